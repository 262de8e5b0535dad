#include "fastscene/rooms/layout_patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "fastscene/rooms/layout_pattern.h"

namespace fastscene::furnishing {
namespace {

constexpr float kSeatDeep = 0.5f;      // floor that a seat at a table takes, drawn up to it
constexpr float kLeastClear = 0.9f;    // a piece that wants so much floor before it is gone to: tables keep off
constexpr float kDrawnUp = 0.02f;      // between a desk and its chair
constexpr float kLeastCounter = 1.1f;  // metres

Vec2f direction(float yaw) { return flat(front_of(yaw)); }
float yaw_towards(int wall) {
    constexpr std::array<float, 4> kYaw{0.f, kPi / 2, kPi, -kPi / 2};
    return kYaw[static_cast<std::size_t>(wall)];
}
// Of the plan's box along a direction of an axis.
float extent_of(const Plan& plan, Vec2f axis) { return std::abs(axis.x) * plan.width + std::abs(axis.y) * plan.depth; }

// A seat drawn up to the front of a piece, looking at it.
void seat_before(Placement& p, Pattern& seats, int at, float gap, float aside) {
    if (!seats.open()) return;
    const Placed anchor = p.at(at);
    const Piece seat = seats.piece();
    const Vec3f spot = anchor.position + front_of(anchor.yaw) * (anchor.piece.size_m.z / 2 + gap + seat.size_m.z / 2) +
                       right_of(anchor.yaw) * aside;
    const auto index = seats.place([&](const PromptObject& o) {
        return p.layout().stand_at(seat, flat(spot), std::remainder(anchor.yaw + kPi, 2 * kPi), o, {});
    });
    if (index) p.layout().join(*index, at);
}

// ---- rows that look at a wall

// Where the pieces of a row stand along it.
std::vector<float> along_row(const RecipeStep& step, float length, float size) {
    const float gap = step.gap_m, free = length - 2 * step.side_m;
    std::vector<float> at;
    const auto fit = [&](float space) {
        const int most = static_cast<int>((space + gap) / (size + gap));
        return step.block > 0 ? std::min(step.block, most) : most;
    };
    if (step.aisle_m > 0) {
        const int count = fit((free - step.aisle_m) / 2);
        for (int i = 0; i < count; ++i) {
            const float off = step.aisle_m / 2 + size / 2 + static_cast<float>(i) * (size + gap);
            at.push_back(-off), at.push_back(off);
        }
        std::sort(at.begin(), at.end());
    } else {
        const int count = fit(free);
        for (int i = 0; i < count; ++i)
            at.push_back((static_cast<float>(i) - static_cast<float>(count - 1) / 2) * (size + gap));
    }
    return at;
}

void place_rows(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    const Plan& plan = p.layout().plan();
    const bool tiered = step.rise_m > 0 && !plan.platforms.empty();
    Pattern row(p, thing, step.alike, true), seats(p, step.seat, true);
    if (!row.open() || !is_due(p, step, thing)) return;
    const float yaw = yaw_towards(step.towards);
    // One looks at the front of a desk from behind it: with a seat the piece is turned to that.
    const float stands = step.seat.empty() ? yaw : std::remainder(yaw + kPi, 2 * kPi);
    const Vec2f ahead = direction(yaw), right = flat(right_of(yaw));
    const Vec3f size = row.piece().size_m;
    const float deep = extent_of(plan, ahead), pitch = std::max(step.pitch_m, size.z + 0.02f);
    const auto fill = [&](const std::vector<float>& columns, float front, float rear, int most) {
        int rows = 0;
        // On tiers, backs are where the next one rises.
        const float behind = tiered ? kBehindRow : 0.f, before = tiered ? pitch - size.z - behind : 0.f;
        for (float at = deep / 2 - front - before - size.z / 2; at - size.z / 2 - behind > rear - deep / 2;
             at -= pitch) {
            if (most > 0 && rows++ >= most) return;
            for (const float column : columns) {
                if (!row.open()) return;
                const Piece piece = row.piece();
                const auto index = row.place([&](const PromptObject& o) {
                    return p.layout().stand_at(piece, ahead * at + right * column, stands, o, {});
                });
                if (!index) continue;
                if (!step.seat.empty()) seat_before(p, seats, *index, kDrawnUp, 0);
                follow_steps(step.then, p, *index);
            }
        }
    };
    std::vector<float> usual = along_row(step, extent_of(plan, right), size.x);
    if (usual.empty() && !tiered) {                               // narrower ways, before most of the rows are left out
        constexpr float kNarrowAisle = 0.9f, kNarrowSide = 0.2f;  // metres
        RecipeStep narrow = step;
        narrow.aisle_m = std::min(step.aisle_m, kNarrowAisle), narrow.side_m = std::min(step.side_m, kNarrowSide);
        usual = along_row(narrow, extent_of(plan, right), size.x);
    }
    fill(usual, step.front_m, step.rear_m, step.rows);
    // In a room too small for them as they usually are, one row stands where there is a place, without an aisle.
    constexpr float kLeastFree = 0.15f, kShift = 0.2f;
    RecipeStep tight = step;
    tight.aisle_m = 0, tight.side_m = std::min(step.side_m, 2 * kLeastFree);
    const std::vector<float> columns = along_row(tight, extent_of(plan, right), size.x);
    for (float front = std::min(step.front_m, deep / 2); front > kLeastFree && row.first() < 0; front -= kShift)
        fill(columns, front, kLeastFree, 1);
}

// ---- tables on a grid

// In the way of what people go to: a counter's front.
bool is_in_a_way(const Layout& layout, Vec2f at, float half) {
    return std::any_of(layout.placed().begin(), layout.placed().end(), [&](const Placed& other) {
        const float front = other.piece.clearance_front_m;
        if (front < kLeastClear || other.piece.mount != Mount::floor || other.on >= 0) return false;
        Footprint zone = footprint_of(other);
        zone.center = zone.center + direction(other.yaw) * (zone.half.y + front / 2);
        zone.half.y = front / 2;
        return distance_to(zone, at) < half;
    });
}

void place_tables(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern tables(p, thing, step.alike, true);
    const PromptObject* like = nullptr;  // of whose kind all seats are
    if (!tables.open() || !is_due(p, step, thing)) return;
    const Plan& plan = p.layout().plan();
    constexpr float kDeepest = 0.8f;  // of a table whose length is said
    if (step.length_m > 0) tables.sized({step.length_m, 0, std::min(step.length_m, kDeepest)});
    const Vec3f size = tables.piece().size_m;
    const int along = std::max(1, static_cast<int>(size.x / 0.62f));
    const bool heads = step.seats > 2 * along;
    const float way = step.pitch_m > 0 ? step.pitch_m : kLeastClear, wide = size.x + (heads ? 2 * kSeatDeep : 0.1f),
                deep = size.z + 2 * kSeatDeep;
    const float width = plan.width - 2 * step.side_m, depth = plan.depth - step.front_m - step.rear_m;
    const int columns = static_cast<int>((width + way) / (wide + way)),
              rows = static_cast<int>((depth + way * 0.5f) / (deep + way * 0.5f));
    int placed = 0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            if (!tables.open() || (step.most > 0 && placed >= step.most)) return;
            const float x = width * ((static_cast<float>(i) + 0.5f) / static_cast<float>(columns) - 0.5f),
                        z = plan.depth / 2 - step.front_m -
                            depth * (static_cast<float>(j) + 0.5f) / static_cast<float>(rows);
            if (is_in_a_way(p.layout(), {x, z}, std::max(size.x, size.z) / 2)) continue;
            const Piece table = tables.piece();
            const float side = heads ? kSeatDeep : 0.f;
            const auto index = tables.place([&](const PromptObject& o) {
                return p.layout().stand_at(table, {x, z}, 0, o,
                                           {.left = side, .right = side, .front = 0.5f, .behind = 0.5f});
            });
            if (!index) continue;
            ++placed;
            if (!step.seat.empty() && p.is_furnished()) like = p.seats_of_pattern(*index, step.seat, step.seats, like);
            follow_steps(step.then, p, *index);
        }
}

// ---- a counter

// What stands at the wall behind the counter, side by side, as long as that.
void stand_behind(Placement& p, const std::string& thing, const WallFace& face, float from, float to) {
    Pattern units(p, thing, false);
    for (float u = from; u < to && units.open();) {
        const Piece unit = units.piece();
        const float half = unit.size_m.x / 2;
        if (u + 2 * half > to + 0.05f) return;
        const Vec3f at = face.point(u + half, 0) + face.inward * (kOffWall + unit.size_m.z / 2);
        const auto index = units.place(
            [&](const PromptObject& o) { return p.layout().stand_at(unit, flat(at), yaw_of(face.inward), o, {}); });
        u += index ? 2 * half + 0.01f : 0.1f;
    }
}

std::optional<int> counter_at(Placement& p, const RecipeStep& step, Pattern& counter, int wall) {
    const Plan& plan = p.layout().plan();
    const auto [low, high] = plan.free_span(wall, 2.1f);
    const float room = high - low - std::max(step.side_m, 0.f) - 0.1f;
    const float length = step.length_m > 0 ? std::min(step.length_m, room) : room;
    if (length < kLeastCounter) return {};
    const WallFace face = plan.wall(wall);
    counter.sized({length, 0, 0});
    const Piece piece = counter.piece();
    // The way in is at the right end.
    for (const float shift : {0.f, 0.5f, 1.f}) {
        const float middle = low + 0.1f + piece.size_m.x / 2 + shift * (room - piece.size_m.x);
        const Vec3f at = face.point(middle, 0) + face.inward * (step.off_m + piece.size_m.z / 2);
        const auto index = counter.place(
            [&](const PromptObject& o) { return p.layout().stand_at(piece, flat(at), yaw_of(face.inward), o, {}); });
        if (!index) continue;
        if (!step.back.empty())
            stand_behind(p, step.back, face, middle - piece.size_m.x / 2, middle + piece.size_m.x / 2);
        return index;
    }
    return {};
}

void place_counter(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern counter(p, thing, true);
    if (!counter.open() || !is_due(p, step, thing)) return;
    for (const int wall : step.walls)
        if (const auto index = counter_at(p, step, counter, wall)) return follow_steps(step.then, p, *index);
}

// Side by side before the front of a piece, each looking at it.
void place_line(Placement& p, const RecipeStep& step, int anchor) {
    const std::string thing = thing_of(step, p);
    Pattern seats(p, thing, true);
    if (!seats.open() || !is_due(p, step, thing)) return;
    const float length = p.size(anchor).x - 2 * step.side_m, pitch = step.pitch_m > 0 ? step.pitch_m : 0.65f;
    const int count = std::max(1, static_cast<int>(length / pitch));
    for (int i = 0; i < count; ++i)
        seat_before(p, seats, anchor, step.gap_m,
                    length * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f));
}

