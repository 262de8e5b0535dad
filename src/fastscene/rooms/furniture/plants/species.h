// Species of house plants: what distinguishes them, as data, and how they grow.
#pragma once

#include <span>
#include <string_view>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// How a plant is built.
enum class Habit : unsigned char {
    clump,    // leaves on stalks from the soil
    canes,    // upright stems with leaves around their upper part
    rosette,  // bare stems, each with a tuft of leaves on top
    fronds,   // arching ribs with leaflets on both sides
    tree,     // a trunk and a branched crown
};
enum class LeafShape : unsigned char { sword, lance, ovate, violin, heart, split };

// Lengths are for a plant about one metre high above its pot; they scale with it. Angles in radians above the horizon.
struct Species {
    const char* name;  // as gardeners call it, and as wishes name it: "monstera"
    Habit habit;
    LeafShape leaf;
    Vec3f green;
    float gloss;  // roughness of the leaf
    int stems;    // canes and rosettes: how many; fronds: ribs
    int leaves;   // of the plant (clump), of each stem, or pairs of each rib
    float leaf_m, leaf_wide_m;
    float stalk_m;    // clump: of the leaf; canes, rosette, tree: height of the stem; fronds: length of the rib
    float low, high;  // rise of the outermost and of the innermost leaf or stalk
    float droop;      // how far a leaf or rib bends down along its length
    bool flowers;     // white spathes
};

// Those that are at home on the floor, those as high as a person, and those for a table or a shelf.
enum class PlantSize : unsigned char { floor, tree, small };
std::span<const Species* const> species_for(PlantSize size);
// By its name; null: unknown.
const Species* species_named(std::string_view name);

// Grows out of the soil at height `y`, `size` times as large as the table has it.
void grow(Kit& k, const Species& species, float y, float size);

}  // namespace fastscene::furniture
