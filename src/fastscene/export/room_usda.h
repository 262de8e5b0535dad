// The furnished room as OpenUSD text: what room.glb holds, with UsdGeom, UsdPreviewSurface, UsdLux and labels.
#pragma once

#include <string>
#include <vector>

#include "fastscene/export/room_model.h"

namespace fastscene {

struct NamedBytes {
    std::string name, bytes;
};
struct UsdaRoom {
    std::string text;
    std::vector<NamedBytes> textures;  // to be written into `texture_folder`, beside the text
};
// Metres, y up, z forward (kGltfAxes). Intensities are those of room.glb.
UsdaRoom room_usda(const Room& room, const RoomModel& model, const std::string& texture_folder);
UsdaRoom room_usda(const Room& room, const std::string& texture_folder, const BakeParams& params, const Run& run);

}  // namespace fastscene
