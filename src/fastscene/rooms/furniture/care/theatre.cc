// Of operating rooms, dentists and wards: lights, X-rays, instruments, curtains.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

namespace {

int clinic_white(Kit& k) { return k.main(plain("clinic white", {0.74f, 0.75f, 0.75f}, 0.35f)); }

void castors(Kit& k, int dark, float half_x, float half_z, float r = 0.04f) {
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(dark, {sx * half_x - 0.012f, r, sz * half_z}, {sx * half_x + 0.012f, r, sz * half_z}, r, -1, 12);
}

}  // namespace

// An arm of two parts on the wall; its head with the cone that is laid to one's cheek.
void build_xray_arm(Kit& k) {
    const int body = clinic_white(k), gray = color(k, "joint", {0.3f, 0.32f, 0.34f}, 0.4f),
              dark = color(k, "label", {0.03f, 0.03f, 0.033f}, 0.5f);
    k.board(body, {-0.3f, 0.3f, 0.04f}, {0.2f, 0.36f, 0.08f}, 0.02f),
        block(k, dark, {-0.3f, 0.5f, 0.081f}, {0.12f, 0.08f, 0.002f});
    for (int i = 0; i < 4; ++i)
        block(k, gray, {-0.345f + 0.03f * static_cast<float>(i), 0.42f, 0.08f}, {0.02f, 0.02f, 0.004f});
    const Vec3f root{-0.3f, 0.72f, 0.1f}, knee{0.3f, 0.74f, 0.16f}, elbow{-0.04f, 0.98f, 0.36f},
        wrist{0.3f, 0.44f, 0.5f};
    k.board(body, {-0.3f, 0.66f, 0.05f}, {0.12f, 0.12f, 0.1f}, 0.02f), k.rod(body, root, knee, 0.035f, -1, 14),
        k.rod(gray, knee - Vec3f{0, 0.06f, 0}, knee + Vec3f{0, 0.07f, 0}, 0.042f, -1, 14);
    k.rod(body, knee + Vec3f{0, 0.05f, 0}, elbow, 0.03f, -1, 12),
        k.add(shapes::ball(elbow, {0.045f, 0.045f, 0.045f}, 12), gray),
        k.rod(body, elbow, wrist + Vec3f{0, 0.1f, 0}, 0.027f, -1, 12);
    k.rod(gray, wrist, wrist + Vec3f{0, 0.13f, 0}, 0.02f, -1, 10);
    k.rod(body, wrist + Vec3f{-0.13f, 0, 0}, wrist + Vec3f{0.13f, 0, 0}, 0.075f, -1, 20),
        k.rod(gray, wrist + Vec3f{0, -0.02f, 0.06f}, wrist + Vec3f{0, -0.05f, 0.12f}, 0.05f, 0.042f, 18);
    k.rod(body, wrist + Vec3f{0, -0.05f, 0.12f}, wrist + Vec3f{0, -0.14f, 0.32f}, 0.034f, -1, 18);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.95f;
}

