#include "fastscene/rooms/layout_ways.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/layout.h"

namespace fastscene {
namespace {

constexpr float kCell = 0.1f;
constexpr float kBodyRadius = 0.27f;  // a walkway of about 0.55 m
constexpr float kEyeRadius = 0.65f;   // air that the camera wants around it
constexpr float kEyeBand = 0.7f;      // heights that count for that: as Layout::camera_position has it
constexpr float kHead = 1.75f;        // of who walks
constexpr float kStepOver = 1.2f;     // what hangs higher is walked under (or beside: wall lamps, pictures)

}  // namespace

Ways::Ways(const Plan& plan)
    : plan_(&plan),
      columns_(std::max(1, static_cast<int>(plan.width / kCell))),
      rows_(std::max(1, static_cast<int>(plan.depth / kCell))) {
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) {
            const Vec2f p = center(i, j);
            // Below a slope one walks where one can stand.
            const float wall = plan.wall_distance(p), head = plan.ceiling_at(p) < kHead ? 0.f : wall;
            cells_.push_back({head, std::min(wall, plan.air_around({p.x, kEyeHeight, p.y}))});
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
    open_ = leads_to_a_view(cells_);
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

void Ways::narrow(std::vector<Clear>& cells, const Placed& placed) const {
    if (placed.flat) return;
    const Footprint box = footprint_of(placed);
    // One steps over a toy.
    constexpr float kToyHigh = 0.36f, kToyWide = 0.34f;
    const bool toy = box.y1 < kToyHigh && std::max(box.half.x, box.half.y) < kToyWide / 2;
    const bool feet = !toy && placed.on < 0 && !placed.overhead && box.y0 < kStepOver && placed.piece.kind != "curtain";
    const bool eyes = box.y1 > kEyeHeight - kEyeBand && box.y0 < kEyeHeight + kEyeBand;
    if (!feet && !eyes) return;
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) {
            Clear& cell = cells[static_cast<std::size_t>(j * columns_ + i)];
            const float far = distance_to(box, center(i, j));
            if (feet) cell.feet = std::min(cell.feet, far);
            if (eyes) cell.eyes = std::min(cell.eyes, far);
        }
}

// The cells that can be walked to from the door.
std::vector<char> Ways::walked(const std::vector<Clear>& cells) const {
    const auto free = [&](int k) { return cells[static_cast<std::size_t>(k)].feet >= kBodyRadius; };
    std::vector<char> seen(cells.size(), 0);
    std::vector<int> todo;
    const auto visit = [&](int k) {
        if (free(k) && !seen[static_cast<std::size_t>(k)]) seen[static_cast<std::size_t>(k)] = 1, todo.push_back(k);
    };
    for (const int k : starts_) visit(k);
    if (starts_.empty())  // no door: whoever is inside may be anywhere
        for (int k = 0; k < static_cast<int>(cells.size()); ++k) visit(k);
    while (!todo.empty()) {
        const int k = todo.back(), i = k % columns_, j = k / columns_;
        todo.pop_back();
        if (i > 0) visit(k - 1);
        if (i + 1 < columns_) visit(k + 1);
        if (j > 0) visit(k - columns_);
        if (j + 1 < rows_) visit(k + columns_);
    }
    return seen;
}

bool Ways::leads_to_a_view(const std::vector<Clear>& cells) const {
    const std::vector<char> seen = walked(cells);
    for (const int goal : goals_)
        if (!seen[static_cast<std::size_t>(goal)]) return false;
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (seen[k] && cells[k].eyes >= kEyeRadius) return true;
    return false;
}

void Ways::add(const Placed& placed) {
    narrow(cells_, placed);
    open_ = leads_to_a_view(cells_);
}

bool Ways::open_with(const Placed& extra) const {
    std::vector<Clear> cells = cells_;
    narrow(cells, extra);
    return leads_to_a_view(cells);
}

bool Ways::reaches(Vec2f point) const {
    const std::vector<char> seen = walked(cells_);
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i)
            if (seen[static_cast<std::size_t>(j * columns_ + i)] && length(center(i, j) - point) < 0.3f) return true;
    return false;
}

}  // namespace fastscene
