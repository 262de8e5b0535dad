#include "fastscene/trace/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "fastscene/base/check.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/film.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/path.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/shade.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

// Where a pixel's samples look, and how wide they are.
struct Eye {
    Rigid world_from_camera;
    int width = 0, height = 0;
    std::function<Vec3f(Vec2f)> direction;   // camera frame, any length
    float pixel_angle = 0;
};

Vec3f world_direction(const Eye& eye, Vec2f pixel) { return normalize(eye.world_from_camera.rotation * eye.direction(pixel)); }

// The i-th of n positions in a pixel: n jittered strata in a square as near as possible.
Vec2f stratum(int i, int n, Random& random) {
    const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<float>(n)) + 0.5f));
    if (i >= side * side) return {random.uniform(), random.uniform()};
    return {(static_cast<float>(i % side) + random.uniform()) / static_cast<float>(side), (static_cast<float>(i / side % side) + random.uniform()) / static_cast<float>(side)};
}

// How well the mean of the samples so far is known.
class MeanError {
  public:
    void add(float v) {
        ++count_;
        sum_ += v;
        squares_ += v * v;
    }
    // Standard error of the mean, in sRGB-encoded values: what the eye and PSNR see. Strata make the true error smaller.
    float of_srgb_mean() const {
        const float n = static_cast<float>(count_), mean = sum_ / n;
        const float error = std::sqrt(std::max(0.f, squares_ / n - mean * mean) / n);
        // The slope of the encoding, about half a power.
        return error * 0.5f / std::sqrt(std::max(0.003f, mean));
    }

  private:
    int count_ = 0;
    float sum_ = 0, squares_ = 0;
};

}  // namespace

struct TracedRoom::Impl {
    Room room;
    SceneBvh bvh;
    Lights lights;
    std::vector<bool> closed;
    TraceParams params;
    std::optional<IrradianceCache> light;

    explicit Impl(Room r) : room(std::move(r)), bvh(room), lights(room) {
        for (const Mesh& mesh : room.meshes) closed.push_back(is_closed(mesh));
    }

    // Radiances, or developed color when `look` is given.
    ImageColor color(const Eye& eye, const ShotParts& parts, const Look* look, ImageColor* albedo, const Run& run) const {
        const ShadeScene scene{room, bvh, lights, *light};
        const int samples = parts.pixel_samples > 0 ? parts.pixel_samples : params.pixel_samples;
        const int round = parts.noise > 0 ? std::min(16, samples) : samples;
        ImageColor out(eye.width, eye.height);
        if (albedo) *albedo = ImageColor(eye.width, eye.height);
        Progress progress(run, "picture", eye.height);
        parallel_for(eye.height, 4, [&](std::int64_t begin, std::int64_t end) {
            run.check_stop();
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (int x = 0; x < eye.width; ++x) {
                    Random random(mix64(run.seed ^ 0x9a7e1ull) ^ (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x)));
                    Vec3f sum{}, sum_albedo{};
                    MeanError error;
                    int taken = 0;
                    do {
                        for (int s = 0; s < round; ++s) {
                            const Vec2f offset = stratum(s, round, random);
                            const Vec3f direction = world_direction(eye, {static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y});
                            const Shaded shaded = shade_ray(scene, eye.world_from_camera.translation, direction, eye.pixel_angle, random);
                            // Samples are developed before they are averaged: edges against a bright window stay smooth.
                            const Vec3f color = look ? develop(*look, shaded.radiance) : shaded.radiance;
                            sum += color;
                            sum_albedo += shaded.albedo;
                            if (parts.noise > 0) error.add(luminance(color));
                        }
                        taken += round;
                    } while (taken < samples && error.of_srgb_mean() > parts.noise);
                    out.at(x, y) = sum / static_cast<float>(taken);
                    if (albedo) albedo->at(x, y) = sum_albedo / static_cast<float>(taken);
                }
            progress.advance(end - begin);
        });
        return out;
    }

    // Radiances are averaged over the pixel before they are developed.
    ImageColor path_traced(const Eye& eye, const ShotParts& parts, const Look* look, const Run& run) const {
        const PathScene scene{room, bvh, lights};
        const int samples = parts.pixel_samples > 0 ? parts.pixel_samples : params.pixel_samples;
        ImageColor out(eye.width, eye.height);
        Progress progress(run, "paths", eye.height);
        parallel_for(eye.height, 1, [&](std::int64_t begin, std::int64_t end) {
            run.check_stop();
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (int x = 0; x < eye.width; ++x) {
                    const std::uint64_t key = mix64(run.seed ^ 0x70a7ull) ^ (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
                    Vec3f sum{};
                    for (int s = 0; s < samples; ++s) {
                        Sampler sampler(key, static_cast<std::uint32_t>(s));
                        const Vec2f offset = sampler.next2();
                        const Vec3f direction = world_direction(eye, {static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y});
                        sum += path_radiance(scene, eye.world_from_camera.translation, direction, eye.pixel_angle, sampler);
                    }
                    const Vec3f mean = sum / static_cast<float>(samples);
                    out.at(x, y) = look ? develop(*look, mean) : mean;
                }
            progress.advance(end - begin);
        });
        return out;
    }

    Shot shoot(const Eye& eye, const ShotParts& parts, const Run& run) const {
        Shot shot;
        if (parts.color || parts.albedo) {
            const Look* look = parts.radiance ? nullptr : &room.look;
            FASTSCENE_CHECK(light.has_value() || parts.paths);
            shot.color = parts.paths ? path_traced(eye, parts, look, run) : color(eye, parts, look, parts.albedo ? &shot.albedo : nullptr, run);
        }
        if (parts.range) shot.range = ImageF(eye.width, eye.height);
        if (parts.normal) shot.normal = ImageColor(eye.width, eye.height);
        if (parts.object) shot.object = Image<std::int32_t>(eye.width, eye.height, -2);
        if (!parts.range && !parts.normal && !parts.object) return shot;
        parallel_for(eye.height, 8, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (int x = 0; x < eye.width; ++x) {
                    const Vec3f direction = world_direction(eye, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
                    const RayHit hit = bvh.first_hit(eye.world_from_camera.translation, direction);
                    if (parts.range) shot.range.at(x, y) = hit.distance;
                    if (!hit) continue;
                    const Mesh& mesh = room.meshes[static_cast<std::size_t>(hit.mesh)];
                    if (parts.object) shot.object.at(x, y) = mesh.object;
                    if (parts.normal) shot.normal.at(x, y) = hit.back ? -shading_normal(mesh, hit) : shading_normal(mesh, hit);
                }
        });
        return shot;
    }
};

