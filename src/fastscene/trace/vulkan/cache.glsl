// The irradiance cache and estimates from it (trace/irradiance.cc, irradiance_estimate.cc).
const float kNearSun = 8, kShort = 0.9999;

struct Entry {
    vec3 light, sun, normal, center, gradient;
    float trust;
};
Entry cache_entry(World w, int c) {
    const vec4 a = w.cells.at[4 * c], b = w.cells.at[4 * c + 1], d = w.cells.at[4 * c + 2], e = w.cells.at[4 * c + 3];
    return Entry(a.xyz, vec3(a.w, b.xy), vec3(b.zw, d.x), d.yzw, e.xyz, e.w);
}

int facing_of(vec3 n) {
    const vec3 a = abs(n);
    if (a.x >= a.y && a.x >= a.z) return n.x > 0 ? 0 : 1;
    if (a.y >= a.z) return n.y > 0 ? 2 : 3;
    return n.z > 0 ? 4 : 5;
}
uvec2 key_of(ivec3 cell, int facing) {
    const uvec3 p = uvec3(cell + (1 << 18)) & 0xfffffu;
    return uvec2(p.y << 23 | p.z << 3 | uint(facing), p.x << 11 | p.y >> 9);
}
int find_entry(World w, ivec3 cell, int facing) {
    const uvec2 key = key_of(cell, facing);
    for (uint slot = mix64(key).x & w.slot_mask;; slot = (slot + 1) & w.slot_mask) {
        const uvec4 s = w.slots.at[slot];
        if (s.z == 0) return -1;
        if (s.xy == key) return int(s.z) - 1;
    }
}
void consider_entry(World w, ivec3 cell, int facing, vec3 position, vec3 normal, float least, inout int best,
                    inout float best_far) {
    const int c = find_entry(w, cell, facing);
    if (c < 0) return;
    const Entry e = cache_entry(w, c);
    const float agree = dot(e.normal, normal), far = length(e.center - position) + world_cache(w).w * (1 - agree) * 2;
    if (agree > least && far < best_far) best_far = far, best = c;
}
// The entry whose surface contains the point, or else the nearest around it with the same facing.
int nearest_entry(World w, vec3 position, vec3 normal) {
    const vec4 cache = world_cache(w);
    const ivec3 at = ivec3(floor((position - cache.xyz) / cache.w));
    const int facing = facing_of(normal), c = find_entry(w, at, facing);
    if (c >= 0) return c;
    int best = -1;
    float best_far = 1e9f;
    // Candidates 0-5: the other facings here; 6-11: the six neighbours, -x -y -z +x +y +z; from 12 on: all 162.
    for (int k = 0; k < 12 + 162; ++k) {
        if (k == 12 && best >= 0) return best;
        ivec3 cell = at;
        int f = facing;
        if (k < 6) f = k;
        else if (k < 12) {
            const int axis = (k - 6) % 3, d = k < 9 ? -1 : 1;
            cell += ivec3(axis == 0 ? d : 0, axis == 1 ? d : 0, axis == 2 ? d : 0);
        } else {
            const int n = k - 12, place = n / 6;
            f = n % 6;
            cell += ivec3(place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1);
        }
        consider_entry(w, cell, f, position, normal, k < 12 ? 0.6f : 0.2f, best, best_far);
    }
    return best;
}

struct Near {
    vec3 light, sun;
};
Near near_light(World w, vec3 position, vec3 normal) {
    const int c = nearest_entry(w, position, normal);
    if (c < 0) return Near(vec3(0), vec3(0));
    const vec4 a = w.cells.at[4 * c], b = w.cells.at[4 * c + 1];
    return Near(a.xyz, vec3(a.w, b.xy));
}

struct Reading {
    vec3 irradiance, sun, direction;
    float trust;
};
Reading read_cache(World w, vec3 position, vec3 normal) {
    const vec4 cache = world_cache(w);
    const vec3 q = (position - cache.xyz) / cache.w - 0.5f, low = floor(q), f = q - low;
    const ivec3 at = ivec3(low);
    Reading sum = Reading(vec3(0), vec3(0), vec3(0), 0);
    float weight = 0;
    for (int k = 0; k < 24; ++k) {
        const int axis = k >> 3;
        const float along = axis == 0 ? normal.x : axis == 1 ? normal.y : normal.z, share = along * along;
        if (share < 0.12f) continue;
        const ivec3 step = ivec3(k & 1, k >> 1 & 1, k >> 2 & 1);
        const int c = find_entry(w, at + step, 2 * axis + (along > 0 ? 0 : 1));
        if (c < 0) continue;
        const Entry e = cache_entry(w, c);
        const float aside = dot(e.center - position, e.normal) / (0.2f * cache.w);
        const float same = 1 / (1 + aside * aside * aside * aside);
        const vec3 weights = mix(1 - f, f, notEqual(step, ivec3(0)));
        const float near = weights.x * weights.y * weights.z;
        const float v = share * same * near * max(0.02f, dot(e.normal, normal)) + 1e-6f * share;
        sum.irradiance += e.light * v;
        sum.sun += e.sun * v;
        sum.direction += e.gradient * v;
        weight += v;
        sum.trust += v * same * e.trust;
    }
    if (weight > 0)
        return Reading(sum.irradiance / weight, sum.sun / weight, sum.direction / weight, sum.trust / weight);
    const int c = nearest_entry(w, position, normal);
    if (c < 0) return sum;
    const Entry e = cache_entry(w, c);
    return Reading(e.light, e.sun, e.gradient, 0);
}
float relief_light(vec3 gradient, vec3 normal, vec3 bumped) {
    return clamp(1 + dot(bumped - normal, gradient), 0.25f, 2.f);
}

