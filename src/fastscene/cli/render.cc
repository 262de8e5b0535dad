#include "fastscene/base/file.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/program.h"
#include "fastscene/cli/verb.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/camera_path.h"
#include "fastscene/pipeline/share.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct Flags {
    std::string scene, out, path, size = "1280x720";
    std::vector<float> position{0, 0, 0};
    float yaw_deg = 0, pitch_deg = 0, fov_deg = 75;
};

void parse_size(const std::string& text, int& width, int& height) {
    const auto x = text.find('x');
    if (x == std::string::npos) throw UsageError("--size: expected WIDTHxHEIGHT, found \"{}\"", text);
    width = number_from<int>("--size", text.substr(0, x));
    height = number_from<int>("--size", text.substr(x + 1));
    if (width < 1 || height < 1 || width > 16384 || height > 16384)
        throw UsageError("--size: expected 1x1 to 16384x16384, found \"{}\"", text);
}

// The film's frames as PNGs, and the film itself where ffmpeg is.
void render_film(const Splats& splats, const CameraPath& camera, const fs::path& out, const Session& session) {
    const Run run = session.run(0);
    const fs::path frames = out.extension() == ".mp4" ? fs::path(out).replace_extension("") : out;
    make_directories(frames);
    const Pinhole pinhole = Pinhole::with_fov(camera.width, camera.height, camera.fov_deg);
    const int count = camera.frames();
    Progress progress(run, "render", count);
    for (int i = 0; i < count; ++i) {
        run.check_stop();
        const CameraKey key = camera.at(camera.keys.front().time_s + static_cast<float>(i) / camera.fps);
        save_png(frames / fmt::format("{:05}.png", i), picture_of(splats, pinhole, world_from_camera_at(key.position_m, key.yaw_deg, key.pitch_deg)));
        progress.advance();
    }
    Json json{{"frames", frames.string()}, {"count", count}};
    std::string text = frames.string();
    if (const auto ffmpeg = find_program("ffmpeg")) {
        const fs::path film = fs::path(frames.string() + ".mp4");
        const int code = run_program(*ffmpeg, {"-y", "-loglevel", "error", "-framerate", fmt::format("{}", camera.fps), "-i",
                                               (frames / "%05d.png").string(), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt",
                                               "yuv420p", "-crf", "18", film.string()});
        if (code != 0) throw Error("{}: ffmpeg failed with exit code {}; the frames are in {}", film.string(), code, frames.string());
        json["film"] = film.string();
        text = film.string();
    } else {
        run.note("ffmpeg is not on PATH: the frames are here, the film is not (apt-get install ffmpeg)");
    }
    session.print(text, json);
}

void render(const Flags& flags, const Session& session) {
    const fs::path scene = fs::is_directory(flags.scene) ? RunFolder{flags.scene}.scene_ply() : fs::path(flags.scene);
    if (fs::is_directory(flags.scene) && !fs::exists(scene))
        throw UsageError("{}: expected a finished run or a .ply, found no splat/scene.ply", flags.scene);
    const fs::path folder = fs::is_directory(flags.scene) ? fs::path(flags.scene) : scene.parent_path();
    CameraPath camera;
    parse_size(flags.size, camera.width, camera.height);
    if (!(flags.fov_deg >= 1.f && flags.fov_deg <= 170.f)) throw UsageError("--fov: expected 1 to 170 degrees, found {}", flags.fov_deg);
    if (!flags.path.empty()) camera = load_camera_path(flags.path);
    const Splats splats = load_splat_ply(scene);
    if (!flags.path.empty()) return render_film(splats, camera, flags.out.empty() ? folder / "film" : fs::path(flags.out), session);

    const fs::path out = flags.out.empty() ? folder / "render.png" : fs::path(flags.out);
    const Vec3f position{flags.position[0], flags.position[1], flags.position[2]};
    const ImageRgb8 picture = picture_of(splats, Pinhole::with_fov(camera.width, camera.height, flags.fov_deg),
                                         world_from_camera_at(position, flags.yaw_deg, flags.pitch_deg));
    if (out.extension() == ".jpg" || out.extension() == ".jpeg")
        save_jpeg(out, picture);
    else if (out.extension() == ".png")
        save_png(out, picture);
    else
        throw UsageError("--out: expected a name that ends in .png or .jpg, found {}", out.string());
    session.print(out.string(), {{"picture", out.string()}});
}

}  // namespace

Verb add_render(CLI::App& app) {
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("render", "A picture of a scene, or a film along a camera path.");
    verb->add_option("scene", flags->scene, "Folder of a run, or a .ply of splats.")->type_name("DIR|PLY")->required();
    verb->add_option("-o,--out", flags->out, "Picture (.png, .jpg) or folder of frames; default: render.png or film/ in the run's folder.")->type_name("PATH");
    verb->add_option("--position", flags->position, "Where the camera is: metres right, down, forward of the first panorama.")->type_name("X Y Z")->expected(3)->default_str("0 0 0");
    verb->add_option("--yaw", flags->yaw_deg, "Degrees turned to the right.")->type_name("X")->capture_default_str();
    verb->add_option("--pitch", flags->pitch_deg, "Degrees looked up.")->type_name("X")->capture_default_str();
    verb->add_option("--fov", flags->fov_deg, "Horizontal field of view in degrees.")->type_name("X")->capture_default_str();
    verb->add_option("--size", flags->size, "Size of the picture in pixels.")->type_name("WxH")->capture_default_str();
    verb->add_option("--path", flags->path, "Camera path (JSON: fps, fov_deg, size, keys with time_s, position_m, yaw_deg, pitch_deg).")->type_name("FILE");
    return {verb, [flags](const Session& session) { render(*flags, session); }};
}

}  // namespace fastscene::cli
