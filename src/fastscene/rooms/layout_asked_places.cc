// Where what was asked for stands: in the shell, searched for by the words, or anywhere.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_furnisher.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::furnishing {
namespace {

// Who is as tall as a man and has a back stands at a wall or not at all: in the room's middle it would hide the half of
// it.
bool stands_at_walls(const Piece& piece) {
    return piece.against_wall && piece.size_m.y > (has_role(piece.kind, Role::along_wall) ? 1.f : 1.4f);
}

}  // namespace

// Room for what was asked for at it, and for those that stand in a row with it.
Spare Furnisher::spare_for(const PromptObject& wish, const Piece& piece) {
    Spare spare = spare_for(wish.kind);
    if (wish.in_row && piece.mount == Mount::floor && wish.count > 1)
        spare.right = std::max(spare.right, static_cast<float>(wish.count - 1) * (piece.size_m.x + kInRow));
    return spare;
}

std::optional<int> Furnisher::in_shell(const Ask& ask) {
    const PromptObject& wish = *ask.wish;
    if (!l_.why_not(wish.kind).empty()) return {};
    const PieceRequest r = l_.request(wish.kind, &wish);
    const Piece piece = make_piece(r);
    if (wish.in_row)
        if (const auto i = next_in_row(wish, r)) return i;
    if (lies_about(wish.kind))
        if (const auto i = strewn(r, wish)) return i;
    if (wish.kind == "rug") {
        PieceRequest sized = r;
        for (const Opening& o : l_.plan().openings) {
            if (!is_opening_of(o, ask.at)) continue;
            const WallFace face = l_.plan().wall(o.wall);
            const bool window = o.kind == Opening::Kind::window;
            sized.size_m = window ? Vec3f{1.6f, 0, 1.1f} : Vec3f{0.8f, 0, 0.5f};
            if (const auto i = l_.lay(flat(face.point((o.u0 + o.u1) / 2, 0) + face.inward * (window ? 0.9f : 0.45f)),
                                      yaw_of(face.inward), sized, wish))
                return i;
        }
        sized.size_m = {2.2f, 0, 1.5f};
        return ask.relation == "in the middle" ? l_.lay({0, 0}, 0, sized, wish) : std::nullopt;
    }
    // Lights, leaves and pennants around a window hang along its upper edge.
    if (has_role(wish.kind, Role::garland) && ask.relation != "opposite")
        for (const Opening& o : l_.plan().openings) {
            if (!is_opening_of(o, ask.at)) continue;
            PieceRequest strand = r;
            for (const float high : {0.3f, 0.2f, 0.14f}) {
                strand.size_m = {o.u1 - o.u0 + 0.3f, high, 0};
                if (const auto i = l_.over_opening(ask.at, strand, wish)) return i;
            }
        }
    if (ask.relation == "above")
        for (const float size : {1.f, 0.8f, 0.62f, 0.5f}) {
            PieceRequest smaller = r;
            smaller.size_factor *= size;
            if (const auto i = l_.over_opening(ask.at, smaller, wish)) return i;
        }
    if (ask.relation == "facing" && piece.mount == Mount::floor && !piece.against_wall)
        for (const Opening& o : l_.plan().openings)
            if (is_opening_of(o, ask.at)) {
                const Insisting insisting(l_, wish);
                const WallFace face = l_.plan().wall(o.wall);
                if (const auto i = l_.angled_towards(flat(face.point((o.u0 + o.u1) / 2, 0)), r, wish)) return i;
            }
    if (piece.mount == Mount::surface) {
        if (ask.relation == "on" && ask.at.ends_with("window"))
            if (const auto i = l_.on_sill(r, {}, wish)) return i;
        if (ask.at == "wall") return l_.on_wall(r, {}, wish);
        if (ask.at == "floor") return l_.on_floor_near({0, 0}, r, wish);
        return on_a_top_there(wish, r, {});
    }
    return where_asked(wish, r, piece);
}

