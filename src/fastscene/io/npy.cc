#include "fastscene/io/npy.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/bytes.h"

namespace fastscene {
namespace {

constexpr std::string_view kMagic("\x93NUMPY\x01\x00", 8);
constexpr std::size_t kAlignment = 64;  // of the values

}  // namespace

std::string npy_bytes(std::span<const std::uint16_t> values) {
    std::string header = fmt::format("{{'descr': '<u2', 'fortran_order': False, 'shape': ({},), }}", values.size());
    const std::size_t before = kMagic.size() + 2;
    header.append((kAlignment - (before + header.size() + 1) % kAlignment) % kAlignment, ' ');
    header += '\n';
    std::string out(kMagic);
    append(out, static_cast<std::uint16_t>(header.size()));
    out += header;
    for (const std::uint16_t v : values) append(out, v);
    return out;
}

std::vector<std::uint16_t> load_npy(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    if (!bytes.starts_with(kMagic) || bytes.size() < kMagic.size() + 2)
        throw Error("{}: expected NumPy's .npy, version 1.0, found something else", path.string());
    const std::size_t begin = kMagic.size() + 2 + number_at<std::uint16_t>(bytes, kMagic.size());
    const std::string header = bytes.substr(kMagic.size() + 2, begin - kMagic.size() - 2);
    if (header.find("'<u2'") == std::string::npos || header.find("False") == std::string::npos)
        throw Error("{}: expected whole numbers of 16 bits ('<u2'), found {}", path.string(),
                    header.substr(0, header.find('}') + 1));
    const std::size_t shape = header.find("'shape': (");
    std::size_t count = 0;
    const char* first = header.data() + (shape == std::string::npos ? 0 : shape + std::strlen("'shape': ("));
    const auto [end, code] = std::from_chars(first, header.data() + header.size(), count);
    if (shape == std::string::npos || code != std::errc() ||
        header.compare(static_cast<std::size_t>(end - header.data()), 2, ",)") != 0)
        throw Error("{}: expected one dimension, found {}", path.string(), header.substr(0, header.find('}') + 1));
    if (begin > bytes.size() || bytes.size() - begin != 2 * count)
        throw Error("{}: expected {} numbers of 2 bytes, found {} bytes", path.string(), count,
                    bytes.size() - std::min(begin, bytes.size()));
    std::vector<std::uint16_t> out(count);
    if (count > 0) std::memcpy(out.data(), bytes.data() + begin, 2 * count);
    return out;
}

}  // namespace fastscene
