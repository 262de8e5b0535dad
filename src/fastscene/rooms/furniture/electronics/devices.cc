// Fans, air conditioners, heaters, loudspeakers, radios, headphones, cameras that watch.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// Three blades in a cage on a stand.
void build_fan(Kit& k) {
    const int body = k.main(
                  plain("fan", k.rng.chance(0.5f) ? Vec3f{0.72f, 0.72f, 0.71f} : Vec3f{0.04f, 0.04f, 0.043f}, 0.35f)),
              metal = k.material(steel());
    const float y = 1.08f;
    k.add(shapes::prism(shapes::circle(0.2f, 28), 0, 0.03f, 0.01f), body),
        k.rod(body, {0, 0.02f, 0}, {0, 0.62f, 0}, 0.02f, -1, 10),
        k.rod(metal, {0, 0.6f, 0}, {0, y - 0.05f, 0}, 0.013f, -1, 8);
    k.board(body, {0, y - 0.09f, -0.04f}, {0.09f, 0.17f, 0.1f}, 0.03f),
        k.rod(body, {0, y, -0.16f}, {0, y, 0.02f}, 0.055f, 0.06f, 16);
    for (int i = 0; i < 3; ++i) {
        Mesh blade = shapes::slab(6, 4, 0.004f, [](float u, float v) {
            const float r = 0.03f + 0.16f * v,
                        across = (u - 0.5f) * (0.07f + 0.11f * std::sin(kPi * std::min(1.f, 0.15f + 0.75f * v)));
            return Vec3f{across, r, 0.25f * across};
        });
        shapes::turn(blade, {0, 0, 1}, 120.f * static_cast<float>(i) + 17.f),
            k.add(std::move(blade), body, {0, y, 0.06f});
    }
    for (const auto& [r, z] : {std::pair{0.22f, 0.06f}, {0.17f, 0.112f}, {0.11f, 0.127f}, {0.17f, 0.012f}}) {
        Mesh hoop = shapes::ring(r, r > 0.2f ? 0.006f : 0.0025f, 32);
        shapes::turn(hoop, {1, 0, 0}, 90), k.add(std::move(hoop), metal, {0, y, z});
    }
    k.rod(body, {0, y, 0.12f}, {0, y, 0.135f}, 0.04f, -1, 16);
    for (int i = 0; i < 20; ++i) {
        const float a = kTau * static_cast<float>(i) / 20;
        const Vec3f d{std::cos(a), std::sin(a), 0}, hub{0, y, 0};
        const std::array<Vec3f, 4> wire{hub + d * 0.03f + Vec3f{0, 0, 0.13f}, hub + d * 0.11f + Vec3f{0, 0, 0.127f},
                                        hub + d * 0.17f + Vec3f{0, 0, 0.112f}, hub + d * 0.22f + Vec3f{0, 0, 0.06f}};
        k.add(shapes::tube(wire, 0.0016f, 4), metal),
            k.rod(metal, hub + d * 0.22f + Vec3f{0, 0, 0.06f}, hub + d * 0.05f + Vec3f{0, 0, -0.01f}, 0.0016f, -1, 4);
    }
}

// The indoor unit of an air conditioner, high on the wall.
void build_air_conditioner(Kit& k) {
    const int body = k.main(plain("air conditioner", {0.76f, 0.77f, 0.77f}, 0.35f)),
              dark = color(k, "outlet", {0.03f, 0.03f, 0.033f}, 0.5f), led = lit(k, "led", {0.2f, 1.6f, 0.5f});
    k.board(body, {0, 0, 0.1f}, {0.85f, 0.29f, 0.2f}, 0.035f),
        block(k, dark, {0, 0.02f, 0.196f}, {0.74f, 0.045f, 0.008f});
    for (int i = 0; i < 2; ++i)
        k.board(body, {0, 0.024f + 0.02f * static_cast<float>(i), 0.206f}, {0.73f, 0.008f, 0.03f}, 0.002f);
    block(k, dark, {0, 0.085f, 0.2f}, {0.8f, 0.003f, 0.002f}),
        block(k, led, {0.33f, 0.12f, 0.2f}, {0.02f, 0.006f, 0.002f});
    for (int i = 0; i < 6; ++i)
        block(k, dark, {0, 0.288f, 0.05f + 0.02f * static_cast<float>(i)}, {0.7f, 0.003f, 0.008f});
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 2.05f;
}