TracedRoom::TracedRoom(Room room) : impl_(std::make_unique<Impl>(std::move(room))) {}
TracedRoom::~TracedRoom() = default;
TracedRoom::TracedRoom(TracedRoom&&) noexcept = default;
TracedRoom& TracedRoom::operator=(TracedRoom&&) noexcept = default;

namespace {

Eye panorama_eye(const Rigid& world_from_pano, EquirectSize size) {
    return {world_from_pano, size.width, size.height, [size](Vec2f p) { return direction_at(p, size); }, static_cast<float>(M_PI) / static_cast<float>(size.height)};
}

}  // namespace

void TracedRoom::gather_light(const TraceParams& params, const Run& run) {
    impl_->params = params;
    impl_->light = IrradianceCache::gather(impl_->room, impl_->bvh, params, run);
    const Run quiet{run.seed, nullptr, run.stop};
    const ImageColor small = impl_->color(panorama_eye({}, {128, 64}), {.pixel_samples = 4}, nullptr, nullptr, quiet);
    impl_->room.look = automatic_look(impl_->room.look, impl_->room.sky, small);
}

Shot TracedRoom::panorama(const Rigid& world_from_pano, EquirectSize size, const ShotParts& parts, const Run& run) const {
    return impl_->shoot(panorama_eye(world_from_pano, size), parts, run);
}

Shot TracedRoom::perspective(const Rigid& world_from_camera, const Pinhole& camera, const ShotParts& parts, const Run& run) const {
    return impl_->shoot({world_from_camera, camera.width, camera.height, [camera](Vec2f p) { return camera.direction_at(p); }, 1.f / camera.fx}, parts, run);
}

float TracedRoom::distance(Vec3f origin, Vec3f direction) const { return impl_->bvh.first_hit(origin, direction).distance; }

float TracedRoom::clearance(Vec3f point, float limit_m) const {
    // Inside a solid most ways out lead through back faces.
    constexpr std::array<Vec3f, 6> kWays{Vec3f{1, 0, 0}, Vec3f{-1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, -1, 0}, Vec3f{0, 0, 1}, Vec3f{0, 0, -1}};
    int inside = 0;
    for (const Vec3f way : kWays) {
        const RayHit hit = impl_->bvh.first_hit(point, way);
        if (hit && hit.back && impl_->closed[static_cast<std::size_t>(hit.mesh)]) ++inside;
    }
    return inside >= 4 ? 0.f : impl_->bvh.nearest(point, limit_m);
}

const Room& TracedRoom::room() const { return impl_->room; }

}  // namespace fastscene
