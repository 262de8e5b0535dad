#include "fastscene/trace/outdoors_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/trace/noise.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/scene_bvh.h"

namespace fastscene::outdoors {
namespace {

constexpr float kSunRadius = 0.0075f;   // radians; a little wider than the disc, as haze makes it
constexpr float kShadowReach_m = 60.f;  // beyond this, what hides the sky is not asked for
constexpr float kOffset_m = 2e-3f;

Vec3f flipped(Vec3f v) { return {v.x, -v.y, v.z}; }

struct Hit {
    float distance = std::numeric_limits<float>::infinity();
    std::uint32_t instance = 0, mesh = 0, quad = 0;
    Vec3f normal;  // unit, facing the ray
};

}  // namespace

struct Tracer::Impl {
    Sky sky;
    World world;
    const SkyDome& dome;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<RTCScene> prototypes;
    Vec3f to_sun, sunny;  // sunny: irradiance of flat open ground
    Vec3f bounced;        // irradiance from greenery and ground all around, half of it in the sun
    static constexpr int kTurns = 24, kRises = 12;
    std::array<std::array<Vec3f, kTurns>, kRises + 1> open{};  // irradiance without the sun, by normal
    bool dark = false;

    Impl(const Sky& s, World w, const SkyDome& d) : sky(s), world(std::move(w)), dome(d) {
        device = rtcNewDevice(embree_settings());
        if (!device)
            throw Error("Embree: expected a ray tracing device, found error {}",
                        static_cast<int>(rtcGetDeviceError(nullptr)));
        for (QuadMesh& mesh : world.meshes) add_prototype(mesh);
        scene = rtcNewScene(device);
        for (const Instance& i : world.instances) add_instance(i);
        rtcCommitScene(scene);
        to_sun = flipped(sky.sun_dir);
        sunny = sky_irradiance({0, 1, 0}) + sky.sun_irradiance * std::max(0.f, to_sun.y);
        const bool paved = sky.view == Sky::View::city || sky.view == Sky::View::street ||
                           sky.view == Sky::View::airfield;
        bounced = sunny * (sky.snow                     ? Vec3f{0.5f, 0.52f, 0.56f}
                           : paved                      ? Vec3f{0.22f, 0.21f, 0.195f}
                           : sky.view == Sky::View::sea ? Vec3f{0.17f, 0.155f, 0.13f}
                                                        : Vec3f{0.11f, 0.105f, 0.07f});
        for (int j = 0; j <= kRises; ++j)
            for (int i = 0; i < kTurns; ++i) {
                const float rise = kPi * (static_cast<float>(j) / kRises - 0.5f),
                            turn = 2 * kPi * static_cast<float>(i) / kTurns;
                open[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = sky_irradiance(
                    {std::cos(rise) * std::sin(turn), std::sin(rise), std::cos(rise) * std::cos(turn)});
            }
        dark = sky.time == Sky::Time::night || sky.time == Sky::Time::dusk;
    }
    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        for (RTCScene p : prototypes) rtcReleaseScene(p);
        if (device) rtcReleaseDevice(device);
    }

