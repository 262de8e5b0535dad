#include "fastscene/geometry/resample_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fastscene {
namespace {

using Kind = SpherePicture::Kind;

int part_height(const SpherePicture& p) { return p.kind == Kind::cube ? p.width : p.height; }

// Angular distance in degrees of a direction inside a face from its nearest border; negative outside.
float depth_in_face_deg(const Pinhole& camera, Vec3f in_face) {
    if (!(in_face.z > 0)) return -1;
    const float half = std::atan2(static_cast<float>(camera.width) / 2.f, camera.fx);
    const float x = std::atan2(std::fabs(in_face.x), in_face.z), y = std::atan2(std::fabs(in_face.y), in_face.z);
    return (half - std::max(x, y)) * 180.f / std::numbers::pi_v<float>;
}

std::array<float, 4> weights_of(int side, float t) {
    if (side == 1) return {1, 0, 0, 0};
    if (side == 2) return {1 - t, t, 0, 0};
    return catmull_rom(t);
}

// Adds pixel (x, y) of a part, resolved across the pole, the seam, or in the neighbouring face.
void add_pixel(const SpherePicture& s, int part, int x, int y, float weight, std::vector<SourceTap>& taps) {
    const int w = s.width, h = part_height(s);
    if (s.kind == Kind::equirect) {
        if (y >= 0 && y < h) {
            taps.push_back({y * w + wrap_column(x, w), weight});
            return;
        }
        y = std::clamp(y < 0 ? -1 - y : 2 * h - 1 - y, 0, h - 1);
        // with an odd number of columns, the opposite longitude is between two
        for (const int half_turn : {w / 2, w - w / 2})
            taps.push_back({y * w + wrap_column(x + half_turn, w), 0.5f * weight});
        return;
    }
    const bool inside = x >= 0 && y >= 0 && x < w && y < h;
    if (inside || s.kind == Kind::perspective) {
        taps.push_back({(part * h + std::clamp(y, 0, h - 1)) * w + std::clamp(x, 0, w - 1), weight});
        return;
    }
    // Extends the face's plane; the direction through that point belongs to the neighbour.
    const Vec3f d = pano_from_face(kCubeFaces[static_cast<std::size_t>(part)]) *
                    s.camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
    const auto other = static_cast<int>(face_of_direction(d));
    const Vec2f at = s.camera.project(transpose(pano_from_face(kCubeFaces[static_cast<std::size_t>(other)])) * d)
                         .value_or(Vec2f{});
    const float px = std::clamp(at.x - 0.5f, 0.f, static_cast<float>(w - 1)),
                py = std::clamp(at.y - 0.5f, 0.f, static_cast<float>(h - 1));
    const int ix = static_cast<int>(px), iy = static_cast<int>(py);
    const float u = px - static_cast<float>(ix), v = py - static_cast<float>(iy);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const float part_weight = weight * (i ? u : 1 - u) * (j ? v : 1 - v);
            if (part_weight != 0)
                taps.push_back({(other * h + std::min(iy + j, h - 1)) * w + std::min(ix + i, w - 1), part_weight});
        }
}

// First pixel of a neighbourhood, and the position within its middle cell.
struct Cell {
    int x, y;
    float u, v;
};
Cell cell_of(Vec2f pixel, int side) {
    if (side == 1) return {static_cast<int>(std::floor(pixel.x)), static_cast<int>(std::floor(pixel.y)), 0, 0};
    const float fx = std::floor(pixel.x - 0.5f), fy = std::floor(pixel.y - 0.5f);
    const int before = side / 2 - 1;
    return {static_cast<int>(fx) - before, static_cast<int>(fy) - before, pixel.x - 0.5f - fx, pixel.y - 0.5f - fy};
}

}  // namespace

Vec3f direction_in(const SpherePicture& p, Vec2f point) {
    if (p.kind == Kind::equirect) return p.world_from_picture * direction_at(point, EquirectSize{p.width, p.height});
    if (p.kind == Kind::perspective) return p.world_from_picture * normalize(p.camera.direction_at(point));
    const int face = std::clamp(static_cast<int>(point.y / static_cast<float>(p.width)), 0, 5);
    const Vec2f in_face{point.x, point.y - static_cast<float>(face * p.width)};
    return p.world_from_picture *
           (pano_from_face(kCubeFaces[static_cast<std::size_t>(face)]) * normalize(p.camera.direction_at(in_face)));
}

