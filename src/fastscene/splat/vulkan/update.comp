// One invocation a splat: sums its slots, goes back through the projection, and applies Adam (Kingma and Ba 2015). All
// splats are updated in every step, visible or not: in short runs the momentum of invisible ones helps.
#version 460
#include "tables.glsl"
#include "project.glsl"
#include "project_grad.glsl"

layout(local_size_x = 256) in;
shared vec4 reduced[256];

// Sums of twelve floats.
struct Sums {
    vec4 a, b, c;
};
Sums slots_from(uint begin, uint count, uint first_slot, uint stride) {
    Sums s = Sums(vec4(0), vec4(0), vec4(0));
    for (uint k = first_slot; k < count; k += stride) {
        const uint at = 3 * (begin + k);
        s.a += t.slots.at[at], s.b += t.slots.at[at + 1], s.c += t.slots.at[at + 2];
    }
    return s;
}
// The whole subgroup sums the slots of a splat that touches many tiles.
Sums sum_slots(uint begin, uint count) {
    const bool many = count > 4 * kSubgroup;
    Sums s = slots_from(begin, many ? 0 : count, 0, 1);
    const uvec4 set = subgroupBallot(many);
    for (uint word = 0; word < (kSubgroup + 31) / 32; ++word)
        for (uint left = set[word]; left != 0; left &= left - 1) {
            const uint lane = word * 32 + findLSB(left);
            Sums part = slots_from(subgroupShuffle(begin, lane), subgroupShuffle(count, lane),
                                   gl_SubgroupInvocationID, kSubgroup);
            part.a = subgroupAdd(part.a), part.b = subgroupAdd(part.b), part.c = subgroupAdd(part.c);
            if (gl_SubgroupInvocationID == lane) s = part;
        }
    return s;
}

bool is_sound(float x) { return abs(x) < 1e15; }  // false for NaN

void adam(Floats x, Floats first_moment, Floats second_moment, uint at, float gradient, float rate, float inv_root) {
    const float m = first_moment.at[at] * kBeta1 + gradient * (1.0 - kBeta1);
    const float v = second_moment.at[at] * kBeta2 + gradient * gradient * (1.0 - kBeta2);
    first_moment.at[at] = m, second_moment.at[at] = v;
    x.at[at] -= rate * m / (sqrt(v) * inv_root + kAdamEpsilon);
}

// SH degrees >= 1, of visible splats only: updating all moments would dominate memory traffic. Returns dL/d(mean).
vec3 update_rest(uint i, vec4 sight, vec3 g_color, bool changes) {
    const uint n = rest_functions(plan.degree);
    float basis[15], w[15];
    sh_basis(sight.xyz, basis);
    [[unroll]] for (uint k = 0; k < 15; ++k) {
        w[k] = 0.0;
        if (k < n) {
            w[k] = dot(g_color, rest_of(i, k, n));
            const vec3 g = g_color * basis[k];
            [[unroll]] for (uint c = 0; c < 3; ++c) {
                const uint at = (c * n + k) * t.capacity + i;
                const float sound = is_sound(g[c]) ? g[c] : 0.0;
                if (flag(kGradientsOnly)) t.rest_gradients.at[at] = sound;
                else if (changes)
                    adam(t.rest, t.rest_first_moment, t.rest_second_moment, at, sound, rate_of(14), plan_adam().y);
            }
        }
    }
    const vec3 slope = sh_slope(plan.degree, sight.xyz, w);
    // Only the component orthogonal to the line of sight changes the direction.
    return (slope - sight.xyz * dot(slope, sight.xyz)) * sight.w;
}

void note(Floats list, uint i, float x) {
    if (is_sound(x)) list.at[i] += x;
}

