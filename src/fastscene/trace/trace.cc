#include "fastscene/trace/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>

#include "fastscene/base/bytes.h"
#include "fastscene/base/check.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/backend.h"
#include "fastscene/trace/film.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/picture.h"
#include "fastscene/trace/room_change.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

constexpr std::string_view kLightFormat = "fastscene-light 2\n";
constexpr int kMostMirrors = 4;  // same limit as for mirrors within mirrors in pictures (shade.cc)

// The normal of a mesh that is a flat mirror, i.e. nearly all of its surface is mirror or the back of its pane. Zero if
// it is not, or if it has no single image (a mirror ball).
Vec3f mirror_normal(const Room& room, const Mesh& mesh) {
    if (!(room.materials[static_cast<std::size_t>(mesh.material)].mirror > 0.5f)) return {};
    std::vector<Vec3f> areas;  // normals weighted by twice the area
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.positions[mesh.triangles[i + k]]; };
        areas.push_back(cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    if (areas.empty()) return {};
    const Vec3f normal = normalize(
        *std::max_element(areas.begin(), areas.end(), [](Vec3f a, Vec3f b) { return dot(a, a) < dot(b, b); }));
    float all = 0, flat = 0;
    for (const Vec3f area : areas) {
        all += length(area);
        if (std::fabs(dot(area, normal)) > 0.9999f * length(area)) flat += length(area);
    }
    return flat > 0.8f * all ? normal : Vec3f{};
}

}  // namespace

struct TracedRoom::Impl {
    Room room;
    SceneBvh bvh;
    std::vector<bool> closed;
    std::vector<Vec3f> mirrors;  // by mesh: mirror_normal
    TraceParams params;
    std::optional<IrradianceCache> light;

    // Built on first use: geometry alone needs no light, and the outside takes seconds.
    const Lights& lights() const {
        std::call_once(lights_once_, [&] { lights_.emplace(room, params.outside_detail, &bvh, outdoors); });
        return *lights_;
    }
    std::shared_ptr<const Outdoors> outdoors;  // of a room with the same outside, if there is one
    mutable std::once_flag lights_once_;
    mutable std::optional<Lights> lights_;

    // Another processor that renders this room, if one was asked for; one picture at a time.
    std::unique_ptr<RoomTracer> card;
    mutable std::mutex card_mutex;

    explicit Impl(Room r) : room(std::move(r)), bvh(room) {
        for (const Mesh& mesh : room.meshes) {
            closed.push_back(is_closed(mesh));
            mirrors.push_back(mirror_normal(room, mesh));
        }
    }

    void prepare(const TraceParams& by) {
        params = by;
        card = nullptr;
        const auto& backend = registered_entry<TraceBackendEntry>("--trace-backend", params.backend.name);
        check_device(params.backend, "--trace-device");  // before the outside is built
        if (const auto make = backend.make) card = make(params.backend.device, room, lights());
    }
    ViewTransform transform() const {
        const auto name = std::find(kViewTransforms.begin(), kViewTransforms.end(), params.view_transform);
        FASTSCENE_CHECK(name != kViewTransforms.end());
        return static_cast<ViewTransform>(name - kViewTransforms.begin());
    }
    // The exposure as seen from the world's origin.
    Look automatic_look(const Run& run) {
        const Run quiet{run.seed, nullptr, run.stop};
        ImageColor albedo;
        const ImageColor small = color(panorama_camera({}, {128, 64}), {.pixel_samples = 4}, nullptr, &albedo, quiet);
        Look look = room.look;
        look.transform = transform();
        if (look.automatic) look.exposure_ev += params.exposure_ev;
        return fastscene::automatic_look(look, room.sky, small, albedo, lights().outdoors().brightness());
    }
    void expose(const Look& look) {
        room.look = look;
        if (card) card->set_look(room.look, room.sky);
    }
    // Of the room and the settings that its light depends on.
    std::string light_key() const {
        return Hash()
            .add(content_of(room))
            .add(params.cell_m)
            .add(params.cell_samples)
            .add(params.view_transform)
            .add(params.exposure_ev)
            .hex();
    }

