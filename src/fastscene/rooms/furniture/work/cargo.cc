// What carries and holds goods: forklifts, hand trucks, pallets, crates, drums, sacks, bins.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/profiles.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

void cargo_wheel(Kit& k, int tire, int hub, Vec3f at, float radius, float width) {
    const Vec3f half{0.5f * width, 0, 0}, rim{0.5f * width + 0.006f, 0, 0};
    k.rod(tire, at - half, at + half, radius, -1, 20), k.rod(hub, at - rim, at + rim, 0.55f * radius, -1, 14);
}

int cargo_cloth(Kit& k, Vec3f albedo) {
    Material m = k.style.fabric;
    m.name = "sacking";
    return k.main(tinted(m, albedo));
}

}  // namespace

// With a counterweight at the back, a guard over the driver, a mast and two forks at the front.
void build_forklift(Kit& k) {
    const int body = k.main(plain("machine enamel", {0.72f, 0.38f, 0.02f}, 0.35f)),
              dark = color(k, "mast", {0.035f, 0.036f, 0.038f}, 0.5f),
              tire = color(k, "tire", {0.022f, 0.022f, 0.023f}, 0.85f),
              hub = color(k, "wheel hub", {0.55f, 0.54f, 0.5f}, 0.5f), metal = k.material(steel()),
              seat = color(k, "seat", {0.03f, 0.03f, 0.033f}, 0.6f), lamp = color(k, "lens", {0.7f, 0.7f, 0.66f}, 0.1f),
              red = color(k, "tail light", {0.5f, 0.03f, 0.02f}, 0.2f);
    const std::array<Vec2f, 9> weight{Vec2f{-1.12f, 0.16f}, {-0.5f, 0.16f},  {-0.5f, 0.3f},
                                      {-0.38f, 0.86f},      {-0.42f, 0.92f}, {-0.98f, 0.98f},
                                      {-1.12f, 0.9f},       {-1.2f, 0.6f},   {-1.2f, 0.3f}};
    k.add(side_prism(weight, -0.53f, 0.53f, 0.03f), body);
    k.board(body, {0, 0.2f, 0.05f}, {1.04f, 0.3f, 1.0f}, 0.02f),
        k.board(dark, {0, 0.5f, 0.12f}, {0.96f, 0.02f, 0.7f}, 0.006f);
    const std::array<Vec2f, 5> dash{Vec2f{0.38f, 0.48f}, {0.56f, 0.48f}, {0.56f, 1.0f}, {0.46f, 1.05f}, {0.38f, 0.9f}};
    k.add(side_prism(dash, -0.48f, 0.48f, 0.02f), body);
    k.board(seat, {0, 0.9f, -0.46f}, {0.5f, 0.12f, 0.46f}, 0.04f),
        k.board(seat, {0, 1.0f, -0.7f}, {0.48f, 0.46f, 0.12f}, 0.04f);
    k.rod(dark, {0, 0.95f, 0.42f}, {0, 1.12f, 0.26f}, 0.025f);
    Mesh wheel = shapes::ring(0.16f, 0.026f, 24);
    shapes::turn(wheel, {1, 0, 0}, 40);
    k.add(std::move(wheel), dark, {0, 1.13f, 0.25f});
    for (const float x : {-0.06f, 0.02f, 0.1f})
        k.rod(metal, {x + 0.25f, 1.0f, 0.43f}, {x + 0.25f, 1.16f, 0.4f}, 0.008f, 0.014f, 8);
    for (const float sx : {-1.f, 1.f}) {  // the guard
        const float x = 0.47f * sx;
        strut(k, dark, {x, 1.0f, 0.5f}, {x, 2.05f, 0.3f}, 0.06f, 0.06f),
            strut(k, dark, {x, 0.92f, -0.9f}, {x, 2.05f, -0.74f}, 0.06f, 0.06f);
        k.board(dark, {x, 2.03f, -0.22f}, {0.06f, 0.06f, 1.1f}, 0.01f);
        cargo_wheel(k, tire, hub, {sx * 0.47f, 0.29f, 0.5f}, 0.29f, 0.2f),
            cargo_wheel(k, tire, hub, {sx * 0.46f, 0.24f, -0.8f}, 0.24f, 0.18f);
        k.rod(lamp, {sx * 0.42f, 1.9f, 0.36f}, {sx * 0.42f, 1.9f, 0.42f}, 0.055f, 0.06f, 14);
        block(k, red, {sx * 0.4f, 0.72f, -1.18f}, {0.12f, 0.08f, 0.05f});
        k.board(dark, {sx * 0.28f, 0.08f, 0.72f}, {0.1f, 2.0f, 0.12f}, 0.006f),
            k.board(metal, {sx * 0.2f, 0.1f, 0.74f}, {0.06f, 1.9f, 0.1f}, 0.004f);
        k.rod(metal, {sx * 0.1f, 0.3f, 0.72f}, {sx * 0.1f, 1.6f, 0.72f}, 0.028f, -1, 10);
        k.board(dark, {sx * 0.24f, 0.06f, 0.86f}, {0.1f, 0.5f, 0.04f}, 0.006f);  // the forks
        const std::array<Vec2f, 4> fork{Vec2f{0.84f, 0.05f}, {1.95f, 0.05f}, {1.95f, 0.062f}, {0.84f, 0.1f}};
        k.add(side_prism(fork, sx * 0.24f - 0.05f, sx * 0.24f + 0.05f, 0.003f), dark);
    }
    for (int i = 0; i < 6; ++i)
        block(k, dark, {-0.38f + 0.152f * static_cast<float>(i), 2.045f, -0.22f}, {0.03f, 0.03f, 1.06f});
    k.board(dark, {0, 2.03f, 0.3f}, {1.0f, 0.06f, 0.06f}, 0.01f),
        k.board(dark, {0, 2.03f, -0.74f}, {1.0f, 0.06f, 0.06f}, 0.01f);
    for (const float y : {0.12f, 1.1f, 2.0f}) k.board(dark, {0, y, 0.7f}, {0.6f, 0.08f, 0.08f}, 0.005f);
    for (const float y : {0.2f, 0.48f}) k.board(dark, {0, y, 0.83f}, {0.92f, 0.07f, 0.04f}, 0.005f);
    for (int i = 0; i < 7; ++i)
        block(k, dark, {-0.42f + 0.14f * static_cast<float>(i), 0.52f, 0.83f}, {0.025f, 0.5f, 0.025f});
    block(k, dark, {0, 1.0f, 0.83f}, {0.88f, 0.035f, 0.03f});
    k.rod(color(k, "beacon", {0.8f, 0.3f, 0.02f}, 0.15f), {0, 2.09f, -0.6f}, {0, 2.2f, -0.6f}, 0.05f, 0.04f, 12);
    k.piece.clearance_front_m = 0.5f;
}

