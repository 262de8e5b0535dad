// dL/d color of each pixel and, where they count, dL/d(depth sum) (splat/depth_loss.h) and dL/d transmittance.
#version 460
#include "tables.glsl"
#include "loss.glsl"

shared vec3 source[kWide][kWide];   // derivatives with respect to the blurred maps
shared vec3 blurred[kWide][kTile];

vec3 blurred_maps(uint channel) {
    const uint lane = gl_LocalInvocationID.x;
    const ivec2 corner = tile_corner() - int(kReach);
    barrier();
    for (uint k = lane; k < kWide * kWide; k += 256) {
        const ivec2 p = corner + ivec2(k % kWide, k / kWide);
        vec3 all = vec3(0);
        if (inside(p)) {
            const uint at = 3 * channel * pixels() + index_of(p);
            all = vec3(t.maps.at[at], t.maps.at[at + pixels()], t.maps.at[at + 2 * pixels()]);
        }
        source[k / kWide][k % kWide] = all;
    }
    barrier();
    for (uint k = lane; k < kWide * kTile; k += 256) {
        const uint x = k % kTile, y = k / kTile;
        vec3 sum = vec3(0);
        [[unroll]] for (uint i = 0; i < 11; ++i) sum += kWindow[i] * source[y][x + i];
        blurred[y][x] = sum;
    }
    barrier();
    vec3 sum = vec3(0);
    [[unroll]] for (uint i = 0; i < 11; ++i) sum += kWindow[i] * blurred[lane / kTile + i][lane % kTile];
    return sum;
}

// Depth and transmittance losses of a pixel.
vec2 other_losses(uint i, float weight, float transmittance) {
    vec2 loss = vec2(0), v = vec2(0);
    if (plan_weights().x > 0.0) {
        const float target = plan.depth.at[i];
        if (target > 0.0) {  // placed behind the splats, as a background
            const float total = t.depth.at[i] + transmittance * target, relative = total / target - 1.0;
            t.depth.at[i] = total;
            loss.x = weight * plan_weights().x * abs(relative);
            v.x = weight * plan_weights().x * (relative > 0.0 ? 1.0 : -1.0) / target;
        }
    }
    if (flag(kOpen)) {
        v.y = weight * plan_weights().y;
        loss.y = v.y * transmittance;
    }
    t.v_more.at[i] = v;
    return loss;
}

void main() {
    if (has_failed()) return;
    const ivec2 p = own_pixel();
    const bool there = inside(p);
    const uint i = there ? index_of(p) : 0, target = there ? plan.target.at[i] : 0;
    const float weight = there ? weight_of(p, target) : 0.0;
    const float scale = weight * (1.0 - plan_background().w) / (3.0 * float(pixels()));
    vec4 color = vec4(0);
    if (there) color = t.color.at[i];
    vec4 v = vec4(0);
    float squared = 0.0;
    [[unroll]] for (uint channel = 0; channel < 3; ++channel) {
        const vec3 maps = blurred_maps(channel);
        const float c = color[channel], want = float(target >> 8 * channel & 0xff) / 255.0, difference = c - want;
        v[channel] = (difference < 0.0 ? -scale : scale) + maps.x + c * maps.y + want * maps.z;
        v.w += weight * abs(difference);
        squared += weight * difference * difference;
    }
    vec2 others = vec2(0);
    if (there) {
        t.v.at[i] = v;
        if (flag(kDepth) || flag(kOpen)) others = other_losses(i, weight, color.w);
    }
    const vec4 sums = sum_of_tile(there ? vec4(v.w, squared, others) : vec4(0));
    if (gl_LocalInvocationID.x == 0) t.sums.at[gl_WorkGroupID.x] = sums;
}
