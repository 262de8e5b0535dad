// Of one channel: SSIM, and its derivatives with respect to the blurred maps.
#version 460
#include "tables.glsl"
#include "loss.glsl"

shared vec2 source[kWide][kWide];     // picture, target
shared vec4 blurred[kWide][kTile];    // along rows: x, y, x^2 + y^2, x y

void main() {
    if (has_failed()) return;
    const uint channel = gl_WorkGroupID.z, lane = gl_LocalInvocationID.x;
    const ivec2 corner = tile_corner() - int(kReach);
    for (uint k = lane; k < kWide * kWide; k += 256) {
        const ivec2 p = corner + ivec2(k % kWide, k / kWide);
        vec2 both = vec2(0);
        if (inside(p)) {
            const uint i = index_of(p);
            const vec4 color = t.color.at[i];
            both = vec2(color[channel], float(plan.target.at[i] >> 8 * channel & 0xff) / 255.0);
        }
        source[k / kWide][k % kWide] = both;
    }
    barrier();
    for (uint k = lane; k < kWide * kTile; k += 256) {
        const uint x = k % kTile, y = k / kTile;
        vec4 sum = vec4(0);
        [[unroll]] for (uint i = 0; i < 11; ++i) {
            const vec2 s = source[y][x + i];
            sum += kWindow[i] * vec4(s, dot(s, s), s.x * s.y);
        }
        blurred[y][x] = sum;
    }
    barrier();
    vec4 m = vec4(0);
    const uint x = lane % kTile, y = lane / kTile;
    [[unroll]] for (uint i = 0; i < 11; ++i) m += kWindow[i] * blurred[y + i][x];
    const float mxmy = m.x * m.y, mm = m.x * m.x + m.y * m.y;
    const float a1 = 2.0 * mxmy + kC1, a2 = 2.0 * (m.w - mxmy) + kC2, b1 = mm + kC1, b2 = m.z - mm + kC2;
    const float inv = 1.0 / (b1 * b2), ssim = a1 * a2 * inv;
    const ivec2 p = own_pixel();
    float dissimilarity = 0.0;
    if (inside(p)) {
        const uint i = index_of(p);
        const float w = weight_of(p, plan.target.at[i]);
        const float k = w * inv * (-2.0 * plan_background().w / (3.0 * float(pixels())));
        const uint at = 3 * channel * pixels() + i;
        t.maps.at[at] = k * (m.y * (a2 - a1) - m.x * ssim * (b2 - b1));
        t.maps.at[at + pixels()] = -k * b1 * ssim;
        t.maps.at[at + 2 * pixels()] = k * a1;
        dissimilarity = w - w * ssim;
    }
    const vec4 sum = sum_of_tile(vec4(dissimilarity, 0, 0, 0));
    if (lane == 0) t.dssim.at[channel * plan_size().z * plan_size().w + gl_WorkGroupID.x] = sum.x;
}