// A lit pane on which films of bones hang.
void build_xray_viewer(Kit& k) {
    const Vec3f s = k.wanted({0.86f, 0.56f, 0.09f});
    const int frame = k.main(plain("lacquered steel", {0.5f, 0.52f, 0.53f}, 0.35f)),
              pane = lit(k, "light box", {1.5f, 1.65f, 1.8f}), film = color(k, "film", {0.012f, 0.018f, 0.03f}, 0.25f),
              bone = lit(k, "bone", {0.5f, 0.62f, 0.75f}), flesh = lit(k, "soft tissue", {0.05f, 0.075f, 0.11f}),
              dark = color(k, "clip", {0.03f, 0.03f, 0.033f}, 0.5f);
    k.board(frame, {0, 0, 0.5f * s.z - 0.005f}, {s.x, s.y, s.z - 0.01f}, 0.012f),
        block(k, pane, {0, 0.05f, s.z - 0.01f}, {s.x - 0.06f, s.y - 0.1f, 0.006f}),
        block(k, dark, {0, s.y - 0.06f, s.z - 0.005f}, {s.x - 0.06f, 0.022f, 0.014f});
    block(k, dark, {0.44f * s.x, 0.015f, s.z - 0.008f}, {0.03f, 0.018f, 0.01f});
    const float h = s.y - 0.15f, w = 0.36f * s.x, y0 = 0.075f, z = s.z - 0.004f;
    // A chest on the left: ribs to both sides of a spine.
    const float cl = -0.23f * s.x;
    block(k, film, {cl, y0, z}, {w, h, 0.002f}),
        k.add(shapes::ball({}, {0.4f * w, 0.42f * h, 0.0014f}, 16), flesh, {cl, y0 + 0.5f * h, z + 0.0015f});
    for (int i = 0; i < 9; ++i)
        block(k, bone, {cl, y0 + h * (0.1f + 0.088f * static_cast<float>(i)), z + 0.0035f},
              {0.028f, 0.06f * h, 0.002f});
    for (int i = 0; i < 6; ++i)
        for (const float sx : {-1.f, 1.f}) {
            std::vector<Vec3f> rib;
            for (int j = 0; j <= 5; ++j) {
                const float t = static_cast<float>(j) / 5;
                rib.push_back(
                    {cl + sx * (0.012f + 0.34f * w * std::sin(0.5f * kPi * t) *
                                             (0.75f + 0.25f * std::sin(0.5f * static_cast<float>(i + 1)))),
                     y0 + h * (0.28f + 0.1f * static_cast<float>(i) + 0.03f * std::sin(kPi * t) - 0.09f * t * t),
                     z + 0.004f});
            }
            k.add(shapes::tube(rib, 0.0032f, 4), bone);
        }
    // A hand on the right.
    const float cr = 0.23f * s.x;
    block(k, film, {cr, y0, z}, {w, h, 0.002f}),
        k.add(shapes::ball({}, {0.24f * w, 0.26f * h, 0.0014f}, 14), flesh, {cr, y0 + 0.32f * h, z + 0.0015f});
    for (int f = 0; f < 5; ++f) {
        const float a = f == 0 ? -0.95f : -0.3f + 0.2f * static_cast<float>(f - 1), reach = (f == 0   ? 0.36f
                                                                                             : f == 4 ? 0.5f
                                                                                                      : 0.6f) *
                                                                                            h;
        float from = 0.12f;
        for (const float part : {0.34f, 0.25f, 0.16f}) {
            const Vec3f o{cr, y0 + 0.22f * h, z + 0.004f}, d{std::sin(a), std::cos(a), 0};
            k.rod(bone, o + d * (from * reach), o + d * ((from + part - 0.03f) * reach), 0.0055f, 0.0045f, 5),
                from += part + 0.02f;
        }
    }
    for (const float sx : {-1.f, 1.f})
        block(k, bone, {cr + sx * 0.014f, y0 + 0.03f, z + 0.003f}, {0.014f, 0.15f * h, 0.002f});
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.3f;
}

