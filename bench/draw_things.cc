// Draws things alone: each kind from two sides, in a row, shaded by its colors and normals only, so that a sheet of
// twenty takes seconds. For whoever writes a builder: draw_things microscope printer --style modern -o sheet.png
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "fastscene/base/run.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/style.h"
#include "fastscene/trace/trace.h"

namespace fastscene {
namespace {

constexpr float kFov = 26.f;                          // degrees: little perspective, as in a catalogue
constexpr Vec3f kPaper{0.8f, 0.8f, 0.82f};            // behind the thing
constexpr Vec3f kLight{0.35f, 0.8f, 0.48f};           // towards the light, of unit length
constexpr std::array<float, 2> kTurns{30.f, -125.f};  // degrees: of the camera about the thing, from its front

struct Box {
    Vec3f low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
};
Box box_of(const Piece& piece) {
    Box b;
    for (const Mesh& m : piece.meshes)
        for (const Vec3f& p : m.positions)
            for (std::size_t k = 0; k < 3; ++k)
                b.low[k] = std::min(b.low[k], p[k]), b.high[k] = std::max(b.high[k], p[k]);
    return b;
}

// One picture of `side` x `side` pixels.
ImageColor draw(const TracedRoom& room, const Box& box, float turn_deg, int side, const Run& run) {
    const Vec3f middle = (box.low + box.high) * 0.5f;
    const float radius = 0.5f * length(box.high - box.low),
                distance = radius / std::sin(0.5f * kFov * std::numbers::pi_v<float> / 180.f);
    const float a = turn_deg * std::numbers::pi_v<float> / 180.f;
    const Vec3f from = normalize(Vec3f{std::sin(a), 0.42f, std::cos(a)}), forward = from * -1.f,
                right = normalize(cross(forward, Vec3f{0, 1, 0})), down = cross(forward, right);
    const Shot shot = room.perspective(
        {Mat3f::from_columns(right, down, forward), middle + from * distance}, Pinhole::with_fov(side, side, kFov),
        {.color = false, .albedo = true, .normal = true, .mesh = true, .pixel_samples = 8}, run);
    ImageColor out(side, side);
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (shot.mesh.pixels[i] < 0) {
            out.pixels[i] = kPaper;
            continue;
        }
        const float facing = dot(shot.normal.pixels[i], kLight);
        out.pixels[i] = shot.albedo.pixels[i] * (0.45f + 0.6f * std::max(0.f, facing) + 0.12f * facing);
    }
    return out;
}

int draw_all(const std::vector<std::string>& kinds, const std::string& style, std::uint64_t seed, int side,
             const std::string& file) {
    const int across = 4, cells = 2 * static_cast<int>(kinds.size()), rows = (cells + across - 1) / across;
    ImageColor sheet(side * std::min(across, cells), side * rows);
    std::fill(sheet.pixels.begin(), sheet.pixels.end(), kPaper);
    const Run run;
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        const Piece piece = make_piece({.kind = kinds[n], .style = &style_named(style), .seed = seed});
        const Box box = box_of(piece);
        std::size_t triangles = 0;
        for (const Mesh& m : piece.meshes) triangles += m.triangles.size() / 3;
        std::printf("%-24s %5.2f x %5.2f x %5.2f m  %6zu triangles\n", kinds[n].c_str(),
                    static_cast<double>(piece.size_m.x), static_cast<double>(piece.size_m.y),
                    static_cast<double>(piece.size_m.z), triangles);
        Room room;
        room.materials = piece.materials;
        room.meshes = piece.meshes;
        room.min_corner = box.low, room.max_corner = box.high;
        TracedRoom traced(std::move(room));
        // Colors come with light, of which nothing is shown.
        traced.gather_light({.cell_m = 0.5f, .cell_samples = 1, .outside_detail = 0}, run);
        for (std::size_t t = 0; t < kTurns.size(); ++t) {
            const ImageColor picture = draw(traced, box, kTurns[t], side, run);
            const int cell = static_cast<int>(2 * n + t), x0 = side * (cell % across), y0 = side * (cell / across);
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) sheet.at(x0 + x, y0 + y) = picture.at(x, y);
        }
    }
    save_png(file, srgb8_from_linear(sheet));
    return 0;
}

}  // namespace
}  // namespace fastscene

int main(int argc, char** argv) {
    CLI::App app("Draws things alone, each from two sides: four pictures a row.", "draw_things");
    std::vector<std::string> kinds;
    std::string style = "modern", file = "things.png";
    std::uint64_t seed = 1;
    int side = 320;
    app.add_option("kinds", kinds, "Kinds of the catalogue.")->required();
    app.add_option("--style", style)->capture_default_str();
    app.add_option("--seed", seed);
    app.add_option("--side", side, "Pixels of a picture.")->capture_default_str();
    app.add_option("-o,--out", file)->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        return fastscene::draw_all(kinds, style, seed, side, file);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "draw_things: %s\n", e.what());
        return 1;
    }
}
