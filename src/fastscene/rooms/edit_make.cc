// "the sofa green", "it night", "the walls sage", "the rug larger": how things, surfaces and the room are to be.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// "wall", "floor", "ceiling", "trim"; empty: the words are no surface of the room.
std::string surface_said(const Words& words) {
    Words bare = words;
    std::erase_if(bare, [](const std::string& w) {
        return is_definite(w) || is_one_of(w, {"all", "whole", "entire", "room", "of", "a", "only", "just"});
    });
    if (is_one_wall(words)) return "accent_wall";
    const std::string text = text_of(bare);
    if (is_one_of(text, {"tiles", "tile", "tiling"})) return "tiles";
    if (is_one_of(text, {"floor tiles", "tiled floor"})) return "floor";
    if (is_one_of(text, {"wall tiles", "tiled walls"})) return "wall";
    if (text.find("accent wall") != std::string::npos) return "accent_wall";
    if (is_one_of(text, {"trim", "trims", "baseboard", "baseboards", "skirting", "skirting board", "skirting boards",
                         "molding", "moldings"}))
        return "trim";
    const auto word = look_up(text);
    if (word && is_one_of(word->meaning, {"wall", "floor", "ceiling"})) return word->meaning;
    return {};
}

bool speaks_of_shell(const Words& subject) {
    Words bare = subject;
    std::erase_if(bare, [](const std::string& w) { return is_definite(w) || is_one_of(w, {"all", "a"}); });
    const std::string text = text_of(bare);
    const auto word = look_up(text);
    return text == "room" || (word &&
                              is_one_of(word->meaning, {"window", "door", "doorway", "ceiling", "wall", "floor",
                                                        "bay_window", "skylight"}) &&
                              word->kind == WordKind::structure);
}

constexpr float kDarkWood = 0.6f, kLightWood = 1.5f;  // of the usual wood's color

bool is_worktop(const std::string& word) {
    return is_one_of(word, {"worktop", "worktops", "countertop", "countertops"});
}

// Of a kitchen counter the top alone.
void of_the_top(PromptObject& looks) {
    looks.holder_color = std::exchange(looks.color, "");
    looks.holder_material = std::exchange(looks.material, "");
}

// What is hard and transparent is glass.
void suit_cloth(const Talk& talk, EditStep& step) {
    const bool soft = std::any_of(step.ids.begin(), step.ids.end(), [&](const std::string& id) {
        return has_role(talk.editor.placed(id).piece.kind, Role::soft);
    });
    if (step.wish.material == "voile" && !soft) step.wish.material = "glass";
}

// "Longer": taller, where that is its longer side. Curtains hang to the floor at most.
void along_its_length(const Talk& talk, EditStep& step) {
    constexpr float kAtFloor = 0.1f;  // metres
    const auto hangs = [](const Placed& p) {
        return p.piece.mount == Mount::wall && has_role(p.piece.kind, Role::soft);
    };
    const bool upright = !step.ids.empty() && std::all_of(step.ids.begin(), step.ids.end(), [&](const std::string& id) {
        const Placed& p = talk.editor.placed(id);
        return hangs(p) || p.piece.size_m.y > std::max(p.piece.size_m.x, p.piece.size_m.z);
    });
    if (!upright) return;
    std::swap(step.factor.x, step.factor.y);
    for (const std::string& id : step.ids)
        if (const Placed& p = talk.editor.placed(id); hangs(p) && p.position.y < kAtFloor && step.factor.y > 1)
            throw Error("{}: it reaches the floor already", id);
}

// Of dark wood the wood first, and then darker.
void apply_shaded(Talk& talk, EditStep step) {
    if (step.brighter != 1 && !step.wish.material.empty()) {
        EditStep first = step;
        first.brighter = 1;
        talk.editor.apply(first);
        step.wish = {};
    }
    talk.editor.apply(step);
}

void tell_stand_ins(Talk& talk, const EditStep& step, const Value& value) {
    for (const std::string& word : value.near)
        talk.editor.note(step.ids.empty() ? step.surface : step.ids.front(),
                         fmt::format("the nearest look there is to \"{}\"", word));
}

