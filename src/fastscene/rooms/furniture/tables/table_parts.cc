// Table tops on legs, and the cloth on them.
#include "fastscene/rooms/furniture/tables/table_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fastscene/rooms/drape.h"

namespace fastscene::furniture {
namespace {

int leg_material(Kit& k, int wood) {
    return k.style.legs == LegType::metal_frame || k.style.legs == LegType::hairpin ? k.material(k.style.metal) : wood;
}

int table_linen(Kit& k) {
    Material cloth = k.style.fabric;
    const bool said = !k.request.holder_color.empty();
    const Vec3f color = said ? *color_named(k.request.holder_color) : Vec3f{0.74f, 0.72f, 0.68f};
    cloth.color_a = cloth.color_c = color, cloth.color_b = color * 0.85f;
    cloth.name = "tablecloth";
    k.print(cloth, said ? std::optional(color) : std::nullopt);
    return k.material(cloth);
}

// What stands on the table stands on its cloth.
void raise_tops(Kit& k, float to) {
    for (Surface& s : k.piece.surfaces) s.center.y = std::max(s.center.y, to);
}

}  // namespace

void plain_table(Kit& k, Vec3f s, float thick) {
    const int wood = k.main(k.style.wood, k.request.holder_material != kTableCloth), leg = leg_material(k, wood);
    k.board(wood, {0, s.y - thick, 0}, {s.x, thick, s.z}, 0.006f);
    const float t = std::min(0.07f, 0.14f * s.y + 0.01f), in = 0.06f;
    legs(k, leg, 0.5f * s.x - in - 0.5f * t, 0.5f * s.z - in - 0.5f * t, s.y - thick + 0.002f, t);
    const float apron = std::min(0.08f, 0.18f * s.y);
    for (const float sg : {-1.f, 1.f}) {
        k.board(leg, {0, s.y - thick - apron, sg * (0.5f * s.z - in - 0.03f)}, {s.x - 2 * in - t, apron, 0.022f});
        k.board(leg, {sg * (0.5f * s.x - in - 0.03f), s.y - thick - apron, 0}, {0.022f, apron, s.z - 2 * in - t});
    }
    k.top(s.y, 0, 0, 0.46f * s.x, 0.46f * s.z);
}

void round_table(Kit& k, float d, float y, float thick) {
    const int wood = k.main(k.style.wood, k.request.holder_material != kTableCloth), leg = leg_material(k, wood);
    k.add(shapes::prism(shapes::circle(0.5f * d, 48), y - thick, y, 0.006f), wood);
    if (y > 0.6f && k.style.legs != LegType::splayed) {
        const std::array<Vec2f, 8> p{Vec2f{0.26f * d, 0},
                                     {0.26f * d, 0.025f},
                                     {0.06f * d, 0.06f},
                                     {0.04f * d, 0.2f * y},
                                     {0.05f * d, 0.5f * y},
                                     {0.04f * d, 0.8f * y},
                                     {0.12f * d, y - thick - 0.01f},
                                     {0.12f * d, y - thick + 0.002f}};
        k.add(shapes::lathe(p, 32), leg);
    } else {
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + 0.5f;
            k.rod(leg, {0.42f * d * std::cos(a), 0, 0.42f * d * std::sin(a)},
                  {0.3f * d * std::cos(a), y - thick + 0.002f, 0.3f * d * std::sin(a)}, 0.012f, 0.02f);
        }
    }
    k.top(y, 0, 0, 0.33f * d, 0.33f * d);
}

