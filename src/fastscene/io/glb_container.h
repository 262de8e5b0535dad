// The glTF binary container: a JSON chunk and a binary chunk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "fastscene/base/json.h"

namespace fastscene {

struct GlbChunks {
    std::string_view json, binary;  // parts of the file; binary may be empty
    std::size_t json_at = 0;        // byte
};
// Throws Error naming the file if it is no glTF binary of version 2, or ends too early.
GlbChunks glb_chunks(const std::filesystem::path& path, std::string_view bytes);

// The file's bytes. `binary` is padded to a multiple of 4. Throws Error beyond the format's 4 GiB.
std::string glb_bytes(const Json& json, std::string binary);

}  // namespace fastscene
