// Record player.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A wooden case, a platter with a record on it, an arm.
void build_record_player(Kit& k) {
    const int wood = k.main(k.style.wood), black = k.material(plain("vinyl record", {0.012f, 0.012f, 0.013f}, 0.22f)),
              metal = k.material(steel()), dark = k.material(plain("mat", {0.03f, 0.03f, 0.03f}, 0.9f)),
              label = k.material(plain("label", k.accent(), 0.7f)),
              top = k.material(plain("deck", {0.05f, 0.05f, 0.052f}, 0.45f));
    k.board(wood, {0, 0.012f, 0}, {0.44f, 0.09f, 0.35f}, 0.008f);
    for (const float sx : {-0.17f, 0.17f})
        for (const float sz : {-0.13f, 0.13f}) k.rod(dark, {sx, 0, sz}, {sx, 0.014f, sz}, 0.018f, -1, 14);
    k.board(top, {0, 0.101f, 0}, {0.41f, 0.004f, 0.32f}, 0.002f);
    const Vec3f hub{-0.045f, 0, 0};
    k.add(shapes::prism(shapes::circle(0.152f, 56), 0.105f, 0.12f, 0.003f), metal, hub);
    k.add(shapes::prism(shapes::circle(0.148f, 56), 0.12f, 0.1235f, 0.001f), black, hub);
    for (const float r : {0.07f, 0.09f, 0.11f, 0.13f}) {
        Mesh groove = shapes::ring(r, 0.0009f, 48);
        k.add(std::move(groove), dark, {hub.x, 0.1236f, hub.z});
    }
    k.add(shapes::prism(shapes::circle(0.05f, 32), 0.1235f, 0.1242f, 0.0003f), label, hub);
    k.rod(metal, {hub.x, 0.12f, hub.z}, {hub.x, 0.132f, hub.z}, 0.0035f, -1, 8);
    // The arm on its post, its needle on the record.
    const Vec3f post{0.16f, 0.105f, -0.1f};
    k.rod(metal, post, post + Vec3f{0, 0.035f, 0}, 0.018f, 0.014f, 18);
    const std::array<Vec3f, 4> arm{{post + Vec3f{0, 0.036f, -0.035f},
                                    post + Vec3f{0, 0.036f, 0.04f},
                                    {0.145f, 0.138f, 0.05f},
                                    {0.06f, 0.132f, 0.09f}}};
    k.add(shapes::tube(arm, 0.0045f, 8), metal);
    k.board(dark, {0.055f, 0.125f, 0.094f}, {0.022f, 0.009f, 0.03f}, 0.002f);
    k.rod(metal, post + Vec3f{0, 0.036f, -0.055f}, post + Vec3f{0, 0.036f, -0.03f}, 0.014f, -1, 14);
    k.rod(metal, {0.17f, 0.104f, 0.12f}, {0.17f, 0.115f, 0.12f}, 0.014f, -1, 16);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
