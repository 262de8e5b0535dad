// Paper lantern.
#include <algorithm>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {

// A ball of rice paper on a cord.
void build_paper_lantern(Kit& k) {
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.8f * k.request.size_factor,
                r = 0.24f * k.request.size_factor;
    k.sized = true;
    Material rice = plain("rice paper", {0.76f, 0.72f, 0.62f}, 0.9f);
    rice.transmission = 0.55f;
    const int paper = k.main(rice), cord = k.material(plain("cord", {0.6f, 0.58f, 0.54f}, 0.8f));
    // Dyed paper glows in its color.
    Material& dyed = k.piece.materials[static_cast<std::size_t>(paper)];
    dyed.emission = k.style.lamp_light * dyed.color_a * (0.3f / std::max(max_component(dyed.color_a), 0.05f));
    k.add(shapes::prism(shapes::circle(0.045f, 24), -0.022f, 0.f), cord);
    lamp_head(k, -drop, r, true, LampFamily::paper, paper);
    k.rod(cord, {0, -drop + 1.6f * r, 0}, {0, -0.01f, 0}, 0.003f, -1, 6);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