// Two rails that end in grips, a blade at the foot, two wheels.
void build_hand_truck(Kit& k) {
    const int frame = k.main(plain("enamel", {0.45f, 0.04f, 0.03f}, 0.35f)), metal = k.material(steel()),
              grip = color(k, "grip", {0.03f, 0.03f, 0.032f}, 0.7f),
              tire = color(k, "tire", {0.025f, 0.025f, 0.026f}, 0.85f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = 0.2f * sx;
        const std::array<Vec3f, 4> rail{
            Vec3f{x, 0.02f, 0.02f}, {x, 1.08f, 0.02f}, {x, 1.18f, -0.03f}, {x, 1.22f, -0.14f}};
        k.add(shapes::tube(rail, 0.017f, 10), frame),
            k.rod(grip, {x, 1.215f, -0.12f}, {x, 1.235f, -0.25f}, 0.021f, -1, 10);
        cargo_wheel(k, tire, metal, {sx * 0.27f, 0.13f, -0.1f}, 0.13f, 0.06f);
        strut(k, frame, {x, 0.12f, -0.1f}, {x, 0.42f, 0.01f}, 0.02f, 0.03f),
            strut(k, frame, {x, 0.03f, 0.01f}, {x, 0.13f, -0.1f}, 0.02f, 0.03f);
    }
    for (const float y : {0.16f, 0.44f, 0.72f, 1.0f}) {
        const std::array<Vec3f, 3> bar{Vec3f{-0.2f, y, 0.02f}, {0, y, -0.03f}, {0.2f, y, 0.02f}};
        k.add(shapes::tube(bar, 0.012f, 8), frame);
    }
    k.rod(frame, {0, 0.1f, -0.025f}, {0, 1.0f, -0.03f}, 0.011f, -1, 8),
        k.rod(metal, {-0.27f, 0.13f, -0.1f}, {0.27f, 0.13f, -0.1f}, 0.01f, -1, 8);
    k.board(metal, {0, 0.004f, 0.15f}, {0.46f, 0.008f, 0.26f}, 0.002f),
        k.board(metal, {0, 0.004f, 0.02f}, {0.46f, 0.1f, 0.008f}, 0.002f);
}

