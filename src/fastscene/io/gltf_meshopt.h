// Unpacks what EXT_meshopt_compression and KHR_meshopt_compression pack. Private to io/.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fastscene {

struct MeshoptStream {
    std::string mode, filter;  // as glTF names them
    std::size_t count = 0, stride = 0;
};
// `count` rows of `stride` bytes; nothing, with the reason, if `packed` does not hold them.
std::optional<std::string> meshopt_unpacked(std::string_view packed, const MeshoptStream& stream, std::string& reason);

}  // namespace fastscene
