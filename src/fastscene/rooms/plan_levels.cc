// Floors with levels: the tiers that rows of seats stand on, the steps that lead up to them, and what of the walls
// beside them is left for windows and doors.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr float kHeadRoom = 2.3f;    // metres, above the highest tier
constexpr float kLeastRise = 0.12f;  // lower tiers are a thing to stumble over, and no better to see from
constexpr float kWayUp = 0.75f;      // a narrower strip beside the rows has no steps
constexpr float kBesideSteps = 0.06f;
constexpr float kLeastBlock = 0.55f;  // of a row beside an aisle: one seat
constexpr float kTouch = 0.01f;

Footprint above_all(const Platform& p) {
    constexpr float kEndless = 1e3f;
    return {(p.low + p.high) * 0.5f, (p.high - p.low) * 0.5f, 0, -kEndless, kEndless};
}

// The first step whose rows rise, wherever in the recipe it is.
const RecipeStep* rising_rows(const std::vector<RecipeStep>& steps) {
    for (const RecipeStep& step : steps) {
        if (step.rise_m > 0) return &step;
        if (const RecipeStep* found = rising_rows(step.then)) return found;
    }
    return nullptr;
}

// Parts of the plan in the frame of who sits there: from the wall that he looks at (`from` to `to` metres), and to the
// right of the middle (`left` to `right`).
class Seen {
  public:
    Seen(const Plan& plan, int towards) : ahead_(flat(plan.wall(towards).inward) * -1.f), right_{ahead_.y, -ahead_.x} {
        const auto extent = [&](Vec2f axis) { return std::abs(axis.x) * plan.width + std::abs(axis.y) * plan.depth; };
        deep_ = extent(ahead_), wide_ = extent(right_);
    }
    float deep() const { return deep_; }
    float wide() const { return wide_; }
    Platform box(Platform::Kind kind, float from, float to, float left, float right, float height) const {
        const Vec2f a = ahead_ * (deep_ / 2 - from) + right_ * left, b = ahead_ * (deep_ / 2 - to) + right_ * right;
        return {kind, {std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}, height};
    }

  private:
    Vec2f ahead_, right_;
    float deep_ = 0, wide_ = 0;
};

// The ways beside and between the blocks of seats, from left to right.
std::vector<std::pair<float, float>> aisles(const RecipeStep& rows, float wide) {
    std::vector<std::pair<float, float>> out;
    if (rows.side_m >= kWayUp) {
        out.push_back({-wide / 2, -wide / 2 + rows.side_m - kBesideSteps});
        out.push_back({wide / 2 - rows.side_m + kBesideSteps, wide / 2});
    }
    if (rows.aisle_m >= kWayUp) out.push_back({-rows.aisle_m / 2 + kBesideSteps, rows.aisle_m / 2 - kBesideSteps});
    return out;
}

}  // namespace

float Plan::floor_at(Vec2f p) const {
    float floor = 0;
    for (const Platform& f : platforms)
        if (p.x >= f.low.x && p.x <= f.high.x && p.y >= f.low.y && p.y <= f.high.y) floor = std::max(floor, f.height);
    return floor;
}

float Plan::floor_below(const Footprint& box) const {
    float floor = 0;
    for (const Platform& f : platforms) {
        Footprint column = box;
        column.y0 = 0, column.y1 = 1;
        if (f.height > floor && overlap(column, above_all(f))) floor = f.height;
    }
    return floor;
}

bool Plan::is_level(const Footprint& box) const {
    if (platforms.empty()) return true;
    const float floor = floor_below(box);
    const Footprint inner = shrunk(box, kTouch);  // what only touches a riser stands below it
    for (const Vec2f corner : corners_of(inner))
        if (floor_at(corner) != floor) return false;
    return floor_at(box.center) == floor;
}

float Plan::floor_before(const WallFace& face, float u0, float u1) const {
    if (platforms.empty()) return 0;
    const Vec2f middle = flat(face.point((u0 + u1) / 2, 0) + face.inward * kTouch);
    return floor_below({middle, {(u1 - u0) / 2, kTouch}, yaw_of(face.inward), 0, 1});
}

