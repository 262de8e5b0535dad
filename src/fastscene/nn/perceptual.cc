#include "fastscene/nn/perceptual.h"

#include <c10/core/InferenceMode.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/base/random.h"
#include "fastscene/nn/clip_image.h"
#include "fastscene/nn/clip_openai.h"
#include "fastscene/nn/file_weights.h"
#include "fastscene/nn/lpips.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/tokenizer.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {
namespace fs = std::filesystem;

using at::Tensor;
using nn::FileWeights;
using nn::Scope;

namespace {

constexpr int kLeastSide = 32;  // minimum input size of the backbone

Tensor tensor_of(const ImageRgb8& image) {  // [3, H, W], 0..255
    const Tensor bytes = at::from_blob(const_cast<Rgb8*>(image.pixels.data()), {image.height, image.width, 3},
                                       at::kByte);
    return bytes.permute({2, 0, 1}).to(at::kFloat).contiguous();
}

ImageRgb8 noise(int side) {
    Random random(1, "lpips");
    const auto level = [&] { return static_cast<std::uint8_t>(random.index(256)); };
    ImageRgb8 out(side, side);
    for (Rgb8& p : out.pixels) p = {level(), level(), level()};
    return out;
}

std::vector<float> unit_features(const Tensor& features) {
    const Tensor row = (features / features.norm()).to(at::kFloat).flatten().contiguous();
    return {row.data_ptr<float>(), row.data_ptr<float>() + row.numel()};
}

}  // namespace

struct LpipsMeasure::Parts {
    nn::LpipsNet net;
    FileWeights backbone, heads;
};

LpipsMeasure::LpipsMeasure(const std::string& net, const fs::path& backbone, const fs::path& heads)
    : parts_(new Parts{net == "vgg" ? nn::LpipsNet::vgg : nn::LpipsNet::alex, FileWeights(backbone, at::kFloat),
                       FileWeights(heads, at::kFloat)}) {
    // Checks all tensors, and that the network responds: with all-zero weights every distance would be 0, a perfect
    // score.
    const double seen = distance(ImageRgb8(kLeastSide, kLeastSide), noise(kLeastSide));
    if (!(seen > 0) || !std::isfinite(seen))
        throw Error(
            "{}: expected a network that with {} tells black from noise, found a distance of {} (weights of zeros, or "
            "damaged?)",
            backbone.string(), heads.string(), seen);
}
LpipsMeasure::~LpipsMeasure() = default;

double LpipsMeasure::distance(const ImageRgb8& a, const ImageRgb8& b) const {
    if (!a.same_size(b))
        throw Error("LPIPS: expected pictures of one size, found {} x {} and {} x {}", a.width, a.height, b.width,
                    b.height);
    if (a.width < kLeastSide || a.height < kLeastSide)
        throw Error("LPIPS: expected a picture of at least {0} x {0} pixels, found {1} x {2}", kLeastSide, a.width,
                    a.height);
    const c10::InferenceMode inference;
    use_our_threads();
    const auto input = [](const ImageRgb8& image) { return (tensor_of(image) / 127.5 - 1).unsqueeze(0); };
    return nn::lpips(Scope(parts_->backbone), Scope(parts_->heads), parts_->net, input(a), input(b))
        .distance.item<double>();
}

namespace {

// Where a model folder keeps the tokenizer's merges.
fs::path vocabulary_in(const fs::path& folder) {
    for (const fs::path& place : {folder / "tokenizer", folder})
        if (fs::exists(place / "merges.txt")) return place;
    if (fs::exists(folder / "bpe_simple_vocab_16e6.txt.gz")) return folder / "bpe_simple_vocab_16e6.txt.gz";
    throw Error("{}: expected CLIP's merges.txt or bpe_simple_vocab_16e6.txt.gz, found neither", folder.string());
}

}  // namespace

struct ClipMeasure::Parts {
    nn::ClipConfig config;
    std::unique_ptr<nn::WeightSource> weights;
    std::vector<fs::path> files;
    ClipTokenizer tokenizer;

