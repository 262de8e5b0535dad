// A desk, and a console table.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/tables/table_parts.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {
namespace {

void put_small(Kit& k, std::string kind, Vec3f at, float turn = 0.f) { k.merge(k.small(std::move(kind)), at, turn); }

}  // namespace

void build_console_table(Kit& k) {
    plain_table(k, k.wanted({1.1f, 0.8f, 0.35f}), 0.03f);
    k.piece.against_wall = true;
}

void build_desk(Kit& k) {
    const int screens = k.request.screens;
    const Vec3f s = k.wanted(
        {std::max(1.35f, 0.25f + kMonitorStep * static_cast<float>(screens)), 0.75f, screens > 0 ? 0.72f : 0.65f});
    plain_table(k, s, 0.03f);
    k.piece.surfaces.clear();
    k.board(k.piece.main_material, {0.5f * s.x - 0.3f, s.y - 0.17f, 0.02f}, {0.38f, 0.14f, s.z - 0.2f});
    const int metal = k.material(k.style.metal), dark = k.material(plain("dark plastic", {0.04f, 0.04f, 0.043f}, 0.4f)),
              alu = k.material(plain("aluminium", {0.5f, 0.51f, 0.52f}, 0.35f));
    fronts(k, k.piece.main_material, metal, 0.5f * s.x - 0.49f, 0.5f * s.x - 0.11f, s.y - 0.17f, s.y - 0.03f,
           0.5f * s.z - 0.08f, 1, 1);
    k.piece.clearance_front_m = 0.8f;
    k.piece.against_wall = true;
    if (screens > 0) {
        // A keyboard and a mouse before the monitors that come; all of the top's back is theirs.
        k.board(dark, {0, s.y, 0.17f}, {0.42f, 0.016f, 0.13f}, 0.005f);
        k.board(alu, {0, s.y + 0.015f, 0.17f}, {0.4f, 0.004f, 0.112f}, 0.001f);
        k.board(dark, {0.3f, s.y, 0.18f}, {0.06f, 0.03f, 0.1f}, 0.013f);
        k.top(s.y, 0, -0.13f, 0.5f * s.x - 0.02f, 0.5f * s.z - 0.15f);
        return;
    }
    // The laptop faces who sits at the front (+z).
    k.board(alu, {0, s.y, 0.06f}, {0.34f, 0.014f, 0.24f}, 0.004f);
    k.board(dark, {0, s.y + 0.0135f, 0.03f}, {0.29f, 0.002f, 0.11f}, 0.0005f);
    Mesh lid = shapes::box({0.34f, 0.23f, 0.008f}, 0.003f), face = screen_box({0.315f, 0.205f, 0.002f});
    shapes::move(face, {0, -0.1025f, 0.0045f});
    for (Mesh* m : {&lid, &face}) shapes::move(shapes::turn(*m, {1, 0, 0}, -16), {0, s.y + 0.122f, -0.09f});
    k.add(lid, alu);
    k.add(face, lit_screen(k, Shown::desktop, kMonitorWhite, 0.315f));
    put_small(k, "book_stack", {0.5f * s.x - 0.25f, s.y, -0.08f}, 12);
    const std::array<Vec2f, 2> cup{Vec2f{0.036f, 0}, {0.04f, 0.09f}};
    k.add(shapes::vessel(cup, 0.004f, 18), k.material(plain("mug", k.accent(), 0.3f)), {0.3f, s.y, 0.14f});
    // Room for a lamp and more at the left.
    k.top(s.y, -0.25f * s.x - 0.09f, -0.01f, 0.25f * s.x - 0.1f, 0.5f * s.z - 0.04f);
}

}  // namespace fastscene::furniture
