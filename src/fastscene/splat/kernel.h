// The fast renderer's inner loops, compiled once per instruction set (isa_*.cc) and chosen at run time.
// Everything here is plain pointers: the caller (engine.cc) owns memory, threads and order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "fastscene/splat/project.h"

namespace fastscene::splat {

inline constexpr int kBlock = 16;       // splats a vector
inline constexpr int kTile = 16;        // pixels a tile side
inline constexpr int kChunk = 64;       // splats blended at a time in a tile: one bit each in a 64-bit set
inline constexpr int kSlotFloats = 12;  // 6 moments, 3 colors, blending weight, weight * error, depth

// One visible splat on screen.
struct alignas(64) Record {
    float x, y, a, b, c, log2_opacity;  // Footprint
    float color[3];
    float depth_z;
    float dy_per_dx, dx_per_dy;  // where alpha is largest along a column, along a row
    std::uint32_t splat,
        first_slot;  // its gradient slots: one per tile of its rectangle, row-major, counted from its piece's first
    std::uint16_t tile_x, tile_y, tiles_wide, tiles_high;
};
static_assert(sizeof(Record) == 64);

// The tiles that a record's ellipse may touch.
struct TileBox {
    std::uint16_t x, y, wide, high;
};
inline constexpr int kPiece = 2048;  // splats projected and updated at a time: enough to pay for a task
// What projecting a piece gave.
struct PieceCount {
    std::int64_t records = 0;
    std::uint32_t slots = 0;
};

// Of Adam's division. Gradients of splats that show are 1e-6 and larger. With the 1e-15 of the original trainer those
// of splats behind walls, which are never quite closed, made steps of full length: from new viewpoints the ground below
// a window had the wall's color.
inline constexpr float kAdamEpsilon = 1e-7f;

// Splats in blocks of 16: block k holds its 14 parameters one after the other, 16 floats each.
struct ProjectJob {
    const float* parameters;
    std::int64_t count;
    Lens<float> lens;
    int width, height;
    // Of splats [begin, end) these are written from records_a_splat * begin on, in order.
    Record* records;
    std::uint64_t* keys;  // bits of the depth << 32 | number of the record: depths are positive, so their bits order
                          // like the numbers
    TileBox* boxes;
    const float* rest = nullptr;  // coefficients of the higher bands, in blocks like the parameters
    int degree = 0;
};
// A splat across the seam of an equirectangular picture shows on both sides: two records, one a picture's width aside.
inline constexpr int records_a_splat(CameraModel model) { return model == CameraModel::equirectangular ? 2 : 1; }

// Picture planes are row-major with `stride` floats a row and whole tiles: no bounds checks inside.
struct Frame {
    int width, height, tiles_x, tiles_y;
    std::ptrdiff_t stride;
    float* color[3];
    float* transmittance;
    float* depth;                  // sum of weight * depth_z; null = not wanted
    const float* v[3];             // dL/d color; zero outside the picture
    const float* error[3];         // |difference| per channel; null: weights and errors of splats are not summed
    const float* v_transmittance;  // dL/d(transmittance left), zero outside the picture; null = none
    const float* v_depth;          // dL/d(depth sum), zero outside the picture; null = none, otherwise `depth` is there
    float background[3];
    const Record* records;
    const std::uint32_t* list;        // record numbers, tile after tile, front to back
    const std::uint32_t* tile_begin;  // tiles + 1
    const std::uint32_t* piece_slot;  // per piece of splats: its first slot
    int piece_shift;                  // record >> piece_shift: its piece
    std::uint16_t* masks;             // per list entry: which of the tile's 4x4 blocks of 4x4 pixels it touches
    float* slots;
    float outside_m;  // splats of a larger depth learn only where they show (Engine::set_outside)
};

struct LossSums {
    double loss = 0, squared_error = 0;
};
struct LossJob {
    int width, height;
    std::ptrdiff_t stride;
    const float* color[3];
    const std::uint8_t* target;  // interleaved sRGB
    const std::uint8_t* weight;  // or null
    const float* row_weight;     // or null: one per row
    float lambda;
    float* v[3];
    float* error[3];        // or null
    LossSums* row_sums[3];  // one per row
};

struct UpdateJob {
    float* parameters;
    float* first_moment;
    float* second_moment;
    const Record* records;
    Lens<float> lens;
    float rate[kParameters];  // Adam's step sizes, bias correction of the first moment included
    Vec3f middle;             // positions farther than reach_m from it step as much farther
    float reach_m = std::numeric_limits<float>::infinity();
    float inv_sqrt_bias2;          // 1 / sqrt(1 - beta2^t)
    float* seen_weight = nullptr;  // += blending weight of each splat
    float* seen_error = nullptr;   // += blending weight * error
    float* rest = nullptr;         // coefficients of the higher bands and their moments; null: degree 0
    float* rest_first_moment = nullptr;
    float* rest_second_moment = nullptr;
    int degree = 0;
    float rest_rate = 0;  // 0: the higher bands stay as they are in this step
    float rest_inv_sqrt_bias2 = 1;
    float* rest_gradients = nullptr;
    float opacity_pull = 0, scale_pull = 0;  // dL/d(opacity), dL/d(scale in metres) of the regularizers, per splat
    float* seen_move = nullptr;              // += length of dL/d(position on screen), half pictures; null: not wanted
    float* seen_steps = nullptr;             // += 1 where visible
    float half_picture = 0;                  // pixels
    float* gradients;                        // null, or where dL/dparameter goes instead of moving the parameters
};

struct Kernel {
    const char* name;
    // The visible ones among splats [begin, end); begin is a multiple of kBlock.
    PieceCount (*project)(const ProjectJob&, std::int64_t begin, std::int64_t end);
    void (*forward)(const Frame&, int tile);
    void (*backward)(const Frame&, int tile);
    // Floats of scratch memory the loss needs for a picture of this stride.
    std::ptrdiff_t (*loss_scratch)(std::ptrdiff_t stride);
    // Of the rows [row_begin, row_end): their sums, v and error. The same whatever the rows are cut into, but at every
    // cut the 10 nearest are done twice.
    void (*loss)(const LossJob&, int channel, int row_begin, int row_end, float* scratch);
    // A piece: records [record_begin, record_end) belong to splats [begin, end), and their slots begin at `slots`.
    void (*update)(const UpdateJob&, std::int64_t begin, std::int64_t end, std::int64_t record_begin,
                   std::int64_t record_end, const float* slots);
};
inline constexpr int kLossRows =
    64;  // a loss piece handles no fewer rows: the work done twice would outgrow what more threads save

namespace baseline {
const Kernel& kernel();
}
namespace avx2 {
const Kernel& kernel();
}
namespace avx512 {
const Kernel& kernel();
}
// The best one this processor can run; `name` ("avx512", "avx2", "baseline") asks for one in particular.
// Throws UsageError when the processor lacks it.
const Kernel& choose_kernel(const char* name = nullptr);

}  // namespace fastscene::splat
