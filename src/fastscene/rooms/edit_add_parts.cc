// The parts of "a floor lamp beside the bed and two plants in the corner", one after the other: each at its own place,
// at that of the next one, or at what came before it.
#include <algorithm>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// What comes with what was added: "two nightstands with a lamp on each" are two lamps.
void add_with(Talk& talk, const std::vector<std::string>& ids, const Addition& addition) {
    const std::vector<PromptObject>& wishes = addition.wishes;
    const auto at = [&](const std::string& id, const std::string& relation) {
        Place out;
        out.step.wish.relation = relation, out.step.wish.relation_to = asked_kind(talk.editor.placed(id));
        out.step.at = {id};
        return out;
    };
    const std::size_t first = std::min<std::size_t>(1, wishes.size());
    do_each(
        talk.editor, wishes.size() - first,
        [&](std::size_t k) {
            const PromptObject& wish = wishes[k + first];
            // "With a chair and a lamp on it": the chair stands before it.
            const std::string relation = addition.on_it && furnishing::is_small(wish.kind) ? "on" : wish.relation;
            if (ids.empty() ||
                (ids.size() > 1 && !addition.each && !addition.on_it && (relation != "on" || wish.count > 1)))
                return add_or_stand(talk, wish, {});
            do_each(talk.editor, ids.size(), [&](std::size_t i) { add_or_stand(talk, wish, at(ids[i], relation)); });
        },
        [&](std::size_t k) { return wishes[k + first].words; });
}

// "It" is what was last put somewhere, or that at which it was put: where the first has no place for it, the other.
std::optional<Addition> at_the_other(const Talk& talk, const Words& words, const std::vector<std::string>& spoken) {
    if (!is_one_of(words.back(), {"it", "them"}) || talk.last_place.wish.relation_to.empty()) return {};
    const std::vector<std::string> others = things_at(talk.editor, talk.last_place);
    if (others.empty() || others == spoken) return {};
    // What is to lie on a shelf lies there or nowhere; a mirror carries nothing.
    constexpr float kCarries = 0.08f;  // metres deep
    const bool carrier = std::any_of(spoken.begin(), spoken.end(), [&](const std::string& id) {
        const Placed& p = talk.editor.placed(id);
        const bool holds = carries(p) || (p.piece.mount == Mount::wall && p.piece.size_m.z > kCarries);
        return holds && !p.flat && !has_role(p.piece.kind, Role::seat);
    });
    if (carrier && words.size() > 1 && words[words.size() - 2] == "on") return {};
    Addition out = addition_of(talk, words, others);
    return out.place ? std::optional(out) : std::nullopt;
}

// A lamp at each end of "it" stands by the sideboard, not by the mirror above that.
Addition at_what_is_meant(Talk& talk, const Words& words) {
    // "Three stools before the counter, and a lamp over it": over the counter, the stools are "them".
    if (words.back() == "it" && talk.last.size() > 1)
        if (const auto other = things_at(talk.editor, talk.last_place); other.size() == 1) talk.last = other;
    // "Turn the armchair to the bed and put a table between them": between those two.
    if (const std::size_t n = words.size();
        n > 2 && words[n - 2] == "between" && words[n - 1] == "them" && talk.last.size() == 1)
        for (auto other = talk.mentioned.rbegin(); other != talk.mentioned.rend() && talk.last.size() < 2; ++other)
            if (!is_among(*other, talk.last)) talk.last.push_back(*other);
    // "Paint that wall black and put a picture on it"
    if (const std::size_t n = words.size();
        n > 2 && words.back() == "it" && words[n - 2] == "on" && talk.last.empty() && talk.wall >= 0) {
        Addition out = addition_of(talk, joined_words(part_of(words, 0, n - 1), {"the", "wall"}), {});
        if (out.place) out.place->step.wall = talk.wall;
        return out;
    }
    const bool it = is_one_of(words.back(), {"it", "them"}) && !talk.last.empty();
    const auto hangs = [](Mount mount) { return mount == Mount::wall || mount == Mount::ceiling; };
    const bool hung = it && std::all_of(talk.last.begin(), talk.last.end(), [&](const std::string& id) {
                          return hangs(talk.editor.placed(id).piece.mount);
                      });
    Addition out = addition_of(talk, words, talk.last);
    // On a shelf is on it.
    const bool on_it = out.place && out.place->step.wish.relation == "on" &&
                       std::any_of(talk.last.begin(), talk.last.end(), [&](const std::string& id) {
                           return !talk.editor.placed(id).piece.surfaces.empty();
                       });
    // "On it" of a rug or a stool means the table or island there, for what does not stand on floors or seats.
    const bool rug = it && std::all_of(talk.last.begin(), talk.last.end(), [&](const std::string& id) {
                         const Placed& p = talk.editor.placed(id);
                         constexpr float kStool =
                             0.55f;  // metres: what is lower and has no back carries things as well
                         const bool stool = talk.last.size() == 1 && p.piece.size_m.y < kStool;
                         return p.flat || (has_role(p.piece.kind, Role::seat) && !stool);
                     });
    if (rug && out.place && out.place->step.wish.relation == "on" && furnishing::is_small(out.wishes.front().kind) &&
        !furnishing::lies_on_seats(out.wishes.front().kind))
        if (auto other = at_the_other(talk, words, talk.last)) return *other;
    if (hung && !on_it && out.place && !hangs(mount_of(talk.editor, out.wishes.front().kind)))
        if (auto other = at_the_other(talk, words, talk.last)) return *other;
    return out;
}

