// Lamps, windows and the sun (trace/light_tree.cc, lights.cc).
const float kSunRadius = 0.008, kNearest = 0.03;
const uint kMostHeads = 32;

struct LightNode {
    vec3 center, extent, axis;
    float radius, power, cosine, sine;
    bool two_sided;
    int emitter, second;
};
LightNode light_node(World w, uint i) {
    const vec4 a = w.light_nodes.at[4 * i], b = w.light_nodes.at[4 * i + 1], c = w.light_nodes.at[4 * i + 2],
               d = w.light_nodes.at[4 * i + 3];
    return LightNode(a.xyz, b.xyz, c.xyz, a.w, b.w, c.w, d.x, floatBitsToUint(d.y) != 0, floatBitsToInt(d.z),
                     floatBitsToInt(d.w));
}
// Cosine and sine of the difference of two angles, clamped at 0.
vec2 angle_less(vec2 a, vec2 other) {
    return a.x >= other.x ? vec2(1, 0) : vec2(a.x * other.x + a.y * other.y, a.y * other.x - a.x * other.y);
}
float importance_of(LightNode n, vec3 position, vec3 normal) {
    const vec3 to = n.center - position;
    const float middle = dot(normal, to), reach = dot(abs(normal), n.extent);
    if (!(middle + reach > 0)) return 0;
    const float height = middle >= reach ? middle : (middle + reach) * (middle + reach) / (4 * reach);
    const float d2 = dot(to, to), r2 = n.radius * n.radius;
    if (n.emitter >= 0) {
        const float away = -dot(n.axis, to), there = n.two_sided ? abs(away) : away,
                    far2 = max(max(d2, 0.25f * r2), 1e-10f);
        return there > 0 ? n.power * there * height / (far2 * far2) : 0;
    }
    const vec3 beyond = max(vec3(0), abs(to) - n.extent);
    const float near2 = dot(beyond, beyond), d = sqrt(d2),
                far2 = max(sqrt(near2), 0.1f * n.radius) * max(d, n.radius) + 1e-10f;
    const float here = min(1, height / sqrt(far2));
    if (!(d2 > r2)) return n.power * here / far2;
    const float sine = n.radius / d, away = clamp(-dot(n.axis, to) / d, -1, 1),
                cosine = n.two_sided ? abs(away) : away;
    const vec2 least = angle_less(vec2(cosine, sqrt(1 - cosine * cosine)), vec2(n.cosine, n.sine));
    const float best = angle_less(least, vec2(sqrt(max(0, 1 - sine * sine)), sine)).x;
    if (!(best > 0)) return 0;
    return n.power * 0.5f * (best + max(0, least.x)) * here / far2;
}
float head_importance(World w, uint head, vec3 position, vec3 normal) {
    return importance_of(light_node(w, w.light_heads.at[head]), position, normal);
}
float all_heads(World w, vec3 position, vec3 normal) {
    float sum = 0;
    for (uint h = 0; h < w.heads; ++h) sum += head_importance(w, h, position, normal);
    return sum;
}
// The probability of the first child; -1: neither.
float first_share(World w, uint node, uint second, vec3 position, vec3 normal) {
    const float one = importance_of(light_node(w, node + 1), position, normal),
                two = importance_of(light_node(w, second), position, normal);
    return one + two > 0 ? one / (one + two) : -1;
}

struct DrawnEmitter {
    int emitter;
    float probability, all;  // all: sum over the heads
};
DrawnEmitter draw_emitter(World w, vec3 position, vec3 normal, float u) {
    const uint heads = w.heads;
    float shares[kMostHeads], all = 0;
    for (uint h = 0; h < heads; ++h) shares[h] = all += head_importance(w, h, position, normal);
    DrawnEmitter none = DrawnEmitter(-1, 0, all);
    if (!(all > 0)) return none;
    uint head = 0;
    while (head + 1 < heads && !(u * all < shares[head])) ++head;
    const float below = head > 0 ? shares[head - 1] : 0;
    if (!(shares[head] > below)) return none;
    float probability = (shares[head] - below) / all;
    u = (u * all - below) / (shares[head] - below);
    for (uint at = w.light_heads.at[head];;) {
        u = clamp(u, 0.0, 0.999999f);
        const vec4 last = w.light_nodes.at[4 * at + 3];
        const int emitter = floatBitsToInt(last.z);
        if (emitter >= 0) return DrawnEmitter(emitter, probability, all);
        const uint second = floatBitsToUint(last.w);
        const float one = first_share(w, at, second, position, normal);
        if (one < 0) return none;
        const bool takes_first = u < one;
        probability *= takes_first ? one : 1 - one;
        u = takes_first ? u / one : (u - one) / (1 - one);
        at = takes_first ? at + 1 : second;
    }
}
float emitter_probability(World w, uint emitter, float all, vec3 position, vec3 normal) {
    const uvec4 place = w.light_places.at[emitter];
    if (int(place.x) < 0 || !(all > 0)) return 0;
    float probability = head_importance(w, place.x, position, normal) / all;
    uint at = w.light_heads.at[place.x];
    for (uint level = 0; level < place.y && probability > 0; ++level) {
        const uint second = floatBitsToUint(w.light_nodes.at[4 * at + 3].w);
        const float one = first_share(w, at, second, position, normal);
        if (one < 0) return 0;
        const bool takes_second = ((level < 32 ? place.z >> level : place.w >> (level - 32)) & 1) != 0;
        probability *= takes_second ? 1 - one : one;
        at = takes_second ? second : at + 1;
    }
    return probability;
}

