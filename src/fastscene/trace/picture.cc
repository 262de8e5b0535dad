#include "fastscene/trace/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/eyes.h"
#include "fastscene/geometry/grown.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/trace/denoise.h"
#include "fastscene/trace/film.h"
#include "fastscene/trace/pixel_tracer.h"

namespace fastscene {
namespace {

// The second surface of a pixel, until its neighbours' light is known.
struct SecondSurface {
    int x = 0;
    float share = 0;
    Vec3f color, radiance, position, normal, through, light;  // light: diffuse
};

// Per-pixel data kept for the denoiser.
struct NoisyPicture {
    ImageColor radiance, diffuse, specular, rest_color;
    ImageF own_share;
    std::array<NoisyLight, 3> lights;
    Guides guides;
    std::vector<std::vector<SecondSurface>> seconds;  // by row

    explicit NoisyPicture(const RayCamera& camera)
        : own_share(camera.width, camera.height), seconds(static_cast<std::size_t>(camera.height)) {
        const ImageColor black(camera.width, camera.height);
        radiance = diffuse = specular = rest_color = guides.position = guides.normal = black;
        for (NoisyLight& light : lights) light = {black, ImageF(camera.width, camera.height)};
        guides.rays = own_share;
        guides.wraps = camera.panorama;
    }
    void set(int x, int y, const PixelSum& p) {
        const float of_own = 1 / static_cast<float>(p.own.count);
        radiance.at(x, y) = p.own.radiance * of_own;
        diffuse.at(x, y) = p.own.through(0);
        specular.at(x, y) = p.own.through(2);
        own_share.at(x, y) = p.own_share();
        rest_color.at(x, y) = p.rest_part();
        for (std::size_t k = 0; k < lights.size(); ++k) {
            lights[k].value.at(x, y) = p.own.light(k);
            lights[k].variance.at(x, y) = p.own.lights[k].arriving.variance();
        }
        guides.position.at(x, y) = p.own.position;
        guides.normal.at(x, y) = p.own.normal;
        guides.rays.at(x, y) = static_cast<float>(p.own.count);
        if (p.second.count == 0) return;
        const SurfaceSum& other = p.second;
        const float of_other = 1 / static_cast<float>(other.count);
        seconds[static_cast<std::size_t>(y)].push_back({x, p.second_share(), other.color * of_other,
                                                        other.radiance * of_other, other.position, other.normal,
                                                        other.through(0), other.light(0)});
    }

    // Replaces a pixel that had no second surface.
    void set_again(int x, int y, const PixelSum& p) {
        set(x, y, p);
        auto& row = seconds[static_cast<std::size_t>(y)];
        std::sort(row.begin(), row.end(), [](const SecondSurface& a, const SecondSurface& b) { return a.x < b.x; });
    }

    // All rays of the pixel hit the same surface.
    bool is_whole(int x, int y) const { return own_share.at(x, y) == 1.f; }
    // Whether a pixel, or one of the eight around it, passes test(x, y).
    template <class Test>
    bool any_beside(int x, int y, const Test& test) const {
        for (int k = 0; k < 9; ++k) {
            const int dx = k % 3 - 1, qy = std::clamp(y + k / 3 - 1, 0, own_share.height - 1);
            if (test(guides.wraps ? wrap_column(x + dx, own_share.width) : std::clamp(x + dx, 0, own_share.width - 1),
                     qy))
                return true;
        }
        return false;
    }

    // Pixels of a row at the edge of the sun's shadow according to a neighbour, although their own first `rays` rays
    // (all so far) agree.
    std::vector<int> beside_shadow_edges(int y, int rays) const {
        const NoisyLight& sun = lights[1];
        const auto at_edge = [&](int x, int row) {
            const float bright = luminance(sun.value.at(x, row));
            return sun.variance.at(x, row) > kNoisy * kNoisy * bright * bright;
        };
        std::vector<int> found;
        for (int x = 0; x < own_share.width; ++x) {
            const Vec3f normal = guides.normal.at(x, y);
            if (!is_whole(x, y) || guides.rays.at(x, y) > static_cast<float>(rays) || !(dot(normal, normal) > 0.5f))
                continue;
            if (any_beside(x, y, at_edge)) found.push_back(x);
        }
        return found;
    }

