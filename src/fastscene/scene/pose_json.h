// Poses in JSON: the 4 x 4 matrix of a Rigid, row by row, with last row 0 0 0 1.
#pragma once

#include "fastscene/base/json.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// shortest: the fewest decimals that read back as the same float; exact: the float's value as a double.
enum class Decimals { shortest, exact };

Json json_from_pose(const Rigid& pose, Decimals decimals = Decimals::shortest);
// Restores the same floats. Throws Json::exception if rows or numbers are missing; the last row is not read.
Rigid pose_from_json(const Json& rows);

}  // namespace fastscene
