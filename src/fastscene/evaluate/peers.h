// Peers: what another system made, measured by the same code. A peer's folder holds for each scene of the suite, by its
// name,
//   SCENE/*.png, *.jpg     its own renders, judged as they are (`stills`),
//   SCENE/source.png       its picture all around from panorama 0's place (`source`),
//   SCENE.ply .spz .glb    Gaussian splats in our frame, drawn by our renderer at the suite's own cameras: for every
//   measure, SCENE/minutes.txt      its time; minutes.txt beside the scenes: one figure for all of them.
// bench/peers/ brings the outputs of several systems into this form.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// Our own finished run of a scene: it lends its cameras, its panorama and its room.
struct OwnRun {
    RunFolder folder;
    std::filesystem::path truth;  // where its true pictures are kept
};
struct PeerInputs {
    const Suite& suite;
    std::filesystem::path out, weights;
    std::function<std::optional<OwnRun>(const SuiteScene&)> own_run;
};

// Throws UsageError for a name that another row has, a folder that holds nothing of the suite's scenes, or a suite that
// measures nothing of a peer. Nothing is written.
void check_peers(const std::vector<SuitePeer>& peers, const Suite& suite);
// A record a scene, as evaluate keeps them.
std::vector<Json> peer_records(const SuitePeer& peer, const PeerInputs& inputs, const Run& run);

}  // namespace fastscene
