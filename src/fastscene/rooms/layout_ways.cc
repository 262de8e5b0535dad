#include "fastscene/rooms/layout_ways.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/rooms/layout.h"

namespace fastscene {
namespace {

constexpr float kCell = 0.1f;
constexpr float kEyeBand = 0.7f;             // heights that count for that: as Layout::camera_position has it
constexpr float kHead = 1.75f;               // of who walks
constexpr float kStepOver = 1.2f;            // what hangs higher is walked under (or beside: wall lamps, pictures)
constexpr float kClimb = kMostStep + 0.05f;  // from one cell to the next
constexpr float kSlim = 0.1f;                // half the width of a slim body
constexpr float kUnderfoot = 0.05f;          // what ends lower stands on a lower tier

}  // namespace

Ways::Ways(const Plan& plan, const Passage& passage)
    : plan_(&plan),
      passage_(passage),
      columns_(std::max(1, static_cast<int>(plan.width / kCell))),
      rows_(std::max(1, static_cast<int>(plan.depth / kCell))) {
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) {
            const Vec2f p = center(i, j);
            const float floor = plan.floor_at(p);
            if (!plan.platforms.empty()) floors_.push_back(floor);
            // Below a slope one walks where one can stand.
            const float wall = plan.wall_distance(p), head = plan.ceiling_at(p) < floor + kHead ? 0.f : wall;
            cells_.push_back({head, std::min(wall, plan.air_around({p.x, floor + kEyeHeight, p.y})), head});
        }
    for (const Opening& o : plan.openings) {
        if (o.kind != Opening::Kind::door) continue;
        const WallFace face = plan.wall(o.wall);
        for (const float far : {0.35f, 0.45f, 0.55f}) {
            const Vec3f p = face.point((o.u0 + o.u1) / 2, 0) + face.inward * far;
            starts_.push_back(cell_near({p.x, p.z}));
        }
    }
    for (const Opening& o : plan.openings) {
        if (o.kind != Opening::Kind::doorway) continue;
        const WallFace face = plan.wall(o.wall);
        const Vec3f p = face.point((o.u0 + o.u1) / 2, 0) + face.inward * 0.45f;
        (starts_.empty() ? starts_ : goals_).push_back(cell_near({p.x, p.z}));
    }
    walked_ = walked(cells_);
    open_ = leads_to_a_view(cells_, walked_);
}

Vec2f Ways::center(int i, int j) const {
    return {(static_cast<float>(i) + 0.5f) * kCell - plan_->width / 2,
            (static_cast<float>(j) + 0.5f) * kCell - plan_->depth / 2};
}

int Ways::cell_near(Vec2f p) const {
    const int i = std::clamp(static_cast<int>((p.x + plan_->width / 2) / kCell), 0, columns_ - 1),
              j = std::clamp(static_cast<int>((p.y + plan_->depth / 2) / kCell), 0, rows_ - 1);
    return j * columns_ + i;
}

bool Ways::narrow(std::vector<Clear>& cells, const Placed& placed) const {
    if (placed.flat) return false;
    const Footprint box = footprint_of(placed);
    // One steps over a toy.
    constexpr float kToyHigh = 0.36f, kToyWide = 0.34f;
    const bool toy = box.y1 < kToyHigh && std::max(box.half.x, box.half.y) < kToyWide / 2;
    const bool in_the_way = placed.on < 0 && !placed.overhead && placed.piece.kind != "curtain",
               stands = in_the_way && !toy;
    bool feet = stands && box.y0 < kStepOver, ground = in_the_way && box.y0 < kStepOver;
    bool eyes = box.y1 > kEyeHeight - kEyeBand && box.y0 < kEyeHeight + kEyeBand;
    const bool tiers = !floors_.empty();
    if (!ground && !eyes && !tiers) return false;
    // Only distances below the radii count: the cells around it.
    const auto axes = axes_of(box);
    const float reach = (eyes || tiers ? passage_.eye_radius : passage_.body_radius) + kCell;
    const auto span = [&](float middle, float half, float size, int count) {
        return std::pair{std::clamp(static_cast<int>((middle - half - reach + size / 2) / kCell), 0, count),
                         std::clamp(static_cast<int>((middle + half + reach + size / 2) / kCell) + 1, 0, count)};
    };
    const auto [i0, i1] = span(box.center.x, extent(box, {1, 0}), plan_->width, columns_);
    const auto [j0, j1] = span(box.center.y, extent(box, {0, 1}), plan_->depth, rows_);
    bool narrower = false;
    for (int j = j0; j < j1; ++j)
        for (int i = i0; i < i1; ++i) {
            Clear& cell = cells[static_cast<std::size_t>(j * columns_ + i)];
            if (tiers) {
                const float floor = floor_of(j * columns_ + i), eye = floor + kEyeHeight;
                ground = in_the_way && box.y0 < floor + kStepOver && box.y1 > floor + kUnderfoot;
                feet = stands && ground;
                eyes = box.y1 > eye - kEyeBand && box.y0 < eye + kEyeBand;
            }
            const float far = distance_to(box, axes, center(i, j));
            narrower |= (feet && cell.feet >= passage_.body_radius && far < passage_.body_radius) ||
                        (ground && cell.ground >= kSlim && far < kSlim) ||
                        (eyes && cell.eyes >= passage_.eye_radius && far < passage_.eye_radius);
            if (feet) cell.feet = std::min(cell.feet, far);
            if (ground) cell.ground = std::min(cell.ground, far);
            if (eyes) cell.eyes = std::min(cell.eyes, far);
        }
    return narrower;
}

