#include "fastscene/studio/films.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>

#include "fastscene/base/file.h"
#include "fastscene/base/program.h"
#include "fastscene/image/color.h"
#include "fastscene/io/camera_path_io.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/film_of_run.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/splat/splat.h"
#include "fastscene/studio/job.h"
#include "fastscene/studio/refusal.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

using namespace std::chrono_literals;
constexpr auto kFilmLogEvery = 300ms;
constexpr int kFilmNiceness = 10;      // of a film: scenes in the making go first
constexpr float kTrackEvery_s = 0.1f;  // of the line on the plan
constexpr int kJpegQuality = 85;
constexpr int kTracedWidth = 960, kTracedSamples = 32;  // a picture within a minute, to compare with the splats
constexpr const char* kTraced = "traced.png";
constexpr const char* kFilmEndings[] = {"mp4", "webm"};

WalkableArea area_of(const RunFolder& folder) {
    if (!fs::exists(folder.scene_ply())) throw Refusal(409, "this scene has no splats yet: a film needs them");
    const auto area = walkable_in(folder);
    if (!area) throw Refusal(409, "the walkable floor of this scene is not known: load a camera path of your own");
    return *area;
}

// Along the path: [x, z, whether the camera is where a visitor may be].
Json track_of(const CameraPath& path, const WalkableArea& area) {
    Json track = Json::array();
    const float first = path.keys.front().time_s, last = path.keys.back().time_s;
    const int steps = std::max(1, static_cast<int>((last - first) / kTrackEvery_s));
    for (int i = 0; i <= steps; ++i) {
        const Vec3f p = path.at(first + (last - first) * static_cast<float>(i) / static_cast<float>(steps)).position_m;
        track.push_back({p.x, p.z, contains(area, Vec2f{p.x, p.z})});
    }
    return track;
}

// With keys that can be dragged one by one.
CameraPath editable(const CameraPath& path) {
    constexpr float kSlack_m = 0.05f, kSlack_deg = 3;
    return with_fewer_keys(path, kSlack_m, kSlack_deg);
}

Json json_of(const CameraPath& path, const WalkableArea& area) {
    return {{"path", camera_path_json(path)}, {"track", track_of(path, area)}};
}

}  // namespace

struct Films::Stage {
    fs::path file;
    fs::file_time_type when;
    Splats splats;
    std::unique_ptr<SplatRenderer> renderer;  // of `splats`
};

Films::Films(Library& library, Board& board, fs::path program)
    : library_(library), board_(board), program_(std::move(program)), live_{{"scene", ""}, {"state", ""}} {}

Films::~Films() { stop(); }

fs::path Films::folder(const std::string& scene) const {
    library_.folder(scene);  // throws if there is no such scene
    return library_.own("films") / scene;
}
fs::path Films::path_file(const std::string& scene) const { return folder(scene) / "path.json"; }

CameraPath Films::path(const std::string& scene) {
    const RunFolder run = library_.folder(scene);
    if (fs::exists(path_file(scene))) return load_camera_path(path_file(scene));
    return editable(film_of_run(run, area_of(run), {}, Run{}));
}

Json Films::film(const std::string& scene) {
    const std::lock_guard lock(paths_);
    const RunFolder run = library_.folder(scene);
    const WalkableArea area = area_of(run);
    Json out = keep(scene, path(scene));
    out["rings"] = Json::array();
    for (const auto& ring : area.rings_m) {
        out["rings"].push_back(Json::array());
        for (const Vec2f p : ring) out["rings"].back().push_back({p.x, p.y});
    }
    out["low_m"] = area.floor_y - area.high_y;
    float highest_y = area.floor_y;
    for (const WalkableArea::Level& level : area.levels) highest_y = std::min(highest_y, level.floor_y);
    out["high_m"] = area.floor_y - area.low_y + (area.floor_y - highest_y);
    out["floor_y"] = area.floor_y;
    return out;
}

