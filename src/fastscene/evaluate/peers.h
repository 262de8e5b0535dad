// Peers: what another system made, measured by the same code. A peer's folder holds for each scene of the suite, by its name,
//   SCENE/*.png, *.jpg     its own renders, judged as they are, or
//   SCENE.ply .spz .glb    Gaussian splats, drawn by our renderer at the suite's own cameras,
// and optionally minutes.txt, its time a scene. bench/peers/ brings the outputs of several systems into this form.
#pragma once

#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// Throws UsageError when the folder holds nothing of the suite's scenes, or the suite does not measure pictures alone.
void check_peer(const SuitePeer& peer, const Suite& suite);
// A record a scene, as evaluate keeps them.
std::vector<Json> peer_records(const SuitePeer& peer, const Suite& suite, const std::filesystem::path& out, const std::filesystem::path& weights, const Run& run);

}  // namespace fastscene
