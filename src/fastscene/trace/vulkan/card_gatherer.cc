#include "fastscene/trace/vulkan/card_gatherer.h"

#include <bit>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/texture.h"

namespace fastscene::vulkan {

struct CardGatherer::Push {
    std::uint64_t world, entries, points, found, seed, pass;
    std::uint32_t count, first, rays, least;
};

void CardGatherer::update(const IrradianceCache::Tables& cache, Changed what) {
    gpu::Device& device = tracer_.device();
    CardScene& scene = tracer_.scene();
    const std::size_t count = cache.cells.size();
    const auto bits = [](std::uint32_t word) { return std::bit_cast<float>(word); };
    switch (what) {
        case Changed::places: {
            std::vector<Uvec4> entries(count);
            for (std::size_t c = 0; c < count; ++c) {
                const std::uint32_t first = cache.first_sample[c], points = cache.first_sample[c + 1] - first;
                entries[c] = {static_cast<std::uint32_t>(cache.keys[c]),
                              static_cast<std::uint32_t>(cache.keys[c] >> 32), first,
                              points | (cache.cells[c].seen ? 1u << 31 : 0u)};
            }
            std::vector<Vec4> points(2 * cache.samples.size());
            for (std::size_t i = 0; i < cache.samples.size(); ++i)
                points[2 * i] = vec4(cache.samples[i].position), points[2 * i + 1] = vec4(cache.samples[i].normal);
            const auto keep = [&](gpu::Buffer& buffer, const auto& from) {
                const auto bytes = static_cast<std::int64_t>(from.size() * sizeof from[0]);
                if (buffer.bytes() < bytes) {
                    buffer = {};
                    buffer = gpu::Buffer(device, bytes, gpu::Memory::device, "the light of a room");
                }
                gpu::upload(device, buffer, 0, from.data(), bytes);
            };
            keep(entries_, entries), keep(points_, points);
            count_ = static_cast<std::int64_t>(count), first_sample_ = cache.first_sample;
            const std::int64_t bytes = std::max<std::int64_t>(1, count_) * 3 * static_cast<std::int64_t>(sizeof(Vec4));
            if (found_.bytes() < bytes) {
                found_ = {};
                found_ = gpu::Buffer(device, bytes, gpu::Memory::device, "the light of a room");
            }
            scene.tables().cache = vec4(cache.origin, cache.cell_m);
            scene.write();
            return;
        }
        case Changed::light: {
            std::vector<Vec4> cells(4 * count);
            parallel_for(static_cast<std::int64_t>(count), 4096, [&](std::int64_t begin, std::int64_t end) {
                for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
                    const IrradianceCache::Cell& cell = cache.cells[c];
                    const Vec3f light = cell.direct + cell.indirect, s = cell.sun, n = cell.normal, m = cell.center;
                    cells[4 * c] = vec4(light, s.x), cells[4 * c + 1] = {s.y, s.z, n.x, n.y};
                    cells[4 * c + 2] = {n.z, m.x, m.y, m.z};
                    cells[4 * c + 3] = vec4(cell.directed.gradient(), cell.trust);
                }
            });
            scene.set_cache(CardScene::kCells, cells);
            if (cache.first_sample.empty() || cache.samples.empty()) entries_ = {}, points_ = {}, found_ = {};
            return;
        }
        case Changed::index: {
            std::vector<Uvec4> slots;
            slots.reserve(cache.slots.size());
            for (const IrradianceCache::Slot& s : cache.slots)
                slots.push_back(
                    {static_cast<std::uint32_t>(s.key), static_cast<std::uint32_t>(s.key >> 32), s.cell, 0});
            scene.tables().slot_mask = static_cast<std::uint32_t>(cache.slots.size() - 1);
            scene.set_cache(CardScene::kSlots, slots);
            std::vector<Vec4> coats;
            for (std::size_t m = 0; m < cache.coats.size(); ++m) {
                const Coat& c = cache.coats[m];
                const Material& material = tracer_.material(m);
                coats.push_back(vec4(cache.reflectances[m], material.transmission));
                coats.push_back(vec4(c.across, c.sharp)), coats.push_back(vec4(c.grazing, c.alpha));
                coats.push_back(vec4(mean_emission(material)));
            }
            scene.set_cache(CardScene::kCoats, coats);
            return;
        }
        case Changed::sun: {
            std::vector<Vec4> patches, places;
            for (const IrradianceCache::SunPatch& p : cache.sun_patches) {
                patches.push_back(vec4(p.sun, p.area));
                patches.push_back(
                    {bits(p.first), bits(p.count), luminance(p.leaving) * p.area * p.useful, bits(p.behind ? 1u : 0u)});
            }
            for (const IrradianceCache::SunPlace& p : cache.sun_places) {
                places.push_back(vec4(p.at.position, bits(static_cast<std::uint32_t>(p.material))));
                places.push_back(vec4(p.at.normal));
            }
            scene.tables().patches = static_cast<std::uint32_t>(cache.sun_patches.size());
            scene.set_cache(CardScene::kSunPatches, patches), scene.set_cache(CardScene::kSunPlaces, places);
            scene.set_cache(CardScene::kSunPowers, cache.sun_powers);
            return;
        }
    }
}

