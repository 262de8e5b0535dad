// "The tables that don't have a candle", "the shelf with books": things by what stands on them or at them.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

struct Carrying {
    std::string_view words;
    bool has;
};
// The longer ones first.
constexpr std::array<Carrying, 14> kCarrying{{{"that does not have", false},
                                              {"that do not have", false},
                                              {"that doesn't have", false},
                                              {"that doesnt have", false},
                                              {"that don't have", false},
                                              {"that dont have", false},
                                              {"that have no", false},
                                              {"that has no", false},
                                              {"with no", false},
                                              {"that lack", false},
                                              {"without", false},
                                              {"that have", true},
                                              {"that has", true},
                                              {"with", true}}};

}  // namespace

std::optional<std::vector<int>> at_ends_of_table(const Editor& editor, const Words& words) {
    const std::size_t ends = find_word(words, {"ends", "end", "head", "heads", "sides"}, 3);
    // "The chairs at the ends": of the tables at which they stand.
    const bool bare = ends + 1 == words.size() && is_one_of(words[ends], {"ends", "heads"});
    if (!bare && (ends + 2 >= words.size() || words[ends + 1] != "of")) return {};
    if (!is_one_of(words[ends - 2], {"at", "on"})) return {};
    const bool at_ends = words[ends] != "sides";
    const bool sides = is_one_of(words[ends - 1], {"long", "both"}) && !at_ends;
    if (!at_ends && !sides) return {};
    const auto& all = editor.room().furnished.placed;
    std::vector<int> tables = bare ? std::vector<int>{} : all_named(editor, text_of(words, ends + 2));
    for (int i = 0; bare && i < static_cast<int>(all.size()); ++i)
        if (is_sat_at(all[static_cast<std::size_t>(i)].piece.kind)) tables.push_back(i);
    std::vector<int> out;
    for (const int i : all_named(editor, "all " + text_of(words, is_definite(words.front()) ? 1 : 0, ends - 2))) {
        const Placed& p = all[static_cast<std::size_t>(i)];
        if (p.with < 0 || std::find(tables.begin(), tables.end(), p.with) == tables.end()) continue;
        const Placed& t = all[static_cast<std::size_t>(p.with)];
        const Vec3f d = p.position - t.position;
        const bool wide = t.piece.size_m.x >= t.piece.size_m.z;
        const float x = std::abs(dot(d, right_of(t.yaw))) - t.piece.size_m.x / 2;
        const float z = std::abs(dot(d, front_of(t.yaw))) - t.piece.size_m.z / 2;
        if ((wide ? x > z : z > x) == at_ends) out.push_back(i);
    }
    if (out.empty()) throw UsageError("nothing is there, found \"{}\"", text_of(words));
    return out;
}

std::optional<std::vector<int>> on_side_of_table(const Editor& editor, const Words& words) {
    const std::size_t side = find_word(words, {"side"}, 3);
    if (side + 2 >= words.size() || words[side + 1] != "of" || !is_one_of(words[side - 1], {"window", "door"}))
        return {};
    std::size_t at = side - 1;
    while (at > 1 && !is_one_of(words[at], {"on", "at"})) --at;
    const auto& all = editor.room().furnished.placed;
    const std::vector<int> tables = all_named(editor, text_of(words, side + 2));
    std::vector<int> out;
    for (const int i : all_named(editor, "all " + text_of(words, is_definite(words.front()) ? 1 : 0, at)))
        for (const int t : tables) {
            const Placed &p = all[static_cast<std::size_t>(i)], &table = all[static_cast<std::size_t>(t)];
            if (p.with != t) continue;
            // The side towards the nearest of them.
            const Footprint box = footprint_of(table);
            float least = 1e9f;
            Vec2f out_of{};
            for (const Opening& o : editor.plan().openings) {
                if (!is_opening_of(o, words[side - 1])) continue;
                const WallFace face = editor.plan().wall(o.wall);
                const Vec2f to = flat(face.point((o.u0 + o.u1) / 2, 0));
                if (const float far = length(to - box.center); far < least)
                    least = far, out_of = flat(face.inward) * -1.f;
            }
            constexpr float kBeyond = 0.8f;  // of the table's half
            if (least < 1e8f && dot(flat(p.position) - box.center, out_of) > kBeyond * extent(box, out_of))
                out.push_back(i);
        }
    if (out.empty()) throw UsageError("nothing is there, found \"{}\"", text_of(words));
    return out;
}

std::optional<std::vector<int>> by_what_they_carry(const Editor& editor, const Words& words) {
    for (const auto& [phrase, has] : kCarrying) {
        const Words said = tokens_of(phrase);
        for (std::size_t at = 1; at + said.size() < words.size(); ++at) {
            if (part_of(words, at, at + said.size()) != said) continue;
            Words what = part_of(words, at + said.size());
            if (is_one_of(what.back(), {"it", "them"}) && what.size() > 2) what.resize(what.size() - 2);  // "on them"
            std::erase_if(what, [](const std::string& w) {
                return is_definite(w) || is_one_of(w, {"a", "an", "any", "some"});
            });
            const Words head = part_of(words, 0, at);
            if (what.empty() || is_definite(what.back()) || next_place(head) < head.size()) return {};
            const std::vector<int> carried = all_named(editor, "all " + text_of(what));
            std::vector<int> found = all_named(editor, "all " + text_of(head, is_definite(head.front()) ? 1 : 0));
            const auto& placed = editor.room().furnished.placed;
            const auto carries = [&](int i) {
                return std::any_of(carried.begin(), carried.end(), [&](int k) {
                    const Placed& p = placed[static_cast<std::size_t>(k)];
                    return k != i && (p.on == i || p.with == i);
                });
            };
            // "The cabinet with glass doors" is no cabinet with doors on it.
            if (has && std::none_of(found.begin(), found.end(), carries)) return {};
            std::erase_if(found, [&](int i) { return carries(i) != has; });
            return found.empty() ? std::nullopt : std::optional(found);
        }
    }
    return {};
}

}  // namespace fastscene::editing
