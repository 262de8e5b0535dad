// Any depth network exported as TorchScript: panorama in, range or disparity out. What it wants is said by flags, or by
// the JSON beside the file: {"output": "range" | "disparity" | "metres", "width": 1024, "normalize": "unit" |
// "imagenet" | "symmetric", "key": name or number of the output}.
#include <algorithm>
#include <cmath>

#include "fastscene/depth/align.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/image/color.h"
#include "fastscene/nn/scripted.h"

namespace fastscene::depth_backends {
namespace {

constexpr int kUsualWidth = 1024;
constexpr float kFarthest_m = 1000;  // of an output in metres: beyond is the sky

struct Wishes {
    std::string output = "range", normalize = "unit", key;
    int width = kUsualWidth;
};

Wishes wishes_of(const DepthParams& params) {
    const std::filesystem::path file = params.weights;
    const Json json = beside_network(file);
    Wishes out;
    const auto refuse = [&](const char* name, const char* expected) {
        throw Error("{}: the JSON beside it: expected {} as \"{}\", found {}", file.string(), expected, name,
                    json.at(name).dump().substr(0, 60));
    };
    const auto word = [&](const char* name, const std::string& flag, std::string& value,
                          const std::vector<std::string>& known) {
        if (flag != "auto") value = flag;
        else if (json.contains(name)) {
            if (!json.at(name).is_string()) refuse(name, "a word");
            value = json.at(name).get<std::string>();
            if (std::find(known.begin(), known.end(), value) == known.end()) refuse(name, any_of(known).c_str());
        }
    };
    word("output", params.script_output, out.output, {"range", "disparity", "metres"});
    word("normalize", params.script_normalize, out.normalize, {"unit", "imagenet", "symmetric"});
    if (params.script_width > 0) out.width = params.script_width;
    else if (json.contains("width")) {
        if (!json.at("width").is_number_integer() || json.at("width") < 64 || json.at("width") > 8192)
            refuse("width", "64 to 8192");
        out.width = json.at("width").get<int>();
    }
    if (out.width % 2 != 0) throw Error("{}: expected an even width, found {}", file.string(), out.width);
    if (json.contains("key"))
        out.key = json.at("key").is_string() ? json.at("key").get<std::string>() : json.at("key").dump();
    return out;
}

// Mean and deviation that a network's input is normalized with.
struct Normal {
    Vec3f mean, deviation;
};
Normal normal_of(const std::string& name) {
    if (name == "imagenet") return {{0.485f, 0.456f, 0.406f}, {0.229f, 0.224f, 0.225f}};
    if (name == "symmetric") return {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}};
    return {{0, 0, 0}, {1, 1, 1}};
}

class TorchscriptEstimator final : public DepthEstimator {
  public:
    TorchscriptEstimator(ScriptedNetwork network, Wishes wishes, const DepthParams& params)
        : network_(std::move(network)),
          wishes_(std::move(wishes)),
          camera_height_m_(params.camera_height_m),
          turns_(std::max(1, params.tta)) {}

    EstimatedRange estimate(const ImageColor& color, const Run& run) const override {
        const ImageF found = mean_over_turns(equirect_from_equirect(color, {wishes_.width, wishes_.width / 2}), run);
        Json about{{"backend", "torchscript"},
                   {"weights", network_.file().filename().string()},
                   {"sha256", network_.sha256()},
                   {"output", wishes_.output},
                   {"width", wishes_.width}};
        if (wishes_.output == "metres") return {aligned_to_picture(found, color), about};
        return in_metres(found, color, camera_height_m_, UnknownOfRange::scale_and_shift, std::move(about), run);
    }

  private:
    // The panorama begins at another column each time, so that the seam is not where the network's border is.
    ImageF mean_over_turns(const ImageColor& color, const Run& run) const {
        ImageF mean;
        for (int turn = 0; turn < turns_; ++turn) {
            const int shift = turn * color.width / turns_;
            const ImageF found = distances(color, shift, run);
            if (mean.empty()) mean = ImageF(found.width, found.height);
            const int back = static_cast<int>(std::int64_t{shift} * found.width / color.width);
            for (int y = 0; y < found.height; ++y)
                for (int x = 0; x < found.width; ++x)
                    mean.at(wrap_column(x + back, found.width), y) += found.at(x, y) / static_cast<float>(turns_);
        }
        return mean;
    }
    // Grows with distance; metres if the network says metres.
    ImageF distances(const ImageColor& color, int shift, const Run& run) const {
        const Normal normal = normal_of(wishes_.normalize);
        PicturePlanes input(3, color.width, color.height);
        for (int y = 0; y < color.height; ++y)
            for (int x = 0; x < color.width; ++x) {
                const Vec3f v = srgb_from_linear(color.at(wrap_column(x + shift, color.width), y));
                for (std::size_t c = 0; c < 3; ++c)
                    input.at(static_cast<int>(c), x, y) = (std::clamp(v[c], 0.f, 1.f) - normal.mean[c]) /
                                                          normal.deviation[c];
            }
        const PicturePlanes out = network_.run({std::move(input)}, wishes_.key, run);
        if (out.count != 1 || out.width != 2 * out.height)
            throw Error("{}: expected one plane twice as wide as high, found {} of {} x {}", network_.file().string(),
                        out.count, out.width, out.height);
        return as_distance(out);
    }
    ImageF as_distance(const PicturePlanes& out) const {
        ImageF found(out.width, out.height);
        found.pixels = out.values;
        const float most = *std::max_element(found.pixels.begin(), found.pixels.end());
        if (!std::all_of(found.pixels.begin(), found.pixels.end(), [](float v) { return std::isfinite(v); }))
            throw Error("{}: expected finite numbers, found NaN or infinity in its output", network_.file().string());
        if (!(most > 0)) throw Error("{}: expected positive numbers, found none above 0", network_.file().string());
        constexpr float kLeastShare = 1e-3f;  // of the greatest disparity: farther than that is the same
        for (float& v : found.pixels)
            if (wishes_.output == "disparity") v = 1 / std::max(v, kLeastShare * most);
            else if (wishes_.output == "metres") v = std::clamp(v, 0.01f, kFarthest_m);
        return found;
    }

    ScriptedNetwork network_;
    Wishes wishes_;
    float camera_height_m_;
    int turns_;
};

std::unique_ptr<DepthEstimator> make_torchscript(const DepthParams& params) {
    if (params.weights.empty())
        throw UsageError("--depth-backend torchscript: expected --depth-weights FILE, found none");
    ScriptedNetwork network = ScriptedNetwork::load(params.weights, params.trusted, {params.device, "--depth-device"});
    return std::make_unique<TorchscriptEstimator>(std::move(network), wishes_of(params), params);
}

}  // namespace

DepthBackend torchscript() {
    return {.name = "torchscript",
            .about = "any network exported as TorchScript (--depth-weights, --trust)",
            .ready = [](const DepthParams& params) { return !params.weights.empty(); },
            .make = make_torchscript};
}

}  // namespace fastscene::depth_backends
