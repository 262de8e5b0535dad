// Plants grown by rule: trees by space colonization, spruces by whorls, hedges, shrubs, flowers, ferns and grass.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/trace/outdoors_world.h"

namespace fastscene::outdoors {

enum class Crown : std::uint8_t { round, ovate, columnar, umbrella };
struct TreeKind {
    float height_m, bare_m;  // bare: trunk below the crown
    float radius_m;          // of the crown
    Crown crown;
    float leaf_m;  // length of a leaf, or of a needle
    int leaves;
    std::uint16_t bark = kBark;
    bool needles = false;  // tufts of needles instead of leaves
    float lean = 0.25f;    // how far the trunk wanders
};
// `bare`: in winter, twigs instead of leaves.
QuadMesh grow_tree(const TreeKind& kind, std::uint32_t seed, bool bare = false);
QuadMesh grow_spruce(float height_m, float radius_m, std::uint32_t seed);

// A piece of clipped hedge along x.
QuadMesh grow_hedge(float long_m, float high_m, float thick_m, std::uint32_t seed);
// `bloom`: share of its leaves that are flowers.
QuadMesh grow_shrub(float radius_m, float high_m, float leaf_m, float bloom, std::uint32_t seed);
QuadMesh grow_perennial(float high_m, int stems, bool flowers, std::uint32_t seed);
QuadMesh grow_fern(std::uint32_t seed);
// A square of lawn around the origin.
QuadMesh grow_grass(float side_m, int blades, float high_m, float width_m, std::uint32_t seed);
void add_blade(QuadMesh& mesh, Vec3f foot, float high_m, float width_m, Random& random);

// A tapered tube between two points.
void add_tube(QuadMesh& mesh, Vec3f from, Vec3f to, float from_radius, float to_radius, int sides, std::uint16_t paint);

}  // namespace fastscene::outdoors