// A heater of fins on wheels.
void build_space_heater(Kit& k) {
    const int body = k.main(plain("heater", {0.74f, 0.74f, 0.72f}, 0.35f)),
              dark = color(k, "wheel", {0.04f, 0.04f, 0.043f}, 0.6f);
    for (int i = 0; i < 8; ++i)
        k.board(body, {-0.2f + 0.052f * static_cast<float>(i), 0.08f, 0}, {0.034f, 0.52f, 0.15f}, 0.014f);
    k.board(body, {0.245f, 0.08f, 0}, {0.07f, 0.52f, 0.17f}, 0.015f);
    for (const float y : {0.13f, 0.52f}) k.rod(body, {-0.2f, y, 0}, {0.24f, y, 0}, 0.025f, -1, 10);
    for (int i = 0; i < 2; ++i)
        k.rod(dark, {0.245f, 0.34f + 0.12f * static_cast<float>(i), 0.08f},
              {0.245f, 0.34f + 0.12f * static_cast<float>(i), 0.105f}, 0.025f, -1, 14);
    for (const float x : {-0.15f, 0.2f}) {
        block(k, dark, {x, 0.05f, 0}, {0.03f, 0.03f, 0.26f});
        for (const float z : {-0.11f, 0.11f})
            k.rod(dark, {x - 0.012f, 0.03f, z}, {x + 0.012f, 0.03f, z}, 0.03f, -1, 12);
    }
}

// A loudspeaker as high as one's chest.
void build_speaker(Kit& k) {
    const int body = k.main(k.rng.chance(0.5f) ? k.style.wood : plain("speaker lacquer", {0.03f, 0.03f, 0.033f}, 0.3f)),
              dark = color(k, "cone", {0.02f, 0.02f, 0.022f}, 0.6f), metal = k.material(steel());
    k.board(dark, {0, 0, 0}, {0.27f, 0.03f, 0.33f}, 0.006f), k.board(body, {0, 0.03f, 0}, {0.23f, 0.95f, 0.3f}, 0.012f),
        k.board(dark, {0, 0.05f, 0.148f}, {0.21f, 0.91f, 0.014f}, 0.005f);
    const auto driver = [&](float y, float r) {
        Mesh rim = shapes::ring(r, 0.007f, 28),
             cone = shapes::shade(std::array<Vec2f, 3>{Vec2f{0.28f * r, 0.f}, {0.6f * r, 0.012f}, {0.95f * r, 0.02f}},
                                  24);
        shapes::turn(rim, {1, 0, 0}, 90), shapes::turn(cone, {1, 0, 0}, 90),
            k.add(std::move(rim), metal, {0, y, 0.157f}), k.add(std::move(cone), dark, {0, y, 0.14f});
        k.add(shapes::ball({0, y, 0.156f}, {0.3f * r, 0.3f * r, 0.01f}, 12), metal);
    };
    driver(0.24f, 0.082f), driver(0.46f, 0.082f), driver(0.68f, 0.082f), driver(0.86f, 0.035f);
}

// A small loudspeaker on a stand, as in studios.
void build_studio_monitor(Kit& k) {
    const int body = k.main(plain("studio monitor", {0.035f, 0.035f, 0.038f}, 0.45f)),
              cone = color(k, "cone", {0.75f, 0.55f, 0.05f}, 0.6f), metal = k.material(steel()),
              led = lit(k, "led", {0.3f, 0.6f, 2.f});
    k.board(metal, {0, 0, 0}, {0.3f, 0.02f, 0.3f}, 0.006f), k.rod(metal, {0, 0.02f, 0}, {0, 0.9f, 0}, 0.03f, -1, 12),
        k.board(metal, {0, 0.89f, 0}, {0.22f, 0.015f, 0.24f}, 0.004f),
        k.board(body, {0, 0.905f, 0}, {0.25f, 0.39f, 0.3f}, 0.018f);
    for (const auto& [y, r] : {std::pair{1.03f, 0.085f}, {1.21f, 0.04f}}) {
        Mesh rim = shapes::ring(r, 0.008f, 28);
        shapes::turn(rim, {1, 0, 0}, 90), k.add(std::move(rim), body, {0, y, 0.152f}),
            k.rod(cone, {0, y, 0.148f}, {0, y, 0.155f}, 0.92f * r, -1, 24),
            k.add(shapes::ball({0, y, 0.156f}, {0.35f * r, 0.35f * r, 0.012f}, 12), body);
    }
    block(k, led, {0.09f, 0.925f, 0.151f}, {0.012f, 0.006f, 0.002f});
}

