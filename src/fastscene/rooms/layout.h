// Layout: where the furniture stands. Works in the room frame of plan.h. Pieces are placed one after the other, what
// was asked for first, each into the best free slot; then groups of pieces move together until they stand well
// (layout_anneal.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/layout_ways.h"
#include "fastscene/rooms/plan.h"

namespace fastscene {

inline constexpr float kCurtainMargin = 0.32f;  // how far the rod reaches beyond the window
inline constexpr float kPanelling = 0.035f;     // stands proud of the wall
inline constexpr float kSlotStep = 0.07f;       // between the places along a wall that are tried

// A piece and its pose. The front (+z of the object) looks along (sin yaw, 0, cos yaw).
struct Placed {
    std::string id{};  // its name in a document; empty: by its kind and number
    Piece piece;
    PromptObject wish;  // empty kind: nobody asked for it
    Vec3f position;
    float yaw = 0;
    int on = -1;     // index of the piece it stands on
    int sill = -1;   // index of the window on whose sill it stands, or in which it hangs
    int below = -1;  // index of the table it stands under
    int with =
        -1;  // index of the piece it was placed by (beside, before, above, under it): where that goes it goes too
    bool flat = false;           // rugs: one may stand on them
    bool overhead = false;       // lamps that hang: one may stand below them
    bool fixed = false;          // given, or a part of a pattern: it stays where it is
    std::optional<float> lit{};  // share of its light that it gives; nothing: as the room's lamps
};

// A thing that hangs on walls set upright on a top (a picture on the mantelpiece), or a flat one that stands hung on a
// wall with its back against it.
void mount_as(Piece& piece, Mount mount);

Footprint footprint_of(const Placed& placed, float margin_m = 0.f);
// The box of what of a piece reaches above a height: of a bed its head alone; nothing, if all of it is lower.
std::optional<Footprint> part_above(const Placed& placed, float height);
// Whether a piece stands above what carries this one, and high enough: a loft bed above the lamp on its desk.
bool shelters(const std::vector<Placed>& all, int over, const Placed& thing);
// In the door's way, tall before a window, or in its sill.
bool blocks_opening(const Plan& plan, const Footprint& box);
// Whether it hides a good part of a window from who stands in the room: what stands on a low top before one.
bool shades_window(const Plan& plan, const Footprint& box);
// Whether a piece of wall carries it, clear of doors and windows.
bool hangs_on_wall(const Plan& plan, const std::vector<WallFace>& faces, const Placed& placed);
// In its window's reveal, before the frame: a blind.
bool hangs_in_window(const Plan& plan, const Placed& placed);
// On the sill of its window, between the frame and the sill's edge.
bool stands_on_sill(const Plan& plan, const Placed& placed);
// Whether a piece on the floor, or a plant from the ceiling, is close before what hangs on a wall, and reaches to its
// height.
bool hides(const Placed& floor, const Placed& hung);
// Whether all of what stands on the floor is on it: not half on a step, nor above or below its tier.
bool stands_level(const Plan& plan, const Placed& placed);
// In the room, off its walls and their panelling.
bool clear_of_walls(const Plan& plan, const Placed& placed);
// No door and no window in this part of a wall face.
bool wall_is_free(const Plan& plan, const WallFace& face, float u0, float u1, float y0, float y1);

// The search after the slot scan (layout_anneal.h). Temperatures are in units of its cost.
struct AnnealParams {
    int steps = 1500;  // 0: pieces stay in their slots
    float hot = 0.5f, cold = 0.01f;
};
struct AnnealReport {
    float before = 0, after = 0;  // cost
    double seconds = 0;           // of this thread's time
};

inline constexpr int kMostScreens = 3;      // side by side on a desk
inline constexpr float kInsideBed = 0.13f;  // metres that a desk below a bed stands back from the front of its ladder
inline constexpr float kInRow = 0.12f;      // metres between those that stand in a row

// Floor kept free about a piece, and the wall above it, for what is to stand or hang there.
struct Spare {
    float left = 0, right = 0, front = 0, behind = 0;
    bool above = false;
};

// The room being furnished.
class Layout {
  public:
    Layout(const Plan& plan, PromptSpec& spec, Random& rng, const AnnealParams& annealing = {})
        : plan_(plan), spec_(spec), rng_(rng), annealing_(annealing), faces_(plan.faces()), ways_(plan) {}

