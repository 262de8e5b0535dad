// "The desk lamp", "the window plant", "the coffee table books", "the table": nouns that name a thing by where it
// stands, and bare nouns that mean the main one of their sort.
#include <algorithm>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene::editing {
namespace {

const DocumentThing& thing_at(const Editor& editor, int i) {
    return editor.document().things[static_cast<std::size_t>(i)];
}
const Placed& placed_at(const Editor& editor, int i) {
    return editor.room().furnished.placed[static_cast<std::size_t>(i)];
}

// The nouns and adjectives: no articles, no numbers, nothing of a place.
Words content_of(const Words& words) {
    Words out = part_of(words, 0, next_place(words));
    std::erase_if(out, [](const std::string& w) {
        return is_definite(w) || number_said(w) || is_joint(w) ||
               is_one_of(w, {"all", "both", "every", "each", "of", "other", "another", "some", "any"});
    });
    for (std::string& w : out)
        if (w.size() > 2 && w.ends_with("'s")) w.resize(w.size() - 2);
    return out;
}

bool is_close(const Editor& editor, int i, const std::string& relation, const std::string& to) {
    PromptObject at;
    at.id = -2;  // none of those that stand there
    at.relation = relation, at.relation_to = to;
    const FurnishedRoom& room = editor.room().furnished;
    return stands_as_asked(room.plan, room.placed, placed_at(editor, i), at).value_or(false);
}

// What the first noun of a compound is: things of the room, or a part of it.
struct Support {
    std::string part;         // wall, floor, ceiling, window, door, corner
    std::vector<int> things;  // that may carry it, or that it stands by
    bool beside = false;      // … and it does not stand on them: "bedside"
    bool is_known() const { return !part.empty() || !things.empty(); }
};

Support support_of(const Editor& editor, const Words& words) {
    Support out;
    const std::string text = text_of(words);
    if (text == "bedside") {
        out.beside = true;
        for (int i = 0; i < static_cast<int>(editor.document().things.size()); ++i)
            if (has_role(placed_at(editor, i).piece.kind, Role::bed)) out.things.push_back(i);
        return out;
    }
    if (words.size() == 1) out.part = noun_of(words.front());
    if (out.part == "room" || out.part == "middle" || out.part == "side") out.part.clear();
    if (!out.part.empty()) return out;
    const auto word = look_up(text);
    if (word && word->kind == WordKind::object) out.things = all_named(editor, text);
    return out;
}

// Those within reach of who lies there.
std::vector<int> beside(const Editor& editor, const std::vector<int>& beds, const std::vector<int>& found) {
    constexpr float kReach = 0.7f;  // metres from a bed's edge
    std::vector<int> out;
    for (const int i : found)
        if (std::any_of(beds.begin(), beds.end(), [&](int bed) {
                const Placed& b = placed_at(editor, bed);
                // At its head, where that has one.
                const bool foot = !has_role(b.piece.kind, Role::along_wall) &&
                                  dot(placed_at(editor, i).position - b.position, front_of(b.yaw)) > 0;
                return !foot && distance_to(footprint_of(placed_at(editor, bed)),
                                            footprint_of(placed_at(editor, i)).center) < kReach;
            }))
            out.push_back(i);
    return out;
}

// On the things or before the part of the room; if there is none such, beside them.
std::vector<int> those_at(const Editor& editor, const Support& support, const std::vector<int>& found) {
    if (support.beside) return beside(editor, support.things, found);
    std::vector<int> on, by;
    for (const int i : found) {
        const Placed& p = placed_at(editor, i);
        const Mount mount = p.piece.mount;
        if (support.part == "wall"      ? mount == Mount::wall
            : support.part == "ceiling" ? mount == Mount::ceiling
            : support.part == "floor"   ? mount == Mount::floor && p.on < 0 && p.sill < 0
            : support.part == "window"  ? p.sill >= 0
                                        : false)
            on.push_back(i);
        else if (support.part == "corner" && is_close(editor, i, "in the corner", "")) on.push_back(i);
        else if (is_one_of(support.part, {"window", "door", "doorway"}) && is_close(editor, i, "next to", support.part))
            by.push_back(i);
        if (std::find(support.things.begin(), support.things.end(), p.on) != support.things.end()) on.push_back(i);
        else
            for (const int k : support.things)
                if (k != i && (is_close(editor, i, "next to", placed_at(editor, k).piece.kind) ||
                               is_close(editor, i, "above", placed_at(editor, k).piece.kind))) {
                    by.push_back(i);
                    break;
                }
    }
    return on.empty() ? by : on;
}

// Whether a kind of the room bears this very name: a floor lamp is one wherever it stands.
bool is_own_name(const Editor& editor, const std::string& text) {
    const auto forms = base_forms(text);
    return std::any_of(editor.document().things.begin(), editor.document().things.end(), [&](const DocumentThing& t) {
        const std::string asked = t.asked ? t.asked->kind : "";
        return std::any_of(forms.begin(), forms.end(),
                           [&](const std::string& f) { return f == in_words(t.kind) || f == in_words(asked); }) ||
               text == in_words(t.kind) || text == in_words(asked);
    });
}

}  // namespace

