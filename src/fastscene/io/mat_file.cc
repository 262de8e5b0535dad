#include "fastscene/io/mat_file.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/gzip.h"

namespace fastscene {
namespace {

// Data element types (MAT-File Format, table 1-1), and the only array class that is supported.
constexpr std::uint32_t kInt8 = 1, kUint8 = 2, kInt16 = 3, kUint16 = 4, kInt32 = 5, kUint32 = 6, kDouble = 9,
                        kMatrix = 14, kCompressed = 15;
constexpr std::uint32_t kDoubleClass = 6;
constexpr std::uint32_t kComplexFlag = 0x0800;
constexpr std::size_t kHeaderBytes = 128;

struct Element {
    std::uint32_t type = 0;
    std::string_view data;
};

class Elements {
  public:
    Elements(std::string_view bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}
    bool at_end() const { return bytes_.size() < 8; }
    Element next() {
        if (at_end()) throw broken("a data element");
        const std::uint32_t tag = word(0);
        if (tag >> 16) {  // the small form: size and type share a word, followed by up to four bytes
            const std::size_t size = tag >> 16;
            if (size > 4) throw broken("a small data element of at most 4 bytes");
            const Element element{tag & 0xffff, bytes_.substr(4, size)};
            bytes_.remove_prefix(8);
            return element;
        }
        const std::size_t size = word(4);
        if (size > bytes_.size() - 8) throw broken("a data element of " + std::to_string(size) + " bytes");
        const Element element{tag, bytes_.substr(8, size)};
        // Elements are padded to 8 bytes, except compressed ones.
        const std::size_t whole = tag == kCompressed ? size : (size + 7) / 8 * 8;
        bytes_.remove_prefix(std::min(8 + whole, bytes_.size()));
        return element;
    }
    Error broken(const std::string& expected) const {
        return Error("{}: expected {} of a MAT 5 file, found the end or other data", path_.string(), expected);
    }

  private:
    std::uint32_t word(std::size_t at) const {
        std::uint32_t value;
        std::memcpy(&value, bytes_.data() + at, 4);
        return value;
    }
    std::string_view bytes_;
    const std::filesystem::path& path_;
};

template <class T>
void append_numbers(std::vector<double>& out, std::string_view data) {
    for (std::size_t at = 0; at + sizeof(T) <= data.size(); at += sizeof(T)) {
        T value;
        std::memcpy(&value, data.data() + at, sizeof value);
        out.push_back(static_cast<double>(value));
    }
}
// MATLAB stores integer-valued double matrices in a smaller type if they fit.
std::vector<double> numbers(const Element& element, const Elements& place) {
    std::vector<double> out;
    switch (element.type) {
        case kInt8: append_numbers<std::int8_t>(out, element.data); break;
        case kUint8: append_numbers<std::uint8_t>(out, element.data); break;
        case kInt16: append_numbers<std::int16_t>(out, element.data); break;
        case kUint16: append_numbers<std::uint16_t>(out, element.data); break;
        case kInt32: append_numbers<std::int32_t>(out, element.data); break;
        case kUint32: append_numbers<std::uint32_t>(out, element.data); break;
        case kDouble: append_numbers<double>(out, element.data); break;
        default: throw place.broken("numbers");
    }
    return out;
}

struct Named {
    std::string name;
    MatMatrix matrix;
};
std::optional<Named> read_matrix(std::string_view bytes, const std::filesystem::path& path) {
    Elements parts(bytes, path);
    const std::vector<double> flags = numbers(parts.next(), parts);
    if (flags.empty()) throw parts.broken("array flags");
    const auto flag = static_cast<std::uint32_t>(flags[0]);
    if ((flag & 0xff) != kDoubleClass || (flag & kComplexFlag)) return std::nullopt;
    const std::vector<double> sides = numbers(parts.next(), parts);
    const Element name = parts.next();
    if (sides.size() != 2) return std::nullopt;
    const std::vector<double> values = numbers(parts.next(), parts);
    if (!(sides[0] >= 0 && sides[1] >= 0 && sides[0] * sides[1] == static_cast<double>(values.size())))
        throw parts.broken("as many values as the matrix has");

    Named out{std::string(name.data), {static_cast<int>(sides[0]), static_cast<int>(sides[1]), {}}};
    out.matrix.values.resize(values.size());
    const auto rows = static_cast<std::size_t>(sides[0]), columns = static_cast<std::size_t>(sides[1]);
    for (std::size_t i = 0; i < rows; ++i)  // column-major in the file
        for (std::size_t j = 0; j < columns; ++j) out.matrix.values[i * columns + j] = values[j * rows + i];
    return out;
}

}  // namespace

std::map<std::string, MatMatrix> load_mat_file(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    if (bytes.size() < kHeaderBytes || !bytes.starts_with("MATLAB 5.0 MAT-file") || bytes.substr(126, 2) != "IM")
        throw Error("{}: expected a MATLAB 5.0 MAT-file (little endian), found other data", path.string());
    std::map<std::string, MatMatrix> out;
    for (Elements elements(std::string_view(bytes).substr(kHeaderBytes), path); !elements.at_end();) {
        Element element = elements.next();
        std::string unpacked;
        if (element.type == kCompressed) {
            unpacked = inflated(element.data, path);
            element = Elements(unpacked, path).next();
        }
        if (element.type != kMatrix) continue;
        if (auto named = read_matrix(element.data, path)) out[named->name] = std::move(named->matrix);
    }
    return out;
}

}  // namespace fastscene