// Boards on nine blocks, as all of Europe has them.
void build_pallet(Kit& k) {
    const int wood = k.main(materials::timber("natural", 0.85f));
    for (int i = 0; i < 5; ++i)
        k.board(wood, {0, 0.122f, -0.34f + 0.17f * static_cast<float>(i)}, {1.2f, 0.022f, i % 2 ? 0.1f : 0.125f},
                0.003f);
    for (const float x : {-0.53f, 0.f, 0.53f}) {
        block(k, wood, {x, 0.1f, 0}, {0.145f, 0.022f, 0.8f});
        for (const float z : {-0.34f, 0.f, 0.34f}) k.board(wood, {x, 0.022f, z}, {0.145f, 0.078f, 0.11f}, 0.003f);
    }
    for (const float z : {-0.34f, 0.f, 0.34f}) k.board(wood, {0, 0, z}, {1.2f, 0.022f, 0.11f}, 0.003f);
    k.top(0.144f, 0, 0, 0.5f, 0.32f);
}

// Of slats and open, or with a lid and braces.
void build_crate(Kit& k) {
    const int wood = k.main(materials::timber(k.rng.chance(0.5f) ? "natural" : "oak", 0.85f)),
              nail = color(k, "nail", {0.16f, 0.15f, 0.14f}, 0.5f),
              inner = color(k, "inside of a crate", {0.1f, 0.06f, 0.03f}, 0.95f);
    const bool closed = k.rng.chance(0.5f);
    const Vec3f s = k.wanted(closed ? Vec3f{0.6f, 0.55f, 0.5f} : Vec3f{0.5f, 0.3f, 0.36f});
    const float t = 0.018f;
    const int rows = closed ? 4 : 3;
    const float pitch = s.y / static_cast<float>(rows), high = closed ? pitch - 0.003f : 0.72f * pitch;
    if (closed) block(k, inner, {0, 0.02f, 0}, {s.x - 2.2f * t, s.y - 0.04f, s.z - 2.2f * t});
    for (int i = 0; i < rows; ++i) {
        const float y = pitch * static_cast<float>(i);
        for (const float side : {-1.f, 1.f})
            k.board(wood, {0, y, side * (0.5f * s.z - 1.5f * t)}, {s.x - 2 * t, high, t}, 0.003f),
                k.board(wood, {side * (0.5f * s.x - 1.5f * t), y, 0}, {t, high, s.z - 4 * t}, 0.003f);
    }
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            const Vec3f at{sx * (0.5f * s.x - 0.05f), 0, sz * (0.5f * s.z - 0.5f * t)};
            if (closed)
                k.board(wood, at, {0.07f, s.y, t}, 0.003f),
                    k.board(wood, {sx * (0.5f * s.x - 0.5f * t), 0, sz * (0.5f * s.z - 0.05f)}, {t, s.y, 0.07f},
                            0.003f);
            else
                k.board(wood, {sx * (0.5f * s.x - 2 * t - 0.015f), 0, sz * (0.5f * s.z - 2 * t - 0.015f)},
                        {0.03f, s.y - 0.01f, 0.03f}, 0.003f);
            for (int i = 0; i < rows; ++i)
                for (const float dy : {0.25f, 0.6f})
                    block(k, nail, {at.x, pitch * (static_cast<float>(i) + dy), sz * (0.5f * s.z - (closed ? 0.f : t))},
                          {0.007f, 0.007f, 0.004f});
        }
    if (!closed) {
        for (int i = 0; i < 4; ++i)
            block(k, wood, {0, 0, s.z * (static_cast<float>(i) - 1.5f) / 4.3f}, {s.x - 4 * t, 0.012f, s.z / 5});
        return;
    }
    for (const float side : {-1.f, 1.f})
        slat(k, wood, {-0.5f * s.x + 0.08f, 0.06f, side * (0.5f * s.z - 0.5f * t)},
             {0.5f * s.x - 0.08f, s.y - 0.06f, side * (0.5f * s.z - 0.5f * t)}, 0.07f, t * 0.9f);
    for (int i = 0; i < 4; ++i)
        k.board(wood, {0, s.y, s.z * (static_cast<float>(i) - 1.5f) / 4}, {s.x, t, s.z / 4 - 0.003f}, 0.003f);
    k.top(s.y + t, 0, 0, 0.4f * s.x, 0.4f * s.z);
}

