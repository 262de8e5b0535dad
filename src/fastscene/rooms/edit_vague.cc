// Wishes for the room as a whole that name no thing: "make it cozier", "less cluttered". What they are taken as is
// told.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene::editing {
namespace {

// "cozy" of "cozier", "warm" of "warmer"; the word itself, where it is no comparative.
std::string positive_of(const std::string& word) {
    if (word.ends_with("ier")) return word.substr(0, word.size() - 3) + "y";
    return word.ends_with("er") ? word.substr(0, word.size() - 2) : word;
}

bool says_cozy(const std::string& word) {
    const auto is = [](const std::string& w) {
        const auto known = look_up(w);
        return known && known->kind == WordKind::mood && known->meaning == "cozy";
    };
    return is(word) || is(positive_of(word));
}

bool says_cluttered(const std::string& word) {
    return is_one_of(word, {"cluttered", "crowded", "messy", "busy", "full", "clutter", "mess", "stuff"});
}

// Words that say nothing beside the wish: "it", "the room feel a bit more".
bool is_of_room(const Editor& editor, const std::string& word) {
    const auto known = look_up(word);
    return is_definite(word) || noun_of(word) == "room" || word == editor.document().type ||
           (known && known->kind == WordKind::room) ||
           is_one_of(word,
                     {"everything", "place", "space", "here",  "in",    "whole",  "feel",   "look",       "be",
                      "more",       "less",  "much",  "a",     "bit",   "little", "lot",    "slightly",   "and",
                      "so",         "too",   "not",   "feels", "looks", "is",     "should", "atmosphere", "mood"});
}

// What one lies down or leans back on: a bed, else a sofa, else an easy chair; null: there is none.
const Placed* softest(const Editor& editor) {
    const Placed* best = nullptr;
    const auto rank = [](const Placed& p) {
        return has_role(p.piece.kind, Role::bed)          ? 3
               : has_role(p.piece.kind, Role::sofa)       ? 2
               : has_role(p.piece.kind, Role::rug_before) ? 1
                                                          : 0;
    };
    for (const Placed& p : editor.room().furnished.placed)
        if (rank(p) > (best ? rank(*best) : 0)) best = &p;
    return best;
}

// Evening light and lamps, and of the soft and warm things those that the room has none of, where such things are.
void make_cozy(Talk& talk) {
    const std::size_t before = talk.editor.deeds();
    const auto attempt = [&](const EditStep& step) {
        try {
            talk.editor.apply(step);
        } catch (const Error&) {  // it is so, or there is no place for it
        }
    };
    EditStep light;
    light.kind = EditStep::Kind::light;
    const std::string hour = talk.editor.document().light.hour;
    if (!is_one_of(hour, {"evening", "dusk", "night"})) light.value = "evening", attempt(light);
    light.value = "lamps on";
    if (talk.editor.document().light.lamps.value_or(0) < 1) attempt(light);
    for (const std::string& kind : kinds_with(Role::cozy)) {
        const auto& all = talk.editor.room().furnished.placed;
        if (std::any_of(all.begin(), all.end(), [&](const Placed& p) { return asked_kind(p) == kind; })) continue;
        EditStep step;
        step.kind = EditStep::Kind::add;
        step.wish.kind = kind, step.wish.words = in_words(kind);
        if (has_role(kind, Role::lies_on_seats)) {
            const Placed* on = softest(talk.editor);
            if (!on) continue;
            step.wish.relation = "on", step.wish.relation_to = asked_kind(*on), step.at = {on->id};
        }
        attempt(step);
    }
    if (talk.editor.deeds() == before)
        throw Error("it is evening, the lamps are on, and the room has soft things: name what else is to come");
    talk.editor.note("room", "cozier: evening light, lamps, and soft things that it had none of");
}

bool is_decoration(const Placed& p) {
    const bool screen = std::any_of(p.piece.materials.begin(), p.piece.materials.end(),
                                    [](const Material& m) { return m.pattern == Pattern::screen; });
    return furnishing::is_small(p.piece.kind) && !screen && !can_shine(p) &&
           !has_role(p.piece.kind, Role::before_seats) && !has_role(p.piece.kind, Role::lies_on_seats);
}

}  // namespace

bool lies_about(const Editor& editor, const std::string& id) {
    const Placed& p = editor.placed(id);
    const bool lies = p.piece.mount == Mount::floor && !p.flat && !is_rug(p.piece) && p.on < 0 && p.sill < 0;
    return lies && (has_role(p.piece.kind, Role::litter) || is_decoration(p));
}

namespace {

// What lies about, and on each top all decoration but the largest; lamps, screens and what is laid stay.
void thin_out(Talk& talk, const std::vector<std::string>& tops) {
    const std::vector<Placed>& all = talk.editor.room().furnished.placed;
    std::vector<std::string> gone;
    std::map<std::pair<int, int>, std::vector<const Placed*>> on;  // by what carries them, or the sill
    for (const Placed& p : all) {
        const bool carries = std::any_of(all.begin(), all.end(), [&](const Placed& q) {
            return q.on >= 0 && all[static_cast<std::size_t>(q.on)].id == p.id;
        });
        if (!tops.empty() && (p.on < 0 || !is_among(all[static_cast<std::size_t>(p.on)].id, tops))) continue;
        if (lies_about(talk.editor, p.id)) gone.push_back(p.id);
        else if (is_decoration(p) && !carries && (p.on >= 0 || p.sill >= 0)) on[{p.on, p.sill}].push_back(&p);
    }
    for (auto& [top, some] : on) {
        const auto bulk = [](const Placed* p) { return p->piece.size_m.x * p->piece.size_m.y * p->piece.size_m.z; };
        std::stable_sort(some.begin(), some.end(), [&](const Placed* a, const Placed* b) { return bulk(a) > bulk(b); });
        for (std::size_t k = 1; k < some.size(); ++k) gone.push_back(some[k]->id);
    }
    if (gone.empty())
        throw Error("nothing lies about, and no top carries more than one small thing: name what is to go");
    remove_all(talk, gone);
    talk.editor.note("room", "less cluttered: what lies about goes, and on each top all small things but the largest");
}

}  // namespace

bool made_vaguely(Talk& talk, const Words& words) {
    Words subject, wish;
    bool cozy = false, clutter = false, less = false;
    for (const std::string& w : words) {
        if (says_cozy(w)) cozy = true;
        else if (says_cluttered(w)) clutter = true;
        else if (is_one_of(w, {"tidier", "neater", "cleaner", "decluttered", "uncluttered"})) clutter = less = true;
        else if (!is_of_room(talk.editor, w)) subject.push_back(w);
        if (is_one_of(w, {"less", "not", "too"})) less = true;
    }
    cozy = cozy && !less && subject.empty(), clutter = clutter && less;
    if (!cozy && (!clutter || (!subject.empty() && all_named(talk.editor, text_of(subject)).empty()))) return false;
    talk.vague = true;
    if (cozy) make_cozy(talk);
    else thin_out(talk, subject.empty() ? subject : talk.things_of_parts(joined_words({"the"}, subject)));
    return true;
}

}  // namespace fastscene::editing
