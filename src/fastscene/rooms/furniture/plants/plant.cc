// Potted plants of three sizes.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"
#include "fastscene/rooms/furniture/plants/species.h"

namespace fastscene::furniture {
namespace {

void potted(Kit& k, PlantSize place, float size) {
    const auto choice = species_for(place);
    const Species* drawn = choice[static_cast<std::size_t>(k.rng.index(static_cast<int>(choice.size())))];
    const Species* wished = species_named(k.request.pattern);
    const Species& species = wished ? *wished : *drawn;
    Material clay = plain("plant pot", k.rng.chance(0.4f) ? Vec3f{0.7f, 0.68f, 0.63f} : k.accent(), 0.6f);
    if (k.style.plants > 0.8f && size > 0.6f) clay = *material_named("wicker");
    const int pot = k.material(clay);
    grow(k, species, flower_pot(k, pot, 0.17f * size, 0.3f * size), size);
    k.piece.form = species.name;
}

}  // namespace

void build_plant(Kit& k) { potted(k, PlantSize::floor, 1.05f); }

void build_plant_tree(Kit& k) { potted(k, PlantSize::tree, 1.4f); }

void build_plant_small(Kit& k) {
    potted(k, PlantSize::small, 0.3f);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
