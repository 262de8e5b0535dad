// A closed room with boxes, and the same boxes on a stage in front of nothing, with procedural textures: views, points
// and ground truth within a second, without files.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/scene/view.h"

namespace fastscene::bench {

struct Box {
    Vec3f low, high;
};
struct RoomHit {
    float range = 1e9f;
    Vec3f normal;
    int surface = -1;
    explicit operator bool() const { return surface >= 0; }
};

// The room is seen from inside, the boxes from outside. The stage is only a slab of the room's floor, surrounded by
// black.
class TexturedRoom {
  public:
    explicit TexturedRoom(bool stage = false)
        : stage_(stage), boxes_{{{-2.5f, -1.4f, -2.f}, {2.5f, 1.2f, 2.f}},
                                {{-2.5f, 0.3f, -1.f}, {-1.7f, 1.2f, 1.f}},
                                {{0.7f, 0.5f, 1.1f}, {1.9f, 1.2f, 2.f}},
                                {{1.8f, -0.8f, -2.f}, {2.5f, 1.2f, -1.1f}},
                                {{-0.4f, 0.85f, -1.9f}, {0.5f, 1.2f, -1.2f}},
                                {{-1.3f, 0.75f, 1.3f}, {-0.6f, 0.8f, 1.9f}},
                                {{1.2f, 0.1f, 1.3f}, {1.4f, 0.5f, 1.5f}}} {
        if (stage) boxes_[0].low.y = boxes_[0].high.y, boxes_[0].high.y += 0.1f;
    }

    RoomHit hit(Vec3f origin, Vec3f direction) const {
        RoomHit best;
        for (std::size_t b = 0; b < boxes_.size(); ++b) {
            float enter = -1e9f, leave = 1e9f;
            std::size_t enter_axis = 0, leave_axis = 0;
            for (std::size_t a = 0; a < 3; ++a) {
                const float inv = 1.f / direction[a];
                float t0 = (boxes_[b].low[a] - origin[a]) * inv, t1 = (boxes_[b].high[a] - origin[a]) * inv;
                if (t0 > t1) std::swap(t0, t1);
                if (t0 > enter) enter = t0, enter_axis = a;
                if (t1 < leave) leave = t1, leave_axis = a;
            }
            const bool inside = b == 0 && !stage_;
            const float t = inside ? leave : enter;
            if (enter > leave || !(t > 1e-4f) || t >= best.range) continue;
            const std::size_t axis = inside ? leave_axis : enter_axis;
            best.range = t;
            best.normal = {};
            best.normal[axis] = direction[axis] > 0 ? -1.f : 1.f;
            best.surface = static_cast<int>(b * 6 + axis * 2 + (direction[axis] > 0));
        }
        return best;
    }

    // sRGB-encoded. Soft shading, stripes, checks and blotches of different sizes.
    Vec3f color(Vec3f p, const RoomHit& h) const {
        if (!h) return {};
        Random random(0x9000ull + static_cast<std::uint64_t>(h.surface));
        const Vec3f base{random.uniform(0.3f, 0.9f), random.uniform(0.3f, 0.9f), random.uniform(0.3f, 0.9f)};
        const float u = h.normal.x != 0 ? p.z : p.x, v = h.normal.y != 0 ? p.z : p.y;
        const float size = random.uniform(6.f, 22.f);
        float pattern = 0.f;
        switch (h.surface % 4) {
            case 0: pattern = 0.15f * std::tanh(4.f * std::sin(size * u) * std::sin(size * v)); break;
            case 1: pattern = 0.12f * std::tanh(6.f * std::sin(size * u)); break;
            case 2: pattern = 0.1f * std::sin(size * u + 2.f * std::sin(size * 0.7f * v)); break;
            default: pattern = 0.03f * std::sin(40.f * v); break;
        }
        const float shade = 0.75f + 0.25f * h.normal.y * -1.f + 0.1f * std::sin(1.3f * p.x + 0.9f * p.z + p.y);
        const Vec3f c = base * (shade * (1.f + pattern * 2.f));
        return {std::clamp(c.x, 0.f, 1.f), std::clamp(c.y, 0.f, 1.f), std::clamp(c.z, 0.f, 1.f)};
    }

    // Renders with `samples` x `samples` rays per pixel.
    View view(const Pinhole& camera, const Rigid& world_from_camera, int samples) const {
        View out;
        out.camera = camera;
        out.world_from_camera = world_from_camera;
        out.color = ImageRgb8(camera.width, camera.height);
        parallel_for(camera.height, 8, [&](std::int64_t begin, std::int64_t end) {
            for (int y = static_cast<int>(begin); y < end; ++y)
                for (int x = 0; x < camera.width; ++x) {
                    Vec3f sum;
                    for (int s = 0; s < samples * samples; ++s) {
                        const Vec2f at{static_cast<float>(x) +
                                           (static_cast<float>(s % samples) + 0.5f) / static_cast<float>(samples),
                                       static_cast<float>(y) +
                                           (static_cast<float>(s / samples) + 0.5f) / static_cast<float>(samples)};
                        const Vec3f d = world_from_camera.rotation * normalize(camera.direction_at(at));
                        const RoomHit h = hit(world_from_camera.translation, d);
                        sum += color(world_from_camera.translation + d * h.range, h);
                    }
                    sum *= 1.f / static_cast<float>(samples * samples);
                    out.color.at(x, y) = {byte_from_unit(sum.x), byte_from_unit(sum.y), byte_from_unit(sum.z)};
                }
        });
        return out;
    }

