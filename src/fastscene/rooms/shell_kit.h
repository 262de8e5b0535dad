// What the shell_*.cc files share: boxes in wall coordinates and the materials of the shell.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/rooms/plan.h"
#include "fastscene/scene/box.h"

namespace fastscene::shell {

// Builds boxes in wall coordinates: u along, y up, w into the room (negative: into the wall).
class WallBuilder {
  public:
    WallBuilder(const WallFace& face, Room& room) : face_(face), room_(room) {}
    void box(float u0, float u1, float y0, float y1, float w0, float w1, int material, int object = -1) const {
        if (!(u1 > u0 && y1 > y0 && w1 > w0)) return;
        if (std::min(std::abs(face_.along.x), std::abs(face_.along.z)) > 1e-4f)
            return slanted_box(u0, u1, y0, y1, w0, w1, material, object);
        const Vec3f a = face_.point(u0, y0) + face_.inward * w0, b = face_.point(u1, y1) + face_.inward * w1;
        room_.meshes.push_back(box_mesh({std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                                        {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}, material,
                                        object));
    }

    // A band between two lines of as many points (u, y), from depth w0 to w1: `outer` lies to the left of who walks
    // along `inner`. Closed.
    void band(const std::vector<Vec2f>& inner, const std::vector<Vec2f>& outer, float w0, float w1, int material,
              int object = -1) const;

  private:
    // The same at a wall that runs along neither x nor z.
    void slanted_box(float u0, float u1, float y0, float y1, float w0, float w1, int material, int object) const;

    const WallFace& face_;
    Room& room_;
};

// The edge of an arched or round opening, `grow` metres outside it: from its right foot over the top to its left one,
// or all around.
std::vector<Vec2f> edge_of(const Opening& o, float grow);

// What an arched, round or rounded opening leaves of the box about it, from depth w0 to w1.
void fill_corners(const WallBuilder& wall, const Opening& o, float w0, float w1, int material, int object);
inline constexpr int kCornerSteps = 6;  // of the arc in a rounded corner

// Indices of the shell's materials in room.materials.
struct Materials {
    int wall, accent, trim, floor, ceiling;
    int of_far_wall = wall;  // of a chimney breast
};

inline int add_material(Room& room, Material m) {
    room.materials.push_back(std::move(m));
    return static_cast<int>(room.materials.size()) - 1;
}

inline Material painted(const char* name, Vec3f color, float roughness) {
    Material m;
    m.name = name;
    m.color_a = m.color_b = m.color_c = color;
    m.roughness = roughness;
    return m;
}
// The usual material of a part of the shell, in the material, color and pattern that the prompt wants it in.
Material as_asked(const Plan& plan, std::string_view kind, Material usual);

inline constexpr float kCeilingThickness = 0.2f, kFloorThickness = 0.2f;
inline constexpr float kCasing = 0.08f;  // width of the frame about doors and windows
// What keeps two faces out of one plane, where renderers show one, the other, or black.
inline constexpr float kHair_m = 0.001f;

// The parts of a face that no opening of these kinds takes between heights y0 and y1, with `margin` beside openings.
std::vector<std::pair<float, float>> between_openings(const Plan& plan, const WallFace& face, float y0, float y1,
                                                      float margin);

// A ring about an opening that is not square, from `inside` to `outside` metres of its edge.
inline void ring(const WallBuilder& wall, const Opening& o, float inside, float outside, float w0, float w1,
                 int material, int object) {
    wall.band(edge_of(o, inside), edge_of(o, outside), w0, w1, material, object);
}
// How high an opening reaches at u, and how low.
std::pair<float, float> extent_at(const Opening& o, float u);
// A window or a door as an object, to which the next meshes belong.
int opening_object(const Plan& plan, Room& room, const char* kind, const Opening& o, const WallFace& face, float depth);
// The room's door with its casing, in the form that its kind has: shell_doors.cc.
void build_door(const Plan& plan, const Opening& o, Room& room, int trim, Random& rng);
// Panes in rubber and doors of glass; the curve below the ceiling; the tunnel outside: shell_cabin.cc.
void build_cabin_opening(const Plan& plan, const Opening& o, const WallBuilder& wall, Room& room, int object);
void build_cove(const Plan& plan, int material, Room& room);
void build_tunnel(const Plan& plan, Room& room);

// A part of the room as an object, with what the prompt said of it; its meshes follow.
int part_object(const Plan& plan, Room& room, const char* kind, Vec3f size);
void build_mezzanine(const Plan& plan, const Materials& materials, Room& room);

// The walls before corners that are cut off; the inside of a vault with its ribs, and its opening: shell_vaults.cc.
void build_cut_corners(const Plan& plan, int material, Room& room);
// A floor or a ceiling of the plan's outline.
void build_slab(const Plan& plan, float y0, float y1, int material, Room& room);
// What a wall has above the spring of a barrel vault.
void build_gable(const Plan& plan, int wall, int material, Room& room);
void build_vault(const Plan& plan, const Materials& materials, Room& room);

// A window without frame and panes: columns at its sides, the arch's moulding, a bench of stone below.
void build_arcade_arch(const Opening& o, const WallFace& face, Room& room, int wall, int object);
void build_openings(const Plan& plan, const Materials& materials, Room& room);  // windows, doors, doorways
// Tiers and steps: shell_tiers.cc.
void build_platforms(const Plan& plan, const Materials& materials, Room& room);
void build_skylights(const Plan& plan, const Materials& materials, Room& room);  // with the slopes they are in
void build_trim(const Plan& plan, const Materials& materials,
                Room& room);  // skirting, mouldings, panelling, beams, coffers

}  // namespace fastscene::shell
