#include "fastscene/trace/scene_bvh.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/isa.h"
#include "fastscene/trace/response.h"

namespace fastscene {
namespace {

Vec3f position(const Mesh& mesh, std::size_t triangle, std::size_t corner) {
    return mesh.positions[mesh.triangles[3 * triangle + corner]];
}

// The point of triangle abc nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3f nearest_on_triangle(Vec3f p, Vec3f a, Vec3f b, Vec3f c) {
    const Vec3f ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const float d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
                d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) return a;
    if (d3 >= 0 && d4 <= d3) return b;
    if (d6 >= 0 && d5 <= d6) return c;
    const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const float sum = va + vb + vc;
    return sum > 0 ? a + ab * (vb / sum) + ac * (vc / sum) : a;
}

using Corners = std::vector<std::array<Vec3f, 3>>;  // the triangles of one mesh

struct NearestQuery {
    const std::vector<Corners>* meshes;
    Vec3f point;
    float best;
};

bool visit_triangle(RTCPointQueryFunctionArguments* args) {
    auto* query = static_cast<NearestQuery*>(args->userPtr);
    const auto& t = (*query->meshes)[args->geomID][args->primID];
    const float far = length(query->point - nearest_on_triangle(query->point, t[0], t[1], t[2]));
    if (far >= query->best) return false;
    query->best = args->query->radius = far;
    return true;
}

constexpr float kBeyondGlass_m = 1e-4f;

}  // namespace

const char* embree_settings() { return isa() == Isa::sse4 ? "max_isa=sse42" : "max_isa=avx2"; }

struct SceneBvh::Impl {
    RTCDevice device = nullptr;
    // Two trees over the same triangles: rays are twice as fast in a tree that need not be watertight, but one aimed at
    // an edge may then slip through. A third tree omits clear glass and flames, if there are any: that is what light
    // interacts with.
    RTCScene scene = nullptr, watertight = nullptr, lit = nullptr;
    std::vector<Corners> meshes;
    std::vector<bool> clear;  // by mesh
    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        if (watertight) rtcReleaseScene(watertight);
        if (lit) rtcReleaseScene(lit);
        if (device) rtcReleaseDevice(device);
    }
    RayHit first(RTCScene among, Vec3f origin, Vec3f direction, float near_m, float far_m) const;
};

SceneBvh::SceneBvh(const Room& room) : impl_(std::make_unique<Impl>()) {
    // No thread count here: Embree would set it for the whole process, as it shares oneTBB with us.
    impl_->device = rtcNewDevice(embree_settings());
    if (!impl_->device)
        throw Error("Embree: expected a ray tracing device, found error {}",
                    static_cast<int>(rtcGetDeviceError(nullptr)));
    impl_->scene = rtcNewScene(impl_->device);
    impl_->watertight = rtcNewScene(impl_->device);
    rtcSetSceneFlags(impl_->watertight, RTC_SCENE_FLAG_ROBUST);
    for (const Mesh& mesh : room.meshes)
        impl_->clear.push_back(lets_light_pass(room.materials[static_cast<std::size_t>(mesh.material)]));
    if (std::find(impl_->clear.begin(), impl_->clear.end(), true) != impl_->clear.end()) {
        impl_->lit = rtcNewScene(impl_->device);
    } else {
        impl_->lit = impl_->scene;
        rtcRetainScene(impl_->lit);
    }
    for (RTCScene scene : {impl_->scene, impl_->watertight, impl_->lit})
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    impl_->meshes.resize(room.meshes.size());
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const Mesh& mesh = room.meshes[m];
        const std::size_t count = mesh.triangles.size() / 3;
        RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                      RTC_FORMAT_FLOAT3, sizeof(Vec3f),
                                                                      std::max<std::size_t>(1, mesh.positions.size())));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, std::max<std::size_t>(1, count)));
        if (!positions || !indices) throw Error("Embree: expected memory for {} triangles, found none", count);
        positions[0] = {};
        indices[0] = indices[1] = indices[2] = 0;
        std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
        std::copy(mesh.triangles.begin(), mesh.triangles.end(), indices);
        rtcCommitGeometry(geometry);
        for (RTCScene scene : {impl_->scene, impl_->watertight})
            rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(m));
        if (impl_->lit != impl_->scene && !impl_->clear[m])
            rtcAttachGeometryByID(impl_->lit, geometry, static_cast<unsigned>(m));
        rtcReleaseGeometry(geometry);
        for (std::size_t t = 0; t < count; ++t)
            impl_->meshes[m].push_back({position(mesh, t, 0), position(mesh, t, 1), position(mesh, t, 2)});
        if (count == 0) impl_->meshes[m].push_back({});
    }
    for (RTCScene scene : {impl_->scene, impl_->watertight}) rtcCommitScene(scene);
    if (impl_->lit != impl_->scene) rtcCommitScene(impl_->lit);
}
SceneBvh::~SceneBvh() = default;

