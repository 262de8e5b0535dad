// The nouns of a prompt: which pieces it speaks of, which of them again, which it does not want.
#include <algorithm>
#include <array>
#include <utility>

#include "fastscene/base/is_one_of.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// Whether "the" or its like stands before it, with nothing but adjectives between.
bool is_definite(const Matches& m, std::size_t i) {
    for (std::size_t k = i; k-- > 0;) {
        if (m[k].is_function("the") || m[k].is_function("its") || m[k].is_function("their") ||
            m[k].is_function("this") || m[k].is_function("that") || m[k].is_function("each") ||
            m[k].is_function("every") || m[k].is_function("both"))
            return true;
        if (!is_adjective(m[k]) && !m[k].is(WordKind::nuance)) return false;
    }
    return false;
}

std::string last_word(const std::string& words) {
    const auto space = words.rfind(' ');
    return space == std::string::npos ? words : words.substr(space + 1);
}

// A dryer and a washing machine are of one class, and yet two things: one of them is only the nearest there is.
bool may_be_one(const Match& a, const Match& b) {
    if (a.words == b.words || last_word(a.words) == last_word(b.words)) return true;
    // Few rooms have two fires: "a stone hearth … facing the fire".
    return (a.word->exact && b.word->exact) || a.word->meaning == "fireplace";
}

// "the chair" after "two armchairs", "the lamp" after "a floor lamp".
int spoken_of_before(const Reading& r, std::size_t i) {
    const std::string& kind = r.m[i].word->meaning;
    for (std::size_t k = i; k-- > 0;)
        if (has_object(r.m[k]) && r.m[k].word->meaning == kind && r.m[k].is(WordKind::object) &&
            may_be_one(r.m[k], r.m[i]))
            return r.m[k].object;
    // "each bed" after "twin beds"
    const std::string noun = r.m[i].words;
    for (std::size_t k = i; k-- > 0;) {
        if (!has_object(r.m[k]) || !r.m[k].is(WordKind::object)) continue;
        const std::string last = last_word(r.m[k].words);
        std::vector<std::string> forms = base_forms(last);
        forms.push_back(last);
        if (std::any_of(forms.begin(), forms.end(), [&](const std::string& form) { return form.ends_with(noun); }))
            return r.m[k].object;
    }
    return -1;
}

// A bare plural means more than one ("plants", "chairs"); some words are plural by nature.
bool is_plural(const Match& m, Language language) {
    const std::string& kind = m.word->meaning;
    if (has_role(kind, Role::never_plural) || m.is(WordKind::detail)) return false;
    if (!language.empty()) {
        const auto forms = base_forms(m.words, language);
        return !forms.empty() &&
               (m.words.back() == 's' || m.words.back() == 'n' || m.words.back() == 'i' || m.words.back() == 'e') &&
               std::any_of(forms.begin(), forms.end(), [&](const std::string& f) {
                   const auto w = look_up(f, language);
                   return w && w->meaning == kind;
               });
    }
    if (m.plural) return true;
    if (m.words.ends_with("drawers") || kind == "glass_cup" || m.words.ends_with("stairs")) return false;
    for (const std::string& single : base_forms(m.words))
        if (const auto word = look_up(single); word && word->meaning == kind) return true;
    return false;
}

void take_added(const Word& word, PromptObject& object) {
    for (const auto& [name, field] : {std::pair{"material", &object.material},
                                      {"color", &object.color},
                                      {"size", &object.size},
                                      {"pattern", &object.pattern}})
        if (const std::string value = added_by(word, name); !value.empty()) *field = value;
    if (const std::string count = added_by(word, "count"); !count.empty())
        object.count = std::stoi(count), object.counted = true;
    if (const std::string length = added_by(word, "length"); !length.empty() && !(object.size_m.x > 0))
        object.size_m.x = static_cast<float>(number_in(length).value_or(0)), object.size = "large";
    if (!added_by(word, "row").empty()) object.in_row = true;
}

