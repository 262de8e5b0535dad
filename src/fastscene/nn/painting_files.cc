#include "fastscene/nn/painting_files.h"

#include "fastscene/nn/file_weights.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

void add_weights(const fs::path& component, std::vector<fs::path>& files) {
    files.push_back(component / "config.json");
    for (const fs::path& file : nn::FileWeights(component, at::kFloat).files()) files.push_back(file);
}

void add_model(const fs::path& base, std::vector<fs::path>& files) {
    for (const char* part : {"unet", "vae", "text_encoder"}) add_weights(base / part, files);
    files.push_back(base / "scheduler/scheduler_config.json");
    for (const char* name : {"merges.txt", "special_tokens_map.json", "tokenizer_config.json"})
        if (fs::exists(base / "tokenizer" / name)) files.push_back(base / "tokenizer" / name);
}

}  // namespace

std::vector<fs::path> painting_files(const fs::path& weights, bool from_photo) {
    const fs::path inside = weights / (from_photo ? "sr-base" : "sd-base");
    std::vector<fs::path> files;
    add_model(!fs::exists(weights / "unet") && fs::exists(inside) ? inside : weights, files);
    if (from_photo) add_weights(weights / "sd-i2p", files);
    return files;
}

std::vector<fs::path> enlarging_files(const fs::path& weights, const std::string& to) {
    std::vector<fs::path> files;
    add_model(weights / "sr-base", files);
    add_weights(weights / "sr-control", files);
    if (to != "3") files.push_back(weights / "RealESRGAN_x2plus.pth");
    return files;
}

}  // namespace fastscene