// The things that it is of; none: a surface.
std::vector<std::string> make_one(Talk& talk, const Words& subject, const Value& value) {
    EditStep step;
    step.kind = !value.shape.empty() ? EditStep::Kind::reshape
                : value.resizes()    ? EditStep::Kind::resize
                                     : EditStep::Kind::recolor;
    step.value = value.shape;
    step.factor = value.factor, step.exactly = value.exactly;
    step.wish = value.looks;
    step.brighter = value.brighter;
    if (value.resizes() && speaks_of_shell(subject)) refuse_shell();
    if (!value.resizes()) step.surface = surface_said(subject);
    // "The floor dark wood": boards, and dark ones.
    if (!step.surface.empty() && step.wish.color.ends_with(" wood") && step.wish.material.empty()) {
        if (step.wish.color.starts_with("dark")) step.brighter = kDarkWood;
        if (step.wish.color.starts_with("light")) step.brighter = kLightWood;
        step.wish.color.clear(), step.wish.material = "wood";
    }
    // "The rest of the walls": not those that this sentence painted.
    if (noun_of(subject.back()) == "wall" && has_word(subject, {"rest", "other", "others", "remaining"}) &&
        talk.wall >= 0)
        step.surface = "wall", step.elsewhere = true;
    if (step.surface == "tiles") step.surface = tiled_surface(talk.editor);
    else if (step.surface == "accent_wall" && !has_word(subject, {"accent"})) {
        Words which = subject;
        std::erase_if(which, [](const std::string& w) { return is_one_of(w, {"only", "just"}); });
        step.wall = talk.wall = wall_meant(talk.editor, which, talk.last);
    }
    if (step.surface.empty()) step.ids = talk.things(subject);
    if (value.length && value.by == Vec3f{}) along_its_length(talk, step);
    // A larger table is no higher.
    const bool tables = !step.ids.empty() && std::all_of(step.ids.begin(), step.ids.end(), [&](const std::string& id) {
        const std::string& kind = talk.editor.placed(id).piece.kind;
        return has_role(kind, Role::laid) || has_role(kind, Role::work_place);
    });
    // Nor is a larger rug thicker.
    const bool rugs = !step.ids.empty() && std::all_of(step.ids.begin(), step.ids.end(), [&](const std::string& id) {
        const Placed& p = talk.editor.placed(id);
        return p.flat || is_rug(p.piece);
    });
    if ((tables || rugs) && step.factor.x == step.factor.y && step.factor.y == step.factor.z) step.factor.y = 1;
    const bool lamps = !step.ids.empty() && std::all_of(step.ids.begin(), step.ids.end(), [&](const std::string& id) {
        return has_role(talk.editor.placed(id).piece.kind, Role::light);
    });
    if (lamps && value.shines)
        step.kind = EditStep::Kind::shine, step.value = value.brighter > 1 ? "brighter" : "darker";
    suit_cloth(talk, step);
    if (std::any_of(subject.begin(), subject.end(), is_worktop)) of_the_top(step.wish);
    if (value.by == Vec3f{}) {
        apply_shaded(talk, step);
        tell_stand_ins(talk, step, value);
        return step.ids;
    }
    for (const std::string& id : step.ids) {
        EditStep one = step;
        one.ids = {id};
        const Vec3f size = talk.editor.placed(id).piece.size_m;
        for (std::size_t a = 0; a < 3; ++a) one.factor[a] = std::max(0.2f, 1 + value.by[a] / size[a]);
        if (value.length) along_its_length(talk, one);
        talk.editor.apply(one);
    }
    return step.ids;
}

// "The bed frame oak and the bedding white": a thing has one color.
void check_one_look(Talk& talk, const std::vector<Group>& groups) {
    std::vector<std::string> seen;
    for (const Group& group : groups) {
        std::vector<std::string> ids;
        for (const Words& subject : group.subjects)
            for (const Words& words : group.values)
                if (const auto value = value_of(words); value && !value->resizes() && surface_said(subject).empty() &&
                                                        !has_word(subject, {"it", "them", "other"}))
                    for (const int i : all_named(talk.editor, text_of(subject)))
                        ids.push_back(talk.editor.document().things[static_cast<std::size_t>(i)].id);
        for (const std::string& id : ids)
            if (groups.size() > 1 && ids.size() == 1 && std::find(seen.begin(), seen.end(), id) != seen.end())
                throw UsageError("{}: its parts have one color, found two", id);
        add_new(seen, ids);
    }
}

void apply(Talk& talk, const Group& group) {
    std::vector<std::string> spoken;
    do_each(
        talk.editor, group.subjects.size(),
        [&](std::size_t k) {
            const Words& subject = group.subjects[k];
            if (!group.by.empty()) {
                replace(talk, subject, group.by);
                spoken = talk.last;
            }
            do_each(
                talk.editor, group.values.size(),
                [&](std::size_t v) { add_new(spoken, make_one(talk, subject, *value_of(group.values[v]))); },
                [&](std::size_t v) { return text_of(group.values[v]); });
        },
        [&](std::size_t k) { return text_of(group.subjects[k]); });
    talk.last = spoken;
}

