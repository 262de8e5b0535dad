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

// Distance into the room from the line of a wall that runs from a to b.
Vec2f direction(Vec2f a, Vec2f b) { return (b - a) * (1.f / length(b - a)); }
float distance_from(Vec2f a, Vec2f b, Vec2f p) {
    const Vec2f along = direction(a, b);
    return dot(p - a, Vec2f{along.y, -along.x});
}
// … from the wall before a cut corner; negative behind it. The room is convex there.
float distance_from_edge(const Block& b, Vec2f p) {
    const std::vector<Vec2f> edge = cut_edge(b);
    float near = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) near = std::min(near, distance_from(edge[i], edge[i + 1], p));
    return near;
}

WallFace face_between(Vec2f a, Vec2f b) {
    const Vec2f along = direction(a, b);
    return {{a.x, 0, a.y}, {along.x, 0, along.y}, {along.y, 0, -along.x}, length(b - a)};
}

// Walls before a cut corner, and chords before a curved one that are wide enough for furniture.
void add_edge_faces(const Block& b, std::vector<WallFace>& out) {
    constexpr float kFarthestBehind = 0.45f;  // metres
    const std::vector<Vec2f> edge = cut_edge(b);
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) out.push_back(face_between(edge[i], edge[i + 1]));
    for (std::size_t span = 2; span < edge.size(); span += 2)
        for (std::size_t i = 0; i + span < edge.size(); i += span / 2) {
            WallFace chord = face_between(edge[i], edge[i + span]);
            chord.behind = -distance_from(edge[i], edge[i + span], edge[i + span / 2]);
            if (chord.behind < kFarthestBehind) out.push_back(chord);
        }
}

// Lines in front of a wall that reach into the cut corners at its ends, where the wall itself is short.
void add_wall_chords(const Plan& plan, int wall, std::vector<WallFace>& out) {
    const WallFace face = plan.wall(wall);
    for (const float behind : {0.06f, 0.14f, 0.28f, 0.42f}) {
        float from = 0, to = face.length;
        for (const Block& b : plan.blocks) {
            const auto [low, high] = shadow(face, b);
            if (!cuts_corner(b) || !(high > low)) continue;
            // Where its wall crosses the line at that depth.
            const std::vector<Vec2f> edge = cut_edge(b);
            float cross = low < 0.5f * face.length ? low : high;  // deeper than it goes it takes nothing
            for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
                const Vec2f p = edge[i] - flat(face.origin), q = edge[i + 1] - flat(face.origin);
                const float dp = dot(p, flat(face.inward)), dq = dot(q, flat(face.inward));
                if ((dp < behind) == (dq < behind)) continue;
                cross = dot(p + (q - p) * ((behind - dp) / (dq - dp)), flat(face.along));
            }
            if (low < 0.5f * face.length) from = std::max(from, cross);
            else to = std::min(to, cross);
        }
        const auto [low, high] = plan.free_span(wall, 0);
        if (to - from > high - low + 0.04f)
            out.push_back(
                {face.point(from, 0) + face.inward * behind, face.along, face.inward, to - from, wall, from, behind});
    }
}

float distance_to_box(const Block& b, Vec2f p) {
    return std::hypot(std::max({0.f, b.low.x - p.x, p.x - b.high.x}), std::max({0.f, b.low.y - p.y, p.y - b.high.y}));
}

// How far from the edge of the oculus, or the middle of the vault, to the wall a point is, on the line through them: 0
// to 1.
float share_to_wall(const Plan& plan, Vec2f middle, Vec2f point) {
    const Vec2f p = point - middle;
    const float far = length(p);
    if (far < 1e-4f) return 0;
    std::vector<Vec2f> outline = plan.outline();
    for (Vec2f& corner : outline) corner = corner - middle;
    return std::clamp((far - plan.oculus) / (reach_of(outline, p * (1.f / far)) - plan.oculus), 0.f, 1.f);
}

}  // namespace

