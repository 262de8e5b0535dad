// L1 + D-SSIM and its gradient (splat/isa_loss.h has the formulas), in tiles of 16 x 16 pixels with the window's reach
// around them.
layout(local_size_x = 256) in;
const uint kReach = 5, kWide = kTile + 2 * kReach;
const float kWindow[11] = float[11](0.00102838, 0.00759876, 0.03600077, 0.10936069, 0.21300554, 0.26601172, 0.21300554,
                                    0.10936069, 0.03600077, 0.00759876, 0.00102838);
const float kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

uint pixels() { return plan_size().x * plan_size().y; }
ivec2 tile_corner() {
    return ivec2(gl_WorkGroupID.x % plan_size().z, gl_WorkGroupID.x / plan_size().z) * int(kTile);
}
ivec2 own_pixel() { return tile_corner() + ivec2(gl_LocalInvocationID.x % kTile, gl_LocalInvocationID.x / kTile); }
bool inside(ivec2 p) { return all(greaterThanEqual(p, ivec2(0))) && all(lessThan(uvec2(p), plan.size.xy)); }
uint index_of(ivec2 p) { return uint(p.y) * plan_size().x + uint(p.x); }

// The pixel's training weight; rows of an equirectangular picture count by the solid angle they show.
float weight_of(ivec2 p, uint target) {
    const float row = flag(kEquirect) ? sin((float(p.y) + 0.5) / float(plan_size().y) * 3.14159265358979) : 1.0;
    return row * float(target >> 24) / 255.0;
}

shared vec4 reduced[256 / kSubgroup];
// The workgroup's sum, in a fixed order; for its first invocation.
vec4 sum_of_tile(vec4 x) {
    const vec4 sum = subgroupAdd(x);
    if (subgroupElect()) reduced[gl_SubgroupID] = sum;
    barrier();
    vec4 all = vec4(0);
    if (gl_LocalInvocationID.x == 0)
        for (uint k = 0; k < 256 / kSubgroup; ++k) all += reduced[k];
    return all;
}
