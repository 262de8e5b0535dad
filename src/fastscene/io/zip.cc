#include "fastscene/io/zip.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// PKWARE's APPNOTE: fixed sizes and signatures of the three record types.
constexpr std::size_t kEndSize = 22, kCentralSize = 46, kLocalSize = 30, kMaxComment = 65535;
constexpr std::uint32_t kEndMark = 0x06054b50, kCentralMark = 0x02014b50, kLocalMark = 0x04034b50;
constexpr std::uint32_t kMaxUnpacked = 256u << 20;

std::uint32_t u16(std::string_view b, std::size_t at) {
    return static_cast<unsigned char>(b[at]) | (static_cast<unsigned>(static_cast<unsigned char>(b[at + 1])) << 8);
}
std::uint32_t u32(std::string_view b, std::size_t at) { return u16(b, at) | (u16(b, at + 2) << 16); }

std::string bytes_at(std::ifstream& file, std::uint64_t at, std::size_t count) {
    std::string bytes(count, '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    return bytes;
}

bool inflate_raw(std::string_view packed, std::string& out) {
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const int code = inflate(&stream, Z_FINISH);
    const bool whole = code == Z_STREAM_END && stream.avail_out == 0;
    inflateEnd(&stream);
    return whole;
}

}  // namespace

ZipFile::ZipFile(fs::path path) : path_(std::move(path)) {
    std::ifstream file(path_, std::ios::binary);
    if (!file) throw Error("{}: cannot be opened", path_.string());
    file.seekg(0, std::ios::end);
    file_size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(0, file.tellg()));
    // The end record is last, followed by a comment of unknown length.
    const std::uint64_t tail_size = std::min<std::uint64_t>(file_size_, kEndSize + kMaxComment);
    const std::string tail = bytes_at(file, file_size_ - tail_size, tail_size);
    std::size_t end = std::string::npos;
    for (std::size_t at = tail.size() < kEndSize ? 0 : tail.size() - kEndSize + 1;
         at-- > 0 && end == std::string::npos;)
        if (u32(tail, at) == kEndMark) end = at;
    if (end == std::string::npos)
        throw Error("{}: expected a zip archive, found no table of contents (the file may be cut short)",
                    path_.string());
    const std::uint32_t count = u16(tail, end + 10), size = u32(tail, end + 12), offset = u32(tail, end + 16);
    if (std::uint64_t{offset} + size > file_size_)
        throw Error("{}: expected its table of contents inside the file, found it beyond the end", path_.string());
    const std::string table = bytes_at(file, offset, size);
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (at + kCentralSize > table.size() || u32(table, at) != kCentralMark)
            throw Error("{}: expected {} entries, found {}", path_.string(), count, i);
        const std::size_t name = u16(table, at + 28), extra = u16(table, at + 30), comment = u16(table, at + 32);
        if (at + kCentralSize + name > table.size())
            throw Error("{}: expected {} entries, found {}", path_.string(), count, i);
        entries_[table.substr(at + kCentralSize, name)] = {u32(table, at + 42),
                                                           u32(table, at + 20),
                                                           u32(table, at + 24),
                                                           u32(table, at + 16),
                                                           static_cast<std::uint16_t>(u16(table, at + 10)),
                                                           static_cast<std::uint16_t>(u16(table, at + 8))};
        at += kCentralSize + name + extra + comment;
    }
}

std::vector<std::string> ZipFile::names() const {
    std::vector<std::string> out;
    for (const auto& [name, entry] : entries_) out.push_back(name);
    return out;
}

std::string ZipFile::read(const std::string& name) const {
    const std::string where = path_.string() + ": " + name;
    const auto found = entries_.find(name);
    if (found == entries_.end()) throw Error("{}: expected this entry in the archive, found none", where);
    const Entry& entry = found->second;
    if (entry.flags & 1) throw Error("{}: expected a plain entry, found an encrypted one", where);
    if (entry.method != 0 && entry.method != 8)
        throw Error("{}: expected a stored or deflated entry, found method {}", where, entry.method);
    if (entry.size > kMaxUnpacked || entry.packed > file_size_)
        throw Error("{}: expected at most 256 MiB, found {} bytes", where, entry.size);
    std::ifstream file(path_, std::ios::binary);
    const std::string head = bytes_at(file, entry.offset, kLocalSize);
    if (head.size() < kLocalSize || u32(head, 0) != kLocalMark)
        throw Error("{}: expected an entry at byte {}, found something else", where, entry.offset);
    const std::string packed = bytes_at(file, entry.offset + kLocalSize + u16(head, 26) + u16(head, 28), entry.packed);
    std::string out(entry.size, '\0');
    const bool whole = packed.size() == entry.packed &&
                       (entry.method == 0 ? packed.size() == out.size() : inflate_raw(packed, out));
    if (whole && entry.method == 0) out = packed;
    if (!whole || crc32(0, reinterpret_cast<const Bytef*>(out.data()), static_cast<uInt>(out.size())) != entry.crc)
        throw Error("{}: expected a whole entry, found a damaged one", where);
    return out;
}

}  // namespace fastscene
