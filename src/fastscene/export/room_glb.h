// The furnished room as glTF 2.0: a node per thing, baked materials, lights, the camera.
#pragma once

#include <string>

#include "fastscene/export/room_model.h"

namespace fastscene {

// The bytes of a .glb file. Metres, y up, z forward (kGltfAxes). Light intensities and emission share one unit, in
// which white paper in daylight shade is about 1.
std::string room_glb_bytes(const Room& room, const RoomModel& model);
std::string room_glb_bytes(const Room& room, const BakeParams& params, const Run& run);

}  // namespace fastscene
