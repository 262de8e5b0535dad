// What is said where words mean none of the room's things, or several where one is meant.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "fastscene/base/error.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

// Where a thing stands, in words that tell it from its like.
std::string whereabouts(const RoomDocument& document, const DocumentRoom& room, std::size_t index) {
    const DocumentThing& t = document.things[index];
    if (!t.on.empty()) return "on " + t.on;
    const std::vector<Placed>& placed = room.furnished.placed;
    const Footprint box = footprint_of(placed[index]);
    PromptObject at;
    at.relation = "next to";
    for (const char* opening : {"window", "door", "doorway"}) {
        at.relation_to = opening;
        if (stands_as_asked(room.furnished.plan, placed, placed[index], at).value_or(false))
            return std::string("at the ") + opening;
    }
    constexpr float kNear = 0.8f;  // metres
    float nearest = kNear;
    std::string other;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (i == index || placed[i].flat || placed[i].on >= 0 || placed[i].piece.kind == placed[index].piece.kind)
            continue;
        if (const float far = distance_to(footprint_of(placed[i]), box.center); far < nearest)
            nearest = far, other = document.things[i].id;
    }
    if (!other.empty()) return "by " + other;
    return fmt::format("at x {:.1f}, z {:.1f}", t.position.x, t.position.z);
}

float bulk_of(const Placed& p) { return p.piece.size_m.x * p.piece.size_m.y * p.piece.size_m.z; }

}  // namespace

void refuse_shell() {
    throw UsageError(
        "sentences do not change the room's shape, its windows or doors; \"plan\" in the document does: width_m, "
        "depth_m, height_m, openings (docs/room-document.md)");
}

void refuse_many(const std::string& words, const Editor& editor, const std::vector<int>& found) {
    constexpr std::size_t kMost = 6;
    std::vector<std::string> list;
    for (const int i : found) {
        if (list.size() == kMost) break;
        list.push_back(editor.document().things[static_cast<std::size_t>(i)].id + " " +
                       whereabouts(editor.document(), editor.room(), static_cast<std::size_t>(i)));
    }
    throw UsageError("which {}? {}{}", words, fmt::join(list, ", "),
                     found.size() > kMost ? fmt::format(" and {} more", found.size() - kMost) : "");
}

void refuse_none(const std::string& words, const Editor& editor, const std::string& kind) {
    const std::vector<DocumentThing>& things = editor.document().things;
    std::vector<int> order(things.size());
    std::iota(order.begin(), order.end(), 0);
    const int label = kind.empty() ? -1 : nyu40_label(kind);
    const auto rank = [&](int i) {
        const DocumentThing& t = things[static_cast<std::size_t>(i)];
        return (nyu40_label(t.kind) == label ? 1e3f : 0.f) + bulk_of(editor.placed(t.id));
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) > rank(b); });
    constexpr std::size_t kMost = 5;
    std::vector<std::string> near;
    for (const int i : order)
        if (near.size() < kMost) near.push_back(things[static_cast<std::size_t>(i)].id);
    throw UsageError("there is no \"{}\" in the room; there are {}{}", words, fmt::join(near, ", "),
                     things.size() > near.size() ? " and smaller things" : "");
}

}  // namespace fastscene::editing
