// Tv.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {
namespace {

constexpr float kTvIsOn = 0.5f;  // as often as not: in empty rooms most are off, but a black one says little
constexpr Vec3f kTvWhite{1.3f, 1.3f, 1.35f};

}  // namespace

void build_tv(Kit& k) {
    const int dark = k.main(plain("black plastic", {0.032f, 0.032f, 0.034f}, 0.25f));
    const float w = 1.22f, h = 0.7f;
    Material off = plain("tv screen", {0.03f, 0.03f, 0.034f}, 0.08f);
    off.pattern = Pattern::screen;
    const int screen = k.rng.chance(kTvIsOn) ? lit_screen(k, Shown::broadcast, kTvWhite, w)
                                             : k.material(std::move(off));
    const bool hung = k.request.pattern == kHungScreen;
    const float foot = hung ? 0.f : 0.05f;
    k.board(dark, {0, foot, 0}, {w, h, 0.035f}, 0.005f);
    k.add(screen_box({w - 0.016f, h - 0.024f, 0.003f}), screen, {0, foot + 0.012f, 0.0175f});
    for (const float sx : {-1.f, 1.f}) {
        if (hung) break;
        k.board(dark, {sx * 0.36f, 0, 0}, {0.03f, 0.052f, 0.025f}, 0.003f);
        k.board(dark, {sx * 0.36f, 0, 0}, {0.03f, 0.012f, 0.22f}, 0.004f);
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