std::optional<int> Furnisher::where_asked(const PromptObject& wish, const PieceRequest& r, const Piece& piece) {
    if (wish.relation.empty() || wish.kind == "rug") return {};
    const Insisting insisting(l_, wish);
    if (piece.mount == Mount::wall || wish.kind == "tv") return l_.on_wall(r, {}, wish);
    if (piece.mount == Mount::ceiling)
        return wish.relation == "in the middle" ? l_.hanging(r, {0, 0}, wish) : std::nullopt;
    if (piece.mount != Mount::floor) return {};
    if (wish.kind == "kitchen_counter") return kitchen_units(l_, r, wish);
    const Spare spare = spare_for(wish, piece);
    Layout::WallWish w{.center_pull = 0.3f, .spare = spare};
    if (wish.relation == "in the corner") w.corner = true, w.apart_pull = 1.f;
    if (wish.relation_to == "window") w.window_pull = 2.f, w.center_pull = 0.2f;
    else
        for (const Opening& o : l_.plan().openings)
            if (is_opening_of(o, wish.relation_to)) w.near = flat(l_.plan().wall(o.wall).point((o.u0 + o.u1) / 2, 0));
    std::optional<int> i;
    if (wish.relation != "in the middle") i = l_.against_wall(r, w, wish);
    return i || (stands_at_walls(piece) && wish.relation != "in the middle") ? i : l_.free_standing(r, wish, spare);
}

// A run of units fills a wall as far as windows and the door leave it; a short one is better than none. Below a window
// it has no cupboards.
std::optional<int> kitchen_units(Layout& layout, PieceRequest r, const PromptObject& wish, float beside_m) {
    constexpr float kLow = 0.92f, kFromCorners = 0.1f, kLeast = 1.8f;
    const bool at_window = wish.relation_to == "window" && wish.relation != "opposite" && wish.relation != "between";
    std::vector<float> heights{0.f};
    if (at_window) heights = {kLow, 0.f};
    // With room beside them on some wall, rather than without on the first.
    std::vector<Spare> spares{Spare{}};
    if (beside_m > 0) spares = {Spare{.right = beside_m}, Spare{.left = beside_m}, Spare{}};
    for (const float height : heights)
        for (const Spare& spare : spares) {
            const float beside = spare.left + spare.right;
            for (const int w : {0, 1, 3, 2}) {
                const float length = layout.plan().wall(w).length - beside;
                for (const float width : {length - kFromCorners, length - 0.8f, length * 0.6f, 2.2f, 1.8f}) {
                    if (beside > 0 && width < kLeast) continue;
                    r.size_m = {width, height, 0};
                    const Layout::WallWish at{
                        .wall = w, .window_pull = height > 0 ? 2.f : 0.f, .spare = spare, .needs_spare = beside > 0};
                    if (const auto i = layout.against_wall(r, at, wish)) return i;
                }
            }
        }
    return {};
}

// Beside the last one of its kind, in line with it.
std::optional<int> Furnisher::next_in_row(const PromptObject& wish, const PieceRequest& r) {
    std::vector<int> row;
    for (int i = 0; i < static_cast<int>(l_.placed().size()); ++i)
        if (at(i).wish.id == wish.id) row.push_back(i);
    // At both ends in turn: the first stays in the middle.
    for (const int one : row)
        for (const int side : {1, -1})
            if (const auto i = l_.in_line(one, r, side, wish)) return i;
    return {};
}

// Where no top is left.
std::optional<int> Furnisher::on_a_table_of_its_own(const PieceRequest& r, const PromptObject& wish) {
    const std::size_t before = l_.mark();
    if (wishes_.forbids("side_table")) return {};
    if (const auto stand = l_.against_wall(l_.request("side_table"), {.center_pull = 0.2f, .apart_pull = 0.5f}))
        if (const auto i = l_.on_top(*stand, r, wish)) return i;
    l_.undo(before);
    return {};
}

std::optional<int> Furnisher::on_a_top_there(const PromptObject& wish, const PieceRequest& r,
                                             std::optional<int> anchor) {
    const Insisting insisting(l_, wish);
    const auto has_one = [&](int top) {
        return std::any_of(l_.placed().begin(), l_.placed().end(),
                           [&](const Placed& p) { return p.on == top && p.wish.id == wish.id; });
    };
    const auto on_those = [&](bool again) -> std::optional<int> {
        for (int i = 0; i < static_cast<int>(l_.placed().size()); ++i)
            if (i != anchor && at(i).on < 0 && !is_seat(kind_of(i)) && !at(i).piece.surfaces.empty() &&
                has_one(i) == again)
                if (const auto k = l_.on_top(i, r, wish)) return k;
        return {};
    };
    if (const auto i = on_those(false)) return i;
    // A small table is brought for it.
    const std::string& whose = anchor ? kind_of(*anchor) : wish.relation_to;
    const bool bed = has_role(whose, Role::bed);
    const std::string kind = bed ? "nightstand" : "side_table";
    if (!wishes_.forbids(kind)) {
        const PieceRequest table = l_.request(kind);
        const std::size_t before = l_.mark();
        std::vector<int> sides{1, -1};
        if (wish.relation == "left of") sides = {-1};
        if (wish.relation == "right of") sides = {1};
        std::optional<int> stand;
        if (anchor && is_beside(wish.relation))
            for (const int side : sides)
                if (!stand) stand = l_.beside(*anchor, table, side, 0.06f);
        if (!stand) stand = l_.against_wall(table, {.center_pull = 0.2f, .corner = wish.relation == "in the corner"});
        if (!stand) stand = l_.free_standing(table);
        if (stand)
            if (const auto k = l_.on_top(*stand, r, wish)) return k;
        l_.undo(before);
    }
    return on_those(true);
}

