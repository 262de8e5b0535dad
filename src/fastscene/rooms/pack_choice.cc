// Which models of the furniture pack serve for which kinds: their rows in the catalogue of things say.
#include <algorithm>
#include <array>
#include <cctype>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/pack_parts.h"

namespace fastscene {
namespace packs {
namespace {

bool has_word(std::string_view kind, std::string_view word) { return kind.find(word) != std::string_view::npos; }

}  // namespace

bool keeps_builder(const std::string& kind) {
    // Extras that the pack shows better than our builders do; every other class with a builder of ours keeps it.
    if (has_role(kind, Role::prefers_model)) return false;
    return std::binary_search(piece_classes().begin(), piece_classes().end(), kind);
}

std::vector<std::string> catalogue_classes(const std::string& kind) {
    std::vector<std::string> out;
    if (const Thing* thing = find_thing(kind)) out = thing->models;
    if (std::find(out.begin(), out.end(), kind) == out.end()) out.push_back(kind);
    return out;
}

bool fits_a_room(const PackModel& model) {
    constexpr float kLargest = 2.7f, kTallest = 2.35f;
    return !model.opening && model.size_m.x <= kLargest && model.size_m.z <= kLargest &&
           (model.size_m.y <= kTallest || has_word(model.kind, "staircase"));
}

Mount mount_of(const PackModel& m) {
    const float top = m.elevation_m + m.size_m.y;
    if (m.elevation_m > 1.4f &&
        (m.category == "Lights" || has_word(m.kind, "ceiling") || has_word(m.kind, "hanging") ||
         has_word(m.kind, "chandelier")) &&
        top > 2.1f && !has_word(m.kind, "wall"))
        return Mount::ceiling;
    if (m.elevation_m > 0.09f && !is_one_of(m.kind, {"towel", "toilet_brush"})) return Mount::wall;
    // Small, but it stands on the floor.
    if (m.category == "Characters" || is_floor_model(m.kind)) return Mount::floor;
    const float wide = std::max(m.size_m.x, m.size_m.z);
    return wide < 0.52f && m.size_m.y < 0.6f ? Mount::surface : Mount::floor;
}

}  // namespace packs

std::optional<std::string> stand_in(const std::string& kind) {
    if (const Thing* thing = find_thing(kind); thing && !thing->stand_in.empty()) return thing->stand_in;
    return {};
}

}  // namespace fastscene
