// The CPU renderer with gradients. Owns all memory of a picture in progress, divides the work into pieces that any
// thread may take, and keeps the order of every sum fixed, so that results are bit-identical for any number of threads.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fastscene/geometry/pinhole.h"
#include "fastscene/math/rigid.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/view.h"
#include "fastscene/splat/aligned.h"
#include "fastscene/splat/kernel.h"
#include "fastscene/splat/sh_color.h"

namespace fastscene::splat {

Lens<float> lens_of(const Pinhole& camera, const Rigid& world_from_camera, CameraModel model = CameraModel::pinhole,
                    const FootprintFilter& filter = {});

// Weight of a row in an equirectangular picture: proportional to the solid angle it shows, the cosine of the latitude.
inline float latitude_weight(int y, int height) {
    return std::sin((static_cast<float>(y) + 0.5f) / static_cast<float>(height) * std::numbers::pi_v<float>);
}

// The parameters in the kernels' layout, with Adam's two moments.
struct Cloud {
    std::int64_t count = 0;
    AlignedFloats parameters, first_moment, second_moment;
    AlignedFloats seen_weight, seen_error;  // per splat, summed since the last clear
    AlignedFloats seen_move, seen_steps;    // the same, allocated only if density control needs it
    int degree = 0;                         // degree of the spherical harmonics
    AlignedFloats rest, rest_first_moment,
        rest_second_moment;     // blocks of 3 * rest_functions(degree) numbers, laid out like the parameters
    std::int64_t capacity = 0;  // number of splats that memory is allocated for
    FootprintFilter filter;     // Splats::filter

    Cloud(const Splats& splats, bool train, std::int64_t room_for = 0);
    Splats splats() const;
    std::size_t rest_at(std::int64_t splat, int i) const {
        return static_cast<std::size_t>(splat / kBlock * kBlock * 3 * rest_functions(degree) + i * kBlock +
                                        splat % kBlock);
    }
    std::int64_t padded() const { return (count + kBlock - 1) / kBlock * kBlock; }
    std::size_t at(std::int64_t splat, int parameter) const {
        return static_cast<std::size_t>(splat / kBlock * kBlock * kParameters + parameter * kBlock + splat % kBlock);
    }
};

// CPU time in milliseconds, over all threads, for each part of a step; summed since the last clear.
struct StepTimes {
    double project = 0, sort = 0, bin = 0, forward = 0, loss = 0, backward = 0, update = 0;
};

// The settings of a step besides the gradients.
struct StepRates {
    std::array<float, kParameters> rates{};
    int adam_step = 1;  // counts from 1
    // Position step sizes are meant for splats within reach_m of `middle`. Beyond it they grow in proportion to the
    // distance, so that near and far splats move equally on screen.
    Vec3f middle{};
    float reach_m = std::numeric_limits<float>::infinity();
    float rest_rate = 0;  // learning rate of SH degrees >= 1; 0: not updated in this step
    int rest_adam_step = 1;
    float opacity_reg = 0, scale_reg = 0;  // weights of the mean opacity and of the mean scale
};

class Engine {
  public:
    explicit Engine(const Kernel& kernel) : kernel_(kernel) {}

    // Forward pass; `depth` requests the depth plane too.
    void render(const Cloud& cloud, const Pinhole& camera, const Rigid& world_from_camera, Vec3f background, bool depth,
                CameraModel model = CameraModel::pinhole);
    // After render(): the loss against the view, and dL/d color.
    LossSums differentiate(const View& view, float lambda_dssim, bool judge = true);
    // After differentiate(), if render() computed depth: adds `strength` times the mean relative depth error
    // (depth_loss.h) and returns it. `depth`: metres along the optical axis (equirectangular: along the ray), 0 =
    // unknown.
    double differentiate_depth(const View& view, const ImageF& depth, float strength);
    // After either: adds `strength` times the mean remaining transmittance, which pushes pictures towards full opacity,
    // and returns it.
    double differentiate_transmittance(const View& view, float strength);
    // Splats deeper than this belong to the outside. They are trained only by pixels that mostly show it
    // (kOutsideVisible): walls are never fully opaque, and Adam takes full steps however small the gradient.
    void set_outside(float depth_m) { outside_m_ = depth_m; }
    // After render(): sets dL/d color directly (tests). Three planes of width * height.
    void set_color_gradient(const std::vector<Vec3f>& v);
    // After any of these: backpropagates to the splats and applies one step of Adam.
    void step(Cloud& cloud, const StepRates& rates);
    void step(Cloud& cloud, const std::array<float, kParameters>& rates, int adam_step) {
        step(cloud, StepRates{rates, adam_step});
    }
    // … or only returns the gradients, in the kernels' layout; those of SH degrees >= 1 in `rest`.
    AlignedFloats gradients(Cloud& cloud, AlignedFloats* rest = nullptr);

    Vec3f color(int x, int y) const;
    Vec3f color_gradient(int x, int y) const;
    float transmittance(int x, int y) const { return transmittance_[index(x, y)]; }
    float depth_sum(int x, int y) const { return depth_[index(x, y)]; }
    std::int64_t visible() const { return visible_; }
    std::int64_t entries() const { return static_cast<std::int64_t>(list_.size()); }
    // Of the last picture: how many pairs of a splat and a 4x4 pixel block were blended.
    std::int64_t block_visits() const;
    StepTimes times;

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(x);
    }
    void set_size(int width, int height);
    void project(const Cloud& cloud);
    void sort();
    void bin();
    Frame frame(bool depth);
    void backward();
    void update(Cloud& cloud, UpdateJob& job);

    const Kernel& kernel_;
    int width_ = 0, height_ = 0, tiles_x_ = 0, tiles_y_ = 0;
    std::ptrdiff_t stride_ = 0;
    Lens<float> lens_{};
    Vec3f background_;
    AlignedFloats color_[3], transmittance_, depth_, v_[3], error_[3], v_depth_, v_transmittance_;
    float outside_m_ = std::numeric_limits<float>::infinity();
    bool judges_ = false;                // the next gradient also collects statistics for density control
    bool depth_counts_ = false;          // the next gradient includes depth
    bool transmittance_counts_ = false;  // the next gradient includes transmittance
    // As written by projection, piece after piece, with gaps in between.
    AlignedVector<Record> records_;
    std::vector<std::uint64_t> piece_keys_;
    std::vector<TileBox> piece_boxes_;
    std::vector<PieceCount> pieces_;
    std::vector<std::uint32_t> piece_slot_;  // first gradient slot of each piece
    int records_a_piece() const { return kPiece * records_a_splat(lens_.model); }
    std::int64_t visible_ = 0, slots_used_ = 0;
    // In depth order.
    std::vector<std::uint64_t> keys_, keys_other_;
    std::vector<TileBox> boxes_;
    std::vector<std::uint32_t> piece_tiles_;  // per piece and tile: where its entries begin in the tile's list
    std::vector<std::uint32_t> tile_begin_, list_;
    std::vector<std::uint16_t> masks_;
    AlignedFloats slots_;
};

}  // namespace fastscene::splat
