#include "fastscene/io/capture_parts.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/ply.h"

namespace fastscene {
namespace fs = std::filesystem;

bool is_name_below(const std::string& name) {
    if (name.empty() || fs::path(name).is_absolute()) return false;
    const fs::path path(name);
    return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

void sort_by_name(std::vector<Photo>& photos) {
    std::stable_sort(photos.begin(), photos.end(), [](const Photo& a, const Photo& b) { return a.name < b.name; });
}

fs::path mask_for(const fs::path& masks, const std::string& name) {
    if (!fs::is_directory(masks)) return {};
    const fs::path whole = masks / name;
    if (const fs::path file = whole.string() + ".png"; fs::is_regular_file(file)) return file;  // COLMAP's naming
    if (fs::is_regular_file(whole)) return whole;
    for (const char* ending : kPictureEndings) {
        if (const fs::path file = fs::path(whole).replace_extension(ending); fs::is_regular_file(file)) return file;
        if (const fs::path file = whole.string() + ending; fs::is_regular_file(file)) return file;
    }
    return {};
}

void name_files(Capture& capture, fs::path images, const fs::path& masks, int downscale) {
    if (downscale > 1)
        if (const fs::path smaller = images.string() + "_" + std::to_string(downscale); fs::is_directory(smaller))
            images = smaller;
    if (!fs::is_directory(images))
        throw Error("{}: expected the folder of the pictures, found none; name it with --images", images.string());
    for (Photo& photo : capture.photos) {
        photo.file = images / photo.name;
        photo.mask = mask_for(masks, photo.name);
    }
}

std::vector<CapturePoint> points_of_ply(const fs::path& path) {
    const Ply ply(path);
    const PlyElement& v = ply.element("vertex");
    const int x = ply.property(v, "x"), y = ply.property(v, "y"), z = ply.property(v, "z");
    std::array<int, 3> color{Ply::find(v, "red"), Ply::find(v, "green"), Ply::find(v, "blue")};
    if (color[0] < 0)
        color = {Ply::find(v, "diffuse_red"), Ply::find(v, "diffuse_green"), Ply::find(v, "diffuse_blue")};
    std::vector<CapturePoint> points(v.count);
    for (std::size_t i = 0; i < v.count; ++i) {
        points[i].position = {ply.value(v, i, x), ply.value(v, i, y), ply.value(v, i, z)};
        const auto byte = [&](std::size_t c) -> std::uint8_t {
            if (color[c] < 0) return 128;
            const double value = ply.value(v, i, color[c]) *
                                 (v.properties[static_cast<std::size_t>(color[c])].kind == 'f' &&
                                          v.properties[static_cast<std::size_t>(color[c])].bytes == 4
                                      ? 255
                                      : 1);
            return static_cast<std::uint8_t>(std::min(std::max(0.0, value), 255.0));
        };
        points[i].color = {byte(0), byte(1), byte(2)};
    }
    return points;
}

}  // namespace fastscene