// A cart with gauges, vaporizers, bellows, a screen and hoses.
void build_anesthesia_machine(Kit& k) {
    const int body = clinic_white(k), gray = color(k, "device gray", {0.3f, 0.33f, 0.36f}, 0.4f),
              dark = color(k, "bezel", {0.03f, 0.03f, 0.033f}, 0.4f), metal = k.material(steel()),
              green = lit(k, "trace", {0.2f, 2.2f, 0.5f}), amber = lit(k, "pressure trace", {2.2f, 1.3f, 0.2f}),
              purple = color(k, "vaporizer", {0.32f, 0.08f, 0.42f}, 0.4f),
              yellow = color(k, "vaporizer yellow", {0.75f, 0.55f, 0.04f}, 0.4f),
              hose = color(k, "hose", {0.35f, 0.5f, 0.58f}, 0.5f),
              bag = color(k, "breathing bag", {0.05f, 0.16f, 0.14f}, 0.6f);
    castors(k, dark, 0.28f, 0.26f, 0.05f);
    k.board(gray, {0, 0.08f, 0}, {0.68f, 0.08f, 0.64f}, 0.02f),
        k.board(body, {0, 0.16f, -0.06f}, {0.6f, 0.66f, 0.48f}, 0.015f);
    for (int i = 0; i < 3; ++i)
        k.board(body, {0, 0.19f + 0.2f * static_cast<float>(i), 0.185f}, {0.54f, 0.18f, 0.02f}, 0.006f),
            k.board(metal, {0, 0.3f + 0.2f * static_cast<float>(i), 0.2f}, {0.22f, 0.016f, 0.016f}, 0.005f);
    k.board(metal, {0, 0.82f, 0.02f}, {0.66f, 0.03f, 0.62f}, 0.008f),
        k.board(body, {0, 0.85f, -0.2f}, {0.62f, 0.5f, 0.2f}, 0.015f);
    // Gauges, flow tubes, vaporizers.
    for (int i = 0; i < 3; ++i)
        k.rod(body, {-0.24f + 0.09f * static_cast<float>(i), 1.26f, -0.1f},
              {-0.24f + 0.09f * static_cast<float>(i), 1.26f, -0.085f}, 0.036f, -1, 14),
            block(k, dark, {-0.24f + 0.09f * static_cast<float>(i), 1.25f, -0.083f}, {0.006f, 0.03f, 0.003f});
    block(k, dark, {-0.15f, 0.96f, -0.1f}, {0.24f, 0.22f, 0.01f});
    for (int i = 0; i < 4; ++i)
        k.rod(i % 2 ? green : metal, {-0.23f + 0.05f * static_cast<float>(i), 0.98f, -0.088f},
              {-0.23f + 0.05f * static_cast<float>(i), 1.16f, -0.088f}, 0.007f, -1, 6),
            k.rod(gray, {-0.23f + 0.05f * static_cast<float>(i), 0.925f, -0.1f},
                  {-0.23f + 0.05f * static_cast<float>(i), 0.925f, -0.065f}, 0.017f, -1, 10);
    for (int i = 0; i < 2; ++i) {
        const float x = 0.1f + 0.14f * static_cast<float>(i);
        k.board(gray, {x, 0.95f, -0.05f}, {0.11f, 0.16f, 0.1f}, 0.012f),
            k.rod(i ? yellow : purple, {x, 1.11f, -0.05f}, {x, 1.17f, -0.05f}, 0.05f, 0.045f, 18);
    }
    // The bellows in its glass, the bag and two corrugated hoses.
    const int clear = k.material(glass());
    k.rod(gray, {-0.2f, 0.85f, 0.14f}, {-0.2f, 0.88f, 0.14f}, 0.08f, -1, 18);
    for (int i = 0; i < 5; ++i)
        k.add(shapes::ring(0.05f, 0.01f, 14), dark, {-0.2f, 0.892f + 0.018f * static_cast<float>(i), 0.14f});
    const std::array<Vec2f, 3> dome{Vec2f{0.072f, 0}, {0.072f, 0.18f}, {0.03f, 0.22f}};
    k.add(shapes::shade(dome, 18), clear, {-0.2f, 0.88f, 0.14f});
    for (int h = 0; h < 2; ++h) {
        std::vector<Vec3f> path;
        for (int i = 0; i <= 14; ++i) {
            const float t = static_cast<float>(i) / 14;
            path.push_back({0.05f + 0.07f * static_cast<float>(h) + 0.32f * t * (1 - t),
                            0.87f - 0.34f * std::sin(kPi * t) + 0.1f * t, 0.2f + 0.22f * std::sin(kPi * t)});
        }
        k.add(shapes::tube(path, 0.016f, 8), hose);
    }
    k.add(shapes::ball({0.24f, 0.68f, 0.3f}, {0.05f, 0.1f, 0.05f}, 12), bag),
        k.rod(metal, {0.24f, 0.77f, 0.3f}, {0.24f, 0.84f, 0.28f}, 0.014f, -1, 8);
    k.rod(metal, {0.2f, 1.34f, -0.2f}, {0.2f, 1.46f, -0.2f}, 0.02f, -1, 10),
        k.board(body, {0.1f, 1.36f, -0.16f}, {0.44f, 0.32f, 0.05f}, 0.012f),
        block(k, dark, {0.1f, 1.38f, -0.1345f}, {0.4f, 0.28f, 0.003f});
    for (int t = 0; t < 3; ++t)
        for (int i = 0; i < 14; ++i)
            block(k, t % 2 ? amber : green,
                  {-0.07f + 0.026f * static_cast<float>(i), 1.42f + 0.08f * static_cast<float>(t), -0.1325f},
                  {0.024f, i % 5 == 2 ? 0.04f : 0.005f, 0.002f});
    for (int i = 0; i < 2; ++i)
        k.rod(i ? body : hose, {-0.16f + 0.2f * static_cast<float>(i), 0.2f, -0.37f},
              {-0.16f + 0.2f * static_cast<float>(i), 0.85f, -0.37f}, 0.06f, 0.055f, 14);
    k.piece.clearance_front_m = 0.5f;
}

