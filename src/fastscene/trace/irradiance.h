// The irradiance cache: the diffuse light of a room, gathered once, read by every picture of it.
//
// Space is cut into cells of `cell_m`; each cell that a surface passes through has one entry for each of the six main
// directions that the surface may face there. An entry holds the irradiance (W/m2 in the room's own units) of that bit
// of surface: from lamps and windows directly, from everything else by repeated gathering. Sun is kept apart, because
// its edges are sharp: pictures trace it themselves and use the entry's only where light bounces.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

class IrradianceCache {
  public:
    // Walks the surfaces and gathers. Deterministic in run.seed. `viewpoints`: where pictures will be taken from; what
    // nobody sees who steps about there gets fewer paths, since it is only known by what it lights.
    static IrradianceCache gather(const Room& room, const SceneBvh& bvh, const TraceParams& params, const Run& run,
                                  const std::vector<Vec3f>& viewpoints = {Vec3f{}});

    // Irradiance without sun at a point of a surface: interpolated between the entries around it. `normal` of length 1.
    Vec3f at(Vec3f position, Vec3f normal) const { return read(position, normal).irradiance; }
    // The same, and how well it stands for the very point: 1 on even surfaces in the open, 0 where things are near or
    // the surface has steps, so that light changes within a cell.
    struct Reading {
        Vec3f irradiance;
        Vec3f sun;  // the sun's own, as blurred as the cells are wide
        float trust = 0;
    };
    Reading read(Vec3f position, Vec3f normal) const;
    // From the nearest entry only: for light that bounces, many times over.
    struct Near {
        Vec3f light, sun;  // irradiance without the sun's own, and the sun's
    };
    Near near(Vec3f position, Vec3f normal) const;
    std::size_t size() const { return cells_.size(); }

    // A bit of surface.
    struct Place {
        Vec3f position, normal;
    };
    // One estimate of a place's irradiance, in two parts that add up to what entries hold the mean of. First what is
    // asked for: lamps, windows and the first bounce of the sun (`which`, `uv`: uniform in [0, 1), best well spread).
    Vec3f direct(const Room& room, const SceneBvh& bvh, const Lights& lights, const Place& at, float which,
                 Vec2f uv) const;
    // Then what is found in one direction, by the light that the cache knows there.
    struct Bounce {
        Vec3f irradiance;
        float distance = kFar;
        bool buried = false;  // the inside of something solid
    };
    Bounce bounced(const Room& room, const SceneBvh& bvh, const Lights& lights, const Place& at, Vec2f uv) const;

  private:
    struct Cell {
        Vec3f direct, indirect, sun, normal, center;
        Vec3f albedo;    // mean of what lies here
        float area = 0;  // of the surface in the cell
        float transmission = 0;
        float trust = 0;
        bool seen = true;  // by somebody who steps about the viewpoints
    };
    // A cell that the sun lights, as a lamp for the rest of the room. It shines from the very places that lie in the
    // sun: a cell's center may lie behind an edge, or in the shade.
    struct SunPatch {
        std::uint32_t first, count;  // of sun_places_
        Vec3f sun;                   // irradiance
        Vec3f leaving;               // radiant exitance
        float area;
        float useful;  // the share of the room that sees it
        bool behind;   // the far side of a sheet
    };
    struct SunPlace {
        Place at;
        std::size_t material;
    };
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t cell = 0;  // + 1; 0: free
    };
    int find(std::int32_t x, std::int32_t y, std::int32_t z, int facing) const;
    int nearest(Vec3f position, Vec3f normal) const;
    const Place& place(std::size_t cell, int i) const;
    std::uint64_t random_key(std::size_t cell, std::uint64_t pass, std::uint64_t seed) const;
    void build(const Room& room);
    std::vector<std::uint8_t> visibility(const SceneBvh& bvh) const;
    void drop_hidden(const SceneBvh& bvh);
    void find_seen(const SceneBvh& bvh, const std::vector<Vec3f>& viewpoints);
    void index();
    void despeckle(bool indirect);
    std::vector<float> pooled(const std::vector<float>& error) const;
    void smooth(bool indirect, int step, std::vector<float>& error);
    void distrust_edges();

    // The steps of gather(), in order.
    std::vector<std::uint16_t> light_by_sun(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                            std::uint64_t seed);
    void find_sun_patches(const Room& room, const SceneBvh& bvh, const std::vector<std::uint16_t>& sunny,
                          std::uint64_t seed);
    void gather_direct(const Room& room, const SceneBvh& bvh, const Lights& lights, int samples, const Run& run,
                       Progress& progress);
    struct Pass;
    void gather_pass(const Room& room, const SceneBvh& bvh, const Lights& lights, const Run& run, Progress& progress,
                     Pass& pass);
    void gather_indirect(const Room& room, const SceneBvh& bvh, const Lights& lights, int samples, const Run& run,
                         Progress& progress);
    Vec3f reflected(const Room& room, std::size_t material, Vec3f normal, Vec3f direction, bool behind) const;
    Vec3f sunlit(const Room& room, const SceneBvh& bvh, const Place& at, float which) const;

    float cell_m_ = 0.03f;
    Vec3f origin_;
    std::vector<Vec3f> reflectances_;  // by material: of light on its second way
    std::vector<Coat> coats_;          // by material: what of them mirrors the sun
    std::vector<bool> closed_;         // by mesh
    std::vector<Cell> cells_;
    std::vector<std::uint64_t> keys_;          // of cells_, ascending
    std::vector<std::uint32_t> first_sample_;  // into samples_, one more than cells
    std::vector<Place> samples_;
    std::vector<Slot> slots_;  // open addressing
    std::uint32_t mask_ = 0;
    std::vector<SunPatch> sun_patches_;
    std::vector<SunPlace> sun_places_;
    std::vector<float> sun_powers_;  // cumulative, by patch
};

// The direction among +-x, +-y, +-z that a normal is nearest to: 0..5.
int facing_of(Vec3f normal);

}  // namespace fastscene
