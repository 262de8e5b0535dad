// What the document_*.cc files share.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/rooms/document.h"

namespace fastscene {

namespace document_fields {

// "room.json:12: /things/3/kind".
std::string place_in(std::string_view text, const std::string& file, const std::string& pointer);
Json material_json(const Material& material);
float radians_of(double degrees);
// A known color or "#rrggbb".
std::optional<Vec3f> color_said(const std::string& text);
// A material, or paint in a color, by name.
std::optional<Material> surface_named(const std::string& name);

}  // namespace document_fields

// The camera of a document stands inside of a thing.
class CameraInside : public Error {
  public:
    using Error::Error;
};

// A style with a document's materials, and what of a style is no longer `usual`.
void dress(const DocumentSurfaces& surfaces, Style& style);
DocumentSurfaces surfaces_of(const Style& style, const Style& usual);
DocumentThing thing_of(const Placed& placed, const std::vector<std::string>& ids, std::size_t index);
// Right-angled outlines as a box and its blocks. Throws Error, beginning with `place`, for lines that cross or slant.
void apply_polygon(const std::vector<Vec2f>& polygon, const std::string& place, Plan& plan);

}  // namespace fastscene
