// The gradient of blending, front to back once more (splat/blend_grad.h). Each pair's sums over the tile's pixels go
// to a slot of its own: no atomics, so their order is fixed and runs repeat bit for bit.
#version 460
#include "tables.glsl"
#include "raster.glsl"

layout(constant_id = 2) const uint kBatch = 32;  // pairs between two barriers; at most 32
shared vec4 batch[kBatch][3];
shared uint pairs[kBatch];
shared float partial[kBlocks][kBatch][kSlotFloats];
shared uint touched[kBlocks];
shared uint tile_stop;

// One pixel of the block during the pass.
struct Pixel {
    float transmittance, rest;  // what lies behind, times v
    vec3 v;
    float error, v_depth, open;
};

// Sums of twelve values over the subgroup, spread out: of every eight invocations, each ends with one or two sums.
// Halving the values at each exchange costs less than summing them one by one.
void store_sums(float x[12], uint slot) {
    const uint lane = gl_SubgroupInvocationID;
    const bool high4 = (lane & 4) != 0, high2 = (lane & 2) != 0, high1 = (lane & 1) != 0;
    float six[6];
    [[unroll]] for (uint j = 0; j < 6; ++j)
        six[j] = (high4 ? x[j + 6] : x[j]) + subgroupShuffleXor(high4 ? x[j] : x[j + 6], 4);
    float three[3];
    [[unroll]] for (uint j = 0; j < 3; ++j)
        three[j] = (high2 ? six[j + 3] : six[j]) + subgroupShuffleXor(high2 ? six[j] : six[j + 3], 2);
    float own = (high1 ? three[2] : three[0]) + subgroupShuffleXor(high1 ? three[0] : three[2], 1);
    float middle = three[1] + subgroupShuffleXor(three[1], 1);
    [[unroll]] for (uint far = 8; far < 64; far *= 2)
        if (far < kSubgroup) own += subgroupShuffleXor(own, far), middle += subgroupShuffleXor(middle, far);
    if (lane < 8) {
        const uint base = (high4 ? 6 : 0) + (high2 ? 3 : 0);
        partial[gl_SubgroupID][slot][base + (high1 ? 2 : 0)] = own;
        if (!high1) partial[gl_SubgroupID][slot][base + 1] = middle;
    }
}

void visit(inout Pixel pixel, Record s, vec2 d, float alpha, uint slot) {
    const float weight = alpha * pixel.transmittance, odds = alpha / (1.0 - alpha);
    const float vc = dot(pixel.v, color_of(s)) + pixel.v_depth * s.more.y;
    pixel.rest -= weight * vc;
    const float slope = weight * vc - pixel.rest * odds;
    pixel.transmittance -= weight;
    const float g = (alpha < kMaxAlpha ? slope : 0.0) * pixel.open, trained = weight * pixel.open;
    const float gx = g * d.x, gy = g * d.y;
    store_sums(float[12](g, gx, gy, gx * d.x, gx * d.y, gy * d.y, trained * pixel.v.x, trained * pixel.v.y,
                         trained * pixel.v.z, weight, weight * pixel.error, trained * pixel.v_depth), slot);
}

Pixel start(uvec2 at) {
    Pixel p = Pixel(0.0, 0.0, vec3(0), 0.0, 0.0, 1.0);
    if (any(greaterThanEqual(at, plan.size.xy))) return p;
    const uint i = at.y * plan_size().x + at.x;
    const vec4 v = t.v.at[i], color = t.color.at[i];
    p.transmittance = 1.0, p.v = v.xyz, p.error = v.w;
    p.rest = dot(v.xyz, color.xyz);
    if (flag(kDepth) || flag(kOpen)) {
        const vec2 more = t.v_more.at[i];
        p.v_depth = more.x;
        p.rest += more.y * color.w;
        if (flag(kDepth)) p.rest += more.x * t.depth.at[i];
    }
    return p;
}

// First float of the slot that a record has in this tile.
uint slot_of(uint r) {
    const uvec2 box = t.boxes.at[r];
    const uint column = gl_WorkGroupID.x % plan_size().z, row = gl_WorkGroupID.x / plan_size().z;
    return t.first_pair.at[r] + (row - (box.x >> 16)) * (box.y & 0xffff) + column - (box.x & 0xffff);
}

void main() {
    if (has_failed()) return;
    const uint lane = gl_LocalInvocationID.x;
    const uint begin = t.tile_begin.at[gl_WorkGroupID.x], end = t.tile_begin.at[gl_WorkGroupID.x + 1];
    const uvec2 corner = block_corner(), at = pixel_at(corner);
    const vec2 center = vec2(at) + 0.5;
    const uint stop = t.stops.at[gl_WorkGroupID.x * kBlocks + gl_SubgroupID];
    if (lane == 0) tile_stop = begin;
    barrier();
    if (subgroupElect()) atomicMax(tile_stop, stop);
    barrier();
    Pixel pixel = start(at);
    bool outside = false;
    for (uint base = begin; base < tile_stop; base += kBatch) {
        for (uint k = lane; k < kBatch * 3; k += kLocal)
            if (base + k / 3 < end) batch[k / 3][k % 3] = t.records.at[3 * t.pair_records[side].at[base + k / 3] + k % 3];
        if (lane < kBatch && base + lane < end) pairs[lane] = slot_of(t.pair_records[side].at[base + lane]);
        barrier();
        uint near = 0;
        for (uint k = 0; k < kBatch; k += kSubgroup) {
            const uint own = k + gl_SubgroupInvocationID;
            bool hit = false;
            if (own < kBatch && base + own < min(end, stop)) {
                const Record s = Record(batch[own][0], batch[own][1], batch[own][2]);
                hit = touches(s, vec2(corner));
            }
            near |= subgroupBallot(hit).x << k;
        }
        uint used = 0;
        for (uint left = near; left != 0; left &= left - 1) {
            const uint k = findLSB(left);
            const Record s = Record(batch[k][0], batch[k][1], batch[k][2]);
            const vec2 d = center - s.place.xy;
            const float alpha = alpha_at(s, d);
            if (!outside && s.more.y > plan_center().w) {
                outside = true;
                pixel.open = pixel.transmittance > kOutsideVisible ? 1.0 : 0.0;
            }
            if (!subgroupAny(alpha > 0.0)) continue;
            used |= 1u << k;
            visit(pixel, s, d, alpha, k);
        }
        if (subgroupElect()) touched[gl_SubgroupID] = used;
        barrier();
        for (uint k = lane; k < kBatch * kSlotFloats; k += kLocal) {
            const uint pair = k / kSlotFloats, value = k % kSlotFloats;
            if (base + pair >= end) continue;
            float sum = 0.0;
            for (uint block = 0; block < kBlocks; ++block)
                if ((touched[block] >> pair & 1) != 0) sum += partial[block][pair][value];
            t.slot_floats.at[kSlotFloats * pairs[pair] + value] = sum;
        }
        barrier();
    }
    // Behind opaque pixels.
    const uint done = (tile_stop - begin + kBatch - 1) / kBatch * kBatch + begin;
    for (uint i = done + lane; i < end; i += kLocal) {
        const uint slot = 3 * slot_of(t.pair_records[side].at[i]);
        t.slots.at[slot] = t.slots.at[slot + 1] = t.slots.at[slot + 2] = vec4(0);
    }
}