std::vector<Vec4> CardGatherer::run_kernel(LazyKernel& kernel, std::uint64_t points, int rays, int least,
                                           std::uint64_t seed, std::uint64_t pass, const Run& run) {
    tracer_.run_in_pieces(kernel, count_, run, [&](std::int64_t first, std::uint32_t items) {
        return Push{tracer_.scene().world(),
                    entries_.address(),
                    points,
                    found_.address(),
                    seed,
                    mix64(pass),
                    items,
                    static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(rays),
                    static_cast<std::uint32_t>(least)};
    });
    std::vector<Vec4> found(3 * static_cast<std::size_t>(count_));
    gpu::download(tracer_.device(), found_, 0, found.data(), static_cast<std::int64_t>(found.size() * sizeof(Vec4)));
    return found;
}

std::vector<Gatherer::CellLight> CardGatherer::lights_of(LazyKernel& kernel, int rays, int least, std::uint64_t seed,
                                                         std::uint64_t pass, const Run& run) {
    const std::vector<Vec4> found = run_kernel(kernel, points_.address(), rays, least, seed, pass, run);
    std::vector<CellLight> out(static_cast<std::size_t>(count_));
    for (std::size_t c = 0; c < out.size(); ++c) {
        const Vec4 a = found[3 * c], b = found[3 * c + 1], d = found[3 * c + 2];
        out[c] = {{a.x, a.y, a.z}, a.w, {{b.x, b.y, b.z}, b.w}, d.x, std::bit_cast<std::uint32_t>(d.y)};
    }
    return out;
}

std::vector<Gatherer::CellLight> CardGatherer::by_sun(std::uint64_t seed, std::uint64_t pass, const Run& run) {
    return lights_of(tracer_.kernels().gather_sun, irradiance::kSunSamples, irradiance::kSunSamples, seed, pass, run);
}
std::vector<Gatherer::CellLight> CardGatherer::direct(int rays, int least, std::uint64_t seed, std::uint64_t pass,
                                                      const Run& run) {
    return lights_of(tracer_.kernels().gather_direct, rays, least, seed, pass, run);
}
std::vector<Gatherer::CellLight> CardGatherer::bounced(int rays, int least, std::uint64_t seed, std::uint64_t pass,
                                                       const Run& run) {
    return lights_of(tracer_.kernels().gather_bounce, rays, least, seed, pass, run);
}

std::vector<std::uint8_t> CardGatherer::visibility(const Run& run) {
    const std::vector<Vec4> found = run_kernel(tracer_.kernels().gather_sight, points_.address(), 0, 0, 0, 0, run);
    std::vector<std::uint8_t> out(first_sample_.back());
    for (std::size_t c = 0; c < static_cast<std::size_t>(count_); ++c) {
        const std::uint64_t all = std::bit_cast<std::uint32_t>(found[3 * c].x) |
                                  std::uint64_t{std::bit_cast<std::uint32_t>(found[3 * c].y)} << 32;
        for (std::uint32_t s = first_sample_[c]; s < first_sample_[c + 1]; ++s)
            out[s] = static_cast<std::uint8_t>(all >> (4 * (s - first_sample_[c])) & 15);
    }
    return out;
}

std::vector<std::uint8_t> CardGatherer::seen_from(const std::vector<Vec3f>& points, const Run& run) {
    std::vector<Vec4> given;
    for (const Vec3f p : points) given.push_back(vec4(p));
    gpu::Buffer list(tracer_.device(), static_cast<std::int64_t>(given.size() * sizeof(Vec4)), gpu::Memory::device,
                     "viewpoints");
    gpu::upload(tracer_.device(), list, 0, given.data(), static_cast<std::int64_t>(given.size() * sizeof(Vec4)));
    const std::vector<Vec4> found = run_kernel(tracer_.kernels().gather_seen, list.address(),
                                               static_cast<int>(points.size()), 0, 0, 0, run);
    std::vector<std::uint8_t> out(static_cast<std::size_t>(count_));
    for (std::size_t c = 0; c < out.size(); ++c) out[c] = std::bit_cast<std::uint32_t>(found[3 * c].x) != 0;
    return out;
}

}  // namespace fastscene::vulkan
