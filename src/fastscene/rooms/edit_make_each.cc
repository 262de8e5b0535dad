// "the chairs alternately black and white", "each wall a different color", "every desk a plant": one after the other.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {

// "the chairs alternately black and white"; false: no such words.
bool make_by_turns(Talk& talk, const Words& words) {
    const std::size_t at = find_word(words, {"alternate", "alternately", "alternating"}, 1);
    if (at + 1 >= words.size()) return false;
    Words rest = part_of(words, at + 1);
    std::vector<Value> values;
    std::erase_if(rest, [](const std::string& w) { return is_one_of(w, {"between", "in"}); });
    for (const Words& part : parts_of(rest))
        if (const auto value = value_of(part)) values.push_back(*value);
    if (values.size() < 2)
        throw UsageError("expected two looks, for example \"alternately black and white\", found \"{}\"",
                         text_of(rest));
    const std::vector<std::string> ids = talk.things_of_parts(part_of(words, 0, at));
    for (std::size_t k = 0; k < ids.size(); ++k) {
        EditStep step;
        step.kind = EditStep::Kind::recolor;
        step.ids = {ids[k]};
        step.wish = values[k % values.size()].looks;
        talk.editor.apply(step);
    }
    return true;
}

// "each wall a different color", "the chairs in various colors": one after the other; false: no such words.
bool make_various(Talk& talk, const Words& words) {
    // Muted ones that go together.
    static constexpr std::array<const char*, 6> kColors{"sage green", "dusty blue", "terracotta",
                                                        "mustard",    "dusty pink", "cream"};
    const std::size_t at = find_word(words, {"different", "another", "various", "own", "other", "mixed"}, 1);
    if (at + 2 != words.size() || !is_one_of(words.back(), {"color", "colors", "shade", "shades"})) return false;
    Words subject = part_of(words, 0, at);
    // "In two different colors": by turns.
    std::size_t count = kColors.size();
    if (const auto number = number_said(subject.back()); number && *number >= 2 && subject.size() > 2)
        count = std::min(count, static_cast<std::size_t>(*number)), subject.pop_back();
    while (subject.size() > 1 && is_one_of(subject.back(), {"a", "an", "in", "its", "their", "to", "all"}))
        subject.pop_back();
    const bool each = is_one_of(subject.front(), {"each", "every", "all", "both"});
    const bool walls = noun_of(subject.back()) == "wall";
    // "The sofa another color": which one?
    if (!each && !subject.back().ends_with("s")) return false;
    EditStep step;
    step.kind = EditStep::Kind::recolor;
    const std::vector<std::string> ids = walls ? std::vector<std::string>(4) : talk.things(subject);
    for (std::size_t k = 0; k < ids.size(); ++k) {
        if (walls) step.surface = "accent_wall", step.wall = static_cast<int>(k);
        else step.ids = {ids[k]};
        step.wish.color = kColors[k % count];
        talk.editor.apply(step);
    }
    return true;
}

// "Every desk a plant": one at each; false: no such words.
bool given(Talk& talk, const Words& words) {
    for (std::size_t i = 2; i < words.size(); ++i) {
        if (!is_one_of(words[i], {"a", "an", "two", "three", "some"})) continue;
        Words all = part_of(words, i);
        const auto last = look_up(all.back());
        if (all.size() < 2 || !last || last->kind != WordKind::object || value_of(all) || shape_said({all[1]}) != "" ||
            !names_things(all) || all_named(talk.editor, text_of(words, 0, i)).empty() ||
            is_one_of(all.back(), {"color", "look", "shape"}))
            return false;
        all.push_back("at");
        all.insert(all.end(), words.begin(), words.begin() + static_cast<std::ptrdiff_t>(i));
        add(talk, all);
        return true;
    }
    return false;
}

