// Networks that judge pictures, behind a plain-data interface: LPIPS (perceptual distance) and CLIP (agreement of
// picture and text).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

class LpipsMeasure {
  public:
    // backbone: torchvision's alexnet or vgg16 (.pth, .safetensors; features.N.weight); heads: the authors' lin0 … lin4
    // (alex.pth, vgg.pth). `net`: "alex" or "vgg". Throws Error naming the file, the tensor, expected and actual, or if
    // the network cannot tell pictures apart.
    LpipsMeasure(const std::string& net, const std::filesystem::path& backbone, const std::filesystem::path& heads);
    ~LpipsMeasure();
    // 0 = equal. Throws Error unless sizes are equal and sides at least 32.
    double distance(const ImageRgb8& a, const ImageRgb8& b) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

class ClipMeasure {
  public:
    // `place`: a folder as transformers saves a CLIPModel (config.json, model.safetensors or pytorch_model.bin, and
    // merges.txt in it or in tokenizer/), or a file of OpenAI's (ViT-B-32.pt or ViT-L-14.pt) as published in
    // TorchScript or as a state_dict (.pt, .safetensors), with merges.txt or bpe_simple_vocab_16e6.txt.gz next to it.
    // Throws Error naming the file, the tensor or key, expected and actual.
    explicit ClipMeasure(const std::filesystem::path& place);
    ~ClipMeasure();
    // The files that determine its results.
    const std::vector<std::filesystem::path>& files() const;
    // The network's patch size in pixels (32: ViT-B/32, 14: ViT-L/14), and its input size (224; 336 in ViT-L/14@336px).
    int patch() const;
    int picture_side() const;
    // Unit vectors in the joint space. Batches are faster: the weights are read from memory once.
    std::vector<float> of_picture(const ImageRgb8& image) const;
    std::vector<std::vector<float>> of_pictures(const std::vector<const ImageRgb8*>& images) const;
    std::vector<float> of_text(const std::string& text) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};
double cosine(const std::vector<float>& a, const std::vector<float>& b);

}  // namespace fastscene
