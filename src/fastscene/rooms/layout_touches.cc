// What makes a room lived in: small things on tops, radiators, and more on walls and floors that are
// bare.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/layout_wall_art.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene {
namespace {

// Worktops of rooms where nobody cooks.
const std::vector<TopHabit>& at_washing() {
    static const std::vector<TopHabit> habits{
        {"towel_stack", 0.9f}, {"bottles", 0.8f}, {"storage_box", 0.7f}, {"plant_small", 0.5f}};
    return habits;
}

class Touches {
  public:
    Touches(Layout& layout, float clutter) : l_(layout), type_(room_type(layout.spec().room)), clutter_(clutter) {}

    void run() {
        radiators();
        fill_floor();
        if (type_.lived_in) walls();
        small_things();
        if (type_.lived_in) sills();
        toys();
    }

  private:
    bool is_settled(std::string_view kind) const { return furnishing::is_settled(l_.spec(), kind); }
    bool wants(std::string_view kind, float probability) {
        return l_.rng().chance(std::min(0.97f, probability * (0.35f + 1.3f * clutter_))) && !is_settled(kind);
    }
    bool is_sparse() const { return is_one_of(l_.spec().clutter, {"bare", "minimal"}); }

    // Below windows whose sill is high enough, where nothing else stands.
    void radiators() {
        if (is_settled("radiator") || !l_.plan().style.radiators || !type_.radiators) return;
        for (const Opening& o : l_.plan().openings) {
            if (o.kind != Opening::Kind::window || o.y0 < 0.75f || !l_.rng().chance(0.6f)) continue;
            PieceRequest r = l_.request("radiator");
            const WallFace face = l_.plan().wall(o.wall);
            const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0);
            l_.against_wall(r, {.wall = o.wall, .near = flat(middle), .center_pull = 0, .at_most_from_near = 0.4f});
        }
    }

    // Rooms larger than their groups get more: about one piece on the floor for every two square metres, with clutter
    // more.
    void fill_floor() {
        const float area = l_.plan().width * l_.plan().depth;
        const float usual = type_.pieces_per_m2;
        const int wanted = static_cast<int>(area * (is_sparse() ? 0.5f * usual : usual + 0.24f * clutter_));
        for (const std::string& kind : type_.pieces) {
            const auto standing = std::count_if(l_.placed().begin(), l_.placed().end(), [](const Placed& p) {
                return p.on < 0 && !p.flat && !p.overhead && p.piece.mount == Mount::floor && p.piece.kind != "curtain";
            });
            if (standing >= wanted) return;
            if (is_settled(kind)) continue;
            const bool tall = has_role(kind, Role::shades_windows);
            l_.against_wall(l_.request(kind),
                            {.center_pull = 0.2f, .window_pull = tall ? -1.f : 0.2f, .apart_pull = 0.6f});
        }
    }

    void walls() {
        const bool wet = type_.wet;
        if (!wet && wants("picture_ledge", 0.15f)) l_.on_wall(l_.request("picture_ledge"), {});
        for (int i = 0; i < 2; ++i)
            if (!wet && wants("shelf", type_.wall_shelf_probability)) l_.on_wall(l_.request("shelf"), {});
        if (!wet && wants("mirror", type_.mirror_probability) && l_.count("mirror") == 0)
            l_.on_wall(l_.request("mirror"), {});
        if (wants("clock", type_.clock_probability) && l_.count("clock") == 0) l_.on_wall(l_.request("clock"), {});
        // What is still bare gets pictures.
        const float around = 2 * (l_.plan().width + l_.plan().depth);
        const int wanted = static_cast<int>(around * (is_sparse() ? 0.05f
                                                      : wet       ? 0.1f
                                                                  : 0.16f + 0.16f * clutter_)),
                  there = l_.count("picture") + l_.count("mirror") + l_.count("shelf") + l_.count("picture_ledge");
        if (!is_settled("picture")) furnishing::hang_art(l_, "picture", wanted - there);
    }

    void small_things() {
        const std::size_t count = l_.placed().size();
        for (std::size_t i = 0; i < count; ++i) {
            if (l_.placed()[i].on >= 0) continue;
            const std::string kind = l_.placed()[i].piece.kind;
            int put = 0;
            // One bowl, one vase, one lamp on a top; frames and candles come in groups.
            const auto there = [&](std::string_view thing) {
                return !has_role(thing, Role::in_groups) &&
                       std::any_of(l_.placed().begin(), l_.placed().end(), [&](const Placed& p) {
                           return p.on == static_cast<int>(i) && p.piece.kind == thing;
                       });
            };
            const bool damp = type_.wet;
            const bool washes = kind == "kitchen_counter" && damp;
            const Thing* top = find_thing(kind);
            if (!top) continue;
            for (const TopHabit& h : washes ? at_washing() : top->on_top) {
                const std::string_view thing = type_.for_children ? furnishing::for_a_child(h.thing) : h.thing;
                if ((damp || thing != "towel_stack") && !there(thing) && put < 5 + static_cast<int>(4 * clutter_) &&
                    wants(thing, h.probability))
                    put += l_.on_top(static_cast<int>(i), l_.request(std::string(thing))).has_value();
            }
        }
    }

    // One to four things at a window: herbs in a kitchen, soap in a bathroom, plants and books elsewhere.
    void sills() {
        const std::vector<std::string>& things = type_.sills;
        for (int window = 0; window < static_cast<int>(l_.plan().openings.size()); ++window) {
            const Opening& o = l_.plan().openings[static_cast<std::size_t>(window)];
            if (o.kind != Opening::Kind::window || !l_.rng().chance(std::min(0.95f, 0.45f + 0.6f * clutter_))) continue;
            // Things gather: one for every half metre or so, with some left out.
            const int most = std::clamp(static_cast<int>((o.u1 - o.u0) / 0.5f), 1, 4),
                      first = l_.rng().index(static_cast<int>(things.size()));
            for (int i = 0; i < most; ++i) {
                const std::string& kind = things[static_cast<std::size_t>(first + i) % things.size()];
                if (wants(kind, 0.75f)) l_.on_sill(l_.request(kind), window);
            }
        }
    }

    void toys() {
        if (!type_.for_children) return;
        const auto rug = l_.find("rug");
        const Vec2f at = rug ? flat(l_.placed()[static_cast<std::size_t>(*rug)].position) : Vec2f{0, 0};
        for (const char* kind : {"toy_blocks", "teddy_bear", "toy_blocks", "book_stack"})
            if (wants(kind, 0.8f)) l_.on_floor_near(at, l_.request(kind));
    }

    Layout& l_;
    const RoomType& type_;
    float clutter_;
};

}  // namespace

void add_touches(Layout& layout, float clutter) { Touches(layout, clutter).run(); }

}  // namespace fastscene
