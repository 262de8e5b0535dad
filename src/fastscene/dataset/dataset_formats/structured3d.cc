// Folders and names of Structured3D. A scene is a room; its 2D_rendering has a folder for each picture.
#include <cmath>

#include "fastscene/dataset/format.h"
#include "fastscene/dataset/nyu40_colors.h"
#include "fastscene/dataset/range_points.h"
#include "fastscene/image/encoded_maps.h"
#include "fastscene/io/image_io.h"

namespace fastscene::dataset_formats {
namespace {

using namespace dataset;
namespace fs = std::filesystem;

constexpr std::uint16_t kBackground = 65535;  // of instance.png

// Millimetres, z up; a camera that looks along our z axis looks along -y.
Vec3f structured3d_axes(Vec3f p) { return {-p.x, -p.z, -p.y}; }

ImageRgb8 semantic_colors(const ImageMask& classes) {
    ImageRgb8 out(classes.width, classes.height);
    for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] = kNyu40Colors.at(classes.pixels[i]);
    return out;
}

Image<std::uint16_t> with_background(const ImageF& instances) {
    Image<std::uint16_t> out(instances.width, instances.height, kBackground);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (instances.pixels[i] > 0) out.pixels[i] = static_cast<std::uint16_t>(instances.pixels[i]);
    return out;
}

// "vx vy vz tx ty tz ux uy uz xfov yfov 1": place, view, up, and half the angles of view.
std::string pose_line(const Camera& camera) {
    const Mat3f& r = camera.world_from_camera.rotation;
    const Vec3f at = structured3d_axes(camera.world_from_camera.translation * 1000.f),
                view = structured3d_axes(r * Vec3f{0, 0, 1}), up = structured3d_axes(r * Vec3f{0, -1, 0});
    const Pinhole& p = camera.pinhole;
    return fmt::format("{} {} {} {} {} {} {} {} {} {} {} 1\n", at.x, at.y, at.z, view.x, view.y, view.z, up.x, up.y,
                       up.z, std::atan(static_cast<float>(p.width) / 2 / p.fx),
                       std::atan(static_cast<float>(p.height) / 2 / p.fy));
}

void write_maps(const ExportJob& job, const SetPicture& picture, const std::string& folder) {
    const DataSet& set = job.set;
    const auto save = [&](const char* name, const auto& image) {
        job.out.write_by(folder + name, [&](const fs::path& path) {
            if constexpr (std::is_same_v<std::decay_t<decltype(image)>, Image<std::uint16_t>>) save_png16(path, image);
            else save_png(path, image);
        });
    };
    save("rgb_rawlight.png", load_rgb8(set.file(picture, "color")));
    save("depth.png", depth_millimetres(set, picture));
    save("semantic.png", semantic_colors(load_mask_png(set.file(picture, "class"))));
    save("instance.png", with_background(load_float(set.file(picture, "instance"), 1.f)));
    job.out.write(folder + "normal.png", set.bytes(picture, "normal"));
    if (picture.about.contains("albedo")) job.out.write(folder + "albedo.png", set.bytes(picture, "albedo"));
    job.out.write_json(folder + "camera.json", picture.about);
}

void write_structured3d(const ExportJob& job) {
    const auto scene_of = [](const SetPicture& picture) { return fmt::format("scene_{:05}", picture.room); };
    job.for_each([&](std::size_t, const SetPicture& picture) {
        const Camera camera = job.set.camera(picture);
        const std::string scene = scene_of(picture) + "/";
        if (camera.panorama) {
            const std::string folder = fmt::format("{}2D_rendering/{}/panorama/", scene, picture.number);
            const Vec3f at = structured3d_axes(camera.world_from_camera.translation * 1000.f);
            job.out.write(folder + "camera_xyz.txt", fmt::format("{} {} {}\n", at.x, at.y, at.z));
            write_maps(job, picture, folder + "full/");
        } else {
            const std::string folder = fmt::format("{}2D_rendering/0/perspective/full/{}/", scene, picture.number);
            job.out.write(folder + "camera_pose.txt", pose_line(camera));
            write_maps(job, picture, folder);
        }
    });
    // Structured3D's splits are ranges of scenes; here they are lists.
    for (std::size_t s = 0; s < kSplits.size(); ++s) {
        std::string scenes;
        int last = -1;
        for (const SetPicture* picture : job.splits[s]) {
            if (picture->room == last) continue;
            last = picture->room;
            scenes += scene_of(*picture) + "\n";
            job.out.write(scene_of(*picture) + "/room.json", job.set.bytes(*picture, "room_document"));
        }
        if (!scenes.empty()) job.out.write(fmt::format("{}.txt", kSplits[s]), scenes);
    }
}

}  // namespace

DatasetFormat structured3d() {
    return {.name = "structured3d",
            .about = "folders and names of Structured3D",
            .readers = "loaders for Structured3D, `fastscene depth train`, `inpaint dataset`",
            .write = write_structured3d};
}

}  // namespace fastscene::dataset_formats
