// Mirror.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_mirror(Kit& k) {
    Vec3f s = k.wanted({0.7f, 0.9f, 0.03f});
    if (k.request.pattern == "round") s.x = s.y = std::min(s.x, s.y);
    if (k.request.pattern == "arched") s.y = std::max(s.y, 1.35f * s.x);
    const bool rounded = is_one_of(k.request.pattern, {"round", "oval"}) || k.style.lamp == LampFamily::globe ||
                         k.style.lamp == LampFamily::paper;
    const int frame = k.main(k.style.mouldings == Mouldings::rich || k.style.metal.metal > 0.5f ? k.style.metal
                                                                                                : k.style.wood);
    Material m = plain("mirror", {0.85f, 0.85f, 0.85f}, 0.05f);
    m.mirror = 1.f;
    const int silver = k.material(m);
    const float f = k.style.mouldings == Mouldings::rich ? 0.06f : 0.025f;
    auto o = shapes::rounded_rectangle(s.x - f, s.y - f, rounded ? 0.5f * (std::min(s.x, s.y) - f) - 1e-4f : 0.8f * f,
                                       10);
    if (k.request.pattern == "arched") {  // a half circle on upright sides
        const float half = 0.5f * (s.x - f), foot = -0.5f * (s.y - f), spring = 0.5f * (s.y - f) - half;
        o = {{-half, foot}, {half, foot}};
        for (int i = 0; i <= 24; ++i)
            o.push_back(Vec2f{half * std::cos(kPi * static_cast<float>(i) / 24.f),
                              spring + half * std::sin(kPi * static_cast<float>(i) / 24.f)});
    }
    auto below = o;  // turned up, z runs down
    for (Vec2f& p : below) p.y = -p.y;
    Mesh pane = shapes::prism(below, 0.004f, 0.012f, 0.002f);
    shapes::turn(pane, {1, 0, 0}, 90);
    k.add(std::move(pane), silver, {0, 0.5f * s.y, 0});
    std::vector<Vec3f> path;
    for (const Vec2f p : o) path.push_back({p.x, 0.5f * s.y + p.y, 0.014f});
    path.push_back(path.front());
    k.add(shapes::tube(path, 0.5f * f, 10), frame);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.1f;
}

}  // namespace fastscene::furniture
