// Cot mobile.
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Small shapes of felt on threads, under a cross of wood.
void build_cot_mobile(Kit& k) {
    const int wood = k.main(*material_named("birch")), thread = k.material(plain("thread", {0.6f, 0.58f, 0.54f}, 0.8f));
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.95f, cross_y = -drop + 0.34f;
    k.sized = true;
    k.add(shapes::prism(shapes::circle(0.03f, 20), -0.012f, 0.f, 0.003f), wood);
    k.rod(thread, {0, cross_y, 0}, {0, -0.008f, 0}, 0.002f, -1, 6);
    k.add(shapes::ball({0, cross_y, 0}, {0.02f, 0.02f, 0.02f}, 12), wood);
    std::array<int, 4> felts{};
    for (std::size_t i = 0; i < 4; ++i)
        felts[i] = k.material(plain("felt", lerp(k.style.palette[i], {0.66f, 0.62f, 0.58f}, 0.3f), 0.95f));
    for (int i = 0; i < 6; ++i) {
        const float a = 1.0472f * static_cast<float>(i), c = std::cos(a), s = std::sin(a),
                    down = cross_y - (i % 2 == 0 ? 0.17f : 0.25f);
        const Vec3f end{0.21f * c, cross_y, 0.21f * s}, at{end.x, down, end.z};
        k.rod(wood, {0, cross_y, 0}, end, 0.006f, -1, 8);
        k.rod(thread, at, end, 0.0015f, -1, 6);
        const int felt = felts[static_cast<std::size_t>(i) % 4];
        if (i % 3 == 0) {  // a star
            Mesh m = shapes::prism(star(0.062f, 0.03f), -0.012f, 0.012f, 0.005f);
            shapes::turn(m, {1, 0, 0}, 90);
            shapes::turn(m, {0, 1, 0}, 40.f * static_cast<float>(i));
            k.add(std::move(m), felt, at - Vec3f{0, 0.05f, 0});
        } else if (i % 3 == 1) {  // a cloud
            for (const Vec3f& p : {Vec3f{-0.042f, 0, 0.03f}, {0, 0.014f, 0.043f}, {0.044f, 0, 0.032f}})
                k.add(shapes::ball(at + Vec3f{p.x, p.y - 0.045f, 0}, {p.z, 0.85f * p.z, 0.6f * p.z}, 14), felt);
        } else {  // a ball
            k.add(shapes::ball(at - Vec3f{0, 0.045f, 0}, {0.045f, 0.045f, 0.045f}, 18), felt);
        }
    }
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