// Of sheet steel, with two ribs; now and then with a band of another color.
void build_oil_drum(Kit& k) {
    static constexpr std::array<Vec3f, 4> kPaints{
        Vec3f{0.03f, 0.1f, 0.3f}, {0.4f, 0.04f, 0.03f}, {0.06f, 0.16f, 0.09f}, {0.04f, 0.042f, 0.045f}};
    const int body = k.main(plain("drum paint", kPaints[static_cast<std::size_t>(k.rng.index(4))], 0.4f)),
              metal = k.material(steel()), band = color(k, "band", {0.62f, 0.58f, 0.48f}, 0.5f);
    const float r = 0.286f;
    std::vector<Vec2f> side{{r, 0}, {r + 0.008f, 0.004f}, {r + 0.008f, 0.018f}, {r, 0.024f}};
    for (const float y : {0.29f, 0.58f})
        side.insert(side.end(), {{r, y - 0.016f}, {r + 0.011f, y - 0.006f}, {r + 0.011f, y + 0.006f}, {r, y + 0.016f}});
    side.insert(side.end(),
                {{r, 0.85f}, {r + 0.008f, 0.858f}, {r + 0.008f, 0.878f}, {r - 0.006f, 0.88f}, {r - 0.01f, 0.866f}});
    k.add(shapes::lathe(side, 32), body);
    if (k.rng.chance(0.6f)) {
        const std::array<Vec2f, 2> ring{Vec2f{r + 0.0012f, 0.34f}, {r + 0.0012f, 0.53f}};
        k.add(shapes::lathe(ring, 32), band);
    }
    k.rod(metal, {0.17f, 0.864f, 0.08f}, {0.17f, 0.882f, 0.08f}, 0.035f, -1, 12),
        k.rod(metal, {-0.19f, 0.864f, -0.06f}, {-0.19f, 0.88f, -0.06f}, 0.018f, -1, 10);
    k.top(0.867f, 0, 0, 0.16f, 0.16f);
}