// ---- in the corners

// One in each corner that is free, its back and its right side at the walls.
void place_corners(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern corner(p, thing, true);
    if (!corner.open() || !is_due(p, step, thing)) return;
    constexpr float kOff = 0.012f;
    const Plan& plan = p.layout().plan();
    for (int wall = 0; wall < 4; ++wall) {
        if (!corner.open()) return;
        const WallFace face = plan.wall(wall);
        const Piece piece = corner.piece();
        const Vec3f at = face.point(kOff + piece.size_m.x / 2, 0) + face.inward * (kOff + piece.size_m.z / 2);
        const auto index = corner.place(
            [&](const PromptObject& o) { return p.layout().stand_at(piece, flat(at), yaw_of(face.inward), o, {}); });
        if (index) follow_steps(step.then, p, *index);
    }
}

// ---- at the ceiling

void place_lights(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern lights(p, thing, true);
    if (!lights.open() || !is_due(p, step, thing)) return;
    const Plan& plan = p.layout().plan();
    constexpr float kFree = 0.06f;  // about a piece that fills its cell: pieces that touch count as crossing
    const float pitch = step.pitch_m > 0 ? step.pitch_m : 2.4f;
    // Below a vault lamps hang where it is highest.
    const int columns = plan.vault != Vault::flat ? 1 : std::max(1, static_cast<int>(std::lround(plan.width / pitch))),
              rows = plan.vault == Vault::dome || plan.vault == Vault::cone
                         ? 1
                         : std::max(1, static_cast<int>(std::lround(plan.depth / pitch)));
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            if (!lights.open()) return;
            const Vec2f at{plan.width * ((static_cast<float>(i) + 0.5f) / static_cast<float>(columns) - 0.5f),
                           plan.depth * ((static_cast<float>(j) + 0.5f) / static_cast<float>(rows) - 0.5f)};
            if (std::abs(at.x) < step.aisle_m / 2) continue;
            const PromptObject* wish = p.wishes().next(thing);
            PieceRequest request = p.layout().request(thing, wish);
            if (step.fill)
                request.size_m.x = plan.width / static_cast<float>(columns) - kFree,
                request.size_m.z = plan.depth / static_cast<float>(rows) - kFree;
            const auto index = p.layout().hanging(request, at, wish ? *wish : PromptObject{});
            if (!index && wish) p.wishes().give_back(wish);
        }
}

}  // namespace