int places_of(const SpherePicture& s, Vec3f direction, float feather_deg, std::array<SourcePlace, 6>& out) {
    const Vec3f d = transpose(s.world_from_picture) * direction;
    if (s.kind == Kind::equirect) {
        out[0] = {pixel_of_direction(d, EquirectSize{s.width, s.height}), 0, 1};
        return 1;
    }
    if (s.kind == Kind::perspective) {
        const auto at = s.camera.project(d);
        if (!at || !(at->x >= 0 && at->y >= 0 && at->x <= static_cast<float>(s.width) &&
                     at->y <= static_cast<float>(s.height)))
            return 0;
        out[0] = {*at, 0, 1};
        return 1;
    }
    const auto own = static_cast<int>(face_of_direction(d));
    int count = 0;
    float sum = 0;
    for (int f = 0; f < 6; ++f) {
        if (f != own && !(feather_deg > 0)) continue;
        const Vec3f in_face = transpose(pano_from_face(kCubeFaces[static_cast<std::size_t>(f)])) * d;
        float weight = 1;
        if (feather_deg > 0) {
            const float t = std::clamp(depth_in_face_deg(s.camera, in_face) / feather_deg, f == own ? 1e-4f : 0.f, 1.f);
            weight = t * t * (3 - 2 * t);
        }
        if (!(weight > 0)) continue;
        out[static_cast<std::size_t>(count++)] = {*s.camera.project(in_face), f, weight};
        sum += weight;
    }
    for (int i = 0; i < count; ++i) out[static_cast<std::size_t>(i)].weight /= sum;
    return count;
}

float pitch_at(const SpherePicture& s, Vec3f direction) {
    if (s.kind == Kind::equirect)
        return std::numbers::pi_v<float> / static_cast<float>(std::max(s.height, s.width / 2));
    const Vec3f d = transpose(s.world_from_picture) * direction;
    const float z = s.kind == Kind::perspective ? std::fabs(d.z)
                                                : std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    return z * z / s.camera.fx;  // off-axis pixels subtend smaller angles
}

float crowding(const SpherePicture& s, Vec3f direction) {
    const float sine = dot(s.world_from_picture.column(1), direction);
    const float columns = 2 * std::numbers::pi_v<float> / static_cast<float>(s.width) *
                          std::sqrt(std::fmax(0.f, 1 - sine * sine));
    return std::fmax(1.f, pitch_at(s, direction) / std::fmax(columns, 1e-5f));
}

Vec2f columns_across(const SpherePicture& s, const SpherePicture& t, Vec2f corner) {
    const auto w = static_cast<float>(s.width);
    const auto column = [&](float x, float y) {
        return pixel_of_direction(transpose(s.world_from_picture) * direction_in(t, corner + Vec2f{x, y}),
                                  EquirectSize{s.width, s.height})
            .x;
    };
    const auto between = [&](float a, float b) { return std::fmin(std::fabs(a - b), w - std::fabs(a - b)); };
    constexpr float kIn = 0.001f;  // so that both ends are on the same face
    return Vec2f{between(column(kIn, 0.5f), column(1 - kIn, 0.5f)), between(column(0.5f, kIn), column(0.5f, 1 - kIn))} *
           (1 / (1 - 2 * kIn));
}

Vec2f pixel_angles(const SpherePicture& t, Vec3f direction) {
    const Vec3f d = transpose(t.world_from_picture) * direction;
    if (t.kind == Kind::equirect) {
        const float row = std::numbers::pi_v<float> / static_cast<float>(t.height),
                    column = 2 * std::numbers::pi_v<float> / static_cast<float>(t.width);
        return {column * std::sqrt(std::fmax(0.f, 1 - d.y * d.y)), row};
    }
    const float z = t.kind == Kind::perspective ? std::fabs(d.z)
                                                : std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    // The larger of its two angles off axis; limited for very wide cameras.
    return {2 * std::atan(0.5f * z / t.camera.fx), 2 * std::atan(0.5f * z / t.camera.fy)};
}

bool is_inside(const SpherePicture& s, const SourcePlace& place, int side) {
    const Cell c = cell_of(place.pixel, side);
    return c.x >= 0 && c.y >= 0 && c.x + side <= s.width && c.y + side <= part_height(s);
}

void add_taps(const SpherePicture& s, const SourcePlace& place, int side, std::vector<SourceTap>& taps) {
    const Cell c = cell_of(place.pixel, side);
    const auto wu = weights_of(side, c.u), wv = weights_of(side, c.v);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const float weight = place.weight * wu[static_cast<std::size_t>(i)] * wv[static_cast<std::size_t>(j)];
            if (weight != 0) add_pixel(s, place.part, c.x + i, c.y + j, weight, taps);
        }
}

}  // namespace fastscene
