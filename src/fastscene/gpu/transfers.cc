#include "fastscene/gpu/transfers.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace fastscene::gpu {

const Buffer& Transfers::reserved(Buffer& buffer, std::int64_t bytes, Memory memory) {
    const std::int64_t wanted = std::min(bytes, kMostBytes);
    if (buffer.bytes() < wanted) {
        const auto grown = static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(wanted)));
        buffer = {};  // before the next is allocated
        buffer = Buffer(device_, grown, memory, "a transfer");
    }
    return buffer;
}

void upload(Device& device, const Buffer& to, std::int64_t to_byte, const void* from, std::int64_t bytes) {
    if (bytes == 0) return;
    if (to.mapped()) {
        std::memcpy(static_cast<char*>(to.mapped()) + to_byte, from, static_cast<std::size_t>(bytes));
        return;
    }
    Transfers& transfers = device.transfers();
    const Buffer& staging = transfers.up(bytes);
    for (std::int64_t done = 0; done < bytes; done += Transfers::kMostBytes) {
        const std::int64_t now = std::min(Transfers::kMostBytes, bytes - done);
        std::memcpy(staging.mapped(), static_cast<const char*>(from) + done, static_cast<std::size_t>(now));
        transfers.copy(staging, 0, to, to_byte + done, now);
    }
}

namespace {

void take_pieces(Device& device, const Buffer& from, std::int64_t from_byte, std::int64_t bytes,
                 std::int64_t item_bytes, const TakePiece& take) {
    if (bytes == 0) return;
    if (from.mapped()) {
        take(static_cast<const char*>(from.mapped()) + from_byte, 0, bytes);
        return;
    }
    Transfers& transfers = device.transfers();
    const Buffer& staging = transfers.down(bytes);
    const std::int64_t piece = Transfers::kMostBytes / item_bytes * item_bytes;
    for (std::int64_t done = 0; done < bytes; done += piece) {
        const std::int64_t now = std::min(piece, bytes - done);
        transfers.copy(from, from_byte + done, staging, 0, now);
        take(staging.mapped(), done, now);
    }
}

}  // namespace

void download(Device& device, const Buffer& from, std::int64_t from_byte, void* to, std::int64_t bytes) {
    take_pieces(device, from, from_byte, bytes, 1, [&](const void* piece, std::int64_t at, std::int64_t size) {
        std::memcpy(static_cast<char*>(to) + at, piece, static_cast<std::size_t>(size));
    });
}

void download_in_pieces(Device& device, const Buffer& from, std::int64_t bytes, std::int64_t item_bytes,
                        const TakePiece& take) {
    take_pieces(device, from, 0, bytes, item_bytes, take);
}

}  // namespace fastscene::gpu
