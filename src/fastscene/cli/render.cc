#include "fastscene/cli/render.h"

#include <cmath>

#include "fastscene/base/file.h"
#include "fastscene/base/writable.h"
#include "fastscene/cli/checks.h"
#include "fastscene/film/encode.h"
#include "fastscene/io/camera_path_io.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/gpano_mark.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/splat_files.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

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

// Renders a picture for each camera of a capture, under the same names.
void render_cameras(const RenderSubject& subject, const Capture& capture, const fs::path& out, const Session& session) {
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
    if (place.extension() == ".chan") return {};
    const Json json = read_json(place);
    if (json.is_array()) return load_cameras_json(place);
    if (json.contains("frames")) return load_nerfstudio_capture(place, {});
    return {};
}

void render_one(const RenderSubject& subject, int width, int height, const fs::path& out, const RenderFlags& flags,
                const Session& session) {
    const Rigid pose = world_from_camera_at({flags.position[0], flags.position[1], flags.position[2]}, flags.yaw_deg,
                                            flags.pitch_deg);
    Json json{{"picture", out.string()}};
    if (stereo_of(flags) != FilmStereo::mono) {
        save_color(out, sphere_picture(subject, width, pose, stereo_of(flags)));
        return session.print(out.string(), json);
    }
    const Still still = flags.sphere ? subject.sphere(width, pose)
                                     : subject.flat(Pinhole::with_fov(width, height, flags.fov_deg), pose);
    flags.sphere ? save_panorama(out, still.color) : save_color(out, still.color);
    if (!flags.depth.empty()) save_distance(flags.depth, still.distance), json["depth"] = flags.depth;
    if (!flags.alpha.empty()) save_png(flags.alpha, still.alpha), json["alpha"] = flags.alpha;
    session.print(out.string(), json);
}

void refuse_with(const RenderFlags& flags, std::initializer_list<const char*> names, const std::string& why) {
    for (const char* name : names)
        if (flags.verb->count(name)) throw UsageError("{}: {}", name, why);
}

// Flags that contradict each other, before any work.
void check_flags(const RenderFlags& flags) {
    const bool of_room = flags.of == "room", planned = is_planned(flags.path), path = !flags.path.empty();
    if (!of_room) refuse_with(flags, {"--samples"}, "expected with --of room, found with --of " + flags.of);
    if (of_room) refuse_with(flags, {"--background"}, "expected with --of splats, found with --of room");
    if (of_room && !flags.given->empty())
        throw UsageError("{}: expected with --of splats, found with --of room", flags.given->begin()->first);
    if (!(flags.fov_deg >= 1.f && flags.fov_deg <= 170.f))
        throw UsageError("--fov: expected 1 to 170 degrees, found {}", flags.fov_deg);
    for (const float v : flags.background)
        if (!(v >= 0.f && v <= 1.f)) throw UsageError("--background: expected three numbers from 0 to 1, found {}", v);
    if (!flags.depth.empty() && !ends_in(flags.depth, {".exr", ".pfm", ".png"}))
        throw UsageError("--depth: expected a name that ends in .exr, .pfm or .png, found {}", flags.depth);
    if (!flags.alpha.empty() && !ends_in(flags.alpha, {".png"}))
        throw UsageError("--alpha: expected a name that ends in .png, found {}", flags.alpha);
    for (const float v : {flags.position[0], flags.position[1], flags.position[2], flags.yaw_deg, flags.pitch_deg})
        if (!(std::fabs(v) < 1e6f))
            throw UsageError("--position, --yaw, --pitch: expected numbers below a million, found {}", v);
    if (path && !(flags.depth.empty() && flags.alpha.empty()))
        throw UsageError("--path: cannot be combined with --depth or --alpha");
    if (path)
        refuse_with(flags, {"--position", "--yaw", "--pitch"},
                    "cannot be combined with --path, which moves the camera");
    if (path && !planned) refuse_with(flags, {"--fov"}, "cannot be combined with --path, whose file specifies it");
    if (!planned) refuse_with(flags, {"--seconds"}, "expected with --path tour, orbit or walkthrough");
    if (!path)
        refuse_with(flags, {"--fps", "--keep-frames", "--write-path", "--path-format", "--path-only"},
                    "expected with --path");
    if (!flags.path_format.empty() && flags.write_path.empty())
        throw UsageError("--path-format: expected with --write-path");
    if (flags.path_only && flags.write_path.empty()) throw UsageError("--path-only: expected with --write-path");
    if (!(flags.fps >= 1.f && flags.fps <= 240.f)) throw UsageError("--fps: expected 1 to 240, found {}", flags.fps);
    if (flags.verb->count("--seconds") && !(flags.seconds > 0.f && flags.seconds <= 3600.f))
        throw UsageError("--seconds: expected above 0 and at most 3600, found {}", flags.seconds);
    if (stereo_of(flags) != FilmStereo::mono && !flags.sphere)
        throw UsageError("--stereo: expected with --sphere, found without");
    if (stereo_of(flags) != FilmStereo::mono && !(flags.depth.empty() && flags.alpha.empty()))
        throw UsageError("--stereo: cannot be combined with --depth or --alpha");
}

fs::path out_of(const RenderFlags& flags) {
    if (!flags.out.empty()) return flags.out;
    const fs::path folder = fs::is_directory(flags.scene) ? fs::path(flags.scene)
                                                          : scene_file(flags.scene).parent_path();
    return folder / (flags.path.empty() ? "render.png" : is_planned(flags.path) ? flags.path + ".mp4" : "film");
}

