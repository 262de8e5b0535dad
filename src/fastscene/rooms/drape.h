// Cloth that falls on solids and comes to rest: duvets, throws, tablecloths.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

// What cloth falls on: a box with rounded edges. Piece's frame: y up, metres.
struct DrapeSolid {
    Vec3f center, half;
    float round_m = 0.03f;
};

// A rectangle of cloth, spread level in the air before it falls.
struct Cloth {
    Vec2f low, high;         // its corners: x, z
    float from_y = 0;        // height from which it falls
    float slack = 0.02f;     // the share by which it is wider than where it is spread: this makes its folds
    float stiffness = 0.3f;  // of its bending, in [0, 1]: a duvet's folds are broad, a sheet's narrow
    float clear_m = 0.004f;  // its middle stays this far from solids and from the floor
    float cell_m = 0.06f;    // distance of the points that are simulated
    Vec2f most{1e9f, 1e9f};  // |x| and |z| that it keeps within, as if tucked in: what stands beside has its place
    std::uint32_t seed = 0;
};

// Cloth at rest: a grid of points, smooth between them.
struct DrapedCloth {
    int columns = 0, rows = 0;  // cells along x and along z
    Vec2f size_m;               // of the flat cloth
    std::vector<Vec3f> points;  // (columns + 1) * (rows + 1), row by row

    Vec3f at(float u, float v) const;  // u along x, v along z, in [0, 1]
};

// Position-based dynamics (Müller et al., "Position Based Dynamics", 2007): points joined by links that keep their
// lengths, pulled down by gravity, pushed out of the solids and held there by friction. Cloth does not collide with
// itself. The same arguments give the same bytes.
DrapedCloth drape(const Cloth& cloth, std::span<const DrapeSolid> solids);

// The cloth as a closed mesh whose upper side is at its points, `thick_m` thick, of squares about `cell_m` wide. coords
// are those of the flat cloth (z, x), so that patterns follow the folds.
Mesh cloth_mesh(const DrapedCloth& cloth, float thick_m, float cell_m = 0.045f);

}  // namespace fastscene
