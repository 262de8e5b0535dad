// Pin board.
#include <algorithm>
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

// Cork with notes, cards and photographs on pins.
void build_pin_board(Kit& k) {
    const Vec3f s = k.wanted({1.05f, 0.72f, 0.03f});
    Material cork = plain("cork", {0.42f, 0.26f, 0.13f}, 0.95f);
    cork.pattern = Pattern::terrazzo;
    cork.scale_m = 0.008f;
    cork.color_b = {0.3f, 0.17f, 0.08f};
    cork.color_c = {0.5f, 0.34f, 0.19f};
    const int board = k.main(cork), wood = k.material(k.style.wood2),
              ink = k.material(plain("ink", {0.05f, 0.05f, 0.08f}, 0.7f));
    k.board(board, {0, 0.01f, 0.007f}, {s.x - 0.02f, s.y - 0.02f, 0.012f}, 0.001f);
    wall_frame(k, wood, s, 0.026f, 0.02f);
    static constexpr std::array<Vec3f, 5> kPapers{Vec3f{0.74f, 0.73f, 0.69f},
                                                  {0.7f, 0.62f, 0.2f},
                                                  {0.68f, 0.4f, 0.42f},
                                                  {0.4f, 0.58f, 0.66f},
                                                  {0.5f, 0.62f, 0.36f}};
    std::array<int, 5> papers{};
    for (std::size_t i = 0; i < 5; ++i) papers[i] = k.material(plain("note", kPapers[i], 0.9f));
    std::array<int, 3> pins{};
    for (std::size_t i = 0; i < 3; ++i)
        pins[i] = k.material(
            plain("pin", std::array{Vec3f{0.5f, 0.03f, 0.03f}, Vec3f{0.03f, 0.1f, 0.4f}, Vec3f{0.65f, 0.5f, 0.04f}}[i],
                  0.25f));
    const int columns = std::max(2, static_cast<int>(s.x / 0.165f)), rows = std::max(1, static_cast<int>(s.y / 0.19f));
    for (int i = 0; i < columns * rows; ++i) {
        if (k.rng.chance(0.12f)) continue;
        const float cx = s.x * ((static_cast<float>(i % columns) + 0.5f) / static_cast<float>(columns) - 0.5f) * 0.9f +
                         k.rng.uniform(-0.018f, 0.018f),
                    cy = 0.06f + (s.y - 0.12f) * (static_cast<float>(i / columns) + 0.5f) / static_cast<float>(rows) +
                         k.rng.uniform(-0.02f, 0.02f);
        const int kind = k.rng.index(4);
        const float pw = kind == 0   ? 0.125f
                         : kind == 1 ? 0.1f
                                     : k.rng.uniform(0.12f, 0.17f),
                    ph = kind == 0   ? 0.17f
                         : kind == 1 ? 0.1f
                                     : pw * 0.72f,
                    turn = k.rng.uniform(-7.f, 7.f);
        const float z = 0.0145f + 0.0007f * static_cast<float>(i % 3);
        const std::size_t first = k.piece.meshes.size();
        // Photographs have a white rim; the rest is written on.
        const int sheet = papers[kind == 3 || kind == 0 ? 0 : 1 + static_cast<std::size_t>(k.rng.index(4))];
        k.board(sheet, {0, -0.5f * ph, 0}, {pw, ph, 0.0008f}, 0.0002f);
        if (kind == 3) {
            Material photo = plain("photo", k.accent(), 0.35f);
            photo.pattern = Pattern::art;
            photo.color_b = k.accent();
            photo.color_c = k.accent();
            photo.scale_m = pw;
            photo.seed = k.seed();
            Mesh face = shapes::box({pw - 0.016f, ph - 0.016f, 0.0006f}, 0.0001f);
            face.coords = face.positions;
            for (Vec3f& c : face.coords) c = {c.x + 0.5f * pw, 0.5f * ph - c.y, c.z};
            k.add(std::move(face), k.material(photo), {0, 0, 0.0006f});
        } else {
            Chalk pen(k, ink, 0.0007f, 0.0022f);
            for (int j = 0; j < (kind == 0 ? 6 : 3); ++j)
                pen.words(-0.42f * pw, 0.42f * pw, ph * (0.28f - (kind == 0 ? 0.12f : 0.22f) * static_cast<float>(j)),
                          0.0085f);
        }
        for (std::size_t j = first; j < k.piece.meshes.size(); ++j)
            shapes::move(shapes::turn(k.piece.meshes[j], {0, 0, 1}, turn), {cx, cy, z});
        const int pin = pins[static_cast<std::size_t>(k.rng.index(3))];
        k.add(shapes::ball({cx, cy + 0.42f * ph, z + 0.006f}, {0.0065f, 0.0065f, 0.006f}, 10), pin);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.15f;
}

}  // namespace fastscene::furniture
