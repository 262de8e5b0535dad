// Plan: the empty room. Room frame, right-handed: y UP, z towards the far wall, x to the left of who faces it, metres;
// the floor is y = 0 and the plan's center is the origin. Walls are numbered 0 far (+z), 1 (+x), 2 near (-z), 3 (-x); 1
// is called right and 3 left, as seen from the far wall.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/base/random.h"
#include "fastscene/rooms/footprint.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/style.h"

namespace fastscene {

inline constexpr float kWallThickness = 0.22f;
// A window's sill: how far it reaches into the room, beside the window, and how thick it is. A column's capital: how
// far it stands proud.
inline constexpr float kSillReach = 0.04f, kSillBeside = 0.05f, kSillThickness = 0.03f, kCapitalReach = 0.025f;
inline constexpr float kPanelThickness = 0.06f;  // of a cabin's walls
inline constexpr float kRevealDepth = 0.12f;     // of a window: from the wall's face to the frame
inline constexpr float kBeamDepth = 0.18f;       // from the ceiling down
inline constexpr float kBeamWidth = 0.16f;

// How far a tray ceiling steps down along the walls, and how wide that border is.
inline constexpr float kTrayStep = 0.09f, kTrayBorder = 0.55f;

inline constexpr const char* kNeon = "neon strip";  // the name of their materials

// A hole in a wall (window, doorway without a door), or a door leaf set before it. `u` runs along the wall from its
// right end as seen from inside.
struct Opening {
    enum class Kind : unsigned char { window, door, doorway } kind = Kind::window;
    int wall = 0;
    float u0 = 0, u1 = 0, y0 = 0, y1 = 0;  // of the box about it, whatever its shape
    bool requested = false;
    enum class Shape : unsigned char { square, arched, round, rounded } shape = Shape::square;  // rounded: its corners
    Glazing glazing = Glazing::window;
};
// How high an arch rises above where it springs; a wide one is flatter than half a circle, and legs are left below it.
inline float arch_rise(const Opening& o) {
    constexpr float kLegs = 0.5f;  // share of the height that stays upright
    return std::min(0.5f * (o.u1 - o.u0), (1.f - kLegs) * (o.y1 - o.y0));
}

// The inner face of a wall.
struct WallFace {
    Vec3f origin;  // its right end at the floor, as seen from inside
    Vec3f along;   // unit, to the left as seen from inside
    Vec3f inward;  // unit, into the room
    float length;
    int wall = -1;     // the wall it is a part of; -1: the side of a block
    float from = 0;    // where on that wall its u begins
    float behind = 0;  // a chord before a curved or cut corner: how far the wall is behind it at most; 0: a wall
    Vec3f point(float u, float y) const { return origin + along * u + Vec3f{0, y, 0}; }
};

// Whether things hang at this face: a chord is nearly at the wall.
inline bool hangs_at(const WallFace& face) { return face.behind < 0.035f; }

// Whether wishes of this class are for the shell: make_plan heeds them, or says in spec.not_placed why it cannot.
bool is_shell(std::string_view kind);

// A part of the plan's box that is not room, from floor to ceiling: the corner that an L leaves out, a chimney breast,
// a column; or what lies behind a corner that is cut off straight (of an octagon) or by a quarter of an ellipse (of
// round rooms and apses), where `low` and `high` are the box of what is cut off; or what the stairs of a mezzanine
// take.
struct Block {
    enum class Kind : unsigned char { corner, breast, column, cut, curve, stairs } kind = Kind::corner;
    Vec2f low, high;  // x, z
};
inline bool cuts_corner(const Block& b) { return b.kind == Block::Kind::cut || b.kind == Block::Kind::curve; }
// The wall before a corner that is cut off: points (x, z) from one wall of the box to the next, in the order of the
// walls. Convex seen from outside.
std::vector<Vec2f> cut_edge(const Block& block);

// A part of the floor that is raised: a box on it. Tiers carry rows of seats; steps lead up an aisle from one to the
// next, and stand on the lower one. Where two overlap, the higher is the floor.
struct Platform {
    enum class Kind : unsigned char { tier, step } kind = Kind::tier;
    Vec2f low, high;   // x, z
    float height = 0;  // of its top
};
inline constexpr float kMostStep = 0.2f;    // metres that one climbs at once
inline constexpr float kBehindRow = 0.03f;  // free between the backs of a row and the end of its tier

// A window in a sloped ceiling above wall 1 or 3: from z0 to z1, and from s0 to s1 metres up the slope.
struct Skylight {
    int wall = 1;
    float z0 = 0, z1 = 0, s0 = 0, s1 = 0;
};

// A floor halfway up over the far part of the room, open to it behind a railing, with stairs along a side wall. What
// stands on it is the furniture of a next room.
struct Mezzanine {
    float depth = 0;      // from the far wall; 0: there is none
    float floor = 0;      // height of its floor
    int stairs_wall = 1;  // 1 or 3
};
inline constexpr float kMezzanineSlab = 0.2f;     // thickness
inline constexpr float kMezzanineStairs = 0.85f;  // width
inline constexpr float kMezzanineGoing = 0.19f;   // of a step: steep, as such stairs are
inline constexpr int kMezzanineSteps = 13;

struct NextRoom;

struct Plan {
    float width = 4, depth = 5, height = 2.7f;  // inside
    std::vector<Opening> openings;
    Style style;            // with the prompt's wishes for walls, floor and so on worked in
    bool measured = false;  // width or depth were said: nothing adds to them
    bool accent = false;    // one wall has the accent material
    int accent_wall = 0;    // that one
    std::array<std::optional<Material>, 4> own_walls{};  // by number: those with a material of their own
    bool beams = false;
    bool tray = false;                // the ceiling steps down along the walls
    bool neon = false;                // strips of colored light below the ceiling
    std::optional<Vec3f> neon_color;  // an albedo of that hue; nothing: pink and blue
    bool recessed_lights = false;     // small lamps sunk into the ceiling
    bool coffers = false;             // a grid of beams in the color of the trim
    bool bay = false;                 // the recess of the far wall is all window
    RoomDoor door;                    // what the room's own is like
    bool glazed = true;               // windows have frames and panes; else they are the open arches of an arcade
    WallRelief relief = WallRelief::flat;
    bool cabin = false;      // of a vehicle or a lift: thin panels, no skirting, panes in rubber
    float cove = 0;          // radius of the curve between walls 1 and 3 and the ceiling
    bool tunnel = false;     // the room is in one
    bool panelling = false;  // walls are panelled to the height of a chair's back
    Vault vault = Vault::flat;
    float spring = 0;  // height at the walls at which a vault begins; it reaches `height` in the middle
    float oculus = 0;  // radius of a round opening to the sky at the top of a dome; 0: none
    Mezzanine mezzanine;
    std::vector<Block> blocks;
    std::vector<Platform> platforms;        // empty: all of the floor is y = 0
    std::vector<PromptObject> asked_parts;  // what of is_shell the prompt asks for
    // Sloped ceiling (attic): it begins at this height at walls 1 and 3 and reaches `height` after slope_run metres; 0
    // = flat.
    float knee = 0, slope_run = 0;
    std::vector<Skylight> skylights;
    std::shared_ptr<const NextRoom> next;  // behind the doorway
    bool joined = false;                   // this is such a next room: its near wall (2) is built by the other

