#include <zlib.h>

#include "fastscene/base/error.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/zip.h"

namespace fastscene {
namespace {

constexpr std::uint32_t kLocalHeader = 0x04034b50, kDirectoryEntry = 0x02014b50, kDirectoryEnd = 0x06054b50;
constexpr std::uint16_t kVersion = 20;                                 // 2.0, the first that everything reads
constexpr std::uint16_t kFirstDay = 1 << 5 | 1;                        // 1 January 1980: archives begin there
constexpr std::size_t kLargestZip = 0xffffffffu, kMostFiles = 0xffff;  // sizes and counts are of 32 and 16 bits

// What the local header and the directory share: version needed, flags, method (stored), time, date, checksum, sizes.
void append_facts(std::string& out, const std::string& name, const std::string& content) {
    for (const std::uint16_t v : {kVersion, std::uint16_t{0}, std::uint16_t{0}, std::uint16_t{0}, kFirstDay})
        append(out, v);
    append(out, static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size())));
    append(out, static_cast<std::uint32_t>(content.size()));
    append(out, static_cast<std::uint32_t>(content.size()));
    append(out, static_cast<std::uint16_t>(name.size()));
    append(out, std::uint16_t{0});  // no extra field
}

}  // namespace

std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files) {
    std::string out, directory;
    for (const auto& [name, content] : files) {
        append(directory, kDirectoryEntry);
        append(directory, kVersion);
        append_facts(directory, name, content);
        for (int i = 0; i < 3; ++i) append(directory, std::uint16_t{0});  // no comment, disk 0, no attributes
        append(directory, std::uint32_t{0});
        append(directory, static_cast<std::uint32_t>(out.size()));
        directory += name;
        append(out, kLocalHeader);
        append_facts(out, name, content);
        out += name;
        out += content;
        if (out.size() > kLargestZip) throw Error("ZIP holds up to 4 GiB, found {} bytes and more", out.size());
    }
    if (files.size() > kMostFiles) throw Error("ZIP holds up to {} files, found {}", kMostFiles, files.size());
    const auto start = static_cast<std::uint32_t>(out.size()), size = static_cast<std::uint32_t>(directory.size());
    const auto count = static_cast<std::uint16_t>(files.size());
    out += directory;
    append(out, kDirectoryEnd);
    for (const std::uint16_t v : {std::uint16_t{0}, std::uint16_t{0}, count, count}) append(out, v);
    append(out, size);
    append(out, start);
    append(out, std::uint16_t{0});
    return out;
}

}  // namespace fastscene