void at_support(const Editor& editor, const Words& words, std::vector<int>& found) {
    const Words content = content_of(words);
    if (content.size() < 2 || found.empty()) return;
    for (std::size_t from = 0; from + 1 < content.size(); ++from)
        if (is_own_name(editor, text_of(content, from))) return;
    for (std::size_t from = 0; from + 1 < content.size(); ++from)
        for (std::size_t mid = content.size() - 1; mid > from; --mid) {
            const Support support = support_of(editor, part_of(content, from, mid));
            if (!support.is_known()) continue;
            // A desk itself is not what is at the desk.
            if (std::any_of(found.begin(), found.end(), [&](int i) {
                    return std::find(support.things.begin(), support.things.end(), i) != support.things.end();
                }))
                continue;
            const std::vector<int> there = those_at(editor, support, found);
            if (!there.empty()) {
                found = there;
                return;
            }
            // The lamp of a nightstand is not the lamp of the desk.
            const bool others = std::all_of(found.begin(), found.end(),
                                            [&](int i) { return placed_at(editor, i).on >= 0; }) &&
                                std::any_of(support.things.begin(), support.things.end(),
                                            [&](int i) { return !placed_at(editor, i).piece.surfaces.empty(); });
            if (others) found.clear();
            return;
        }
}

bool beside_as_seen(const Editor& editor, const PromptObject& where, std::vector<int>& found) {
    if (!is_one_of(where.relation, {"left of", "right of"}) || where.relation_to.empty() || where.count < 3)
        return false;
    constexpr float kMiddle = 0.2f, kNear = 1.2f;  // metres
    const FurnishedRoom& room = editor.room().furnished;
    const auto to_the_right = [&](const Placed& p) {
        return dot(p.position - room.camera, cross(room.looks, Vec3f{0, 1, 0}));
    };
    std::vector<int> there;
    for (const Placed& at : room.placed) {
        if (at.piece.kind != where.relation_to && at.wish.kind != where.relation_to) continue;
        for (const int i : found) {
            const Placed& p = placed_at(editor, i);
            const float aside = to_the_right(p) - to_the_right(at);
            if ((where.relation == "left of" ? -aside : aside) > kMiddle &&
                distance_to(footprint_of(at), footprint_of(p).center) < kNear)
                there.push_back(i);
        }
    }
    if (there.empty()) return false;
    found = there;
    return true;
}

void at_anchors(const Editor& editor, const std::string& relation, const std::vector<int>& anchors,
                std::vector<int>& found) {
    std::vector<Placed> all = editor.room().furnished.placed;
    for (const int i : anchors) all[static_cast<std::size_t>(i)].wish.kind = "@at";
    PromptObject wish;
    wish.id = -2;  // none of those that stand there
    wish.relation_to = "@at";
    wish.relation = is_one_of(relation, {"at", "to", "in", "along", "from"}) ? "next to" : relation;
    std::vector<int> there;
    for (const int i : found) {
        const Placed& p = all[static_cast<std::size_t>(i)];
        const bool has_it = std::any_of(anchors.begin(), anchors.end(),
                                        [&](int k) { return p.on == k || (p.with == k && relation != "on"); });
        if (has_it || stands_as_asked(editor.plan(), all, p, wish).value_or(false)) there.push_back(i);
    }
    found = there;
}

