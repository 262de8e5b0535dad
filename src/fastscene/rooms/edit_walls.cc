// "The wall behind the bed", "the window wall", "the tiles": surfaces that are named by what is there.
#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

int wall_nearest_to(const Plan& plan, const Placed& p) {
    const Footprint box = footprint_of(p);
    int best = 0;
    float least = 1e9f;
    for (int w = 0; w < 4; ++w) {
        const WallFace face = plan.wall(w);
        const float off = dot(box.center - flat(face.origin), flat(face.inward)) - extent(box, flat(face.inward));
        if (off < least) least = off, best = w;
    }
    return best;
}

int wall_at_back(const Plan& plan, const Placed& p) {
    const int behind = wall_behind(plan, p);
    return behind >= 0 ? behind : wall_nearest_to(plan, p);
}

}  // namespace

std::optional<int> wall_with(const Plan& plan, const std::string& kind) {
    std::optional<int> out;
    for (const Opening& o : plan.openings) {
        if (!is_opening_of(o, kind) && !(kind == "door" && o.kind != Opening::Kind::window)) continue;
        if (out && *out != o.wall) return {};
        out = o.wall;
    }
    return out;
}

bool is_tiled(const Material& m) {
    return m.pattern == Pattern::tile || m.pattern == Pattern::subway || m.pattern == Pattern::checker;
}

bool is_one_wall(const Words& words) {
    if (is_one_of(text_of(words), {"one wall", "a wall", "one of the walls", "only one wall"})) return true;
    Words bare = words;
    std::erase_if(bare, [](const std::string& w) { return is_definite(w) || is_one_of(w, {"only", "just", "one"}); });
    const std::size_t wall = find_word(bare, {"wall"});
    if (wall == bare.size() || bare.size() < 2) return false;
    if (wall + 1 == bare.size()) return true;
    return next_place(bare, wall + 1) == wall + 1 || is_one_of(bare[wall + 1], {"with", "that", "opposite", "behind"});
}

int wall_meant(const Editor& editor, const Words& words, const std::vector<std::string>& spoken) {
    const auto unclear = [&]() -> int {
        throw UsageError(
            "which wall? expected \"the wall behind the bed\", \"the window wall\", \"the left wall\", found \"{}\"",
            text_of(words));
    };
    const Plan& plan = editor.plan();
    const auto part = room_part(words, 0);
    // "The shower wall" is that behind the shower.
    if (!part && words.size() > 1 && noun_of(words.back()) == "wall")
        if (const std::vector<int> at = all_named(editor, text_of(words, 0, words.size() - 1)); at.size() == 1)
            return wall_at_back(plan, editor.room().furnished.placed[static_cast<std::size_t>(at.front())]);
    if (!part) return unclear();
    if (is_one_of(part->noun, {"window", "door"}) || part->says({"window", "door"})) {
        const auto wall = wall_with(plan, part->says({"window"}) ? "window"
                                          : part->says({"door"}) ? "door"
                                                                 : part->noun);
        return wall ? *wall : unclear();
    }
    Words rest = part_of(words, part->next);
    if (rest.empty()) {
        if (part->is_other() || part->modifiers.empty()) return unclear();
        Words all{"against"};
        all.insert(all.end(), words.begin(), words.end());
        const auto place = place_of(editor, all, "", "", spoken);
        return place && place->step.wall >= 0 ? place->step.wall : unclear();
    }
    while (!rest.empty() && is_one_of(rest.front(), {"that", "which", "is", "has", "right", "directly", "just"}))
        rest.erase(rest.begin());
    if (!rest.empty() && is_one_of(rest.front(), {"with", "of", "around"})) rest.front() = "at";
    const auto relation = relation_at(rest, 0);
    if (!relation) return unclear();
    const Words there = part_of(rest, relation->next);
    if (const auto known = room_part(there, 0); known && known->next == there.size()) {
        const auto wall = wall_with(plan, known->noun);
        if (!wall) return unclear();
        return relation->name == "opposite" ? (*wall + 2) % 4 : *wall;
    }
    const bool it = there.size() == 1 && is_one_of(there.front(), {"it", "them"});
    const std::vector<std::string> ids = it ? spoken : named(editor, text_of(there));
    if (ids.empty()) return unclear();
    const Placed& at = editor.placed(ids.front());
    const int own = wall_at_back(plan, at);
    if (relation->name != "opposite" && relation->name != "in front of") return own;
    // Opposite is where its front looks.
    int best = 0;
    for (int w = 1; w < 4; ++w)
        if (dot(plan.wall(w).inward, front_of(at.yaw)) < dot(plan.wall(best).inward, front_of(at.yaw))) best = w;
    return best;
}

std::string tiled_surface(const Editor& editor) {
    const Style& style = editor.plan().style;
    const bool floor = is_tiled(style.floor), walls = is_tiled(style.wall);
    const bool accent = editor.plan().accent && is_tiled(style.accent_wall);
    if (floor && (walls || accent)) throw UsageError("which tiles? expected \"the floor tiles\" or \"the wall tiles\"");
    if (!floor && !walls && !accent) throw UsageError("there are no tiles in the room");
    return floor ? "floor" : walls ? "wall" : "accent_wall";
}

}  // namespace fastscene::editing
