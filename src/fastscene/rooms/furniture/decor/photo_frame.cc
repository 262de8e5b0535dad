// Photo frame.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_photo_frame(Kit& k) {
    const int frame = k.main(k.rng.chance(0.5f) ? k.style.metal : k.style.wood);
    Material m = plain("photograph", {0.5f, 0.47f, 0.42f}, 0.25f);
    m.pattern = Pattern::art;
    m.color_a = k.accent(), m.color_b = k.accent(), m.color_c = {0.7f, 0.67f, 0.6f};
    m.scale_m = 0.15f;
    m.seed = k.seed();
    const int photo = k.material(m);
    const float w = k.rng.uniform(0.12f, 0.2f), h = w * k.rng.uniform(0.8f, 1.35f);
    Mesh back = shapes::box({w, h, 0.014f}, 0.004f), face = shapes::box({w - 0.035f, h - 0.035f, 0.003f}, 0.0005f);
    shapes::move(back, {0, 0.5f * h, 0});
    shapes::move(face, {0, 0.5f * h, 0.008f});
    face.coords = face.positions;
    for (Vec3f& c : face.coords) c.y -= 0.5f * h;
    for (Mesh* part : {&back, &face}) shapes::turn(*part, {1, 0, 0}, -10);
    k.add(back, frame);
    k.add(face, photo);
    k.board(frame, {0, 0, -0.05f}, {0.03f, 0.004f, 0.1f}, 0.001f);
    on_surface(k);
}

}  // namespace fastscene::furniture
