#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/base/program.h"
#include "fastscene/base/writable.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/verb.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/camera_path.h"
#include "fastscene/pipeline/room_of_run.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/pipeline/splat_files.h"
#include "fastscene/splat/splat.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct Flags {
    std::string scene, of = "splats", out, path, size, depth, alpha;
    int samples = 128;
    std::vector<float> position{0, 0, 0}, background{0, 0, 0};
    float yaw_deg = 0, pitch_deg = 0, fov_deg = 75;
    bool sphere = false;
    std::shared_ptr<Given> given = std::make_shared<Given>();
    CLI::App* verb = nullptr;  // which flags were given
};

void parse_size(const std::string& text, int& width, int& height) {
    const auto x = text.find('x');
    if (x == std::string::npos) throw UsageError("--size: expected WIDTHxHEIGHT, found \"{}\"", text);
    width = number_from<int>("--size", text.substr(0, x));
    height = number_from<int>("--size", text.substr(x + 1));
    if (width < 1 || height < 1 || width > 16384 || height > 16384)
        throw UsageError("--size: expected 1x1 to 16384x16384, found \"{}\"", text);
}

bool ends_in(const fs::path& path, std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return path.extension() == e; });
}

void save_color(const fs::path& path, const ImageRgb8& picture) {
    if (ends_in(path, {".jpg", ".jpeg"})) return save_jpeg(path, picture);
    save_png(path, picture);
}
void save_distance(const fs::path& path, const ImageF& distance) {
    if (ends_in(path, {".exr"})) return save_exr(path, distance);
    if (ends_in(path, {".pfm"})) return save_pfm(path, distance);
    Image<std::uint16_t> millimetres(distance.width, distance.height);
    for (std::size_t i = 0; i < distance.size(); ++i)
        millimetres.pixels[i] = static_cast<std::uint16_t>(
            std::clamp(distance.pixels[i] * 1000.f + 0.5f, 0.f, 65535.f));
    save_png16(path, millimetres);
}

// Frame pattern for ffmpeg: colons in a folder's name must not be parsed as a protocol, percent signs not as a format.
std::string ffmpeg_frames(const fs::path& folder) {
    std::string text = "file:";
    for (const char c : folder.string()) text += c == '%' ? "%%" : std::string(1, c);
    return text + "/%05d.png";
}

// What to render: the splats, or the room that they were made from.
struct Subject {
    std::function<Still(const Pinhole&, const Rigid& world_from_camera)> flat;
    std::function<Still(int width, const Rigid& world_from_pano)> sphere;  // equirectangular
};

Subject subject_of_splats(Splats given, const SplatBackend& backend, Vec3f background) {
    const auto splats = std::make_shared<const Splats>(std::move(given));
    const auto renderer = std::make_shared<const SplatRenderer>(*splats, backend);
    return {[=](const Pinhole& camera, const Rigid& pose) {
                return (void)splats, still_of(*renderer, camera, pose, background);
            },
            [=](int width, const Rigid& pose) { return (void)splats, sphere_of(*renderer, width, pose, background); }};
}

// Path traced, with the noise level of the ground truth for metrics.
Subject subject_of_room(const std::string& folder, int samples, const Session& session) {
    const Run run = session.run(0);
    if (!fs::is_directory(folder))
        throw UsageError("--of room: expected the folder of a run from a prompt, found the file {}", folder);
    const RunFolder run_folder{folder};
    const RecordedRun recorded = recorded_run(run_folder);
    const std::shared_ptr<const TracedRoom> room = room_of_run(run_folder, recorded, 0, run);
    const ShotParts parts = final_parts(samples);
    const Run quiet{recorded.seed, nullptr, run.stop};
    const auto still = [](Shot shot, auto&& of_range) {
        Still out{srgb8_from_linear(shot.color), ImageMask(shot.color.width, shot.color.height, 255),
                  std::move(shot.range)};
        for (int y = 0; y < out.distance.height; ++y)
            for (int x = 0; x < out.distance.width; ++x) {
                float& d = out.distance.at(x, y);
                d = std::isfinite(d) ? d * of_range(x, y) : 0.f;  // nothing is hit outside
            }
        return out;
    };
    return {
        [=](const Pinhole& camera, const Rigid& pose) {
            return still(room->perspective(pose, camera, parts, quiet), [&](int x, int y) {
                return normalize(camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f})).z;
            });
        },
        [=](int width, const Rigid& pose) {
            return still(room->panorama(pose, {width, width / 2}, parts, quiet), [](int, int) { return 1.f; });
        }};
}