    void add_prototype(QuadMesh& mesh) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
        const std::size_t count = std::max<std::size_t>(1, mesh.size());
        auto* corners = static_cast<Vec3f*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), 4 * count));
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 16, count));
        if (!corners || !indices) throw Error("Embree: expected memory for {} quads, found none", count);
        corners[0] = corners[1] = corners[2] = corners[3] = {};
        std::copy(mesh.corners.begin(), mesh.corners.end(), corners);
        for (std::size_t k = 0; k < 4 * count; ++k) indices[k] = static_cast<std::uint32_t>(k);
        rtcCommitGeometry(geometry);
        RTCScene part = rtcNewScene(device);
        rtcAttachGeometry(part, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(part);
        prototypes.push_back(part);
        mesh.corners.clear(), mesh.corners.shrink_to_fit();  // Embree has them now
    }
    void add_instance(const Instance& i) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, prototypes[i.mesh]);
        const Vec3f x = i.axes.column(0), y = i.axes.column(1), z = i.axes.column(2);
        const float columns[12] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, i.at.x, i.at.y, i.at.z};
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }

    Hit first_hit(Vec3f origin, Vec3f direction) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit ray{};
        ray.ray = {origin.x, origin.y, origin.z, 0.f, direction.x, direction.y, direction.z, 0.f, kFar, ~0u, 0u, 0u};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &ray);
        Hit hit;
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
        hit.distance = ray.ray.tfar;
        hit.instance = ray.hit.instID[0];
        hit.mesh = world.instances[hit.instance].mesh;
        hit.quad = ray.hit.primID;
        // Normals turn with the cofactors of the axes, which also holds for uneven scales.
        const Mat3f& m = world.instances[hit.instance].axes;
        const Vec3f a = m.column(0), b = m.column(1), c = m.column(2);
        const Vec3f n = normalize(cross(b, c) * ray.hit.Ng_x + cross(c, a) * ray.hit.Ng_y + cross(a, b) * ray.hit.Ng_z);
        hit.normal = dot(n, direction) < 0 ? n : -n;
        return hit;
    }
    bool blocked(Vec3f origin, Vec3f direction, float far) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay ray{origin.x, origin.y, origin.z, 0.f, direction.x, direction.y, direction.z, 0.f, far, ~0u, 0u, 0u};
        rtcOccluded1(scene, &context, &ray);
        return ray.tfar < 0;
    }

    Vec3f sky_irradiance(Vec3f normal) const {
        constexpr int kSide = 20;
        Vec3f sum{};
        for (int k = 0; k < kSide * kSide; ++k) {
            const Vec3f way = cosine_direction(normal, {(static_cast<float>(k % kSide) + 0.5f) / kSide,
                                                        (static_cast<float>(k / kSide) + 0.5f) / kSide});
            sum += (way.y > 0 ? dome.air(flipped(way)) * kPi : bounced) / (kSide * kSide);
        }
        return sum;
    }
    Vec3f open_irradiance(Vec3f normal) const {
        const float u = (std::atan2(normal.x, normal.z) / (2 * kPi) + 1) * kTurns,
                    v = (std::asin(std::clamp(normal.y, -1.f, 1.f)) / kPi + 0.5f) * kRises;
        const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(std::min(kRises - 1.f, v));
        const float a = u - static_cast<float>(i), b = v - static_cast<float>(j);
        const auto left = i % kTurns, right = (i + 1) % kTurns;
        return lerp(lerp(open[j][left], open[j][right], a), lerp(open[j + 1][left], open[j + 1][right], a), b);
    }

    // One sample of the sunlight on a surface that faces it.
    Vec3f sunlight(Vec3f from, float cosine, Random& random) const {
        Vec3f s, t;
        make_frame(to_sun, s, t);
        const float r = kSunRadius * std::sqrt(random.uniform()), turn = 2 * kPi * random.uniform();
        const Vec3f way = normalize(to_sun + s * (r * std::cos(turn)) + t * (r * std::sin(turn)));
        return blocked(from, way, kFar) ? Vec3f{} : sky.sun_irradiance * cosine;
    }
    // One sample of what comes from the sky, and from other things. The irradiance from an open sky and ground is known
    // for every normal; whether something is in the way is not.
    Vec3f skylight(Vec3f from, Vec3f normal, Random& random) const {
        constexpr float kShade = 0.75f;
        const Vec3f way = cosine_direction(normal, {random.uniform(), random.uniform()});
        return way.y > 0 && blocked(from, way, kShadowReach_m) ? bounced * kShade : open_irradiance(normal);
    }
    bool is_sunny() const { return luminance(sky.sun_irradiance) > 0; }

    // Irradiance of a surface, one sample.
    Vec3f irradiance(Vec3f at, Vec3f normal, Random& random) const {
        const Vec3f from = at + normal * kOffset_m;
        const float cosine = dot(normal, to_sun);
        const Vec3f sun = is_sunny() && cosine > 0 ? sunlight(from, cosine, random) : Vec3f{};
        return sun + skylight(from, normal, random) + lanterns(at, normal);
    }
    // Radiance of a thin sheet, one sample: it reflects what falls on this side, and lets through what falls on the
    // other. The sun shines on one of them.
    Vec3f sheet(Vec3f at, Vec3f normal, Vec3f albedo, Vec3f through, Random& random) const {
        const Vec3f front = at + normal * kOffset_m, back = at - normal * kOffset_m;
        Vec3f out = albedo * (skylight(front, normal, random) + lanterns(at, normal)) +
                    through * (skylight(back, -normal, random) + lanterns(at, -normal));
        if (is_sunny()) {
            const float cosine = dot(normal, to_sun);
            out += (cosine > 0 ? albedo : through) * sunlight(cosine > 0 ? front : back, std::abs(cosine), random);
        }
        return out * (1 / kPi);
    }

    // Street lamps, without shadows.
    Vec3f lanterns(Vec3f at, Vec3f normal) const {
        Vec3f sum{};
        if (!dark) return sum;
        const float level = sky.time == Sky::Time::night ? 0.03f : 0.1f;
        constexpr float kReach_m = 26;
        for (const Lantern& l : world.lanterns) {
            const Vec3f to = l.at - at;
            const float d2 = dot(to, to);
            if (d2 > kReach_m * kReach_m) continue;
            const float d = std::sqrt(d2), cosine = dot(normal, to) / std::max(0.1f, d);
            // Leaves and rough walls catch some from behind.
            sum += l.intensity * (level * std::max(0.12f, cosine) / (d2 + 0.6f));
        }
        return sum;
    }

    Vec3f haze(Vec3f direction, Vec3f color, float distance) const {
        const float clear = std::exp(-distance / world.clear_m);
        const Vec3f level = normalize(Vec3f{direction.x, 0.03f, direction.z});
        return color * clear + dome.air(flipped(level)) * (0.82f * (1 - clear));
    }

    // The room behind a pane: walls, ceiling and floor of a box, a curtain at its side. Lit after sunset, if it is.
    Vec3f behind_glass(Vec3f at, Vec3f normal, Vec3f direction) const {
        constexpr float kWide_m = 3.6f, kHigh_m = 3.1f, kDeep_m = 4.2f;
        const Vec3f across = normalize(cross(Vec3f{0, 1, 0}, normal));
        const float u = dot(at, across), v = at.y;
        const int room_u = floor_int(u / kWide_m), room_v = floor_int(v / kHigh_m);
        const int wall = static_cast<int>(std::lround(50 * std::atan2(normal.x, normal.z))) +
                         static_cast<int>(std::lround(dot(at, normal)));
        const auto rng = [&](int what) { return lattice_unit(room_u * 31 + what, room_v, wall, sky.seed); };
        const float x = u - kWide_m * static_cast<float>(room_u), y = v - kHigh_m * static_cast<float>(room_v);
        const float dx = dot(direction, across), dy = direction.y, dz = std::max(1e-3f, -dot(direction, normal));
        const auto far = [](float p, float d, float size) {
            return d > 0 ? (size - p) / std::max(1e-4f, d) : p / std::max(1e-4f, -d);
        };
        const float tx = far(x, dx, kWide_m), ty = far(y, dy, kHigh_m), tz = kDeep_m / dz, t = std::min({tx, ty, tz});
        const float deep = t * dz / kDeep_m;
        Vec3f tone = t == ty ? (dy > 0 ? Vec3f{0.7f, 0.7f, 0.68f} : Vec3f{0.25f, 0.19f, 0.14f})
                             : Vec3f{0.55f, 0.5f, 0.44f};
        tone = tone * Vec3f{0.8f + 0.4f * rng(1), 0.8f + 0.4f * rng(2), 0.8f + 0.4f * rng(3)};
        // Furniture: dark shapes along the lower wall.
        const float height = y + dy * t;
        if (height < 0.5f + 1.3f * lattice_unit(floor_int((x + dx * t) * 1.6f) + 7, room_u, room_v, sky.seed))
            tone = tone * 0.45f;
        const bool lit = dark && rng(4) > (sky.time == Sky::Time::night ? 0.6f : 0.52f);
        const Vec3f day = sunny * (0.028f * std::exp(-1.6f * deep));
        const Vec3f lamp = Vec3f{0.5f, 0.33f, 0.16f} * (0.35f + 0.9f * rng(5)) *
                           (sky.time == Sky::Time::night ? 0.36f : 0.8f);
        Vec3f inside = tone * (lit ? lamp * (1.1f - 0.5f * deep) : day);
        // Curtains and blinds right behind the pane.
        const float hang = rng(6);
        const float side = std::abs(x / kWide_m - 0.5f);
        if (hang < 0.45f && side > 0.24f) {
            const float fold = 0.75f + 0.25f * std::cos(42.f * x);
            inside = Vec3f{0.6f, 0.57f, 0.52f} * fold * (lit ? lamp * 0.8f : sunny * 0.06f);
        } else if (hang > 0.88f) {
            inside = Vec3f{0.6f, 0.58f, 0.54f} * (lit ? lamp * 0.9f : sunny * 0.075f);
        }
        return inside;
    }

    // `first`: seen by the eye; reflections show only the sky and flat color.
    Vec3f glass(Vec3f at, Vec3f normal, Vec3f direction, Random& random) const {
        // Panes are never quite flat, nor parallel to each other.
        const Vec3f lean{lattice_unit(floor_int(at.x * 0.7f), floor_int(at.y * 0.5f), floor_int(at.z * 0.7f), 5) - 0.5f,
                         lattice_unit(floor_int(at.x * 0.7f), floor_int(at.y * 0.5f), floor_int(at.z * 0.7f), 6) - 0.5f,
                         0};
        const Vec3f n = normalize(normal + lean * 0.025f);
        const float c = std::clamp(-dot(n, direction), 0.f, 1.f), mirror = 0.08f + 0.92f * std::pow(1 - c, 5.f);
        const Vec3f out = normalize(direction - n * (2 * dot(n, direction)));
        Vec3f seen;
        const Hit hit = first_hit(at + normal * kOffset_m, out);
        if (!(hit.distance < kFar)) {
            seen = dome.at(flipped(out.y > 0 ? out : Vec3f{out.x, 0.01f, out.z}));
        } else {
            const Paint& p = world.paints[world.meshes[hit.mesh].paint[hit.quad]];
            const Vec3f there = at + out * hit.distance;
            const Vec3f albedo = p.finish == Finish::ground ? world.ground(there, 0.3f) : p.albedo;
            seen = albedo * irradiance(there, hit.normal, random) * (1 / kPi);
        }
        return seen * mirror + behind_glass(at, normal, direction) * (1 - mirror);
    }

    // Brightness of the glitter, as a share of the sun's irradiance, without an edge where it saturates.
    static float rolled_off(float share) {
        constexpr float kMost = 2.2f;
        return share / (1 + share / kMost);
    }

    Vec3f water(Vec3f at, Vec3f direction, float distance, float width, Random& random) const {
        // Waves as slopes: resolved ones nearby, and beyond the sample's width a mean roughness.
        const float footprint = distance * width / std::max(0.02f, -direction.y);
        Vec2f slope{};
        float rough = 0.0006f;
        float size = 1 / 9.f, steep = 0.055f;
        for (std::uint32_t k = 0; k < 6; ++k, size *= 2.1f, steep *= 0.92f) {
            const float fade = detail_fade(footprint * 0.6f, 1 / size);
            rough += 0.09f * steep * steep * (1 - fade) * 4;
            if (!(fade > 0)) continue;
            const Vec2f p{at.x * size + 3.1f * static_cast<float>(k), 0.6f * at.z * size};
            const float e = 0.2f, here = noise2(p, sky.seed + 50 + k);
            slope.x += fade * steep * (noise2({p.x + e, p.y}, sky.seed + 50 + k) - here) / e;
            slope.y += fade * steep * (noise2({p.x, p.y + e}, sky.seed + 50 + k) - here) / e;
        }
        slope.x += std::sqrt(rough) * random.normal() * 0.7f, slope.y += std::sqrt(rough) * random.normal() * 0.7f;
        Vec3f n = normalize(Vec3f{-slope.x, 1, -slope.y});
        if (dot(n, direction) > -0.015f) n = normalize(n - direction * (dot(n, direction) + 0.03f));
        const float c = std::clamp(-dot(n, direction), 0.f, 1.f), mirror = 0.02f + 0.98f * std::pow(1 - c, 5.f);
        Vec3f out = direction - n * (2 * dot(n, direction));
        out.y = std::max(0.02f, out.y);
        out = normalize(out);
        Vec3f reflected = dome.at(flipped(out));
        // The sun's glitter.
        if (luminance(sky.sun_irradiance) > 0) {
            const Vec3f half = normalize(to_sun - direction);
            const float spread = rough + 0.003f, tan2 = (1 - half.y * half.y) / std::max(0.02f, half.y * half.y);
            const float dots = smooth_step(0.5f, 0.8f, noise2({at.x * 1.7f, at.z * 1.7f}, sky.seed + 60)) * 2.2f;
            const float shine = std::exp(-tan2 / spread) / (kPi * spread * 4 * std::max(0.06f, -direction.y));
            reflected += sky.sun_irradiance * rolled_off(shine * mix(1.f, dots, detail_fade(footprint, 0.6f)) * 0.25f);
        }
        const Vec3f deep = world.paints[kWater].albedo * sunny * (1 / kPi);
        // Slopes that face the viewer are seen more than their share, which the mean roughness leaves out.
        constexpr float kFacing = 0.72f;
        return reflected * (mirror * kFacing) + deep * (1 - mirror * kFacing);
    }

    Vec3f facade(Vec3f at, Vec3f normal, Vec3f direction, Vec3f wall, float footprint, Random& random) const {
        if (normal.y > 0.5f) return wall * 0.6f * irradiance(at, normal, random) * (1 / kPi);
        constexpr float kBay_m = 2.9f, kStorey_m = 3.3f;
        const float u = dot(at, normalize(cross(Vec3f{0, 1, 0}, normal))) / kBay_m, v = at.y / kStorey_m;
        const int i = floor_int(u), j = floor_int(v);
        const float x = u - static_cast<float>(i), y = v - static_cast<float>(j);
        const Vec3f lit = wall * irradiance(at, normal, random) * (1 / kPi);
        const bool window = x > 0.2f && x < 0.82f && y > 0.22f && y < 0.82f;
        if (!window || footprint > 4 * kBay_m) return lit;
        const Vec3f mirrored = dome.air(
            flipped(normalize(direction - normal * (2 * dot(normal, direction)) + Vec3f{0, 0.3f, 0})));
        const float own = lattice_unit(i, j, static_cast<int>(dot(at, normal)), sky.seed);
        if (dark && own > 0.62f) return Vec3f{0.5f, 0.34f, 0.17f} * (0.18f + 0.5f * (own - 0.62f));
        return mirrored * (0.12f + 0.22f * own) + lit * 0.08f;
    }

    Vec3f shaded(const Hit& hit, Vec3f origin, Vec3f direction, float width, Random& random) const {
        const Vec3f at = origin + direction * hit.distance;
        const Instance& instance = world.instances[hit.instance];
        const Paint& paint = world.paints[world.meshes[hit.mesh].paint[hit.quad]];
        const Vec3f tint = paint.tinted ? instance.tint : Vec3f{1, 1, 1};
        const float footprint = hit.distance * width;
        switch (paint.finish) {
            case Finish::glass: return glass(at, hit.normal, direction, random);
            case Finish::water: return water(at, direction, hit.distance, width, random);
            case Finish::light:
                return dark ? paint.albedo * (sky.time == Sky::Time::night ? 1.2f : 2.f)
                            : paint.albedo * sunny * (0.6f / kPi);
            case Finish::facade: return facade(at, hit.normal, direction, paint.albedo, footprint, random);
            case Finish::ground: {
                // Seen at a slant, a sample covers more; the geometric mean keeps some detail.
                const float slant = std::max(0.02f, std::abs(dot(hit.normal, direction)));
                const Vec3f up = hit.normal.y > 0 ? hit.normal : -hit.normal;
                return world.ground(at, footprint / std::sqrt(slant)) * irradiance(at, up, random) * (1 / kPi);
            }
            case Finish::matt:
            case Finish::leaf: break;
        }
        Vec3f albedo = paint.albedo * tint, through = paint.through * tint;
        if (paint.mottle > 0) {
            const float stain = fbm3(at * 1.3f, 4, footprint * 1.3f, sky.seed + 70);
            albedo = albedo * (1 + paint.mottle * 2 * (stain - 0.5f));
        }
        // Snow lies on what faces up.
        if (sky.snow && paint.takes_snow) {
            const bool leaf = paint.finish == Finish::leaf;
            const float lies = (leaf ? 0.7f : 1.f) *
                               smooth_step(leaf ? 0.f : 0.25f, leaf ? 1.f : 0.6f,
                                           std::abs(hit.normal.y) + 0.25f * (noise3(at * 3.f, sky.seed + 71) - 0.5f)) *
                               (hit.normal.y > 0 || leaf ? 1.f : 0.f);
            albedo = lerp(albedo, {0.76f, 0.78f, 0.82f}, lies), through = through * (1 - lies);
        }
        Vec3f out{};
        if (paint.finish == Finish::leaf) {
            out = sheet(at, hit.normal, albedo, through, random);
            // Waxy: near the mirror direction a leaf shows the sky.
            const Vec3f mirrored = normalize(direction - hit.normal * (2 * dot(hit.normal, direction)));
            constexpr float kWaxy = 0.03f;  // needles and dry grass let less light through, and do not shine
            if (mirrored.y > 0 && !sky.snow && through.y > kWaxy) {
                const float c = std::clamp(-dot(hit.normal, direction), 0.f, 1.f);
                out += dome.air(flipped(mirrored)) * (0.3f * (0.025f + 0.12f * std::pow(1 - c, 5.f)));
            }
            return out;
        }
        return albedo * irradiance(at, hit.normal, random) * (1 / kPi);
    }
};

Tracer::Tracer(const Sky& sky, World world) : dome_(sky), impl_(std::make_unique<Impl>(sky, std::move(world), dome_)) {}
Tracer::~Tracer() = default;

Tracer::Sample Tracer::sample(Vec3f direction, float width, Random& random) const {
    const Vec3f way = flipped(direction);
    const Vec3f eye{0, impl_->world.eye_m, 0};
    const Hit hit = impl_->first_hit(eye, way);
    if (!(hit.distance < kFar)) return {dome_.at(direction), true};
    return {impl_->haze(way, impl_->shaded(hit, eye, way, width, random), hit.distance), false};
}

float Tracer::distance(Vec3f direction) const {
    return impl_->first_hit({0, impl_->world.eye_m, 0}, flipped(direction)).distance;
}

}  // namespace fastscene::outdoors