    // Pixels of a row at a texture edge according to a neighbour with another color on the same surface, although their
    // own first `rays` rays (all so far) agree.
    std::vector<int> beside_pattern_edges(int y, int rays) const {
        constexpr float kContrast = 0.08f;  // in sRGB values
        const auto color_at = [&](int x, int row) {
            return srgb_from_linear(luminance(diffuse.at(x, row) + specular.at(x, row)));
        };
        std::vector<int> found;
        for (int x = 0; x < own_share.width; ++x) {
            const Vec3f position = guides.position.at(x, y), normal = guides.normal.at(x, y);
            if (!is_whole(x, y) || guides.rays.at(x, y) > static_cast<float>(rays) || !(dot(normal, normal) > 0.5f))
                continue;
            const float own = color_at(x, y);
            const auto differs = [&](int qx, int qy) {
                return std::abs(color_at(qx, qy) - own) > kContrast &&
                       !another_surface(position, normal, guides.position.at(qx, qy), guides.normal.at(qx, qy));
            };
            if (any_beside(x, y, differs)) found.push_back(x);
        }
        return found;
    }

    // Pixels of a row whose first `rays` rays (all so far) hit a single surface, while a neighbour sees several or
    // (`others`) a different one.
    std::vector<int> beside_outlines(int y, int rays, bool others) const {
        std::vector<int> found;
        for (int x = 0; x < own_share.width; ++x) {
            if (!is_whole(x, y) || guides.rays.at(x, y) > static_cast<float>(rays)) continue;
            const Vec3f position = guides.position.at(x, y), normal = guides.normal.at(x, y);
            const auto outline = [&](int qx, int qy) {
                return !is_whole(qx, qy) || (others && another_surface(position, normal, guides.position.at(qx, qy),
                                                                       guides.normal.at(qx, qy)));
            };
            if (any_beside(x, y, outline)) found.push_back(x);
        }
        return found;
    }

    // The diffuse light of a second surface, taken from neighbouring pixels that show it, if any: the few rays of one
    // pixel are too noisy.
    std::optional<Vec3f> light_around(const SecondSurface& s, int y) const {
        constexpr int reach = 2;
        Vec3f sum{};
        float weights = 0;
        for (int qy = std::max(0, y - reach); qy <= std::min(own_share.height - 1, y + reach); ++qy)
            for (int dx = -reach; dx <= reach; ++dx) {
                int qx = s.x + dx;
                if (guides.wraps) qx = wrap_column(qx, own_share.width);
                else if (qx < 0 || qx >= own_share.width) continue;
                const float w = same_surface(guides, qx, qy, s.position, s.normal) /
                                static_cast<float>(1 + dx * dx + (qy - y) * (qy - y));
                sum += lights[0].value.at(qx, qy) * w;
                weights += w;
            }
        return weights > 0.05f ? std::optional(sum / weights) : std::nullopt;
    }

