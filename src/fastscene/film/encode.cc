#include "fastscene/film/encode.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "fastscene/base/error.h"
#include "fastscene/base/program.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Frame pattern for ffmpeg: colons in a folder's name must not be parsed as a protocol, percent signs not as a format.
std::string frame_pattern(const fs::path& folder) {
    std::string text = "file:";
    for (const char c : folder.string()) text += c == '%' ? "%%" : std::string(1, c);
    return text + "/%05d.png";
}

std::vector<std::string> codec(const fs::path& film) {
    // Near-transparent quality: sites that a film is uploaded to compress it again.
    if (film.extension() == ".webm")
        return {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-deadline", "good", "-cpu-used", "4"};
    return {"-c:v", "libx264", "-crf", "18", "-preset", "medium", "-movflags", "+faststart"};
}

void run_ffmpeg(std::vector<std::string> arguments, const fs::path& film, const fs::path& frames,
                std::stop_token stop) {
    arguments.insert(arguments.begin(), {"-y", "-nostdin", "-loglevel", "error"});
    const int code = run_program(*find_program("ffmpeg"), arguments, {{}, {}, stop});
    if (code != 0)
        throw Error("{}: ffmpeg failed with exit code {}; the frames are in {}", film.string(), code, frames.string());
}

}  // namespace

fs::path frame_file(const fs::path& folder, int frame) { return folder / fmt::format("{:05}.png", frame); }

std::string rate_text(float fps) {
    const double rate = static_cast<double>(fps), whole = std::round(rate * 1.001);
    if (std::fabs(rate - std::round(rate)) < 1e-4) return fmt::format("{}", static_cast<int>(std::round(rate)));
    constexpr double kRounded = 0.006;  // 23.98 for 24000/1001
    if (std::fabs(rate - whole / 1.001) < kRounded) return fmt::format("{}/1001", static_cast<int>(whole) * 1000);
    const auto thousandths = static_cast<int>(std::round(rate * 1000)), part = std::gcd(thousandths, 1000);
    return fmt::format("{}/{}", thousandths / part, 1000 / part);
}

bool is_film_name(const fs::path& path) { return path.extension() == ".mp4" || path.extension() == ".webm"; }

void check_ffmpeg(const fs::path& film) {
    if (!find_program("ffmpeg"))
        throw Error(
            "{}: expected ffmpeg on PATH, found none (apt-get install ffmpeg); a folder after --out gets the "
            "frames alone",
            film.string());
}

void encode_film(const FilmFrames& frames, const fs::path& film, const std::optional<SphericalFilm>& spherical,
                 std::stop_token stop) {
    check_ffmpeg(film);
    // The pictures are sRGB; players take a film without these marks for BT.601 or BT.709, by its size.
    std::vector<std::string> arguments{"-framerate",
                                       rate_text(frames.fps),
                                       "-i",
                                       frame_pattern(frames.folder),
                                       "-frames:v",
                                       std::to_string(frames.count),
                                       "-vf",
                                       "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv",
                                       "-pix_fmt",
                                       "yuv420p",
                                       "-colorspace",
                                       "bt709",
                                       "-color_primaries",
                                       "bt709",
                                       "-color_trc",
                                       "bt709",
                                       "-color_range",
                                       "tv"};
    for (const std::string& word : codec(film)) arguments.push_back(word);
    if (!spherical || film.extension() == ".mp4") {
        arguments.push_back("file:" + film.string());
        run_ffmpeg(std::move(arguments), film, frames.folder, stop);
        if (spherical) mark_spherical(film, *spherical);
        return;
    }
    // WebM has its own elements for spheres: ffmpeg writes them when it copies a marked MP4.
    const fs::path between = fs::path(film).concat(".part.mp4");
    arguments.push_back("file:" + between.string());
    run_ffmpeg(std::move(arguments), film, frames.folder, stop);
    mark_spherical(between, *spherical);
    run_ffmpeg({"-i", "file:" + between.string(), "-c", "copy", "-strict", "unofficial", "file:" + film.string()}, film,
               frames.folder, stop);
    fs::remove(between);
}

}  // namespace fastscene
