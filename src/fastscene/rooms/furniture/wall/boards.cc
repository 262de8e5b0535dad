// What boards on walls share: the frame, and lines drawn by hand.
#include "fastscene/rooms/furniture/wall/boards.h"

#include <cmath>

namespace fastscene::furniture {

void wall_frame(Kit& k, int material, Vec3f s, float wide, float deep) {
    for (const float sg : {-1.f, 1.f}) {
        k.board(material, {sg * 0.5f * (s.x - wide), 0, 0.5f * deep}, {wide, s.y, deep}, 0.003f);
        k.board(material, {0, sg > 0 ? s.y - wide : 0.f, 0.5f * deep}, {s.x - 2 * wide, wide, deep}, 0.003f);
    }
}

Stroke bow(Vec2f middle, Vec2f radii, float from_deg, float to_deg, int steps) {
    Stroke s;
    for (int i = 0; i <= steps; ++i) {
        const float a = (from_deg + (to_deg - from_deg) * static_cast<float>(i) / static_cast<float>(steps)) * kPi /
                        180.f;
        s.push_back(middle + Vec2f{radii.x * std::cos(a), radii.y * std::sin(a)});
    }
    return s;
}

}  // namespace fastscene::furniture
