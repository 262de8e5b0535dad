// What blinds and shutters share.
#include "fastscene/rooms/furniture/openings/blind_parts.h"

#include <algorithm>
#include <utility>

namespace fastscene::furniture {

int blind_cloth(Kit& k, Material m, float through) {
    m.transmission = through;
    m.specular = 0.02f;
    const int cloth = k.main(std::move(m));
    constexpr float kVeil = 0.5f, kLeast = 0.12f;
    Material& dyed = k.piece.materials[static_cast<std::size_t>(cloth)];
    dyed.transmission = through * std::clamp(luminance(dyed.color_a) / kVeil, kLeast, 1.f);
    return cloth;
}

float drawn(Kit& k, float least, float most) { return Random(k.request.seed, "drawn").uniform(least, most); }

}  // namespace fastscene::furniture
