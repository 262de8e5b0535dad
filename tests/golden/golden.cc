#include "golden.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include <zstd.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/models/cache.h"

namespace fastscene::golden {
namespace {

namespace fs = std::filesystem;

// "2e-3 relative to absmax", "5e-5 (why)", "1 level" or a number.
struct Tolerance {
    double value = 0;
    bool relative = false;
};
Tolerance tolerance_of(const Json& entry, double relative) {
    const auto found = entry.find("tol");
    if (found == entry.end() || found->is_null()) return {relative, true};
    if (found->is_number()) return {found->get<double>(), false};
    const std::string text = found->get<std::string>();
    return {std::atof(text.c_str()), text.find("relative") != std::string::npos};
}

Finding compared(const std::string& name, const at::Tensor& reference, const at::Tensor& ours, double largest,
                 const Json& entry, double relative = 1e-5) {
    const at::Tensor r = reference.to(at::kDouble), o = ours.to(at::kDouble), d = (r - o).abs();
    const Tolerance tol = tolerance_of(entry, relative);
    Finding f{name, 0, 0, tol.relative ? tol.value * largest : tol.value, false, ""};
    f.max_abs = d.numel() ? d.max().item<double>() : 0;
    const double norm = r.norm().item<double>();
    f.relative_l2 = norm > 0 ? d.norm().item<double>() / norm : d.norm().item<double>();
    f.good = f.max_abs <= f.tolerance;  // fails for NaN
    return f;
}

const Json* entry_named(const Json& list, const std::string& name) {
    for (const Json& entry : list)
        if (entry.at("name") == name) return &entry;
    return nullptr;
}
const Json& list_of(const Json& json, const char* key) {
    static const Json none = Json::array();
    const auto found = json.find(key);
    return found == json.end() ? none : *found;
}

}  // namespace

namespace {
// The tokenizer's set is a plain list of prompts: converted to a manifest, each prompt is a value to compare.
Json manifest_of_prompts(const Json& list) {
    Json out;
    for (const char* kind : {"prompts", "weighted"}) {
        Json values = Json::array();
        int number = 0;
        for (const Json& prompt : list_of(list, kind))
            values.push_back({{"name", fmt::format("{:03}", number++)}, {"value", prompt}});
        out["cases"][kind]["values"] = std::move(values);
    }
    return out;
}
}  // namespace

std::string read_packed(const fs::path& file) {
    fs::path packed = file;
    packed += ".zst";
    if (fs::exists(file) || !fs::exists(packed)) return read_file(file);
    const std::string bytes = read_file(packed);
    const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
    if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
        throw Error("{}: expected one zstd frame that says its size", packed.string());
    std::string out(size, '\0');
    const std::size_t got = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
    if (ZSTD_isError(got) || got != size) throw Error("{}: damaged", packed.string());
    return out;
}

Network::Network(fs::path set, std::string name) : set_(std::move(set)), name_(std::move(name)) {
    if (fs::exists(set_ / "wider.json")) wider_ = read_json(set_ / "wider.json").at("factors").value(name_, Json());
    if (!fs::exists(set_ / name_ / "manifest.json")) {
        json_ = manifest_of_prompts(read_json(set_ / name_ / "tokenizer.json"));
        return;
    }
    json_ = read_json(set_ / name_ / "manifest.json");
    if (json_.contains("bin")) data_ = read_packed(set_ / name_ / json_["bin"].get<std::string>());
}

double Network::wider(const std::string& of_case, const std::string& tensor) const {
    if (!wider_.contains(of_case)) return 1;
    return wider_[of_case].value(tensor, 1.0);
}

at::Tensor Network::stored(const Json& t) const {
    const auto count = t.at("count").get<std::int64_t>();
    const auto offset = t.at("offset").get<std::size_t>();
    const std::string dtype = t.at("dtype");
    const at::ScalarType type = dtype == "float32"   ? at::kFloat
                                : dtype == "float64" ? at::kDouble
                                : dtype == "int64"   ? at::kLong
                                : dtype == "int32"   ? at::kInt
                                                     : at::kByte;
    if (dtype != "float32" && dtype != "float64" && dtype != "int64" && dtype != "int32" && dtype != "uint8")
        throw Error("{}: dtype {} is not known", name_, dtype);
    const std::size_t bytes = static_cast<std::size_t>(count) * at::elementSize(type);
    if (offset + bytes > data_.size())
        throw Error("{}: tensor {} lies outside of data.bin", name_, t.at("name").dump());
    return at::from_blob(const_cast<char*>(data_.data()) + offset, {count}, type).clone();
}

bool Case::wants(const std::string& name) const {
    return entry_named(list_of(json_, "tensors"), name) || entry_named(list_of(json_, "values"), name);
}

std::vector<std::string> Case::tensor_names() const {
    std::vector<std::string> out;
    for (const Json& t : list_of(json_, "tensors")) out.push_back(t.at("name"));
    return out;
}

void Case::tensor(const std::string& name, const at::Tensor& ours) {
    std::vector<Finding> findings;
    for (const Json& t : list_of(json_, "tensors")) {
        if (t.at("name") != name) continue;
        const auto shape = t.at("shape").get<std::vector<std::int64_t>>();
        if (ours.numel() != c10::multiply_integers(shape)) {
            findings.push_back(
                {name, std::nan(""), std::nan(""), 0, false,
                 fmt::format("expected shape {}, found {} numbers", t.at("shape").dump(), ours.numel())});
            continue;
        }
        const auto stride = t.at("stride").get<std::int64_t>();
        const at::Tensor some = ours.to(at::kCPU).contiguous().flatten().slice(
            0, 0, std::numeric_limits<std::int64_t>::max(), stride);
        double largest = std::max(std::abs(t.value("min", 0.0)), std::abs(t.value("max", 0.0)));
        const at::Tensor reference = network_.stored(t);
        if (!t.contains("max")) largest = reference.to(at::kDouble).abs().max().item<double>();
        Finding f = compared(name, reference, some.narrow(0, 0, reference.numel()), largest, t);
        if (const double factor = network_.wider(name_, name); factor != 1) {
            f.tolerance *= factor;
            f.good = f.max_abs <= f.tolerance;
            f.remark = fmt::format("{} times the manifest's tolerance", factor);
        }
        findings.push_back(f);
    }
    if (!findings.empty()) found_[name] = std::move(findings);
}

void Case::value(const std::string& name, double ours, double relative) {
    const Json* entry = entry_named(list_of(json_, "values"), name);
    if (!entry) return;
    const Json& reference = entry->at("value");
    if (reference == "inf") {
        found_[name] = {{name, 0, 0, 0, std::isinf(ours) && ours > 0, ""}};
        return;
    }
    const double r = reference.get<double>();
    found_[name] = {compared(name, at::scalar_tensor(r, at::kDouble), at::scalar_tensor(ours, at::kDouble), std::abs(r),
                             *entry, relative)};
}

void Case::value(const std::string& name, const Json& ours) {
    const Json* entry = entry_named(list_of(json_, "values"), name);
    if (!entry) return;
    const Json& reference = entry->at("value");
    if (reference.is_array() && ours.is_array() && reference.size() == ours.size() && !reference.empty() &&
        reference[0].is_number()) {
        const auto numbers = [](const Json& j) { return at::tensor(j.get<std::vector<double>>(), at::kDouble); };
        found_[name] = {
            compared(name, numbers(reference), numbers(ours), numbers(reference).abs().max().item<double>(), *entry)};
        return;
    }
    found_[name] = {{name, 0, 0, 0, reference == ours,
                     reference == ours ? "" : fmt::format("expected {}, found {}", reference.dump(), ours.dump())}};
}

void Case::number_text(const std::string& name, const std::string& ours) {
    const Json* entry = entry_named(list_of(json_, "values"), name);
    if (!entry) return;
    const auto numbers = [](std::string text) {
        std::replace(text.begin(), text.end(), ':', ' ');
        std::istringstream words(text);
        std::vector<double> out;
        for (double v; words >> v;) out.push_back(v);
        return at::tensor(out, at::kDouble);
    };
    const at::Tensor theirs = numbers(entry->at("value").get<std::string>()), mine = numbers(ours);
    if (theirs.numel() != mine.numel())
        found_[name] = {{name, std::nan(""), std::nan(""), 0, false, "another count of numbers"}};
    else found_[name] = {compared(name, theirs, mine, 1, {{"tol", 1e-3}})};
}

void Case::put(Finding finding) {
    std::string name = finding.name;
    found_[name].push_back(std::move(finding));
}

void Case::leave_out(const std::string& name, const std::string& why) {
    if (wants(name)) found_[name] = {{name, 0, 0, 0, true, "left out: " + why}};
}

void Case::lack(const std::string& name, const std::string& file) {
    if (!wants(name)) return;
    lacked_.insert(file);
    if (found_.contains(name)) return;
    found_[name] = {{name, 0, 0, 0, true, "not compared: needs " + file}};
}

nn::Listener Case::listener() {
    return [this](const std::string& name, const at::Tensor& output) { tensor(name, output); };
}

std::vector<Finding> Case::findings() const {
    std::vector<Finding> out;
    std::set<std::string> seen;
    for (const char* key : {"tensors", "values"})
        for (const Json& entry : list_of(json_, key)) {
            const std::string name = entry.at("name");
            if (!seen.insert(name).second) continue;
            const auto found = found_.find(name);
            if (found == found_.end()) out.push_back({name, std::nan(""), std::nan(""), 0, false, "not computed"});
            else out.insert(out.end(), found->second.begin(), found->second.end());
        }
    return out;
}

at::Tensor raw(const std::string& name, at::IntArrayRef shape) { return nn::hashed_input(name, shape); }
at::Tensor unit(const std::string& name, at::IntArrayRef shape) { return (raw(name, shape) + 1) / 2; }

at::Tensor bytes_of(const ImageRgb8& image) {
    at::Tensor out = at::empty({image.height, image.width, 3}, at::kByte);
    std::copy_n(reinterpret_cast<const std::uint8_t*>(image.pixels.data()), 3 * image.size(),
                out.data_ptr<std::uint8_t>());
    return out;
}

std::optional<fs::path> find_others_file(const fs::path& set, const OthersFile& file) {
    std::vector<fs::path> places{fs::absolute(set).parent_path()};
    if (const char* shared = std::getenv("FASTSCENE_SHARED")) places.emplace_back(shared);
    for (fs::path source = FASTSCENE_SOURCE_DIR; source.has_relative_path(); source = source.parent_path())
        places.push_back(source / "shared");
    for (const fs::path& place : places)
        if (fs::exists(place / file.relative)) return place / file.relative;
    const fs::path pulled = models_root() / model_named(file.model).folder / file.pulled;
    return fs::exists(pulled) ? std::optional(pulled) : std::nullopt;
}

fs::path needed_input(const fs::path& set, const std::string& relative) {
    if (!fs::exists(set / relative)) throw Skipped(relative);
    return set / relative;
}

}  // namespace fastscene::golden