// Flour, grain or coffee: upright, its seam above, a stamp in front.
void build_sack(Kit& k) {
    const int cloth = cargo_cloth(k, k.rng.chance(0.5f) ? Vec3f{0.5f, 0.42f, 0.3f} : Vec3f{0.36f, 0.25f, 0.13f}),
              stamp = color(k, "stamp", k.rng.chance(0.5f) ? Vec3f{0.04f, 0.08f, 0.2f} : Vec3f{0.3f, 0.05f, 0.03f},
                            0.9f),
              string = color(k, "string", {0.5f, 0.4f, 0.24f}, 0.9f);
    Soft how;
    how.round_m = 0.1f, how.puff_m = 0.06f, how.wrinkle_m = 0.006f, how.steps = 6;
    k.soft(cloth, {0, 0, 0}, {0.46f, 0.62f, 0.27f}, how);
    k.add_soft(shapes::pillow({0.36f, 0.16f, 0.07f}, k.seed(), 6), cloth, kPillowCrease, {0, 0.57f, 0});
    k.rod(string, {-0.17f, 0.655f, 0.0f}, {0.17f, 0.655f, 0.0f}, 0.012f, -1, 8);
    Mesh mark = hoop(0.085f, 0.012f, 22);
    shapes::turn(mark, {1, 0, 0}, 90);
    k.add(std::move(mark), stamp, {0, 0.32f, 0.134f});
    Mesh inner = hoop(0.052f, 0.009f, 18);
    shapes::turn(inner, {1, 0, 0}, 90);
    k.add(std::move(inner), stamp, {0, 0.32f, 0.136f});
}

// A pedal bin of steel or of a color, its lid hinged behind.
void build_trash(Kit& k) {
    const int body = k.main(k.rng.chance(0.6f) ? steel() : plain("enamel", {0.05f, 0.052f, 0.055f}, 0.35f)),
              dark = color(k, "black plastic", {0.03f, 0.03f, 0.032f}, 0.5f);
    const std::array<Vec2f, 3> foot{Vec2f{0.15f, 0}, {0.153f, 0.03f}, {0.15f, 0.04f}},
        side{Vec2f{0.148f, 0.04f}, {0.15f, 0.05f}, {0.15f, 0.55f}},
        rim{Vec2f{0.155f, 0.55f}, {0.158f, 0.555f}, {0.158f, 0.575f}};
    k.add(shapes::lathe(foot, 28), dark), k.add(shapes::lathe(side, 28), body), k.add(shapes::lathe(rim, 28), dark);
    const std::array<Vec2f, 5> lid{
        Vec2f{0.153f, 0.575f}, {0.15f, 0.595f}, {0.12f, 0.622f}, {0.06f, 0.64f}, {0, 0.645f}};
    k.add(shapes::lathe(lid, 28, true), body);
    k.board(dark, {0, 0.54f, -0.16f}, {0.09f, 0.06f, 0.03f}, 0.006f),
        k.board(dark, {0, 0.008f, 0.175f}, {0.09f, 0.014f, 0.08f}, 0.004f);
}