std::optional<int> next_screen(Layout& layout, int desk, const PieceRequest& r, const PromptObject& wish) {
    int asked = 0, standing = 0;
    for (const PromptObject& o : layout.spec().objects) asked += o.kind == "monitor" && !o.forbidden ? o.count : 0;
    for (const Placed& p : layout.placed()) standing += p.on == desk && p.piece.kind == "monitor";
    const int row = std::min(kMostScreens, asked);
    if (standing >= row) return {};
    constexpr float kFromBack = 0.13f, kTurn = 0.24f;  // metres from the desk's rear edge to a foot's middle; radians
    const float aside = static_cast<float>(standing) - 0.5f * static_cast<float>(row - 1);
    const Placed& d = layout.placed()[static_cast<std::size_t>(desk)];
    const float depth = -d.piece.size_m.z / 2 + kFromBack + 0.06f * std::abs(aside);
    return layout.on_top_at(desk, r,
                            flat(d.position + right_of(d.yaw) * (aside * kMonitorStep) + front_of(d.yaw) * depth),
                            d.yaw - kTurn * aside, wish);
}

// Beside a window in a smaller size.
std::optional<int> screen_above(Layout& layout, int stand, const PieceRequest& r, const PromptObject& wish) {
    for (const float size : {1.f, 0.85f, 0.7f}) {
        PieceRequest smaller = r;
        smaller.size_factor *= size;
        if (const auto i = layout.on_wall(smaller, stand, wish)) return i;
    }
    return {};
}

// On a low piece, else on a wall, else it gets a stand of its own.
std::optional<int> Furnisher::television(const PieceRequest& r, const PromptObject& wish) {
    const bool hung = is_hung_screen(wish);
    const auto at_stand = [&](int stand) {
        return hung ? screen_above(l_, stand, r, wish) : l_.on_top(stand, r, wish);
    };
    for (const char* kind : {"tv_stand", "sideboard", "dresser", "console_table"})
        if (const auto anchor = l_.find(kind))
            if (const auto i = at_stand(*anchor)) return i;
    const std::size_t before = l_.mark();
    if (const auto stand = wishes_.forbids("tv_stand")
                               ? std::nullopt
                               : l_.against_wall(l_.request("tv_stand"), {.window_pull = -2, .clear_of_windows = true}))
        if (const auto i = at_stand(*stand)) return i;
    l_.undo(before);
    return l_.on_wall(r, {}, wish);
}

bool Furnisher::on_a_seat(const PromptObject& wish) {
    const PieceRequest r = l_.request(wish.kind, &wish);
    for (const float size : {1.f, 0.7f}) {  // a blanket for a sofa is folded once more for an armchair
        PieceRequest smaller = r;
        smaller.size_factor = size * r.size_factor;
        for (const char* kind :
             {"sofa", "loveseat", "bed", "bed_single", "canopy_bed", "four_poster_bed", "floor_bed", "daybed",
              "chaise_longue", "bunk_bed", "armchair", "bench", "rocking_chair", "lounge_chair", "cabin_bed"})
            for (std::size_t i = 0; i < l_.placed().size(); ++i)
                if (kind_of(static_cast<int>(i)) == kind && l_.on_top(static_cast<int>(i), smaller, wish)) return true;
        if (wish.kind != "throw" || wish.size_m != Vec3f{}) break;
    }
    return false;
}

