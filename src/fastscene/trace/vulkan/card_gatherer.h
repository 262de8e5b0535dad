// Gathering on a graphics card: the irradiance cache's tables there, and the kernels that fill it.
#pragma once

#include "fastscene/trace/gatherer.h"
#include "fastscene/trace/vulkan/tracer.h"

namespace fastscene::vulkan {

class CardGatherer : public Gatherer {
  public:
    explicit CardGatherer(Tracer& tracer) : tracer_(tracer) {}
    void update(const IrradianceCache::Tables& cache, Changed what) override;
    std::vector<CellLight> by_sun(std::uint64_t seed, std::uint64_t pass, const Run& run) override;
    std::vector<CellLight> direct(int rays, int least, std::uint64_t seed, std::uint64_t pass, const Run& run) override;
    std::vector<CellLight> bounced(int rays, int least, std::uint64_t seed, std::uint64_t pass,
                                   const Run& run) override;
    std::vector<std::uint8_t> visibility(const Run& run) override;
    std::vector<std::uint8_t> seen_from(const std::vector<Vec3f>& points, const Run& run) override;

  private:
    struct Push;
    std::vector<Vec4> run_kernel(LazyKernel& kernel, std::uint64_t points, int rays, int least, std::uint64_t seed,
                                 std::uint64_t pass, const Run& run);
    std::vector<CellLight> lights_of(LazyKernel& kernel, int rays, int least, std::uint64_t seed, std::uint64_t pass,
                                     const Run& run);

    Tracer& tracer_;
    std::int64_t count_ = 0;
    std::vector<std::uint32_t> first_sample_;
    gpu::Buffer entries_, points_, found_;  // of gathering alone
};

}  // namespace fastscene::vulkan
