// "The sofa with two armchairs", "the bench and the pouf": what comes for what was there, and what changes places.
#include <algorithm>
#include <array>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene::editing {

void copy(Talk& talk, const Words& words) {
    for (const std::string& id : talk.things_of_parts(words)) {
        const Placed p = talk.editor.placed(id);
        EditStep step;
        step.kind = EditStep::Kind::add;
        step.wish = p.wish;
        step.wish.kind = asked_kind(p), step.wish.words = in_words(step.wish.kind);
        step.wish.count = 1;
        step.wish.relation = step.wish.relation_to = step.wish.relation_and = "";
        for (const DocumentThing& t : talk.editor.document().things)
            if (t.id == id) step.wish.color = t.color, step.wish.material = t.material, step.wish.pattern = t.pattern;
        step.wish.size_m = p.piece.size_m;
        talk.editor.apply(step);
    }
}

namespace {

// "Replace the coffee table with the ottoman": the ottoman that is there takes its place; false: no such words.
bool replaced_by_its_like(Talk& talk, const Words& old, const Words& by) {
    if (by.size() < 2 || !is_definite(by.front()) || is_one_of(by.back(), {"one", "ones"}) ||
        next_place(by) < by.size() || all_named(talk.editor, text_of(by)).empty())
        return false;
    const std::vector<std::string> gone = talk.things_of_parts(old), come = talk.things_of_parts(by);
    if (gone.size() != 1 || come.size() != 1 || gone == come) return false;
    talk.editor.together([&] {
        EditStep step;
        step.kind = EditStep::Kind::place;
        step.ids = come, step.position = flat(talk.editor.placed(gone.front()).position);
        step.yaw = talk.editor.placed(gone.front()).yaw;
        EditStep take;
        take.ids = gone;
        talk.editor.apply(take);
        talk.editor.apply(step);
    });
    talk.last = come;
    return true;
}

}  // namespace

namespace {

// A plain lamp in place of what hangs from the ceiling hangs there as well.
void as_it_hangs(const Editor& editor, EditStep& step) {
    const auto hangs = [&](const std::string& id) { return editor.placed(id).piece.mount == Mount::ceiling; };
    if (!has_role(step.wish.kind, Role::light) || !std::all_of(step.ids.begin(), step.ids.end(), hangs) ||
        mount_of(editor, step.wish.kind) == Mount::ceiling)
        return;
    const std::string noun = singular(step.wish.words.substr(step.wish.words.rfind(' ') + 1));
    const auto form = look_up("hanging " + noun);
    if (step.wish.words.find(noun) == 0 && noun != in_words(step.wish.kind) && form &&
        mount_of(editor, form->meaning) == Mount::ceiling)
        step.wish.kind = form->meaning;
}

Words without_article(Words words) {
    if (words.size() > 1 && is_definite(words.front())) words.erase(words.begin());
    return words;
}

}  // namespace

