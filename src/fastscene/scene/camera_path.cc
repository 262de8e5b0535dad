#include "fastscene/scene/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fastscene {
namespace {

constexpr float kDegrees = 180.f / std::numbers::pi_v<float>;

// Full turns are added, so that the angles differ by at most 180 degrees.
float nearest_turn(float angle_deg, float reference_deg) {
    return angle_deg - 360.f * std::round((angle_deg - reference_deg) / 360.f);
}

float turn_between(float a_deg, float b_deg) { return std::fabs(nearest_turn(a_deg, b_deg) - b_deg); }

// Cubic Hermite between b and c; a and d are the keys around them. Slopes are those of the neighbours' difference over
// its time, so that keys at uneven times make no jerk; at the ends they are zero.
template <class Value>
auto between(const std::vector<CameraKey>& keys, std::size_t i, float t, const Value& value_of) {
    const CameraKey &b = keys[i - 1], &c = keys[i];
    const float span = c.time_s - b.time_s;
    using T = decltype(value_of(b));
    const auto slope = [&](std::size_t k) {
        if (k == 0 || k + 1 == keys.size()) return T{};
        return (value_of(keys[k + 1]) - value_of(keys[k - 1])) * (span / (keys[k + 1].time_s - keys[k - 1].time_s));
    };
    const T p = value_of(b), q = value_of(c), m = slope(i - 1), n = slope(i);
    const float t2 = t * t, t3 = t2 * t;
    return p * (2 * t3 - 3 * t2 + 1) + m * (t3 - 2 * t2 + t) + q * (3 * t2 - 2 * t3) + n * (t3 - t2);
}

}  // namespace

Rigid world_from_camera_at(Vec3f position_m, float yaw_deg, float pitch_deg, float roll_deg) {
    Mat3f turn = rotation_about(Vec3f{0, 1, 0}, yaw_deg / kDegrees) *
                 rotation_about(Vec3f{1, 0, 0}, pitch_deg / kDegrees);
    if (roll_deg != 0) turn = turn * rotation_about(Vec3f{0, 0, 1}, roll_deg / kDegrees);
    return {turn, position_m};
}

CameraKey key_of_pose(float time_s, const Rigid& pose) {
    const Vec3f right = pose.rotation.column(0), down = pose.rotation.column(1), forward = pose.rotation.column(2);
    const float pitch = std::asin(std::clamp(-forward.y, -1.f, 1.f));
    constexpr float kStraight = 1e-5f;  // level part of a line of sight that has no yaw of its own
    float yaw = 0, roll = 0;
    if (std::hypot(forward.x, forward.z) > kStraight) {
        yaw = std::atan2(forward.x, forward.z);
        roll = std::atan2(right.y, down.y);
    } else {
        yaw = std::atan2(-right.z, right.x);
    }
    return {time_s, pose.translation, yaw * kDegrees, pitch * kDegrees, roll * kDegrees, 0};
}

int CameraPath::frames() const { return 1 + static_cast<int>((keys.back().time_s - keys.front().time_s) * fps + 0.5f); }

float CameraPath::time_of(int frame) const {
    return static_cast<float>(static_cast<double>(keys.front().time_s) +
                              static_cast<double>(frame) / static_cast<double>(fps));
}

CameraKey CameraPath::at(float time_s) const {
    const auto with_fov = [&](CameraKey key) {
        if (key.fov_deg == 0) key.fov_deg = fov_deg;
        return key;
    };
    if (!(time_s > keys.front().time_s)) return with_fov(keys.front());
    if (!(time_s < keys.back().time_s)) return with_fov(keys.back());
    const auto next = std::upper_bound(keys.begin(), keys.end(), time_s,
                                       [](float t, const CameraKey& key) { return t < key.time_s; });
    const auto i = static_cast<std::size_t>(next - keys.begin());
    const float t = (time_s - keys[i - 1].time_s) / (keys[i].time_s - keys[i - 1].time_s);
    const auto value = [&](const auto& of) { return between(keys, i, t, of); };
    // An angle of a key as seen from the segment's first: the shorter way round.
    const auto turn = [&](float CameraKey::*angle) {
        return value([&](const CameraKey& key) { return nearest_turn(key.*angle, keys[i - 1].*angle); });
    };
    return {time_s,
            value([](const CameraKey& key) { return key.position_m; }),
            turn(&CameraKey::yaw_deg),
            value([](const CameraKey& key) { return key.pitch_deg; }),
            turn(&CameraKey::roll_deg),
            value([&](const CameraKey& key) { return with_fov(key).fov_deg; })};
}

void unwrap_angles(std::vector<CameraKey>& keys) {
    for (std::size_t i = 1; i < keys.size(); ++i) {
        keys[i].yaw_deg = nearest_turn(keys[i].yaw_deg, keys[i - 1].yaw_deg);
        keys[i].roll_deg = nearest_turn(keys[i].roll_deg, keys[i - 1].roll_deg);
    }
}

float vertical_fov_deg(float horizontal_deg, int width, int height) {
    return 2 * kDegrees *
           std::atan(std::tan(horizontal_deg / 2 / kDegrees) * static_cast<float>(height) / static_cast<float>(width));
}
float horizontal_fov_deg(float vertical_deg, int width, int height) {
    return vertical_fov_deg(vertical_deg, height, width);
}

CameraPath with_fewer_keys(const CameraPath& path, float slack_m, float slack_deg) {
    if (path.keys.size() < 3) return path;
    std::vector<std::size_t> kept{0, path.keys.size() - 1};
    CameraPath out = path;
    while (true) {
        out.keys.clear();
        for (const std::size_t i : kept) out.keys.push_back(path.keys[i]);
        // The worst key left out, in units of what is allowed, comes back.
        std::size_t worst = 0;
        float most = 1;
        for (std::size_t i = 0; i < path.keys.size(); ++i) {
            const CameraKey key = path.at(path.keys[i].time_s), now = out.at(key.time_s);
            const float off = std::max({length(now.position_m - key.position_m) / slack_m,
                                        turn_between(now.yaw_deg, key.yaw_deg) / slack_deg,
                                        std::fabs(now.pitch_deg - key.pitch_deg) / slack_deg,
                                        turn_between(now.roll_deg, key.roll_deg) / slack_deg,
                                        std::fabs(now.fov_deg - key.fov_deg) / slack_deg});
            if (off > most) most = off, worst = i;
        }
        if (most <= 1) return out;
        kept.insert(std::lower_bound(kept.begin(), kept.end(), worst), worst);
    }
}

}  // namespace fastscene
