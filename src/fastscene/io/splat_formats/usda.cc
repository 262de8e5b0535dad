// OpenUSD's text format with a ParticleField3DGaussianSplat (OpenUSD 26.03). Attribute names and their meaning are
// those of pxr/usd/usdVol/schema.usda there: linear scales, opacities 0..1, quaternions w first, and the harmonics of a
// splat one after the other, three channels each, in the order of INRIA's files.
#include <charconv>
#include <cmath>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/io/usda.h"
#include "fastscene/scene/splat_edit.h"

namespace fastscene::splat_formats {
namespace {

constexpr std::string_view kType = "ParticleField3DGaussianSplat";
constexpr std::string_view kSignature = "#usda 1.0";
constexpr std::string_view kDegree = "radiance:sphericalHarmonicsDegree";
constexpr std::string_view kHarmonics = "radiance:sphericalHarmonicsCoefficients";
// Half a step of the last one is 5e-7 of a value: what a float holds, nearly.
constexpr int kDigits = 7;
constexpr float kOpacityLevels = 1e7f;  // opacities of 0 and 1 are taken for half a step within
constexpr std::string_view kBetween = "(), \t\r\n";

// Looks attributes up in the text; numbers are counted before they are kept.
class UsdaText {
  public:
    UsdaText(const std::filesystem::path& file, std::string_view text) : file_(file), text_(text) {
        const std::size_t last = text_.find_last_not_of(" \t\r\n");
        if (last == std::string_view::npos || text_[last] != '}')
            throw Error("{}: byte {}: expected the closing brace of a prim, found the file's end", file_.string(),
                        text_.size());
        const std::size_t prim = text_.find(kType);
        if (prim == std::string_view::npos)
            throw Error("{}: expected a prim of the type {}, found none", file_.string(), kType);
        body_ = prim + kType.size();
        if (text_.find(fmt::format("def {} ", kType), body_) != std::string_view::npos)
            throw Error("{}: expected one {}, found several", file_.string(), kType);
        if (text_.find("xformOpOrder") != std::string_view::npos)
            throw Error("{}: expected splats in the coordinates of the file, found a transform (xformOpOrder)",
                        file_.string());
    }

    // Numbers of `name`, or of its variant of half the precision, `nameh`. nullopt: not there.
    std::optional<std::vector<float>> numbers(std::string_view name) const {
        for (const std::string& variant : {std::string(name), std::string(name) + "h"})
            if (const auto at = value_of(variant, body_)) return array_at(*at);
        return std::nullopt;
    }
    std::optional<double> number(std::string_view name, std::size_t from) const {
        const auto at = value_of(name, from);
        if (!at) return std::nullopt;
        double value = 0;
        if (std::from_chars(text_.data() + *at, text_.data() + text_.size(), value).ec != std::errc())
            throw Error("{}: byte {}: expected a number for {}, found none", file_.string(), *at, name);
        return value;
    }
    std::size_t body() const { return body_; }
    bool says(std::string_view words) const { return text_.find(words) != std::string_view::npos; }

  private:
    // Where the value of `name = ` begins.
    std::optional<std::size_t> value_of(std::string_view name, std::size_t from) const {
        for (std::size_t at = text_.find(name, from); at != std::string_view::npos; at = text_.find(name, at + 1)) {
            const char before = at > 0 ? text_[at - 1] : ' ';
            std::size_t after = text_.find_first_not_of(" \t", at + name.size());
            if ((before != ' ' && before != '\t' && before != '\n') || after == std::string_view::npos ||
                text_[after] != '=')
                continue;
            after = text_.find_first_not_of(" \t\r\n", after + 1);
            if (after == std::string_view::npos)
                throw Error("{}: byte {}: expected a value for {}, found the file's end", file_.string(), text_.size(),
                            name);
            return after;
        }
        return std::nullopt;
    }
    std::vector<float> array_at(std::size_t at) const {
        const std::size_t end = text_.find(']', at);
        if (text_[at] != '[' || end == std::string_view::npos)
            throw Error("{}: byte {}: expected an array in brackets, found none", file_.string(), at);
        std::vector<float> out;
        const char *p = text_.data() + at + 1, *const stop = text_.data() + end;
        while (true) {
            while (p < stop && kBetween.find(*p) != std::string_view::npos) ++p;
            if (p == stop) return out;
            double value = 0;
            const auto [next, code] = std::from_chars(p, stop, value);
            if (code == std::errc::invalid_argument)
                throw Error("{}: byte {}: expected a number, found \"{}\"", file_.string(), p - text_.data(),
                            std::string_view(p, std::min<std::size_t>(8, static_cast<std::size_t>(stop - p))));
            out.push_back(static_cast<float>(value));
            p = next;
        }
    }

