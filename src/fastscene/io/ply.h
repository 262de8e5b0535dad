// The PLY container: elements with named scalar properties, binary little endian. Private to io/.
#pragma once

#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

struct PlyProperty {
    std::string name;
    int bytes = 4;      // size in the file
    char kind = 'f';    // f: floating point, i: signed, u: unsigned
    std::size_t offset = 0;
};
struct PlyElement {
    std::string name;
    std::size_t count = 0, stride = 0;
    std::vector<PlyProperty> properties;
    std::size_t data = 0;  // where its rows begin in the file
};

// A parsed file. Sizes are checked against the file before anything is allocated.
class Ply {
  public:
    // Throws Error naming the file, the byte or the line, what was expected and found.
    explicit Ply(const std::filesystem::path& path);

    const PlyElement& element(std::string_view name) const;  // throws Error when absent
    // Index of a property, or -1.
    static int find(const PlyElement& element, std::string_view name);
    // Throws Error when absent.
    int property(const PlyElement& element, std::string_view name) const;
    double value(const PlyElement& element, std::size_t row, int property) const;
    float number(const PlyElement& element, std::size_t row, int property) const { return static_cast<float>(value(element, row, property)); }

  private:
    std::filesystem::path path_;
    std::string bytes_;
    std::vector<PlyElement> elements_;
};

// Appends the bytes of a number, little endian (as all machines we run on are).
template <class T>
void append(std::string& out, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
}

}  // namespace fastscene
