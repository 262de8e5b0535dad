#include "fastscene/film/route.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

constexpr float kCell_m = 0.05f;
// Below this distance to an edge a metre costs up to four times as much: the camera keeps to the middle where it can.
constexpr float kComfort_m = 0.35f, kDearest = 3.f;

float segment_distance(Vec2f p, Vec2f a, Vec2f b) {
    const Vec2f way = b - a;
    const float all = dot(way, way);
    const float t = all > 0 ? std::clamp(dot(p - a, way) / all, 0.f, 1.f) : 0.f;
    const Vec2f gap = p - (a + way * t);
    return std::hypot(gap.x, gap.y);
}

float distance(Vec2f a, Vec2f b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Points of a polyline in equal steps of about kCurveStep_m.
std::vector<Vec2f> resampled(const std::vector<Vec2f>& line) {
    float whole = 0;
    for (std::size_t i = 1; i < line.size(); ++i) whole += distance(line[i - 1], line[i]);
    const int steps = std::max(1, static_cast<int>(std::round(whole / kCurveStep_m)));
    std::vector<Vec2f> out{line.front()};
    std::size_t i = 1;
    float passed = 0;
    for (int k = 1; k < steps; ++k) {
        const float at = whole * static_cast<float>(k) / static_cast<float>(steps);
        while (i + 1 < line.size() && passed + distance(line[i - 1], line[i]) < at)
            passed += distance(line[i - 1], line[i]), ++i;
        const float part = distance(line[i - 1], line[i]);
        const float t = part > 0 ? std::clamp((at - passed) / part, 0.f, 1.f) : 0.f;
        out.push_back(line[i - 1] + (line[i] - line[i - 1]) * t);
    }
    if (line.size() > 1) out.push_back(line.back());
    return out;
}

}  // namespace

float clearance(const WalkableArea& area, Vec2f point) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const auto& ring : area.rings_m)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            nearest = std::min(nearest, segment_distance(point, ring[j], ring[i]));
    return contains(area, point) ? nearest : -nearest;
}

FloorGrid::FloorGrid(const WalkableArea& area, Vec2f start) {
    Vec2f low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (const auto& ring : area.rings_m)
        for (const Vec2f p : ring) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    constexpr float kMost_m = 200;  // a grid of a hall, not of a landscape
    if (!(high.x > low.x && high.y > low.y) || high.x - low.x > kMost_m || high.y - low.y > kMost_m)
        throw Error("expected a walkable floor of at most {} m, found {} x {} m", kMost_m, high.x - low.x,
                    high.y - low.y);
    corner_ = low;
    columns_ = static_cast<int>((high.x - low.x) / kCell_m) + 1,
    rows_ = static_cast<int>((high.y - low.y) / kCell_m) + 1;
    const auto center = [&](std::size_t cell) {
        const auto x = static_cast<float>(cell % static_cast<std::size_t>(columns_)),
                   y = static_cast<float>(cell / static_cast<std::size_t>(columns_));
        return Vec2f{corner_.x + (x + 0.5f) * kCell_m, corner_.y + (y + 0.5f) * kCell_m};
    };
    const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    std::vector<float> clear(cells);
    std::size_t first = cells;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        clear[cell] = clearance(area, center(cell));
        if (clear[cell] > 0 && (first == cells || distance(center(cell), start) < distance(center(first), start)))
            first = cell;
    }
    if (first == cells) throw Error("expected a walkable floor, found none");
    place_of_cell_.assign(cells, -1);
    const auto take = [&](std::size_t cell) {
        place_of_cell_[cell] = static_cast<int>(places_.size());
        cell_of_place_.push_back(cell), places_.push_back(center(cell)), clear_.push_back(clear[cell]);
    };
    take(first);
    for (std::size_t k = 0; k < places_.size(); ++k) {  // grows while it is walked through
        const auto x = static_cast<int>(cell_of_place_[k] % static_cast<std::size_t>(columns_)),
                   y = static_cast<int>(cell_of_place_[k] / static_cast<std::size_t>(columns_));
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            if (x + dx < 0 || y + dy < 0 || x + dx >= columns_ || y + dy >= rows_) continue;
            const auto cell = static_cast<std::size_t>(y + dy) * static_cast<std::size_t>(columns_) +
                              static_cast<std::size_t>(x + dx);
            if (clear[cell] > 0 && place_of_cell_[cell] < 0) take(cell);
        }
    }
}

std::size_t FloorGrid::nearest(Vec2f point) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < places_.size(); ++i)
        if (distance(places_[i], point) < distance(places_[best], point)) best = i;
    return best;
}

std::vector<std::size_t> FloorGrid::neighbours(std::size_t place) const {
    std::vector<std::size_t> found;
    const auto x = static_cast<int>(cell_of_place_[place] % static_cast<std::size_t>(columns_)),
               y = static_cast<int>(cell_of_place_[place] / static_cast<std::size_t>(columns_));
    const auto at = [&](int cx, int cy) {
        return cx < 0 || cy < 0 || cx >= columns_ || cy >= rows_
                   ? -1
                   : place_of_cell_[static_cast<std::size_t>(cy * columns_ + cx)];
    };
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            // A diagonal step must not cut a corner.
            if ((dx == 0 && dy == 0) || at(x + dx, y) < 0 || at(x, y + dy) < 0) continue;
            if (const int next = at(x + dx, y + dy); next >= 0) found.push_back(static_cast<std::size_t>(next));
        }
    return found;
}

FloorGrid::Ways FloorGrid::ways_from(std::size_t place) const {
    Ways ways{std::vector<float>(places_.size(), std::numeric_limits<float>::infinity()),
              std::vector<std::size_t>(places_.size(), place)};
    using Entry = std::pair<float, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    ways.cost[place] = 0;
    open.push({0.f, place});
    while (!open.empty()) {
        const auto [cost, here] = open.top();
        open.pop();
        if (cost > ways.cost[here]) continue;
        for (const std::size_t next : neighbours(here)) {
            const float tight = std::max(0.f, 1 - clear_[next] / kComfort_m);
            const float onward = cost + distance(places_[here], places_[next]) * (1 + kDearest * tight * tight);
            if (onward >= ways.cost[next]) continue;
            ways.cost[next] = onward, ways.before[next] = here;
            open.push({onward, next});
        }
    }
    return ways;
}

std::vector<Vec2f> FloorGrid::way(const Ways& ways, std::size_t to) const {
    std::vector<Vec2f> back{places_[to]};
    while (ways.before[to] != to) back.push_back(places_[to = ways.before[to]]);
    std::reverse(back.begin(), back.end());
    return back;
}

std::vector<Vec2f> smooth_curve(const WalkableArea& area, const std::vector<Vec2f>& way) {
    std::vector<Vec2f> line = resampled(way);
    std::vector<float> clear;
    for (const Vec2f p : line) clear.push_back(clearance(area, p));
    // Tension pulls the line straight; with stiffness it bends in long curves. Each move must keep its distance.
    constexpr int kRounds = 400;
    for (int round = 0; round < kRounds; ++round) {
        const bool stiff = round % 2 == 1;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            Vec2f to = (line[i - 1] + line[i + 1]) * 0.5f;
            if (stiff && i >= 2 && i + 2 < line.size())
                to = (line[i - 1] + line[i + 1]) * (4.f / 6) - (line[i - 2] + line[i + 2]) * (1.f / 6);
            const float there = clearance(area, to);
            if (there < std::min(kCurveMargin_m, clear[i])) continue;
            line[i] = to, clear[i] = there;
        }
    }
    return resampled(line);
}

}  // namespace fastscene
