#include "fastscene/io/glb_container.h"

#include "fastscene/base/bytes.h"
#include "fastscene/io/glb.h"

namespace fastscene {

GlbChunks glb_chunks(const std::filesystem::path& path, std::string_view bytes) {
    ByteReader in(path, bytes);
    if (in.get<std::uint32_t>() != kGlbMagic) in.refuse("expected the sign glTF, found another");
    if (const auto version = in.get<std::uint32_t>(); version != 2)
        in.refuse(fmt::format("expected glTF 2, found {}", version));
    if (const auto size = in.get<std::uint32_t>(); size > bytes.size())
        in.refuse(fmt::format("expected {} bytes, found {}", size, bytes.size()));
    GlbChunks chunks;
    while (in.left() >= 8) {
        const auto size = in.get<std::uint32_t>(), kind = in.get<std::uint32_t>();
        const std::size_t begin = in.at();
        in.skip(size);
        if (kind == kJsonChunk && chunks.json.empty()) chunks.json = bytes.substr(begin, size), chunks.json_at = begin;
        if (kind == kBinaryChunk && chunks.binary.empty()) chunks.binary = bytes.substr(begin, size);
    }
    if (chunks.json.empty()) in.refuse("expected a chunk of JSON, found none");
    return chunks;
}

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
