// Alarm clock.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_alarm_clock(Kit& k) {
    const int body = k.main(k.style.metal), face = k.material(plain("dial", {0.76f, 0.74f, 0.68f}, 0.4f)),
              dark = k.material(plain("hands", {0.04f, 0.04f, 0.04f}, 0.4f));
    Mesh drum = shapes::prism(shapes::circle(0.05f, 32), -0.02f, 0.02f, 0.006f),
         dial = shapes::prism(shapes::circle(0.043f, 32), 0.f, 0.003f, 0.001f);
    shapes::turn(drum, {1, 0, 0}, 90);
    shapes::turn(dial, {1, 0, 0}, 90);
    k.add(std::move(drum), body, {0, 0.065f, 0});
    k.add(std::move(dial), face, {0, 0.065f, 0.019f});
    k.board(dark, {0, 0.063f, 0.024f}, {0.003f, 0.034f, 0.001f}, 0.0003f);
    k.board(dark, {0.01f, 0.064f, 0.024f}, {0.022f, 0.003f, 0.001f}, 0.0003f);
    for (const float s : {-1.f, 1.f}) k.rod(body, {s * 0.03f, 0, 0}, {s * 0.022f, 0.025f, 0}, 0.005f);
    on_surface(k);
}

}  // namespace fastscene::furniture