void add_tiers(const PromptSpec& spec, Plan& plan) {
    const RecipeStep* rows = rising_rows(recipe_of(spec.room));
    const bool cut = has_cut_corners(plan);  // tiers are rectangles
    if (!rows || plan.knee > 0 || cut) return;
    const Seen seen(plan, rows->towards);
    const std::vector<std::pair<float, float>> ways = aisles(*rows, seen.wide());
    if (seen.wide() < rows->aisle_m + 2 * rows->side_m + (rows->aisle_m > 0 ? 2 : 1) * kLeastBlock) return;
    int count = static_cast<int>((seen.deep() - rows->front_m - rows->rear_m) / rows->pitch_m);
    if (rows->rows > 0) count = std::min(count, rows->rows);
    if (count < 2) return;
    float rise = std::min(rows->rise_m, (plan.wall_top() - kHeadRoom) / static_cast<float>(count - 1));
    if (ways.empty()) rise = std::min(rise, kMostStep);
    if (rise < kLeastRise) return;
    if (!plan.asked("wainscoting")) plan.panelling = false;  // a dado would run into the tiers
    const int steps = static_cast<int>(std::ceil(rise / kMostStep - 1e-3f));
    const float tread = rows->pitch_m / static_cast<float>(steps);
    for (int i = 1; i < count; ++i) {
        const float begins = rows->front_m + static_cast<float>(i) * rows->pitch_m,
                    ends = i + 1 < count ? rows->front_m + static_cast<float>(i + 1) * rows->pitch_m : seen.deep(),
                    below = rise * static_cast<float>(i - 1);
        for (const auto& [left, right] : ways)
            for (int k = 1; k < steps; ++k)
                plan.platforms.push_back(seen.box(Platform::Kind::step, begins - tread * static_cast<float>(steps - k),
                                                  begins - tread * static_cast<float>(steps - k - 1), left, right,
                                                  below + rise * static_cast<float>(k) / static_cast<float>(steps)));
        plan.platforms.push_back(seen.box(Platform::Kind::tier, begins, ends, -seen.wide() / 2, seen.wide() / 2,
                                          rise * static_cast<float>(i)));
    }
}

void lift_windows(PromptSpec& spec, Plan& plan) {
    if (plan.platforms.empty()) return;
    constexpr float kLeastSill = 0.6f, kAbove = 0.2f, kLowest = 0.5f;  // metres: above the floor, the head, of a pane
    std::erase_if(plan.openings, [&](Opening& o) {
        const WallFace face = plan.wall(o.wall);
        const float floor = plan.floor_before(face, o.u0, o.u1);
        if (o.kind != Opening::Kind::window || !(o.y0 < floor + kLeastSill) || !(floor > 0)) return false;
        const float top = plan.wall_top() - kAbove, high = std::min(o.y1 - o.y0, top - floor - kLeastSill);
        o.y0 = std::min(floor + std::max(o.y0, kLeastSill), top - high), o.y1 = o.y0 + high;
        if (high >= kLowest) return false;
        if (o.requested) spec.not_placed.push_back("window: the seats rise too high for it");
        return true;
    });
}

void move_door(Plan& plan, Opening& door) {
    if (plan.platforms.empty()) return;
    constexpr float kFromCorner = 0.6f, kBeside = 0.15f, kTry = 0.1f;
    // Beside who sits on the first rows, at his left or his right, whichever was drawn for the usual wall.
    const bool right = door.u0 > plan.wall(door.wall).length / 2;
    const auto fits = [&](int wall, float u0, float wide) {
        return std::none_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& o) {
            return o.wall == wall && u0 < o.u1 + kBeside && u0 + wide > o.u0 - kBeside && o.y0 < door.y1 + kBeside;
        });
    };
    const std::array walls{right ? 1 : 3, right ? 3 : 1, 0, 2};
    for (const float wide : {door.u1 - door.u0, RoomDoor{}.width_m})  // better a narrow door than none
        for (const int wall : walls) {
            const auto [low, high] = plan.free_span(wall, door.y1 + kBeside, true);
            const bool from_low = low < plan.wall(wall).length - high;  // from the corner before the seats
            for (float off = kFromCorner; off + wide + kBeside <= high - low; off += kTry) {
                const float u0 = from_low ? low + off : high - off - wide;
                if (!fits(wall, u0, wide)) continue;
                door.wall = wall, door.u0 = u0, door.u1 = u0 + wide;
                return;
            }
        }
    plan.platforms.clear();  // better a level floor than a door below it
}

}  // namespace fastscene
