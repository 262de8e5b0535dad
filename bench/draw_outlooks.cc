// Pictures of the outside alone, as a photographer before the house would take them: source of the framed photographs
// and paintings of rooms (docs/decisions/0018-framed-pictures.md).
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <string>

#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/trace/film.h"
#include "fastscene/trace/outdoors.h"

namespace fastscene {
namespace {

constexpr float kPixelsPerDegree = 24;
constexpr float kBright = 0.2f;  // mean of the picture: middle gray

// What a window as large as a wall shows from the middle of the room that the sentence asks for.
void draw(const std::string& sentence, std::uint64_t seed, float fov_deg, float turn_deg, float pitch_deg, int width,
          int height, const std::string& file) {
    Run run;
    run.seed = seed;
    PromptSpec spec = understand_prompt(sentence, false);
    const Room room = make_room(spec, run);
    const float half = 1.3f *
                       std::tan(fov_deg * kPi / 360);  // of a window a metre ahead: no more is drawn than is shown
    const float azimuth = main_outlook(room.portals) + turn_deg * kPi / 180;
    const Vec3f ahead{std::sin(azimuth), 0, std::cos(azimuth)}, right{ahead.z, 0, -ahead.x};
    const Vec3f corner = ahead + right * half - Vec3f{0, half, 0};
    const Outdoors outside(room.sky, {{corner, right * (-2 * half), {0, 2 * half, 0}}}, {-0.01f, -0.01f, -0.01f},
                           {0.01f, 0.01f, 0.01f}, kPixelsPerDegree);
    ImageColor picture(width, height);
    const float focal = 0.5f * static_cast<float>(width) / std::tan(fov_deg * kPi / 360), pitch = pitch_deg * kPi / 180;
    double mean = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = (static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(width)) / focal,
                        v = (static_cast<float>(y) + 0.5f - 0.5f * static_cast<float>(height)) / focal;
            const Vec3f forward = ahead * std::cos(pitch) - Vec3f{0, std::sin(pitch), 0},
                        down = ahead * std::sin(pitch) + Vec3f{0, std::cos(pitch), 0};
            const Vec3f color = outside.seen(normalize(forward + right * u + down * v));
            picture.at(x, y) = color;
            mean += std::log2(std::max(1e-6f, luminance(color)));
        }
    Look look = room.look;
    look.automatic = false;
    look.white = {1, 1, 1};
    look.exposure_ev = std::log2(kBright) - static_cast<float>(mean / width / height);
    for (Vec3f& c : picture.pixels) c = develop(look, c);
    save_png(file, srgb8_from_linear(picture));
}

}  // namespace
}  // namespace fastscene

int main(int argc, char** argv) {
    CLI::App app("A picture of the outside that a room's windows look at.", "draw_outlooks");
    std::string sentence, file = "outlook.png";
    std::uint64_t seed = 1;
    float fov = 40, turn = 0, pitch = 2;
    int width = 900, height = 600;
    app.add_option("sentence", sentence, "Of a room: \"a living room with a view of the sea at dusk\".")->required();
    app.add_option("--seed", seed);
    app.add_option("--fov", fov, "Degrees across.")->capture_default_str();
    app.add_option("--turn", turn, "Degrees from the window's direction.")->capture_default_str();
    app.add_option("--pitch", pitch, "Degrees upwards.")->capture_default_str();
    app.add_option("--width", width)->capture_default_str();
    app.add_option("--height", height)->capture_default_str();
    app.add_option("-o,--out", file)->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        fastscene::draw(sentence, seed, fov, turn, pitch, width, height, file);
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "draw_outlooks: %s\n", e.what());
        return 1;
    }
}
