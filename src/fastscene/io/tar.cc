#include "fastscene/io/tar.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

constexpr std::size_t kTarBlock = 512, kTarRecord = 20 * kTarBlock;  // an archive is a whole number of records

// The fields of a header that are not zero: where they begin, and how long they are.
struct TarField {
    std::size_t at, length;
};
constexpr TarField kTarName{0, 100}, kTarMode{100, 8}, kTarUser{108, 8}, kTarGroup{116, 8}, kTarSize{124, 12},
    kTarDate{136, 12}, kTarSum{148, 8}, kTarType{156, 1}, kTarMagic{257, 8};

std::size_t blocks(std::size_t bytes) { return (bytes + kTarBlock - 1) / kTarBlock; }

}  // namespace

std::size_t tar_entry_size(std::size_t file_size) { return (1 + blocks(file_size)) * kTarBlock; }

void TarWriter::put(std::string_view bytes) {
    put_(bytes);
    written_ += bytes.size();
}

void TarWriter::add(const std::string& name, std::string_view content) {
    if (name.empty() || name.size() > kTarName.length)
        throw Error("{}: expected a name of at most {} bytes for a tar archive, found {}", name, kTarName.length,
                    name.size());
    constexpr std::uint64_t kMost = std::uint64_t{1} << 33;  // 11 octal digits
    if (content.size() >= kMost)
        throw Error("{}: expected less than 8 GiB for a tar archive, found {} bytes", name, content.size());
    std::array<char, kTarBlock> header{};
    const auto set = [&](TarField field, std::string_view text) {
        std::memcpy(header.data() + field.at, text.data(), text.size());
    };
    set(kTarName, name);
    set(kTarMode, "0000644");
    set(kTarUser, "0000000");
    set(kTarGroup, "0000000");
    set(kTarSize, fmt::format("{:011o}", content.size()));
    set(kTarDate, "00000000000");
    set(kTarType, "0");
    set(kTarMagic, std::string_view("ustar\00000", kTarMagic.length));
    // The sum is taken with blanks in its own place.
    set(kTarSum, "        ");
    unsigned sum = 0;
    for (const char c : header) sum += static_cast<unsigned char>(c);
    set(kTarSum, fmt::format("{:06o}", sum));
    header[kTarSum.at + 6] = '\0';
    put({header.data(), header.size()});
    put(content);
    put(std::string(blocks(content.size()) * kTarBlock - content.size(), '\0'));
}

void TarWriter::finish() {
    put(std::string(2 * kTarBlock, '\0'));
    if (const std::size_t over = written_ % kTarRecord; over > 0) put(std::string(kTarRecord - over, '\0'));
}

}  // namespace fastscene