struct Emitter {
    vec3 a, b, c;  // corners; of a window: a corner and two edges
    uint material, flags;
    float area;
};
Emitter emitter_of(World w, uint i) {
    const vec4 a = w.emitters.at[3 * i], b = w.emitters.at[3 * i + 1], c = w.emitters.at[3 * i + 2];
    return Emitter(a.xyz, b.xyz, c.xyz, floatBitsToUint(a.w), floatBitsToUint(b.w), c.w);
}

// Summed over all windows that lie in this direction, one behind the other.
float portal_pdf(World w, float all, vec3 position, vec3 normal, vec3 direction) {
    float sum = 0;
    const vec3 from = position + normal * kSurfaceOffset;
    for (uint i = 0; i < w.windows; ++i) {
        const Emitter p = emitter_of(w, i);
        const vec3 across = cross(p.b, p.c);
        const float cosine = -dot(across, direction) / p.area;
        if (!(cosine > 1e-5f)) continue;
        const float far = dot(p.a - from, across) / (-cosine * p.area);
        if (!(far > 0)) continue;
        const vec3 at = from + direction * far - p.a;
        const float u = dot(at, p.b) / dot(p.b, p.b), v = dot(at, p.c) / dot(p.c, p.c);
        if (u >= 0 && u <= 1 && v >= 0 && v <= 1)
            sum += emitter_probability(w, i, all, position, normal) * far * far / (cosine * p.area);
    }
    return sum;
}

struct LightSample {
    vec3 direction;
    float far;
    vec3 radiance;
    float pdf;
    bool alone;  // no ray can hit it
};
// MIS weight of the sample, where the BSDF has the pdf `other` in its direction.
float light_weight(LightSample light, float other) { return light.alone ? 1 : power_heuristic(light.pdf, other); }

LightSample draw_light(World w, vec3 position, vec3 normal, float which, vec2 uv) {
    LightSample none = LightSample(vec3(0), 0, vec3(0), 0, false);
    const DrawnEmitter drawn = draw_emitter(w, position, normal, which);
    if (drawn.emitter < 0) return none;
    const Emitter e = emitter_of(w, uint(drawn.emitter));
    const vec3 from = position + normal * kSurfaceOffset;
    if ((e.flags & kWindow) != 0) {
        const vec3 direction = normalize(e.a + e.b * uv.x + e.c * uv.y - from);
        return LightSample(direction, kFar, outside_light(w, direction),
                           portal_pdf(w, drawn.all, position, normal, direction), false);
    }
    const float r = sqrt(uv.x);
    const vec3 to = e.a * (1 - r) + e.b * (r * (1 - uv.y)) + e.c * (r * uv.y) - from;
    const float far = length(to);
    if (!(far > 1e-4f)) return none;
    const vec3 direction = to / far;
    const float away = dot(normalize(cross(e.b - e.a, e.c - e.a)), direction);
    const float there = (e.flags & kSolid) != 0 ? -away : abs(away);
    if (!(there > 1e-5f)) return none;
    return LightSample(direction, far * 0.999f - kSurfaceOffset, emission_of(w, e.material),
                       drawn.probability * far * far / (there * e.area), (e.flags & kFlame) != 0);
}

// Lights::pdf for a hit on a triangle of a mesh; `triangle` kNone: none.
float light_pdf(World w, vec3 position, vec3 normal, vec3 direction, uint triangle, uint mesh, vec3 hit_normal,
                bool back, float distance) {
    if (w.emitter_count == 0) return 0;
    if (triangle == kNone)
        return w.windows == 0 ? 0 : portal_pdf(w, all_heads(w, position, normal), position, normal, direction);
    const uvec4 m = w.meshes.at[mesh];
    if (int(m.z) < 0 || (back && (m.y & kClosed) != 0)) return 0;
    const uint emitter = m.z + triangle - m.w;
    const vec4 c = w.emitters.at[3 * emitter + 2];
    return emitter_probability(w, emitter, all_heads(w, position, normal), position, normal) * distance * distance /
           (max(1e-5f, abs(dot(hit_normal, direction))) * c.w);
}

// A direction to the sun's disc.
vec3 sun_direction(World w, vec2 uv) {
    const vec3 middle = world_sun(w).xyz;
    vec3 s, t;
    make_frame(middle, s, t);
    const float r = kSunRadius * sqrt(uv.x), phi = 6.2831853f * uv.y;
    return normalize(middle + s * (r * cos(phi)) + t * (r * sin(phi)));
}
// Its irradiance on a surface if nothing is in between.
vec3 sun_unblocked(World w, vec3 normal) {
    const vec3 light = world_sun_light(w).xyz;
    const float cosine = dot(normal, world_sun(w).xyz);
    return luminance(light) > 0 && cosine > 0 ? light * cosine : vec3(0);
}
