#include "fastscene/io/ply.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace {

struct Type {
    const char *name, *other;
    int bytes;
    char kind;
};
constexpr Type kTypes[] = {{"char", "int8", 1, 'i'},     {"uchar", "uint8", 1, 'u'},   {"short", "int16", 2, 'i'},
                           {"ushort", "uint16", 2, 'u'}, {"int", "int32", 4, 'i'},     {"uint", "uint32", 4, 'u'},
                           {"float", "float32", 4, 'f'}, {"double", "float64", 8, 'f'}};
constexpr std::size_t kLongestComment = 1 << 20;
// Sanity limit on columns.
constexpr std::size_t kMostProperties = 1000;

const Type* type_named(const std::string& name) {
    for (const Type& t : kTypes)
        if (name == t.name || name == t.other) return &t;
    return nullptr;
}

constexpr std::string_view kBlanks = " \t\r\v\f";

std::string trimmed(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(kBlanks), end = line.find_last_not_of(kBlanks);
    return begin == std::string_view::npos ? "" : std::string(line.substr(begin, end - begin + 1));
}

// Programs and people leave blanks at the ends of lines, and more than one between words.
std::string with_single_blanks(std::string_view line) {
    std::string out;
    for (std::size_t begin; (begin = line.find_first_not_of(kBlanks)) != std::string_view::npos;) {
        line.remove_prefix(begin);
        const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
        out.append(out.empty() ? "" : " ").append(line.substr(0, end));
        line.remove_prefix(end);
    }
    return out;
}

template <class T>
double read_as(const char* p) {
    T v;
    std::memcpy(&v, p, sizeof v);
    return static_cast<double>(v);
}

}  // namespace

Ply::Ply(const std::filesystem::path& path) : Ply(path, read_file(path)) {}

Ply::Ply(const std::filesystem::path& path, std::string bytes) : path_(path), bytes_(std::move(bytes)) {
    const Encoding encoding = parse_header();
    if (encoding == Encoding::text) read_text_rows();
    else place_binary_rows();
    if (encoding == Encoding::big) swap_bytes();
}

std::string Ply::next_line() {
    const std::size_t end = bytes_.find('\n', at_);
    // Header lines are short, except for programs' comments; anything longer is not a header.
    if (end == std::string::npos || end - at_ > (bytes_.compare(at_, 8, "comment ") == 0 ? kLongestComment : 1000))
        throw Error("{}: byte {}: expected a PLY header line, found none", path_.string(), at_);
    const std::string_view line = std::string_view(bytes_).substr(at_, end - at_);
    at_ = end + 1;
    return line.starts_with("comment ") ? trimmed(line) : with_single_blanks(line);
}

Ply::Encoding Ply::parse_header() {
    if (next_line() != "ply") throw Error("{}: expected a PLY file, found another first line", path_.string());
    std::string format;
    for (std::string line = next_line(); line != "end_header"; line = next_line())
        if (line.starts_with("format ") && format.empty()) format = line;
        else parse_header_line(line);
    if (format == "format binary_little_endian 1.0") return Encoding::little;
    if (format == "format binary_big_endian 1.0") return Encoding::big;
    if (format == "format ascii 1.0") return Encoding::text;
    throw Error("{}: expected \"format binary_little_endian 1.0\", binary_big_endian or ascii, found \"{}\"",
                path_.string(), format);
}

void Ply::parse_header_line(const std::string& line) {
    std::istringstream words(line);
    std::string word, type, name;
    words >> word;
    if (word == "comment") return comments_.push_back(line.substr(std::min(line.size(), word.size() + 1)));
    if (word == "obj_info") return;
    if (word == "element") {
        PlyElement element;
        std::string count;
        words >> element.name >> count;
        const auto [end, code] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (count.empty() || code != std::errc() || end != count.data() + count.size())
            throw Error("{}: expected \"element NAME COUNT\", found \"{}\"", path_.string(), line);
        elements_.push_back(element);
    } else if (word == "property" && words >> type && type == "list" && !elements_.empty()) {
        elements_.back().has_list = true;
    } else if (word == "property" && words >> name && type_named(type) && !elements_.empty()) {
        PlyElement& element = elements_.back();
        if (element.properties.size() >= kMostProperties)
            throw Error("{}: expected at most {} properties of \"{}\", found more", path_.string(), kMostProperties,
                        element.name);
        element.properties.push_back({name, type_named(type)->bytes, type_named(type)->kind, element.stride});
        element.stride += static_cast<std::size_t>(type_named(type)->bytes);
    } else {
        throw Error("{}: expected an element or a scalar property, found \"{}\"", path_.string(), line);
    }
}

void Ply::place_binary_rows() {
    for (PlyElement& element : elements_) {
        if (element.has_list) return;
        element.data = at_;
        const std::size_t left = bytes_.size() - at_;
        // Elements without properties have zero-byte rows, so their count would be unlimited.
        if (element.count > left / std::max<std::size_t>(element.stride, 1))
            throw Error("{}: byte {}: expected {} rows of {} bytes for \"{}\", found {} bytes", path_.string(), at_,
                        element.count, element.stride, element.name, left);
        at_ += element.count * element.stride;
    }
}