// Writes the film's frames as PNGs, and the film if ffmpeg is available.
void render_film(const Subject& subject, const CameraPath& camera, const fs::path& out, const Flags& flags,
                 const Session& session) {
    const Run run = session.run(0);
    const fs::path frames = out.extension() == ".mp4" ? fs::path(out).replace_extension("") : out;
    make_directories(frames);
    const Pinhole pinhole = Pinhole::with_fov(camera.width, camera.height, camera.fov_deg);
    const int count = camera.frames();
    Progress progress(run, "render", count);
    for (int i = 0; i < count; ++i) {
        run.check_stop();
        const CameraKey key = camera.at(camera.keys.front().time_s + static_cast<float>(i) / camera.fps);
        const Rigid pose = world_from_camera_at(key.position_m, key.yaw_deg, key.pitch_deg);
        save_png(frames / fmt::format("{:05}.png", i),
                 (flags.sphere ? subject.sphere(camera.width / 2 * 2, pose) : subject.flat(pinhole, pose)).color);
        progress.advance();
    }
    Json json{{"frames", frames.string()}, {"count", count}};
    std::string text = frames.string();
    // Frames of an earlier, longer film would be appended.
    if (fs::exists(frames / fmt::format("{:05}.png", count)))
        run.note(fmt::format("{}: frames from {:05}.png on belong to an earlier film", frames.string(), count));
    if (const auto ffmpeg = find_program("ffmpeg")) {
        const fs::path film = fs::path(frames.string() + ".mp4");
        const int code = run_program(
            *ffmpeg,
            {"-y", "-loglevel", "error", "-framerate", fmt::format("{}", camera.fps), "-i", ffmpeg_frames(frames),
             "-frames:v", std::to_string(count), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-crf",
             "18", "file:" + film.string()},
            {{}, {}, session.stop});
        if (code != 0)
            throw Error("{}: ffmpeg failed with exit code {}; the frames are in {}", film.string(), code,
                        frames.string());
        json["film"] = film.string();
        text = film.string();
    } else {
        run.note("ffmpeg is not on PATH: only the frames were written, not the film (apt-get install ffmpeg)");
    }
    session.print(text, json);
}