    // Multiplies each denoised light by the pixel's own color, so textures stay as sampled; other surfaces at outlines
    // are added unfiltered.
    void denoise_into(ImageColor& color, const Look* look, bool reflections_only) {
        constexpr std::array<int, 3> kLevels{4, 2, 3};
        ImageColor change(color.width, color.height);
        for (std::size_t k = reflections_only ? 2 : 0; k < lights.size(); ++k) {
            const ImageColor before = lights[k].value;
            denoise(lights[k], guides, kLevels[k]);
            const ImageColor& through = k < 2 ? diffuse : specular;
            for (std::size_t i = 0; i < before.size(); ++i)
                change.pixels[i] += through.pixels[i] * (lights[k].value.pixels[i] - before.pixels[i]);
            if (k > 0) lights[k] = {};  // the diffuse light is needed again below
        }
        const auto seen = [look](Vec3f light) {
            for (std::size_t a = 0; a < 3; ++a) light[a] = std::max(0.f, light[a]);
            return look ? develop(*look, light) : light;
        };
        parallel_for(color.height, 16, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y) {
                auto second = seconds[static_cast<std::size_t>(y)].begin();
                for (int x = 0; x < color.width; ++x) {
                    const SecondSurface* other = second != seconds[static_cast<std::size_t>(y)].end() && second->x == x
                                                     ? &*second++
                                                     : nullptr;
                    if (!other && change.at(x, y) == Vec3f{}) continue;
                    color.at(x, y) = rest_color.at(x, y) +
                                     seen(radiance.at(x, y) + change.at(x, y)) * own_share.at(x, y);
                    if (!other) continue;
                    const auto around = reflections_only ? std::nullopt : light_around(*other, y);
                    color.at(x, y) += (around ? seen(other->radiance + other->through * (*around - other->light))
                                              : other->color) *
                                      other->share;
                }
            }
        });
    }
};

}  // namespace

RayCamera panorama_camera(const Rigid& world_from_pano, EquirectSize size, float eye_m) {
    RayCamera camera{world_from_pano,
                     size.width,
                     size.height,
                     [size](Vec2f p) { return direction_at(p, size); },
                     kPi / static_cast<float>(size.height),
                     true};
    camera.eye_m = eye_m;
    if (eye_m != 0) camera.offset = [size, eye_m](Vec2f pixel) { return eye_offset(pixel, size, eye_m); };
    return camera;
}
RayCamera perspective_camera(const Rigid& world_from_camera, const Pinhole& camera) {
    RayCamera out{world_from_camera, camera.width, camera.height, [camera](Vec2f p) { return camera.direction_at(p); },
                  1.f / camera.fx};
    out.pinhole = camera;
    return out;
}
Vec3f world_direction(const RayCamera& camera, Vec2f pixel) {
    return normalize(camera.world_from_camera.rotation * camera.direction(pixel));
}
Vec3f world_origin(const RayCamera& camera, Vec2f pixel) {
    return camera.offset ? camera.world_from_camera * camera.offset(pixel) : camera.world_from_camera.translation;
}

