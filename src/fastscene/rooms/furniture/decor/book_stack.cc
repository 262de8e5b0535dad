// Book stack.
#include <utility>

#include "fastscene/rooms/furniture/print.h"

namespace fastscene::furniture {

void build_book_stack(Kit& k) {
    const int count = 2 + k.rng.index(3);
    float y = 0.f;
    Random looks(k.request.seed, "covers");  // apart from the forms, which keep their draws
    const bool old = is_old_book(k.style, looks);
    const int paper = k.material(plain("paper", {0.72f, 0.68f, 0.58f}, 0.9f));
    for (int i = 0; i < count; ++i) {
        const float t = k.rng.uniform(0.018f, 0.038f), w = 0.24f - 0.018f * static_cast<float>(i),
                    d = 0.17f - 0.012f * static_cast<float>(i), yaw = k.rng.uniform(-14, 14);
        Material c = plain("book cover", lerp(cover_color(looks, old), 0.5f * k.accent(), 0.3f), 0.5f);
        const int cover = i == 0 ? k.main(c) : k.material(c);
        const auto put = [&](Vec3f size, Vec3f at, int mat) {
            Mesh m = shapes::box(size, 0.001f);
            shapes::turn(shapes::move(m, at), {0, 1, 0}, yaw);
            k.add(std::move(m), mat, {0, y, 0});
        };
        put({w, 0.003f, d}, {0, 0.0015f, 0}, cover);
        put({w, 0.003f, d}, {0, t - 0.0015f, 0}, cover);
        put({w, t, 0.004f}, {0, 0.5f * t, -0.5f * d}, cover);
        put({w - 0.012f, t - 0.005f, d - 0.01f}, {0, 0.5f * t, -0.002f}, paper);
        y += t + 0.0005f;
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
