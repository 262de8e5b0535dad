// The renderer and trainer on a graphics card: the same steps as splat::Engine, all of them on the device. The host
// records steps ahead and learns of their losses afterwards.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/gpu/device.h"
#include "fastscene/scene/view.h"
#include "fastscene/splat/engine.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/backend.h"
#include "fastscene/splat/vulkan/tables.h"

namespace fastscene::splat::vulkan {

struct Kernels;

class VulkanEngine {
  public:
    // `device` as in gpu::choose_device(). Throws UsageError naming `flag`.
    explicit VulkanEngine(const std::string& device, const std::string& flag = "--splat-device");
    ~VulkanEngine();

    gpu::Device& device() { return device_; }
    const gpu::Device& device() const { return device_; }

    // Copies the splats to the device and back; their capacity is the host's. Both wait for all steps.
    void load(const Cloud& cloud);
    void store(Cloud& cloud);

    // The pictures of the steps to come, copied to the device; across the bus from the host's memory if they do not
    // fit.
    void set_views(const std::vector<const View*>& views, const DepthOf& depth_of = {});

    // Enqueues a step on views[view].
    void step(std::size_t view, const StepPlan& plan);
    // Enqueues density control: adds up to `growth` times the splats, then moves dead ones (splat/relocate.h), both
    // with random numbers of `seed`.
    void relocate(float growth, std::uint32_t seed);
    // Waits for all steps enqueued, and returns the losses of those not yet returned, in order.
    std::vector<LossSums> finish();
    // The losses that are known without waiting.
    std::vector<LossSums> losses();

    // A picture of the splats loaded; waits for it.
    SplatPicture render(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background, CameraModel model);

    // For tests: gradients of one step in the layout of Cloud, instead of the step. Without `view`, from dL/d color
    // in `v`, row by row.
    struct Gradients {
        AlignedFloats parameters, rest;
        LossSums loss;
    };
    Gradients gradients(const Cloud& cloud, const View& view, const ImageF* depth, const StepPlan& plan,
                        const std::vector<Vec3f>* v = nullptr);

    // Pairs of a splat and a tile that memory is reserved for. Grows when a step needs more; tests make it small.
    void reserve_pairs(std::int64_t pairs);
    std::int64_t reserved_pairs() const { return static_cast<std::int64_t>(pair_capacity_); }
    // Of the last step that is done.
    std::int64_t pairs() const { return pairs_; }

  private:
    struct Picture {  // a training view on the device
        Pinhole camera;
        Rigid world_from_camera;
        CameraModel model = CameraModel::pinhole;
        std::uint64_t target = 0, depth = 0;
    };
    struct Batch {
        explicit Batch(gpu::Device& device) : commands(device) {}
        gpu::Commands commands;
        gpu::Buffer mapped_plans, plans;
        std::vector<Plan> steps;
        bool is_recording = false, is_running = false;
        double started_s = 0;
        std::uint32_t first_outcome = 0;
    };

    Plan plan_of(const Pinhole& camera, const Rigid& world_from_camera, CameraModel model, Vec3f background) const;
    Plan plan_of(const Picture& picture, const StepPlan& step) const;
    void enqueue(const Plan& plan);
    void record(Batch& batch, const Plan& plan, std::uint64_t address);
    void submit();
    void collect_oldest();
    void repeat(std::vector<Plan> steps, std::uint32_t pairs);
    void drain();
    void reserve_pixels(int width, int height);
    void allocate_splats(std::int64_t capacity, int degree, bool train);
    void write_tables();
    void set_counters(std::uint32_t count);
    void record_density(Batch& batch, std::uint64_t address);
    std::uint32_t device_count();
    Batch& current() { return *batches_[batch_]; }

    gpu::Device device_;
    std::unique_ptr<Kernels> kernels_;
    Tables tables_{};
    gpu::Buffer tables_buffer_, counters_, histogram_, block_pairs_;
    // Of the splats.
    std::int64_t count_ = 0, most_ = 0, capacity_ = 0, records_ = 0;  // capacity_: whole blocks, at least most_
    int degree_ = 0;
    FootprintFilter filter_;
    bool trains_ = false;
    gpu::Buffer parameters_, first_moment_, second_moment_, rest_, rest_first_, rest_second_, seen_, gradients_,
        rest_gradients_;
    gpu::Buffer density_, density_errors_, density_dead_, density_claims_, density_choices_, density_ranks_,
        density_free_;
    gpu::Buffer records_buffer_, boxes_, first_pair_, depth_keys_[2], depth_records_[2];
    gpu::Buffer pair_tiles_[2], pair_records_[2], slots_;
    std::uint32_t pair_capacity_ = 0;
    std::uint32_t visible_ = 0, pairs_ = 0;  // records and pairs of the last step known
    // Of the picture.
    std::int64_t pixels_ = 0, tiles_ = 0;
    gpu::Buffer color_, depth_, maps_, v_, v_more_, tile_begin_, stops_, dssim_, sums_;
    std::vector<gpu::Buffer> view_memory_;
    std::vector<Picture> pictures_;

    std::vector<std::unique_ptr<Batch>> batches_;
    std::size_t batch_ = 0;        // the one being recorded
    std::deque<Batch*> running_;   // in the order of their submission
    std::size_t batch_limit_ = 1;  // steps
    gpu::Buffer outcomes_;
    double last_done_s_ = 0;
    std::vector<LossSums> losses_;
    std::uint32_t number_ = 0;  // of the last step enqueued, from 1
};

}  // namespace fastscene::splat::vulkan