namespace {

std::uint64_t key_of_pixel(const Run& run, int x, int y) {
    return picture_key(run.seed) ^ (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
}
Vec2f point_in(int x, int y, Sampler& sampler) {
    const Vec2f offset = sampler.next2();
    return {static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y};
}

// With Embree.
class ProcessorPixels : public PixelTracer {
  public:
    ProcessorPixels(const ShadeScene& scene, const PixelPlan& plan) : scene_(scene), plan_(plan) {}

    void trace(const PixelRows& pixels, int least, const Done& done, Progress* progress) override {
        parallel_for(static_cast<std::int64_t>(pixels.size()), 4, [&](std::int64_t begin, std::int64_t end) {
            plan_.run.check_stop();
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (const int x : pixels[static_cast<std::size_t>(y)]) done(x, y, pixel(x, y, least));
            if (progress) progress->advance(end - begin);
        });
    }
    PixelRows meeting_others(const PixelRows& pixels, int first, int end, const Guides& guides) override {
        PixelRows out(pixels.size());
        parallel_for(static_cast<std::int64_t>(pixels.size()), 4, [&](std::int64_t top, std::int64_t bottom) {
            plan_.run.check_stop();
            for (auto y = static_cast<int>(top); y < bottom; ++y)
                for (const int x : pixels[static_cast<std::size_t>(y)])
                    if (meets_another(x, y, first, end, guides)) out[static_cast<std::size_t>(y)].push_back(x);
        });
        return out;
    }

  private:
    PixelSum pixel(int x, int y, int least) const {
        const RayCamera& camera = plan_.camera;
        PixelSum sum;
        do {
            for (int s = 0; s < plan_.round; ++s) {
                Sampler sampler(key_of_pixel(plan_.run, x, y), static_cast<std::uint32_t>(sum.taken));
                const Vec2f point = point_in(x, y, sampler);
                const Shaded shaded = shade_ray(scene_, world_origin(camera, point), world_direction(camera, point),
                                                plan_.ray_angle, sampler);
                // Samples are tone mapped before averaging, so that edges against a bright window stay antialiased.
                sum.add(shaded, plan_.look ? develop(*plan_.look, shaded.radiance) : shaded.radiance);
            }
        } while (sum.taken < least || needs_more(sum, plan_.parts, plan_.samples));
        if (plan_.parts.denoise && sum.mixed()) cover(x, y, sum);
        return sum;
    }
    // Measures by rays that are not shaded how much of a pixel each of its surfaces covers.
    void cover(int x, int y, PixelSum& sum) const {
        constexpr int kCoverageRays = 64;  // a standard error of at most 1/16, less as they are stratified
        for (int s = sum.taken; s < kCoverageRays; ++s) {
            Sampler sampler(key_of_pixel(plan_.run, x, y), static_cast<std::uint32_t>(s));
            const Vec2f point = point_in(x, y, sampler);
            const Met met = met_by_ray(scene_, world_origin(plan_.camera, point), world_direction(plan_.camera, point));
            sum.cover(met.position, met.normal);
        }
    }
    bool meets_another(int x, int y, int first, int end, const Guides& guides) const {
        for (int s = first; s < end; ++s) {
            Sampler sampler(key_of_pixel(plan_.run, x, y), static_cast<std::uint32_t>(s));
            const Vec2f point = point_in(x, y, sampler);
            const Met met = met_by_ray(scene_, world_origin(plan_.camera, point), world_direction(plan_.camera, point));
            if (another_surface(guides.position.at(x, y), guides.normal.at(x, y), met.position, met.normal))
                return true;
        }
        return false;
    }

    const ShadeScene& scene_;
    const PixelPlan& plan_;
};

}  // namespace

std::unique_ptr<PixelTracer> processor_pixels(const ShadeScene& scene, const PixelPlan& plan) {
    return std::make_unique<ProcessorPixels>(scene, plan);
}

std::uint64_t picture_key(std::uint64_t seed) { return mix64(seed ^ 0x9a7e1ull); }
std::uint64_t path_picture_key(std::uint64_t seed) { return mix64(seed ^ 0x70a7ull); }

ImageColor cached_picture(const ShadeScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                          const Look* look, ImageColor* albedo, const Run& run, const MakePixelTracer& make) {
    const int round = parts.denoise     ? std::max(kLeastRound, samples / 16)
                      : parts.noise > 0 ? std::min(16, samples)
                                        : samples;
    ImageColor out(camera.width, camera.height);
    if (albedo) *albedo = out;
    std::optional<NoisyPicture> noisy;
    if (parts.denoise || parts.denoise_reflections) noisy.emplace(camera);
    // Each ray covers its share of the pixel: filtering textures over the whole pixel would blur them twice.
    const PixelPlan plan{camera, parts, samples, round, camera.pixel_angle / std::sqrt(static_cast<float>(round)),
                         look,   run};
    const std::unique_ptr<PixelTracer> tracer = make ? make(plan) : processor_pixels(scene, plan);
    const auto show = [&](int x, int y, const PixelSum& pixel) {
        out.at(x, y) = pixel.color();
        if (albedo) albedo->at(x, y) = pixel.albedo();
    };
    // In a partial picture the denoiser also sees the nearest pixels outside the mask.
    constexpr int kContext = 2;
    const ImageMask context = parts.only && parts.denoise ? grown(*parts.only, kContext, camera.panorama) : ImageMask{};
    const auto is_traced = [&](int x, int y) {
        return context.empty() ? is_asked_for(parts, x, y) : context.at(x, y) != 0;
    };
    // Columns by row; of all rows before any pixel changes.
    const auto selected = [&](const auto& in_row) {
        PixelRows rows(static_cast<std::size_t>(camera.height));
        parallel_for(camera.height, 8, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y) rows[static_cast<std::size_t>(y)] = in_row(y);
        });
        return rows;
    };
    Progress progress(run, "picture", camera.height);
    tracer->trace(
        selected([&](int y) {
            std::vector<int> columns;
            for (int x = 0; x < camera.width; ++x)
                if (is_traced(x, y)) columns.push_back(x);
            return columns;
        }),
        round,
        [&](int x, int y, const PixelSum& pixel) {
            show(x, y, pixel);
            if (noisy) noisy->set(x, y, pixel);
        },
        &progress);
    if (!noisy) return out;
    if (!parts.denoise) {
        noisy->denoise_into(out, look, true);
        return out;
    }
    // Sends more rays to selected pixels.
    const auto refine = [&](const PixelRows& pixels, int least) {
        tracer->trace(
            pixels, least,
            [&](int x, int y, const PixelSum& pixel) {
                show(x, y, pixel);
                noisy->set_again(x, y, pixel);
            },
            nullptr);
    };
    // Texture edges first: all of the four initial rays may lie on one side.
    refine(selected([&](int y) { return noisy->beside_pattern_edges(y, round); }), samples / 4);
    // Then edges of sun shadows: all rays may see the sun although a fifth of it is hidden, which would leave ragged
    // edges.
    constexpr int kShadowRounds = 2;
    for (int look_number = 0; look_number < kShadowRounds; ++look_number)
        refine(selected([&](int y) { return noisy->beside_shadow_edges(y, round); }), samples / 4);
    // Then beside outlines: where they cover a part of the pixel that all initial rays missed, lines would break. It is
    // cheap to test whether further rays hit another surface; where they do, the next pixel along is tested too.
    constexpr int kOutlineRounds = 4;
    const int next = samples / 2;
    Image<std::uint8_t> looked(camera.width, camera.height);
    for (int look_number = 0; look_number < kOutlineRounds; ++look_number) {
        const PixelRows doubtful = selected([&](int y) {
            std::vector<int> columns = noisy->beside_outlines(y, round, look_number == 0);
            std::erase_if(columns, [&](int x) { return std::exchange(looked.at(x, y), std::uint8_t{1}) != 0; });
            return columns;
        });
        refine(tracer->meeting_others(doubtful, round, next, noisy->guides), next);
    }
    noisy->denoise_into(out, look, false);
    return out;
}