// "… and a candle on the stool", where a stool comes in a part before it.
bool is_at_one_before(const std::vector<Words>& parts, std::size_t k) {
    const std::size_t place = next_place(parts[k]);
    if (place >= parts[k].size()) return false;
    const std::string& noun = parts[k].back();
    return std::any_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(k), [&](const Words& part) {
        return find_word(part_of(part, 0, next_place(part)), {noun}) < part.size() &&
               find_word(part, {noun}) < next_place(part);
    });
}

bool says_how(const Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i)
        if (value_of(part_of(words, i))) return true;
    return false;
}

// "And a plant on the other", where it is not known yet which one that is.
bool names_other(const Words& words) {
    const std::size_t other = find_word(words, {"other"}, 1);
    if (other >= words.size() || words[other - 1] != "the") return false;
    std::size_t end = other + 1;
    while (end < words.size() && words[end] != "with" && next_place(words, end) != end) ++end;
    return noun_of(words[end - 1]).empty();
}

}  // namespace

bool stands_already(const Talk& talk, const Words& words) {
    const std::size_t place = next_place(words);
    return is_definite(words.front()) && !is_one_of(words.front(), {"it", "them"}) && place > 1 &&
           place < words.size() && !all_named(talk.editor, text_of(words, 0, place)).empty();
}

namespace {

// Those that share a corner stand in one.
void add_in_one_corner(Talk& talk, const PromptObject& wish, const std::optional<Place>& place,
                       const std::vector<std::string>& together) {
    if (!place || place->step.wish.relation != "in the corner" || together.empty())
        return add_or_stand(talk, wish, place);
    constexpr float kOneCorner = 1.7f;  // metres
    const std::vector<std::string> before = talk.last;
    try {
        talk.editor.together([&] {
            add_or_stand(talk, wish, place);
            const Vec3f d = talk.editor.placed(talk.last.back()).position -
                            talk.editor.placed(together.front()).position;
            if (length(flat(d)) > kOneCorner) throw Error("{}: it is in another corner", talk.last.back());
        });
    } catch (const UsageError&) {
        throw;
    } catch (const Error&) {
        talk.last = before;
        throw;
    }
}

}  // namespace