void light(Talk& talk, const std::string& value) {
    EditStep step;
    step.kind = EditStep::Kind::light;
    step.value = value;
    talk.editor.apply(step);
}

// Of the whole room: its style, hour and weather. Says whether the clause was about that.
bool of_the_room(Talk& talk, const Words& words) {
    const bool of_it = is_one_of(words.front(), {"it", "them"});
    const bool of_room = has_word(
        words, {"everything", "room", "style", "time", "weather", "lighting", "outside", "hour", "view"});
    if (!of_it && !of_room) return false;
    const PromptSpec spec = understand_prompt(text_of(words), false, talk.editor.pack());
    bool told = false;
    for (const std::string* value : {&spec.time, &spec.weather, &spec.outlook})
        if (!value->empty()) light(talk, *value), told = true;
    if (!spec.style.empty()) {
        EditStep step;
        step.kind = EditStep::Kind::restyle;
        step.value = spec.style;
        talk.editor.apply(step);
        told = true;
    }
    if (told) return true;
    const auto value = value_of(part_of(words, 1));
    if (of_it && (value || !talk.last.empty())) return false;  // of what was named before
    for (std::size_t i = 1; i < words.size() && of_room; ++i)
        if (const auto said = value_of(part_of(words, i))) {
            if (said->resizes()) refuse_shell();
            // "the room pink" is its walls.
            if (is_one_of(text_of(words, 0, i), {"the room", "this room", "my room", "the whole room"}) &&
                !said->looks.color.empty() && said->looks.material.empty()) {
                EditStep step;
                step.kind = EditStep::Kind::recolor;
                step.surface = "wall", step.wish = said->looks;
                return talk.editor.apply(step), true;
            }
            // "the walls of the room white"
            if (!surface_said(part_of(words, 0, i)).empty()) return false;
        }
    if (has_word(words, {"everything"}))
        throw UsageError("name what is to be so, for example \"the walls\" or \"all chairs\", found \"{}\"",
                         text_of(words));
    throw UsageError("expected a style, an hour or a weather for the room, found \"{}\"", text_of(words));
}

}  // namespace

namespace {

// "the sofa the same color as the rug", "the curtains match the sofa"; false: no such words.
bool like_another(Talk& talk, const Words& words) {
    std::size_t same = find_word(words, {"same"}, 1), as = find_word(words, {"as"}, same);
    if (const std::size_t match = find_word(words, {"match", "matching"}, 1); match < words.size()) same = as = match;
    else if (find_word(words, {"color", "shade"}, same) > as) return false;
    if (as + 1 >= words.size()) return false;
    Words subject = part_of(words, 0, same);
    while (subject.size() > 1 && is_one_of(subject.back(), {"the", "in", "to", "have", "be"})) subject.pop_back();
    const std::vector<std::string> model = talk.things(part_of(words, as + 1));
    Value value;
    value.looks.color = talk.editor.color_seen(model.front());
    talk.last = make_one(talk, bare_subject(subject), value);
    return true;
}

}  // namespace

namespace {

bool says_on_or_off(const Words& words) {
    return is_one_of(words.front(), {"on", "off"}) || is_one_of(words.back(), {"on", "off"});
}

}  // namespace

void recolor(Talk& talk, const std::string& surface, const Value& value) {
    EditStep step;
    step.kind = EditStep::Kind::recolor;
    step.surface = surface, step.wish = value.looks, step.brighter = value.brighter;
    apply_shaded(talk, step);
    tell_stand_ins(talk, step, value);
}

bool each_on_or_off(const Words& words) {
    const std::vector<Words> parts = parts_of(words);
    return parts.size() > 1 && std::all_of(parts.begin(), parts.end(), says_on_or_off);
}

