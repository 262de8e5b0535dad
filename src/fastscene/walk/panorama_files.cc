#include "fastscene/walk/panorama_files.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// A picture of a set made by `fastscene rooms dataset`, by its JSON, which is written last.
std::optional<PanoramaFiles> from_our_set(const fs::path& json_path) {
    const Json about = read_json(json_path);
    if (!about.is_object() || about.value(Json::json_pointer("/camera/model"), "") != "EQUIRECTANGULAR" ||
        !about.contains("color") || !about.contains("range"))
        return {};
    return PanoramaFiles{json_path.parent_path() / about["color"].get<std::string>(),
                         json_path.parent_path() / about["range"].get<std::string>(),
                         fmt::format("room {}", about.value("room", 0)),
                         {}};
}

std::optional<PanoramaFiles> from_structured3d(const fs::path& color) {
    const fs::path range = color.parent_path() / "depth.png";
    if (color.filename() != "rgb_rawlight.png" || color.parent_path().filename() != "full" || !fs::exists(range))
        return {};
    std::string place = color.parent_path().string();
    for (const fs::path& part : color)
        if (part.string().starts_with("scene_")) place = part.string();
    return PanoramaFiles{color, range, place, {}};
}

std::optional<PanoramaFiles> from_anybody(const fs::path& color) {
    if (!has_picture_ending(color)) return {};
    for (const char* range_ending : {".range.exr", ".range.pfm", ".range.png", ".range.tif", ".range.tiff"}) {
        const fs::path range = fs::path(color).replace_extension(range_ending);
        if (fs::exists(range)) return PanoramaFiles{color, range, color.stem().string(), {}};
    }
    return {};
}

}  // namespace

std::vector<PanoramaFiles> find_panoramas(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw UsageError("{}: expected a folder of panoramas with range maps, found none", folder.string());
    const bool ours = fs::exists(folder / "dataset.json");
    std::vector<PanoramaFiles> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        const fs::path& path = entry.path();
        if (ours && (path.extension() != ".json" || path.parent_path() == folder)) continue;
        auto files = ours ? from_our_set(path) : from_structured3d(path);
        if (!files && !ours) files = from_anybody(path);
        if (files) found.push_back(std::move(*files));
    }
    if (found.empty())
        throw UsageError(
            "{}: expected panoramas with range maps (a set of `fastscene rooms dataset`, Structured3D's folders, or "
            "NAME.png beside NAME.range.png), "
            "found none",
            folder.string());
    for (PanoramaFiles& files : found) files.name = files.color.lexically_relative(folder).string();
    std::sort(found.begin(), found.end(),
              [](const PanoramaFiles& a, const PanoramaFiles& b) { return a.color < b.color; });
    return found;
}

Panorama load_panorama(const PanoramaFiles& files) {
    const ImageRgb8 color = load_rgb8(files.color);
    if (color.width != 2 * color.height)
        throw Error("{}: expected a panorama twice as wide as high, found {} x {}", files.color.string(), color.width,
                    color.height);
    const ImageF range = load_float(files.range);
    if (range.width != 2 * range.height)
        throw Error("{}: expected a range map twice as wide as high, found {} x {}", files.range.string(), range.width,
                    range.height);
    Panorama out;
    out.color = linear_from_srgb8(color);
    out.range = ImageF(color.width, color.height);
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x) {
            const float r = range.at((2 * x + 1) * range.width / (2 * color.width),
                                     (2 * y + 1) * range.height / (2 * color.height));
            out.range.at(x, y) = r > 0 ? r : std::numeric_limits<float>::infinity();
        }
    return out;
}

}  // namespace fastscene
