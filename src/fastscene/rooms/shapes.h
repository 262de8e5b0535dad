// Shapes: the solids furniture is made of. Every maker returns a Mesh in its own frame (y up, metres), normals outward,
// closed unless it says otherwise. coords follow the wood's rule: the long axis of the part lies along coords.y.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene::shapes {

// A hard box, centered at the origin, whose edges are rounded by `bevel_m` (one flat chamfer with smooth normals).
Mesh box(Vec3f size_m, float bevel_m = 0.004f);

// An upholstered box, centered: edges of radius `round_m`, each face bulged by up to `puff_m`, and cloth wrinkles.
// Fits the box size_m: the bulge is taken from inside it.
struct Soft {
    float round_m = 0.05f, puff_m = 0.03f, wrinkle_m = 0.003f;
    int steps = 14;  // grid cells along the longest edge
    std::uint32_t seed = 0;
};
Mesh soft_box(Vec3f size_m, const Soft& soft);

// A cushion standing on its lower edge: width x, height y, thickness z; center of its lower edge at the origin.
Mesh pillow(Vec3f size_m, std::uint32_t seed, int steps = 12);

// A profile of (radius, height) points, from bottom to top, turned about y. Ends of radius > 0 are closed with discs.
// Corners sharper than 35 degrees stay sharp unless `smooth`.
Mesh lathe(std::span<const Vec2f> profile, int sides = 24, bool smooth = false);
// A thin-walled vessel or shade: the same, but with an inner wall; open at the top.
Mesh vessel(std::span<const Vec2f> profile, float wall_m, int sides = 24);
// An open sheet of revolution (lampshades): both sides are seen.
Mesh shade(std::span<const Vec2f> profile, int sides = 28);

// A smooth curve through the points (Catmull-Rom), `steps` pieces between two of them.
std::vector<Vec2f> curve(std::span<const Vec2f> points, int steps);

// A round bar from a to b with the given radii, with slightly rounded ends.
Mesh rod(Vec3f a, Vec3f b, float radius_a, float radius_b, int sides = 12);
Mesh ball(Vec3f center, Vec3f radii, int sides = 16);
// A tube of constant radius along a curve.
Mesh tube(std::span<const Vec3f> path, float radius_m, int sides = 8);
Mesh ring(float radius_m, float thickness_m, int sides = 28);  // a torus about y

// A horizontal polygon (x, z), counter-clockwise seen from above (+y), extruded from y0 to y1, edges chamfered.
Mesh prism(std::span<const Vec2f> outline, float y0, float y1, float bevel_m = 0.003f);
std::vector<Vec2f> rounded_rectangle(float width, float depth, float radius, int steps = 6);
std::vector<Vec2f> circle(float radius, int steps = 40);

// A rounded limb: from a to b, its radius growing from ra to rb.
struct Limb {
    Vec3f a, b;
    float ra, rb;
};
// The one smooth skin about all limbs, which flow into each other where they are nearer than about `flow_m`: animals.
// Closed; `cell_m` is the length of its triangles' edges, coords are positions.
Mesh skin(std::span<const Limb> limbs, float flow_m, float cell_m);

// An open sheet: point(u, v) for u, v in [0, 1]; the normal is d/du x d/dv.
Mesh sheet(int columns, int rows, const std::function<Vec3f(float, float)>& point);
// The sheet with a second one `thickness_m` behind it and closed rims.
Mesh slab(int columns, int rows, float thickness_m, const std::function<Vec3f(float, float)>& point);

// Moves the mesh; coords stay.
Mesh& move(Mesh& mesh, Vec3f by);
Mesh& turn(Mesh& mesh, Vec3f axis, float degrees);
void append(Mesh& mesh, const Mesh& part);
// coords from positions with the longest axis of the bounding box along coords.y, plus an offset.
void lay_grain(Mesh& mesh, Vec3f offset = {});
void smooth_normals(Mesh& mesh);  // area-weighted, over vertices that share an index

struct Box {
    Vec3f low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
};
Box bounds(const Mesh& mesh);
float signed_volume(const Mesh& mesh);

// Smooth noise in [-1, 1], about one feature a unit.
float wobble(Vec3f p, std::uint32_t seed);

}  // namespace fastscene::shapes
