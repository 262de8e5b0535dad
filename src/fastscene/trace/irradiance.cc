// Lookup.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/trace/irradiance_cells.h"

namespace fastscene {

using namespace irradiance;

int facing_of(Vec3f n) {
    const float x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    if (x >= y && x >= z) return n.x > 0 ? 0 : 1;
    if (y >= z) return n.y > 0 ? 2 : 3;
    return n.z > 0 ? 4 : 5;
}

void LightDirection::add(Vec3f irradiance, Vec3f direction, Vec3f normal) {
    constexpr float kGrazing = 0.12f;  // cosine; light from lower is as uncertain as it is sensitive to the normal
    const float w = luminance(irradiance);
    sum += direction * (w / std::max(kGrazing, dot(direction, normal)));
    weight += w;
}

float relief_light(Vec3f gradient, Vec3f normal, Vec3f bumped) {
    constexpr float kLeast = 0.25f, kMost = 2.f;  // beyond these, slopes hide light from each other
    return std::clamp(1.f + dot(bumped - normal, gradient), kLeast, kMost);
}

void IrradianceCache::index() {
    std::uint32_t capacity = 16;
    while (capacity < cells_.size() * 2 + 2) capacity *= 2;
    mask_ = capacity - 1;
    slots_.assign(capacity, {});
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        auto slot = static_cast<std::uint32_t>(mix64(keys_[c])) & mask_;
        while (slots_[slot].cell) slot = (slot + 1) & mask_;
        slots_[slot] = {keys_[c], static_cast<std::uint32_t>(c) + 1};
    }
}

int IrradianceCache::find(std::int32_t x, std::int32_t y, std::int32_t z, int facing) const {
    const std::uint64_t key = key_of(x, y, z, facing);
    for (auto slot = static_cast<std::uint32_t>(mix64(key)) & mask_; slots_[slot].cell; slot = (slot + 1) & mask_)
        if (slots_[slot].key == key) return static_cast<int>(slots_[slot].cell) - 1;
    return -1;
}

// The entry whose surface contains the point, or else the nearest entry around it with the same facing.
int IrradianceCache::nearest(Vec3f position, Vec3f normal) const {
    const Vec3f q = (position - origin_) / cell_m_;
    const std::int32_t x = cell_index(q.x), y = cell_index(q.y), z = cell_index(q.z);
    const int facing = facing_of(normal);
    if (const int c = find(x, y, z, facing); c >= 0) return c;
    int best = -1;
    float best_far = 1e9f;
    const auto consider = [&](std::int32_t i, std::int32_t j, std::int32_t k, int f, float least_agreement) {
        const int c = find(i, j, k, f);
        if (c < 0) return;
        const Cell& cell = cells_[static_cast<std::size_t>(c)];
        const float agree = dot(cell.normal, normal), far = length(cell.center - position) + cell_m_ * (1 - agree) * 2;
        if (agree > least_agreement && far < best_far) best_far = far, best = c;
    };
    // Most often the surface merely grazes this cell, or changes its dominant axis within it: test a dozen candidates
    // first instead of all 162.
    for (int f = 0; f < 6; ++f) consider(x, y, z, f, 0.6f);
    for (const int d : {-1, 1}) {
        consider(x + d, y, z, facing, 0.6f);
        consider(x, y + d, z, facing, 0.6f);
        consider(x, y, z + d, facing, 0.6f);
    }
    if (best >= 0) return best;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                for (int f = 0; f < 6; ++f) consider(x + dx, y + dy, z + dz, f, 0.2f);
    return best;
}

IrradianceCache::Near IrradianceCache::near(Vec3f position, Vec3f normal) const {
    const int c = nearest(position, normal);
    if (c < 0) return {};
    const Cell& cell = cells_[static_cast<std::size_t>(c)];
    return {cell.direct + cell.indirect, cell.sun};
}

IrradianceCache::Reading IrradianceCache::read(Vec3f position, Vec3f normal) const {
    constexpr float kSameSurface = 0.2f;  // in cells: how far a point may lie from an entry's plane
    const Vec3f q = (position - origin_) / cell_m_ - Vec3f{0.5f, 0.5f, 0.5f};
    const std::int32_t x = cell_index(q.x), y = cell_index(q.y), z = cell_index(q.z);
    const float fx = q.x - static_cast<float>(x), fy = q.y - static_cast<float>(y), fz = q.z - static_cast<float>(z);
    Vec3f sum{}, sun{}, direction{};
    float weight = 0, trust = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // On a rounded surface, blend between the entries of the dominant axes.
        const float share = normal[axis] * normal[axis];
        if (share < 0.12f) continue;
        const int facing = static_cast<int>(2 * axis) + (normal[axis] > 0 ? 0 : 1);
        for (int k = 0; k < 8; ++k) {
            const int c = find(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2), facing);
            if (c < 0) continue;
            const Cell& cell = cells_[static_cast<std::size_t>(c)];
            // A groove behind the surface or a board in front of it faces the same way but is a different surface.
            const float off = dot(cell.center - position, cell.normal) / (kSameSurface * cell_m_);
            const float same = 1 / (1 + off * off * off * off);
            const float near = (k & 1 ? fx : 1 - fx) * (k & 2 ? fy : 1 - fy) * (k & 4 ? fz : 1 - fz);
            const float w = share * same * near * std::max(0.02f, dot(cell.normal, normal)) + 1e-6f * share;
            sum += (cell.direct + cell.indirect) * w;
            sun += cell.sun * w;
            direction += cell.directed.gradient() * w;
            weight += w;
            trust += w * same * cell.trust;
        }
    }
    if (weight > 0) return {sum / weight, sun / weight, direction / weight, trust / weight};
    const int c = nearest(position, normal);
    if (c < 0) return {};
    const Cell& cell = cells_[static_cast<std::size_t>(c)];
    return {cell.direct + cell.indirect, cell.sun, cell.directed.gradient(), 0.f};
}

}  // namespace fastscene
