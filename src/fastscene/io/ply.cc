#include "fastscene/io/ply.h"

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
constexpr Type kTypes[] = {{"char", "int8", 1, 'i'},   {"uchar", "uint8", 1, 'u'},   {"short", "int16", 2, 'i'}, {"ushort", "uint16", 2, 'u'},
                           {"int", "int32", 4, 'i'},   {"uint", "uint32", 4, 'u'},   {"float", "float32", 4, 'f'}, {"double", "float64", 8, 'f'}};

const Type* type_named(const std::string& name) {
    for (const Type& t : kTypes)
        if (name == t.name || name == t.other) return &t;
    return nullptr;
}

template <class T>
double read_as(const char* p) {
    T v;
    std::memcpy(&v, p, sizeof v);
    return static_cast<double>(v);
}

}  // namespace

Ply::Ply(const std::filesystem::path& path) : path_(path), bytes_(read_file(path)) {
    std::size_t at = 0;
    const auto next_line = [&] {
        const std::size_t end = bytes_.find('\n', at);
        // A header line is short; anything longer is not a header.
        if (end == std::string::npos || end - at > 1000) throw Error("{}: byte {}: expected a PLY header line, found none", path.string(), at);
        std::string line = bytes_.substr(at, end - at);
        if (!line.empty() && line.back() == '\r') line.pop_back();
        at = end + 1;
        return line;
    };
    if (next_line() != "ply") throw Error("{}: expected a PLY file, found another first line", path.string());
    if (const std::string format = next_line(); format != "format binary_little_endian 1.0")
        throw Error("{}: expected \"format binary_little_endian 1.0\", found \"{}\"", path.string(), format);
    for (std::string line = next_line(); line != "end_header"; line = next_line()) {
        std::istringstream words(line);
        std::string word, type, name;
        words >> word;
        if (word == "comment" || word == "obj_info") continue;
        if (word == "element") {
            PlyElement element;
            if (!(words >> element.name >> element.count)) throw Error("{}: expected \"element NAME COUNT\", found \"{}\"", path.string(), line);
            elements_.push_back(element);
        } else if (word == "property" && words >> type >> name && type_named(type) && !elements_.empty()) {
            PlyElement& element = elements_.back();
            element.properties.push_back({name, type_named(type)->bytes, type_named(type)->kind, element.stride});
            element.stride += static_cast<std::size_t>(type_named(type)->bytes);
        } else {
            throw Error("{}: expected an element or a scalar property, found \"{}\"", path.string(), line);
        }
    }
    for (PlyElement& element : elements_) {
        element.data = at;
        const std::size_t left = bytes_.size() - at;
        if (element.stride && element.count > left / element.stride)
            throw Error("{}: byte {}: expected {} rows of {} bytes for \"{}\", found {} bytes", path.string(), at, element.count, element.stride,
                        element.name, left);
        at += element.count * element.stride;
    }
}

const PlyElement& Ply::element(std::string_view name) const {
    for (const PlyElement& e : elements_)
        if (e.name == name) return e;
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
    if (p.kind == 'i') return p.bytes == 1 ? read_as<std::int8_t>(at) : p.bytes == 2 ? read_as<std::int16_t>(at) : read_as<std::int32_t>(at);
    return p.bytes == 1 ? read_as<std::uint8_t>(at) : p.bytes == 2 ? read_as<std::uint16_t>(at) : read_as<std::uint32_t>(at);
}

}  // namespace fastscene
