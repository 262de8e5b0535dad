#include "fastscene/trace/surface.h"

#include <cmath>

namespace fastscene {
namespace {

struct Corner {
    std::size_t a, b, c;
    float wa, wb, wc;
};
Corner corners(const Mesh& mesh, const RayHit& hit) {
    const std::size_t t = 3 * static_cast<std::size_t>(hit.triangle);
    return {mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2], 1.f - hit.u - hit.v, hit.u, hit.v};
}
Vec3f blend(const std::vector<Vec3f>& values, const Corner& k) {
    return values[k.a] * k.wa + values[k.b] * k.wb + values[k.c] * k.wc;
}

// World-space gradients, within the triangle, of the two flat coordinates of the pattern.
void pattern_axes(const Mesh& mesh, const Corner& k, int axis, Vec3f& du, Vec3f& dv) {
    const Vec3f p1 = mesh.positions[k.b] - mesh.positions[k.a], p2 = mesh.positions[k.c] - mesh.positions[k.a];
    const Vec2f q0 = flat_coords(mesh.coords[k.a], axis), q1 = flat_coords(mesh.coords[k.b], axis) - q0,
                q2 = flat_coords(mesh.coords[k.c], axis) - q0;
    const float det = q1.x * q2.y - q1.y * q2.x;
    du = dv = {};
    if (!(std::abs(det) > 1e-12f)) return;
    du = normalize((p1 * q2.y - p2 * q1.y) / det);
    dv = normalize((p2 * q1.x - p1 * q2.x) / det);
}

}  // namespace

Vec3f shading_normal(const Mesh& mesh, const RayHit& hit) {
    const Vec3f n = normalize(blend(mesh.normals, corners(mesh, hit)));
    // A shading normal that disagrees with its triangle is a modelling error: use the triangle's.
    return dot(n, hit.normal) > 0.1f ? n : hit.normal;
}

SurfacePointInfo surface_at(const Room& room, const RayHit& hit, Vec3f origin, Vec3f direction, float footprint_m,
                            bool with_relief) {
    const Mesh& mesh = room.meshes[static_cast<std::size_t>(hit.mesh)];
    const Corner k = corners(mesh, hit);
    SurfacePointInfo s;
    s.position = origin + direction * hit.distance;
    s.back = hit.back;
    s.normal = shading_normal(mesh, hit);
    if (s.back) s.normal = -s.normal;
    s.material = &room.materials[static_cast<std::size_t>(mesh.material)];

    TexturePoint point;
    point.coords = blend(mesh.coords, k);
    const Vec3f coords_normal = cross(mesh.coords[k.b] - mesh.coords[k.a], mesh.coords[k.c] - mesh.coords[k.a]);
    const int axis = dominant_axis(coords_normal);
    point.plane = flat_coords(point.coords, axis);
    point.footprint_m = footprint_m;
    s.texture = sample_texture(*s.material, point);
    s.bumped = s.normal;
    const bool is_uneven = s.material->bump_m > 0.f || s.material->crease_m > 0.f || s.material->normals;
    if (!with_relief || !is_uneven) return s;
    const Vec2f slope = texture_with_slope(*s.material, point, axis, true).slope;
    if (slope.x == 0.f && slope.y == 0.f) return s;
    Vec3f du, dv;
    pattern_axes(mesh, k, axis, du, dv);
    const Vec3f n = normalize(s.normal - du * slope.x - dv * slope.y);
    if (dot(n, direction) < -0.02f) s.bumped = n;
    return s;
}

}  // namespace fastscene