bool resurfaced(Talk& talk, const Words& old, const Words& by) {
    if (old.empty() || by.empty()) return false;
    const std::string& last = old.back();
    std::string surface = noun_of(last);
    if (is_one_of(last, {"flooring", "floorboards", "parquet"})) surface = "floor";
    if (is_one_of(last, {"wallpaper", "wallpapers", "paneling"})) surface = "wall";
    if (is_one_of(last, {"tiles", "carpet"}) && !all_named(talk.editor, last).empty()) return false;
    if (last == "tiles" && old.size() > 1)
        surface = is_one_of(old[old.size() - 2], {"wall", "floor"}) ? old[old.size() - 2] : "";
    if (!is_one_of(surface, {"floor", "wall", "ceiling"})) return false;
    // Its own look says which one it is, and nothing of what comes: "the wooden floor".
    for (std::size_t i = 0; i + 1 < old.size(); ++i)
        if (!is_definite(old[i]) && !is_one_of(old[i], {"all", "whole", "entire", "current", "old", "wall", "floor"}) &&
            !looks_of(old[i]))
            return false;
    Words all{"the", surface == "wall" ? "walls" : surface};
    for (std::size_t i = is_one_of(by.front(), {"a", "an", "some", "new"}) ? 1 : 0; i < by.size(); ++i)
        all.push_back(by[i]);
    while (all.size() > 3 && is_one_of(all.back(), {"wallpaper", "floor", "flooring", "ceiling", "wall", "walls"}))
        all.pop_back();
    make(talk, all);
    return true;
}

// "The table into a round one with four chairs", "the sofa green with two cushions": those come to it; false: no such
// words.
bool made_with(Talk& talk, const Words& words) {
    const std::size_t with = find_word(words, {"with"}, 3);
    Words comes = part_of(words, with + 1);
    const std::size_t n = comes.size();
    const bool on_it = n > 2 && comes[n - 2] == "on" && is_one_of(comes[n - 1], {"top", "it", "them", "each"});
    const bool on_each = on_it && comes[n - 1] == "each";
    if (on_it) comes.resize(n - 2);
    if (comes.size() < 2 || parts_of(words).size() > 1 || !number_said(comes.front()) ||
        next_place(comes) < comes.size() || is_a_part(comes.back()))
        return false;
    auto noun = look_up(text_of(comes, 1));
    if (!noun) noun = look_up(comes.back());
    if (!noun || noun->kind != WordKind::object || noun->far) return false;
    const Words first = part_of(words, 0, with);
    const bool into = find_word(first, {"into"}, 1) < first.size();
    bool value = into;
    for (std::size_t i = 1; i < first.size(); ++i) value = value || value_of(part_of(first, i));
    if (!value) return false;
    do_each(
        talk.editor, 2,
        [&](std::size_t k) {
            if (k == 0) make(talk, first);
            else if (on_each) add(talk, joined_words(comes, {"on", "each", "of", "them"}));
            else add(talk, joined_words(comes, {on_it ? "on" : "to", "it"}));
        },
        [&](std::size_t k) { return text_of(k == 0 ? first : comes); });
    return true;
}

// "The walls black and red curtains": what is there already is made so, what is not comes; false: no such words.
bool made_and_wanted(Talk& talk, const Words& words) {
    const std::vector<Words> parts = parts_of(words);
    if (parts.size() < 2) return false;
    const Words& last = parts.back();
    const Words look = part_of(last, 0, last.size() - 1);
    const Words first = part_of(words, 0, words.size() - last.size() - 1);
    if (look.empty() || is_definite(last.front()) || number_said(last.front()) || value_of(last) || !value_of(look) ||
        first.empty())
        return false;
    bool says = false;
    for (std::size_t i = 1; i < first.size(); ++i) says = says || value_of(part_of(first, i));
    const auto noun = look_up(last.back());
    if (!says || !noun || noun->kind != WordKind::object) return false;
    const bool there = !all_named(talk.editor, "all " + last.back()).empty();
    do_each(
        talk.editor, 2,
        [&](std::size_t k) {
            if (k == 0) make(talk, first);
            else if (there) make(talk, joined_words({"the", last.back()}, look));
            else add(talk, last);
        },
        [&](std::size_t k) { return text_of(k == 0 ? first : last); });
    return true;
}

}  // namespace fastscene::editing
