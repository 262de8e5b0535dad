#include "fastscene/io/inflate.h"

#include <zlib.h>

#include "fastscene/base/error.h"

namespace fastscene {

std::string inflated(std::string_view packed, const std::filesystem::path& path) {
    constexpr std::size_t largest = std::size_t{1} << 28;
    constexpr int either_kind = 15 + 32;  // window bits; + 32 detects gzip or zlib by the header
    z_stream stream{};
    if (inflateInit2(&stream, either_kind) != Z_OK) throw Error("{}: zlib cannot start", path.string());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    std::string out;
    int code = Z_OK;
    while (code == Z_OK && out.size() < largest) {
        char chunk[1 << 16];
        stream.next_out = reinterpret_cast<Bytef*>(chunk);
        stream.avail_out = sizeof chunk;
        code = inflate(&stream, Z_NO_FLUSH);
        out.append(chunk, sizeof chunk - stream.avail_out);
    }
    inflateEnd(&stream);
    if (code != Z_STREAM_END) throw Error("{}: expected whole packed data, found it damaged or cut off", path.string());
    return out;
}

}  // namespace fastscene
