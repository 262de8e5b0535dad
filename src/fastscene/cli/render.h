// What `render` renders: its flags, the subject, and films of it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/cli/flags.h"
#include "fastscene/cli/verb.h"
#include "fastscene/film/stereo.h"
#include "fastscene/scene/camera_path.h"
#include "fastscene/splat/splat.h"

namespace fastscene::cli {

struct RenderFlags {
    std::string scene, of = "splats", out, path, size, depth, alpha, stereo = "mono", write_path, path_format;
    int samples = 128;
    std::vector<float> position{0, 0, 0}, background{0, 0, 0};
    float yaw_deg = 0, pitch_deg = 0, fov_deg = 75, seconds = 0, fps = 30;
    bool sphere = false, keep_frames = false, path_only = false;
    std::shared_ptr<Given> given = std::make_shared<Given>();
    CLI::App* verb = nullptr;  // which flags were given
};

// The splats, or the room that they were made from.
struct RenderSubject {
    std::function<Still(const Pinhole&, const Rigid& world_from_camera)> flat;
    std::function<Still(int width, const Rigid& world_from_pano)> sphere;  // equirectangular
    // One eye of omnidirectional stereo, and the front half of a sphere.
    std::function<ImageRgb8(int width, const Rigid& world_from_pano, float eye_m)> eye;
    std::function<ImageRgb8(int width, const Rigid& world_from_pano)> half;
};
RenderSubject subject_of_splats(Splats splats, const SplatBackend& backend, Vec3f background);
// Path traced, with the noise level of the ground truth for metrics.
RenderSubject subject_of_room(const std::string& folder, int samples, const Session& session);

FilmStereo stereo_of(const RenderFlags& flags);
// A sphere's picture as the flags want it: for one eye or both.
ImageRgb8 sphere_picture(const RenderSubject& subject, int width, const Rigid& pose, FilmStereo stereo);

// The path that --path names: a planned one, or a file's. Empty: cameras of a capture, or no path.
bool is_planned(const std::string& path);
CameraPath planned_path(const RenderFlags& flags, int width, int height, const Session& session);
void write_path(const RenderFlags& flags, const CameraPath& camera);
// Renders the frames and encodes them; `out` is a film's name or a folder for frames.
void render_film(const RenderSubject& subject, const CameraPath& camera, const std::filesystem::path& out,
                 const RenderFlags& flags, const Session& session);

}  // namespace fastscene::cli