void replace(Talk& talk, const Words& old, const Words& by) {
    if (resurfaced(talk, old, by) || replaced_by_its_like(talk, old, by)) return;
    EditStep step;
    step.kind = EditStep::Kind::replace;
    step.ids = talk.things_of_parts(old);
    std::vector<Words> parts = parts_of(by);
    // "a loveseat facing the sofa"
    if (const std::size_t facing = find_word(by, {"facing"}, 2); facing + 1 < by.size()) {
        replace(talk, old, part_of(by, 0, facing));
        Words all{"them"};
        all.insert(all.end(), by.begin() + static_cast<std::ptrdiff_t>(facing), by.end());
        return face(talk, all);
    }
    // "with a bigger one", "with a blue one", "with a round one", "with something round"
    if (by.size() > 1 && by.front() == "something") {
        Words one{"a"};
        one.insert(one.end(), by.begin() + 1, by.end());
        one.push_back("one");
        return replace(talk, old, one);
    }
    // "a leather one in brown"
    if (const std::size_t one = find_word(by, {"one", "ones"}, 1); one + 2 < by.size() && by[one + 1] == "in") {
        Words all = part_of(by, 0, one);
        all.insert(all.end(), by.begin() + static_cast<std::ptrdiff_t>(one) + 2, by.end());
        all.push_back(by[one]);
        return replace(talk, old, all);
    }
    // "a long rectangular one and six chairs": six in all
    if (parts.size() > 1 && is_one_of(parts.front().back(), {"one", "ones"})) {
        replace(talk, old, parts.front());
        talk.said = "we want";
        return do_each(talk.editor, parts.size() - 1, [&](std::size_t k) { add(talk, parts[k + 1]); });
    }
    if (!by.empty() && is_one_of(by.back(), {"one", "ones"})) {
        Words all{"it"}, sizes;
        for (const std::string& w : by)
            if (!is_one_of(w, {"a", "an", "one", "ones"})) {
                const std::string more = comparative_of(w);
                (more.empty() ? all : sizes).push_back(more.empty() ? w : more);
            }
        if (all.size() > 1 && !value_of(part_of(all, 1))) sizes.clear();
        if (value_of(part_of(all, 1)) || (all.size() == 1 && !sizes.empty())) {
            if (all.size() > 1) make(talk, all);
            for (const std::string& size : sizes) make(talk, {"it", size});
            return;
        }
        parts = {by};
        parts[0].back() = in_words(asked_kind(talk.editor.placed(step.ids.front())));
    }
    if (parts.empty()) throw UsageError("expected what comes in place of \"{}\"", text_of(old));
    // "A desk with a chair": that comes to it.
    if (const std::size_t with = find_word(parts.front(), {"with"}, 2); with + 2 < parts.front().size() &&
                                                                        begins_anew(part_of(parts.front(), with + 1)) &&
                                                                        !is_a_part(parts.front().back())) {
        const Words extra = part_of(parts.front(), with + 1);
        const auto noun = look_up(extra.back());
        if (noun && noun->kind == WordKind::object) {
            parts.front().resize(with);
            parts.insert(parts.begin() + 1, extra);
        }
    }
    // "The vending machine with a coffee machine on a small table": first the table.
    if (const Words& first = parts.front(); next_place(first) + 2 < first.size() && begins_anew(first)) {
        const std::size_t place = next_place(first);
        const Words there = part_of(first, place + 1);
        if (first[place] == "on" && is_one_of(there.front(), {"a", "an"}) && !value_of(there)) {
            replace(talk, old, there);
            return add(talk, joined_words(part_of(first, 0, place), {"on", "it"}));
        }
        // "… with a wide one opposite the bed": not where that stood.
        const auto relation = relation_at(first, place);
        if (relation && is_one_of(relation->name, {"opposite", "next to", "in the corner", "in front of", "behind"}))
            return talk.editor.together([&] {
                remove(talk, old);
                add(talk, by);
            });
    }
    step.wish = wishes_of(talk.editor, parts.front()).front();
    as_it_hangs(talk.editor, step);
    const bool each = is_one_of(old.front(), {"every", "each"});  // "every chair with a stool"
    const bool one = is_one_of(parts.front().front(), {"a", "an", "another", "one"}) && !each;
    if ((!step.wish.counted || each) && !one) step.wish.count = static_cast<int>(step.ids.size());
    // "The books" of several tops by one plant: on which of them?
    std::set<std::string> tops;
    std::vector<int> those;
    for (const std::string& id : step.ids)
        those.push_back(talk.editor.index_of(id)),
            tops.insert(talk.editor.document().things[static_cast<std::size_t>(those.back())].on);
    if (step.wish.counted && step.wish.count < static_cast<int>(tops.size()) && !tops.contains(""))
        refuse_many(text_of(without_article(old)), talk.editor, those);
    const std::size_t told = talk.editor.result().changes.size();
    talk.editor.apply(step);
    talk.last = {};
    const auto& changes = talk.editor.result().changes;
    for (std::size_t i = told; i < changes.size(); ++i)
        if (const EditChange& change = changes[i]; change.what.starts_with("added in place of"))
            talk.last.push_back(change.id);
    shape_as_asked(talk, talk.last, shape_asked(parts.front()));
    tell_unshown(talk, talk.last, step.wish, counted_anew(parts.front()));
    const std::vector<std::string> fresh = talk.last;
    for (std::size_t k = 1; k < parts.size(); ++k) {
        talk.last = fresh;
        if (next_place(parts[k]) < parts[k].size()) {  // "two armchairs and a table between them"
            add(talk, parts[k]);
            continue;
        }
        PromptObject wish = wishes_of(talk.editor, parts[k]).front();
        // "A small table and two chairs": the chairs come to the table.
        wish.relation = fresh.empty() ? "next to" : suited("to", wish.kind, talk.editor.placed(fresh.front()));
        wish.relation_to = step.wish.kind;
        add_wish(talk, wish, {});
    }
}

bool swap_colors(Talk& talk, const Words& words) {
    const std::size_t colors = find_word(words, {"colors", "color", "colours"});
    if (colors + 2 >= words.size() || words[colors + 1] != "of") return false;
    const std::vector<std::string> ids = talk.things_of_parts(part_of(words, colors + 2));
    if (ids.size() != 2) throw UsageError("expected two things to exchange their colors, found {}", ids.size());
    std::array<std::string, 2> seen{talk.editor.color_seen(ids[1]), talk.editor.color_seen(ids[0])};
    for (const std::size_t k : {0u, 1u}) {
        EditStep step;
        step.kind = EditStep::Kind::recolor;
        step.ids = {ids[k]}, step.wish.color = seen[k];
        talk.editor.apply(step);
    }
    return true;
}

void swap(Talk& talk, Words words) {
    if (swap_colors(talk, words)) return;
    for (const char* name : {"positions", "position", "places", "place"})
        if (const std::size_t at = find_word(words, {name}); at + 1 < words.size() && words[at + 1] == "of")
            words = part_of(words, at + 2);
    // "the two armchairs' places"
    while (words.size() > 1 && is_one_of(words.back(), {"places", "positions", "place", "position", "around", "over"}))
        words.pop_back();
    for (std::string& w : words)
        if (const std::size_t mark = w.find('\''); mark != std::string::npos && mark > 1) w.resize(mark);
    // "The sofa by the window with the armchair" is no "by".
    std::size_t with = find_word(words, {"with", "for", "and"});
    if (with == words.size()) with = find_word(words, {"by"});
    if (const auto two = with == words.size() ? talk.things(words) : std::vector<std::string>{}; two.size() == 2) {
        EditStep step;
        step.kind = EditStep::Kind::swap;
        step.ids = two;
        return talk.editor.apply(step);
    }
    if (with + 1 >= words.size())
        throw UsageError("expected \"swap … and …\" or \"swap … for …\", found \"{}\"", text_of(words));
    const Words one = part_of(words, 0, with), other = part_of(words, with + 1);
    const bool anew = words[with] == "for" || words[with] == "by" ||
                      (words[with] == "with" && is_one_of(other.front(), {"a", "an", "some", "another"}));
    if (anew || (words[with] == "with" && all_named(talk.editor, text_of(other)).empty()))
        return replace(talk, one, other);
    EditStep step;
    step.kind = EditStep::Kind::swap;
    const auto a = talk.things(one), b = talk.things(other);
    if (a.size() != b.size())
        throw UsageError("expected as many things to swap as to swap them with, found {} and {}", a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        step.ids = {a[k], b[k]};
        talk.editor.apply(step);
    }
}

}  // namespace fastscene::editing
