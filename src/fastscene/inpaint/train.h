// Training of AOT-GAN on hole masks of walks (made by walk/hole_dataset.h; official AOT-GAN folders of pictures and
// masks work, too).
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/nn/aotgan_training.h"

namespace fastscene {

struct InpaintTrainParams {
    int size = 512;
    double strange_masks = 0.5;
    double shrunk = 0;
    double most_open = 0.7;
    double jitter = 0.05;
    int held_out = 64;
    AotganTrainingParams network;
};
template <class V>
void visit_fields(InpaintTrainParams& p, V&& v) {
    v("size", p.size, Bounds{64, 2048}, "Side of the crops about holes that are trained on; a multiple of 8.");
    v("strange-masks", p.strange_masks, Bounds{0, 1},
      "Share of the examples that have another picture's holes besides their own.");
    v("shrunk", p.shrunk, Bounds{0, 1},
      "Share of the examples at half their size: faces of a small panorama are soft, those of a large one are not.");
    v("most-open", p.most_open, Bounds{0.01, 1}, "Crops with a larger share of holes are left out.");
    v("jitter", p.jitter, Bounds{0, 1}, "How far brightness, contrast and balance of the colors stray.");
    v("held-out", p.held_out, Bounds{1, 100000}, "Held-out examples whose figures are measured while training.");
    visit_fields(p.network, v);
}

// Paths of faces and their masks, sorted.
struct HoleSet {
    struct Face {
        std::filesystem::path image;
        std::vector<std::filesystem::path> masks;
    };
    std::vector<Face> faces;
};
// `part`: a folder with images/ and masks/: DIR/train, DIR/held-out. Throws UsageError if no face has a mask.
HoleSet find_holes(const std::filesystem::path& part);

// A random example: a crop with a hole, sometimes flipped. Unreadable pictures are skipped and counted in `broken`.
// `still`: deterministic evaluation, without flips and color jitter, with the face's own masks.
InpaintExample draw_example(const HoleSet& set, const InpaintTrainParams& params, bool still, Random& rng,
                            std::atomic<std::int64_t>& broken);

// Trains `folder`/generator.safetensors on `data`/train and `data`/held-out. Returns the metrics on the held-out
// examples.
std::vector<std::pair<std::string, double>> train_inpainter(const std::filesystem::path& data,
                                                            const InpaintTrainParams& params,
                                                            const std::filesystem::path& folder, const Run& run);

}  // namespace fastscene