void add_parts(Talk& talk, const std::vector<Words>& parts, const Words& words) {
    std::vector<std::optional<Addition>> all(parts.size());
    std::vector<bool> failed(parts.size());  // nobody knows what that is
    std::vector<bool> later(parts.size());   // at what comes before it in these words
    const std::vector<std::string> spoken_before = std::exchange(talk.last, {});
    std::vector<std::string> together;  // those that share the place of the next one
    // "A rug, a chair in the corner and a lamp": the corner is the chair's alone; "a chair and a lamp in the corner".
    const std::string text = text_of(words);
    const auto shares = [&](std::size_t k, std::size_t next) {
        return k == next || next + 1 == parts.size() ||
               text.find(text_of(parts[next - 1]) + " and " + text_of(parts[next])) != std::string::npos;
    };
    const auto add_part = [&](std::size_t k) {
        // "A screen and a harp on the desk": the screen comes there, whatever becomes of the harp.
        if (!all[k]->place && k + 1 < parts.size() && failed[k + 1] && shares(k, k + 1))
            if (const std::size_t place = next_place(parts[k + 1]); place < parts[k + 1].size()) {
                const std::vector<std::string> last = std::exchange(talk.last, spoken_before);
                all[k] = at_what_is_meant(talk, joined_words(parts[k], part_of(parts[k + 1], place)));
                talk.last = last;
            }
        const auto own = all[k]->place;
        std::optional<Place> shared;
        for (std::size_t next = k; next < all.size() && !shared; ++next)
            if (all[next] && all[next]->place) {
                if (!shares(k, next)) break;
                shared = all[next]->place;
            }
        const PromptObject& first = all[k]->wishes.front();
        const std::size_t spoken = talk.last.size();
        // Of "two stools and a lamp over the island" the stools stand at it.
        if (shared && !own && shared->step.wish.relation == "above" &&
            mount_of(talk.editor, first.kind) == Mount::floor)
            shared->step.wish.relation = has_role(first.kind, Role::seat) ? "around" : "next to";
        // "An armchair, a lamp and a shelf by the window": at one window, side by side.
        const bool group = shared && !together.empty() && !noun_of(shared->step.wish.relation_to).empty() &&
                           shared->step.wish.relation == "next to";
        talk.editor.together([&] {
            if (group && grouped(talk, first, *shared, together)) return;
            try {
                constexpr float kFlat = 0.05f;  // metres: mats in a row
                const bool flat_row = all[k]->in_row && first.count > 1 && talk.editor.usual_size(first).y < kFlat &&
                                      mount_of(talk.editor, first.kind) == Mount::floor;
                if (all[k]->in_row && !shared && first.count > 1 && !flat_row) add_row(talk, first);
                else add_in_one_corner(talk, first, shared, together);
                if (flat_row) {
                    EditStep row;
                    row.kind = EditStep::Kind::rows;
                    row.ids = part_of(talk.last, spoken), row.wish.count = 1;
                    row.yaw = talk.editor.placed(row.ids.front()).yaw;
                    talk.editor.apply(row);
                }
            } catch (const UsageError&) {
                throw;
            } catch (const Error&) {
                // Two that do not fit into one corner: one by the other.
                const bool beside = shared && shared->step.wish.relation == "in the corner" && !together.empty();
                const auto other = beside ? std::nullopt : at_the_other(talk, all[k]->said, spoken_before);
                if (!beside && !other) throw;
                add_or_stand(talk, first, beside ? beside_those(talk, together) : *other->place);
            }
            shape_as_asked(talk, part_of(talk.last, spoken), all[k]->shape);
        });
        if (own) together.clear();
        else if (together.empty()) together = part_of(talk.last, spoken);
        const std::vector<std::string> fresh = part_of(talk.last, spoken);
        if (shared) talk.last_place = shared->step, talk.mention_place(shared->step, fresh);
        tell_unshown(talk, fresh, first, all[k]->said);
        add_with(talk, fresh, *all[k]);
    };
    // Parse all of them before adding the first.
    do_each(
        talk.editor, 2 * parts.size(),
        [&](std::size_t i) {
            const std::size_t k = i % parts.size();
            // "Two more chairs, and the walls in green"
            if (parts.size() > 1 && is_definite(parts[k].front()) && says_how(parts[k])) {
                if (i >= parts.size()) make(talk, parts[k]);
            } else if (parts.size() > 1 && stands_already(talk, parts[k])) {
                if (i >= parts.size()) move(talk, parts[k]);
            } else if (i < parts.size()) {
                const std::vector<std::string> none = std::exchange(talk.last, spoken_before);
                const Words part = talk.with_others(by_kind_there(talk.editor, parts[k]));
                // "On one nightstand, and a plant on the other": where the first came is not known yet.
                if (k > 0 && names_other(part)) {
                    later[k] = true, talk.last = none;
                    return;
                }
                try {
                    all[k] = at_what_is_meant(talk, with_noun(talk, part));
                } catch (const Error&) {
                    talk.last = none;
                    later[k] = is_at_one_before(parts, k);
                    failed[k] = !later[k];
                    if (!later[k]) throw;
                }
                talk.last = none;
                if (all[k]) all[k]->said = counted_anew(part);
                if (all[k] && all[k]->place)
                    if (const EditStep& at = all[k]->place->step; things_at(talk.editor, at).size() == 1)
                        talk.mention_place(at);
            } else {
                if (const auto each = talk.each_of_the_others(parts[k]); later[k] && each.size() > 1)
                    return do_each(
                        talk.editor, each.size(), [&](std::size_t n) { add(talk, each[n]); },
                        [&](std::size_t n) { return text_of(each[n]); });
                // "A stool next to it and a candle on the stool"
                if (later[k]) {
                    const Words part = talk.with_others(by_kind_there(talk.editor, parts[k]));
                    all[k] = at_what_is_meant(talk, with_noun(talk, part));
                    all[k]->said = counted_anew(part);
                }
                if (all[k]) add_part(k);
            }
        },
        [&](std::size_t i) { return parts.size() > 1 ? text_of(parts[i % parts.size()]) : ""; });
}

}  // namespace fastscene::editing
