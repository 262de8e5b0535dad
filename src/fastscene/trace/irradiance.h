// The irradiance cache: the diffuse light of a room, gathered once, read by every picture of it.
//
// Space is cut into cells of `cell_m`; each cell that a surface passes through has one entry for each of the six main
// directions that the surface may face there. An entry holds the irradiance (W/m2 in the room's own units) of that bit of
// surface: from lamps and windows directly, from everything else by repeated gathering. Sun is kept apart, because its
// edges are sharp: pictures trace it themselves and use the entry's only where light bounces.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

class IrradianceCache {
  public:
    // Walks the surfaces and gathers. Deterministic in run.seed.
    static IrradianceCache gather(const Room& room, const SceneBvh& bvh, const TraceParams& params, const Run& run);

    // Irradiance without sun at a point of a surface: interpolated between the entries around it. `normal` of length 1.
    Vec3f at(Vec3f position, Vec3f normal) const;
    // From the nearest entry only: for light that bounces or is mirrored.
    Vec3f near(Vec3f position, Vec3f normal, bool with_sun) const;
    std::size_t size() const { return cells_.size(); }

  private:
    struct Cell {
        Vec3f direct, indirect, sun, normal, center;
        Vec3f albedo;       // mean of what lies here
        float area = 0;     // of the surface in the cell
        float transmission = 0;
    };
    // A bit of surface that the sun lights, as a lamp for the rest of the room.
    struct SunPatch {
        Vec3f position, normal;
        Vec3f leaving;      // radiant exitance
        float area;
    };
    struct Sample {
        Vec3f position, normal;
    };
    int find(std::int32_t x, std::int32_t y, std::int32_t z, int facing) const;
    int nearest(Vec3f position, Vec3f normal) const;
    void build(const Room& room, const std::vector<Vec3f>& albedo);
    std::vector<SunPatch> sun_patches() const;
    std::vector<float> usefulness(const std::vector<SunPatch>& patches, const SceneBvh& bvh, std::uint64_t seed) const;
    void drop_unseen(const SceneBvh& bvh, const std::vector<bool>& closed);
    void index();
    void despeckle(bool indirect);
    std::vector<float> pooled(const std::vector<float>& error) const;
    void smooth(bool indirect, int step, std::vector<float>& error);

    float cell_m_ = 0.03f;
    Vec3f origin_;
    std::vector<Cell> cells_;
    std::vector<std::uint64_t> keys_;              // of cells_, ascending
    std::vector<std::uint32_t> first_sample_;      // into samples_, one more than cells
    std::vector<Sample> samples_;
    std::vector<std::uint32_t> slots_;             // open addressing: cell + 1, or 0
    std::uint32_t mask_ = 0;
};

// The direction among +-x, +-y, +-z that a normal is nearest to: 0..5.
int facing_of(Vec3f normal);

}  // namespace fastscene