void update(uint i, PixelSums s, bool seen) {
    const Gaussian g = load_gaussian(i);
    float gradient[kParameters];
    [[unroll]] for (int p = 0; p < kParameters; ++p) gradient[p] = 0.0;
    if (seen) {
        const vec4 sight = sight_of(g.mean);
        const Projection p = project(g, more_color(i, sight.xyz));
        Gaussian d = project_grad(g, p, s);
        if (plan.degree > 0) d.mean += update_rest(i, sight, d.sh0 / kSh0, rate_of(14) > 0.0);
        gradient = float[kParameters](d.mean.x, d.mean.y, d.mean.z, d.log_scale.x, d.log_scale.y, d.log_scale.z,
                                      d.rotation.x, d.rotation.y, d.rotation.z, d.rotation.w, d.logit, d.sh0.x,
                                      d.sh0.y, d.sh0.z);
        if (flag(kJudge)) note(t.seen_weight, i, s.weight), note(t.seen_error, i, s.error);
        if (flag(kMoves)) {
            note(t.seen_move, i, length(screen_grad(p, s)) * plan_weights().z);
            t.seen_steps.at[i] += 1.0;
        }
    }
    const float opacity = 1.0 / (1.0 + exp(-g.logit));
    const vec3 far = g.mean - plan.middle.xyz;
    const float stride = max(1.0, length(far) * plan_middle().w);
    [[unroll]] for (int p = 0; p < kParameters; ++p) {
        float x = is_sound(gradient[p]) ? gradient[p] : 0.0;
        if (p == 10) {
            const float pull = opacity * (1.0 - opacity) * plan_adam().z / float(t.counters.count);
            x += is_sound(pull) ? pull : 0.0;
        }
        if (p >= 3 && p < 6) {
            const float pull = exp(g.log_scale[p - 3]) * plan_adam().w / (3.0 * float(t.counters.count));
            x += is_sound(pull) ? pull : 0.0;
        }
        const uint at = uint(p) * t.capacity + i;
        if (flag(kGradientsOnly)) t.gradients.at[at] = x;
        else
            adam(t.parameters, t.first_moment, t.second_moment, at, x, rate_of(p) * (p < 3 ? stride : 1.0),
                 plan_adam().x);
    }
}

// Tells the host of the step, and clears what the next one counts.
void finish_step() {
    const uint lane = gl_LocalInvocationID.x, tiles = plan_size().z * plan_size().w;
    vec4 sum = vec4(0);  // L1, squared error, depth and transmittance, D-SSIM
    if (!has_failed() && !flag(kNoLoss)) {
        for (uint k = lane; k < tiles; k += 256) {
            const vec4 s = t.sums.at[k];
            sum += vec4(s.xy, s.z + s.w, 0.0);
        }
        for (uint k = lane; k < 3 * tiles; k += 256) sum.w += t.dssim.at[k];
    }
    reduced[lane] = sum;
    barrier();
    for (uint half_size = 128; half_size > 0; half_size /= 2) {
        if (lane < half_size) reduced[lane] += reduced[lane + half_size];
        barrier();
    }
    if (lane != 0) return;
    const float scale = 1.0 / (3.0 * float(plan_size().x) * float(plan_size().y)), lambda = plan_background().w;
    const vec4 all = reduced[0];
    t.outcomes.at[plan.outcome] = Outcome(((1.0 - lambda) * all.x + lambda * all.w) * scale + all.z, all.y * scale,
                                          t.counters.visible, t.counters.pairs, t.counters.failed);
    t.counters.visible = 0;
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    const bool there = i < t.counters.count && !has_failed() && !flag(kRenderOnly);
    const uint records_a_splat = flag(kEquirect) ? 2 : 1;
    Sums sums = Sums(vec4(0), vec4(0), vec4(0));
    bool seen = false;
    for (uint k = 0; k < records_a_splat; ++k) {
        const uint r = i * records_a_splat + k;
        uint tiles = 0, begin = 0;
        if (there) {
            const uvec2 box = t.boxes.at[r];
            tiles = (box.y & 0xffff) * (box.y >> 16);
            if (tiles > 0) begin = t.first_pair.at[r];
        }
        seen = seen || tiles > 0;
        const Sums part = sum_slots(begin, tiles);
        sums.a += part.a, sums.b += part.b, sums.c += part.c;
    }
    const PixelSums s = PixelSums(sums.a.x, sums.a.yz, vec3(sums.a.w, sums.b.xy), vec3(sums.b.zw, sums.c.x), sums.c.y,
                                  sums.c.z, sums.c.w);
    if (there) update(i, s, seen);
    if (gl_WorkGroupID.x == 0) finish_step();
}
