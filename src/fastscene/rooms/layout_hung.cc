// What hangs at windows, over openings and from the ceiling.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene {
namespace {

// A rail runs along the nearest beam, below it; a lamp with a plate goes between two beams; what hangs by a rod or a
// cord that meets a beam hangs from that.
void hang_among_beams(const Plan& plan, Placed& p) {
    constexpr float kRod = 0.08f;  // half of what covers its end
    const bool rail = p.piece.kind == "track_light", plate = p.piece.kind == "ceiling_lamp";
    const float spacing = plan.depth / static_cast<float>(beam_count(plan)), offset = p.position.z - beam_z(plan, 0);
    const float beam = beam_z(plan,
                              std::clamp(static_cast<int>(std::lround(offset / spacing)), 0, beam_count(plan) - 1));
    const int gap = std::clamp(static_cast<int>(std::floor(offset / spacing)), 0, beam_count(plan) - 2);
    const bool meets = std::abs(p.position.z - beam) < kBeamWidth / 2 + (plate ? p.piece.size_m.z / 2 : kRod);
    if (!rail && !meets) return;
    p.position.z = plate ? beam_z(plan, gap) + spacing / 2 : beam;
    if (!plate) p.position.y -= kBeamDepth;
}

}  // namespace

std::optional<int> Layout::over_opening(const std::string& kind, const PieceRequest& request,
                                        const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    if (p.piece.mount == Mount::surface) mount_as(p.piece, Mount::wall), p.piece.hang_height_m = 0;
    if (p.piece.mount != Mount::wall) return {};
    constexpr float kCasing = 0.09f;
    for (const Opening& o : plan_.openings) {
        if (!is_opening_of(o, kind)) continue;
        const WallFace face = plan_.wall(o.wall);
        p.yaw = yaw_of(face.inward);
        p.position = face.point((o.u0 + o.u1) / 2, o.y1 + kCasing + 0.02f) + face.inward * 0.002f;
        const Footprint box = footprint_of(p);
        if (!plan_.holds(box) || box.y1 > plan_.wall_top() - 0.03f) continue;
        if (std::none_of(placed_.begin(), placed_.end(),
                         [&](const Placed& other) { return !other.flat && overlap(box, footprint_of(other)); }))
            return keep(p, from);
    }
    return {};
}

std::optional<int> Layout::hanging(const PieceRequest& request, Vec2f at, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    p.overhead = true;
    p.position = {at.x, plan_.height, at.y};
    for (const Vec2f corner : corners_of(footprint_of(p)))  // below a vault or a mezzanine all of it
        if (plan_.vault != Vault::flat || plan_.mezzanine.depth > 0)
            p.position.y = std::min(p.position.y, plan_.ceiling_at(corner));
    if (plan_.beams && !(plan_.knee > 0)) hang_among_beams(plan_, p);
    if (!plan_.holds(footprint_of(p)) && !has_role(p.piece.kind, Role::roof)) return {};
    // Nor into what hangs above a tier.
    constexpr float kHead = 2.f;
    if (const float floor = plan_.floor_below(footprint_of(p)); floor > 0 && footprint_of(p).y0 < floor + kHead)
        return {};
    for (const Placed& other : placed_)
        if (!other.flat && (overlap(footprint_of(p, 0.05f), footprint_of(other)) || hides(p, other))) return {};
    // Nobody walks into it who comes through a door.
    for (const Opening& o : plan_.openings) {
        constexpr float kPassing = 0.8f;  // metres; a leaf opens as far as it is wide
        const float deep = o.kind == Opening::Kind::door ? std::max(kPassing, o.u1 - o.u0) : kPassing;
        const WallFace face = plan_.wall(o.wall);
        const Vec3f before = face.point((o.u0 + o.u1) / 2, 0) + face.inward * (deep / 2);
        if ((o.kind != Opening::Kind::window || is_doors(o.glazing)) &&
            overlap(footprint_of(p), {flat(before), {(o.u1 - o.u0) / 2, deep / 2}, yaw_of(face.inward), 0, o.y1}))
            return {};
    }
    if (!leaves_way(p, from)) return {};
    return keep(p, from);
}

std::optional<int> Layout::in_upper_corner(const PieceRequest& request, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    p.overhead = true;
    const Vec3f half = p.piece.size_m * 0.5f;
    const int first = rng_.index(4);
    for (int k = 0; k < 4; ++k) {
        // Its own walls are at -x and -z: a quarter turn for each corner.
        const int corner = (first + k) % 4;
        p.yaw = kPi / 2 * static_cast<float>(corner);
        const Vec3f out = right_of(p.yaw) * -1.f - front_of(p.yaw);
        const float gap = 0.004f, across = corner % 2 == 0 ? half.x : half.z, along = corner % 2 == 0 ? half.z : half.x;
        p.position = {(out.x < 0 ? -1.f : 1.f) * (plan_.width / 2 - across - gap), plan_.height,
                      (out.z < 0 ? -1.f : 1.f) * (plan_.depth / 2 - along - gap)};
        const Footprint box = footprint_of(p);
        if (!plan_.holds(box)) continue;
        if (std::none_of(placed_.begin(), placed_.end(),
                         [&](const Placed& other) { return !other.flat && overlap(box, footprint_of(other)); }))
            return keep(p, from);
    }
    return {};
}

