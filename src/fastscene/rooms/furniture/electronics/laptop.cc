// Laptop.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {

void build_laptop(Kit& k) {
    const int alu = k.main(plain("aluminium", {0.5f, 0.51f, 0.52f}, 0.35f)),
              dark = k.material(plain("dark plastic", {0.04f, 0.04f, 0.043f}, 0.4f));
    k.board(alu, {}, {0.32f, 0.014f, 0.22f}, 0.004f);
    if (k.rng.chance(0.4f)) return k.board(alu, {0, 0.014f, 0}, {0.32f, 0.008f, 0.22f}, 0.003f), on_surface(k);
    k.board(dark, {0, 0.0135f, -0.02f}, {0.28f, 0.002f, 0.1f}, 0.0005f);
    Mesh lid = shapes::box({0.32f, 0.21f, 0.007f}, 0.003f), face = screen_box({0.3f, 0.19f, 0.002f});
    shapes::move(face, {0, -0.095f, 0.004f});
    for (Mesh* m : {&lid, &face}) shapes::move(shapes::turn(*m, {1, 0, 0}, -18), {0, 0.112f, -0.14f});
    k.add(lid, alu);
    k.add(face, lit_screen(k, Shown::desktop, kMonitorWhite, 0.3f));
    on_surface(k);
}

}  // namespace fastscene::furniture