    const std::filesystem::path& file_;
    std::string_view text_;
    std::size_t body_ = 0;
};

// The file's axes, and its length of a unit, undone.
Similarity world_from_file(const UsdaText& text) {
    // z up: x stays, y goes up and z comes towards us.
    constexpr Mat3d kYUpFromZUp{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    const Mat3d y_up = text.says("upAxis = \"Z\"") ? kYUpFromZUp : Mat3d{};
    const double metres = text.number("metersPerUnit", 0).value_or(0.01);  // USD's own: centimetres
    return {transpose(kGltfFromWorld) * y_up, metres > 0 && metres < 1e6 ? metres : 1, {}};
}

ReadSplats read_usda(const std::filesystem::path& file, std::string_view bytes) {
    const UsdaText text(file, bytes);
    const auto counted = [&](std::string_view name, std::size_t count, std::size_t width) {
        auto values = text.numbers(name);
        if (values && values->size() != count * width)
            throw Error("{}: expected {} numbers of {}, found {}", file.string(), count * width, name, values->size());
        return values;
    };
    const auto positions = text.numbers("positions");
    if (!positions || positions->size() % 3 != 0)
        throw Error("{}: expected positions, three numbers each, found {}", file.string(),
                    positions ? positions->size() : 0);
    Splats splats;
    splats.sh_degree = static_cast<int>(text.number(kDegree, text.body()).value_or(3));
    if (splats.sh_degree < 0 || splats.sh_degree > 3)
        throw Error("{}: expected spherical harmonics of degree 0 to 3, found {}", file.string(), splats.sh_degree);
    const std::size_t count = positions->size() / 3;
    const auto scales = counted("scales", count, 3), turns = counted("orientations", count, 4),
               opacities = counted("opacities", count, 1);
    const auto per_splat = static_cast<std::size_t>(splats.rest_coefficients()) + 1;
    const auto harmonics = counted(kHarmonics, count, 3 * per_splat);
    if (!harmonics) splats.sh_degree = 0;
    splats.resize(count);
    splats.filter.antialias = text.says("bool antialias = 1");
    if (const auto low_pass = text.number(kLowPassKey, 0)) splats.filter.low_pass_px2 = low_pass_px2_from(*low_pass);
    for (std::size_t i = 0; i < count; ++i) {
        const auto three = [i](const std::vector<float>& v) { return Vec3f{v[3 * i], v[3 * i + 1], v[3 * i + 2]}; };
        splats.mean_m[i] = three(*positions);
        const Vec3f scale = scales ? three(*scales) : Vec3f{1, 1, 1};
        splats.log_scale[i] = {std::log(scale.x), std::log(scale.y), std::log(scale.z)};
        if (turns)
            splats.rotation[i] = {(*turns)[4 * i], (*turns)[4 * i + 1], (*turns)[4 * i + 2], (*turns)[4 * i + 3]};
        splats.opacity_logit[i] = logit_of(opacities ? (*opacities)[i] : 1.f, kOpacityLevels);
        for (std::size_t k = 0; harmonics && k < per_splat; ++k)
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = (*harmonics)[3 * (i * per_splat + k) + c];
                if (k == 0) splats.sh0[i][c] = value;
                else splats.sh_rest[(i * 3 + c) * (per_splat - 1) + k - 1] = value;
            }
    }
    transform(splats, world_from_file(text));
    return splats;
}

// Lists of numbers of all splats; `of(i, put)` puts those of one, in tuples of `width`.
template <class Of>
std::string listed(std::size_t count, std::size_t width, const Of& of) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t k = 0;
        of(i, [&](float value) {
            if (k % width == 0 && !out.empty()) out += ", ";
            if (width > 1) out += k % width == 0 ? "(" : ", ";
            append_significant(out, value, kDigits);
            if (width > 1 && ++k % width == 0) out += ')';
        });
    }
    return out;
}