std::optional<int> Furnisher::wall_lamp_at(int anchor, const PieceRequest& r, const PromptObject& wish) {
    const Vec3f aside = right_of(at(anchor).yaw);
    float balance = 0;  // on which side there are more of them
    for (const Placed& p : l_.placed())
        if (p.piece.kind == "wall_lamp" && p.with == anchor)
            balance += dot(p.position - at(anchor).position, aside) > 0 ? 1.f : -1.f;
    std::vector<int> sides{1, -1};
    if (balance > 0) sides = {-1, 1};
    if (wish.relation == "left of") sides = {-1};
    if (wish.relation == "right of") sides = {1};
    for (const int side : sides)
        if (const auto i = l_.beside_on_wall(anchor, r, side, wish)) return i;
    return {};
}

std::optional<int> Furnisher::wall_lamp(const PieceRequest& r, const PromptObject& wish) {
    for (const char* kind : {"bed", "bed_single", "mirror", "fireplace", "picture", "sofa", "washbasin",
                             "console_table", "sideboard", "loveseat", "desk"})
        for (int i = 0; i < static_cast<int>(l_.placed().size()); ++i) {
            if (kind_of(i) != kind) continue;
            const auto there = std::count_if(l_.placed().begin(), l_.placed().end(), [&](const Placed& p) {
                return p.piece.kind == "wall_lamp" && p.with == i;
            });
            if (there >= 2) continue;
            if (const auto lamp = wall_lamp_at(i, r, wish)) return lamp;
        }
    return {};
}

std::optional<int> Furnisher::hung_aside(const PieceRequest& r, const PromptObject& wish) {
    const float reach = 0.5f * make_piece(r).size_m.x;
    std::vector<Vec2f> places;
    for (const Opening& o : l_.plan().openings) {
        if (o.kind != Opening::Kind::window) continue;
        const WallFace face = l_.plan().wall(o.wall);
        for (const float off : {0.12f, 0.3f, 0.5f})
            for (const float u : {o.u0 - 0.1f, o.u1 + 0.1f, o.u0 + 0.25f * (o.u1 - o.u0), o.u0 + 0.75f * (o.u1 - o.u0)})
                places.push_back(flat(face.point(u, 0) + face.inward * (reach + off)));
    }
    for (const float off : {0.12f, 0.4f, 0.8f})
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {1.f, -1.f})
                places.push_back(
                    {sx * (0.5f * l_.plan().width - reach - off), sz * (0.5f * l_.plan().depth - reach - off)});
    // Not all at one window.
    std::stable_sort(places.begin(), places.end(), [&](Vec2f a, Vec2f b) {
        const auto crowded = [&](Vec2f p) {
            return std::any_of(l_.placed().begin(), l_.placed().end(), [&](const Placed& q) {
                return q.piece.kind == "hanging_plant" && length(flat(q.position) - p) < 0.7f;
            });
        };
        return !crowded(a) && crowded(b);
    });
    for (const float size : {1.f, 0.8f}) {
        PieceRequest smaller = r;
        smaller.size_factor *= size;
        for (const Vec2f p : places)
            if (const auto i = l_.hanging(smaller, p, wish)) return i;
    }
    return {};
}

// On the floor, where the camera may see it: sheets and paper lie flat, below furniture too, a drop cloth below the
// ladder.
std::optional<int> Furnisher::strewn(const PieceRequest& r, const PromptObject& wish) {
    const auto somewhere = [&] {
        return Vec2f{l_.rng().uniform(-0.36f, 0.36f) * l_.plan().width,
                     l_.rng().uniform(-0.36f, 0.36f) * l_.plan().depth};
    };
    const auto ladder = l_.find("step_ladder");
    if (has_role(wish.kind, Role::spread_out)) {
        if (ladder && wish.kind == "drop_cloth")
            if (const auto i = l_.lay(flat(at(*ladder).position), at(*ladder).yaw, r, wish)) return i;
        for (int tries = 0; tries < 16; ++tries)
            if (const auto i = l_.lay(somewhere(), l_.rng().uniform(-0.5f, 0.5f), r, wish)) return i;
    }
    for (int tries = 0; tries < 6; ++tries)
        if (const auto i = l_.on_floor_near(somewhere(), r, wish)) return i;
    return {};
}

