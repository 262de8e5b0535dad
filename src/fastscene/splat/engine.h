// The CPU renderer and differentiator: owns the memory of a picture in progress, cuts the work into
// pieces that any thread may take, and keeps every sum in a fixed order (same bytes for any thread count).
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
                    bool antialias = false);

// Rows of an equirectangular picture count as much as the part of the sphere they show: the cosine of the latitude.
inline float latitude_weight(int y, int height) {
    return std::sin((static_cast<float>(y) + 0.5f) / static_cast<float>(height) * std::numbers::pi_v<float>);
}

// Parameters in the kernel's layout, with Adam's two moments.
struct Cloud {
    std::int64_t count = 0;
    AlignedFloats parameters, first_moment, second_moment;
    AlignedFloats seen_weight, seen_error;  // per splat, since they were last cleared
    AlignedFloats seen_move, seen_steps;    // the same, only where density control needs them
    int degree = 0;                         // of the spherical harmonics
    AlignedFloats rest, rest_first_moment,
        rest_second_moment;     // blocks of 3 * rest_functions(degree) numbers, like the parameters
    std::int64_t capacity = 0;  // splats there is memory for
    bool antialias = false;     // Splats::antialias

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

// CPU milliseconds, of all threads, per part of a step, summed since the last clear.
struct StepTimes {
    double project = 0, sort = 0, bin = 0, forward = 0, loss = 0, backward = 0, update = 0;
};

// What a step needs besides gradients.
struct StepRates {
    std::array<float, kParameters> rates{};
    int adam_step = 1;  // counts from 1
    // A step of the positions is meant for what stands within reach_m of the middle; what is farther away steps farther
    // in proportion, so that both move as much on the pictures.
    Vec3f middle{};
    float reach_m = std::numeric_limits<float>::infinity();
    float rest_rate = 0;  // of the higher bands; 0: not in this step
    int rest_adam_step = 1;
    float opacity_pull = 0, scale_pull = 0;  // UpdateJob
};

class Engine {
  public:
    explicit Engine(const Kernel& kernel) : kernel_(kernel) {}

    // Forward pass into the planes; `depth` also fills the depth plane.
    void render(const Cloud& cloud, const Pinhole& camera, const Rigid& world_from_camera, Vec3f background, bool depth,
                CameraModel model = CameraModel::pinhole);
    // After render(): loss against the view and dL/d color.
    LossSums differentiate(const View& view, float lambda_dssim, bool judge = true);
    // After that, if render() was asked for depth: adds `strength` times the mean relative error of depth
    // (depth_loss.h) and returns it. `depth`: metres along the optical axis (equirectangular: along the ray), 0 =
    // unknown.
    double differentiate_depth(const View& view, const ImageF& depth, float strength);
    // After either: adds `strength` times the mean transmittance that is left and returns it: pictures shall be opaque.
    double differentiate_transmittance(const View& view, float strength);
    // Splats of a larger depth than this are of the outside. They learn only in pixels where more than half of the
    // light comes from there: walls are never quite closed, and Adam takes full steps however small the gradient.
    void set_outside(float depth_m) { outside_m_ = depth_m; }
    // After render(): take dL/d color from the caller instead (tests). Three planes of width * height.
    void set_color_gradient(const std::vector<Vec3f>& v);
    // After either: gradients per splat; Adam with these step sizes moves the cloud.
    void step(Cloud& cloud, const StepRates& rates);
    void step(Cloud& cloud, const std::array<float, kParameters>& rates, int adam_step) {
        step(cloud, StepRates{rates, adam_step});
    }
    // … or only hands out the gradients, in the kernel's layout; those of the higher bands into `rest`.
    AlignedFloats gradients(Cloud& cloud, AlignedFloats* rest = nullptr);

    Vec3f color(int x, int y) const;
    Vec3f color_gradient(int x, int y) const;
    float transmittance(int x, int y) const { return transmittance_[index(x, y)]; }
    float depth_sum(int x, int y) const { return depth_[index(x, y)]; }
    std::int64_t visible() const { return visible_; }
    std::int64_t entries() const { return static_cast<std::int64_t>(list_.size()); }
    // Of the last picture: how often a splat met a block of 4x4 pixels, the unit of blending.
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
    bool judges_ = false;                // the gradient to come also sums what density control asks for
    bool depth_counts_ = false;          // in the gradient to come
    bool transmittance_counts_ = false;  // …
    // As projection left them, piece after piece of splats, with gaps between the pieces.
    AlignedVector<Record> records_;
    std::vector<std::uint64_t> piece_keys_;
    std::vector<TileBox> piece_boxes_;
    std::vector<PieceCount> pieces_;
    std::vector<std::uint32_t> piece_slot_;  // first gradient slot of each
    int records_a_piece() const { return kPiece * records_a_splat(lens_.model); }
    std::int64_t visible_ = 0, slots_used_ = 0;
    // In depth order.
    std::vector<std::uint64_t> keys_, keys_other_;
    std::vector<TileBox> boxes_;
    std::vector<std::uint32_t> piece_tiles_;  // per piece of them and tile: where in the tile's list it goes on
    std::vector<std::uint32_t> tile_begin_, list_;
    std::vector<std::uint16_t> masks_;
    AlignedFloats slots_;
};

}  // namespace fastscene::splat
