// What is said where words mean none of the room's things, or several where one is meant.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/prompt_text.h"

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

std::optional<std::vector<int>> by_distance(const Editor& editor, const Words& words) {
    const std::size_t at = find_word(words, {"closest", "nearest", "farthest", "furthest"}, 1);
    if (at >= words.size()) return {};
    // "the closest table to the door"
    const std::size_t to = find_word(words, {"to", "from"}, at);
    Words head = part_of(words, 0, at);
    const Words after = part_of(words, at + 1, to);
    head.insert(head.end(), after.begin(), after.end());
    const Words target = part_of(words, to < words.size() ? to + 1 : at + 1);
    if (target.empty() || (to == words.size() && !after.empty())) return {};
    std::vector<Vec2f> places;
    if (is_one_of(target.back(), {"me", "us", "viewer"})) places.push_back(flat(editor.room().furnished.camera));
    else if (const auto part = room_part(target, 0)) {
        for (const Opening& o : editor.plan().openings)
            if (is_opening_of(o, part->noun))
                places.push_back(flat(editor.plan().wall(o.wall).point((o.u0 + o.u1) / 2, 0)));
    } else
        for (const int i : all_named(editor, text_of(target)))
            places.push_back(footprint_of(editor.room().furnished.placed[static_cast<std::size_t>(i)]).center);
    std::size_t count = 1;
    std::erase_if(head, [&](const std::string& w) {
        const auto number = is_definite(w) ? std::nullopt : number_said(w);
        if (number) count = static_cast<std::size_t>(std::max(1.f, *number));
        return number || is_definite(w) || is_one_of(w, {"that", "is", "are", "which", "standing"});
    });
    std::vector<int> found = head.empty() ? std::vector<int>{} : all_named(editor, "all " + text_of(head));
    if (places.empty() || found.size() <= count) return {};
    const auto far = [&](int i) {
        float least = 1e9f;
        for (const Vec2f p : places)
            least = std::min(least,
                             distance_to(footprint_of(editor.room().furnished.placed[static_cast<std::size_t>(i)]), p));
        return is_one_of(words[at], {"closest", "nearest"}) ? least : -least;
    };
    std::stable_sort(found.begin(), found.end(), [&](int a, int b) { return far(a) < far(b); });
    // "The chairs closest to the door": with those that are about as close.
    constexpr float kAsClose = 0.5f;  // metres
    const bool several = count == 1 && !head.empty() && head.back().ends_with("s");
    while (several && count < found.size() && far(found[count]) < far(found.front()) + kAsClose) ++count;
    found.resize(count);
    std::sort(found.begin(), found.end());
    return found;
}

void nearest_to(const Editor& editor, const std::string& kind, std::vector<int>& found, std::size_t count) {
    const FurnishedRoom& room = editor.room().furnished;
    std::vector<Vec2f> places;
    for (const Opening& o : room.plan.openings)
        if (is_opening_of(o, kind)) places.push_back(flat(room.plan.wall(o.wall).point((o.u0 + o.u1) / 2, 0)));
    for (const Placed& p : room.placed)
        if (p.piece.kind == kind || p.wish.kind == kind) places.push_back(footprint_of(p).center);
    const auto far = [&](int i) {
        float least = 1e9f;
        for (const Vec2f at : places)
            least = std::min(least, distance_to(footprint_of(room.placed[static_cast<std::size_t>(i)]), at));
        return least;
    };
    if (places.empty() || found.size() <= count) return;
    std::stable_sort(found.begin(), found.end(), [&](int a, int b) { return far(a) < far(b); });
    found.resize(count);
    std::sort(found.begin(), found.end());
}

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

bool is_viewpoint(const std::string& word) { return is_one_of(word, {"camera", "viewpoint", "viewer"}); }

void refuse_none(const std::string& words, const Editor& editor, const std::string& kind) {
    const Words tokens = tokens_of(words);
    if (std::any_of(tokens.begin(), tokens.end(), is_viewpoint))
        throw UsageError(
            "the camera stays where it is; \"camera\" in the document says where it stands and looks "
            "(docs/room-document.md)");
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