    ImageColor color(const RayCamera& camera, const ShotParts& parts, const Look* look, ImageColor* albedo,
                     const Run& run) const {
        const int samples = parts.pixel_samples > 0 ? parts.pixel_samples : params.pixel_samples;
        std::unique_lock<std::mutex> lock(card_mutex, std::defer_lock);
        if (card) lock.lock();
        if (parts.paths && card)
            return developed_paths(card->path_sums(camera, parts, samples, run), parts, samples, look);
        if (parts.paths) return path_traced_picture({room, bvh, lights()}, camera, parts, samples, look, run);
        FASTSCENE_CHECK(light.has_value());
        return cached_picture({room, bvh, lights(), *light, parts.contacts, parts.frugal, parts.min_alpha}, camera,
                              parts, samples, look, albedo, run, card ? card->pixels(parts) : MakePixelTracer{});
    }

    // Metres along the ray to the virtual image, followed through all flat mirrors on the way.
    float distance_by_mirrors(Vec3f origin, Vec3f direction, RayHit hit) const {
        float way = hit.distance;
        for (int met = 0; hit && met < kMostMirrors; ++met) {
            const Vec3f normal = mirrors[static_cast<std::size_t>(hit.mesh)];
            if (std::fabs(dot(hit.normal, normal)) < 0.9999f) break;  // not a mirror, or the pane's rounded rim
            const Vec3f facing = dot(direction, normal) < 0 ? normal : -normal;
            origin = offset_from(origin + direction * hit.distance, facing);
            direction = normalize(direction - normal * (2 * dot(direction, normal)));
            hit = bvh.first_hit(origin, direction);
            way += hit.distance;
        }
        return way;
    }

    Shot shoot(const RayCamera& camera, const ShotParts& parts, const Run& run) const {
        Shot shot;
        if (parts.color || parts.albedo) {
            const Look* look = parts.radiance ? nullptr : &room.look;
            shot.color = color(camera, parts, look, parts.albedo ? &shot.albedo : nullptr, run);
        }
        if (parts.range) shot.range = ImageF(camera.width, camera.height);
        if (parts.mirrored_range) shot.mirrored_range = ImageF(camera.width, camera.height);
        if (parts.normal) shot.normal = ImageColor(camera.width, camera.height);
        if (parts.object) shot.object = Image<std::int32_t>(camera.width, camera.height, -2);
        if (parts.mesh) shot.mesh = Image<std::int32_t>(camera.width, camera.height, -1);
        if (!parts.range && !parts.mirrored_range && !parts.normal && !parts.object && !parts.mesh) return shot;
        parallel_for(camera.height, 8, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (int x = 0; x < camera.width; ++x) {
                    if (!is_asked_for(parts, x, y)) continue;
                    const Vec2f center{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
                    const Vec3f origin = world_origin(camera, center), direction = world_direction(camera, center);
                    const RayHit hit = bvh.first_hit(origin, direction);
                    if (parts.range) shot.range.at(x, y) = hit.distance;
                    if (parts.mirrored_range)
                        shot.mirrored_range.at(x, y) = distance_by_mirrors(origin, direction, hit);
                    if (!hit) continue;
                    const Mesh& mesh = room.meshes[static_cast<std::size_t>(hit.mesh)];
                    if (parts.object) shot.object.at(x, y) = mesh.object;
                    if (parts.mesh) shot.mesh.at(x, y) = hit.mesh;
                    if (parts.normal)
                        shot.normal.at(x, y) = hit.back ? -shading_normal(mesh, hit) : shading_normal(mesh, hit);
                }
        });
        return shot;
    }
};

TracedRoom::TracedRoom(Room room) : impl_(std::make_unique<Impl>(std::move(room))) {}
TracedRoom::~TracedRoom() = default;
TracedRoom::TracedRoom(TracedRoom&&) noexcept = default;
TracedRoom& TracedRoom::operator=(TracedRoom&&) noexcept = default;