float vault_rise(const Plan& plan, Vec2f p) {
    const float conch = conch_from(plan);
    const float out = plan.vault != Vault::barrel ? share_to_wall(plan, {}, p)
                      : p.y > conch               ? share_to_wall(plan, {0, conch}, p)
                                                  : std::min(1.f, std::abs(p.x) / (plan.width / 2));
    return vault_profile(plan.vault, out);
}

float reach_of(const std::vector<Vec2f>& outline, Vec2f direction) {
    const auto turn = [](Vec2f u, Vec2f v) { return u.x * v.y - u.y * v.x; };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2f a = outline[i], b = outline[(i + 1) % outline.size()];
        constexpr float kTouch = 1e-4f;  // metres: along a corner both sides will do
        if (turn(a, direction) > kTouch || turn(direction, b) > kTouch) continue;  // in another sector
        const float to_wall = turn(a, b - a) / turn(direction, b - a);
        if (to_wall > 0) return to_wall;
    }
    return 0;
}

float conch_from(const Plan& plan) {
    float from = plan.depth / 2;
    bool near = false;
    for (const Block& b : plan.blocks) {
        near = near || (cuts_corner(b) && b.low.y + b.high.y < 0);
        if (b.kind == Block::Kind::curve) from = std::min(from, b.low.y);
    }
    return near ? plan.depth / 2 : from;
}

float vault_profile(Vault vault, float out) {
    return vault == Vault::flat ? 1.f : vault == Vault::cone ? 1.f - out : std::sqrt(std::max(0.f, 1.f - out * out));
}

std::vector<Vec2f> cut_edge(const Block& b) {
    constexpr float kFacet = 0.33f;  // metres: of the flat parts of a curved wall
    const Vec2f middle = (b.low + b.high) * 0.5f;
    const bool right = middle.x > 0, far = middle.y > 0;
    // Where it leaves one wall and meets the next one.
    const Vec2f from = right == far ? Vec2f{far ? b.low.x : b.high.x, far ? b.high.y : b.low.y}
                                    : Vec2f{right ? b.high.x : b.low.x, right ? b.high.y : b.low.y},
                to = right == far ? Vec2f{right ? b.high.x : b.low.x, right ? b.low.y : b.high.y}
                                  : Vec2f{right ? b.low.x : b.high.x, right ? b.low.y : b.high.y};
    if (b.kind == Block::Kind::cut) return {from, to};
    const Vec2f center{right ? b.low.x : b.high.x, far ? b.low.y : b.high.y};
    const float quarter = 0.25f * kPi * (b.high.x - b.low.x + b.high.y - b.low.y);
    const int steps = 2 * std::max(2, static_cast<int>(std::lround(quarter / kFacet / 2)));
    std::vector<Vec2f> out;
    for (int i = 0; i <= steps; ++i) {
        const float a = 0.5f * kPi * static_cast<float>(i) / static_cast<float>(steps);
        out.push_back(center + (from - center) * std::cos(a) + (to - center) * std::sin(a));
    }
    return out;
}

std::vector<Vec2f> Plan::outline() const {
    std::vector<Vec2f> out;
    const auto add = [&](Vec2f p) {
        if (out.empty() || length(p - out.back()) > 1e-4f) out.push_back(p);
    };
    for (int i = 0; i < 4; ++i) {
        // The corner at the end of wall i.
        const Vec2f corner = flat(wall(i).point(wall(i).length, 0));
        const auto cut = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) {
            return cuts_corner(b) && (b.low.x + b.high.x > 0) == (corner.x > 0) &&
                   (b.low.y + b.high.y > 0) == (corner.y > 0);
        });
        if (cut == blocks.end()) add(corner);
        else
            for (const Vec2f p : cut_edge(*cut)) add(p);
    }
    if (length(out.front() - out.back()) < 1e-4f) out.pop_back();
    return out;
}

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
        if (cuts_corner(b)) add_edge_faces(b, out);
        if (b.kind == Block::Kind::column || b.kind == Block::Kind::stairs || cuts_corner(b)) continue;
        if (b.low.y > -d && x > kShortestFace) out.push_back({{b.low.x, 0, b.low.y}, {1, 0, 0}, {0, 0, -1}, x});
        if (b.high.y < d && x > kShortestFace) out.push_back({{b.high.x, 0, b.high.y}, {-1, 0, 0}, {0, 0, 1}, x});
        if (b.low.x > -w && z > kShortestFace) out.push_back({{b.low.x, 0, b.high.y}, {0, 0, -1}, {-1, 0, 0}, z});
        if (b.high.x < w && z > kShortestFace) out.push_back({{b.high.x, 0, b.low.y}, {0, 0, 1}, {1, 0, 0}, z});
    }
    if (has_cut_corners(*this))
        for (int i = 0; i < 4; ++i) add_wall_chords(*this, i, out);
    return out;
}