// Three standard deviations around all means.
std::string extent_of(const Splats& splats) {
    Vec3f low{}, high{};
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const float reach = 3 * std::exp(max_component(splats.log_scale[i]));
        for (std::size_t a = 0; a < 3; ++a) {
            const float v = splats.mean_m[i][a];
            low[a] = i ? std::min(low[a], v - reach) : v - reach;
            high[a] = i ? std::max(high[a], v + reach) : v + reach;
        }
    }
    return usda_tuple(low) + ", " + usda_tuple(high);
}

std::string write_usda(const Splats& in_world, const SplatWriting&) {
    Splats splats = in_world;
    transform(splats, {kGltfFromWorld, 1, {}});
    const std::size_t count = splats.size(), rest = static_cast<std::size_t>(splats.rest_coefficients());
    std::vector<std::string> metadata{"customData = {",
                                      fmt::format("    bool antialias = {}", splats.filter.antialias ? 1 : 0)};
    if (splats.filter.low_pass_px2 != FootprintFilter{}.low_pass_px2)
        metadata.push_back(fmt::format("    float {} = {}", kLowPassKey, splats.filter.low_pass_px2));
    metadata.push_back("}");
    UsdaWriter out("Splats", "Gaussian splats by fastscene. Colors are sRGB-encoded; x left, y up, z forward.");
    out.begin(fmt::format("def {}", kType), "Splats", metadata);
    out.array("float3[] extent", extent_of(splats));
    out.array("point3f[] positions", listed(count, 3, [&](std::size_t i, const auto& put) {
                  for (std::size_t a = 0; a < 3; ++a) put(splats.mean_m[i][a]);
              }));
    out.array("quatf[] orientations", listed(count, 4, [&](std::size_t i, const auto& put) {
                  for (const float part : unit_quaternion(splats.rotation[i])) put(part);
              }));
    out.array("float3[] scales", listed(count, 3, [&](std::size_t i, const auto& put) {
                  for (std::size_t a = 0; a < 3; ++a) put(std::exp(splats.log_scale[i][a]));
              }));
    out.array("float[] opacities",
              listed(count, 1, [&](std::size_t i, const auto& put) { put(sigmoid(splats.opacity_logit[i])); }));
    out.line(fmt::format("uniform int {} = {}", kDegree, splats.sh_degree));
    out.array(fmt::format("float3[] {}", kHarmonics), listed(count, 3, [&](std::size_t i, const auto& put) {
                  for (std::size_t c = 0; c < 3; ++c) put(splats.sh0[i][c]);
                  for (std::size_t k = 0; k < rest; ++k)
                      for (std::size_t c = 0; c < 3; ++c) put(splats.sh_rest[(i * 3 + c) * rest + k]);
              }));
    out.line("uniform token projectionModeHint = \"perspective\"");
    out.line("uniform token sortingModeHint = \"zDepth\"");
    out.end();
    return out.text();
}

}  // namespace

SplatFormat usda() {
    return {.name = "usda",
            .ending = ".usda",
            .about = "OpenUSD as text, with `ParticleField3DGaussianSplat` (OpenUSD 26.03)",
            .readers = "Omniverse, Houdini, Arnold",
            .precision = {.mean_m = 1e-5f, .opacity_logit = 1e-5f},
            .file_from_world = kGltfFromWorld,
            .recognizes = [](std::string_view bytes) { return bytes.starts_with(kSignature); },
            .read = read_usda,
            .write = write_usda};
}

}  // namespace fastscene::splat_formats