void build_radio(Kit& k) {
    const int body = k.main(k.style.wood), front = color(k, "radio cloth", {0.42f, 0.34f, 0.2f}, 0.9f),
              dial = lit(k, "dial", {1.1f, 0.8f, 0.4f}), metal = k.material(steel()),
              dark = color(k, "needle", {0.03f, 0.03f, 0.03f}, 0.5f);
    k.board(body, {0, 0.01f, 0}, {0.3f, 0.18f, 0.12f}, 0.02f),
        k.board(front, {-0.05f, 0.03f, 0.058f}, {0.17f, 0.14f, 0.008f}, 0.003f),
        block(k, dial, {0.095f, 0.1f, 0.06f}, {0.08f, 0.055f, 0.003f}),
        block(k, dark, {0.1f, 0.103f, 0.062f}, {0.003f, 0.048f, 0.002f});
    for (int i = 0; i < 7; ++i)
        block(k, body, {-0.05f, 0.042f + 0.018f * static_cast<float>(i), 0.063f}, {0.16f, 0.004f, 0.003f});
    for (const float x : {0.07f, 0.12f}) k.rod(metal, {x, 0.06f, 0.058f}, {x, 0.06f, 0.078f}, 0.017f, -1, 14);
    for (const float sx : {-1.f, 1.f}) block(k, dark, {sx * 0.11f, 0, 0}, {0.03f, 0.012f, 0.08f});
    k.rod(metal, {0.12f, 0.18f, -0.045f}, {0.2f, 0.44f, -0.045f}, 0.003f, 0.002f, 6);
    on_surface(k);
}

// Lying on one side of their band.
void build_headphones(Kit& k) {
    const int body = k.main(plain("headphones", {0.03f, 0.03f, 0.033f}, 0.4f)),
              pad = color(k, "ear pad", {0.07f, 0.065f, 0.06f}, 0.8f), metal = k.material(steel());
    std::vector<Vec3f> band;
    for (int i = 0; i <= 16; ++i) {
        const float a = kPi * static_cast<float>(i) / 16;
        band.push_back({0.085f * std::cos(a), 0.045f + 0.13f * std::sin(a), 0});
    }
    k.add(shapes::tube(band, 0.009f, 8), body);
    for (const float s : {-1.f, 1.f}) {
        k.rod(metal, {s * 0.083f, 0.05f, 0}, {s * 0.088f, 0.09f, 0}, 0.006f, -1, 8),
            k.rod(body, {s * 0.075f, 0.042f, 0}, {s * 0.1f, 0.042f, 0}, 0.042f, 0.036f, 20);
        Mesh cushion = shapes::ring(0.03f, 0.012f, 20);
        shapes::turn(cushion, {0, 0, 1}, 90), k.add(std::move(cushion), pad, {s * 0.066f, 0.042f, 0});
    }
    on_surface(k);
}

// A camera in a housing on an arm, high on the wall.
void build_surveillance(Kit& k) {
    const int body = k.main(plain("camera", {0.74f, 0.75f, 0.75f}, 0.35f)),
              dark = color(k, "lens", {0.015f, 0.015f, 0.02f}, 0.1f), led = lit(k, "led", {2.2f, 0.1f, 0.1f});
    k.rod(body, {0, 0.16f, 0}, {0, 0.16f, 0.02f}, 0.05f, -1, 18),
        k.rod(body, {0, 0.16f, 0.01f}, {0, 0.15f, 0.11f}, 0.014f, -1, 10),
        k.add(shapes::ball({0, 0.145f, 0.12f}, {0.025f, 0.025f, 0.025f}, 10), body);
    const auto lay = [&](Mesh m, int material) {
        shapes::turn(m, {1, 0, 0}, 18), k.add(std::move(m), material, {0, 0.09f, 0.17f});
    };
    lay(shapes::box({0.09f, 0.085f, 0.22f}, 0.016f), body);
    Mesh hood = shapes::box({0.105f, 0.01f, 0.27f}, 0.004f);
    shapes::move(hood, {0, 0.048f, 0.02f}), lay(std::move(hood), body);
    lay(shapes::rod({0, 0, 0.1f}, {0, 0, 0.118f}, 0.034f, 0.032f, 18), dark);
    Mesh light = shapes::box({0.006f, 0.006f, 0.006f}, 0.001f);
    shapes::move(light, {0.032f, -0.032f, 0.11f}), lay(std::move(light), led);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 2.2f;
}

}  // namespace fastscene::furniture