std::span<const StepKind> pattern_kinds() {
    static const std::array<StepKind, 10> all{{
        {"rows",
         {"thing", "first_asked", "other", "thing_share", "probability", "seat", "towards", "pitch_m", "rise_m",
          "gap_m", "aisle_m", "side_m", "front_m", "rear_m", "rows", "block", "alike", "then"},
         false,
         {},
         place_rows},
        {"tables",
         {"thing", "first_asked", "other", "thing_share", "probability", "seat", "seats", "pitch_m", "side_m",
          "front_m", "rear_m", "length_m", "most", "alike", "then"},
         false,
         {},
         place_tables},
        {"counter",
         {"thing", "first_asked", "probability", "back", "walls", "off_m", "side_m", "length_m", "then"},
         false,
         {},
         place_counter},
        {"line", {"thing", "first_asked", "probability", "pitch_m", "gap_m", "side_m"}, true, {}, place_line},
        {"run",
         {"thing", "first_asked", "other", "thing_share", "probability", "walls", "gap_m", "side_m", "off_m",
          "length_m", "block", "most", "alike", "then"},
         false,
         {},
         place_run},
        {"end",
         {"thing", "first_asked", "probability", "pattern", "walls", "off_m", "length_m", "then"},
         false,
         {},
         place_end},
        {"bare_walls",
         {"thing", "first_asked", "probability", "pattern", "walls", "pitch_m", "side_m", "length_m", "block", "most",
          "alike"},
         false,
         {},
         place_bare},
        {"all_around", {"thing", "first_asked", "probability"}, false, {}, place_around},
        {"corners", {"thing", "first_asked", "probability", "then"}, false, {}, place_corners},
        {"lights", {"thing", "first_asked", "probability", "pitch_m", "aisle_m", "fill"}, false, {}, place_lights},
    }};
    return all;
}

}  // namespace fastscene::furnishing