ImageColor developed_paths(ImageColor sums, const ShotParts& parts, int samples, const Look* look) {
    parallel_for(sums.height, 16, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < sums.width; ++x) {
                if (!is_asked_for(parts, x, y)) continue;
                const Vec3f mean = sums.at(x, y) / static_cast<float>(samples);
                sums.at(x, y) = look ? develop(*look, mean) : mean;
            }
    });
    return sums;
}

ImageColor path_traced_picture(const PathScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                               const Look* look, const Run& run) {
    ImageColor out(camera.width, camera.height);
    Progress progress(run, "paths", camera.height);
    parallel_for(camera.height, 1, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < camera.width; ++x) {
                if (!is_asked_for(parts, x, y)) continue;
                const std::uint64_t key = path_picture_key(run.seed) ^
                                          (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
                Vec3f sum{};
                for (int s = 0; s < samples; ++s) {
                    Sampler sampler(key, static_cast<std::uint32_t>(s));
                    const Vec2f point = point_in(x, y, sampler);
                    sum += path_radiance(scene, world_origin(camera, point), world_direction(camera, point),
                                         camera.pixel_angle, sampler);
                }
                const Vec3f mean = sum / static_cast<float>(samples);
                out.at(x, y) = look ? develop(*look, mean) : mean;
            }
        progress.advance(end - begin);
    });
    return out;
}

}  // namespace fastscene
