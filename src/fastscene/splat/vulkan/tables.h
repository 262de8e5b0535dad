// The host's side of tables.glsl: the same structures, field by field. Addresses are of gpu::Buffer.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fastscene::splat::vulkan {

struct Vec4 {
    float x = 0, y = 0, z = 0, w = 0;
};

struct Counters {
    std::uint32_t count = 0, visible = 0, pairs = 0, failed = 0;
};
struct Outcome {
    float loss, squared_error;
    std::uint32_t visible, pairs, failed;
};

enum Flag : std::uint32_t {
    kEquirect = 1,
    kAntialias = 2,
    kJudge = 4,
    kDepth = 8,
    kOpen = 16,
    kMoves = 32,
    kGradientsOnly = 64,
    kNoLoss = 128,
    kRenderOnly = 256,
    kDensity = 512  // not a step but density control; on the host only
};

struct Plan {
    Vec4 row_x, row_y, row_z, lens, slopes, center, background;
    float rates[16] = {};
    Vec4 middle, adam, weights;
    std::uint32_t width = 0, height = 0, tiles_x = 0, tiles_y = 0;
    std::uint32_t flags = 0, degree = 0, number = 0, outcome = 0;
    std::uint64_t target = 0, depth = 0;
};
static_assert(sizeof(Plan) == 272 && offsetof(Plan, target) == 256);

struct Tables {
    std::uint64_t parameters, first_moment, second_moment, rest, rest_first_moment, rest_second_moment;
    std::uint64_t seen_weight, seen_error, seen_move, seen_steps, gradients, rest_gradients;
    std::uint64_t records, boxes, first_pair, depth_keys[2], depth_records[2], pair_tiles[2], pair_records[2];
    std::uint64_t histogram, block_pairs, tile_begin, stops, color, depth, maps, v, v_more, slots, slot_floats, dssim,
        sums;
    std::uint64_t counters, outcomes;
    std::uint64_t density, density_errors, density_dead, density_claims, density_choices, density_ranks, density_free;
    std::uint32_t capacity, most_splats, pair_capacity;
};

struct Push {
    std::uint64_t tables, plan;
    std::uint32_t shift = 0, bits = 0, side = 0, first = 0;
};

}  // namespace fastscene::splat::vulkan