// "tulips in a vase": the flowers that stand in the vase of match i, -1: none.
int held_by(const Reading& r, std::size_t i) {
    if (!r.m[i].is(WordKind::object) || !has_role(r.m[i].word->meaning, Role::vase) || r.m[i].negated) return -1;
    std::size_t k = i;
    while (k > 0 && modifies(r.m[k - 1])) --k;
    if (k < 2 || !(r.m[k - 1].is_function("in") || r.m[k - 1].is_function("inside")) || !has_object(r.m[k - 2]))
        return -1;
    return r.m[k - 2].is(WordKind::object) && r.m[k - 2].word->meaning == "bouquet" ? r.m[k - 2].object : -1;
}

// "a shop full of clocks, vases and mirrors": of what fills a room there is more than a pair; not "shelves full of
// books".
bool fills_the_room(const Reading& r, std::size_t i) {
    if (!is_one_of(r.m[i].words, {"full of", "filled with", "packed with", "crammed with", "stuffed with",
                                  "crowded with", "bursting with", "overflowing with"}))
        return false;
    for (std::size_t k = i; k-- > 0 && !r.m[k].comma;) {
        if (has_object(r.m[k])) return false;
        if (r.m[k].is(WordKind::room) || r.m[k].is(WordKind::filler)) return true;
    }
    return false;
}

// "nothing on the walls", "bare walls", "a bare floor": what rooms have there by themselves is not there.
void clear_surfaces(Reading& r) {
    constexpr std::array<std::string_view, 7> kOnWalls{"picture",  "mirror", "clock",      "picture_ledge",
                                                       "tapestry", "shelf",  "photo_frame"};
    for (std::size_t i = 0; i + 1 < r.m.size(); ++i) {
        const bool nothing = r.m[i].words == "nothing" && r.m[i + 1].is(WordKind::relation) &&
                             r.m[i + 1].word->meaning == "on";
        if (!nothing && (!is_one_of(r.m[i].words, {"bare", "empty", "blank", "undecorated"}) || r.m[i].negated))
            continue;
        std::size_t surface = i + (nothing ? 2 : 1);
        while (surface < r.m.size() && (modifies(r.m[surface]) || (nothing && r.m[surface].is_function("the"))))
            ++surface;
        if (surface >= r.m.size() || !r.m[surface].is(WordKind::structure)) continue;
        const std::string& kind = r.m[surface].word->meaning;
        if (kind != "wall" && kind != "floor") continue;
        const auto asked = [&](std::string_view what) {
            return std::any_of(r.spec.objects.begin(), r.spec.objects.end(),
                               [&](const PromptObject& o) { return o.kind == what; });
        };
        if (kind == "floor" && !asked("rug")) r.add_object("rug", r.m[i].words).forbidden = true;
        if (kind == "wall")
            for (const std::string_view what : kOnWalls)
                if (!asked(what)) r.add_object(std::string(what), r.m[i].words).forbidden = true;
        r.tell(i,
               kind == "wall" ? "nothing hangs on the walls but what is named" : "no rug lies there but what is named");
        r.m[i].settled = true;
        if (nothing) r.m[i + 1].word = Word{WordKind::function, ""};
    }
}

// "a vase of tulips", "a vase with pink roses": the vase that the flowers of match i stand in, -1: none. It is one
// thing.
int holder_of(const Reading& r, std::size_t i) {
    if (!r.m[i].is(WordKind::object) || r.m[i].word->meaning != "bouquet" || r.m[i].negated) return -1;
    std::size_t k = i;
    while (k > 0 && modifies(r.m[k - 1])) --k;
    if (k < 2 || !(r.m[k - 1].is_function("of") || r.m[k - 1].is_function("with")) || !has_object(r.m[k - 2]))
        return -1;
    return is_one_of(r.m[k - 2].word->meaning, {"vase", "vase_small", "bouquet"}) ? r.m[k - 2].object : -1;
}