void make(Talk& talk, const Words& words) {
    // "the ceiling lights off and the desk lamp on"
    if (each_on_or_off(words)) {
        const std::vector<Words> parts = parts_of(words);
        return do_each(talk.editor, parts.size(), [&](std::size_t k) { make(talk, parts[k]); });
    }
    // "it a rainy evening with only the lamps on"
    if (const std::size_t with = find_word(words, {"with"}, 2);
        with + 2 < words.size() && is_one_of(words.front(), {"it", "the"}) && says_on_or_off(words)) {
        make(talk, part_of(words, 0, with));
        return make(talk, part_of(words, with + 1));
    }
    // "The ceiling blue with the walls white"
    const auto says_look = [](const Words& some) {
        for (std::size_t i = 1; i < some.size(); ++i)
            if (value_of(part_of(some, i))) return true;
        return false;
    };
    if (const std::size_t with = find_word(words, {"with"}, 2);
        with + 3 < words.size() && is_definite(words[with + 1]) && !noun_of(words[with + 2]).empty() &&
        says_look(part_of(words, 0, with)) && value_of(part_of(words, with + 3)))
        return do_each(
            talk.editor, 2,
            [&](std::size_t k) { make(talk, k == 0 ? part_of(words, 0, with) : part_of(words, with + 1)); },
            [&](std::size_t k) { return text_of(k == 0 ? part_of(words, 0, with) : part_of(words, with + 1)); });
    // "The cabinets green with a wooden worktop"
    if (const std::size_t with = find_word(words, {"with"}, 2);
        with + 3 < words.size() && is_worktop(words.back()) && says_look(part_of(words, 0, with)))
        if (const std::size_t look = is_one_of(words[with + 1], {"a", "an"}) ? with + 2 : with + 1;
            value_of(part_of(words, look, words.size() - 1))) {
            const Words top = joined_words({"the", words.back()}, part_of(words, look, words.size() - 1));
            return do_each(
                talk.editor, 2, [&](std::size_t k) { make(talk, k == 0 ? part_of(words, 0, with) : top); },
                [&](std::size_t k) { return text_of(k == 0 ? part_of(words, 0, with) : top); });
        }
    // "it darker, with candles on the tables", "it a romantic evening with candles on the tables"
    const auto with_things = [&](std::size_t with) {
        const Words what = part_of(words, with + 1);
        const std::size_t end = next_place(what);
        const auto noun = end < what.size() ? look_up(what[end - 1]) : std::nullopt;
        return begins_anew(what) && (words[with - 1] == "," || (words.front() == "it" && talk.last.empty() && noun &&
                                                                noun->kind == WordKind::object));
    };
    for (std::size_t with = 2; with + 2 < words.size(); ++with)
        if (words[with] == "with" && with_things(with))
            return do_each(
                talk.editor, 2,
                [&](std::size_t k) {
                    if (k == 0) make(talk, part_of(words, 0, words[with - 1] == "," ? with - 1 : with));
                    else add(talk, part_of(words, with + 1));
                },
                [&](std::size_t k) { return text_of(k == 0 ? part_of(words, 0, with) : part_of(words, with)); });
    if (made_with(talk, words)) return;
    // "Cover the tables with white cloths": those come, or there is no such thing.
    if (const std::size_t with = find_word(words, {"with"}, 2);
        talk.said == "cover" && with + 1 < words.size() && !value_of(part_of(words, with + 1)))
        return add(talk, joined_words(joined_words(part_of(words, with + 1), {"on"}), part_of(words, 0, with)));
    if (made_and_wanted(talk, words)) return;
    // "it darker and more romantic"
    if (const std::vector<Words> parts = parts_of(words);
        parts.size() > 1 && next_place(words) == words.size() &&
        ((words.front() == "it" && talk.last.empty()) ||
         (is_definite(words.front()) && words.size() > 2 && noun_of(words[1]) == "room")))
        return do_each(
            talk.editor, parts.size(),
            [&](std::size_t k) {
                const Words subject = words.front() == "it" ? Words{"it"} : part_of(words, 0, 2);
                make(talk, k > 0 ? joined_words(subject, parts[k]) : parts[k]);
            },
            [&](std::size_t k) { return text_of(parts[k]); });
    // "the room brick walls and a concrete floor"
    if (talk.said == "give" && words.size() > 3 && noun_of(words[1]) == "room") return add(talk, part_of(words, 2));
    if (talk.said == "give" && given(talk, words)) return;
    if (make_by_turns(talk, words) || make_various(talk, words)) return;
    if (const std::string lamps = lamps_said(words); !lamps.empty()) return light(talk, lamps);
    if (shine_said(talk, words)) return;
    if (has_word(words, {"face", "facing"})) return face(talk, words);
    if (brightness_said(talk, words) || made_vaguely(talk, words)) return;
    if (like_another(talk, words)) return;
    if (of_the_room(talk, words)) return;
    std::vector<Words> unshown;
    const std::vector<Group> groups = groups_of(as_made(words), unshown);
    check_one_look(talk, groups);
    do_each(talk.editor, groups.size(), [&](std::size_t k) { apply(talk, groups[k]); });
    for (const Words& with : unshown)
        talk.editor.note(kNotDone, fmt::format("\"{}\": nothing shows that", text_of(with)));
}

}  // namespace fastscene::editing
