// The machines of an office: projectors, printers, computers, telephones, the water cooler.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

namespace {

// The lens looks along +z; by the middle of its lower face.
void projector_body(Kit& k, int body, float y) {
    const int dark = color(k, "vent", {0.03f, 0.03f, 0.033f}, 0.5f), metal = k.material(steel()),
              lens = color(k, "lens", {0.02f, 0.03f, 0.06f}, 0.05f);
    k.board(body, {0, y, 0}, {0.36f, 0.11f, 0.28f}, 0.018f);
    k.rod(dark, {0.09f, y + 0.056f, 0.12f}, {0.09f, y + 0.056f, 0.165f}, 0.044f, 0.04f, 20);
    k.rod(metal, {0.09f, y + 0.056f, 0.15f}, {0.09f, y + 0.056f, 0.168f}, 0.034f, -1, 20);
    k.rod(lens, {0.09f, y + 0.056f, 0.15f}, {0.09f, y + 0.056f, 0.172f}, 0.028f, -1, 16);
    for (int i = 0; i < 5; ++i) {
        const float h = y + 0.028f + 0.013f * static_cast<float>(i);
        block(k, dark, {-0.09f, h, 0.1401f}, {0.12f, 0.006f, 0.003f});
        for (const float sx : {-1.f, 1.f}) block(k, dark, {sx * 0.1801f, h, 0}, {0.003f, 0.006f, 0.16f});
    }
    for (int i = 0; i < 4; ++i)
        block(k, dark, {-0.12f + 0.05f * static_cast<float>(i), y + 0.03f, -0.1401f}, {0.032f, 0.02f, 0.003f});
    block(k, dark, {-0.06f, y + 0.11f, -0.04f}, {0.08f, 0.002f, 0.03f});
}

// Keys in rows on a plate, by the middle of its lower face; rises to the back.
void key_rows(Kit& k, int key, float width, float depth, float y, int columns, int rows, float z = 0) {
    const float dx = width / static_cast<float>(columns), dz = depth / static_cast<float>(rows);
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const bool space = r == 0 && c >= columns / 4 && c < columns - columns / 3;
            if (space && c > columns / 4) continue;
            const int n = space ? columns - columns / 3 - columns / 4 : 1;
            block(k, key,
                  {-0.5f * width + dx * (static_cast<float>(c) + 0.5f * static_cast<float>(n)),
                   y + 0.0015f * static_cast<float>(r), z + 0.5f * depth - dz * (static_cast<float>(r) + 0.5f)},
                  {dx * (static_cast<float>(n) - 0.16f), 0.006f, dz * 0.84f});
        }
}

}  // namespace

// Hangs from the ceiling by a pole.
void build_projector(Kit& k) {
    const int body = k.main(plain("projector", {0.72f, 0.72f, 0.71f}, 0.35f)), metal = k.material(steel());
    const float drop = 0.5f;
    k.add(shapes::prism(shapes::circle(0.075f, 24), -0.025f, 0, 0.006f), metal);
    k.rod(metal, {0, -drop + 0.02f, 0}, {0, -0.01f, 0}, 0.018f, -1, 14);
    block(k, metal, {0, -drop, 0}, {0.2f, 0.012f, 0.16f});
    for (const float sx : {-1.f, 1.f}) block(k, metal, {sx * 0.11f, -drop - 0.02f, 0}, {0.02f, 0.03f, 0.03f});
    projector_body(k, body, -drop - 0.13f);
    k.piece.mount = Mount::ceiling;
}

void build_table_projector(Kit& k) {
    const int body = k.main(plain("projector", {0.72f, 0.72f, 0.71f}, 0.35f)),
              dark = color(k, "foot", {0.03f, 0.03f, 0.033f}, 0.5f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) block(k, dark, {sx * 0.14f, 0, sz * 0.1f}, {0.025f, 0.016f, 0.025f});
    projector_body(k, body, 0.014f);
    on_surface(k);
}