RayHit SceneBvh::Impl::first(RTCScene among, Vec3f origin, Vec3f direction, float near_m, float far_m) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray = {origin.x, origin.y, origin.z, near_m, direction.x, direction.y, direction.z, 0.f, far_m, ~0u, 0u, 0u};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(among, &context, &ray);
    // Few rays leave a room; those that seem to may have slipped through an edge, so they are traced again in the
    // watertight tree.
    const auto none = [&] { return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID; };
    if (none()) {
        rtcIntersect1(watertight, &context, &ray);
        // The watertight tree contains what lets light pass, so hits on it are skipped.
        while (among == lit && among != scene && !none() && clear[ray.hit.geomID]) {
            ray.ray.tnear = ray.ray.tfar + kBeyondGlass_m;
            ray.ray.tfar = far_m;
            ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(watertight, &context, &ray);
        }
    }
    RayHit hit;
    if (none()) return hit;
    hit.distance = ray.ray.tfar;
    hit.mesh = static_cast<int>(ray.hit.geomID);
    hit.triangle = static_cast<int>(ray.hit.primID);
    hit.u = ray.hit.u;
    hit.v = ray.hit.v;
    hit.normal = normalize(Vec3f{ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z});
    hit.back = dot(hit.normal, direction) > 0;
    return hit;
}

RayHit SceneBvh::first_hit(Vec3f origin, Vec3f direction, float near_m, float far_m) const {
    return impl_->first(impl_->scene, origin, direction, near_m, far_m);
}

RayHit SceneBvh::first_lit(Vec3f origin, Vec3f direction) const {
    return impl_->first(impl_->lit, origin, direction, 0.f, kFar);
}

bool SceneBvh::blocked(Vec3f origin, Vec3f direction, float near_m, float far_m) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{origin.x, origin.y, origin.z, near_m, direction.x, direction.y, direction.z, 0.f, far_m, ~0u, 0u, 0u};
    rtcOccluded1(impl_->lit, &context, &ray);
    return ray.tfar < 0;
}

float SceneBvh::nearest(Vec3f point, float limit) const {
    NearestQuery state{&impl_->meshes, point, limit};
    RTCPointQuery query{point.x, point.y, point.z, 0.f, limit};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(impl_->scene, &query, &context, visit_triangle, &state);
    return state.best;
}

bool is_closed(const Mesh& mesh) {
    // Vertices are merged by position, to a tenth of a millimetre, regardless of their normals.
    std::vector<std::array<std::int32_t, 3>> places;
    for (const Vec3f p : mesh.positions)
        places.push_back({static_cast<std::int32_t>(std::lround(p.x * 1e4f)),
                          static_cast<std::int32_t>(std::lround(p.y * 1e4f)),
                          static_cast<std::int32_t>(std::lround(p.z * 1e4f))});
    std::vector<std::array<std::int32_t, 3>> unique = places;
    std::sort(unique.begin(), unique.end());
    unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
    std::vector<std::uint32_t> id(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        id[i] = static_cast<std::uint32_t>(std::lower_bound(unique.begin(), unique.end(), places[i]) - unique.begin());
    std::vector<std::uint64_t> edges, reversed;
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = id[mesh.triangles[t + k]], b = id[mesh.triangles[t + (k + 1) % 3]];
            if (a == b) continue;
            edges.push_back(a << 32 | b);
            reversed.push_back(b << 32 | a);
        }
    std::sort(edges.begin(), edges.end());
    std::sort(reversed.begin(), reversed.end());
    return !edges.empty() && edges == reversed;
}

}  // namespace fastscene
