#include "fastscene/io/glb_container.h"

#include "fastscene/base/bytes.h"
#include "fastscene/io/glb.h"

namespace fastscene {

std::string glb_bytes(const Json& json, std::string binary) {
    std::string text = json.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    binary.append((4 - binary.size() % 4) % 4, '\0');
    const std::size_t size = 12 + 8 + text.size() + 8 + binary.size();
    if (size > 0xffffffffu) throw Error("glTF binary holds up to 4 GiB, found {} bytes", size);
    std::string out;
    for (const std::uint32_t v :
         {kGlbMagic, 2u, static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(text.size()), kJsonChunk})
        append(out, v);
    out += text;
    for (const std::uint32_t v : {static_cast<std::uint32_t>(binary.size()), kBinaryChunk}) append(out, v);
    return out + binary;
}

}  // namespace fastscene