    WallFace wall(int i) const;
    // Whether the place in front of an opening must stay free. Not before the panes of a cabin: they have neither sills
    // nor curtains, and seats stand at them.
    bool needs_room(const Opening& o) const { return !cabin || o.kind != Opening::Kind::window || is_doors(o.glazing); }
    float wall_thickness() const { return cabin ? kPanelThickness : kWallThickness; }
    const Material& wall_material(int i) const;
    // What the prompt says of a part of the shell, or nothing.
    const PromptObject* asked(std::string_view kind) const;
    // The box without the corners that are cut off: points (x, z) in the order of the walls, each once.
    std::vector<Vec2f> outline() const;
    // All pieces of wall where things may stand or hang, sides of blocks too. Before curved and cut corners also
    // chords, at which things stand that are wider than the flat parts of the wall.
    std::vector<WallFace> faces() const;
    float ceiling_at(Vec2f point) const;
    // The part of a wall (u0, u1) that is not cut off at its ends.
    std::pair<float, float> uncut_span(int wall) const;
    // How high walls go before a vault or the floor of a mezzanine begins.
    float wall_top() const {
        return mezzanine.depth > 0 ? mezzanine.floor - kMezzanineSlab : vault == Vault::flat ? height : spring;
    }
    // The edge of the mezzanine along z; the far wall where there is none.
    float mezzanine_edge() const { return depth / 2 - mezzanine.depth; }
    float floor_at(Vec2f point) const;
    // The highest floor below a box; and whether all of the floor below it is as high.
    float floor_below(const Footprint& box) const;
    bool is_level(const Footprint& box) const;
    // The highest floor that a part of a wall face stands on.
    float floor_before(const WallFace& face, float u0, float u1) const;
    // Whether the box lies in the room: within the walls, out of blocks, above the floor, below the ceiling.
    bool holds(const Footprint& box) const;
    // Distance to the nearest wall or block on the floor, and to any of them or a sloped ceiling in space.
    float wall_distance(Vec2f point) const;
    float air_around(Vec3f point) const;
    // The longest part of a wall (u0, u1) before which nothing stands and above which the ceiling is at least this
    // high; `level`: and before which the floor is y = 0, as doors want it.
    std::pair<float, float> free_span(int wall, float height, bool level = false) const;
};

inline bool has_cut_corners(const Plan& plan) {
    return std::any_of(plan.blocks.begin(), plan.blocks.end(), cuts_corner);
}

// How far up a vault is at a point, 0 where it springs from the walls to 1 at its top; and at a share `out` of the way
// from the middle to the walls.
float vault_rise(const Plan& plan, Vec2f p);
float vault_profile(Vault vault, float out);
// The outline of a round room of this size, for the roofs over one; and how far along a direction it is.
std::vector<Vec2f> round_outline(Vec2f size);
float reach_of(const std::vector<Vec2f>& outline, Vec2f direction);
// Where along z a barrel vault ends in the half dome over an apse; the far wall: it has none.
float conch_from(const Plan& plan);

// The room one sees through the doorway. Its own near wall (2) is the back of ours.
struct NextRoom {
    Plan plan;
    std::string type;      // "dining" …
    Rigid room_from_next;  // from its room frame into ours
};

// The shape of the room beyond a box, by room type, style and wishes: blocks, slopes, coffers, panelling. Before the
// openings.
void shape_plan(PromptSpec& spec, Plan& plan, Random& rng);
// Skylights, and a doorway to a next room where a wall is left for it. After windows and door.
void open_plan(PromptSpec& spec, Plan& plan, Random& rng);

// The tiers that the rows of the room's recipe stand on, where the room is large and high enough for them. Once it has
// its shape.
void add_tiers(const PromptSpec& spec, Plan& plan);
// Windows whose sills a tier would reach are lifted above it, or left out; and a door is moved to where the floor is
// y = 0, beside the tiers.
void lift_windows(PromptSpec& spec, Plan& plan);
void move_door(Plan& plan, Opening& door);

// Beams run along x, evenly spaced over the room's depth: the middle of the first is half a space from the wall.
inline int beam_count(const Plan& plan) { return std::max(2, static_cast<int>(plan.depth / 1.1f)); }
// Its middle in z.
inline float beam_z(const Plan& plan, int i) {
    return plan.depth * ((static_cast<float>(i) + 0.5f) / static_cast<float>(beam_count(plan)) - 0.5f);
}

// Size, openings and surfaces from what the prompt asks and the room's type; the rest is drawn from `rng`.
// Adds to spec.assumed what it chose.
Plan make_plan(PromptSpec& spec, Random& rng);

// Walls, floor, ceiling, mouldings, window frames, door: meshes in the room frame. Materials and objects are appended
// to `room` (objects still with room-frame poses), portals too.
void build_shell(const Plan& plan, Room& room);

}  // namespace fastscene
