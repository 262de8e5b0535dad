// Kitchen, bathroom and what is fixed to the house.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

// A part of the units in what was asked for it.
Material part_in(Material usual, const std::string& material, const std::string& color) {
    if (const auto asked = material.empty() ? std::nullopt : material_named(material)) usual = *asked;
    if (const auto asked = color.empty() ? std::nullopt : color_named(color)) {
        // A plain worktop of another color is no longer wood.
        usual = material.empty() && usual.pattern == Pattern::wood ? plain("worktop", *asked, 0.3f)
                                                                   : tinted(usual, *asked);
    }
    return usual;
}
Material usual_worktop(const Kit& k) {
    return k.style.legs == LegType::tapered || k.style.legs == LegType::square ? k.style.wood2
                                                                               : *material_named("marble");
}
Material worktop(const Kit& k) { return part_in(usual_worktop(k), k.request.holder_material, k.request.holder_color); }
Material kitchen_front(const Kit& k) {
    if (k.style.mouldings == Mouldings::none) return k.style.wood;
    // What kitchens of the style are painted; not every accent of a room suits a whole wall of doors.
    static constexpr std::array<std::pair<std::string_view, std::array<const char*, 2>>, 4> kPaints{
        {{"scandinavian", {"light sage", "off white"}},
         {"classic", {"dusty navy", "ivory"}},
         {"rustic", {"sage", "cream"}},
         {"art deco", {"bottle green", "navy"}}}};
    const bool second = (k.request.seed & 4) != 0;
    for (const auto& [style, colors] : kPaints)
        if (k.style.name == style) return plain("painted fronts", *color_named(colors[second ? 1 : 0]), 0.4f);
    return plain("painted fronts", lerp(k.style.palette[0], {0.55f, 0.54f, 0.5f}, 0.45f), 0.4f);
}
void tap(Kit& k, int chrome, Vec3f at, float h) {
    std::vector<Vec3f> path{at, at + Vec3f{0, 0.6f * h, 0}};
    for (int i = 0; i <= 8; ++i) {
        const float a = 3.14159f * static_cast<float>(i) / 8.f;
        path.push_back(at + Vec3f{0, 0.7f * h + 0.3f * h * std::sin(a), 0.07f * (1.f - std::cos(a))});
    }
    k.add(shapes::tube(path, 0.011f, 10), chrome);
    k.rod(chrome, at, at + Vec3f{0, 0.03f, 0}, 0.024f, -1, 16);
    k.rod(chrome, at + Vec3f{0.015f, 0.06f, 0}, at + Vec3f{0.07f, 0.085f, 0}, 0.007f, -1, 8);
}
void kitchen_counter(Kit& k) {
    const Vec3f s = k.wanted({2.8f, 2.2f, 0.62f});
    const int front = k.main(kitchen_front(k)), top = k.material(worktop(k)), metal = k.material(k.style.metal),
              chrome = k.material(steel()), dark = k.material(plain("black glass", {0.032f, 0.032f, 0.035f}, 0.08f));
    Material splash = k.style.mouldings == Mouldings::none ? *material_named("marble") : *material_named("tiles");
    if (k.style.mouldings != Mouldings::none) splash.pattern = Pattern::subway, splash.scale_m = 0.15f;
    if (!k.request.back_material.empty() && k.request.back_material != "tile") splash = *material_named("plaster");
    const int tiles = k.material(
        part_in(splash, k.request.back_material == "tile" ? "" : k.request.back_material, k.request.back_color));
    const float w = s.x, d = 0.6f, z0 = -0.5f * d;
    const bool cupboards = s.y > 1.5f;  // a low run stands below a window
    k.board(dark, {0, 0, -0.04f}, {w, 0.1f, d - 0.1f});
    k.board(front, {0, 0.1f, -0.02f}, {w, 0.76f, d - 0.04f});
    k.board(top, {0, 0.86f, 0.01f}, {w + 0.01f, 0.04f, d + 0.03f}, 0.005f);
    k.board(tiles, {0, 0.9f, z0 + 0.004f}, {w, cupboards ? 0.55f : 0.06f, 0.008f}, 0.001f);
    const int units = std::max(3, static_cast<int>(std::lround(w / 0.6f)));
    const float uw = w / static_cast<float>(units), fz = 0.5f * d - 0.04f;
    const int oven = units - 2, sink = std::min(1, units - 2) - (units <= 3 ? 1 : 0);
    for (int i = 0; i < units; ++i) {
        const float x0 = -0.5f * w + uw * static_cast<float>(i), cx = x0 + 0.5f * uw;
        if (i == oven && k.request.cooks) {
            k.board(dark, {cx, 0.22f, fz + 0.008f}, {uw - 0.01f, 0.48f, 0.02f}, 0.004f);
            k.rod(chrome, {cx - 0.38f * uw, 0.66f, fz + 0.045f}, {cx + 0.38f * uw, 0.66f, fz + 0.045f}, 0.008f);
            for (const float e : {-0.34f, 0.34f})
                k.rod(chrome, {cx + e * uw, 0.66f, fz + 0.01f}, {cx + e * uw, 0.66f, fz + 0.045f}, 0.006f);
            k.board(chrome, {cx, 0.71f, fz + 0.008f}, {uw - 0.01f, 0.13f, 0.02f}, 0.004f);
            for (int j = -2; j <= 2; ++j)
                k.rod(dark, {cx + 0.09f * static_cast<float>(j), 0.775f, fz + 0.015f},
                      {cx + 0.09f * static_cast<float>(j), 0.775f, fz + 0.04f}, 0.018f, 0.015f, 16);
            k.board(dark, {cx, 0.9f, 0.01f}, {uw - 0.04f, 0.006f, 0.5f}, 0.002f);
            for (int j = 0; j < 4; ++j)
                k.add(shapes::ring(0.08f, 0.004f, 24), chrome,
                      {cx + (j % 2 ? 0.13f : -0.13f), 0.906f, 0.01f + (j / 2 ? 0.12f : -0.12f)});
            const std::array<Vec2f, 3> pot{Vec2f{0.095f, 0}, {0.1f, 0.01f}, {0.1f, 0.11f}};
            k.add(shapes::vessel(pot, 0.004f, 28), chrome, {cx - 0.13f, 0.906f, -0.11f});
            if (!cupboards) continue;
            // The hood: a chimney over a slanted body.
            k.board(chrome, {cx, 1.52f, z0 + 0.2f}, {uw, 0.06f, 0.4f}, 0.006f);
            k.board(chrome, {cx, 1.575f, z0 + 0.15f}, {0.26f, s.y - 1.575f, 0.26f}, 0.006f);
        } else {
            const int rows = i == sink ? 1 : (i + static_cast<int>(k.request.seed & 1)) % 2 == 0 ? 3 : 1;
            fronts(k, front, metal, x0 + 0.003f, x0 + uw - 0.003f, 0.105f, 0.855f, fz, 1, rows);
            if (cupboards) {
                k.board(front, {cx, 1.45f, z0 + 0.165f}, {uw - 0.001f, s.y - 1.45f, 0.33f}, 0.003f);
                fronts(k, front, metal, x0 + 0.003f, x0 + uw - 0.003f, 1.45f, s.y, z0 + 0.33f, 1, 1);
            }
            if (i == sink) {
                k.board(chrome, {cx, 0.9f, 0.03f}, {0.48f, 0.004f, 0.4f}, 0.002f);
                k.board(dark, {cx, 0.902f, 0.03f}, {0.43f, 0.004f, 0.35f}, 0.002f);
                tap(k, k.material(k.style.tap), {cx, 0.9f, -0.2f}, 0.26f);
            } else {
                k.top(0.9f, cx, 0.f, 0.42f * uw, 0.2f);
            }
        }
    }
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}
void kitchen_island(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 0.92f, 0.85f});
    const int front = k.main(kitchen_front(k)), top = k.material(worktop(k)), metal = k.material(k.style.metal),
              dark = k.material(plain("plinth", {0.04f, 0.04f, 0.04f}, 0.6f));
    k.board(dark, {0, 0, 0}, {s.x - 0.16f, 0.1f, s.z - 0.2f});
    k.board(front, {0, 0.1f, 0}, {s.x - 0.08f, s.y - 0.14f, s.z - 0.12f});
    k.board(top, {0, s.y - 0.04f, 0}, {s.x, 0.04f, s.z}, 0.006f);
    fronts(k, front, metal, -0.5f * s.x + 0.045f, 0.5f * s.x - 0.045f, 0.105f, s.y - 0.045f, 0.5f * s.z - 0.06f, 3, 2);
    k.top(s.y, 0, 0, 0.44f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = k.piece.clearance_side_m = 0.8f;
}
void fridge(Kit& k) {
    const int body = k.main(steel()), dark = k.material(plain("seal", {0.05f, 0.05f, 0.05f}, 0.6f));
    k.board(dark, {0, 0, 0}, {0.56f, 0.06f, 0.56f});
    k.board(body, {0, 0.05f, -0.03f}, {0.62f, 1.8f, 0.6f}, 0.006f);
    k.board(body, {0, 0.07f, 0.302f}, {0.61f, 0.58f, 0.06f}, 0.012f);
    k.board(body, {0, 0.66f, 0.302f}, {0.61f, 1.18f, 0.06f}, 0.012f);
    for (const Vec2f y : {Vec2f{0.36f, 0.6f}, Vec2f{0.72f, 1.2f}})
        k.rod(dark, {-0.25f, y.x, 0.36f}, {-0.25f, y.y, 0.36f}, 0.012f),
            k.rod(dark, {-0.25f, y.x + 0.03f, 0.33f}, {-0.25f, y.x + 0.03f, 0.36f}, 0.008f),
            k.rod(dark, {-0.25f, y.y - 0.03f, 0.33f}, {-0.25f, y.y - 0.03f, 0.36f}, 0.008f);
    k.top(1.85f, 0, -0.03f, 0.28f, 0.26f);
    k.piece.clearance_front_m = 0.8f;
    k.piece.against_wall = true;
}
void washing_machine(Kit& k) {
    const int body = k.main(plain("white enamel", {0.76f, 0.76f, 0.75f}, 0.25f)), chrome = k.material(steel()),
              dark = k.material(plain("door glass", {0.04f, 0.045f, 0.05f}, 0.08f));
    k.board(body, {0, 0, 0}, {0.6f, 0.85f, 0.58f}, 0.012f);
    Mesh rim = shapes::ring(0.17f, 0.05f, 36);
    shapes::turn(rim, {1, 0, 0}, 90);
    k.add(std::move(rim), chrome, {0, 0.42f, 0.29f});
    k.add(shapes::ball({0, 0.42f, 0.285f}, {0.155f, 0.155f, 0.045f}, 28), dark);
    k.board(dark, {0.1f, 0.75f, 0.288f}, {0.26f, 0.05f, 0.006f}, 0.002f);
    k.rod(chrome, {-0.14f, 0.775f, 0.285f}, {-0.14f, 0.775f, 0.315f}, 0.03f, 0.027f, 24);
    k.top(0.85f, 0, 0, 0.26f, 0.24f);
    k.piece.clearance_front_m = 0.7f;
    k.piece.against_wall = true;
}
void toilet(Kit& k) {
    const int white = k.main(porcelain()), chrome = k.material(steel());
    const auto oval = [](float w, float d, float z) {
        std::vector<Vec2f> o = shapes::circle(1.f, 40);
        for (Vec2f& p : o) p = {0.5f * w * p.x, z + 0.5f * d * p.y};
        return o;
    };
    // The foot widens into the bowl: a turned body, drawn out lengthwise and leaning forward.
    const std::array<Vec2f, 8> foot{Vec2f{0.115f, 0}, {0.12f, 0.01f},  {0.115f, 0.08f}, {0.12f, 0.15f},
                                    {0.145f, 0.23f},  {0.175f, 0.31f}, {0.188f, 0.36f}, {0.19f, 0.385f}};
    Mesh body = shapes::lathe(foot, 40, true);
    for (Vec3f& p : body.positions) p.z = p.z * 1.28f + 0.06f * (p.y / 0.385f);
    shapes::smooth_normals(body);
    k.add(std::move(body), white);
    k.add(shapes::prism(oval(0.39f, 0.5f, 0.06f), 0.38f, 0.4f, 0.008f), white);
    k.add(shapes::prism(oval(0.37f, 0.48f, 0.06f), 0.401f, 0.425f, 0.01f), white);
    k.soft(white, {0, 0.36f, -0.27f}, {0.38f, 0.42f, 0.18f}, {0.035f, 0.006f, 0.f, 10});
    k.soft(white, {0, 0.775f, -0.27f}, {0.4f, 0.03f, 0.2f}, {0.012f, 0.003f, 0.f, 8});
    k.rod(chrome, {0, 0.8f, -0.27f}, {0, 0.812f, -0.27f}, 0.022f, -1, 20);
    k.board(white, {0, 0, -0.25f}, {0.2f, 0.38f, 0.2f}, 0.02f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.clearance_side_m = 0.2f;
    k.piece.against_wall = true;
}
void bathtub(Kit& k) {
    const int white = k.main(porcelain()), chrome = k.material(k.style.tap);
    const float w = 1.7f, d = 0.76f, h = 0.58f;
    // One closed skin: up the outside, over the rim, down the inside.
    const std::vector<Vec2f> unit = shapes::circle(1.f, 56);
    struct Level {
        float grow, y;
    };
    const std::array<Level, 10> skin{Level{0.74f, 0.f}, {0.78f, 0.02f},  {0.88f, 0.25f},  {0.97f, 0.53f},
                                     {1.f, 0.56f},      {0.985f, 0.58f}, {0.855f, 0.58f}, {0.82f, 0.45f},
                                     {0.72f, 0.2f},     {0.55f, 0.15f}};
    Mesh m;
    const auto point = [&](const Level& l, const Vec2f& p) {
        const float e = 0.62f;  // between an ellipse and a rectangle
        const float x = std::copysign(std::pow(std::fabs(p.x), e), p.x),
                    z = std::copysign(std::pow(std::fabs(p.y), e), p.y);
        const float in = (1.f - l.grow) * 0.5f * d * 1.3f;
        return Vec3f{x * (0.5f * w - in), l.y * h / 0.58f, z * (0.5f * d - in)};
    };
    const auto n = static_cast<std::uint32_t>(unit.size());
    for (const Level& l : skin)
        for (const Vec2f& p : unit) m.positions.push_back(point(l, p));
    for (std::uint32_t j = 0; j + 1 < skin.size(); ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * n + i, b = j * n + (i + 1) % n;
            m.triangles.insert(m.triangles.end(), {a, a + n, b + n, a, b + n, b});
        }
    for (const bool inside : {false, true}) {
        const auto hub = static_cast<std::uint32_t>(m.positions.size()),
                   ring = inside ? static_cast<std::uint32_t>(skin.size() - 1) * n : 0u;
        m.positions.push_back({0, inside ? skin.back().y - 0.005f : 0.f, 0});
        for (std::uint32_t i = 0; i < n; ++i)
            m.triangles.insert(m.triangles.end(),
                               {hub, inside ? ring + (i + 1) % n : ring + i, inside ? ring + i : ring + (i + 1) % n});
    }
    m.normals.assign(m.positions.size(), {0, 1, 0});
    shapes::smooth_normals(m);
    shapes::lay_grain(m);
    k.add(std::move(m), white);
    tap(k, chrome, {-0.5f * w + 0.05f, 0.56f, 0}, 0.22f);
    // Candles and bottles stand on the rim's long sides, where it is straight: more room behind than where one climbs
    // in.
    k.piece.surfaces.push_back({{0, h, -0.5f * d + 0.039f}, {0.2f * w, 0.03f}});
    k.piece.surfaces.push_back({{0, h, 0.5f * d - 0.039f}, {0.16f * w, 0.03f}});
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}
void shower(Kit& k) {
    const int tray = k.main(porcelain()), chrome = k.material(k.style.tap);
    Material pane = glass();
    pane.color_a = pane.color_b = {0.75f, 0.8f, 0.79f};
    pane.transmission = 0.92f;
    const int clear = k.material(pane);
    k.board(tray, {0, 0, 0}, {0.9f, 0.06f, 0.9f}, 0.012f);
    k.board(clear, {0, 0.06f, 0.435f}, {0.86f, 1.94f, 0.008f}, 0.002f);
    k.board(clear, {0.435f, 0.06f, 0}, {0.008f, 1.94f, 0.86f}, 0.002f);
    k.board(chrome, {0.435f, 0.06f, 0.435f}, {0.02f, 1.96f, 0.02f}, 0.004f);
    k.board(chrome, {0, 1.99f, 0.435f}, {0.88f, 0.03f, 0.02f}, 0.004f);
    k.board(chrome, {0.435f, 1.99f, 0}, {0.02f, 0.03f, 0.88f}, 0.004f);
    k.rod(chrome, {0, 1.0f, -0.42f}, {0, 2.05f, -0.42f}, 0.011f);
    k.rod(chrome, {0, 2.04f, -0.42f}, {0, 2.04f, -0.1f}, 0.011f);
    k.rod(chrome, {0, 1.985f, -0.1f}, {0, 2.04f, -0.1f}, 0.11f, 0.02f, 28);
    k.rod(chrome, {-0.09f, 1.05f, -0.42f}, {0.09f, 1.05f, -0.42f}, 0.022f, -1, 16);
    k.rod(chrome, {-0.1f, 0.95f, 0.45f}, {-0.1f, 1.25f, 0.45f}, 0.01f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}
void washbasin(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 0.86f, 0.5f});
    const int front = k.main(kitchen_front(k)), top = k.material(worktop(k)), metal = k.material(k.style.metal),
              white = k.material(porcelain()), chrome = k.material(k.style.tap);
    legs(k, metal, 0.5f * s.x - 0.06f, 0.5f * s.z - 0.06f, 0.3f, 0.04f);
    k.board(front, {0, 0.28f, -0.015f}, {s.x - 0.02f, 0.4f, s.z - 0.05f});
    fronts(k, front, metal, -0.5f * s.x + 0.015f, 0.5f * s.x - 0.015f, 0.285f, 0.675f, 0.5f * s.z - 0.04f, 2, 1);
    k.board(top, {0, 0.68f, 0}, {s.x, 0.035f, s.z}, 0.005f);
    const std::array<Vec2f, 5> bowl{Vec2f{0.1f, 0}, {0.14f, 0.01f}, {0.18f, 0.06f}, {0.2f, 0.13f}, {0.2f, 0.14f}};
    k.add(shapes::vessel(bowl, 0.012f, 36), white, {0, 0.714f, 0.01f});
    tap(k, chrome, {0, 0.714f, -0.205f}, 0.26f);
    k.top(0.715f, -0.34f * s.x, 0, 0.1f * s.x, 0.15f);
    k.rod(k.material(plain("soap bottle", k.accent(), 0.3f)), {0.33f * s.x, 0.714f, -0.05f},
          {0.33f * s.x, 0.85f, -0.05f}, 0.03f, 0.028f, 20);
    k.rod(chrome, {0.33f * s.x, 0.84f, -0.05f}, {0.33f * s.x, 0.89f, -0.05f}, 0.007f);
    k.piece.clearance_front_m = 0.7f;
    k.piece.against_wall = true;
}
void mirror(Kit& k) {
    Vec3f s = k.wanted({0.7f, 0.9f, 0.03f});
    if (k.request.pattern == "round") s.x = s.y = std::min(s.x, s.y);
    if (k.request.pattern == "arched") s.y = std::max(s.y, 1.35f * s.x);
    const bool rounded = is_one_of(k.request.pattern, {"round", "oval"}) || k.style.lamp == LampFamily::globe ||
                         k.style.lamp == LampFamily::paper;
    const int frame = k.main(k.style.mouldings == Mouldings::rich || k.style.metal.metal > 0.5f ? k.style.metal
                                                                                                : k.style.wood);
    Material m = plain("mirror", {0.85f, 0.85f, 0.85f}, 0.05f);
    m.mirror = 1.f;
    const int silver = k.material(m);
    const float f = k.style.mouldings == Mouldings::rich ? 0.06f : 0.025f;
    auto o = shapes::rounded_rectangle(s.x - f, s.y - f, rounded ? 0.5f * (std::min(s.x, s.y) - f) - 1e-4f : 0.8f * f,
                                       10);
    if (k.request.pattern == "arched") {  // a half circle on upright sides
        const float half = 0.5f * (s.x - f), foot = -0.5f * (s.y - f), spring = 0.5f * (s.y - f) - half;
        o = {{-half, foot}, {half, foot}};
        for (int i = 0; i <= 24; ++i)
            o.push_back(Vec2f{half * std::cos(kPi * static_cast<float>(i) / 24.f),
                              spring + half * std::sin(kPi * static_cast<float>(i) / 24.f)});
    }
    auto below = o;  // turned up, z runs down
    for (Vec2f& p : below) p.y = -p.y;
    Mesh pane = shapes::prism(below, 0.004f, 0.012f, 0.002f);
    shapes::turn(pane, {1, 0, 0}, 90);
    k.add(std::move(pane), silver, {0, 0.5f * s.y, 0});
    std::vector<Vec3f> path;
    for (const Vec2f p : o) path.push_back({p.x, 0.5f * s.y + p.y, 0.014f});
    path.push_back(path.front());
    k.add(shapes::tube(path, 0.5f * f, 10), frame);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.1f;
}
void towel_rail(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric, k.accent())), chrome = k.material(k.style.metal);
    for (const float sx : {-1.f, 1.f}) k.rod(chrome, {sx * 0.29f, 0.5f, 0}, {sx * 0.29f, 0.5f, 0.075f}, 0.01f);
    k.rod(chrome, {-0.3f, 0.5f, 0.07f}, {0.3f, 0.5f, 0.07f}, 0.009f);
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(24, 24, 0.008f,
                       [=](float u, float v) {
                           const float x = (u - 0.5f) * 0.42f, run = (v - 0.45f) * 1.05f,
                                       over = std::min(std::fabs(run), 0.03f);
                           const float side = run < 0 ? 1.f : -1.f, hang = std::max(0.f, std::fabs(run) - 0.03f);
                           return Vec3f{x, 0.518f - 0.2f * over - hang,
                                        0.07f + side * (0.55f * over + 0.01f * hang) +
                                            0.007f * std::min(1.f, 6.f * hang) *
                                                (std::sin(x * 26.f) + shapes::wobble({x * 9, v * 3, 0}, seed))};
                       }),
          cloth);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.8f;
}
void radiator(Kit& k) {
    const int white = k.main(plain("radiator enamel", {0.76f, 0.76f, 0.74f}, 0.3f));
    for (int i = 0; i < 14; ++i)
        k.soft(white, {-0.455f + 0.07f * static_cast<float>(i), 0.1f, 0}, {0.06f, 0.56f, 0.1f},
               {0.025f, 0.004f, 0.f, 3});
    for (const float y : {0.18f, 0.58f}) k.rod(white, {-0.47f, y, 0}, {0.47f, y, 0}, 0.02f);
    for (const float x : {-0.4f, 0.4f}) k.board(white, {x, 0, 0}, {0.03f, 0.12f, 0.06f});
    k.piece.against_wall = true;
}
void fireplace(Kit& k) {
    Material stone = k.style.mouldings == Mouldings::none ? k.style.accent_wall : *material_named("marble");
    const int body = k.main(stone), soot = k.material(plain("soot", {0.035f, 0.032f, 0.03f}, 0.95f)),
              top = k.material(k.style.mouldings == Mouldings::rich ? stone : k.style.wood);
    Material wood = plain("log", {0.2f, 0.12f, 0.07f}, 0.9f);
    wood.pattern = Pattern::bark;
    wood.scale_m = 0.05f;
    wood.color_b = {0.06f, 0.04f, 0.03f};
    const int log = k.material(wood), fire = k.material(flame("fire", {13.f, 3.f, 0.3f})),
              embers = k.material(flame("embers", {6.f, 0.9f, 0.06f}));
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * 0.56f, 0, 0}, {0.28f, 1.02f, 0.36f}, 0.01f);
    k.board(body, {0, 0.72f, 0}, {0.842f, 0.3f, 0.36f}, 0.008f);
    k.board(soot, {0, 0.03f, -0.16f}, {0.842f, 0.7f, 0.04f});
    k.board(body, {0, 0, 0.08f}, {1.5f, 0.035f, 0.56f}, 0.006f);
    k.board(top, {0, 1.02f, 0.02f}, {1.54f, 0.055f, 0.42f}, 0.008f);
    for (int i = 0; i < 3; ++i)
        k.rod(log, {-0.24f, 0.075f + (i == 2 ? 0.075f : 0.f), 0.f + 0.1f * static_cast<float>(i % 2)},
              {0.24f, 0.08f + (i == 2 ? 0.08f : 0.f), 0.03f + 0.07f * static_cast<float>(i % 2)}, 0.04f, 0.036f, 12);
    // Tongues that lick to one side and end in a point, the highest in the middle; embers between the logs.
    for (int i = 0; i < 11; ++i) {
        const float x = -0.2f + 0.04f * static_cast<float>(i), h = k.dice.uniform(0.13f, 0.3f) * (1.f - 9.f * x * x),
                    lean = k.dice.uniform(-0.3f, 0.3f);
        const std::array<Vec2f, 6> p{Vec2f{0, 0},        {0.026f, 0.12f * h}, {0.03f, 0.3f * h},
                                     {0.017f, 0.6f * h}, {0.006f, 0.85f * h}, {0, h}};
        Mesh tongue = shapes::lathe(shapes::curve(p, 2), 10, true);
        for (Vec3f& q : tongue.positions)
            q.x += lean * h * (q.y / h) * (q.y / h) + 0.012f * std::sin(22.f * q.y + static_cast<float>(i)) * q.y / h;
        shapes::smooth_normals(tongue);
        k.add(std::move(tongue), i % 3 == 1 ? embers : fire, {x, 0.11f, 0.05f + k.dice.uniform(-0.05f, 0.05f)});
    }
    k.board(embers, {0, 0.05f, 0.05f}, {0.4f, 0.03f, 0.12f}, 0.01f);
    k.top(1.075f, 0, 0.02f, 0.7f, 0.16f);
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}

constexpr Entry kFixtures[] = {{"kitchen_counter", kitchen_counter},
                               {"kitchen_island", kitchen_island},
                               {"fridge", fridge},
                               {"washing_machine", washing_machine},
                               {"toilet", toilet},
                               {"bathtub", bathtub},
                               {"shower", shower},
                               {"washbasin", washbasin},
                               {"mirror", mirror},
                               {"towel_rail", towel_rail},
                               {"radiator", radiator},
                               {"fireplace", fireplace}};

}  // namespace

std::span<const Entry> fixtures() { return kFixtures; }

}  // namespace fastscene::furniture