Json Films::keep(const std::string& scene, const CameraPath& path) {
    make_directories(folder(scene));
    const std::string text = camera_path_json(path).dump(1);
    // A finished film belongs to this path until the path changes.
    if (!fs::exists(path_file(scene)) || read_file(path_file(scene)) != text) write_file(path_file(scene), text);
    Json out = json_of(path, area_of(library_.folder(scene)));
    out["made"] = nullptr;
    try {
        const fs::path film = made(scene);
        out["made"] = {{"file", film.filename().string()}, {"bytes", fs::file_size(film)}};
    } catch (const Refusal&) {  // not yet
    }
    return out;
}

Json Films::plan(const std::string& scene, const std::string& kind, float seconds) {
    const std::lock_guard lock(paths_);
    const RunFolder run = library_.folder(scene);
    FilmWish wish;
    wish.kind = kind, wish.seconds = seconds;
    return keep(scene, editable(film_of_run(run, area_of(run), wish, Run{})));
}

Json Films::save(const std::string& scene, const Json& path) {
    const std::lock_guard lock(paths_);
    return keep(scene, read_camera_path(path.dump(), {}, "the path"));
}

Json Films::read(const std::string& scene, const std::string& text) {
    const std::lock_guard lock(paths_);
    return keep(scene, editable(read_camera_path(text, {}, "the file")));
}

fs::path Films::written(const std::string& scene, const std::string& format) {
    const std::lock_guard lock(paths_);
    const auto at = std::find(std::begin(kPathFormats), std::end(kPathFormats), format);
    if (at == std::end(kPathFormats))
        throw Refusal(404, "expected a known format of camera paths, found \"{}\"", format);
    const auto which = static_cast<PathFormat>(at - std::begin(kPathFormats));
    const fs::path file = folder(scene) /
                          (which == PathFormat::blender ? fs::path("camera.chan") : fs::path(format + ".json"));
    const CameraPath camera = path(scene);
    make_directories(folder(scene));
    save_camera_path(file, camera, which);
    return file;
}

std::string Films::frame(const std::string& scene, float time_s, int width) {
    CameraPath camera;
    {
        const std::lock_guard lock(paths_);
        camera = path(scene);
    }
    const fs::path file = library_.folder(scene).scene_ply();
    if (!fs::exists(file)) throw Refusal(409, "this scene has no splats yet");
    const std::lock_guard lock(stage_mutex_);
    const auto when = fs::last_write_time(file);
    if (!stage_ || stage_->file != file || stage_->when != when) {
        stage_.reset();  // before the next one: two may not fit in memory
        stage_ = std::make_unique<Stage>(Stage{file, when, load_splat_ply(file), {}});
        stage_->renderer = std::make_unique<SplatRenderer>(stage_->splats);
    }
    const CameraKey key = camera.at(time_s);
    const int height = std::max(1, width * camera.height / camera.width);
    const Pinhole lens = Pinhole::with_fov(width, height, key.fov_deg);
    return encode_jpeg(srgb8_from_unit(stage_->renderer->picture(lens, world_from_camera(key)).color), kJpegQuality);
}

fs::path Films::made(const std::string& scene) const {
    for (const char* const ending : kFilmEndings) {
        const fs::path film = folder(scene) / (std::string("film.") + ending);
        std::error_code none;
        const auto when = fs::last_write_time(film, none);
        if (!none && when >= fs::last_write_time(path_file(scene), none) && !none &&
            when >= fs::last_write_time(library_.folder(scene).scene_ply(), none) && !none)
            return film;
    }
    throw Refusal(404, "the film of this path is not made yet");
}

Json Films::live() const {
    const std::lock_guard lock(mutex_);
    return live_;
}

