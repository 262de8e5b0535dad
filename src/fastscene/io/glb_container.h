// The glTF binary container: a JSON chunk and a binary chunk.
#pragma once

#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

// The file's bytes. `binary` is padded to a multiple of 4. Throws Error beyond the format's 4 GiB.
std::string glb_bytes(const Json& json, std::string binary);

}  // namespace fastscene
