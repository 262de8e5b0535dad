// Rays against the room's triangles (bvh.h).
const int kMostLevels = 40;  // kMostBvhLevels

struct Hit {
    float distance;  // kFar: none
    uint place;      // of the triangle in the tree; kNone: none
    float u, v;      // weights of its second and third corner
};

// Edges are tested by signed volumes with the ray, which two triangles compute alike for the edge they share: rays
// cannot slip through.
void meet_triangle(World w, uint place, vec3 origin, vec3 direction, uint kind, inout Hit hit) {
    const vec4 r0 = w.triangles.at[3 * place], r1 = w.triangles.at[3 * place + 1], r2 = w.triangles.at[3 * place + 2];
    if ((kind & kLit) != 0 && floatBitsToUint(r2.w) != 0) return;
    const vec3 a = r0.xyz - origin, b = vec3(r0.w, r1.xy) - origin, c = vec3(r1.zw, r2.x) - origin;
    const float of_a = dot(cross(c - b, b + c), direction), of_b = dot(cross(a - c, c + a), direction),
                of_c = dot(cross(b - a, a + b), direction), sum = of_a + of_b + of_c, slack = 1.2e-7 * abs(sum);
    if (!(min(of_a, min(of_b, of_c)) >= -slack || max(of_a, max(of_b, of_c)) <= slack)) return;
    const vec3 normal = cross(b - a, c - a);
    const float facing = dot(normal, direction);
    if (facing == 0 || sum == 0) return;
    const float far = dot(a, normal) / facing;
    if (far >= 0 && far < hit.distance) hit = Hit(far, place, of_b / sum, of_c / sum);
}

// The nearest hit before `far`; of kind kAny: any.
Hit trace_ray(World w, vec3 origin, vec3 direction, float far, uint kind) {
    Hit hit = Hit(far, kNone, 0, 0);
    const vec3 safe = mix(direction, vec3(1e-20), lessThan(abs(direction), vec3(1e-20))), inverse = 1 / safe;
    const bvec3 forward = greaterThanEqual(safe, vec3(0));
    const uint octant = (forward.x ? 4 : 0) | (forward.y ? 2 : 0) | (forward.z ? 1 : 0);
    uvec2 stack[kMostLevels];
    int top = 0;
    // Nodes still to be visited: the first of the siblings; which of them, in the order of visits from the highest bit
    // down, and in the lowest byte which slots hold nodes.
    uvec2 group = uvec2(0, 0x80000000u);
    for (;;) {
        const uint bit = findMSB(group.y), rest = group.y & ~(1u << bit);
        if ((rest & 0xff000000u) != 0) stack[top++] = uvec2(group.x, rest);
        const uint slot = (bit - 24) ^ octant;
        const uint node = 5 * (group.x + bitCount(group.y & ((1u << slot) - 1)));
        const uvec4 n0 = w.nodes.at[node], n1 = w.nodes.at[node + 1], n2 = w.nodes.at[node + 2],
                    n3 = w.nodes.at[node + 3], n4 = w.nodes.at[node + 4];
        const vec3 scale = uintBitsToFloat(uvec3(n0.w & 255, n0.w >> 8 & 255, n0.w >> 16 & 255) << 23) * inverse,
                   base = (uintBitsToFloat(n0.xyz) - origin) * inverse;
        uint hits = 0;
        [[unroll]] for (int part = 0; part < 2; ++part) {
            const uint meta = part == 0 ? n1.z : n1.w;
            const uint low_x = part == 0 ? n2.x : n2.y, low_y = part == 0 ? n2.z : n2.w,
                       low_z = part == 0 ? n3.x : n3.y, high_x = part == 0 ? n3.z : n3.w,
                       high_y = part == 0 ? n4.x : n4.y, high_z = part == 0 ? n4.z : n4.w;
            const uvec3 low = uvec3(low_x, low_y, low_z), high = uvec3(high_x, high_y, high_z),
                        near = mix(high, low, forward), away = mix(low, high, forward);
            [[unroll]] for (int k = 0; k < 4; ++k) {
                const uint m = meta >> (8 * k) & 255;
                const vec3 enter = vec3(near >> (8 * k) & 255) * scale + base,
                           leave = vec3(away >> (8 * k) & 255) * scale + base;
                const float first = max(max(enter.x, enter.y), max(enter.z, 0)),
                            last = min(min(leave.x, leave.y), min(leave.z, hit.distance));
                if (m != 0 && first <= last)
                    hits |= (m >> 5) << ((m & 0x18) == 0x18 ? (m & 31) ^ octant : m & 31);
            }
        }
        for (uint found = hits & 0x00ffffffu; found != 0; found &= found - 1) {
            meet_triangle(w, n1.y + findLSB(found), origin, direction, kind, hit);
            if ((kind & kAny) != 0 && hit.place != kNone) return hit;
        }
        if ((hits & 0xff000000u) != 0) group = uvec2(n1.x, (hits & 0xff000000u) | n0.w >> 24);
        else if (top == 0) break;
        else group = stack[--top];
    }
    if (hit.place == kNone) hit.distance = kFar;
    return hit;
}
bool is_blocked(World w, vec3 origin, vec3 direction, float far) {
    return trace_ray(w, origin, direction, far, kLit | kAny).place != kNone;
}