// Renders a picture for each camera of a capture, under the same names.
void render_cameras(const Subject& subject, const Capture& capture, const fs::path& out, const Session& session) {
    const Run run = session.run(0);
    if (capture.photos.empty()) throw Error("{}: expected cameras, found none", capture.source);
    Progress progress(run, "render", static_cast<std::int64_t>(capture.photos.size()));
    const auto to_float = [](Vec3d v) {
        return Vec3f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    bool bent = false;
    for (const Photo& photo : capture.photos) {
        run.check_stop();
        const Mat3d& r = photo.world_from_camera.rotation;
        const Rigid pose{{to_float(r.row0), to_float(r.row1), to_float(r.row2)},
                         to_float(photo.world_from_camera.translation)};
        const bool sphere = photo.lens.kind == LensKind::equirectangular;
        bent = bent || !(sphere || photo.lens.is_pinhole());
        // Names with ".." must not leave the folder.
        std::string below;
        for (const fs::path& part : fs::path(photo.name).relative_path())
            if (part != ".." && part != ".") below += (below.empty() ? "" : "/") + part.string();
        const fs::path file = (out / below).replace_extension(".png");
        make_directories(file.parent_path());
        save_png(
            file,
            (sphere ? subject.sphere(photo.lens.width / 2 * 2, pose) : subject.flat(photo.lens.pinhole(), pose)).color);
        progress.advance();
    }
    if (bent) run.note("lenses with distortion were rendered without it");
    session.print(out.string(), {{"frames", out.string()}, {"count", capture.photos.size()}});
}

// Cameras of a COLMAP model, a capture's folder, a transforms.json or a cameras.json; empty: a camera path file.
std::optional<Capture> cameras_of(const fs::path& place) {
    if (fs::is_directory(place)) {
        if (const auto model = colmap_model_in(place)) return load_colmap_model(*model);
        return load_nerfstudio_capture(place, {});
    }
    const Json json = read_json(place);
    if (json.is_array()) return load_cameras_json(place);
    if (json.contains("frames")) return load_nerfstudio_capture(place, {});
    return {};
}

void render_one(const Subject& subject, const CameraPath& camera, const fs::path& out, const Flags& flags,
                const Session& session) {
    const Rigid pose = world_from_camera_at({flags.position[0], flags.position[1], flags.position[2]}, flags.yaw_deg,
                                            flags.pitch_deg);
    const Still still = flags.sphere
                            ? subject.sphere(camera.width, pose)
                            : subject.flat(Pinhole::with_fov(camera.width, camera.height, flags.fov_deg), pose);
    save_color(out, still.color);
    Json json{{"picture", out.string()}};
    if (!flags.depth.empty()) save_distance(flags.depth, still.distance), json["depth"] = flags.depth;
    if (!flags.alpha.empty()) save_png(flags.alpha, still.alpha), json["alpha"] = flags.alpha;
    session.print(out.string(), json);
}

void render(const Flags& flags, const Session& session) {
    const bool of_room = flags.of == "room";
    const fs::path folder = fs::is_directory(flags.scene) ? fs::path(flags.scene)
                                                          : scene_file(flags.scene).parent_path();
    if (flags.verb->count("--samples") && !of_room)
        throw UsageError("--samples: expected with --of room, found with --of {}", flags.of);
    if (flags.verb->count("--background") && of_room)
        throw UsageError("--background: expected with --of splats, found with --of room");
    SplatBackend backend;
    apply_fields("", backend, *flags.given);
    check_fields("", backend);
    if (of_room && !flags.given->empty())
        throw UsageError("{}: expected with --of splats, found with --of room", flags.given->begin()->first);
    CameraPath camera;
    parse_size(!flags.size.empty() ? flags.size : flags.sphere ? "2048x1024" : "1280x720", camera.width, camera.height);
    if (flags.sphere && camera.width != 2 * camera.height)
        throw UsageError("--size: expected twice as wide as high with --sphere, found {}", flags.size);
    if (!(flags.fov_deg >= 1.f && flags.fov_deg <= 170.f))
        throw UsageError("--fov: expected 1 to 170 degrees, found {}", flags.fov_deg);
    for (const float v : flags.background)
        if (!(v >= 0.f && v <= 1.f)) throw UsageError("--background: expected three numbers from 0 to 1, found {}", v);
    const fs::path out = !flags.out.empty() ? fs::path(flags.out)
                                            : folder / (flags.path.empty() ? "render.png" : "film");
    if (flags.path.empty() && !ends_in(out, {".png", ".jpg", ".jpeg"}))
        throw UsageError("--out: expected a name that ends in .png or .jpg, found {}", out.string());
    if (!flags.depth.empty() && !ends_in(flags.depth, {".exr", ".pfm", ".png"}))
        throw UsageError("--depth: expected a name that ends in .exr, .pfm or .png, found {}", flags.depth);
    if (!flags.alpha.empty() && !ends_in(flags.alpha, {".png"}))
        throw UsageError("--alpha: expected a name that ends in .png, found {}", flags.alpha);
    if (!flags.path.empty() && !(flags.depth.empty() && flags.alpha.empty()))
        throw UsageError("--path: cannot be combined with --depth or --alpha");

    for (const float v : {flags.position[0], flags.position[1], flags.position[2], flags.yaw_deg, flags.pitch_deg})
        if (!(std::fabs(v) < 1e6f))
            throw UsageError("--position, --yaw, --pitch: expected numbers below a million, found {}", v);
    if (!flags.path.empty())
        for (const char* flag : {"--position", "--yaw", "--pitch", "--fov"})
            if (flags.verb->count(flag))
                throw UsageError("{}: cannot be combined with --path, whose file specifies it", flag);

    const auto capture = flags.path.empty() ? std::nullopt : cameras_of(flags.path);
    if (capture && (!flags.size.empty() || flags.sphere))
        throw UsageError("{}: cannot be combined with cameras from --path, which have their own",
                         flags.sphere ? "--sphere" : "--size");
    if (!flags.path.empty() && !capture) {
        const int width = camera.width, height = camera.height;
        camera = load_camera_path(flags.path);
        if (!flags.size.empty()) camera.width = width, camera.height = height;
    }
    if (flags.path.empty())
        for (const fs::path& file : {out, fs::path(flags.depth), fs::path(flags.alpha)})
            if (!file.empty()) check_writable(file);
    const Subject subject = of_room
                                ? subject_of_room(flags.scene, flags.samples, session)
                                : subject_of_splats(load_scene(flags.scene, session.run(0)).splats, backend,
                                                    {flags.background[0], flags.background[1], flags.background[2]});
    if (capture) return render_cameras(subject, *capture, out, session);
    if (!flags.path.empty()) return render_film(subject, camera, out, flags, session);
    render_one(subject, camera, out, flags, session);
}

}  // namespace

