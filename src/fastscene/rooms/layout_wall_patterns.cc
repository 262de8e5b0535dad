// Patterns along walls and on them.
#include <algorithm>
#include <vector>

#include "fastscene/rooms/layout_pattern.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene::furnishing {
// ---- along walls

void place_run(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern run(p, thing, step.alike);
    if (!run.open() || !is_due(p, step, thing)) return;
    if (step.length_m > 0) run.sized({step.length_m, 0, 0});
    constexpr float kTry = 0.1f;
    int placed = 0;
    for (const int wall : step.walls) {
        const WallFace face = p.layout().plan().wall(wall);
        int here = 0;
        for (float u = std::max(step.side_m, 0.02f); u < face.length - step.side_m;) {
            if (!run.open() || (step.most > 0 && placed >= step.most)) return;
            if (step.block > 0 && here >= step.block) break;
            const Piece piece = run.piece();
            const Vec3f s = piece.size_m;
            if (u + s.x > face.length - step.side_m + 0.02f) break;
            const auto index = run.place([&](const PromptObject& o) {
                if (s.x > 0 && piece.mount == Mount::wall) return p.layout().hang_at(piece, wall, u + s.x / 2, o);
                const Vec3f at = face.point(u + s.x / 2, 0) + face.inward * (kOffWall + step.off_m + s.z / 2);
                return p.layout().stand_at(piece, flat(at), yaw_of(face.inward), o, {}, true);
            });
            u += index ? s.x + std::max(step.gap_m, 0.01f) : kTry;
            if (!index) continue;
            ++placed, ++here;
            follow_steps(step.then, p, *index);
        }
    }
}

// ---- at the middle of a wall: an altar, a blackboard, a screen

void place_end(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern end(p, thing, true);
    if (!end.open() || !is_due(p, step, thing)) return;
    constexpr float kStep = 0.25f;
    constexpr int kSteps = 10;
    for (const int wall : step.walls) {
        const WallFace face = p.layout().plan().wall(wall);
        end.patterned(step.pattern);
        if (step.length_m > 0) end.sized({std::min(step.length_m, face.length - 0.6f), 0, 0});
        const Piece piece = end.piece();
        for (int i = 0; i <= 2 * kSteps; ++i) {
            const float aside = kStep * static_cast<float>((i + 1) / 2) * (i % 2 == 0 ? 1.f : -1.f),
                        u = face.length / 2 + aside;
            const auto index = end.place([&](const PromptObject& o) {
                if (piece.mount == Mount::wall) return p.layout().hang_at(piece, wall, u, o);
                const Vec3f at = face.point(u, 0) + face.inward * (step.off_m + kOffWall + piece.size_m.z / 2);
                return p.layout().stand_at(piece, flat(at), yaw_of(face.inward), o, {});
            });
            if (index) return follow_steps(step.then, p, *index);
        }
    }
}

// ---- where walls are bare

namespace {

// A stretch of a wall in which a piece may hang: from the first to the last place of its middle.
struct BareStretch {
    float from, to;
};

std::vector<BareStretch> bare_stretches(const Layout& layout, const Piece& piece, int wall) {
    constexpr float kTry = 0.1f;
    std::vector<BareStretch> found;
    bool open = false;
    const float length = layout.plan().wall(wall).length, half = piece.size_m.x / 2;
    for (float u = half; u <= length - half; u += kTry) {
        const bool free = layout.can_hang_at(piece, wall, u);
        if (free && !open) found.push_back({u, u});
        if (free) found.back().to = u;
        open = free;
    }
    return found;
}

}  // namespace

// As many as fit into each bare stretch of the walls, in its middle or evenly along it.
void place_bare(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern hung(p, thing, step.alike);
    if (!hung.open() || !is_due(p, step, thing)) return;
    hung.patterned(step.pattern);
    if (step.length_m > 0) hung.sized({step.length_m, 0, 0});
    int placed = 0;
    for (const int wall : step.walls)
        for (const BareStretch& bare : bare_stretches(p.layout(), hung.piece(), wall)) {
            const float free = bare.to - bare.from - 2 * step.side_m;
            if (free < 0) continue;
            int count = step.pitch_m > 0 ? 1 + static_cast<int>(free / step.pitch_m) : 1;
            if (step.block > 0) count = std::min(count, step.block);
            const float middle = (bare.from + bare.to) / 2,
                        pitch = step.block > 0 ? step.pitch_m : (free + step.pitch_m) / static_cast<float>(count);
            for (int i = 0; i < count; ++i) {
                if (!hung.open() || (step.most > 0 && placed >= step.most)) return;
                const Piece piece = hung.piece();
                const float u = middle + pitch * (static_cast<float>(i) - static_cast<float>(count - 1) / 2);
                placed += hung.place([&](const PromptObject& o) { return p.layout().hang_at(piece, wall, u, o); })
                              .has_value();
            }
        }
}

// ---- all around

// On every flat piece of wall between doors and windows, those of round corners too: lattice, rails, panels.
void place_around(Placement& p, const RecipeStep& step, int) {
    const std::string thing = thing_of(step, p);
    Pattern panels(p, thing, true);
    if (!panels.open() || !is_due(p, step, thing)) return;
    constexpr float kBeside = 0.12f, kJoint = 0.012f, kNarrowest = 0.15f;  // metres: of openings, between panels
    const Plan& plan = p.layout().plan();
    for (const WallFace& face : plan.faces()) {
        if (face.behind > 0) continue;
        for (const auto& [from, to] : shell::between_openings(plan, face, 0, plan.wall_top(), kBeside)) {
            if (to - from < kNarrowest) continue;
            panels.sized({to - from - 2 * kJoint, 0, 0});
            const Piece piece = panels.fresh_piece();
            panels.place([&](const PromptObject& o) { return p.layout().hang_on(piece, face, (from + to) / 2, o); });
        }
    }
}

}  // namespace fastscene::furnishing
