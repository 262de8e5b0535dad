#include "fastscene/nn/da2_net.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/check.h"
#include "fastscene/nn/da2_head.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/shape_list.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

constexpr double kFarQuantile = 0.98;     // of the distances: becomes 1
constexpr double kLeast = -8, kMost = 8;  // of the logarithm
constexpr double kLift = 2;               // added to it; cancels but for rounding

std::int64_t whole_patches(double pixels) {
    const auto whole = static_cast<std::int64_t>(pixels);
    return (whole + kDinoPatch - 1) / kDinoPatch * kDinoPatch;
}

// Less ImageNet's mean, by its deviation.
Tensor normalized(const Tensor& color) {
    const auto per_channel = [&](std::initializer_list<float> values) {
        return at::tensor(at::ArrayRef<float>(values), at::kFloat).view({1, 3, 1, 1}).to(color.device());
    };
    return (color - per_channel({0.485f, 0.456f, 0.406f})) / per_channel({0.229f, 0.224f, 0.225f});
}

Tensor embedded_angles(const Scope& root, const Da2Shape& shape, const Da2Size& size) {
    if (root.is_heard()) (root / "sphere_dirs").out(sphere_directions(size.height, size.width, size.sphere));
    const std::int64_t rows = size.height / kDinoPatch, columns = size.width / kDinoPatch;
    // As published, a patch looks where its top left pixel does, not its middle.
    const Tensor angles = (root / "sphere_angles")
                              .out(sphere_angles(sphere_directions(rows, columns, size.sphere, kDinoPatch)));
    return (root / "sphere_embeddings").out(sphere_embedding(angles, shape.features / 2, std::max(rows, columns) / 2));
}

}  // namespace

NamedShapes da2_parameters(const Da2Shape& shape) {
    ShapeList list;
    const Da2Size two_patches{kDinoPatch, 2 * kDinoPatch, {2 * kDinoPatch, kDinoPatch}};
    da2_log_distance(Scope(list), shape, at::zeros({1, 3, two_patches.height, two_patches.width}), two_patches);
    return list.shapes();
}

NamedShapes da2_unused(const Da2Shape& shape) {
    const std::string head = "vit_w_esphere._vit_w_esphere.";
    const std::int64_t width = shape.dino.width, c = shape.features;
    return {{"dino.register_tokens", {1, 1, width}},
            {"dino.mask_token", {1, width}},
            {head + "to_confidence_lr.weight", {c / 8, c / 4, 3, 3}},
            {head + "to_confidence_lr.bias", {c / 8}},
            {head + "to_confidence_hr.0.weight", {c / 16, c / 8, 3, 3}},
            {head + "to_confidence_hr.0.bias", {c / 16}},
            {head + "to_confidence_hr.2.weight", {1, c / 16, 1, 1}},
            {head + "to_confidence_hr.2.bias", {1}}};
}

Da2Size da2_size(std::int64_t height, std::int64_t width, const Da2Config& config) {
    FASTSCENE_CHECK(height > 0 && width > 0);
    const double h = static_cast<double>(height), w = static_cast<double>(width);
    const double pixels = std::min(config.max_pixels, std::max(config.min_pixels, h * w));
    const double factor = std::sqrt(pixels / (h * w));
    return {whole_patches(h * factor),
            whole_patches(w * factor),
            {config.sphere.width * factor, config.sphere.height * factor}};
}

Tensor da2_log_distance(const Scope& root, const Da2Shape& shape, const Tensor& color, const Da2Size& size, bool bf16) {
    const Tensor seen = (root / "preprocessed")
                            .out(normalized(at::upsample_bilinear2d(color, {size.height, size.width}, false)));
    const Tensor embedding = embedded_angles(root, shape, size).to(color.device());
    const std::array<Tensor, 4> maps = [&] {
        const Autocast autocast(color.device(), bf16);
        return dino_features(root, shape.dino, seen);
    }();
    return (root / "logdistance").out(da2_head(root, shape.features, maps, embedding, size.height, size.width, bf16));
}

Tensor da2(const Scope& root, const Da2Shape& shape, const Tensor& color, const Da2Config& config, bool bf16) {
    const std::int64_t height = color.size(2), width = color.size(3);
    const Tensor log = da2_log_distance(root, shape, color, da2_size(height, width, config), bf16);
    const Tensor distance = at::exp(at::clamp(log, kLeast, kMost) + kLift);
    const Tensor far = (root / "quantile98").out(at::quantile(distance.flatten(), kFarQuantile));
    const Tensor relative = (root / "distance_model_size").out(distance / far);
    return at::upsample_bilinear2d(relative, {height, width}, false).squeeze(1);
}

}  // namespace fastscene::nn