void TracedRoom::gather_light(const TraceParams& params, const Run& run, const std::vector<Vec3f>& viewpoints) {
    impl_->prepare(params);
    impl_->light = IrradianceCache::gather(impl_->room, impl_->bvh, impl_->lights(), params, run, viewpoints,
                                           impl_->card ? &impl_->card->gatherer() : nullptr);
    impl_->expose(impl_->automatic_look(run));
}

double TracedRoom::gather_light_again(const TraceParams& params, const Run& run, const std::vector<Vec3f>& viewpoints,
                                      const TracedRoom& before) {
    constexpr float kVisible_ev = 0.04f;  // three percent
    FASTSCENE_CHECK(before.impl_->light.has_value());
    impl_->prepare(params);
    const RoomChange change = change_between(before.room(), impl_->room);
    if (impl_->card || change.lights) {
        gather_light(params, run, viewpoints);
        return 0;
    }
    impl_->outdoors = before.impl_->lights().shared_outdoors();
    impl_->light = IrradianceCache::gather_again(impl_->room, impl_->bvh, impl_->lights(), params, run, viewpoints,
                                                 {*before.impl_->light, change});
    Look look = impl_->automatic_look(run);
    const float kept_ev = before.room().look.exposure_ev;
    if (std::fabs(look.exposure_ev - kept_ev) < kVisible_ev) look.exposure_ev = kept_ev;
    impl_->expose(look);
    return impl_->light->kept_share();
}

std::string TracedRoom::light() const {
    FASTSCENE_CHECK(impl_->light.has_value());
    std::string out = std::string(kLightFormat) + impl_->light_key();
    const Look& look = impl_->room.look;
    for (const float value : {look.exposure_ev, look.white.x, look.white.y, look.white.z, look.contrast,
                              look.saturation, look.outside_seen, look.sun_seen})
        append(out, value);
    out += impl_->light->bytes();
    out += impl_->lights().outdoors().bytes();
    return out + Hash().add(out).hex();
}

bool TracedRoom::take_light(const TraceParams& params, std::string_view bytes, const std::string& name) {
    impl_->prepare(params);
    if (impl_->card) return false;
    const std::string key = impl_->light_key();
    const std::size_t header = kLightFormat.size() + key.size(), least = header + key.size();
    if (!bytes.starts_with(kLightFormat) || bytes.size() < least)
        throw Error("{}: expected the light of a room, found something else", name);
    if (bytes.substr(kLightFormat.size(), key.size()) != key)
        throw Error("{}: expected the light of this room by these settings, found that of another", name);
    const std::string_view content = bytes.substr(0, bytes.size() - key.size());
    if (Hash().add(content).hex() != bytes.substr(content.size()))
        throw Error("{}: expected the light of a room, found a damaged file", name);
    ByteReader in(name, content);
    in.skip(header);
    Look look = impl_->room.look;
    look.automatic = false;
    look.transform = impl_->transform();
    for (float* value : {&look.exposure_ev, &look.white.x, &look.white.y, &look.white.z, &look.contrast,
                         &look.saturation, &look.outside_seen, &look.sun_seen})
        *value = in.get<float>();
    impl_->light = IrradianceCache::from_bytes(in, impl_->room);
    auto outdoors = std::make_shared<const Outdoors>(Outdoors::from_bytes(in, impl_->room.sky));
    if (outdoors->pixels_per_degree() == params.outside_detail) impl_->outdoors = std::move(outdoors);
    impl_->expose(look);
    return true;
}

Shot TracedRoom::panorama(const Rigid& world_from_pano, EquirectSize size, const ShotParts& parts,
                          const Run& run) const {
    return impl_->shoot(panorama_camera(world_from_pano, size), parts, run);
}

Shot TracedRoom::eye_panorama(const Rigid& world_from_pano, EquirectSize size, float eye_m, const ShotParts& parts,
                              const Run& run) const {
    return impl_->shoot(panorama_camera(world_from_pano, size, eye_m), parts, run);
}

