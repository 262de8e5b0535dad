// Sofas, love seats, corner sofas.
#include <algorithm>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/seats/couch.h"
#include "fastscene/rooms/furniture/seats/sofa_forms.h"

namespace fastscene::furniture {
namespace {

SofaForm sofa_form(Kit& k) { return is_woven(k) ? SofaForm::framed : form_for(k, k.style.forms.sofa); }

void sofa_of(Kit& k, float width, int seats, int pillows) {
    switch (sofa_form(k)) {
        case SofaForm::framed: return frame_sofa(k, width, seats);
        case SofaForm::buttoned: return chesterfield(k, width, seats);
        case SofaForm::channelled: return channel_seat(k, width, seats * 8);
        case SofaForm::padded: return couch(k, width, seats, pillows);
    }
}

// The long seat of a corner sofa, at the right of a padded one: what reaches before the last of its cushions.
void corner_of(Kit& k, float width, int seats) {
    const SofaType type = k.style.sofa;
    const bool slim = type == SofaType::slim, rolled = type == SofaType::rolled;
    const int cloth = k.piece.main_material, foot = k.material(slim ? k.style.wood : k.style.wood2);
    const float arm = slim     ? 0.07f
                      : rolled ? 0.17f
                               : 0.2f,
                leg = slim     ? 0.17f
                      : rolled ? 0.09f
                               : 0.05f,
                seat_y = 0.43f, front = 0.5f * (slim ? 0.82f : 0.93f), reach = 0.7f, inside = width - 2 * arm,
                w = inside / static_cast<float>(seats) + (slim ? 0.f : 0.5f * arm),
                x = 0.5f * inside - inside / static_cast<float>(2 * seats) + (slim ? 0.f : 0.25f * arm);
    k.soft(cloth, {x, leg, front + 0.5f * reach - 0.03f}, {w - 0.01f, seat_y - 0.16f - leg, reach + 0.04f},
           {0.02f, 0.004f, 0.002f, 8});
    k.soft(cloth, {x, seat_y - 0.17f, front + 0.5f * reach - 0.035f}, {w - 0.004f, 0.19f, reach + 0.02f},
           {0.05f, 0.035f, 0.004f, 9});
    for (const float sx : {-1.f, 1.f})
        k.rod(foot, {x + sx * (0.5f * w - 0.09f), 0, front + reach - 0.12f},
              {x + sx * (0.5f * w - 0.09f), leg + 0.01f, front + reach - 0.12f}, 0.018f, 0.026f, 12);
}

}  // namespace

void build_sofa(Kit& k) {
    const float w = k.request.size_m.x > 0 ? k.request.size_m.x : 2.2f * k.request.size_factor;
    k.sized = true;
    if (k.request.pattern == "corner") {
        const float wide = std::max(w, 2.f) + (k.request.size_m.x > 0 ? 0.f : 0.3f);
        couch(k, wide, 3, 2 + k.rng.index(3));
        return corner_of(k, wide, 3);
    }
    sofa_of(k, std::max(w, 1.2f), w > 1.9f ? 3 : 2, 2 + k.rng.index(3));
}

void build_loveseat(Kit& k) { sofa_of(k, 1.55f, 2, 2); }

}  // namespace fastscene::furniture
