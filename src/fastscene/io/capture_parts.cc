#include "fastscene/io/capture_parts.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/picture_folder.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/io/ply.h"

namespace fastscene {
namespace fs = std::filesystem;

bool is_name_below(const std::string& given) {
    const std::string name = with_slashes(given);
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
    PictureFolder folder(images);
    RenamedPictures renamed;
    for (Photo& photo : capture.photos) {
        photo.file = images / photo.name;
        if (!fs::is_regular_file(photo.file)) photo.name = with_slashes(photo.name), photo.file = images / photo.name;
        if (!fs::is_regular_file(photo.file))
            if (const fs::path other = folder.similar_to(photo.name); !other.empty()) {
                renamed.add(photo.name, other);
                photo.file = other;
            }
        photo.mask = mask_for(masks, photo.name);
        if (photo.mask.empty()) photo.mask = mask_for(masks, photo.file.lexically_relative(images).generic_string());
    }
    if (const auto text = renamed.warning(capture.source, capture.photos.size())) capture.warnings.push_back(*text);
}

void name_labelled_files(Capture& capture, const CaptureFolders& folders, const fs::path& dir) {
    fs::path images = !folders.images.empty()            ? folders.images
                      : fs::is_directory(dir / "images") ? dir / "images"
                      : dir.empty()                      ? fs::path(".")
                                                         : dir;
    if (folders.downscale > 1)
        if (const fs::path smaller = images.string() + "_" + std::to_string(folders.downscale);
            fs::is_directory(smaller))
            images = smaller;
    if (!fs::is_directory(images))
        throw Error("{}: expected the folder of the pictures, found none; name it with --images", images.string());
    const fs::path masks = folders.masks.empty() ? dir / "masks" : folders.masks;
    PictureFolder folder(images);
    for (Photo& photo : capture.photos) {
        photo.file = folder.labelled(photo.name);
        if (photo.file.empty()) photo.file = images / with_slashes(photo.name);  // missing, and told
        else photo.name = photo.file.lexically_relative(images).generic_string();
        photo.mask = mask_for(masks, photo.name);
    }
}

void give_sizes(Capture& capture, const std::function<void(Lens&, int, int)>& give) {
    std::vector<PictureInfo> sizes(capture.photos.size());
    PictureInfo usual;
    for (std::size_t i = 0; i < sizes.size(); ++i) try {
            if (fs::is_regular_file(capture.photos[i].file)) usual = sizes[i] = picture_info(capture.photos[i].file);
        } catch (const Error&) {  // dropped later, with a warning
        }
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const PictureInfo& size = sizes[i].width > 0 ? sizes[i] : usual;
        give(capture.photos[i].lens, std::max(size.width, 1), std::max(size.height, 1));
    }
}

void finish_capture(Capture& capture, const CaptureFolders& folders) {
    if (!folders.points.empty()) capture.points = points_of_ply(folders.points);
    sort_by_name(capture.photos);
    take_offset_out(capture);
}

namespace {

Vec3d median_of(const std::vector<Photo>& photos) {
    Vec3d out;
    for (std::size_t a = 0; a < 3; ++a) {
        std::vector<double> values;
        for (const Photo& p : photos) values.push_back(p.world_from_camera.translation[a]);
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        out[a] = *middle;
    }
    return out;
}

}  // namespace

void take_offset_out(Capture& capture) {
    if (capture.photos.empty()) return;
    const Vec3d offset = offset_for(median_of(capture.photos));
    if (offset == Vec3d{}) return;
    capture.offset = offset;
    for (Photo& photo : capture.photos)
        photo.world_from_camera.translation = photo.world_from_camera.translation - offset;
    for (CapturePoint& point : capture.points) point.position = point.position - offset;
    capture.warnings.push_back(
        fmt::format("{}: its cameras are far from the origin (georeferenced?): ({:.0f}, {:.0f}, {:.0f}) is subtracted "
                    "from all positions, and convert adds it again",
                    capture.source, offset.x, offset.y, offset.z));
}

double share_in_view(const std::vector<Photo>& photos, const std::vector<CapturePoint>& points) {
    constexpr std::size_t kPhotos = 50, kPoints = 400;
    std::size_t seen = 0, pairs = 0;
    for (std::size_t i = 0; i < photos.size(); i += 1 + photos.size() / kPhotos) {
        const Photo& photo = photos[i];
        const Mat3d camera_from_world = transpose(photo.world_from_camera.rotation);
        const double reach = photo.lens.reach();
        for (std::size_t k = 0; k < points.size(); k += 1 + points.size() / kPoints, ++pairs) {
            const Vec3d p = camera_from_world * (points[k].position - photo.world_from_camera.translation);
            const auto pixel = photo.lens.pixel_of(p, reach);
            seen += pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < photo.lens.width &&
                    pixel->y < photo.lens.height;
        }
    }
    return pairs ? static_cast<double>(seen) / static_cast<double>(pairs) : 0;
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