// The cells that can be walked to from the door.
std::vector<char> Ways::walked(const std::vector<Clear>& cells) const {
    const auto free = [&](int k) { return cells[static_cast<std::size_t>(k)].feet >= passage_.body_radius; };
    std::vector<char> seen(cells.size(), 0);
    std::vector<int> todo;
    const auto enter = [&](int k) {
        if (free(k) && !seen[static_cast<std::size_t>(k)]) seen[static_cast<std::size_t>(k)] = 1, todo.push_back(k);
    };
    for (const int k : starts_) enter(k);
    if (starts_.empty())  // no door: whoever is inside may be anywhere
        for (int k = 0; k < static_cast<int>(cells.size()); ++k) enter(k);
    while (!todo.empty()) {
        const int k = todo.back(), i = k % columns_, j = k / columns_;
        todo.pop_back();
        const auto visit = [&](int n) {
            if (std::abs(floor_of(n) - floor_of(k)) < kClimb) enter(n);
        };
        if (i > 0) visit(k - 1);
        if (i + 1 < columns_) visit(k + 1);
        if (j > 0) visit(k - columns_);
        if (j + 1 < rows_) visit(k + columns_);
    }
    return seen;
}

bool Ways::leads_to_a_view(const std::vector<Clear>& cells, const std::vector<char>& walked) const {
    for (const int goal : goals_)
        if (!walked[static_cast<std::size_t>(goal)]) return false;
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (walked[k] && cells[k].eyes >= passage_.eye_radius) return true;
    return false;
}

Ways::FreeFloor Ways::cut_off(const std::vector<Clear>& cells) const {
    std::vector<char> seen(cells.size(), 0);
    std::vector<int> todo;
    int all = 0, largest = 0;
    const auto enter = [&](int k) {
        if (seen[static_cast<std::size_t>(k)] || cells[static_cast<std::size_t>(k)].ground < kSlim) return;
        seen[static_cast<std::size_t>(k)] = 1, todo.push_back(k);
    };
    for (int start = 0; start < static_cast<int>(cells.size()); ++start) {
        enter(start);
        int count = 0;
        for (; !todo.empty(); ++count) {
            const int k = todo.back(), i = k % columns_, j = k / columns_;
            todo.pop_back();
            for (int b = std::max(0, j - 1); b < std::min(rows_, j + 2); ++b)
                for (int a = std::max(0, i - 1); a < std::min(columns_, i + 2); ++a)
                    if (const int n = b * columns_ + a; std::abs(floor_of(n) - floor_of(k)) < kClimb) enter(n);
        }
        all += count, largest = std::max(largest, count);
    }
    return {static_cast<float>(all) * kCell * kCell, static_cast<float>(all - largest) * kCell * kCell};
}

bool Ways::cuts_off(const Placed& extra) const {
    std::vector<Clear> cells = cells_;
    if (!narrow(cells, extra)) return false;
    const FreeFloor after = cut_off(cells);
    return after.apart > std::max(kFewCutOff, kShareCutOff * after.all) && after.apart > cut_off(cells_).apart;
}

void Ways::add(const Placed& placed) {
    if (!narrow(cells_, placed)) return;
    walked_ = walked(cells_);
    open_ = leads_to_a_view(cells_, walked_);
}

bool Ways::open_with(const Placed& extra) const {
    if (!open_) return false;
    std::vector<Clear> cells = cells_;
    return !narrow(cells, extra) || leads_to_a_view(cells, walked(cells));
}

bool Ways::reaches(Vec2f point) const {
    constexpr float kHalfStep = 0.3f;
    constexpr int kCells = static_cast<int>(kHalfStep / kCell) + 1;
    const int middle = cell_near(point), i0 = middle % columns_, j0 = middle / columns_;
    for (int j = std::max(0, j0 - kCells); j < std::min(rows_, j0 + kCells + 1); ++j)
        for (int i = std::max(0, i0 - kCells); i < std::min(columns_, i0 + kCells + 1); ++i)
            if (walked_[static_cast<std::size_t>(j * columns_ + i)] && length(center(i, j) - point) < kHalfStep)
                return true;
    return false;
}

}  // namespace fastscene
