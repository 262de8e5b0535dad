// Tapestry.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

// ---- cloth

// A rod for a hanging, with balls at its ends and a cord over a nail.
void hanging_rod(Kit& k, int wood, float half, float y, float z, float r) {
    k.rod(wood, {-half, y, z}, {half, y, z}, r, -1, 14);
    for (const float sx : {-1.f, 1.f}) k.add(shapes::ball({sx * half, y, z}, {1.5f * r, 1.5f * r, 1.5f * r}, 12), wood);
    const int cord = k.material(plain("cord", {0.58f, 0.5f, 0.37f}, 0.9f));
    const std::array<Vec3f, 3> path{Vec3f{-0.86f * half, y, z}, {0, y + 0.3f * half, 0.01f}, {0.86f * half, y, z}};
    k.add(shapes::tube(std::array{path[0], lerp(path[0], path[1], 0.5f), path[1]}, 0.0028f, 6), cord);
    k.add(shapes::tube(std::array{path[1], lerp(path[1], path[2], 0.5f), path[2]}, 0.0028f, 6), cord);
    k.rod(k.material(k.style.metal), {0, y + 0.3f * half - 0.004f, 0}, {0, y + 0.3f * half - 0.004f, 0.02f}, 0.004f, -1,
          8);
}

}  // namespace

// A woven cloth: medallions with a border where rooms are formal, else a sun over hills.
void build_tapestry(Kit& k) {
    const Vec3f s = k.wanted({1.15f, 1.45f, 0.04f});
    const bool woven = k.style.tapestry == TapestryForm::medallions ||
                       is_one_of(k.request.pattern, {"damask", "floral"});
    const float half = 0.5f * s.x, hem = 0.1f, top = s.y - 0.3f * (half + 0.05f) - 0.01f, fringe = 0.1f;
    const int wood = k.material(k.style.wood);
    hanging_rod(k, wood, half + 0.04f, top, 0.022f, 0.011f);
    const float phase = k.rng.uniform(0, kTau);
    const auto cloth_at = [&](float x, float y, float out) {
        return Vec3f{x, y,
                     0.016f + out + 0.0045f * std::sin(9.f * x / s.x * 2.2f + phase) * std::min(1.f, (top - y) / 0.4f)};
    };
    const auto field = [&](const std::function<Vec2f(float, float)>& at, int columns, int rows, float out,
                           int material) {
        k.add(shapes::sheet(columns, rows,
                            [&](float u, float v) {
                                const Vec2f p = at(u, v);
                                return cloth_at(p.x, p.y, out);
                            }),
              material);
    };
    Material ground = k.style.rug;
    if (woven) {
        ground.pattern = Pattern::rug;
        ground.seed = std::array<std::uint32_t, 4>{4, 6, 7, 11}[static_cast<std::size_t>(k.rng.index(4))];
        ground.scale_m = half;
    } else {
        ground = k.style.fabric;
        ground.name = "tapestry";
        ground.color_a = lerp(k.style.palette[4 % k.style.palette.size()], {0.68f, 0.6f, 0.46f}, 0.75f);
        ground.color_b = ground.color_a * 0.9f;
    }
    ground.bump_m = 0.001f;
    const int main = k.main(ground);
    Mesh base = shapes::slab(
        40, 12, 0.003f, [&](float u, float v) { return cloth_at(s.x * (u - 0.5f), fringe + (top - fringe) * v, 0.f); });
    if (woven)
        for (std::size_t i = 0; i < base.coords.size(); ++i)
            base.coords[i] = {base.positions[i].x, 0.5f * (top - fringe), base.positions[i].y - 0.5f * (top + fringe)};
    k.add(std::move(base), main);
    if (!woven) {
        const auto yarn = [&](Vec3f color) {
            Material m = plain("yarn", color, 0.95f);
            m.pattern = Pattern::fabric;
            m.scale_m = 0.006f;
            m.color_b = m.color_a * 0.85f;
            m.specular = 0.02f;
            return k.material(m);
        };
        const float r = 0.2f * s.x;
        const Vec2f sun{0.04f * s.x, fringe + 0.66f * (top - fringe)};
        const int gold = yarn(lerp(k.style.palette[1], {0.6f, 0.36f, 0.08f}, 0.4f)),
                  rust = yarn(lerp(k.style.palette[0], {0.42f, 0.15f, 0.06f}, 0.4f));
        field(
            [&](float u, float v) {
                return sun + Vec2f{std::cos(kTau * u), std::sin(kTau * u)} * (r * (0.02f + 0.98f * (1.f - v)));
            },
            40, 3, 0.0016f, gold);
        for (int i = 0; i < 20; ++i) {  // rays
            const float a = kTau * static_cast<float>(i) / 20.f, from = 1.14f * r, to = (i % 2 ? 1.42f : 1.6f) * r;
            const Vec2f d{std::cos(a), std::sin(a)}, side{-d.y, d.x};
            field(
                [&](float u, float v) {
                    return sun + d * (from + (to - from) * u) + side * ((v - 0.5f) * 0.02f * s.x * (1.2f - u));
                },
                3, 1, 0.0016f, rust);
        }
        // Hills, the nearer the darker.
        for (int i = 0; i < 4; ++i) {
            const float high = fringe + (top - fringe) * (0.46f - 0.115f * static_cast<float>(i)),
                        p = k.rng.uniform(0, kTau), swing = 0.05f * s.y;
            const int hill = i == 0
                                 ? rust
                                 : yarn(lerp(k.style.palette[static_cast<std::size_t>(i + 1) % k.style.palette.size()],
                                             {0.2f, 0.12f, 0.07f}, 0.14f * static_cast<float>(i)));
            field(
                [&](float u, float v) {
                    const float x = (u - 0.5f) * (s.x - 0.012f);
                    return Vec2f{x, std::lerp(fringe + 0.004f,
                                              high + swing * std::sin(5.f * x / s.x + p) +
                                                  0.4f * swing * std::sin(11.f * x / s.x + 2 * p),
                                              v)};
                },
                40, 6, 0.0026f + 0.001f * static_cast<float>(i), hill);
        }
    }
    // Fringe: bundles of threads.
    Mesh threads;
    const int count = static_cast<int>(s.x / 0.021f);
    for (int i = 0; i < count; ++i) {
        const Vec3f from = cloth_at(s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f),
                                    fringe + 0.004f, 0.f);
        shapes::append(threads,
                       shapes::rod(from,
                                   from + Vec3f{k.rng.uniform(-0.004f, 0.004f), -(hem - k.rng.uniform(0.f, 0.012f)),
                                                k.rng.uniform(-0.002f, 0.003f)},
                                   0.0032f, 0.0046f, 6));
    }
    k.add(std::move(threads),
          k.material(plain("fringe",
                           lerp(k.piece.materials[static_cast<std::size_t>(main)].color_a, {0.66f, 0.6f, 0.48f}, 0.6f),
                           0.95f)));
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.85f;
}

}  // namespace fastscene::furniture
