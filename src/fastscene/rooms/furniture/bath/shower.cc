// Shower.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/worktop.h"

namespace fastscene::furniture {

void build_shower(Kit& k) {
    const int tray = k.main(porcelain()), chrome = k.material(k.style.tap);
    Material pane = glass();
    pane.color_a = pane.color_b = {0.75f, 0.8f, 0.79f};
    pane.transmission = 0.92f;
    const int clear = k.material(pane);
    k.board(tray, {0, 0, 0}, {0.9f, 0.06f, 0.9f}, 0.012f);
    k.board(clear, {0, 0.06f, 0.435f}, {0.86f, 1.94f, 0.008f}, 0.002f);
    k.board(clear, {0.435f, 0.06f, 0}, {0.008f, 1.94f, 0.86f}, 0.002f);
    k.board(chrome, {0.435f, 0.06f, 0.435f}, {0.02f, 1.96f, 0.02f}, 0.004f);
    k.board(chrome, {0, 1.99f, 0.435f}, {0.88f, 0.03f, 0.02f}, 0.004f);
    k.board(chrome, {0.435f, 1.99f, 0}, {0.02f, 0.03f, 0.88f}, 0.004f);
    k.rod(chrome, {0, 1.0f, -0.42f}, {0, 2.05f, -0.42f}, 0.011f);
    k.rod(chrome, {0, 2.04f, -0.42f}, {0, 2.04f, -0.1f}, 0.011f);
    k.rod(chrome, {0, 1.985f, -0.1f}, {0, 2.04f, -0.1f}, 0.11f, 0.02f, 28);
    k.rod(chrome, {-0.09f, 1.05f, -0.42f}, {0.09f, 1.05f, -0.42f}, 0.022f, -1, 16);
    k.rod(chrome, {-0.1f, 0.95f, 0.45f}, {-0.1f, 1.25f, 0.45f}, 0.01f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
