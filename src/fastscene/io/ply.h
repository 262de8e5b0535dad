// The PLY container: elements with named scalar properties, text or binary of either byte order. Private to io/.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/bytes.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

struct PlyProperty {
    std::string name;
    int bytes = 4;    // size in the file
    char kind = 'f';  // f: floating point, i: signed, u: unsigned
    std::size_t offset = 0;
};
struct PlyElement {
    std::string name;
    std::size_t count = 0, stride = 0;
    std::vector<PlyProperty> properties;
    std::size_t data = 0;   // offset of its rows
    bool has_list = false;  // such as the faces of a mesh: neither it nor what follows is read
};

// A parsed file. Sizes are checked against the file before anything is allocated.
class Ply {
  public:
    // Throws Error naming the file, the byte or line, expected and actual.
    explicit Ply(const std::filesystem::path& path);
    // The same of a file that has been read already.
    Ply(const std::filesystem::path& path, std::string bytes);

    const std::filesystem::path& path() const { return path_; }
    const std::vector<std::string>& comments() const { return comments_; }
    bool has(std::string_view name) const;
    // throws Error if absent, or unreadable because it follows a list
    const PlyElement& element(std::string_view name) const;
    // Index of a property, or -1.
    static int find(const PlyElement& element, std::string_view name);
    // Throws Error if absent.
    int property(const PlyElement& element, std::string_view name) const;
    // A color channel, 0 to 1: integers are shares of the type's largest number.
    double share(const PlyElement& element, std::size_t row, int property) const;
    double value(const PlyElement& element, std::size_t row, int property) const;
    float number(const PlyElement& element, std::size_t row, int property) const {
        return static_cast<float>(value(element, row, property));
    }

  private:
    enum class Encoding { text, little, big };
    Encoding parse_header();
    void parse_header_line(const std::string& line);
    std::string next_line();
    void place_binary_rows();
    void swap_bytes();
    void read_text_rows();

    std::filesystem::path path_;
    std::string bytes_;
    std::size_t at_ = 0;  // parser position
    std::vector<PlyElement> elements_;
    std::vector<std::string> comments_;
};

// The f_rest_* columns to keep, channel-major, and their degree: files may have 0, 9, 24, 45 or 72 (degree 4, of which
// the first three degrees are kept). Throws Error for another number.
std::vector<int> sh_columns(const Ply& ply, const PlyElement& element, int& degree);

// Header comments about splats, in the convention shared by Brush, splat-transform and gsplat: "SplatRenderMode: mip".
// Postshot's "antialiased 1" is read, too; "fastscene low-pass 0.1" is our own.
std::string ply_comments(const Splats& splats);
FootprintFilter footprint_filter(const Ply& ply);

bool is_compressed_ply(const Ply& ply);
bool has_compressed_ply_header(std::string_view bytes);
Splats splats_of_compressed_ply(const Ply& ply);
ReadSplats splats_of_ply(const Ply& ply);

}  // namespace fastscene