void build_printer(Kit& k) {
    const bool light = k.rng.chance(0.5f);
    const int body = k.main(plain("printer", light ? Vec3f{0.7f, 0.7f, 0.69f} : Vec3f{0.06f, 0.06f, 0.065f}, 0.4f)),
              dark = color(k, "slot", {0.02f, 0.02f, 0.022f}, 0.45f),
              paper = color(k, "paper", {0.82f, 0.82f, 0.8f}, 0.9f), screen = lit(k, "display", {0.15f, 0.5f, 0.9f}),
              gray = color(k, "gray plastic", {0.3f, 0.31f, 0.32f}, 0.4f);
    k.board(body, {0, 0, 0}, {0.42f, 0.12f, 0.36f}, 0.015f);
    k.board(gray, {0, 0.12f, 0}, {0.41f, 0.012f, 0.35f}, 0.004f);
    k.board(body, {0, 0.13f, -0.01f}, {0.42f, 0.06f, 0.34f}, 0.018f);
    // The slot, its tray and a sheet that lies on it.
    block(k, dark, {0, 0.045f, 0.1805f}, {0.3f, 0.055f, 0.003f});
    k.board(gray, {0, 0.03f, 0.24f}, {0.28f, 0.01f, 0.14f}, 0.004f);
    block(k, paper, {0.004f, 0.041f, 0.22f}, {0.21f, 0.004f, 0.16f});
    // Paper stands at the back.
    Mesh sheets = shapes::box({0.21f, 0.2f, 0.012f}, 0.002f), rest = shapes::box({0.26f, 0.14f, 0.012f}, 0.004f);
    shapes::turn(sheets, {1, 0, 0}, -18), shapes::turn(rest, {1, 0, 0}, -18);
    k.add(std::move(rest), gray, {0, 0.24f, -0.17f}), k.add(std::move(sheets), paper, {0, 0.265f, -0.165f});
    Mesh panel = shapes::box({0.34f, 0.05f, 0.008f}, 0.003f), display = shapes::box({0.08f, 0.036f, 0.004f}, 0.001f);
    shapes::turn(panel, {1, 0, 0}, -30), shapes::turn(display, {1, 0, 0}, -30);
    k.add(std::move(panel), dark, {0, 0.165f, 0.166f}), k.add(std::move(display), screen, {-0.08f, 0.167f, 0.17f});
    for (int i = 0; i < 4; ++i)
        k.add(shapes::ball({0.02f + 0.035f * static_cast<float>(i), 0.166f, 0.173f}, {0.008f, 0.008f, 0.006f}, 6),
              i == 3 ? screen : gray);
    on_surface(k);
}

