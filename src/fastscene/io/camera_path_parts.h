// One file per format of camera paths; camera_path_io.cc chooses. Private to io/.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/scene/camera_path.h"

namespace fastscene {

// Readers leave checks of times, angles and sizes to camera_path_io.cc. `where` names the file in errors.
CameraPath path_from_nerfstudio(const Json& json, const CameraPath& otherwise, const std::string& where);
CameraPath path_from_chan(const std::string& text, const CameraPath& otherwise, const std::string& where);
CameraPath path_from_supersplat(const Json& json, const CameraPath& otherwise, const std::string& where);

Json nerfstudio_from_path(const CameraPath& camera);
std::string chan_from_path(const CameraPath& camera);
Json supersplat_from_path(const CameraPath& camera);
// An entry of animTracks.
Json supersplat_track(const CameraPath& camera);

// A matrix that has to be a rotation, rows in order, up to a scale. Throws Error.
Mat3f rotation_from(Vec3d row0, Vec3d row1, Vec3d row2, const std::string& where);

}  // namespace fastscene
