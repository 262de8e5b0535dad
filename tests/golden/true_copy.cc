// The golden set in the source tree is a partial copy of a larger one: only the cases listed in left_out.json may be
// missing. Their numbers may be zeros in data.bin, which take no room once packed.
#include <iostream>

#include "fastscene/base/file.h"
#include "golden.h"

namespace fastscene::golden {
namespace {

namespace fs = std::filesystem;

// Only in the copy.
constexpr const char* kOwnFiles[] = {"README.md", "left_out.json", "prompt_tokens.json", "wider.json"};

// The original's manifest without the omitted cases; reports unknown names.
Json without_cases(Json manifest, const Json& left_out, std::vector<std::string>& complaints) {
    if (left_out.is_null()) return manifest;
    if (left_out.value("why", "").empty()) complaints.push_back("left_out.json says no reason");
    for (const Json& name : left_out.at("cases"))
        if (manifest.at("cases").erase(name.get<std::string>()) == 0)
            complaints.push_back("left_out.json names " + name.dump() + ", which the original lacks");
    return manifest;
}

std::size_t bytes_of_stored(const Json& tensor) {
    const std::string dtype = tensor.at("dtype");
    const std::size_t each = dtype.ends_with("64") ? 8 : dtype.ends_with("32") ? 4 : 1;
    return each * tensor.at("count").get<std::size_t>();
}

// data.bin with zeros in place of the omitted cases' numbers.
std::string without_data(std::string data, const Json& manifest, const Json& left_out) {
    if (left_out.is_null()) return data;
    for (const Json& name : left_out.at("cases")) {
        const Json one = manifest.at("cases").value(name.get<std::string>(), Json::object());
        for (const Json& tensor : one.value("tensors", Json::array())) {
            const auto offset = tensor.at("offset").get<std::size_t>();
            const std::size_t bytes = bytes_of_stored(tensor);
            if (offset <= data.size() && bytes <= data.size() - offset) data.replace(offset, bytes, bytes, '\0');
        }
    }
    return data;
}

bool is_same_data(const fs::path& copy, const fs::path& original, const fs::path& file, const Json& left_out) {
    const std::string ours = read_packed(copy / file), theirs = read_file(original / file);
    const fs::path manifest = original / file.parent_path() / "manifest.json";
    return ours == theirs ||
           (file.filename() == "data.bin" && ours == without_data(theirs, read_json(manifest), left_out));
}

std::vector<std::string> complaints_about(const fs::path& copy, const fs::path& original, const fs::path& file,
                                          const Json& left_out) {
    std::vector<std::string> complaints;
    if (!fs::exists(original / file)) return {"is not in the original"};
    if (file.filename() == "manifest.json") {
        const Json reason = left_out.value(file.parent_path().string(), Json());
        const Json ours = read_json(copy / file),
                   theirs = without_cases(read_json(original / file), reason, complaints);
        if (ours != theirs) {
            std::string where;
            const Json patch = Json::diff(theirs, ours);
            for (std::size_t i = 0; i < std::min<std::size_t>(3, patch.size()); ++i)
                where += " " + patch[i].at("path").get<std::string>();
            complaints.push_back(fmt::format("differs in {} places:{}", patch.size(), where));
        }
    } else if (!is_same_data(copy, original, file, left_out.value(file.parent_path().string(), Json()))) {
        complaints.push_back("differs");
    }
    return complaints;
}

}  // namespace

bool is_a_true_copy(const fs::path& copy, const fs::path& original) {
    const Json left_out = fs::exists(copy / "left_out.json") ? read_json(copy / "left_out.json") : Json::object();
    int files = 0, bad = 0;
    for (const auto& entry : fs::recursive_directory_iterator(copy)) {
        if (!entry.is_regular_file()) continue;
        fs::path file = fs::relative(entry.path(), copy);
        if (std::find(std::begin(kOwnFiles), std::end(kOwnFiles), file.string()) != std::end(kOwnFiles)) continue;
        if (file.extension() == ".zst") file.replace_extension();
        ++files;
        for (const std::string& complaint : complaints_about(copy, original, file, left_out)) {
            std::cout << file.string() << ": " << complaint << std::endl;
            ++bad;
        }
    }
    for (const auto& [network, reason] : left_out.items()) {
        if (!fs::exists(copy / network / "manifest.json")) {
            std::cout << "left_out.json: no network " << network << " in the copy" << std::endl;
            ++bad;
            continue;
        }
        std::cout << network << ": left out " << reason.at("cases").dump() << ": " << reason.value("why", "")
                  << std::endl;
    }
    std::cout << fmt::format("{} files held against {}, {} complaints", files, original.string(), bad) << std::endl;
    return bad == 0 && files > 0;
}

}  // namespace fastscene::golden
