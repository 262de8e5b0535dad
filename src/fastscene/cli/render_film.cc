// Films of `render`: paths, frames, and the film made of them.
#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/program.h"
#include "fastscene/base/writable.h"
#include "fastscene/cli/render.h"
#include "fastscene/film/encode.h"
#include "fastscene/io/camera_path_io.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/film_of_run.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/pipeline/splat_files.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

PathFormat format_of(const RenderFlags& flags) {
    for (std::size_t i = 0; i < std::size(kPathFormats); ++i)
        if (flags.path_format == kPathFormats[i]) return static_cast<PathFormat>(i);
    return path_format_of(flags.write_path);
}

// Frames that an interrupted run of the same film has left are kept; others' are deleted.
class KeptFrames {
  public:
    KeptFrames(fs::path folder, const std::string& key) : folder_(std::move(folder)) {
        make_directories(folder_);
        if (fs::exists(note()) && read_file(note()) == key) return;
        remove();
        make_directories(folder_);
        write_file(note(), key);
    }
    // Only what is ours: the note and the frames.
    void remove() const {
        for (int i = 0; fs::exists(frame_file(folder_, i)); ++i) fs::remove(frame_file(folder_, i));
        fs::remove(note());
        std::error_code in_use;
        fs::remove(folder_, in_use);
    }

  private:
    fs::path note() const { return folder_ / "film.txt"; }
    fs::path folder_;
};

// Says whether two runs would render the same frames.
std::string film_key(const RenderFlags& flags, const CameraPath& camera) {
    std::string text = fmt::format("{} {} {} {}x{} {} {}", flags.of, flags.samples, flags.sphere, camera.width,
                                   camera.height, flags.stereo, fmt::join(flags.background, ","));
    for (int i = 0; i < camera.frames(); ++i) {
        const CameraKey k = camera.at(camera.time_of(i));
        text += fmt::format("\n{} {} {} {} {} {} {}", k.position_m.x, k.position_m.y, k.position_m.z, k.yaw_deg,
                            k.pitch_deg, k.roll_deg, k.fov_deg);
    }
    const fs::path scene = flags.of == "room" ? RunFolder{flags.scene}.room_json() : scene_file(flags.scene);
    for (const auto& [flag, value] : *flags.given) text += "\n" + flag + " " + value;
    return Hash().add(text).add(read_file(scene)).hex() + "\n";
}

std::optional<SphericalFilm> spherical_marks(const RenderFlags& flags) {
    if (!flags.sphere) return {};
    switch (stereo_of(flags)) {
        case FilmStereo::mono: return SphericalFilm{};
        case FilmStereo::top_bottom: return SphericalFilm{StereoLayout::top_bottom, false};
        case FilmStereo::vr180: return SphericalFilm{StereoLayout::left_right, true};
    }
    return {};
}

void render_frames(const RenderSubject& subject, const CameraPath& camera, const fs::path& frames, bool keep,
                   const RenderFlags& flags, const Session& session) {
    const Run run = session.run(0);
    const FilmStereo stereo = stereo_of(flags);
    Progress progress(run, "frames", camera.frames());
    for (int i = 0; i < camera.frames(); ++i, progress.advance()) {
        run.check_stop();
        const fs::path file = frame_file(frames, i);
        if (keep && fs::exists(file)) continue;
        const CameraKey key = camera.at(camera.time_of(i));
        const Rigid pose = world_from_camera(key);
        save_png(file, flags.sphere
                           ? sphere_picture(subject, camera.width / 2 * 2, pose, stereo)
                           : subject.flat(Pinhole::with_fov(camera.width, camera.height, key.fov_deg), pose).color);
    }
}

}  // namespace

bool is_planned(const std::string& path) {
    return std::find(kPathKinds.begin(), kPathKinds.end(), path) != kPathKinds.end();
}

CameraPath planned_path(const RenderFlags& flags, int width, int height, const Session& session) {
    const Run run = session.run(0);
    if (!fs::is_directory(flags.scene))
        throw UsageError("--path {}: expected the folder of a run, which knows where one can walk, found {}",
                         flags.path, flags.scene);
    const RunFolder folder{flags.scene};
    const auto area = walkable_in(folder);
    if (!area)
        throw UsageError("--path {}: expected a run that knows where one can walk, found no {}", flags.path,
                         folder.walkable_json().string());
    CameraPath camera = film_of_run(folder, *area, {flags.path, flags.seconds, flags.fps, flags.fov_deg, width, height},
                                    run);
    // Who watches a sphere turns by himself: a world that turns as well makes him ill.
    if (flags.sphere)
        for (CameraKey& key : camera.keys) key.yaw_deg = camera.keys.front().yaw_deg, key.pitch_deg = 0;
    return camera;
}

void write_path(const RenderFlags& flags, const CameraPath& camera) {
    if (!flags.write_path.empty()) save_camera_path(flags.write_path, camera, format_of(flags));
}

void render_film(const RenderSubject& subject, const CameraPath& camera, const fs::path& out, const RenderFlags& flags,
                 const Session& session) {
    const Run run = session.run(0);
    const bool to_file = is_film_name(out);
    const fs::path frames = to_file ? fs::path(out).concat(".frames") : out;
    std::optional<KeptFrames> kept;
    if (to_file) kept.emplace(frames, film_key(flags, camera));
    else make_directories(frames);
    const int count = camera.frames();
    render_frames(subject, camera, frames, to_file, flags, session);
    Json json{{"count", count}, {"fps", camera.fps}, {"seconds", static_cast<float>(count) / camera.fps}};
    // Frames of an earlier, longer film would be appended.
    if (!to_file && fs::exists(frame_file(frames, count)))
        run.note(fmt::format("{}: frames from {:05}.png on belong to an earlier film", frames.string(), count));
    const fs::path film = to_file ? out : fs::path(frames.string() + ".mp4");
    const bool encoded = to_file || find_program("ffmpeg");
    if (encoded) {
        run.note(fmt::format("{} frames rendered; encoding {}", count, film.string()));
        encode_film({frames, count, camera.fps}, film, spherical_marks(flags), session.stop);
        json["film"] = film.string();
    } else {
        run.note("ffmpeg is not on PATH: only the frames were written, not the film (apt-get install ffmpeg)");
    }
    if (kept && !flags.keep_frames) kept->remove();
    else json["frames"] = frames.string();
    session.print(encoded ? film.string() : frames.string(), json);
}

}  // namespace fastscene::cli
