// What the plan knows of its own shape: walls and their parts, what lies inside, how much air a point has.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/rooms/plan.h"

namespace fastscene {
namespace {

constexpr float kShortestFace = 0.3f;  // shorter faces take nothing

// The part of a wall that a block stands at, along u; empty when it does not touch the wall.
std::pair<float, float> shadow(const WallFace& face, const Block& block) {
    const Vec3f low{block.low.x, 0, block.low.y}, high{block.high.x, 0, block.high.y};
    const float a = dot(low - face.origin, face.along), b = dot(high - face.origin, face.along);
    const float near = std::min(dot(low - face.origin, face.inward), dot(high - face.origin, face.inward));
    if (near > 0.01f) return {0, 0};
    return {std::min(a, b), std::max(a, b)};
}

// The parts of [0, length] that no interval covers.
std::vector<std::pair<float, float>> gaps(float length, std::vector<std::pair<float, float>> covered) {
    std::sort(covered.begin(), covered.end());
    std::vector<std::pair<float, float>> out;
    float u = 0;
    for (const auto& [a, b] : covered) {
        if (!(b > a)) continue;
        if (a > u) out.push_back({u, a});
        u = std::max(u, b);
    }
    if (length > u) out.push_back({u, length});
    return out;
}

float distance_to(const Block& b, Vec2f p) {
    return std::hypot(std::max({0.f, b.low.x - p.x, p.x - b.high.x}), std::max({0.f, b.low.y - p.y, p.y - b.high.y}));
}

}  // namespace

const Material& Plan::wall_material(int i) const {
    if (const auto& own = own_walls[static_cast<std::size_t>(i)]) return *own;
    return accent && accent_wall == i ? style.accent_wall : style.wall;
}

WallFace Plan::wall(int i) const {
    const float w = width / 2, d = depth / 2;
    switch (i) {
        case 0: return {{-w, 0, d}, {1, 0, 0}, {0, 0, -1}, width, 0};
        case 1: return {{w, 0, d}, {0, 0, -1}, {-1, 0, 0}, depth, 1};
        case 2: return {{w, 0, -d}, {-1, 0, 0}, {0, 0, 1}, width, 2};
        default: return {{-w, 0, -d}, {0, 0, 1}, {1, 0, 0}, depth, 3};
    }
}

std::vector<WallFace> Plan::faces() const {
    std::vector<WallFace> out;
    for (int i = 0; i < 4; ++i) {
        const WallFace face = wall(i);
        std::vector<std::pair<float, float>> covered;
        for (const Block& b : blocks) covered.push_back(shadow(face, b));
        for (const auto& [a, b] : gaps(face.length, covered))
            if (b - a > kShortestFace) out.push_back({face.point(a, 0), face.along, face.inward, b - a, i, a});
    }
    const float w = width / 2 - 0.01f, d = depth / 2 - 0.01f;
    for (const Block& b : blocks) {
        // As seen from the room, a side of a block runs the other way round than the walls about it.
        const float x = b.high.x - b.low.x, z = b.high.y - b.low.y;
        if (b.kind == Block::Kind::column) continue;
        if (b.low.y > -d && x > kShortestFace) out.push_back({{b.low.x, 0, b.low.y}, {1, 0, 0}, {0, 0, -1}, x});
        if (b.high.y < d && x > kShortestFace) out.push_back({{b.high.x, 0, b.high.y}, {-1, 0, 0}, {0, 0, 1}, x});
        if (b.low.x > -w && z > kShortestFace) out.push_back({{b.low.x, 0, b.high.y}, {0, 0, -1}, {-1, 0, 0}, z});
        if (b.high.x < w && z > kShortestFace) out.push_back({{b.high.x, 0, b.low.y}, {0, 0, 1}, {1, 0, 0}, z});
    }
    return out;
}

const PromptObject* Plan::asked(std::string_view kind) const {
    const auto found = std::find_if(asked_parts.begin(), asked_parts.end(),
                                    [&](const PromptObject& o) { return o.kind == kind; });
    return found != asked_parts.end() ? &*found : nullptr;
}

float Plan::ceiling_at(Vec2f p) const {
    if (!(knee > 0)) {
        const float in = cove - std::max(0.f, width / 2 - std::abs(p.x));  // how far within the curve's box
        return in > 0 ? height - cove + std::sqrt(std::max(0.f, cove * cove - in * in)) : height;
    }
    return std::min(height, knee + std::max(0.f, width / 2 - std::abs(p.x)) * (height - knee) / slope_run);
}

bool Plan::holds(const Footprint& box) const {
    if (!(std::abs(box.center.x) + extent(box, {1, 0}) <= width / 2 - 0.002f &&
          std::abs(box.center.y) + extent(box, {0, 1}) <= depth / 2 - 0.002f && box.y0 > floor_below(box) - 0.01f))
        return false;
    for (const Vec2f corner : corners_of(box))
        if (!(box.y1 < ceiling_at(corner) + 0.01f)) return false;
    for (const Block& b : blocks) {
        const float proud = b.kind == Block::Kind::column ? kCapitalReach : 0.f;
        if (overlap(box, {(b.low + b.high) * 0.5f, (b.high - b.low) * 0.5f + Vec2f{proud, proud}, 0, 0, height}))
            return false;
    }
    return true;
}

float Plan::wall_distance(Vec2f p) const {
    float near = std::min(width / 2 - std::abs(p.x), depth / 2 - std::abs(p.y));
    for (const Block& b : blocks) near = std::min(near, distance_to(b, p));
    return near;
}

float Plan::air_around(Vec3f p) const {
    float near = std::min({wall_distance({p.x, p.z}), p.y - floor_at({p.x, p.z}), height - p.y});
    if (knee > 0)
        near = std::min(near, (ceiling_at({p.x, p.z}) < height
                                   ? ceiling_at({p.x, p.z}) - p.y
                                   : knee + (width / 2 - std::abs(p.x)) * (height - knee) / slope_run - p.y) *
                                  slope_run / std::hypot(slope_run, height - knee));
    return near;
}

std::pair<float, float> Plan::free_span(int i, float wanted_height, bool level) const {
    const WallFace face = wall(i);
    std::vector<std::pair<float, float>> covered;
    for (const Block& b : blocks) covered.push_back(shadow(face, b));
    for (const Platform& p : platforms)
        if (level) covered.push_back(shadow(face, {Block::Kind::corner, p.low, p.high}));
    if (knee > 0) {
        // Below the slope: all of the side walls, the ends of the others.
        const float cut = std::clamp((wanted_height - knee) / (height - knee), 0.f, 1.f) * slope_run;
        if (i % 2 == 1) covered.push_back({0, wanted_height > knee ? face.length : 0.f});
        else covered.push_back({0, cut}), covered.push_back({face.length - cut, face.length});
    }
    std::pair<float, float> best{0, 0};
    for (const auto& gap : gaps(face.length, covered))
        if (gap.second - gap.first > best.second - best.first) best = gap;
    return best;
}

}  // namespace fastscene
