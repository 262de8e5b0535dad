// A glTF 2.0 file with its data: buffers, views of them, and accessors. Private to io/.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/io/glb_container.h"
#include "fastscene/io/gltf_json.h"

namespace fastscene {

// The content of a file beside the model, named relative to it; nothing if there is none.
using ReadGltfSibling = std::function<std::optional<std::string>(const std::string& name)>;

// Rows of numbers, read where they lie: an accessor takes no memory of its own.
class GltfAccessor {
  public:
    std::size_t count() const { return count_; }
    std::size_t width() const { return width_; }
    // Component `c` of row `i`.
    float at(std::size_t i, std::size_t c) const;
    std::uint32_t whole(std::size_t i) const;

  private:
    friend class GltfDocument;
    struct Rows {
        std::string_view data;
        std::size_t first = 0, stride = 0;
        bool none = true;  // zeros
    };
    // The row's bytes; nothing where it is zero.
    std::optional<std::pair<std::string_view, std::size_t>> row(std::size_t i) const;

    std::size_t count_ = 0, width_ = 0, component_ = 0;
    bool normalized_ = false;
    Rows rows_;
    // Sparse: rows that replace others.
    std::size_t replaced_ = 0, index_component_ = 0;
    Rows indices_, values_;
};

class GltfDocument : public GltfJson {
  public:
    // `bytes`, of a .glb or a .gltf, must outlive the document. `where` names the file in errors.
    GltfDocument(const std::string& where, std::string_view bytes, const ReadGltfSibling& read_sibling);

    // The bytes of a buffer view, decompressed.
    std::string_view view(std::size_t index);
    // What a URI names: a file beside the model, or data within it. Throws Error if the URI leaves the model's folder;
    // nothing if there is no such file.
    std::optional<std::string> content(const std::string& uri) const;
    // Rows of numbers with one of the `widths`. `use` names it in errors: "POSITION".
    const GltfAccessor& accessor(std::size_t index, const char* use, const std::vector<std::size_t>& widths);

  private:
    GltfDocument(const std::string& where, const GlbChunks& chunks, std::size_t size,
                 const ReadGltfSibling& read_sibling);
    std::string_view buffer(std::size_t index);
    std::string_view part(const Json& owner, std::size_t buffer, std::size_t otherwise_begin);
    std::string_view unpacked(std::size_t index, const Json& how);
    GltfAccessor made(const Json& of, const std::string& use);
    GltfAccessor::Rows rows(const Json& owner, std::size_t count, std::size_t row, const std::string& use);
    void add_sparse(GltfAccessor& accessor, const Json& sparse, const std::string& use);

    std::string_view binary_;
    std::size_t bytes_, unpacked_bytes_ = 0;
    const ReadGltfSibling& read_sibling_;
    std::map<std::string, std::string> files_;  // by URI
    std::map<std::size_t, std::string> unpacked_;
    std::map<std::size_t, GltfAccessor> accessors_;
};

}  // namespace fastscene