    // Each returns the index of the new piece, or nothing when there is no room for it.
    struct WallWish {
        int wall = -1;                             // only this one
        std::optional<Vec2f> near = std::nullopt;  // as near to this point as possible
        float center_pull = 1.f;                   // how much the middle of a wall is preferred
        float window_pull = 0.f;                   // > 0: under a window; < 0: away from it
        bool corner = false;
        bool clear_of_windows = false;   // not below one either
        float at_most_from_near = 1e9f;  // metres
        float apart_pull = 0.f;          // how much it seeks distance from all that stands
        Spare spare{};                   // kept if any slot has it
        bool needs_spare = false;        // … or else the piece does not stand
    };
    std::optional<int> against_wall(const PieceRequest& request, const WallWish& wish, const PromptObject& from = {});
    std::optional<int> in_front_of(int anchor, const PieceRequest& request, float gap_m, bool facing,
                                   const PromptObject& from = {}, float aside_m = 0);
    std::optional<int> beside(int anchor, const PieceRequest& request, int side, float gap_m,
                              const PromptObject& from = {});
    // Beside a piece of the same kind, whatever it stands on or hangs on.
    std::optional<int> in_line(int anchor, const PieceRequest& request, int side, const PromptObject& from);
    std::optional<int> behind(int anchor, const PieceRequest& request, const PromptObject& from = {});
    // Below a table's top, between its legs.
    std::optional<int> below(int anchor, const PieceRequest& request, const PromptObject& from = {});
    std::optional<int> free_standing(const PieceRequest& request, const PromptObject& from = {},
                                     const Spare& spare = {});
    std::optional<int> angled_towards(Vec2f target, const PieceRequest& request, const PromptObject& from = {});
    int around(int table, const PieceRequest& request, int count, const PromptObject& from = {});
    // Parts of patterns. Here and nowhere else, with free floor about it; and on this wall, its middle at `u`.
    std::optional<int> stand_at(const Piece& piece, Vec2f at, float yaw, const PromptObject& from, const Spare& spare,
                                bool with_clearance = false);
    std::optional<int> hang_at(const Piece& piece, int wall, float u, const PromptObject& from);
    // Whether it could hang there.
    bool can_hang_at(const Piece& piece, int wall, float u) const {
        return hung(piece, plan_.wall(wall), u).has_value();
    }
    // The same on any face of the room.
    std::optional<int> hang_on(const Piece& piece, const WallFace& face, float u, const PromptObject& from);
    // Rugs: under a piece, shifted towards its front; or with the middle anywhere.
    std::optional<int> under(int anchor, const PieceRequest& request, float shift_front_m,
                             const PromptObject& from = {});
    std::optional<int> lay(Vec2f at, float yaw, const PieceRequest& request, const PromptObject& from = {});
    std::optional<int> on_top(int anchor, const PieceRequest& request, const PromptObject& from = {});
    // … with its middle at this point of the floor plan, turned as asked.
    std::optional<int> on_top_at(int anchor, const PieceRequest& request, Vec2f at, float yaw,
                                 const PromptObject& from = {});
    // On the sill of this window, or of any, where nothing else stands before it; no larger than the sill is deep.
    std::optional<int> on_sill(const PieceRequest& request, std::optional<int> window = {},
                               const PromptObject& from = {});
    // Small things that lie about on the floor near a point.
    std::optional<int> on_floor_near(Vec2f at, const PieceRequest& request, const PromptObject& from = {});
    std::optional<int> on_any_top(const PieceRequest& request, const PromptObject& from = {});
    std::optional<int> on_wall(const PieceRequest& request, std::optional<int> above, const PromptObject& from = {});
    // Above a door or window of this class, below the ceiling.
    std::optional<int> over_opening(const std::string& kind, const PieceRequest& request,
                                    const PromptObject& from = {});
    std::optional<int> hanging(const PieceRequest& request, Vec2f at, const PromptObject& from = {});
    // Between two walls and the ceiling.
    std::optional<int> in_upper_corner(const PieceRequest& request, const PromptObject& from = {});
    // A pair at every window where they find room; returns how many. All end alike: at the floor, or at the sills.
    int at_windows(const PieceRequest& request, const PromptObject& from = {});
    // A blind in every window, within its reveal; returns how many. Above what stands on a sill it is drawn up.
    int in_windows(const PieceRequest& request, const PromptObject& from = {});
    // On the wall behind a piece, beside it: at eye height, or level with the middle of what hangs there itself.
    std::optional<int> beside_on_wall(int anchor, const PieceRequest& request, int side, const PromptObject& from = {});

    // How much stands; and back to that.
    std::size_t mark() const { return placed_.size(); }
    void undo(std::size_t mark);
    // Says that one piece was placed by another.
    void join(int piece, int anchor) { placed_[static_cast<std::size_t>(piece)].with = anchor; }

    // Before anything is placed: what stands already, and stays there.
    void begin_with(std::vector<Placed> fixed);
    // Pieces of its class are made as this one was, which moves; null: as wished again.
    void make_as(std::shared_ptr<const PieceRequest> sample) { sample_ = std::move(sample); }

    // A wish for a piece that the furniture pack has, or has better, is served from there; another builder may stand
    // in. The pattern is that of a piece for which the wish says none.
    PieceRequest request(std::string kind, const PromptObject* wish = nullptr, const std::string& pattern = {});
    // While insisting, a piece stands where this wish says ("opposite the bed") or not at all; else only rather where
    // its own says.
    void insist(const PromptObject* where) { insisted_ = where; }
    // Why nothing of this class can be made; empty: it can.
    std::string why_not(const std::string& kind) const;
    std::optional<int> find(std::string_view kind) const;
    int count(std::string_view kind) const;
    const std::vector<Placed>& placed() const { return placed_; }
    const Plan& plan() const { return plan_; }
    PromptSpec& spec() { return spec_; }
    Random& rng() { return rng_; }
    // Moves groups of pieces to where they stand better, if anywhere and if nothing is wrong with the room then.
    void improve();
    const AnnealReport& annealed() const { return annealed_; }