void Ply::swap_bytes() {
    for (const PlyElement& element : elements_) {
        if (element.has_list) return;
        for (std::size_t row = 0; row < element.count; ++row)
            for (const PlyProperty& p : element.properties) {
                char* value = bytes_.data() + element.data + row * element.stride + p.offset;
                std::reverse(value, value + p.bytes);
            }
    }
}

// Converts text rows to binary rows of doubles.
void Ply::read_text_rows() {
    std::string rows;
    for (PlyElement& element : elements_) {
        if (element.has_list) break;
        element.data = rows.size();
        element.stride = 8 * element.properties.size();
        for (std::size_t i = 0; i < element.properties.size(); ++i)
            element.properties[i] = {element.properties[i].name, 8, 'f', 8 * i};
        // Each number takes at least two characters, including a separator.
        if (element.count > (bytes_.size() - at_ + 1) / std::max<std::size_t>(2 * element.properties.size(), 1))
            throw Error("{}: byte {}: expected {} rows of {} numbers for \"{}\", found {} bytes", path_.string(), at_,
                        element.count, element.properties.size(), element.name, bytes_.size() - at_);
        for (std::size_t k = 0; k < element.count * element.properties.size(); ++k) {
            while (at_ < bytes_.size() &&
                   (bytes_[at_] == ' ' || bytes_[at_] == '\t' || bytes_[at_] == '\r' || bytes_[at_] == '\n'))
                ++at_;
            if (at_ + 1 < bytes_.size() && bytes_[at_] == '+' && bytes_[at_ + 1] != '-') ++at_;
            double value = 0;
            const auto [end, code] = std::from_chars(bytes_.data() + at_, bytes_.data() + bytes_.size(), value);
            if (code != std::errc() && code != std::errc::result_out_of_range)
                throw Error("{}: byte {}: expected a number, found none", path_.string(), at_);
            at_ = static_cast<std::size_t>(end - bytes_.data());
            append(rows, value);
        }
    }
    bytes_ = std::move(rows);
}

bool Ply::has(std::string_view name) const {
    return std::any_of(elements_.begin(), elements_.end(), [&](const PlyElement& e) { return e.name == name; });
}

const PlyElement& Ply::element(std::string_view name) const {
    for (const PlyElement& e : elements_) {
        if (e.has_list)
            throw Error("{}: expected the element \"{}\" before \"{}\", which has lists", path_.string(), name, e.name);
        if (e.name == name) return e;
    }
    throw Error("{}: expected an element \"{}\", found none", path_.string(), name);
}

int Ply::find(const PlyElement& element, std::string_view name) {
    for (std::size_t i = 0; i < element.properties.size(); ++i)
        if (element.properties[i].name == name) return static_cast<int>(i);
    return -1;
}

int Ply::property(const PlyElement& element, std::string_view name) const {
    const int i = find(element, name);
    if (i < 0) throw Error("{}: expected a property \"{}\" of \"{}\", found none", path_.string(), name, element.name);
    return i;
}

double Ply::value(const PlyElement& element, std::size_t row, int property) const {
    const PlyProperty& p = element.properties[static_cast<std::size_t>(property)];
    const char* at = bytes_.data() + element.data + row * element.stride + p.offset;
    if (p.kind == 'f') return p.bytes == 4 ? read_as<float>(at) : read_as<double>(at);
    if (p.kind == 'i')
        return p.bytes == 1   ? read_as<std::int8_t>(at)
               : p.bytes == 2 ? read_as<std::int16_t>(at)
                              : read_as<std::int32_t>(at);
    return p.bytes == 1   ? read_as<std::uint8_t>(at)
           : p.bytes == 2 ? read_as<std::uint16_t>(at)
                          : read_as<std::uint32_t>(at);
}

double Ply::share(const PlyElement& element, std::size_t row, int property) const {
    const PlyProperty& p = element.properties[static_cast<std::size_t>(property)];
    const double v = value(element, row, property);
    return p.kind == 'f' ? v : v / (std::ldexp(1.0, 8 * p.bytes - (p.kind == 'i' ? 1 : 0)) - 1);
}

std::vector<int> sh_columns(const Ply& ply, const PlyElement& element, int& degree) {
    std::vector<int> all;
    for (int at; (at = Ply::find(element, fmt::format("f_rest_{}", all.size()))) >= 0;) all.push_back(at);
    std::size_t here = 0, found = 5;  // coefficients per channel; the degree
    for (std::size_t d = 0; d <= 4; ++d)
        if (const std::size_t k = (d + 1) * (d + 1) - 1; all.size() == 3 * k) here = k, found = d;
    if (found > 4)
        throw Error("{}: expected 0, 9, 24, 45 or 72 properties f_rest_*, found {}", ply.path().string(), all.size());
    degree = static_cast<int>(std::min<std::size_t>(found, 3));
    const auto kept = static_cast<std::size_t>((degree + 1) * (degree + 1) - 1);
    std::vector<int> columns;
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (std::size_t k = 0; k < kept; ++k) columns.push_back(all[channel * here + k]);
    return columns;
}

}  // namespace fastscene
