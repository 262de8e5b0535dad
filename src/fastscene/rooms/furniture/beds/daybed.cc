// A day bed: its long side stands at the wall.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/seats/upholstery.h"

namespace fastscene::furniture {

// A sofa to sleep on: its long side at the wall, a back and two ends of one height.
void build_daybed(Kit& k) {
    using enum DaybedForm;
    DaybedForm form = form_for(k, k.style.forms.daybed);
    if (k.request.material == "iron" || k.request.material == "metal" || k.request.material == "wrought iron")
        form = iron;
    const float long_side = 2.04f, deep = 0.98f, hx = 0.5f * long_side, hz = 0.5f * deep,
                base = form == padded ? 0.3f : 0.28f, top = base + 0.17f, high = form == iron ? 0.92f : 0.8f;
    Material sheet = tinted(k.style.fabric, lerp(k.style.fabric.color_a, {0.74f, 0.71f, 0.66f}, 0.45f));
    const int cloth = k.main(sheet), frame = k.material(form == iron ? k.style.metal : k.style.wood);
    const bool colored = k.request.color || !k.request.color_name.empty();
    const auto ends = [&](auto&& each) {
        for (const float s : {-1.f, 1.f}) each(Vec3f{s * hx, 0, -hz}, Vec3f{s * hx, 0, hz});
        each(Vec3f{-hx, 0, -hz}, Vec3f{hx, 0, -hz});
    };
    if (form == boards) {
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {-1.f, 1.f}) k.board(frame, {sx * hx, 0, sz * hz}, {0.055f, high, 0.055f}, 0.012f);
        const bool bars = k.style.legs == LegType::turned || k.style.legs == LegType::splayed ||
                          k.style.legs == LegType::tapered;
        ends([&](Vec3f a, Vec3f b) {
            const bool along_x = a.z == b.z;
            const float far = along_x ? b.x - a.x : b.z - a.z;
            const auto bar = [&](float y, float tall, float thick) {
                k.board(frame, (a + b) * 0.5f + Vec3f{0, y, 0},
                        along_x ? Vec3f{far, tall, thick} : Vec3f{thick, tall, far}, 0.007f);
            };
            bar(high - 0.075f, 0.06f, 0.034f);
            if (!bars) return bar(top - 0.06f, high - top - 0.04f, 0.022f);
            const int count = static_cast<int>(far / 0.12f);
            for (int i = 1; i < count; ++i)
                k.rod(frame, lerp(a, b, static_cast<float>(i) / static_cast<float>(count)) + Vec3f{0, base - 0.06f, 0},
                      lerp(a, b, static_cast<float>(i) / static_cast<float>(count)) + Vec3f{0, high - 0.06f, 0}, 0.01f,
                      -1, 8);
        });
    } else if (form == iron) {
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {-1.f, 1.f}) {
                k.rod(frame, {sx * hx, 0, sz * hz}, {sx * hx, high - (sz > 0 ? 0.1f : 0.f), sz * hz}, 0.017f, -1, 12);
                k.add(shapes::ball({sx * hx, high + 0.02f - (sz > 0 ? 0.1f : 0.f), sz * hz}, {0.028f, 0.028f, 0.028f},
                                   12),
                      frame);
            }
        ends([&](Vec3f a, Vec3f b) {
            // The upper bar swings up in the middle of the back, and falls to the front at the ends.
            const bool back = a.z == b.z;
            const auto crest = [=](float u) {
                return back ? high - 0.05f + 0.1f * std::sin(kPi * u) * std::sin(kPi * u) : high - 0.05f - 0.1f * u * u;
            };
            std::vector<Vec3f> path;
            for (int i = 0; i <= 20; ++i)
                path.push_back(lerp(a, b, static_cast<float>(i) / 20.f) +
                               Vec3f{0, crest(static_cast<float>(i) / 20.f), 0});
            k.add(shapes::tube(path, 0.012f, 8), frame);
            k.rod(frame, a + Vec3f{0, top, 0}, b + Vec3f{0, top, 0}, 0.01f, -1, 8);
            const int count = back ? 15 : 7;
            for (int i = 1; i < count; ++i) {
                const float u = static_cast<float>(i) / static_cast<float>(count);
                k.rod(frame, lerp(a, b, u) + Vec3f{0, top, 0}, lerp(a, b, u) + Vec3f{0, crest(u), 0}, 0.007f, -1, 8);
            }
        });
    } else {
        const int cover = colored
                              ? k.material(tinted(k.style.fabric2,
                                                  k.piece.materials[static_cast<std::size_t>(cloth)].color_a * 0.85f))
                              : k.material(k.style.fabric2);
        for (const float s : {-1.f, 1.f})
            k.soft(cover, {s * (hx - 0.01f), 0.1f, 0}, {0.12f, high - 0.2f, deep}, {0.045f, 0.016f, 0.001f, 10});
        k.soft(cover, {0, 0.1f, -hz + 0.05f}, {long_side - 0.1f, high - 0.1f, 0.12f}, {0.045f, 0.016f, 0.001f, 14});
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {-1.f, 1.f})
                k.rod(frame, {sx * (hx - 0.05f), 0, sz * (hz - 0.08f)}, {sx * (hx - 0.05f), 0.13f, sz * (hz - 0.08f)},
                      0.018f, 0.026f, 12);
    }
    const float low = form == padded ? 0.13f : base - 0.1f;
    k.board(frame, {0, low, 0.01f}, {long_side - 0.08f, base - low, deep - 0.05f}, 0.008f);
    const float inside = long_side - (form == padded ? 0.16f : 0.08f), z0 = form == padded ? 0.055f : 0.01f,
                wide = deep - (form == padded ? 0.13f : 0.06f);
    k.soft(cloth, {0, base - 0.005f, z0}, {inside, top - base + 0.02f, wide}, {0.05f, 0.018f, 0.003f, 18});
    // Cushions along the back, a bolster at each end, a throw over the front.
    const int second = accent_cloth(k), third = accent_cloth(k),
              light = k.material(tinted(k.style.fabric, {0.72f, 0.7f, 0.65f}));
    const std::array<int, 4> cushions{light, second, cloth, third};
    const float back = z0 - 0.5f * wide;
    for (int i = 0; i < 4; ++i) {
        const float s = i % 3 == 0 ? 0.52f : 0.46f;
        put_pillow(
            k, cushions[static_cast<std::size_t>(i)],
            {inside * (0.2f * static_cast<float>(i) - 0.3f) + k.rng.uniform(-0.02f, 0.02f), top + 0.005f, back + 0.2f},
            {s, s, 0.17f}, 19.f, k.rng.uniform(-7, 7));
    }
    for (const float s : {-1.f, 1.f}) {
        const std::array<Vec2f, 8> p{Vec2f{0.02f, 0}, {0.07f, 0.006f},  {0.092f, 0.035f}, {0.097f, 0.1f},
                                     {0.097f, 0.44f}, {0.092f, 0.505f}, {0.07f, 0.534f},  {0.02f, 0.54f}};
        Mesh roll = shapes::lathe(p, 22, true);
        shapes::turn(roll, {1, 0, 0}, 90);
        k.add(std::move(roll), cloth, {s * (0.5f * inside - 0.105f), top + 0.1f, back + 0.32f});
    }
    k.top(top + 0.015f, 0, 0.2f, 0.34f * inside, 0.2f);
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
