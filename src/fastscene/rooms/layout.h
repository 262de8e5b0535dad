// Layout: where the furniture stands. Works in the room frame of plan.h. Pieces are placed one after the other, the
// important ones first, each into the best free slot; nothing is moved afterwards, so a layout costs milliseconds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/layout_ways.h"
#include "fastscene/rooms/plan.h"

namespace fastscene {

// A piece and its pose. The front (+z of the object) looks along (sin yaw, 0, cos yaw).
struct Placed {
    Piece piece;
    PromptObject wish;         // empty klass: nobody asked for it
    Vec3f position;
    float yaw = 0;
    int on = -1;               // index of the piece it stands on
    bool flat = false;         // rugs: one may stand on them
    bool overhead = false;     // lamps that hang: one may stand below them
};

// An upright box turned about the vertical axis.
struct Footprint {
    Vec2f center, half;        // x, z
    float yaw = 0, y0 = 0, y1 = 0;
};
Footprint footprint_of(const Placed& placed, float margin_m = 0.f);
// Whether the boxes share a volume (separating axes).
bool overlap(const Footprint& a, const Footprint& b);
// Distance on the floor from a point to the box; 0 inside.
float distance_to(const Footprint& box, Vec2f point);

// The room being furnished.
class Layout {
  public:
    Layout(const Plan& plan, PromptSpec& spec, Random& dice) : plan_(plan), spec_(spec), dice_(dice), ways_(plan) {}

    // Each returns the index of the new piece, or nothing when there is no room for it.
    struct WallWish {
        int wall = -1;                 // only this one
        std::optional<Vec2f> near = std::nullopt;  // as near to this point as possible
        float center_pull = 1.f;       // how much the middle of a wall is preferred
        float window_pull = 0.f;       // > 0: under a window; < 0: away from it
        bool corner = false;
        bool clear_of_windows = false;  // not below one either
    };
    std::optional<int> against_wall(const PieceRequest& request, const WallWish& wish, const PromptObject& from = {});
    std::optional<int> in_front_of(int anchor, const PieceRequest& request, float gap_m, bool facing, const PromptObject& from = {});
    std::optional<int> beside(int anchor, const PieceRequest& request, int side, float gap_m, const PromptObject& from = {});
    std::optional<int> free_standing(const PieceRequest& request, const PromptObject& from = {});
    std::optional<int> angled_towards(Vec2f target, const PieceRequest& request, const PromptObject& from = {});
    int around(int table, const PieceRequest& request, int count, const PromptObject& from = {});
    std::optional<int> under(int anchor, const PieceRequest& request, float shift_front_m, const PromptObject& from = {});
    std::optional<int> on_top(int anchor, const PieceRequest& request, const PromptObject& from = {});
    std::optional<int> on_any_top(const PieceRequest& request, const PromptObject& from = {});
    std::optional<int> on_wall(const PieceRequest& request, std::optional<int> above, const PromptObject& from = {});
    std::optional<int> hanging(const PieceRequest& request, Vec2f at, const PromptObject& from = {});
    // A pair at every window where they find room; returns how many. They end above what stands below a window.
    int at_windows(const PieceRequest& request, const PromptObject& from = {});

    PieceRequest request(std::string klass, const PromptObject* wish = nullptr);
    std::optional<int> find(std::string_view klass) const;
    int count(std::string_view klass) const;
    const std::vector<Placed>& placed() const { return placed_; }
    const Plan& plan() const { return plan_; }
    PromptSpec& spec() { return spec_; }
    Random& dice() { return dice_; }

    // Where the camera stands: eye height, free of things, in sight of what was asked for.
    Vec3f camera_position() const;

  private:
    bool fits(const Placed& placed, bool with_clearance) const;
    // Whether the way from the door to a spot for the camera stays open with this piece.
    bool leaves_way(const Placed& placed) const { return !ways_.open() || ways_.open_with(placed); }
    bool inside_room(const Footprint& box) const;
    bool blocks_opening(const Footprint& box, float height) const;
    std::optional<int> keep(Placed placed, const PromptObject& from);
    int hidden_wishes(Vec3f eye) const;
    bool wall_is_free(int wall, float u0, float u1, float y0, float y1) const;

    const Plan& plan_;
    PromptSpec& spec_;
    Random& dice_;
    std::vector<Placed> placed_;
    Ways ways_;
};

// Furnishes by the room's type, what the prompt asks for first; what does not fit goes to spec.not_placed.
void furnish(Layout& layout);

// What is wrong with a layout, in words; empty = nothing. For tests and for make_room's own conscience.
std::vector<std::string> layout_faults(const Plan& plan, const std::vector<Placed>& placed);

}  // namespace fastscene
