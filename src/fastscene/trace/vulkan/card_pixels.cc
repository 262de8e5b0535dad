#include "fastscene/trace/vulkan/card_pixels.h"

#include <algorithm>
#include <numeric>

#include "fastscene/base/parallel.h"

namespace fastscene::vulkan {
namespace {

// Pixels that are worked on at once: 170 MiB of sums.
constexpr std::int64_t kBandPixels = 1 << 19;

// A pixel's sums as kernels keep them (pixels.glsl).
struct CardSurface {
    Vec4 color_count, radiance_texture, diffuse_texture2, specular_light2, position_sun2, normal_mirrored2;
    std::array<Vec4, 3> lights;
};
struct CardSum {
    Vec4 rest_taken, albedo_shown, shown2;
    std::array<CardSurface, 2> surfaces;
};
static_assert(sizeof(CardSum) == 21 * sizeof(Vec4));

Vec3f rgb(Vec4 v) { return {v.x, v.y, v.z}; }

SurfaceSum surface_sum(const CardSurface& s) {
    SurfaceSum out;
    const float count = s.color_count.w;
    out.count = static_cast<int>(count);
    out.color = rgb(s.color_count), out.radiance = rgb(s.radiance_texture), out.diffuse = rgb(s.diffuse_texture2);
    out.specular = rgb(s.specular_light2), out.position = rgb(s.position_sun2), out.normal = rgb(s.normal_mirrored2);
    const std::array<float, 3> squares{s.specular_light2.w, s.position_sun2.w, s.normal_mirrored2.w};
    for (std::size_t k = 0; k < 3; ++k) out.lights[k] = {rgb(s.lights[k]), MeanError(count, s.lights[k].w, squares[k])};
    out.texture = MeanError(count, s.radiance_texture.w, s.diffuse_texture2.w);
    return out;
}
PixelSum pixel_sum(const CardSum& s) {
    PixelSum out;
    out.taken = static_cast<int>(s.rest_taken.w);
    out.own = surface_sum(s.surfaces[0]), out.second = surface_sum(s.surfaces[1]);
    out.rest_color = rgb(s.rest_taken), out.all_albedo = rgb(s.albedo_shown);
    out.shown = MeanError(s.rest_taken.w, s.albedo_shown.w, s.shown2.x);
    return out;
}

// At least as large as asked for; larger ones are kept.
void reserve(gpu::Device& device, gpu::Buffer& buffer, std::int64_t bytes) {
    if (buffer && buffer.bytes() >= bytes) return;
    buffer = {};
    buffer = gpu::Buffer(device, bytes, gpu::Memory::device, "a picture");
}
template <class T>
void put(gpu::Device& device, gpu::Buffer& buffer, const std::vector<T>& from) {
    const auto bytes = static_cast<std::int64_t>(from.size() * sizeof(T));
    reserve(device, buffer, bytes);
    gpu::upload(device, buffer, 0, from.data(), bytes);
}
template <class T>
std::vector<T> take(gpu::Device& device, const gpu::Buffer& buffer, std::size_t count) {
    std::vector<T> out(count);
    gpu::download(device, buffer, 0, out.data(), static_cast<std::int64_t>(count * sizeof(T)));
    return out;
}

std::uint32_t packed(int x, int y) { return static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16; }

}  // namespace

// Consecutive pixels, row by row.
struct CardPixels::Band {
    std::vector<std::uint32_t> pixels;
    std::vector<std::size_t> rows;  // where each row begins, and the end
};

CardPixels::CardPixels(Tracer& tracer, const ShadeOptions& options, const PixelPlan& plan)
    : tracer_(tracer), options_(options), plan_(plan) {
    put(tracer_.device(), camera_, std::vector{camera_data(plan.camera, picture_key(plan.run.seed))});
}

void CardPixels::trace(const PixelRows& pixels, int least, const Done& done, Progress* progress) {
    Band band;
    std::int64_t rows = 0;
    const auto flush = [&] {
        band.rows.push_back(band.pixels.size());
        if (!band.pixels.empty()) trace_band(band, least, done);
        if (progress) progress->advance(rows);
        band = {}, rows = 0;
    };
    for (std::size_t y = 0; y < pixels.size(); ++y) {
        const std::size_t more = pixels[y].size();
        if (!band.pixels.empty() && band.pixels.size() + more > static_cast<std::size_t>(kBandPixels)) flush();
        band.rows.push_back(band.pixels.size());
        for (const int x : pixels[y]) band.pixels.push_back(packed(x, static_cast<int>(y)));
        ++rows;
    }
    flush();
}

void CardPixels::trace_band(const Band& band, int least, const Done& done) {
    struct Push {
        std::uint64_t world, camera, list, pixels, sums, more;
        std::uint32_t count, round, samples, least, options;
        float ray_angle, noise, min_alpha;
    };
    gpu::Device& device = tracer_.device();
    const std::size_t count = band.pixels.size();
    put(device, pixels_, band.pixels);
    reserve(device, sums_, static_cast<std::int64_t>(count * sizeof(CardSum)));
    reserve(device, more_, static_cast<std::int64_t>(count * 4));
    tracer_.clear(sums_);
    std::vector<std::uint32_t> list(count);
    std::iota(list.begin(), list.end(), 0u);
    const std::uint32_t options = (options_.contacts ? 1u : 0u) | (options_.frugal ? 2u : 0u) |
                                  (plan_.parts.denoise ? 4u : 0u) | (plan_.look ? 8u : 0u);
    while (!list.empty()) {
        put(device, list_, list);
        tracer_.run_in_pieces(tracer_.kernels().shade, static_cast<std::int64_t>(list.size()), plan_.run,
                              [&](std::int64_t first, std::uint32_t items) {
                                  return Push{tracer_.scene().world(),
                                              camera_.address(),
                                              list_.address() + 4 * static_cast<std::uint64_t>(first),
                                              pixels_.address(),
                                              sums_.address(),
                                              more_.address() + 4 * static_cast<std::uint64_t>(first),
                                              items,
                                              static_cast<std::uint32_t>(plan_.round),
                                              static_cast<std::uint32_t>(plan_.samples),
                                              static_cast<std::uint32_t>(least),
                                              options,
                                              plan_.ray_angle,
                                              plan_.parts.noise,
                                              options_.min_alpha};
                              });
        const auto more = take<std::uint32_t>(device, more_, list.size());
        std::size_t kept = 0;
        for (std::size_t i = 0; i < list.size(); ++i)
            if (more[i]) list[kept++] = list[i];
        list.resize(kept);
    }
    // A row is one thread's: what comes of its pixels goes to one list.
    const auto take_sums = [&](const void* piece, std::int64_t from_byte, std::int64_t bytes) {
        const auto* sums = static_cast<const CardSum*>(piece);
        const std::size_t first = static_cast<std::size_t>(from_byte) / sizeof(CardSum),
                          last = first + static_cast<std::size_t>(bytes) / sizeof(CardSum);
        parallel_for(static_cast<std::int64_t>(band.rows.size()) - 1, 4, [&](std::int64_t begin, std::int64_t end) {
            for (auto row = static_cast<std::size_t>(begin); row < static_cast<std::size_t>(end); ++row)
                for (std::size_t i = std::max(first, band.rows[row]); i < std::min(last, band.rows[row + 1]); ++i)
                    done(static_cast<int>(band.pixels[i] & 0xffff), static_cast<int>(band.pixels[i] >> 16),
                         pixel_sum(sums[i - first]));
        });
    };
    gpu::download_in_pieces(device, sums_, static_cast<std::int64_t>(count * sizeof(CardSum)), sizeof(CardSum),
                            take_sums);
}

PixelRows CardPixels::meeting_others(const PixelRows& pixels, int first, int end, const Guides& guides) {
    struct Push {
        std::uint64_t world, camera, pixels, surfaces, found;
        std::uint32_t count, first, end, unused;
    };
    std::vector<std::uint32_t> list;
    std::vector<Vec4> surfaces;
    for (std::size_t y = 0; y < pixels.size(); ++y)
        for (const int x : pixels[y]) {
            list.push_back(packed(x, static_cast<int>(y)));
            surfaces.push_back(vec4(guides.position.at(x, static_cast<int>(y))));
            surfaces.push_back(vec4(guides.normal.at(x, static_cast<int>(y))));
        }
    PixelRows out(pixels.size());
    if (list.empty()) return out;
    gpu::Device& device = tracer_.device();
    gpu::Buffer on_card;
    put(device, pixels_, list), put(device, on_card, surfaces);
    reserve(device, more_, static_cast<std::int64_t>(list.size() * 4));
    tracer_.run_in_pieces(tracer_.kernels().meets, static_cast<std::int64_t>(list.size()), plan_.run,
                          [&](std::int64_t at, std::uint32_t items) {
                              const auto skipped = static_cast<std::uint64_t>(at);
                              return Push{tracer_.scene().world(),
                                          camera_.address(),
                                          pixels_.address() + 4 * skipped,
                                          on_card.address() + 32 * skipped,
                                          more_.address() + 4 * skipped,
                                          items,
                                          static_cast<std::uint32_t>(first),
                                          static_cast<std::uint32_t>(end),
                                          0};
                          });
    const auto found = take<std::uint32_t>(device, more_, list.size());
    for (std::size_t i = 0; i < list.size(); ++i)
        if (found[i]) out[list[i] >> 16].push_back(static_cast<int>(list[i] & 0xffff));
    return out;
}

}  // namespace fastscene::vulkan