// A tray on one arm with a green cloth and instruments laid out in a row.
void build_instrument_tray(Kit& k) {
    const int metal = k.material(steel()), dark = color(k, "wheel", {0.03f, 0.03f, 0.03f}, 0.6f),
              cloth = k.main(plain("surgical drape", {0.06f, 0.32f, 0.3f}, 0.9f)),
              dish = color(k, "gauze", {0.8f, 0.8f, 0.78f}, 0.9f);
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * 0.24f, 0.06f, -0.2f}, {sx * 0.24f, 0.06f, 0.2f}, 0.014f, -1, 8);
    k.rod(metal, {-0.24f, 0.06f, -0.2f}, {0.24f, 0.06f, -0.2f}, 0.014f, -1, 8), castors(k, dark, 0.24f, 0.2f, 0.03f);
    k.rod(metal, {-0.24f, 0.06f, -0.2f}, {-0.24f, 0.86f, -0.2f}, 0.016f, -1, 10),
        k.rod(metal, {-0.24f, 0.86f, -0.2f}, {0.22f, 0.9f, -0.16f}, 0.012f, -1, 8),
        k.rod(metal, {-0.24f, 0.86f, -0.2f}, {-0.22f, 0.9f, 0.16f}, 0.012f, -1, 8);
    const float y = 0.91f;
    block(k, metal, {0, y - 0.01f, 0}, {0.56f, 0.008f, 0.4f}),
        block(k, cloth, {0, y - 0.002f, 0}, {0.54f, 0.005f, 0.38f}),
        block(k, cloth, {0.06f, y - 0.16f, 0.203f}, {0.36f, 0.165f, 0.004f});
    for (const float s : {-1.f, 1.f})
        block(k, metal, {s * 0.28f, y - 0.01f, 0}, {0.008f, 0.022f, 0.4f}),
            block(k, metal, {0, y - 0.01f, s * 0.2f}, {0.56f, 0.022f, 0.008f});
    // Scalpels, scissors, clamps.
    for (int i = 0; i < 8; ++i) {
        const float x = -0.22f + 0.04f * static_cast<float>(i), h = y + 0.008f;
        if (i < 3)
            k.rod(metal, {x, h, 0.1f}, {x, h, -0.02f}, 0.006f, 0.0045f, 6),
                block(k, metal, {x, h - 0.002f, -0.045f}, {0.01f, 0.002f, 0.05f});
        else {
            for (const float sx : {-1.f, 1.f}) {
                k.rod(metal, {x + sx * 0.011f, h, 0.085f}, {x - sx * 0.003f, h, -0.06f}, 0.0035f, 0.0025f, 6);
                k.add(shapes::ring(0.011f, 0.0026f, 12), metal, {x + sx * 0.012f, h, 0.098f});
            }
        }
    }
    const std::array<Vec2f, 4> bowl_form{Vec2f{0.03f, 0}, {0.05f, 0.008f}, {0.062f, 0.035f}, {0.066f, 0.036f}};
    k.add(shapes::vessel(bowl_form, 0.003f, 20), metal, {0.18f, y + 0.003f, -0.09f}),
        block(k, dish, {0.18f, y + 0.012f, -0.09f}, {0.06f, 0.018f, 0.05f}),
        block(k, dish, {0.18f, y + 0.003f, 0.08f}, {0.1f, 0.024f, 0.1f});
    k.piece.clearance_front_m = 0.3f;
}

