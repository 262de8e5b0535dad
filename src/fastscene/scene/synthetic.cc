#include "fastscene/scene/synthetic.h"

#include <cmath>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

// A pattern on the plane, as a factor around 1.
float pattern(SyntheticPaint paint, float u, float v) {
    const auto cell = [](float x) { return static_cast<int>(std::floor(x)); };
    switch (paint) {
        case SyntheticPaint::plain: return 1.f;
        case SyntheticPaint::smooth: return 1.f + 0.2f * std::sin(4.f * u) * std::sin(3.f * v + 1.f);
        case SyntheticPaint::checker: return ((cell(u / 0.25f) + cell(v / 0.25f)) & 1) != 0 ? 0.7f : 1.1f;
        case SyntheticPaint::planks: {
            const int plank = cell(u / 0.14f);
            const float along = v / 1.2f + 0.37f * static_cast<float>(plank);
            Random r(static_cast<std::uint64_t>(static_cast<std::int64_t>(plank) * 7919 + cell(along)));
            const float seam = u / 0.14f - static_cast<float>(plank);
            return (seam < 0.05f ? 0.6f : 1.f) * r.uniform(0.75f, 1.1f);
        }
    }
    return 1.f;
}

// Color of a box's face at p; faces are shaded by their axis, so that edges are visible.
Vec3f face_color(const SyntheticBox& box, SyntheticPaint paint, std::size_t axis, bool high, Vec3f p) {
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    const float shade = axis == 1 ? (high ? 0.75f : 1.f) : axis == 0 ? (high ? 0.82f : 0.88f) : (high ? 0.92f : 0.78f);
    return box.color * (shade * pattern(paint, p[a], p[b]));
}

}  // namespace

SyntheticWorld SyntheticWorld::furnished(SyntheticPaint walls, SyntheticPaint floor) {
    SyntheticWorld world;
    world.room = {{-2.4f, -1.2f, -2.8f}, {2.6f, 1.5f, 3.2f}, {0.75f, 0.72f, 0.66f}, walls};
    world.floor = floor;
    world.boxes = {{{-0.6f, 0.7f, 1.2f}, {0.7f, 1.5f, 1.9f}, {0.55f, 0.25f, 0.12f}, SyntheticPaint::smooth},  // table
                   {{1.9f, -0.7f, -1.f}, {2.6f, 1.5f, 0.4f}, {0.2f, 0.35f, 0.5f}, SyntheticPaint::plain},  // cupboard
                   {{-2.f, 0.8f, -1.9f}, {-0.4f, 1.5f, -1.1f}, {0.3f, 0.5f, 0.25f}, SyntheticPaint::smooth},  // sofa
                   {{-1.7f, 0.2f, 0.7f}, {-1.6f, 1.5f, 0.8f}, {0.1f, 0.1f, 0.1f}, SyntheticPaint::plain}};  // lamp post
    return world;
}

SyntheticHit trace_synthetic(const SyntheticWorld& world, Vec3f origin, Vec3f d) {
    SyntheticHit hit{std::numeric_limits<float>::infinity(), {}};
    const auto slabs = [&](const SyntheticBox& box, float& enter, float& leave, std::size_t& enter_axis,
                           std::size_t& leave_axis) {
        enter = -std::numeric_limits<float>::infinity();
        leave = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < 3; ++i) {
            if (d[i] == 0.f) {
                if (origin[i] < box.low[i] || origin[i] > box.high[i]) leave = -1;
                continue;
            }
            const float a = ((d[i] > 0 ? box.low[i] : box.high[i]) - origin[i]) / d[i],
                        b = ((d[i] > 0 ? box.high[i] : box.low[i]) - origin[i]) / d[i];
            if (a > enter) enter = a, enter_axis = i;
            if (b < leave) leave = b, leave_axis = i;
        }
    };
    float enter = 0, leave = 0;
    std::size_t in = 0, out = 0;
    slabs(world.room, enter, leave, in, out);
    hit.range = leave;
    const bool is_floor = out == 1 && d.y > 0;
    hit.color = face_color(world.room, is_floor ? world.floor : world.room.paint, out, d[out] > 0, origin + d * leave);
    if (is_floor) hit.color = hit.color * Vec3f{0.8f, 0.6f, 0.4f};
    for (const SyntheticBox& box : world.boxes) {
        slabs(box, enter, leave, in, out);
        if (!(enter > 0.f && enter < leave && enter < hit.range)) continue;
        hit.range = enter;
        hit.color = face_color(box, box.paint, in, d[in] < 0, origin + d * enter);
    }
    return hit;
}

Panorama render_synthetic(const SyntheticWorld& world, Vec3f position, EquirectSize size, int samples) {
    Panorama out;
    out.color = ImageColor(size.width, size.height);
    out.range = ImageF(size.width, size.height);
    out.world_from_pano.translation = position;
    const float step = 1.f / static_cast<float>(samples);
    parallel_for(size.height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < size.width; ++x) {
                Vec3f sum;
                for (int j = 0; j < samples; ++j)
                    for (int i = 0; i < samples; ++i) {
                        const Vec2f at{static_cast<float>(x) + (static_cast<float>(i) + 0.5f) * step,
                                       static_cast<float>(y) + (static_cast<float>(j) + 0.5f) * step};
                        sum += trace_synthetic(world, position, direction_at(at, size)).color;
                    }
                out.color.at(x, y) = sum * (step * step);
                out.range.at(x, y) = trace_synthetic(world, position, direction_of_pixel(x, y, size)).range;
            }
    });
    return out;
}

}  // namespace fastscene