void drape_cloth_over(Kit& k, Vec3f s, float down) {
    constexpr float kThick = 0.003f, kBillow = 0.03f, kEdge = 0.012f;  // metres; kBillow: of folds beyond the top
    // Between the points that are simulated cloth takes a short cut: it stays this far from the top, farther from its
    // rim.
    constexpr float kCell = 0.035f, kAbove = 0.014f, kBeside = 0.028f;
    const int linen = table_linen(k);
    const Vec3f half{0.5f * s.x + kBeside, 0.5f * (s.y + kAbove), 0.5f * s.z + kBeside};
    const DrapeSolid table{{0, half.y, 0}, half, kEdge};
    Cloth cloth;
    cloth.low = {-half.x - down, -half.z - down}, cloth.high = {half.x + down, half.z + down};
    cloth.most = {half.x + kThick + kBillow, half.z + kThick + kBillow};
    cloth.from_y = 2 * half.y + 0.01f;
    cloth.slack = 0;  // it lies flat on the top
    cloth.stiffness = 0.12f;
    cloth.clear_m = kThick;
    cloth.cell_m = kCell;
    cloth.seed = k.seed();
    Mesh mesh = cloth_mesh(drape(cloth, {&table, 1}), kThick, 0.03f);
    // At the corners cloth is stretched: what is still inside comes out through the nearest side.
    for (Vec3f& p : mesh.positions) {
        const float top = 2 * half.y - p.y, x = half.x - std::fabs(p.x), z = half.z - std::fabs(p.z);
        if (top <= 0 || x <= 0 || z <= 0) continue;
        if (top <= x && top <= z) p.y += top;
        else if (x <= z) p.x += std::copysign(x, p.x);
        else p.z += std::copysign(z, p.z);
    }
    shapes::smooth_normals(mesh);
    k.add(std::move(mesh), linen);
    raise_tops(k, s.y + kAbove + kThick);
}

void lay_cloth_on(Kit& k, std::span<const Vec2f> rim, float y, float down) {
    const int linen = table_linen(k);
    std::vector<float> along{0.f};  // metres along the rim
    for (std::size_t i = 0; i < rim.size(); ++i)
        along.push_back(along.back() + length(rim[(i + 1) % rim.size()] - rim[i]));
    constexpr float kOver = 0.004f, kLift = 0.003f, kFold = 0.16f;
    const float folds = std::round(along.back() / kFold);
    Mesh m;
    const int columns = static_cast<int>(along.back() / 0.02f), hem = 12;
    const auto at = [&](int c, int row) {
        const float s = along.back() * static_cast<float>(c % columns) / static_cast<float>(columns);
        std::size_t i = 0;
        while (i + 2 < along.size() && along[i + 1] <= s) ++i;
        const Vec2f a = rim[i], b = rim[(i + 1) % rim.size()],
                    p = a + (b - a) * ((s - along[i]) / std::max(1e-6f, along[i + 1] - along[i]));
        const Vec2f run = (b - a) * (1.f / std::max(1e-6f, length(b - a))), across{run.y, -run.x},
                    out = across.x * p.x + across.y * p.y < 0 ? across * -1.f : across;
        if (row == 0) return std::pair{Vec3f{0, y + kLift, 0}, Vec3f{0, 0, 0}};
        const float drop = down * static_cast<float>(row - 1) / static_cast<float>(hem),
                    wave = 0.5f + 0.5f * std::sin(kTau * folds * s / along.back()),
                    spread = kOver + (row > 1 ? 0.02f + 0.03f * wave * drop / down : 0.f);
        const Vec2f q = p + out * spread;
        return std::pair{Vec3f{q.x, y + kLift - drop * (row > 1 ? 1.f : 0.f), q.y},
                         Vec3f{p.x + out.x * drop, 0, p.y + out.y * drop}};
    };
    for (int row = 0; row <= hem + 1; ++row)
        for (int c = 0; c <= columns; ++c) {
            const auto [p, q] = at(c, row);
            m.positions.push_back(p);
            m.coords.push_back({q.x, q.z, 0});
        }
    const auto id = [&](int c, int row) { return static_cast<std::uint32_t>(row * (columns + 1) + c); };
    for (int row = 0; row <= hem; ++row)
        for (int c = 0; c < columns; ++c) {
            // Seen from above the rim runs counter-clockwise about +y: outward is up and out.
            if (row > 0) m.triangles.insert(m.triangles.end(), {id(c, row), id(c + 1, row), id(c, row + 1)});
            m.triangles.insert(m.triangles.end(), {id(c + 1, row), id(c + 1, row + 1), id(c, row + 1)});
        }
    m.normals.assign(m.positions.size(), Vec3f{0, 1, 0});
    shapes::smooth_normals(m);
    // The top is flat, whatever the rim does.
    for (int row = 0; row <= 1; ++row)
        for (int c = 0; c <= columns; ++c) m.normals[id(c, row)] = {0, 1, 0};
    k.add(std::move(m), linen);
    raise_tops(k, y + kLift);
}

bool has_cloth(const Kit& k) { return k.request.holder_material == kTableCloth; }

}  // namespace fastscene::furniture