    // Where the camera stands: eye height, free of things, in sight of what was asked for, by boxes alone; and by what
    // is seen of it.
    Vec3f camera_position() const;
    Vec3f viewpoint() const;
    // Pieces asked for that other pieces hide from there, by boxes; and those of which hardly anything is seen
    // (layout_sight.h).
    int likely_hidden(Vec3f eye) const;
    std::vector<int> unseen(Vec3f eye) const;
    // Moves a small thing to where it is seen best from there: on what carries it, or `anywhere`; pixels of a panorama
    // of 512 x 256.
    float show(int piece, Vec3f eye, bool anywhere);
    // Takes pieces away, with what stands on them: all but those that carry something that was asked for.
    void take_away(std::vector<int> pieces);
    // What looks like an earlier piece, and is no set with it (repeated_forms.h), gets another form or color.
    void tell_apart();

  private:
    void vary(PieceRequest& r) const;
    std::optional<Placed> hung(const Piece& piece, const WallFace& face, float u) const;
    std::string accent_of(const std::string& kind) const;
    bool fits(const Placed& placed, bool with_clearance) const;
    // Lifts what was placed as if all of the floor were y = 0 onto the floor there.
    void ground(Placed& placed) const;
    // What a place is worth for being where the wish says.
    float as_asked(const Placed& placed, const PromptObject& wish) const;
    // How good a place is for the camera, whatever is seen from there.
    struct Surroundings;
    class Levels;
    Surroundings surroundings(float floor) const;
    float ease_of(Vec3f eye, const Surroundings& things) const;
    bool looks_along() const;
    Vec3f position_along(float share) const;
    // Whether a thing may stand there on its top: in the room, out of others. `self`: its own index, if it has one.
    bool free_on_top(const Placed& placed, int self = -1) const;
    // Anew, when pieces have moved or left.
    void find_ways();
    // Whether the way from the door to a spot for the camera stays open with this piece.
    bool leaves_way(const Placed& placed) const { return !ways_.open() || ways_.open_with(placed); }
    // … and, of what nobody asked for, no floor is cut off.
    bool leaves_way(const Placed& placed, const PromptObject& from) const {
        return leaves_way(placed) && (!from.kind.empty() || !ways_.cuts_off(placed));
    }
    // How good a place is by `score`, by being where the wish says, and by the ways that it leaves; no more than `best`
    // if it is no better.
    float worth(const Placed& placed, const PromptObject& from, float score, float best) const;
    bool has_spare(const Placed& placed, const Spare& spare) const;
    std::optional<int> keep(Placed placed, const PromptObject& from);

    const Plan& plan_;
    PromptSpec& spec_;
    Random& rng_;
    AnnealParams annealing_;
    AnnealReport annealed_;
    std::vector<WallFace> faces_;
    std::vector<Placed> placed_;
    const PromptObject* insisted_ = nullptr;
    std::shared_ptr<const PieceRequest> sample_;
    Ways ways_;
};

// What makes a room lived in: small things on tops, radiators, more on bare walls and floors. `clutter` in [0, 1]. Part
// of furnish().
void add_touches(Layout& layout, float clutter);

// Furnishes by the room's type, what the prompt asks for first; what does not fit goes to spec.not_placed.
void furnish(Layout& layout);
// Places what the prompt asks for, and nothing else, among what stands.
void place_asked(Layout& layout);

// A plan, what stands in it, and where panorama 0 stands.
struct FurnishedRoom {
    Plan plan;
    std::vector<Placed> placed;
    Vec3f camera;
    // The room behind the doorway, if there is one.
    std::vector<Placed> placed_next;
    int hidden_wishes = 0;  // pieces asked for of which the camera sees hardly anything
    AnnealReport annealed;
    Vec3f looks{0, 0, 1};                // where the camera looks: level, unit
    std::optional<float> lamps;          // share of their light that lamps give; nothing: as the hour asks
    std::optional<Vec3f> towards_sun{};  // unit; nothing: where it shines through the first window
};
// The room a prompt asks for, before it becomes triangles. Fills spec.assumed and spec.not_placed. Deterministic in
// (spec, run.seed).
FurnishedRoom furnish_room(PromptSpec& spec, const Run& run, const AnnealParams& annealing = {});
// At the piece that names the room, else along the room's longer side.
Vec3f usual_look(const FurnishedRoom& room, const std::string& type);
// The room behind the doorway, if the plan has one: its own type, the same style and hour; of what was asked for, what
// belongs there.
void furnish_next(PromptSpec& spec, const Run& run, const AnnealParams& annealing, FurnishedRoom& room);
// … and as triangles.
Room room_of(PromptSpec& spec, const FurnishedRoom& furnished, const Run& run);

}  // namespace fastscene
