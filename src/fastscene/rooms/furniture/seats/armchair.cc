// Armchairs.
#include <utility>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/seats/couch.h"
#include "fastscene/rooms/furniture/seats/sofa_forms.h"

namespace fastscene::furniture {
namespace {

void shell_chair(Kit& k) {
    // A shell chair: wooden frame, seat and back pads.
    const int cloth = k.main(k.style.fabric), wood = k.material(k.style.wood);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.34f;
        k.rod(wood, {x, 0, 0.33f}, {x, 0.6f, 0.27f}, 0.014f, 0.02f);
        k.rod(wood, {x, 0, -0.38f}, {x, 0.6f, -0.24f}, 0.014f, 0.02f);
        Mesh arm = shapes::box({0.06f, 0.028f, 0.68f}, 0.01f);
        shapes::turn(arm, {1, 0, 0}, -4);
        k.add(std::move(arm), wood, {x, 0.6f, 0});
        k.rod(wood, {x, 0.3f, 0.3f}, {x, 0.26f, -0.31f}, 0.015f);
    }
    k.rod(wood, {-0.34f, 0.29f, 0.29f}, {0.34f, 0.29f, 0.29f}, 0.016f);
    k.rod(wood, {-0.34f, 0.26f, -0.3f}, {0.34f, 0.26f, -0.3f}, 0.016f);
    Mesh seat = shapes::soft_box({0.62f, 0.15f, 0.64f}, {0.05f, 0.03f, 0.004f, 9, k.seed()});
    shapes::turn(seat, {1, 0, 0}, -5);
    k.add(std::move(seat), cloth, {0, 0.37f, 0.03f});
    Mesh back = shapes::soft_box({0.62f, 0.56f, 0.14f}, {0.05f, 0.03f, 0.004f, 9, k.seed()});
    shapes::turn(back, {1, 0, 0}, -17);
    k.add(std::move(back), cloth, {0, 0.64f, -0.3f});
    k.top(0.455f, 0, 0.08f, 0.24f, 0.18f);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace

void build_armchair(Kit& k) {
    if (is_woven(k)) return rattan_chair(k);
    switch (form_for(k, k.style.forms.armchair)) {
        case ArmchairForm::padded: return couch(k, 0.92f, 1, k.rng.index(2));
        case ArmchairForm::wing: return wing_chair(k);
        case ArmchairForm::tub: return channel_seat(k, 0.8f, 17);
        case ArmchairForm::sling: return sling_chair(k);
        case ArmchairForm::rattan: return rattan_chair(k);
        case ArmchairForm::shell: return shell_chair(k);
    }
}

}  // namespace fastscene::furniture