const PromptObject* Plan::asked(std::string_view kind) const {
    const auto found = std::find_if(asked_parts.begin(), asked_parts.end(),
                                    [&](const PromptObject& o) { return o.kind == kind; });
    return found != asked_parts.end() ? &*found : nullptr;
}

float Plan::ceiling_at(Vec2f p) const {
    if (mezzanine.depth > 0) return p.y > mezzanine_edge() ? mezzanine.floor - kMezzanineSlab : height;
    if (vault != Vault::flat)  // as high as at a wall, or higher
        return spring + (height - spring) * vault_rise(*this, p);
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
    const float low_enough = vault == Vault::flat ? -1.f : spring;  // below any vault
    for (const Vec2f corner : corners_of(box))
        if (!(box.y1 < low_enough || box.y1 < ceiling_at(corner) + 0.01f)) return false;
    for (const Block& b : blocks) {
        if (cuts_corner(b)) {
            for (const Vec2f corner : corners_of(box))
                if (!(distance_to_box(b, corner) > 0) && distance_from_edge(b, corner) < 0.002f) return false;
            continue;
        }
        const float proud = b.kind == Block::Kind::column ? kCapitalReach : 0.f;
        if (overlap(box, {(b.low + b.high) * 0.5f, (b.high - b.low) * 0.5f + Vec2f{proud, proud}, 0, 0, height}))
            return false;
    }
    return true;
}

float Plan::wall_distance(Vec2f p) const {
    float near = std::min(width / 2 - std::abs(p.x), depth / 2 - std::abs(p.y));
    for (const Block& b : blocks)
        if (const float to_box = distance_to_box(b, p); to_box < near)
            near = cuts_corner(b) ? std::min(near, distance_from_edge(b, p)) : to_box;
    return near;
}

float Plan::air_around(Vec3f p) const {
    const float above = mezzanine.depth > 0 ? ceiling_at({p.x, p.z}) : height;
    float near = std::min({wall_distance({p.x, p.z}), p.y - floor_at({p.x, p.z}), above - p.y});
    constexpr float kFarthest = 1.2f;
    if (vault != Vault::flat && p.y + kFarthest > spring)
        for (int i = 0; i < 8; ++i)  // towards where it comes down, whichever way that is
            for (const float far : {0.f, 0.3f, 0.6f, 0.9f, kFarthest}) {
                const float a = 0.25f * kPi * static_cast<float>(i),
                            up = ceiling_at(Vec2f{p.x, p.z} + Vec2f{std::cos(a), std::sin(a)} * far) - p.y;
                near = std::min(near, std::hypot(far, std::max(0.f, up)));
            }
    if (knee > 0)
        near = std::min(near, (ceiling_at({p.x, p.z}) < height
                                   ? ceiling_at({p.x, p.z}) - p.y
                                   : knee + (width / 2 - std::abs(p.x)) * (height - knee) / slope_run - p.y) *
                                  slope_run / std::hypot(slope_run, height - knee));
    return near;
}

std::pair<float, float> Plan::uncut_span(int i) const {
    const WallFace face = wall(i);
    std::pair<float, float> span{0, face.length};
    for (const Block& b : blocks) {
        const auto [low, high] = shadow(face, b);
        if (!cuts_corner(b) || !(high > low)) continue;
        if (low < 0.5f * face.length) span.first = std::max(span.first, high);
        else span.second = std::min(span.second, low);
    }
    return span;
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
