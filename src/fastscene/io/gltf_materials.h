// Materials and pictures of a glTF model. Private to io/.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fastscene/io/gltf_document.h"
#include "fastscene/io/gltf_model.h"

namespace fastscene {

// What was left out or repaired, each told once.
class GltfNotes {
  public:
    void add(const std::string& note);
    std::vector<std::string> take() { return std::move(notes_); }

  private:
    std::set<std::string> known_;
    std::vector<std::string> notes_;
};

// Which texture coordinates a texture uses, and what it does with them (KHR_texture_transform).
struct GltfUvUse {
    std::size_t set = 0;
    Vec2d offset{}, scale{1, 1};
    double rotation = 0;
    // As stored, v downward.
    Vec2d operator()(Vec2d uv) const;
    friend bool operator==(const GltfUvUse&, const GltfUvUse&) = default;
};

// A material whose pictures are not read yet: indices of textures, -1: none.
struct GltfSurface {
    GltfMaterial material;
    int base_color = -1, metallic_roughness = -1, normal = -1, emission = -1;
    int glossiness = -1;  // its alpha, times `glossiness_factor`
    float glossiness_factor = 1;
    GltfUvUse uv;         // of all of them
    bool repeats = true;  // the base color's picture, beyond its border
    bool has_textures() const {
        return base_color >= 0 || metallic_roughness >= 0 || normal >= 0 || emission >= 0 || glossiness >= 0;
    }
};
// Nothing: glTF's default material.
GltfSurface gltf_surface(const GltfDocument& document, std::optional<std::size_t> index, GltfNotes& notes);

// Reads each picture once.
class GltfImages {
  public:
    GltfImages(GltfDocument& document, const GltfLimits& limits, GltfNotes& notes)
        : document_(document), limits_(limits), notes_(notes) {}
    GltfMaterial with_images(const GltfSurface& surface);
    std::vector<GltfImage> take();

  private:
    int image(int texture, bool is_base_color);
    int roughness_image(int texture, float factor);
    int loaded(std::size_t source);
    std::optional<GltfImage> load(std::size_t source);
    std::optional<std::size_t> source_of(std::size_t texture);

    GltfDocument& document_;
    const GltfLimits& limits_;
    GltfNotes& notes_;
    std::size_t pixels_ = 0;
    std::vector<GltfImage> images_;
    std::map<std::size_t, int> of_source_;  // -1: cannot be read
    std::map<std::pair<std::size_t, float>, int> of_glossiness_;
    std::set<int> base_colors_;
};

}  // namespace fastscene
