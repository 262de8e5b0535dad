// Blending in tiles of 16 x 16 pixels, one workgroup each. A subgroup owns a block of the tile, one pixel an
// invocation, and visits only those splats of the tile whose ellipse touches its block.
const uint kLocal = 256;
layout(local_size_x = 256) in;

// Sides of a block: 4 x 2, 4 x 4, 8 x 4 or 8 x 8 pixels.
const uint kBlockWide = kSubgroup >= 32 ? 8 : 4, kBlockHigh = kSubgroup / kBlockWide;
const uint kBlocks = kLocal / kSubgroup, kBlocksAcross = kTile / kBlockWide;

struct Record {
    vec4 place, shade, more;  // x, y, a, b; c, log2 opacity, red, green; blue, depth, and slopes for touches()
};
Record load_record(uint r) { return Record(t.records.at[3 * r], t.records.at[3 * r + 1], t.records.at[3 * r + 2]); }
vec3 color_of(Record s) { return vec3(s.shade.zw, s.more.x); }

uvec2 block_corner() {
    const uvec2 tile = uvec2(gl_WorkGroupID.x % plan_size().z, gl_WorkGroupID.x / plan_size().z);
    return tile * kTile + uvec2(gl_SubgroupID % kBlocksAcross * kBlockWide, gl_SubgroupID / kBlocksAcross * kBlockHigh);
}
uvec2 pixel_at(uvec2 corner) {
    return corner + uvec2(gl_SubgroupInvocationID % kBlockWide, gl_SubgroupInvocationID / kBlockWide);
}

// Whether a pixel center of the block may have alpha >= kMinAlpha. The exponent is concave, so its maximum over a
// rectangle lies on the column or row nearest to the splat's center.
bool touches(Record s, vec2 corner) {
    const vec2 low = corner + 0.5 - s.place.xy, high = low + vec2(kBlockWide, kBlockHigh) - 1.0;
    const vec2 near = clamp(vec2(0), low, high);
    const vec2 on_column = vec2(near.x, clamp(near.x * s.more.z, low.y, high.y));
    const vec2 on_row = vec2(clamp(near.y * s.more.w, low.x, high.x), near.y);
    const float most = max(
        on_column.x * (s.place.z * on_column.x + s.place.w * on_column.y) + s.shade.x * on_column.y * on_column.y,
        on_row.x * (s.place.z * on_row.x + s.place.w * on_row.y) + s.shade.x * on_row.y * on_row.y);
    return most >= -kLog2Of255 - 1e-3 - s.shade.y;  // the margin: rounding must not lose a pixel
}

float alpha_at(Record s, vec2 d) {
    const float raw = exp2(d.x * (s.place.z * d.x + s.place.w * d.y) + (s.shade.x * d.y * d.y + s.shade.y));
    return raw >= kMinAlpha ? min(raw, kMaxAlpha) : 0.0;
}
