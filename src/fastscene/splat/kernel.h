// The fast renderer's inner loops, compiled once per instruction set (isa_*.cc) and selected at run time. The interface
// is plain pointers: the caller (engine.cc) owns memory, threading and order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "fastscene/splat/project.h"

namespace fastscene::splat {

inline constexpr int kBlock = 16;       // splats per vector
inline constexpr int kTile = 16;        // tile side in pixels
inline constexpr int kChunk = 64;       // splats blended at a time in a tile: one bit each in a 64-bit mask
inline constexpr int kSlotFloats = 12;  // 6 moments, 3 colors, blending weight, weight * error, depth

// One visible splat on screen.
struct alignas(64) Record {
    float x, y, a, b, c, log2_opacity;  // Footprint
    float color[3];
    float depth_z;
    float dy_per_dx, dx_per_dy;  // slopes of the lines of maximum alpha along columns and along rows
    std::uint32_t splat,
        // first of its gradient slots, one per tile of its rectangle in row-major order, relative to its piece
        first_slot;
    std::uint16_t tile_x, tile_y, tiles_wide, tiles_high;
};
static_assert(sizeof(Record) == 64);

// The tiles that a record's ellipse may touch.
struct TileBox {
    std::uint16_t x, y, wide, high;
};
inline constexpr int kPiece = 2048;  // splats projected and updated at a time: large enough to amortize a task
// Result of projecting a piece.
struct PieceCount {
    std::int64_t records = 0;
    std::uint32_t slots = 0;
};

// Adam's epsilon. Visible splats have gradients of 1e-6 and more. With the original trainer's 1e-15, splats behind
// walls that are not fully opaque took full steps on vanishing gradients: from new viewpoints, the ground below a
// window had the wall's color.
inline constexpr float kAdamEpsilon = 1e-7f;

// Splats in blocks of 16 (AoSoA): block k holds its 14 parameters one after the other, 16 floats each.
struct ProjectJob {
    const float* parameters;
    std::int64_t count;
    Lens<float> lens;
    int width, height;
    // Records of splats [begin, end) are written in order, from index records_a_splat * begin on.
    Record* records;
    std::uint64_t* keys;  // depth bits << 32 | record index: depths are positive, so their bits sort like the numbers
    TileBox* boxes;
    const float* rest = nullptr;  // SH coefficients of degrees >= 1, in blocks like the parameters
    int degree = 0;
};
// A splat across the seam of an equirectangular picture appears on both sides: two records, one picture width apart.
inline constexpr int records_a_splat(CameraModel model) { return model == CameraModel::equirectangular ? 2 : 1; }

// Picture planes are row-major with `stride` floats per row, padded to whole tiles: no bounds checks in the loops.
struct Frame {
    int width, height, tiles_x, tiles_y;
    std::ptrdiff_t stride;
    float* color[3];
    float* transmittance;
    float* depth;                  // sum of weight * depth_z; null: not computed
    const float* v[3];             // dL/d color; zero outside the picture
    const float* error[3];         // |difference| per channel; null: no statistics for density control
    const float* v_transmittance;  // dL/d(remaining transmittance), zero outside the picture; null: none
    const float* v_depth;          // dL/d(depth sum), zero outside the picture; null: none; requires `depth`
    float background[3];
    const Record* records;
    const std::uint32_t* list;        // record indices, tile after tile, front to back
    const std::uint32_t* tile_begin;  // tiles + 1
    const std::uint32_t* piece_slot;  // first slot of each piece of splats
    int piece_shift;                  // record >> piece_shift = its piece
    std::uint16_t* masks;             // per list entry: which of the tile's 4x4 blocks of 4x4 pixels it touches
    float* slots;
    float outside_m;  // deeper splats are trained only where they are visible (Engine::set_outside)
};

struct LossSums {
    double loss = 0, squared_error = 0;
};
struct LossJob {
    int width, height;
    std::ptrdiff_t stride;
    const float* color[3];
    const std::uint8_t* target;  // interleaved sRGB
    const std::uint8_t* weight;  // may be null
    const float* row_weight;     // one per row; may be null
    float lambda;
    float* v[3];
    float* error[3];        // may be null
    LossSums* row_sums[3];  // one per row
};

struct UpdateJob {
    float* parameters;
    float* first_moment;
    float* second_moment;
    const Record* records;
    Lens<float> lens;
    float rate[kParameters];  // Adam's learning rates, including the bias correction of the first moment
    Vec3f middle;             // beyond reach_m from here, position steps grow with the distance
    float reach_m = std::numeric_limits<float>::infinity();
    float inv_sqrt_bias2;          // 1 / sqrt(1 - beta2^t)
    float* seen_weight = nullptr;  // += blending weight of each splat
    float* seen_error = nullptr;   // += blending weight * error
    float* rest = nullptr;         // coefficients of the higher bands and their moments; null: degree 0
    float* rest_first_moment = nullptr;
    float* rest_second_moment = nullptr;
    int degree = 0;
    float rest_rate = 0;  // 0: SH degrees >= 1 stay unchanged in this step
    float rest_inv_sqrt_bias2 = 1;
    float* rest_gradients = nullptr;
    // strengths of the regularizers, per splat: dL/d(opacity), dL/d(scale in metres)
    float opacity_reg = 0, scale_reg = 0;
    float* seen_move = nullptr;   // += length of dL/d(screen position), half pictures; null: not computed
    float* seen_steps = nullptr;  // += 1 if visible
    float half_picture = 0;       // pixels
    float* gradients;             // if not null, receives dL/d(parameters), and the parameters stay unchanged
};

struct Kernel {
    const char* name;
    // Projects splats [begin, end), writing the visible ones; begin is a multiple of kBlock.
    PieceCount (*project)(const ProjectJob&, std::int64_t begin, std::int64_t end);
    void (*forward)(const Frame&, int tile);
    void (*backward)(const Frame&, int tile);
    // Floats of scratch memory that the loss needs for a picture of this stride.
    std::ptrdiff_t (*loss_scratch)(std::ptrdiff_t stride);
    // Rows [row_begin, row_end): their sums, v and error. The result does not depend on how rows are divided into
    // bands, but at each boundary the nearest 10 rows are computed twice.
    void (*loss)(const LossJob&, int channel, int row_begin, int row_end, float* scratch);
    // One piece: records [record_begin, record_end) belong to splats [begin, end); their slots begin at `slots`.
    void (*update)(const UpdateJob&, std::int64_t begin, std::int64_t end, std::int64_t record_begin,
                   std::int64_t record_end, const float* slots);
};
inline constexpr int kLossRows =
    64;  // minimum rows of a loss band: with fewer, the duplicated work outweighs the gain from threads

namespace baseline {
const Kernel& kernel();
}
namespace avx2 {
const Kernel& kernel();
}
namespace avx512 {
const Kernel& kernel();
}
// The fastest kernel that this processor supports, or the one called `name` ("avx512", "avx2", "baseline"). Throws
// UsageError if the processor lacks it.
const Kernel& choose_kernel(const char* name = nullptr);

}  // namespace fastscene::splat