// Two round heads on arms that turn about one column in the ceiling.
void build_surgical_light(Kit& k) {
    const int body = clinic_white(k), gray = color(k, "joint", {0.3f, 0.32f, 0.34f}, 0.4f),
              lamp = k.material(glow("operating light", {9, 9, 8.6f}));
    k.add(shapes::prism(shapes::circle(0.18f, 28), -0.06f, 0, 0.012f), body),
        k.rod(body, {0, -0.3f, 0}, {0, -0.04f, 0}, 0.045f, -1, 16);
    const auto head = [&](float level, float a, float reach, float r) {
        const Vec3f out = around(a) * reach, side = around(a + 0.5f * kPi), hub{0, level, 0}, end = hub + out,
                    mid = end + Vec3f{0, -0.42f, 0};
        k.rod(gray, hub - Vec3f{0, 0.045f, 0}, hub + Vec3f{0, 0.045f, 0}, 0.062f, -1, 16),
            k.rod(body, hub, end, 0.032f, -1, 12),
            k.rod(gray, end + Vec3f{0, 0.05f, 0}, end - Vec3f{0, 0.06f, 0}, 0.045f, -1, 14);
        k.rod(body, end, mid + Vec3f{0, 0.2f, 0}, 0.022f, -1, 10);
        std::vector<Vec3f> bow;
        for (int i = 0; i <= 10; ++i) {
            const float t = kPi * static_cast<float>(i) / 10;
            bow.push_back(mid + side * ((r + 0.03f) * std::cos(t)) + Vec3f{0, 0.2f * std::sin(t), 0});
        }
        k.add(shapes::tube(bow, 0.016f, 8), body);
        const std::array<Vec2f, 5> dish{
            Vec2f{r, -0.03f}, {r, 0.01f}, {0.8f * r, 0.06f}, {0.4f * r, 0.09f}, {0.f, 0.095f}};
        Mesh shell = shapes::lathe(dish, 28, true);
        const float lean = 12.f;
        const auto lay = [&](Mesh m, int material) { shapes::turn(m, side, lean), k.add(std::move(m), material, mid); };
        lay(std::move(shell), body);
        for (int i = 0; i < 7; ++i) {
            Mesh bulb = shapes::prism(shapes::circle(0.24f * r, 14), -0.042f, -0.028f, 0.002f);
            if (i < 6) shapes::move(bulb, around(kTau * static_cast<float>(i) / 6) * (0.62f * r));
            lay(std::move(bulb), lamp);
        }
        lay(shapes::rod({0, -0.13f, 0}, {0, -0.03f, 0}, 0.018f, 0.022f, 10), gray);
    };
    head(-0.2f, 2.6f, 0.62f, 0.34f), head(-0.3f, 0.15f, 0.5f, 0.26f);
    k.piece.mount = Mount::ceiling;
}

// A curtain on a rail that bends about where a bed stands.
void build_hospital_curtain(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 2.25f, 1.0f});
    const Vec3f tones[4] = {{0.3f, 0.5f, 0.52f}, {0.35f, 0.46f, 0.62f}, {0.5f, 0.56f, 0.42f}, {0.6f, 0.55f, 0.45f}};
    const int cloth = k.main(plain("curtain cloth", tones[k.rng.index(4)], 0.9f)), metal = k.material(steel()),
              net = color(k, "curtain net", {0.7f, 0.72f, 0.72f}, 0.9f);
    // The rail: along x, a quarter of a circle, along z.
    const float r = std::min(0.35f, 0.4f * s.z), ax = s.x - r, az = s.z - r, arc = 0.5f * kPi * r, all = ax + arc + az;
    const auto rail = [&](float t, float off) {
        const float l = t * all;
        if (l < ax) return Vec3f{-0.5f * s.x + l, 0, 0.5f * s.z + off};
        if (l < ax + arc) {
            const float a = (l - ax) / r;
            return Vec3f{0.5f * s.x - r + (r + off) * std::sin(a), 0, 0.5f * s.z - r + (r + off) * std::cos(a)};
        }
        return Vec3f{0.5f * s.x + off, 0, 0.5f * s.z - r - (l - ax - arc)};
    };
    std::vector<Vec3f> path;
    for (int i = 0; i <= 24; ++i) path.push_back(rail(static_cast<float>(i) / 24, 0) + Vec3f{0, s.y - 0.02f, 0});
    k.add(shapes::tube(path, 0.016f, 8), metal);
    const float drawn = k.rng.uniform(0.72f, 0.92f);
    const auto hung = [&](int material, float y0, float y1, int rows) {
        k.add(shapes::sheet(110, rows,
                            [&](float u, float v) {
                                const float fold = 0.03f * std::sin(kTau * 17 * u) * (0.6f + 0.4f * v) +
                                                   0.008f * std::sin(kTau * 5.3f * u);
                                return rail(u * drawn, fold) + Vec3f{0, y1 + (y0 - y1) * v, 0};
                            }),
              material);
    };
    hung(net, s.y - 0.42f, s.y - 0.05f, 1), hung(cloth, 0.28f, s.y - 0.42f, 4);
    for (int i = 0; i <= 12; ++i)
        block(k, metal, rail(drawn * static_cast<float>(i) / 12, 0) + Vec3f{0, s.y - 0.06f, 0},
              {0.012f, 0.04f, 0.012f});
    // Hangers up to the ceiling, a post where the rail ends in a room without one.
    for (const float t : {0.01f, 0.99f})
        k.rod(metal, rail(t, 0), rail(t, 0) + Vec3f{0, s.y, 0}, 0.014f, -1, 8),
            k.add(shapes::prism(shapes::circle(0.09f, 16), 0, 0.015f, 0.004f), metal, rail(t, 0));
    k.piece.clearance_front_m = 0.3f;
}

}  // namespace fastscene::furniture
