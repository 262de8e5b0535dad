// What a backend of splats is: steps of training, and pictures. A backend may keep the splats to itself and run behind:
// store() brings them back.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fastscene/base/registry.h"
#include "fastscene/scene/view.h"
#include "fastscene/splat/engine.h"
#include "fastscene/splat/relocate.h"
#include "fastscene/splat/splat.h"

namespace fastscene::splat {

struct StepPlan {
    float lambda_dssim = 0.2f;
    Vec3f background;
    StepRates rates;
    float depth_strength = 0;  // weight of the depth loss (depth_loss.h), if there are target depths
    float outside_m = std::numeric_limits<float>::infinity();  // Engine::set_outside
    float alpha_strength = 0;                                  // weight of the mean remaining transmittance
    bool judge = true;   // whether to collect statistics for density control: each splat's blending weight and error
    bool moves = false;  // … and its screen-space gradients
};
// The target depth of a view; valid until the next call.
using DepthOf = std::function<const ImageF&(const View&)>;
struct Stepper {
    virtual ~Stepper() = default;
    virtual std::string device() const = 0;  // FittedSplats::device
    // Takes over the splats, or what was changed about them.
    virtual void load(const Cloud& cloud) = 0;
    // The views of the steps to come, which must live as long, and their target depths, if there are any.
    virtual void set_views(std::vector<const View*> views, DepthOf depth_of) = 0;
    // Renders views[view], backpropagates and applies Adam; may return before it is done.
    virtual void step(Cloud& cloud, std::size_t view, const StepPlan& plan) = 0;
    // Density control (relocate.h) without bringing the splats back; false: the backend cannot, the caller must.
    virtual bool relocate(float growth, const Relocation& how, std::uint64_t seed, int step) = 0;
    // The losses of steps done and not yet returned, in order.
    virtual std::vector<LossSums> losses() = 0;
    // Waits for all steps, and brings `cloud` up to date.
    virtual void store(Cloud& cloud) = 0;
};
// Renders pictures of the same splats (SplatRenderer).
struct Renderer {
    virtual ~Renderer() = default;
    virtual SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                                 CameraModel model) = 0;
};
// Black and empty, of the camera's size.
SplatPicture empty_picture(const Pinhole& camera);

// Throws UsageError for an unknown backend or device.
std::unique_ptr<Stepper> make_stepper(const SplatBackend& backend);

}  // namespace fastscene::splat

namespace fastscene {

// A way to render and train splats, in a source file of its own under splat/splat_backends/. Flags, --help, errors and
// the contract tests take their lists from the registry.
struct SplatBackendEntry {
    std::string name = {};   // as its source file
    std::string about = {};  // half a sentence, for --help
    // Throws UsageError naming `flag` for a device that there is not, and with all of them for "list". Null: there is
    // no choice.
    void (*check_device)(const std::string& device, const std::string& flag) = nullptr;
    // `device`: SplatBackend::device. Throw UsageError for a device that there is not; the splats must live as long as
    // their renderer.
    std::unique_ptr<splat::Stepper> (*make_stepper)(const std::string& device) = nullptr;
    std::unique_ptr<splat::Renderer> (*make_renderer)(const Splats& splats, const std::string& device) = nullptr;
};

// Throws UsageError naming `flag` for a device that the backend has not, and with all devices for "list".
void check_device(const SplatBackend& backend, const std::string& flag);

}  // namespace fastscene