    explicit Parts(const fs::path& place)
        : tokenizer(vocabulary_in(fs::is_directory(place) ? place : place.parent_path())) {
        fs::is_directory(place) ? read_folder(place) : read_file_of_openai(place);
        if (config.text.positions < ClipTokenizer::kContext || config.text.vocabulary <= ClipTokenizer::kEnd)
            throw Error("{}: expected a text tower for {} places and {} pieces, found {} and {}", place.string(),
                        ClipTokenizer::kContext, ClipTokenizer::kEnd + 1, config.text.positions,
                        config.text.vocabulary);
    }
    void read_folder(const fs::path& folder) {
        const fs::path file = folder / "config.json";
        config = nn::clip_config(read_json(file), file.string());
        auto found = std::make_unique<FileWeights>(folder, at::kFloat);
        files = found->files();
        weights = std::move(found);
    }
    void read_file_of_openai(const fs::path& file) {
        nn::OpenAiClip clip = nn::openai_clip(load_weights(file));
        config = clip.config;
        files = {file};
        weights = std::make_unique<nn::LoadedWeights>(std::move(clip.weights), at::kFloat);
    }
};

ClipMeasure::ClipMeasure(const fs::path& place) : parts_(std::make_unique<Parts>(place)) {
    // Checks names and shapes of all tensors, independent of any input, so nothing is computed.
    const c10::InferenceMode inference;
    const Scope scope(*parts_->weights);
    const auto& [text, vision, dimension] = parts_->config;
    nn::clip_text_features(scope, text, at::zeros({0, ClipTokenizer::kContext}, at::kLong), dimension);
    nn::clip_image_features(scope, vision, at::zeros({0, 3, vision.image_size, vision.image_size}), dimension);
}
const std::vector<fs::path>& ClipMeasure::files() const { return parts_->files; }
int ClipMeasure::patch() const { return static_cast<int>(parts_->config.vision.patch); }
int ClipMeasure::picture_side() const { return static_cast<int>(parts_->config.vision.image_size); }
ClipMeasure::~ClipMeasure() = default;

std::vector<float> ClipMeasure::of_picture(const ImageRgb8& image) const { return of_pictures({&image}).front(); }

std::vector<std::vector<float>> ClipMeasure::of_pictures(const std::vector<const ImageRgb8*>& images) const {
    const c10::InferenceMode inference;
    use_our_threads();
    const auto row = [](double r, double g, double b) {
        return at::tensor(std::vector<double>{r, g, b}, at::kFloat).reshape({3, 1, 1});
    };
    const Tensor mean = row(.48145466, .4578275, .40821073), deviation = row(.26862954, .26130258, .27577711);
    std::vector<Tensor> normalized;
    for (const ImageRgb8* image : images)
        normalized.push_back((tensor_of(clip_crop(*image, picture_side())) / 255 - mean) / deviation);
    const Tensor features = nn::clip_image_features(Scope(*parts_->weights), parts_->config.vision,
                                                    at::stack(normalized), parts_->config.dimension);
    std::vector<std::vector<float>> out;
    for (const Tensor& of_one : features.unbind()) out.push_back(unit_features(of_one));
    return out;
}

std::vector<float> ClipMeasure::of_text(const std::string& text) const {
    const c10::InferenceMode inference;
    use_our_threads();
    const std::vector<int> tokens = parts_->tokenizer.padded(text, 0);
    const Tensor ids = at::tensor(std::vector<std::int64_t>(tokens.begin(), tokens.end()), at::kLong).unsqueeze(0);
    return unit_features(
        nn::clip_text_features(Scope(*parts_->weights), parts_->config.text, ids, parts_->config.dimension));
}

double cosine(const std::vector<float>& a, const std::vector<float>& b) {
    FASTSCENE_CHECK_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(a[i]) * b[i];
    return sum;
}

}  // namespace fastscene
