// Peers: results of other systems, measured by the same code. A peer's folder has, for each scene of the suite, by its
// name:
// SCENE/*.png, *.jpg: its own renderings, evaluated as they are (`stills`);
// SCENE/source.png: its panorama at panorama 0's position (`source`);
// SCENE.ply or another splat format: Gaussian splats in our frame, rendered by our renderer with the suite's cameras,
// for every measure; SCENE/minutes.txt: its duration; minutes.txt beside the scenes: one figure for all of them.
// bench/peers/ converts the outputs of several systems to this layout.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// Our own finished run of a scene, which provides its cameras, panorama and room.
struct OwnRun {
    RunFolder folder;
    std::filesystem::path truth;  // cache of its ground truth
};
struct PeerInputs {
    const Suite& suite;
    std::filesystem::path out, weights;
    std::function<std::optional<OwnRun>(const SuiteScene&)> own_run;
};

// Throws UsageError for a duplicate row name, a folder without any of the suite's scenes, or a suite without measures
// for peers. Writes nothing.
void check_peers(const std::vector<SuitePeer>& peers, const Suite& suite);
// One record per scene, in evaluate's format.
std::vector<Json> peer_records(const SuitePeer& peer, const PeerInputs& inputs, const Run& run);

}  // namespace fastscene