int Layout::in_windows(const PieceRequest& request, const PromptObject& from) {
    constexpr float kOffFrame = 0.008f, kBeside = 0.004f;
    int hung = 0;
    for (int window = 0; window < static_cast<int>(plan_.openings.size()); ++window) {
        const Opening& o = plan_.openings[static_cast<std::size_t>(window)];
        if (o.kind != Opening::Kind::window) continue;
        const WallFace face = plan_.wall(o.wall);
        for (const float low : {o.y0, o.y0 + 0.3f * (o.y1 - o.y0), o.y0 + 0.55f * (o.y1 - o.y0)}) {
            PieceRequest r = request;
            r.size_factor = 1.f;
            r.size_m = {o.u1 - o.u0 - 2 * kBeside, o.y1 - low, 0};
            Placed p;
            p.piece = make_piece(r);
            p.sill = window;
            p.yaw = yaw_of(face.inward);
            p.position = face.point((o.u0 + o.u1) / 2, o.y1 - p.piece.size_m.y) -
                         face.inward * (kRevealDepth - kOffFrame);
            const Footprint box = footprint_of(p);
            if (std::any_of(placed_.begin(), placed_.end(),
                            [&](const Placed& other) { return !other.flat && overlap(box, footprint_of(other)); }))
                continue;
            if (!hangs_in_window(plan_, p)) continue;
            keep(p, from);
            ++hung;
            break;
        }
    }
    return hung;
}

int Layout::at_windows(const PieceRequest& request, const PromptObject& from) {
    constexpr float kOffWall = 0.045f;
    // To the floor, to a hand's breadth below the sill, or to the sill.
    enum class Length { floor, apron, sill };
    const auto hang_at = [&](const Opening& o, Length length) {
        const WallFace face = plan_.wall(o.wall);
        const float wall_top = o.y1 > plan_.wall_top() ? plan_.height : plan_.wall_top(),
                    top = std::min(wall_top - 0.06f, o.y1 + 0.16f);
        const auto hang = [&](float margin, float low) {
            PieceRequest r = request;
            r.size_m = {std::min(o.u1 - o.u0 + 2 * margin, face.length - 0.04f), top - low, 0};
            Placed p;
            p.piece = make_piece(r);
            p.yaw = yaw_of(face.inward);
            p.position = face.point((o.u0 + o.u1) / 2, p.piece.mount == Mount::wall ? top - p.piece.size_m.y : low) +
                         face.inward * kOffWall;
            if (p.piece.mount != Mount::wall) p.position = p.position + face.inward * (p.piece.size_m.z / 2);
            const Footprint box = footprint_of(p);
            bool free = plan_.holds(box);
            // Nothing hangs between it and the wall.
            Footprint to_wall = box;
            to_wall.half.y += kOffWall / 2;
            to_wall.center = to_wall.center - flat(face.inward) * (kOffWall / 2);
            for (const Placed& other : placed_)
                free = free &&
                       (other.flat || !overlap(other.piece.mount == Mount::wall && other.sill < 0 ? to_wall : box,
                                               footprint_of(other)));
            free = free && leaves_way(p, from);
            if (free) keep(p, from);
            return free;
        };
        const float low = length == Length::floor ? 0.02f : length == Length::apron ? o.y0 - 0.12f : o.y0 - 0.02f;
        bool done = false;
        const float floor = plan_.floor_before(face, o.u0, o.u1);
        for (const float margin : {kCurtainMargin, 0.18f, 0.08f})
            done = done || hang(margin, std::max(0.02f, length == Length::floor ? floor + low : low));
        return done;
    };
    // All curtains of a room end alike, where all of them can.
    const std::size_t before = mark();
    for (const Length length : {Length::floor, Length::apron, Length::sill}) {
        int hung = 0, windows = 0;
        for (const Opening& o : plan_.openings) {
            // No cloth hangs before a porthole, and none hides an arch that was asked for.
            if (o.kind != Opening::Kind::window || o.shape == Opening::Shape::round ||
                (o.shape == Opening::Shape::arched && from.kind.empty()))
                continue;
            ++windows;
            hung += hang_at(o, length);
        }
        if (hung == windows || length == Length::sill) return hung;
        undo(before);
    }
    return 0;
}

}  // namespace fastscene
