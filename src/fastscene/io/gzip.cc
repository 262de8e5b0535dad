#include "fastscene/io/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <memory>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

// zlib's window bits: 15 is the largest window; more select the header.
constexpr int kWindowBits = 15, kGzip = 16, kDetect = 32;
constexpr int kMemoryLevel = 9;                           // zlib's fastest
constexpr std::size_t kFeedBytes = std::size_t{1} << 30;  // zlib counts in 32 bits
constexpr std::size_t kPieceBytes = std::size_t{1} << 16;
constexpr std::size_t kMaxInflated = std::size_t{1} << 28;

using Stream = std::unique_ptr<z_stream, int (*)(z_stream*)>;

// Runs `step` until the stream ends or fails, and returns zlib's code. `step` is told whether all input is fed;
// `after` is called with the output so far.
template <class Step, class After>
int pump(z_stream& z, std::string_view in, std::string& out, const Step& step, const After& after) {
    std::string piece(kPieceBytes, '\0');
    int code = Z_OK;
    while (code == Z_OK) {
        if (z.avail_in == 0) {
            const std::size_t take = std::min(in.size(), kFeedBytes);
            z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(in.data()));
            z.avail_in = static_cast<uInt>(take);
            in.remove_prefix(take);
        }
        z.next_out = reinterpret_cast<Bytef*>(piece.data());
        z.avail_out = static_cast<uInt>(piece.size());
        code = step(in.empty());
        out.append(piece, 0, piece.size() - z.avail_out);
        after();
    }
    return code;
}

}  // namespace

std::string gzipped(std::string_view bytes) {
    z_stream z{};
    if (deflateInit2(&z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip + kWindowBits, kMemoryLevel, Z_DEFAULT_STRATEGY) !=
        Z_OK)
        throw std::bad_alloc();
    const Stream guard(&z, deflateEnd);
    std::string out;
    pump(
        z, bytes, out, [&](bool all_fed) { return deflate(&z, all_fed ? Z_FINISH : Z_NO_FLUSH); }, [] {});
    return out;
}

std::string inflated(std::string_view packed, const std::filesystem::path& path, const CheckInflated& check) {
    z_stream z{};
    if (inflateInit2(&z, kDetect + kWindowBits) != Z_OK) throw std::bad_alloc();
    const Stream guard(&z, inflateEnd);
    std::string out;
    const int code = pump(
        z, packed, out, [&](bool) { return inflate(&z, Z_NO_FLUSH); },
        [&] {
            if (check) check(out);
            else if (out.size() > kMaxInflated)
                throw Error("{}: expected at most {} MiB unpacked, found more", path.string(), kMaxInflated >> 20);
        });
    if (code != Z_STREAM_END)
        throw Error("{}: byte {}: expected more of a gzip or zlib stream, found {}", path.string(), z.total_in,
                    z.msg ? z.msg : "the end of the data");
    return out;
}

}  // namespace fastscene