Verb add_render(CLI::App& app) {
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("render",
                                        "Renders a scene: a picture, a panorama, or a film along a camera path.");
    verb->add_option("scene", flags->scene, fmt::format("Folder of a run, or a splat file ({}).", splat_endings()))
        ->type_name("DIR|FILE")
        ->required();
    verb->add_option(
            "--of", flags->of,
            "What to render: the splats, or by path tracing the room they were made from (scenes from a prompt).")
        ->type_name("splats|room")
        ->check(one_of({"splats", "room"}))
        ->capture_default_str();
    verb->add_option("--samples", flags->samples, "With --of room: maximum camera rays per pixel.")
        ->type_name("N")
        ->check(whole_number_within(16, 65536))
        ->capture_default_str();
    verb->add_option("-o,--out", flags->out,
                     "Picture (.png, .jpg) or folder of frames; default: render.png or film/ in the run's folder.")
        ->type_name("PATH");
    verb->add_option("--position", flags->position,
                     "Camera position: metres right, down, forward of the first panorama.")
        ->type_name("X Y Z")
        ->expected(3)
        ->default_str("0 0 0");
    verb->add_option("--yaw", flags->yaw_deg, "Yaw to the right in degrees.")->type_name("X")->capture_default_str();
    verb->add_option("--pitch", flags->pitch_deg, "Pitch upward in degrees.")->type_name("X")->capture_default_str();
    verb->add_option("--fov", flags->fov_deg, "Horizontal field of view in degrees.")
        ->type_name("X")
        ->capture_default_str();
    verb->add_option("--size", flags->size, "Size of the picture in pixels; default 1280x720, with --sphere 2048x1024.")
        ->type_name("WxH");
    verb->add_flag("--sphere", flags->sphere, "Render an equirectangular picture.");
    verb->add_option("--depth", flags->depth,
                     "Also write depth: .exr, .pfm (metres) or .png (16 bit, millimetres); along the optical axis, "
                     "with --sphere along the ray.")
        ->type_name("FILE");
    verb->add_option("--alpha", flags->alpha, "Also write opacity (.png).")->type_name("FILE");
    verb->add_option("--background", flags->background, "Color behind the splats, 0 to 1.")
        ->type_name("R G B")
        ->expected(3)
        ->default_str("0 0 0");
    verb->add_option(
            "--path", flags->path,
            "Camera path (JSON: fps, fov_deg, size, keys with time_s, position_m, yaw_deg, pitch_deg), or cameras to "
            "render from: a cameras.json, a transforms.json or the folder of a COLMAP model or capture.")
        ->type_name("FILE|DIR");
    add_fields(*verb, "", SplatBackend{}, flags->given, "Where splats are rendered");
    verb->footer(
        "Examples:\n  fastscene render out/bedroom --yaw 40 --position 0.2 0 0.3 -o still.png\n"
        "  fastscene render out/bedroom --of room --yaw 40 --position 0.2 0 0.3 -o traced.png");
    flags->verb = verb;
    return {verb, [flags](const Session& session) { render(*flags, session); }};
}

}  // namespace fastscene::cli