    // `count` surface samples seen from `origins` in random directions; for a stage, towards it.
    std::vector<SurfacePoint> points(const std::vector<Vec3f>& origins, int count, std::uint64_t seed) const {
        std::vector<SurfacePoint> out;
        for (int i = 0; static_cast<int>(out.size()) < count; ++i) {
            Random random(seed, "bench.points", static_cast<std::uint64_t>(i));
            const Vec3f o = origins[static_cast<std::size_t>(i) % origins.size()];
            const Vec3f around{random.normal(), random.normal(), random.normal()};
            const Vec3f d = normalize(stage_ ? around * 1.5f - o : around);
            const RoomHit h = hit(o, d);
            if (!h) continue;
            const Vec3f p = o + d * h.range, c = color(p, h);
            // Uniform ray density: the spacing grows with range and grazing angle.
            const float cosine = std::max(0.15f, -dot(d, h.normal));
            const float spacing = h.range * std::sqrt(12.566f / (static_cast<float>(count) * cosine));
            out.push_back({p, h.normal, {byte_from_unit(c.x), byte_from_unit(c.y), byte_from_unit(c.z)}, spacing});
        }
        return out;
    }

  private:
    bool stage_;
    std::vector<Box> boxes_;
};

// Yaw to the right, then pitch upward; y points down.
inline Mat3f looking(float yaw_deg, float pitch_deg) {
    const float rad = 0.01745329f;
    return rotation_about(Vec3f{0, 1, 0}, yaw_deg * rad) * rotation_about(Vec3f{1, 0, 0}, pitch_deg * rad);
}

// The fourteen views of a panorama: eight around, three up, three down.
inline std::vector<Mat3f> fourteen_cuts() {
    std::vector<Mat3f> out;
    for (int i = 0; i < 8; ++i) out.push_back(looking(45.f * static_cast<float>(i), 0));
    for (int i = 0; i < 3; ++i)
        out.push_back(looking(120.f * static_cast<float>(i), 60)),
            out.push_back(looking(120.f * static_cast<float>(i) + 60, -60));
    return out;
}

struct RoomSet {
    ViewSet train;
    std::vector<View> held_out;
};
// A ring of cameras around the stage, looking down at it: everything is in front of every camera.
inline RoomSet orbit_set(int size, int views, int points, int held_out, int samples) {
    const TexturedRoom stage(true);
    const Pinhole camera = Pinhole::with_fov(size, size, 50);
    constexpr float kRadius = 5.5f, kHeight = -2.6f;  // y points down
    const auto pose = [&](float yaw_deg, float lift) {
        const float yaw = yaw_deg * 0.01745329f, down = std::atan2(-kHeight + 0.5f + lift, kRadius) * 57.29578f;
        return Rigid{looking(yaw_deg + 180, -down), {kRadius * std::sin(yaw), kHeight - lift, kRadius * std::cos(yaw)}};
    };
    RoomSet out;
    std::vector<Vec3f> origins;
    for (int i = 0; i < views; ++i) {
        const Rigid at = pose(360.f * static_cast<float>(i) / static_cast<float>(views), i % 3 == 0   ? 0.f
                                                                                         : i % 3 == 1 ? 0.8f
                                                                                                      : 1.6f);
        out.train.views.push_back(stage.view(camera, at, samples));
        out.train.views.back().name = std::to_string(i + 1) + ".png";
        origins.push_back(at.translation);
    }
    for (int i = 0; i < held_out; ++i) {
        Random random(7, "bench.held-out", static_cast<std::uint64_t>(i));
        out.held_out.push_back(stage.view(camera, pose(random.uniform(0, 360), random.uniform(0.1f, 1.5f)), samples));
    }
    out.train.points = stage.points(origins, points, 3);
    return out;
}
inline RoomSet room_set(int size, int positions, int points, int held_out, int samples) {
    const TexturedRoom room;
    RoomSet out;
    std::vector<Vec3f> origins;
    for (int i = 0; i < positions; ++i)
        origins.push_back(i == 0 ? Vec3f{} : Vec3f{i & 1 ? .22f : -.22f, i & 2 ? .22f : -.22f, i & 4 ? .22f : -.22f});
    const Pinhole wide = Pinhole::with_fov(size, size, 90), narrow = Pinhole::with_fov(size, size, 75);
    for (const Vec3f& o : origins)
        for (const Mat3f& r : fourteen_cuts()) {
            out.train.views.push_back(room.view(wide, {r, o}, samples));
            out.train.views.back().name = std::to_string(out.train.views.size()) + ".png";
        }
    for (int i = 0; i < held_out; ++i) {
        Random random(7, "bench.held-out", static_cast<std::uint64_t>(i));
        const Vec3f d = normalize(Vec3f{random.normal(), random.normal(), random.normal()});
        const Rigid pose{looking(random.uniform(0, 360), random.uniform(-30, 30)), d * random.uniform(0.3f, 0.6f)};
        out.held_out.push_back(room.view(narrow, pose, samples));
    }
    out.train.points = room.points(origins, points, 3);
    return out;
}

}  // namespace fastscene::bench