// A copier as high as one's hip: drawers of paper, the scanner above, a panel that leans out.
void build_copier(Kit& k) {
    const int body = k.main(plain("copier", {0.68f, 0.68f, 0.66f}, 0.4f)),
              dark = color(k, "copier dark", {0.05f, 0.05f, 0.055f}, 0.4f),
              gray = color(k, "copier gray", {0.28f, 0.29f, 0.31f}, 0.4f),
              screen = lit(k, "display", {0.2f, 0.6f, 1.f}), paper = color(k, "paper", {0.82f, 0.82f, 0.8f}, 0.9f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.add(shapes::ball({sx * 0.24f, 0.03f, sz * 0.24f}, {0.03f, 0.03f, 0.03f}, 8), dark);
    k.board(gray, {0, 0.05f, 0}, {0.6f, 0.05f, 0.6f}, 0.01f), k.board(body, {0, 0.1f, 0}, {0.6f, 0.62f, 0.6f}, 0.015f);
    for (int i = 0; i < 4; ++i) {
        const float y = 0.12f + 0.135f * static_cast<float>(i);
        k.board(body, {0, y, 0.3f}, {0.56f, 0.122f, 0.02f}, 0.005f),
            block(k, dark, {0, y + 0.085f, 0.311f}, {0.2f, 0.02f, 0.002f});
    }
    // Where copies come out.
    k.board(body, {-0.24f, 0.72f, 0}, {0.12f, 0.2f, 0.6f}, 0.01f),
        k.board(body, {0, 0.72f, -0.22f}, {0.6f, 0.2f, 0.16f}, 0.01f);
    block(k, dark, {0.06f, 0.722f, 0.08f}, {0.48f, 0.008f, 0.44f}),
        block(k, paper, {0.06f, 0.73f, 0.06f}, {0.3f, 0.012f, 0.21f});
    k.board(body, {0, 0.92f, 0}, {0.62f, 0.08f, 0.6f}, 0.015f),
        k.board(gray, {0, 1.0f, 0}, {0.6f, 0.01f, 0.58f}, 0.003f);
    k.board(body, {-0.02f, 1.01f, -0.02f}, {0.56f, 0.1f, 0.52f}, 0.03f);
    k.board(dark, {-0.02f, 1.105f, -0.02f}, {0.4f, 0.012f, 0.1f}, 0.004f);
    Mesh panel = shapes::box({0.4f, 0.03f, 0.16f}, 0.008f), display = shapes::box({0.2f, 0.006f, 0.11f}, 0.002f);
    shapes::turn(panel, {1, 0, 0}, 28), shapes::turn(display, {1, 0, 0}, 28);
    k.add(std::move(panel), gray, {0.06f, 0.975f, 0.36f}), k.add(std::move(display), screen, {0.0f, 0.99f, 0.367f});
    for (int i = 0; i < 6; ++i)
        block(k, i == 5 ? screen : body,
              {0.14f + 0.035f * static_cast<float>(i % 3), 0.98f - 0.02f * static_cast<float>(i / 3),
               0.365f + 0.035f * static_cast<float>(i / 3)},
              {0.02f, 0.014f, 0.02f});
    k.add(shapes::box({0.26f, 0.014f, 0.36f}, 0.005f), gray, {-0.42f, 0.62f, 0}),
        k.board(paper, {-0.41f, 0.627f, 0}, {0.2f, 0.01f, 0.28f}, 0.001f);
    k.piece.clearance_front_m = 0.6f, k.piece.against_wall = true;
}

void build_keyboard_pc(Kit& k) {
    const bool light = k.rng.chance(0.4f);
    const int body = k.main(plain("keyboard", light ? Vec3f{0.6f, 0.6f, 0.59f} : Vec3f{0.03f, 0.03f, 0.033f}, 0.45f)),
              key = color(k, "keys", light ? Vec3f{0.78f, 0.78f, 0.76f} : Vec3f{0.075f, 0.075f, 0.08f}, 0.5f);
    k.board(body, {0, 0, 0}, {0.43f, 0.016f, 0.145f}, 0.006f);
    key_rows(k, key, 0.3f, 0.125f, 0.0145f, 14, 5);
    for (Mesh& m : k.piece.meshes)
        if (m.material == key) shapes::move(m, {-0.055f, 0, 0});
    for (int i = 0; i < 15; ++i)
        block(
            k, key,
            {0.125f + 0.024f * static_cast<float>(i % 3) + 0.02f, 0.0145f, -0.05f + 0.025f * static_cast<float>(i / 3)},
            {0.02f, 0.008f, 0.021f});
    on_surface(k);
}

void build_mouse(Kit& k) {
    const int body = k.main(
                  plain("mouse", k.rng.chance(0.5f) ? Vec3f{0.04f, 0.04f, 0.043f} : Vec3f{0.7f, 0.7f, 0.69f}, 0.35f)),
              wheel = color(k, "wheel", {0.25f, 0.26f, 0.27f}, 0.6f);
    Mesh shell = shapes::ball({0, 0, 0}, {0.032f, 0.036f, 0.056f}, 18);
    for (Vec3f& p : shell.positions) p.y = std::max(p.y, 0.f);
    k.add(std::move(shell), body), block(k, wheel, {0, 0.02f, -0.028f}, {0.007f, 0.0135f, 0.016f});
    on_surface(k);
}

// A flat screen on a foot, its keyboard and its mouse.
void build_computer(Kit& k) {
    const int plastic = k.main(plain("black plastic", {0.032f, 0.032f, 0.034f}, 0.3f));
    k.merge(k.small("monitor"), {0, 0, -0.1f});
    k.merge(k.small("keyboard_pc"), {-0.02f, 0, 0.14f});
    k.merge(k.small("mouse"), {0.27f, 0, 0.14f});
    // All three are of one color.
    for (Mesh& m : k.piece.meshes) {
        const std::string& name = k.piece.materials[static_cast<std::size_t>(m.material)].name;
        if (name == "black plastic" || name == "keyboard" || name == "mouse") m.material = plastic;
    }
    on_surface(k);
}

// A desk telephone: receiver across, keys, a small display.
void build_phone(Kit& k) {
    const int body = k.main(plain("telephone", {0.04f, 0.04f, 0.043f}, 0.35f)),
              key = color(k, "keys", {0.55f, 0.55f, 0.54f}, 0.5f),
              screen = color(k, "display", {0.3f, 0.38f, 0.32f}, 0.2f);
    Mesh wedge = shapes::box({0.2f, 0.035f, 0.2f}, 0.01f);
    shapes::turn(wedge, {1, 0, 0}, 14);
    k.add(std::move(wedge), body, {0, 0.042f, 0}), k.board(body, {0, 0, -0.03f}, {0.18f, 0.04f, 0.12f}, 0.008f);
    const auto on = [](float x, float z) { return Vec3f{x, 0.0585f - 0.249f * z, z}; };
    for (int i = 0; i < 12; ++i)
        block(k, key,
              on(0.005f + 0.028f * static_cast<float>(i % 3), -0.005f + 0.023f * static_cast<float>(i / 3)) -
                  Vec3f{0, 0.002f, 0},
              {0.02f, 0.007f, 0.015f});
    Mesh display = shapes::box({0.09f, 0.006f, 0.04f}, 0.002f);
    shapes::turn(display, {1, 0, 0}, 14), k.add(std::move(display), screen, on(0.035f, -0.055f) + Vec3f{0, 0.002f, 0});
    std::vector<Vec3f> grip;
    for (int i = 0; i <= 8; ++i) {
        const float t = -1.f + 0.25f * static_cast<float>(i), z = 0.085f * t;
        grip.push_back(on(-0.065f, z) + Vec3f{0, 0.012f + 0.026f * (1 - t * t), 0});
    }
    k.add(shapes::tube(grip, 0.014f, 10), body);
    for (const float t : {-1.f, 1.f})
        k.add(shapes::ball(on(-0.065f, 0.083f * t) + Vec3f{0, 0.012f, 0}, {0.026f, 0.02f, 0.027f}, 12), body);
    std::vector<Vec3f> cord;
    for (int i = 0; i <= 40; ++i) {
        const float t = static_cast<float>(i) / 40, a = 9 * kTau * t;
        cord.push_back({-0.105f - 0.04f * std::sin(kPi * t) + 0.005f * std::cos(a),
                        0.009f + 0.005f * std::sin(a) + 0.02f * (1 - t) * (1 - t), 0.085f - 0.16f * t});
    }
    k.add(shapes::tube(cord, 0.0022f, 5), body);
    on_surface(k);
}

// A star of three arms in the middle of a conference table.
void build_speakerphone(Kit& k) {
    const int body = k.main(plain("speakerphone", {0.045f, 0.045f, 0.048f}, 0.4f)),
              mesh = color(k, "grille", {0.12f, 0.12f, 0.125f}, 0.7f), key = color(k, "keys", {0.5f, 0.5f, 0.5f}, 0.5f),
              led = lit(k, "led", {0.2f, 2.f, 0.4f});
    std::vector<Vec2f> outline;
    for (int i = 0; i < 48; ++i) {
        const float a = -kTau * static_cast<float>(i) / 48, r = 0.125f + 0.045f * std::cos(3 * a);
        outline.push_back({r * std::sin(a), r * std::cos(a)});
    }
    if (shapes::signed_volume(shapes::prism(outline, 0, 0.03f)) < 0) std::reverse(outline.begin(), outline.end());
    k.add(shapes::prism(outline, 0, 0.035f, 0.01f), body);
    const std::array<Vec2f, 4> dome{Vec2f{0.075f, 0}, {0.07f, 0.016f}, {0.045f, 0.026f}, {0.f, 0.03f}};
    k.add(shapes::lathe(dome, 24, true), mesh, {0, 0.033f, -0.012f});
    for (int i = 0; i < 12; ++i)
        block(k, key,
              {-0.022f + 0.022f * static_cast<float>(i % 3), 0.034f, 0.075f + 0.019f * static_cast<float>(i / 3)},
              {0.015f, 0.004f, 0.012f});
    for (int i = 0; i < 3; ++i)
        k.add(shapes::ball(around(kTau * static_cast<float>(i) / 3) * 0.155f + Vec3f{0, 0.035f, 0},
                           {0.006f, 0.004f, 0.006f}, 6),
              led);
    on_surface(k);
}

// A cabinet with two taps and a bottle of water upside down on it.
void build_water_cooler(Kit& k) {
    const int body = k.main(plain("cooler", {0.75f, 0.75f, 0.74f}, 0.35f)),
              dark = color(k, "cooler dark", {0.06f, 0.06f, 0.065f}, 0.45f),
              blue = color(k, "cold tap", {0.03f, 0.15f, 0.6f}, 0.3f),
              red = color(k, "hot tap", {0.6f, 0.03f, 0.03f}, 0.3f),
              cup = color(k, "paper cup", {0.8f, 0.8f, 0.78f}, 0.8f);
    Material water = plain("water bottle", {0.3f, 0.52f, 0.72f}, 0.06f);
    water.transmission = 0.35f;
    const int bottle_water = k.material(water);
    k.board(body, {0, 0, 0}, {0.32f, 0.98f, 0.33f}, 0.025f);
    block(k, dark, {0, 0.02f, 0.1655f}, {0.28f, 0.03f, 0.004f});
    k.board(dark, {0, 0.66f, 0.158f}, {0.26f, 0.24f, 0.02f}, 0.008f);
    k.board(body, {0, 0.63f, 0.19f}, {0.26f, 0.03f, 0.07f}, 0.008f),
        block(k, dark, {0, 0.659f, 0.19f}, {0.22f, 0.004f, 0.05f});
    for (const float sx : {-1.f, 1.f}) {
        const int tap = sx < 0 ? blue : red;
        k.rod(body, {sx * 0.06f, 0.83f, 0.16f}, {sx * 0.06f, 0.825f, 0.205f}, 0.014f, -1, 8);
        k.rod(body, {sx * 0.06f, 0.79f, 0.2f}, {sx * 0.06f, 0.84f, 0.2f}, 0.011f, -1, 8);
        block(k, tap, {sx * 0.06f, 0.838f, 0.2f}, {0.03f, 0.016f, 0.04f});
    }
    const std::array<Vec2f, 3> collar{Vec2f{0.13f, 0}, {0.12f, 0.03f}, {0.08f, 0.04f}};
    k.add(shapes::lathe(collar, 24), body, {0, 0.975f, 0});
    const std::array<Vec2f, 12> bottle_form{Vec2f{0.045f, 0}, {0.045f, 0.03f}, {0.1f, 0.085f},  {0.13f, 0.12f},
                                            {0.132f, 0.17f},  {0.125f, 0.18f}, {0.132f, 0.19f}, {0.132f, 0.27f},
                                            {0.125f, 0.28f},  {0.132f, 0.29f}, {0.13f, 0.375f}, {0.1f, 0.39f}};
    k.add(shapes::lathe(bottle_form, 28, true), bottle_water, {0, 1.0f, 0});
    // Cups in a tube at the side.
    const std::array<Vec2f, 3> cups{Vec2f{0.028f, 0}, {0.034f, 0.03f}, {0.034f, 0.3f}};
    k.add(shapes::lathe(cups, 14), cup, {0.2f, 0.58f, 0.06f});
    for (const float y : {0.64f, 0.84f}) block(k, dark, {0.185f, y, 0.06f}, {0.08f, 0.012f, 0.075f});
    k.piece.clearance_front_m = 0.5f, k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
