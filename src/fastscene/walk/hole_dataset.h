// Hole dataset (paper, "Panoramic Inpainting Dataset"): from panoramas with range, the disocclusion holes of a walk, on
// cube faces, as training data for inpainting. Uses the same code as the walk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/walk/panorama_files.h"

namespace fastscene {

struct HoleDatasetParams {
    int size = 512;
    std::string warp = "paper";
    std::string shares = "0.02,0.04", metres = "0.15,0.4";
    int held_out = 5;
    int shard = 1000;
};
template <class V>
void visit_fields(HoleDatasetParams& p, V&& v) {
    v("size", p.size, Bounds{16, 4096}, "Side of a cube face in pixels.");
    v("warp", p.warp, Choices{{"paper", "ours", "both"}},
      "Whose coarse view tears the holes: the paper's, which throws single pixels; our mesh; or each in its turn.");
    v("shares", p.shares,
      "The paper's warp: distances of a step, as shares of the greatest range, in eight directions each.");
    v("metres", p.metres, "Our warp: the same in metres.");
    v("held-out", p.held_out, Bounds{0, 50},
      "Percent of the places (rooms, houses) whose pictures are kept for testing.");
    v("shard", p.shard, Bounds{1, 100000}, "Panoramas in a folder.");
}

struct HoleDatasetState {
    std::int64_t panoramas = 0, there = 0, made = 0, broken = 0;
    std::int64_t faces = 0, masks = 0;  // currently in the folder
};
// DIR/train and DIR/held-out contain
// images/shard-00000/00000042-front.png: a face without holes;
// masks/shard-00000/00000042-front-03.png: white = hole, numbered by (distance, direction), the paper's warp first;
// and DIR/done/00000042.json, written last, marks panorama 42 as complete. Existing results are kept; unreadable
// panoramas are skipped with a warning, counted, and retried next time. Throws UsageError if DIR holds a set with other
// settings, Error if no panorama at all could be read.
HoleDatasetState make_hole_dataset(const std::vector<PanoramaFiles>& panoramas, const HoleDatasetParams& params,
                                   const std::filesystem::path& folder, const Run& run);

// All hole masks of a panorama (nonzero = hole), in the dataset's order.
std::vector<ImageMask> walk_holes(const Panorama& panorama, const HoleDatasetParams& params);

}  // namespace fastscene