Shot TracedRoom::perspective(const Rigid& world_from_camera, const Pinhole& camera, const ShotParts& parts,
                             const Run& run) const {
    return impl_->shoot(perspective_camera(world_from_camera, camera), parts, run);
}

ImageColor TracedRoom::outside(const Mat3f& world_from_pano, EquirectSize size) const {
    const Room& room = impl_->room;
    const Outdoors& outdoors = impl_->lights().outdoors();
    ImageColor color(size.width, size.height);
    parallel_for(size.height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < size.width; ++x)
                color.at(x, y) = develop(
                    room.look, outside_as_seen(room.sky, room.look,
                                               outdoors.seen(world_from_pano * direction_of_pixel(x, y, size))));
    });
    return color;
}

std::vector<Vec3f> TracedRoom::colors_faced(const std::vector<FacedPoint>& points, int samples, const Run& run) const {
    FASTSCENE_CHECK(impl_->light.has_value());
    constexpr float kBefore_m = 2e-3f;  // closer than what lies on a surface, such as a rug
    const ShadeScene scene{impl_->room, impl_->bvh, impl_->lights(), *impl_->light, false, false, 0};
    std::vector<Vec3f> out(points.size());
    Progress progress(run, "light", static_cast<std::int64_t>(points.size()));
    parallel_for(static_cast<std::int64_t>(points.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (std::int64_t i = begin; i < end; ++i) {
            const FacedPoint& p = points[static_cast<std::size_t>(i)];
            Vec3f sum{};
            // All from one place: beside an edge another may lie within a wall.
            const Vec3f from = p.position + p.normal * kBefore_m;
            for (int s = 0; s < samples; ++s) {
                Sampler sampler(mix64(run.seed ^ 0xfaceull) ^ static_cast<std::uint64_t>(i),
                                static_cast<std::uint32_t>(s));
                sum += develop(impl_->room.look,
                               shade_ray(scene, from, -p.normal, p.width_m / kBefore_m, sampler).radiance);
            }
            out[static_cast<std::size_t>(i)] = sum / static_cast<float>(samples);
        }
        progress.advance(end - begin);
    });
    return out;
}

float TracedRoom::distance(Vec3f origin, Vec3f direction) const {
    return impl_->bvh.first_hit(origin, direction).distance;
}

TracedRoom::Surface TracedRoom::surface(Vec3f origin, Vec3f direction) const {
    const RayHit hit = impl_->bvh.first_lit(origin, direction);
    if (!hit) return {hit.distance, {}};
    return {hit.distance, dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal, hit.mesh};
}

float TracedRoom::distance_through_mirrors(Vec3f origin, Vec3f direction) const {
    return impl_->distance_by_mirrors(origin, direction, impl_->bvh.first_hit(origin, direction));
}

bool TracedRoom::sees(Vec3f from, Vec3f to) const {
    constexpr float kSurface_m = 4e-3f;  // tolerance for rounding and for thin things on a surface
    const Vec3f way = to - from;
    const float far = length(way);
    return far <= kSurface_m || !impl_->bvh.blocked(from, way / far, 0.f, far - kSurface_m);
}

float TracedRoom::clearance(Vec3f point, float limit_m) const {
    // Inside a solid most directions hit back faces.
    constexpr std::array<Vec3f, 6> kWays{Vec3f{1, 0, 0},  Vec3f{-1, 0, 0}, Vec3f{0, 1, 0},
                                         Vec3f{0, -1, 0}, Vec3f{0, 0, 1},  Vec3f{0, 0, -1}};
    int inside = 0;
    for (const Vec3f way : kWays) {
        const RayHit hit = impl_->bvh.first_hit(point, way);
        if (hit && hit.back && impl_->closed[static_cast<std::size_t>(hit.mesh)]) ++inside;
    }
    return inside >= 4 ? 0.f : impl_->bvh.nearest(point, limit_m);
}

const Room& TracedRoom::room() const { return impl_->room; }

std::string TracedRoom::device() const { return impl_->card ? impl_->card->device() : std::string(); }

}  // namespace fastscene
