// Polycam's "raw data": keyframes/corrected_cameras/*.json (or cameras/) with the pictures in corrected_images/ (or
// images/). Camera to world in OpenGL's axes (y up, z back), as ARKit has them.
#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Frames {
    fs::path cameras, images;
};
Frames frames_in(const fs::path& dir) {
    for (const fs::path& place : {dir / "keyframes", dir})
        for (const char* kind : {"corrected_", ""})
            if (const Frames found{place / (std::string(kind) + "cameras"), place / (std::string(kind) + "images")};
                fs::is_directory(found.cameras) && fs::is_directory(found.images))
                return found;
    throw Error("{}: expected Polycam's raw data (keyframes/corrected_cameras and corrected_images), found none",
                dir.string());
}

double number(const fs::path& file, const Json& json, const std::string& name) {
    const auto found = json.is_object() ? json.find(name) : json.end();
    if (!json.is_object() || found == json.end() || !found->is_number() || !std::isfinite(found->get<double>()))
        throw Error("{}: expected a number as \"{}\", found none", file.string(), name);
    return found->get<double>();
}

Photo photo_of(const fs::path& file) {
    const Json json = read_json(file);
    const auto of = [&](const std::string& name) { return number(file, json, name); };
    Photo photo;
    photo.name = file.stem().string();
    Lens& lens = photo.lens;
    if (!(of("width") >= 1 && of("height") >= 1 && of("width") <= 65536 && of("height") <= 65536))
        throw Error("{}: expected a picture size, found {} x {}", file.string(), of("width"), of("height"));
    lens.width = static_cast<int>(of("width")), lens.height = static_cast<int>(of("height"));
    lens.fx = of("fx"), lens.fy = of("fy"), lens.cx = of("cx"), lens.cy = of("cy");
    if (!(lens.fx > 0 && lens.fy > 0))
        throw Error("{}: expected a positive focal length, found {}", file.string(), lens.fx);
    const auto column = [&](int c) {
        return Vec3d{of(fmt::format("t_0{}", c)), of(fmt::format("t_1{}", c)), of(fmt::format("t_2{}", c))};
    };
    const Vec3d right = column(0), up = column(1), back = column(2);
    if (!(std::fabs(length(right) - 1) < 0.02 && length(cross(right, up) - back) < 0.02))
        throw Error("{}: expected a rotation in t_00 … t_22, found another matrix", file.string());
    photo.world_from_camera = {matrix_of(quaternion_of(Mat3d::from_columns(right, -up, -back))), column(3)};
    return photo;
}

}  // namespace

Capture load_polycam_capture(const fs::path& dir, const CaptureFolders& folders) {
    const Frames frames = frames_in(dir);
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(frames.cameras))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    Capture capture;
    capture.source = dir.string();
    for (const fs::path& file : files) capture.photos.push_back(photo_of(file));
    CaptureFolders with = folders;
    if (with.images.empty()) with.images = frames.images;
    name_labelled_files(capture, with, dir);
    finish_capture(capture, folders);
    return capture;
}

}  // namespace fastscene
