#include "fastscene/studio/plan_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fastscene/image/color.h"

namespace fastscene::studio {
namespace {

constexpr std::array<const char*, 4> kMounts{"floor", "wall", "ceiling", "surface"};
constexpr std::array<const char*, 3> kOpenings{"window", "door", "doorway"};

std::string hex(Vec3f linear) {
    const Rgb8 c = srgb8_from_linear(linear);
    return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}
// From afar a pattern is the mean of its colors.
std::string seen_color(const Material& m) {
    return hex(m.pattern == Pattern::plain ? m.color_a : (m.color_a + m.color_b) * 0.5f);
}

double rounded(float metres) { return std::round(metres * 1e4) / 1e4; }
double degrees(float radians) { return std::round(radians * 180 / kPi * 100) / 100; }
Json point(Vec3f p) { return {rounded(p.x), rounded(p.z)}; }

std::string words_of(std::string kind) {
    std::replace(kind.begin(), kind.end(), '_', ' ');
    return kind;
}

Json opening_json(const Plan& plan, const Opening& o) {
    const WallFace face = plan.wall(o.wall);
    return {{"kind", kOpenings[static_cast<std::size_t>(o.kind)]},
            {"wall", o.wall},
            {"a", point(face.point(o.u0, 0))},
            {"b", point(face.point(o.u1, 0))},
            {"low", rounded(o.y0)},
            {"high", rounded(o.y1)}};
}

Json thing_json(const Placed& p, const std::string& id, const std::vector<std::string>& ids) {
    const Footprint box = footprint_of(p);
    const auto main = static_cast<std::size_t>(std::max(0, p.piece.main_material));
    const std::string color = main < p.piece.materials.size() ? seen_color(p.piece.materials[main]) : "#999999";
    return {{"id", id},
            {"kind", p.piece.kind},
            {"name", words_of(p.piece.kind)},
            {"x", rounded(p.position.x)},
            {"z", rounded(p.position.z)},
            {"yaw_deg", degrees(p.yaw)},
            {"cx", rounded(box.center.x)},
            {"cz", rounded(box.center.y)},
            {"w", rounded(2 * box.half.x)},
            {"d", rounded(2 * box.half.y)},
            {"y", rounded(box.y0)},
            {"h", rounded(box.y1 - box.y0)},
            {"mount", kMounts[static_cast<std::size_t>(p.piece.mount)]},
            {"on", p.on < 0 ? std::string() : ids[static_cast<std::size_t>(p.on)]},
            {"color", color},
            {"color_name", p.piece.made_from ? p.piece.made_from->color_name : ""},
            {"material", p.piece.made_from ? p.piece.made_from->material : ""},
            {"flat", p.flat},
            {"overhead", p.overhead},
            {"asked", !p.wish.kind.empty()}};
}

std::vector<Vec2f> outline_of(const Block& b) {
    if (!cuts_corner(b)) return {b.low, {b.high.x, b.low.y}, b.high, {b.low.x, b.high.y}};
    std::vector<Vec2f> out = cut_edge(b);
    const bool right = b.low.x + b.high.x > 0, far = b.low.y + b.high.y > 0;
    out.push_back({right ? b.high.x : b.low.x, far ? b.high.y : b.low.y});
    return out;
}

Json plan_json(const Plan& plan) {
    Json out{{"width", rounded(plan.width)},
             {"depth", rounded(plan.depth)},
             {"height", rounded(plan.height)},
             {"floor", seen_color(plan.style.floor)},
             {"floor_name", plan.style.floor.name},
             {"wall", seen_color(plan.style.wall)},
             {"blocks", Json::array()},
             {"openings", Json::array()}};
    for (const Block& b : plan.blocks) {
        Json outline = Json::array();
        for (const Vec2f p : outline_of(b)) outline.push_back({rounded(p.x), rounded(p.y)});
        out["blocks"].push_back(std::move(outline));
    }
    for (const Opening& o : plan.openings) out["openings"].push_back(opening_json(plan, o));
    return out;
}

}  // namespace

Json plan_view(const DocumentRoom& room) {
    const FurnishedRoom& furnished = room.furnished;
    Json out = plan_json(furnished.plan);
    out["type"] = room.spec.room;
    out["style"] = furnished.plan.style.name;
    out["hour"] = room.spec.time;
    out["camera"] = point(furnished.camera);
    out["looks"] = point(furnished.looks);
    const std::vector<std::string> ids = thing_ids(furnished);
    std::vector<std::size_t> order(furnished.placed.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto top = [&](std::size_t i) { return footprint_of(furnished.placed[i]).y1; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return top(a) < top(b); });
    out["things"] = Json::array();
    for (const std::size_t i : order) out["things"].push_back(thing_json(furnished.placed[i], ids[i], ids));
    return out;
}

}  // namespace fastscene::studio
