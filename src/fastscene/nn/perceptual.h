// Networks that judge pictures, behind plain data: LPIPS (how different do two pictures look) and CLIP (does a picture
// fit a sentence).
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
    // (alex.pth, vgg.pth). `net`: "alex" or "vgg". Throws Error naming the file, the tensor, expected and found; so
    // when the network tells nothing apart.
    LpipsMeasure(const std::string& net, const std::filesystem::path& backbone, const std::filesystem::path& heads);
    ~LpipsMeasure();
    // 0 = equal. Sizes must be equal, sides at least 32 (Error).
    double distance(const ImageRgb8& a, const ImageRgb8& b) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

class ClipMeasure {
  public:
    // A folder as transformers saves CLIPModel: config.json, model.safetensors or pytorch_model.bin, and merges.txt (in
    // it or in tokenizer/). Or a file of OpenAI's, ViT-B-32.pt or ViT-L-14.pt, as published (TorchScript) or as a
    // state_dict (.pt, .safetensors), with merges.txt or bpe_simple_vocab_16e6.txt.gz beside it. Throws Error naming
    // the file, the tensor or key, what was expected and what was found.
    explicit ClipMeasure(const std::filesystem::path& place);
    ~ClipMeasure();
    // The files that its numbers come from.
    const std::vector<std::filesystem::path>& files() const;
    // Which network it is: pixels of a patch's side (32: ViT-B/32, 14: ViT-L/14), and of the picture that it is shown
    // (224; 336 in ViT-L/14@336px).
    int patch() const;
    int picture_side() const;
    // Unit vectors in the common space. Several pictures at a time take less: the weights come from memory once for
    // all.
    std::vector<float> of_picture(const ImageRgb8& image) const;
    std::vector<std::vector<float>> of_pictures(const std::vector<const ImageRgb8*>& images) const;
    std::vector<float> of_text(const std::string& text) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};
double cosine(const std::vector<float>& a, const std::vector<float>& b);

}  // namespace fastscene