void Films::make(const std::string& scene, const std::string& ending) {
    if (std::find(std::begin(kFilmEndings), std::end(kFilmEndings), ending) == std::end(kFilmEndings))
        throw Refusal(400, "a film ends in .mp4 or .webm, found \"{}\"", ending);
    if (!find_program("ffmpeg")) throw Refusal(409, "films need ffmpeg: apt-get install ffmpeg");
    {
        const std::lock_guard lock(paths_);
        keep(scene, path(scene));
    }
    const fs::path film = folder(scene) / ("film." + ending);
    start(scene, {{"what", "film"}},
          {"render", library_.folder(scene).root.string(), "--path", path_file(scene).string(), "-o", film.string()});
    for (const char* const other : kFilmEndings)
        if (other != ending) fs::remove(folder(scene) / (std::string("film.") + other));
}

void Films::trace(const std::string& scene, float time_s) {
    const RunFolder run = library_.folder(scene);
    if (!fs::exists(run.room_json())) throw Refusal(409, "this scene was made from pictures: its room is not known");
    CameraPath camera;
    {
        const std::lock_guard lock(paths_);
        camera = path(scene);
        keep(scene, camera);
    }
    const CameraKey key = camera.at(time_s);
    const int height = std::max(64, kTracedWidth * camera.height / camera.width);
    const auto text = [](float value) { return fmt::format("{}", value); };
    start(scene, {{"what", "trace"}, {"time_s", time_s}},
          {"render",
           run.root.string(),
           "--of",
           "room",
           "--position",
           text(key.position_m.x),
           text(key.position_m.y),
           text(key.position_m.z),
           "--yaw",
           text(key.yaw_deg),
           "--pitch",
           text(key.pitch_deg),
           "--fov",
           text(key.fov_deg),
           "--size",
           fmt::format("{}x{}", kTracedWidth, height),
           "--samples",
           std::to_string(kTracedSamples),
           "-o",
           (folder(scene) / kTraced).string()});
}

fs::path Films::traced(const std::string& scene) const {
    const fs::path picture = folder(scene) / kTraced;
    if (!fs::exists(picture)) throw Refusal(404, "no view of this room was traced yet");
    return picture;
}

void Films::start(const std::string& scene, Json live, std::vector<std::string> arguments) {
    const std::lock_guard lock(mutex_);
    if (live_.at("state") == "running")
        throw Refusal(409, "a film or picture of {} is being made: stop it first",
                      live_.at("scene").get<std::string>());
    live.update(Json{{"scene", scene}, {"state", "running"}, {"overall", 0}, {"seconds_left", -1}, {"error", ""}});
    live_ = std::move(live);
    if (worker_.joinable()) worker_.join();  // it has said its last word
    worker_ = std::jthread(
        [this, scene, arguments = std::move(arguments)](std::stop_token stop) { work(scene, arguments, stop); });
    board_.changed();
}

void Films::stop() { worker_.request_stop(); }

void Films::work(const std::string& scene, std::vector<std::string> arguments, const std::stop_token& stop) {
    const fs::path log = folder(scene) / "log";
    std::error_code none;
    fs::remove(log, none);
    Job job;  // what the program says, as of a scene
    std::string state = "failed";
    std::jthread follower([&](std::stop_token end) {
        for (std::streamoff read = 0; !end.stop_requested(); std::this_thread::sleep_for(kFilmLogEvery)) {
            if (!read_more_of_log(log, read, job)) continue;
            {
                const std::lock_guard lock(mutex_);
                live_["overall"] = job.overall, live_["seconds_left"] = job.seconds_left;
            }
            board_.changed();
        }
    });
    try {
        arguments.insert(arguments.end(), {"--progress", "json"});
        const int code = run_program(
            program_, arguments,
            {log, {}, stop, [](int pid) { ::setpriority(PRIO_PROCESS, static_cast<id_t>(pid), kFilmNiceness); }});
        if (code == 0) state = "finished";
    } catch (const Stopped&) {
        state = "stopped";
    } catch (const std::exception& e) {
        job.error = e.what();
    }
    follower.request_stop();
    follower.join();
    {
        const std::lock_guard lock(mutex_);
        live_["state"] = state;
        if (state == "failed") live_["error"] = job.error.empty() ? "it failed without a message" : job.error;
    }
    board_.changed();
}

}  // namespace fastscene::studio