// A material as bounced light sees it, with textures averaged out.
struct Bouncing {
    vec3 reflectance, emission;
    float transmission;
    Coat coat;
};
Bouncing bouncing_of(World w, uint material) {
    const vec4 a = w.coats.at[4 * material], b = w.coats.at[4 * material + 1], c = w.coats.at[4 * material + 2],
               d = w.coats.at[4 * material + 3];
    return Bouncing(a.xyz, d.xyz, a.w, Coat(b.xyz, c.xyz, b.w, c.w));
}
float distance_epsilon(vec3 p) { return 1e-4f + 2e-5f * (abs(p.x) + abs(p.y) + abs(p.z)); }

// What arrives along a ray if nothing is in between.
struct ShadowRay {
    vec3 origin, direction;
    float far;
    vec3 irradiance;
};
ShadowRay no_ray() { return ShadowRay(vec3(0), vec3(0), 0, vec3(0)); }

// Lights::sample.
ShadowRay ask_lamps(World w, vec3 position, vec3 normal, float which, vec2 uv) {
    const LightSample light = draw_light(w, position, normal, which, uv);
    const float here = dot(normal, light.direction);
    if (!(light.pdf > 0 && here > 0)) return no_ray();
    const float near = light.far < kNearest ? light.far * light.far / (kNearest * kNearest) : 1;
    return ShadowRay(position + normal * kSurfaceOffset, light.direction, light.far,
                     light.radiance * (here * near / light.pdf));
}
// IrradianceCache::sunlit: a sunlit patch, sampled by its power and visibility.
ShadowRay ask_sunlit(World w, vec3 position, vec3 normal, float which) {
    if (w.patches == 0) return no_ray();
    const float all = w.sun_powers.at[w.patches - 1], drawn = which * all;
    if (!(all > 0)) return no_ray();
    uint low = 0, high = w.patches;  // the first power above `drawn`
    while (low < high) {
        const uint middle = (low + high) / 2;
        if (w.sun_powers.at[middle] > drawn) high = middle;
        else low = middle + 1;
    }
    const uint found = min(low, w.patches - 1);
    const float below = found > 0 ? w.sun_powers.at[found - 1] : 0,
                share = (drawn - below) / max(1e-30f, w.sun_powers.at[found] - below);
    const vec4 a = w.sun_patches.at[2 * found], b = w.sun_patches.at[2 * found + 1];
    const uint count = floatBitsToUint(b.y),
               place = floatBitsToUint(b.x) + min(count - 1, uint(max(0, share) * float(count)));
    const vec4 there_at = w.sun_places.at[2 * place], there_normal = w.sun_places.at[2 * place + 1];
    const vec3 from = position + normal * distance_epsilon(position), to = there_at.xyz - from;
    const float d2 = dot(to, to), far = sqrt(d2);
    if (!(far > kNearSun * world_cache(w).w)) return no_ray();
    const vec3 direction = to / far;
    const float here = dot(normal, direction), there = -dot(there_normal.xyz, direction);
    if (!(here > 0 && there > 0)) return no_ray();
    const Bouncing m = bouncing_of(w, floatBitsToUint(there_at.w));
    const vec3 reflected = sun_reflected(world_sun(w).xyz, m.reflectance, m.coat, m.transmission, there_normal.xyz,
                                         direction, floatBitsToUint(b.w) != 0);
    return ShadowRay(from, direction, far * kShort, a.xyz * reflected * (here * there / d2 * a.w * all / b.z));
}

struct Bounce {
    vec3 irradiance, direction;
    float distance;
    bool buried;
};
// IrradianceCache::bounced, of a ray that met `hit`.
Bounce bounce_of(World w, Hit hit, vec3 from, vec3 direction) {
    if (hit.place == kNone) return Bounce(vec3(0), vec3(0), kFar, false);  // counted with the windows
    const HitSurface on = hit_surface(w, hit, direction);
    const uvec4 mesh = w.meshes.at[on.mesh];
    if (on.back && (mesh.y & kClosed) != 0) return Bounce(vec3(0), direction, hit.distance, true);
    const vec3 p = from + direction * hit.distance;
    vec3 normal = shading_normal(w, corner_of(w, hit, on.triangle), on.normal);
    if (on.back) normal = -normal;
    const Bouncing m = bouncing_of(w, mesh.x);
    Near both[2] = Near[2](Near(vec3(0), vec3(0)), Near(vec3(0), vec3(0)));
    const int sides = m.transmission > 0 ? 2 : 1;
    for (int side = 0; side < sides; ++side) both[side] = near_light(w, p, side == 0 ? normal : -normal);
    vec3 irradiance = m.reflectance * (both[0].light * (1 - m.transmission) + both[1].light * m.transmission);
    if (hit.distance <= kNearSun * world_cache(w).w) {
        const vec3 sun = world_sun(w).xyz;
        for (int side = 0; side < sides; ++side)
            irradiance += both[side].sun * kPi *
                          sun_reflected(sun, m.reflectance, m.coat, m.transmission, normal, direction, side == 1);
    }
    if ((mesh.y & kLarge) != 0) irradiance += m.emission * kPi;
    return Bounce(irradiance, direction, hit.distance, false);
}
