// Splats with an instance each: computed from a run's room, or read from files that `export` wrote.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "fastscene/export/instances.h"
#include "fastscene/scene/splats.h"
#include "fastscene/trace/trace.h"

namespace fastscene::cli {

struct LabelledScene {
    Splats splats;
    std::vector<std::uint16_t> labels;  // one per splat: index into `instances`
    std::vector<Instance> instances;
};
LabelledScene labelled_scene(const std::filesystem::path& run_folder, const TracedRoom& room, const Run& run);
// `place`: the folder of a run; a .ply that `export` wrote; or any splats NAME.ply with NAME.labels.npy and
// NAME.labels.json beside them. Throws UsageError for splats without labels.
LabelledScene load_labelled(const std::filesystem::path& place, const Run& run);
// PLY with an "instance" per splat, and what the numbers mean in its comments.
void save_labelled_ply(const std::filesystem::path& file, const LabelledScene& scene);

// scene.labels.npy -> scene.labels.json
std::filesystem::path instances_beside(const std::filesystem::path& npy);

}  // namespace fastscene::cli
