// Cloth over a mattress.
#include "fastscene/rooms/furniture/beds/bedding.h"

#include <algorithm>
#include <cmath>

namespace fastscene::furniture {

DrapedCloth over_mattress(const Bedding& b, float from_z, float to_z, Covers covers, std::uint32_t seed) {
    constexpr float kBillow_m = 0.03f;  // of its folds beyond the mattress
    // The frame stands out below the mattress; what lies on it already makes it higher and wider.
    const Vec3f half{0.5f * b.mattress.x + b.frame_m + covers.beside_m, 0.5f * (b.mattress.y + covers.lift_m),
                     0.5f * b.mattress.z + b.frame_m};
    std::vector<DrapeSolid> solids{{{0, half.y, 0}, half, kMattressEdge_m}};
    solids.insert(solids.end(), b.more.begin(), b.more.end());
    Cloth cloth;
    const float reach = half.x + covers.drop_m, over = covers.thick_m + kBillow_m;
    cloth.low = {-reach, from_z}, cloth.high = {reach, to_z};
    cloth.most = {half.x + over, half.z + over};
    cloth.from_y = 2 * half.y + covers.thick_m + 0.01f;
    cloth.slack = covers.slack;
    cloth.stiffness = covers.stiffness;
    cloth.clear_m = covers.thick_m;
    cloth.seed = seed;
    return drape(cloth, solids);
}

void lay_over(const Bedding& b, const DrapedCloth& below, float from_z, float to_z, Covers& covers) {
    float high = 0, wide = 0;
    for (const Vec3f p : below.points)
        if (p.z >= from_z && p.z <= to_z) high = std::max(high, p.y), wide = std::max(wide, std::fabs(p.x));
    covers.lift_m = std::max(0.f, high - b.mattress.y);
    covers.beside_m = std::max(0.f, wide - 0.5f * b.mattress.x - b.frame_m);
}

}  // namespace fastscene::furniture