// "a chapel", "a hat shop": the nearest room of ours has a screen, and that one has none.
void leave_out(Reading& r) {
    for (const Match& m : r.m) {
        std::string left = m.is(WordKind::room) && !m.negated ? added_by(*m.word, "without") : "";
        while (!left.empty()) {
            const std::string kind = left.substr(0, left.find('+'));
            left.erase(0, std::min(left.size(), kind.size() + 1));
            const auto is_it = [&](const std::string& what) { return what == kind || what == kind + "_stand"; };
            const bool asked = std::any_of(r.m.begin(), r.m.end(), [&](const Match& x) {
                return x.is(WordKind::object) && is_it(x.word->meaning);
            });
            const bool there = std::any_of(r.spec.objects.begin(), r.spec.objects.end(),
                                           [&](const PromptObject& o) { return is_it(o.kind); });
            if (!asked && !there) r.add_object(kind, m.words).forbidden = true;
        }
    }
}

}  // namespace

void find_nouns(Reading& r) {
    bool fills = false;
    leave_out(r);
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        Match& m = r.m[i];
        if (m.is(WordKind::relation) || m.is(WordKind::negation) || m.is(WordKind::function))
            fills = fills_the_room(r, i) || (fills && m.is_function("and"));
        if (m.is(WordKind::nuance) && m.word->meaning == "windowless" && !m.negated)
            r.add_object("window", m.words).forbidden = true;
        if (!m.is(WordKind::object) && !m.is(WordKind::structure)) continue;
        if (is_definite(r.m, i) && m.is(WordKind::object) && !m.negated)
            if (const int before = spoken_of_before(r, i); before >= 0) {
                m.object = before;
                continue;
            }
        // A kitchen has one run of units: stove, sink and worktop are parts of it.
        if (m.word->meaning == "kitchen_counter") {
            const auto same = std::find_if(r.spec.objects.begin(), r.spec.objects.end(), [&](const PromptObject& o) {
                return o.kind == m.word->meaning && o.forbidden == m.negated;
            });
            if (same != r.spec.objects.end()) {
                m.object = same->id;
                continue;
            }
        }
        // "walls … on the wall", "a window … by the window": a part of the shell that was spoken of.
        if (m.is(WordKind::structure) && (is_definite(r.m, i) || (i > 0 && r.m[i - 1].is(WordKind::relation)))) {
            const auto same = std::find_if(r.spec.objects.begin(), r.spec.objects.end(), [&](const PromptObject& o) {
                return o.kind == m.word->meaning && o.forbidden == m.negated;
            });
            if (same != r.spec.objects.end()) {
                m.object = same->id;
                continue;
            }
        }
        if (const int holder = holder_of(r, i); holder >= 0) {
            PromptObject& held = r.spec.objects[static_cast<std::size_t>(holder)];
            held.kind = m.word->meaning;
            if (!held.material.empty())
                held.holder_material = std::exchange(held.material, "");  // "a glass vase with tulips"
            take_added(*m.word, held);
            m.object = holder;
            continue;
        }
        if (const int held = held_by(r, i); held >= 0) {
            m.object = held;
            r.spec.objects[static_cast<std::size_t>(held)].count = is_plural(m, r.language) ? 2 : 1;
            continue;
        }
        PromptObject& object = r.add_object(m.word->meaning, m.words);
        if (object.kind == "window_seat") object.relation = "under", object.relation_to = "window";
        object.forbidden = m.negated;
        constexpr int kManyFill = 4;
        if (is_plural(m, r.language)) object.count = fills ? kManyFill : 2;
        take_added(*m.word, object);
        m.object = object.id;
    }
    clear_surfaces(r);
    // "a lamp on the desk, a desk under the window": the desk is one desk.
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (!has_object(r.m[i]) || !r.m[i].is(WordKind::object) || r.m[i].negated || !is_definite(r.m, i)) continue;
        for (std::size_t k = i + 1; k < r.m.size(); ++k)
            if (has_object(r.m[k]) && r.m[k].object > r.m[i].object && r.m[k].word->meaning == r.m[i].word->meaning &&
                !r.m[k].negated) {
                const int gone = r.m[k].object;
                r.spec.objects.erase(r.spec.objects.begin() + gone);
                for (Match& x : r.m) x.object = x.object == gone ? r.m[i].object : x.object - (x.object > gone);
                for (PromptObject& o : r.spec.objects) o.id -= o.id > gone;
                break;
            }
    }
}

}  // namespace fastscene::reading