// Three bins with slots, a color for each sort.
void build_recycling_bins(Kit& k) {
    static constexpr std::array<Vec3f, 3> kSorts{
        Vec3f{0.03f, 0.12f, 0.42f}, {0.62f, 0.42f, 0.03f}, {0.05f, 0.28f, 0.09f}};
    const int body = k.main(plain("bin", {0.42f, 0.43f, 0.43f}, 0.45f)),
              slot = color(k, "slot", {0.012f, 0.012f, 0.013f}, 0.8f),
              white = color(k, "mark", {0.75f, 0.74f, 0.7f}, 0.5f);
    for (int i = 0; i < 3; ++i) {
        const float x = 0.41f * static_cast<float>(i - 1);
        const int paint = color(k, "sort", kSorts[static_cast<std::size_t>(i)], 0.4f);
        k.board(body, {x, 0, 0}, {0.39f, 0.74f, 0.36f}, 0.02f);
        const std::array<Vec2f, 4> hood{Vec2f{-0.18f, 0.74f}, {0.18f, 0.74f}, {0.18f, 0.8f}, {-0.18f, 0.96f}};
        k.add(side_prism(hood, x - 0.195f, x + 0.195f, 0.012f), paint);
        Mesh hole = i == 1 ? shapes::ball({0, 0, 0}, {0.085f, 0.085f, 0.006f}, 18)
                           : shapes::box({0.26f, 0.05f + 0.06f * static_cast<float>(i), 0.012f}, 0.003f);
        shapes::turn(hole, {1, 0, 0}, -66);
        k.add(std::move(hole), slot, {x, 0.886f, 0.005f});
        block(k, paint, {x, 0.3f, 0.18f}, {0.2f, 0.24f, 0.006f});
        for (int a = 0; a < 3; ++a) {  // three arrows about a middle
            const float t = kTau * static_cast<float>(a) / 3.f + 0.5f * kPi;
            slat(k, white, Vec3f{x + 0.06f * std::cos(t), 0.42f + 0.06f * std::sin(t), 0.186f},
                 Vec3f{x + 0.06f * std::cos(t + 1.5f), 0.42f + 0.06f * std::sin(t + 1.5f), 0.186f}, 0.022f, 0.004f);
        }
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// A basket of wire on castors, with a rail for hangers and some washing.
void build_laundry_cart(Kit& k) {
    const int steel_wire = k.main(steel()), tire = color(k, "castor", {0.03f, 0.03f, 0.032f}, 0.7f),
              cloth = k.material(tinted(k.style.fabric, {0.7f, 0.69f, 0.66f})),
              towel = k.material(tinted(k.style.fabric, k.accent()));
    const float hx = 0.36f, hz = 0.24f, y0 = 0.36f, y1 = 0.74f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            k.rod(steel_wire, {sx * hx, 0.1f, sz * hz}, {sx * hx, y1, sz * hz}, 0.013f, -1, 8);
            k.rod(tire, {sx * hx - 0.015f, 0.05f, sz * hz}, {sx * hx + 0.015f, 0.05f, sz * hz}, 0.05f, -1, 12);
        }
    for (const float y : {0.14f, y0, 0.5f, y1})
        for (const float s : {-1.f, 1.f})
            wire(k, steel_wire, {-hx, y, s * hz}, {hx, y, s * hz}, 0.008f),
                wire(k, steel_wire, {s * hx, y, -hz}, {s * hx, y, hz}, 0.008f);
    for (int i = 1; i < 12; ++i) {
        const float x = hx * (static_cast<float>(i) / 6.f - 1);
        for (const float s : {-1.f, 1.f}) wire(k, steel_wire, {x, y0, s * hz}, {x, y1, s * hz}, 0.003f);
        wire(k, steel_wire, {x, y0, -hz}, {x, y0, hz}, 0.003f);
    }
    for (int i = 1; i < 8; ++i)
        for (const float s : {-1.f, 1.f})
            wire(k, steel_wire, {s * hx, y0, hz * (static_cast<float>(i) / 4.f - 1)},
                 {s * hx, y1, hz * (static_cast<float>(i) / 4.f - 1)}, 0.003f);
    for (const float sx : {-1.f, 1.f}) k.rod(steel_wire, {sx * hx, y1, 0}, {sx * hx, 1.65f, 0}, 0.012f, -1, 8);
    k.rod(steel_wire, {-hx - 0.05f, 1.65f, 0}, {hx + 0.05f, 1.65f, 0}, 0.014f, -1, 8);
    for (int i = 0; i < 4; ++i) {
        Soft how;
        how.round_m = 0.06f, how.puff_m = 0.03f, how.wrinkle_m = 0.012f, how.steps = 2;
        k.soft(i % 2 ? towel : cloth,
               {-0.17f + 0.34f * static_cast<float>(i % 2), y0 + 0.01f + 0.14f * static_cast<float>(i / 2),
                k.rng.uniform(-0.04f, 0.04f)},
               {0.35f, 0.2f, 0.38f}, how);
    }
}

}  // namespace fastscene::furniture