CameraPath path_of(const RenderFlags& flags, int width, int height, const Session& session) {
    if (is_planned(flags.path)) return planned_path(flags, width, height, session);
    CameraPath otherwise;
    otherwise.fps = flags.fps, otherwise.width = width, otherwise.height = height;
    CameraPath camera = load_camera_path(flags.path, otherwise);
    if (!flags.size.empty()) camera.width = width, camera.height = height;
    if (flags.verb->count("--fps")) camera.fps = flags.fps;
    return camera;
}

void render(const RenderFlags& flags, const Session& session) {
    check_flags(flags);
    SplatBackend backend;
    apply_fields("", backend, *flags.given);
    check_fields("", backend);
    int width = 0, height = 0;
    parse_size(!flags.size.empty() ? flags.size : flags.sphere ? "2048x1024" : "1280x720", width, height);
    if (flags.sphere && width != 2 * height)
        throw UsageError("--size: expected twice as wide as high with --sphere, found {}", flags.size);
    const fs::path out = out_of(flags);
    if (flags.path.empty() && !ends_in(out, {".png", ".jpg", ".jpeg"}))
        throw UsageError("--out: expected a name that ends in .png or .jpg, found {}", out.string());
    const auto capture = flags.path.empty() || is_planned(flags.path) ? std::nullopt : cameras_of(flags.path);
    if (capture && (!flags.size.empty() || flags.sphere || !flags.write_path.empty()))
        throw UsageError("{}: cannot be combined with cameras from --path, which have their own",
                         flags.sphere         ? "--sphere"
                         : flags.size.empty() ? "--write-path"
                                              : "--size");
    CameraPath camera;
    if (!flags.path.empty() && !capture) {
        camera = path_of(flags, width, height, session);
        write_path(flags, camera);
        if (flags.path_only)
            return session.print(flags.write_path, {{"path", flags.write_path}, {"frames", camera.frames()}});
        if (is_film_name(out)) check_ffmpeg(out), check_writable(out);
    }
    if (flags.path.empty())
        for (const fs::path& file : {out, fs::path(flags.depth), fs::path(flags.alpha)})
            if (!file.empty()) check_writable(file);
    const RenderSubject subject = flags.of == "room"
                                      ? subject_of_room(flags.scene, flags.samples, session)
                                      : subject_of_splats(
                                            load_scene(flags.scene, session.run(0)).splats, backend,
                                            {flags.background[0], flags.background[1], flags.background[2]});
    if (capture) return render_cameras(subject, *capture, out, session);
    if (!flags.path.empty()) return render_film(subject, camera, out, flags, session);
    render_one(subject, width, height, out, flags, session);
}

// Flags of films and their paths.
void add_film_flags(CLI::App& verb, RenderFlags& flags) {
    const std::string group = "Films";
    verb.add_option(
            "--path", flags.path,
            "Film along a planned path over the walkable floor, at eye height: tour (from thing to thing), orbit "
            "(around the main one) or walkthrough (from the door through the room); or along the path in a file: "
            "ours, nerfstudio's camera_path.json, Blender's .chan, SuperSplat's settings; or pictures from the "
            "cameras in a cameras.json, a transforms.json or the folder of a COLMAP model or capture.")
        ->type_name("tour|orbit|walkthrough|FILE|DIR")
        ->group(group);
    verb.add_option("--seconds", flags.seconds,
                    "Length of a film along a planned path; default: that of a slow walk. A shorter tour makes fewer "
                    "stops.")
        ->type_name("X")
        ->group(group);
    verb.add_option("--fps", flags.fps, "Frames per second, unless the path's file specifies them.")
        ->type_name("X")
        ->capture_default_str()
        ->group(group);
    verb.add_option("--stereo", flags.stereo,
                    "With --sphere: stereo pictures. top-bottom: 360 degrees, the left eye on top; vr180: the front "
                    "half, side by side.")
        ->type_name("mono|top-bottom|vr180")
        ->check(one_of({"mono", "top-bottom", "vr180"}))
        ->capture_default_str()
        ->group(group);
    verb.add_flag("--keep-frames", flags.keep_frames, "Keep the frames of a film in the folder NAME.frames.")
        ->group(group);
    verb.add_option("--write-path", flags.write_path, "Also write the camera's path.")->type_name("FILE")->group(group);
    verb.add_option("--path-format", flags.path_format,
                    "Format of --write-path; default: blender for .chan, else fastscene.")
        ->type_name("fastscene|nerfstudio|blender|supersplat")
        ->check(one_of({"fastscene", "nerfstudio", "blender", "supersplat"}))
        ->group(group);
    verb.add_flag("--path-only", flags.path_only, "With --write-path: render nothing.")->group(group);
}

}  // namespace

Verb add_render(CLI::App& app) {
    auto flags = std::make_shared<RenderFlags>();
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
                     "Picture (.png, .jpg), film (.mp4, .webm) or folder of frames; default: in the run's folder.")
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
    add_film_flags(*verb, *flags);
    add_fields(*verb, "", SplatBackend{}, flags->given, "Where splats are rendered");
    verb->footer(
        "Examples:\n  fastscene render out/bedroom --yaw 40 --position 0.2 0 0.3 -o still.png\n"
        "  fastscene render out/bedroom --of room --yaw 40 --position 0.2 0 0.3 -o traced.png\n"
        "  fastscene render out/bedroom --path tour -o tour.mp4\n"
        "  fastscene render out/bedroom --of room --path walkthrough --sphere --stereo top-bottom -o vr.mp4");
    flags->verb = verb;
    return {verb, [flags](const Session& session) { render(*flags, session); }};
}

}  // namespace fastscene::cli