std::vector<int> compound_named(const Editor& editor, const Words& words) {
    const Words content = content_of(words);
    for (std::size_t from = 0; from + 1 < content.size(); ++from) {
        // Terms of the lexicon and kinds of the room are no compounds.
        if (look_up(text_of(content, from)) || is_own_name(editor, text_of(content, from))) return {};
        for (std::size_t mid = content.size() - 1; mid > from; --mid) {
            const auto first = look_up(text_of(content, from, mid)), second = look_up(text_of(content, mid));
            if (!first || !second || second->kind != WordKind::object) continue;
            const Support support = support_of(editor, part_of(content, from, mid));
            if (!support.is_known()) continue;
            return those_at(editor, support, all_named(editor, "all " + text_of(content, mid)));
        }
    }
    return {};
}

std::optional<EditStep> on_support(const Editor& editor, const Words& words) {
    const Words content = content_of(words);
    for (std::size_t from = 0; from + 1 < content.size(); ++from)
        for (std::size_t mid = content.size() - 1; mid > from; --mid) {
            Support support = support_of(editor, part_of(content, from, mid));
            if (support.beside) {
                std::vector<int> all;
                for (int i = 0; i < static_cast<int>(editor.document().things.size()); ++i)
                    if (placed_at(editor, i).on < 0 && placed_at(editor, i).sill < 0) all.push_back(i);
                std::erase_if(all, [&](int i) { return has_role(placed_at(editor, i).piece.kind, Role::bed); });
                support.things = beside(editor, support.things, all);
            }
            // What one may reach, as high as tables are.
            constexpr float kHigh = 1.3f;  // metres
            std::erase_if(support.things, [&](int i) {
                const Placed& p = placed_at(editor, i);
                return p.piece.surfaces.empty() || p.piece.size_m.y > kHigh || p.on >= 0;
            });
            if (support.things.empty()) continue;
            // The smallest beside a bed: a nightstand before a dresser.
            const int at = *std::min_element(support.things.begin(), support.things.end(), [&](int a, int b) {
                const Vec3f one = placed_at(editor, a).piece.size_m, other = placed_at(editor, b).piece.size_m;
                return one.x * one.z < other.x * other.z;
            });
            EditStep step;
            step.wish.relation = "on", step.wish.relation_to = thing_at(editor, at).kind;
            step.at = {thing_at(editor, at).id};
            return step;
        }
    return {};
}

std::vector<int> main_of(const Editor& editor, const std::vector<int>& found) {
    std::vector<int> out;
    const std::string& table = room_type(editor.document().type).table;
    for (const int i : found)
        if (const Placed& p = placed_at(editor, i); !table.empty() && (p.piece.kind == table || p.wish.kind == table))
            out.push_back(i);
    if (out.size() == 1) return out;
    // The largest by far, of what stands on the floor.
    constexpr float kByFar = 1.6f;  // times the floor of the next one
    const auto floor_of = [&](int i) {
        const Vec3f size = placed_at(editor, i).piece.size_m;
        return size.x * size.z;
    };
    const auto is_largest = [&](int i) {
        return std::all_of(found.begin(), found.end(), [&](int k) {
            return k == i ||
                   (floor_of(i) > kByFar * floor_of(k) && thing_at(editor, i).kind != thing_at(editor, k).kind);
        });
    };
    const bool all_stand = std::all_of(found.begin(), found.end(), [&](int i) {
        const Placed& p = placed_at(editor, i);
        return p.on < 0 && p.sill < 0 && p.piece.mount == Mount::floor && !p.flat;
    });
    const auto largest = std::find_if(found.begin(), found.end(), is_largest);
    return all_stand && largest != found.end() ? std::vector<int>{*largest} : std::vector<int>{};
}

}  // namespace fastscene::editing