// By what kind of piece it is.
std::optional<int> Furnisher::anywhere(const PromptObject& wish) {
    const PieceRequest r = l_.request(wish.kind, &wish);
    const Piece piece = make_piece(r);
    if (const auto desk = l_.find("desk");
        wish.kind == "monitor" && desk && (wish.relation.empty() || wish.relation_to == "desk"))
        if (const auto i = next_screen(l_, *desk, r, wish)) return i;
    if (wish.in_row)
        if (const auto i = next_in_row(wish, r)) return i;
    if (is_hung_screen(wish)) return television(r, wish);
    if (const auto i = where_asked(wish, r, piece)) return i;
    if (wish.kind == "kitchen_counter") return kitchen_units(l_, r, wish);
    if (wish.kind == "tv") return television(r, wish);
    // Dogs lie on the floor, on a rug where there is one; on the sofa when somebody says so.
    if (wish.kind == "dog" && wish.relation.empty()) {
        const auto rug = l_.find("rug");
        if (const auto i = l_.on_floor_near(rug ? flat(at(*rug).position) : Vec2f{0, 0}, r, wish)) return i;
    }
    if (lies_on_seats(wish.kind) && on_a_seat(wish)) return static_cast<int>(l_.placed().size()) - 1;
    switch (piece.mount) {
        case Mount::surface:
            if (const auto i = l_.on_any_top(r, wish)) return i;
            // Where nothing else stands ("only a mattress and a candle") small things stand on the floor.
            if (!is_furnished())
                if (const auto i = l_.on_floor_near({0, 0}, r, wish)) return i;
            return on_a_table_of_its_own(r, wish);
        case Mount::wall:
            if (wish.kind == "wall_lamp")
                if (const auto i = wall_lamp(r, wish)) return i;
            // On a wall full of other things in a smaller size.
            for (const float size : {1.f, 0.78f, 0.6f, 0.45f}) {
                PieceRequest smaller = r;
                smaller.size_factor = std::max(0.25f, size * r.size_factor);
                if (const auto i = l_.on_wall(smaller, {}, wish)) return i;
                if (wish.size_m != Vec3f{}) break;
            }
            return {};
        case Mount::ceiling:
            if (wish.kind == "cobweb") return l_.in_upper_corner(r, wish);
            if (const auto cot = l_.find("crib"); wish.kind == "cot_mobile" && cot)
                if (const auto i = l_.hanging(r, flat(at(*cot).position), wish)) return l_.join(*i, *cot), i;
            if (wish.kind == "hanging_plant")
                if (const auto i = hung_aside(r, wish)) return i;
            for (const Vec2f p : {Vec2f{0, 0}, Vec2f{0.7f, 0.5f}, Vec2f{-0.8f, -0.5f}, Vec2f{0, 1.2f}, Vec2f{0, -1.2f}})
                if (const auto i = l_.hanging(r, p, wish)) return i;
            return {};
        case Mount::floor: break;
    }
    if (lies_about(wish.kind))
        if (const auto i = strewn(r, wish)) return i;
    if (wish.kind == "rug") {
        PieceRequest sized = r;
        sized.size_m = {1.6f, 0, 1.1f};
        for (int i = 0; i < static_cast<int>(l_.placed().size()); ++i)
            if (const auto k = l_.under(i, sized, 0.9f, wish)) return k;
        return l_.lay({0, 0}, 0, sized, wish);
    }
    Layout::WallWish w;
    w.corner = wish.relation == "in the corner" || wish.kind == "plant";
    w.window_pull = wish.relation_to == "window" ? 2.f : piece.size_m.y > 1.2f ? -1.f : 0.f;
    w.center_pull = 0.4f;
    w.clear_of_windows = wish.kind == "fireplace" || wish.kind == "tv_stand";
    w.spare = spare_for(wish, piece);
    if (const auto i = l_.against_wall(r, w, wish)) return i;
    w.clear_of_windows = w.corner = false;
    if (const auto i = l_.against_wall(r, w, wish)) return i;
    if (const auto i = stands_at_walls(piece) ? std::nullopt : l_.free_standing(r, wish)) return i;
    if (wish.kind != "plant" || wish.size == "large") return {};
    // "A dozen plants": where no floor is left they stand in small pots, on sills and tops, or hang beside windows.
    PieceRequest pot = r;
    pot.kind = "plant_small", pot.model = nullptr, pot.pack = nullptr;
    if (const auto i = l_.on_sill(pot, {}, wish)) return i;
    if (const auto i = l_.on_any_top(pot, wish)) return i;
    pot.kind = "hanging_plant";
    return hung_aside(pot, wish);
}

}  // namespace fastscene::furnishing
