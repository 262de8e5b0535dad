// The parts of gathering that another processor can take over: those that trace rays. All of them give the sums that
// IrradianceCache's own loops give, with the same random numbers, up to rounding.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/trace/irradiance.h"

namespace fastscene {

class Gatherer {
  public:
    virtual ~Gatherer() = default;

    // Told before the calls below whenever a part of the cache has changed.
    enum class Changed {
        places,  // which cells there are, and their sample points
        light,   // the cells themselves: light, normals, centers
        index,   // keys and slots
        sun,     // sun patches
    };
    virtual void update(const IrradianceCache::Tables& cache, Changed what) = 0;

    // What was found for a cell. Not every call fills all of it.
    struct CellLight {
        Vec3f irradiance;
        float error = 0;  // standard
        LightDirection directed;
        float nearness = 0;         // mean inverse distance, 1/m
        std::uint32_t reached = 0;  // a bit a sample point
    };
    // `seed`, `pass`: of the random numbers (IrradianceCache::random_key).
    virtual std::vector<CellLight> by_sun(std::uint64_t seed, std::uint64_t pass, const Run& run) = 0;
    virtual std::vector<CellLight> direct(int rays, int least, std::uint64_t seed, std::uint64_t pass,
                                          const Run& run) = 0;
    virtual std::vector<CellLight> bounced(int rays, int least, std::uint64_t seed, std::uint64_t pass,
                                           const Run& run) = 0;
    // As IrradianceCache::visibility: by sample point.
    virtual std::vector<std::uint8_t> visibility(const Run& run) = 0;
    // By cell: whether it is seen from one of the points (IrradianceCache::find_seen).
    virtual std::vector<std::uint8_t> seen_from(const std::vector<Vec3f>& points, const Run& run) = 0;
};

}  // namespace fastscene
