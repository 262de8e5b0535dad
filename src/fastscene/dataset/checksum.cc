#include "fastscene/dataset/checksum.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/hash.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = 1 << 20;  // bytes that are hashed at a time: shards need not fit into memory

}  // namespace

Checksum checksum_of_bytes(std::string_view bytes) {
    Hash hash;
    for (std::size_t at = 0; at < bytes.size(); at += kPiece) hash.add(bytes.substr(at, kPiece));
    return {bytes.size(), hash.hex()};
}

Checksum checksum_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error("{}: cannot be read", file.string());
    Hash hash;
    Checksum out;
    std::vector<char> piece(kPiece);
    while (in.read(piece.data(), static_cast<std::streamsize>(kPiece)) || in.gcount() > 0) {
        const auto got = static_cast<std::size_t>(in.gcount());
        hash.add(std::string_view(piece.data(), got));
        out.bytes += got;
    }
    if (in.bad()) throw Error("{}: cannot be read", file.string());
    out.hash = hash.hex();
    return out;
}

Json to_json(const Checksum& sum) { return {{"bytes", sum.bytes}, {"hash", sum.hash}}; }

Checksum checksum_from_json(const Json& json) {
    return {json.at("bytes").get<std::uint64_t>(), json.at("hash").get<std::string>()};
}

std::string fault_of(const fs::path& file, const Checksum& expected, bool quick) {
    std::error_code none;
    if (!fs::is_regular_file(file, none)) return "missing";
    const auto bytes = fs::file_size(file, none);
    if (none) return "cannot be read";
    if (bytes < expected.bytes) return fmt::format("truncated: expected {} bytes, found {}", expected.bytes, bytes);
    if (bytes > expected.bytes) return fmt::format("damaged: expected {} bytes, found {}", expected.bytes, bytes);
    if (quick) return "";
    try {
        return checksum_of(file) == expected ? "" : "damaged: its content does not match its checksum";
    } catch (const Error&) {
        return "cannot be read";
    }
}

}  // namespace fastscene::dataset
