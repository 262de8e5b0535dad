// Surface attributes at a hit (trace/surface.cc).
struct HitSurface {
    uint triangle, mesh;  // id; index into Room::meshes
    vec3 normal;          // unit, by the winding order
    bool back;            // hit from behind
};
HitSurface hit_surface(World w, Hit hit, vec3 direction) {
    const vec4 r0 = w.triangles.at[3 * hit.place], r1 = w.triangles.at[3 * hit.place + 1],
               r2 = w.triangles.at[3 * hit.place + 2];
    const vec3 a = r0.xyz, b = vec3(r0.w, r1.xy), c = vec3(r1.zw, r2.x);
    const vec3 normal = normalize(cross(b - a, c - a));
    return HitSurface(floatBitsToUint(r2.y), floatBitsToUint(r2.z), normal, dot(normal, direction) > 0);
}

vec3 normalized(vec3 v) {
    const float l = length(v);
    return l > 0 ? v / l : v;
}

struct Corner {
    uint a, b, c;  // vertices
    float wa, wb, wc;
};
Corner corner_of(World w, Hit hit, uint triangle) {
    const uvec4 v = w.corners.at[triangle];
    return Corner(v.x, v.y, v.z, 1 - hit.u - hit.v, hit.u, hit.v);
}
vec3 vertex_row(World w, uint vertex, uint row) { return w.vertices.at[3 * vertex + row].xyz; }
vec3 blended(World w, Corner k, uint row) {
    return vertex_row(w, k.a, row) * k.wa + vertex_row(w, k.b, row) * k.wb + vertex_row(w, k.c, row) * k.wc;
}
vec3 shading_normal(World w, Corner k, vec3 flat_normal) {
    const vec3 n = normalized(blended(w, k, 1));
    return dot(n, flat_normal) > 0.1f ? n : flat_normal;
}

struct SurfacePoint {
    vec3 position, normal, bumped;
    TextureValue texture;
    bool back;
};
SurfacePoint surface_at(World w, Material m, Hit hit, HitSurface on, vec3 origin, vec3 direction, float footprint_m,
                        bool relief) {
    const Corner k = corner_of(w, hit, on.triangle);
    SurfacePoint s;
    s.position = origin + direction * hit.distance;
    s.back = on.back;
    s.normal = shading_normal(w, k, on.normal);
    if (s.back) s.normal = -s.normal;
    const vec3 ca = vertex_row(w, k.a, 2), cb = vertex_row(w, k.b, 2), cc = vertex_row(w, k.c, 2);
    TexturePoint p;
    p.coords = ca * k.wa + cb * k.wb + cc * k.wc;
    const int axis = dominant_axis(cross(cb - ca, cc - ca));
    p.plane = flat_coords(p.coords, axis);
    p.footprint_m = footprint_m;
    const SurfaceTexture t = texture_with_slope(m, p, axis, relief);
    s.texture = t.value;
    s.bumped = s.normal;
    if (t.slope.x == 0 && t.slope.y == 0) return s;
    // The slope along the flat coordinates, in the world.
    const vec3 a = vertex_row(w, k.a, 0), p1 = vertex_row(w, k.b, 0) - a, p2 = vertex_row(w, k.c, 0) - a;
    const vec2 q0 = flat_coords(ca, axis), q1 = flat_coords(cb, axis) - q0, q2 = flat_coords(cc, axis) - q0;
    const float det = q1.x * q2.y - q1.y * q2.x;
    if (!(abs(det) > 1e-12f)) return s;
    const vec3 du = normalized((p1 * q2.y - p2 * q1.y) / det), dv = normalized((p2 * q1.x - p1 * q2.x) / det);
    const vec3 n = normalized(s.normal - du * t.slope.x - dv * t.slope.y);
    if (dot(n, direction) < -0.02f) s.bumped = n;
    return s;
}
