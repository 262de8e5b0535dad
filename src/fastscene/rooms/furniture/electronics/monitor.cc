// Monitor.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {

// On a foot, lit as a computer's is.
void build_monitor(Kit& k) {
    const int dark = k.main(plain("black plastic", {0.032f, 0.032f, 0.034f}, 0.3f));
    const float w = 0.55f, h = 0.33f, foot = 0.1f;
    const int screen = lit_screen(k, Shown::desktop, kMonitorWhite, w);
    k.board(dark, {0, foot, 0}, {w, h, 0.03f}, 0.005f);
    k.add(screen_box({w - 0.02f, h - 0.024f, 0.003f}), screen, {0, foot + 0.012f, 0.015f});
    k.board(dark, {0, 0.01f, -0.022f}, {0.05f, foot + 0.1f, 0.016f}, 0.004f);
    k.board(dark, {0, 0, 0}, {0.22f, 0.012f, 0.16f}, 0.004f);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
