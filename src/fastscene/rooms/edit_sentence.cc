// Edits in words: a sentence is cut into clauses, each with its verb.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/plan.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene {
namespace editing {
namespace {

using Words = std::vector<std::string>;

enum class Verb : unsigned char { none, remove, move, put, make, add, replace, turn, color };

Verb verb_of(const std::string& word) {
    struct Entry {
        Verb verb;
        std::initializer_list<std::string_view> words;
    };
    static const std::array<Entry, 8> kVerbs{{
        {Verb::remove, {"remove", "delete", "take", "drop", "clear", "get", "throw", "lose", "discard"}},
        {Verb::move, {"move", "shift", "bring", "push", "pull", "slide", "drag", "relocate"}},
        {Verb::put, {"put", "place", "set", "stand", "hang", "lay"}},
        {Verb::make, {"make", "change", "switch"}},
        {Verb::add, {"add", "insert", "include"}},
        {Verb::replace, {"replace", "swap", "exchange"}},
        {Verb::turn, {"turn", "rotate", "spin"}},
        {Verb::color, {"paint", "color", "recolor", "dye"}},
    }};
    for (const Entry& entry : kVerbs)
        if (std::find(entry.words.begin(), entry.words.end(), word) != entry.words.end()) return entry.verb;
    return Verb::none;
}

bool is_joint(const std::string& word) {
    return is_one_of(word, {",", ".", ";", "and", "then", "please", "also", "but"});
}

// At every verb that begins a phrase a clause begins.
std::vector<Words> clauses_of(const std::string& sentence) {
    std::vector<Words> out;
    bool begins = true;
    for (const std::string& word : tokens_of(sentence)) {
        if (is_joint(word)) {
            begins = true;
            if (!out.empty()) out.back().push_back(word);
            continue;
        }
        if (begins && verb_of(word) != Verb::none) out.emplace_back();
        if (out.empty())
            throw UsageError(
                "expected what to do (move, remove, add, make, turn, replace …) at the beginning of \"{}\", found "
                "\"{}\"",
                sentence, word);
        out.back().push_back(word);
        begins = false;
    }
    for (Words& clause : out)
        while (!clause.empty() && is_joint(clause.back())) clause.pop_back();
    if (out.empty()) throw UsageError("expected what to change, found an empty sentence");
    return out;
}

std::string text_of(const Words& words, std::size_t from = 0, std::size_t to = std::string::npos) {
    std::string out;
    for (std::size_t i = from; i < std::min(to, words.size()); ++i) out += (out.empty() ? "" : " ") + words[i];
    return out;
}

bool is_article(const std::string& word) { return is_one_of(word, {"the", "my", "this", "that", "its"}); }

class Clause {
  public:
    // `last`: the things that the clause before spoke of, "it" in this one.
    Clause(Editor& editor, Words words, std::vector<std::string>& last)
        : editor_(editor), words_(std::move(words)), last_(last) {
        verb_ = verb_of(words_.front());
        words_.erase(words_.begin());
    }

    void act() {
        // "take away", "get rid of", "throw out"
        if (verb_ == Verb::remove)
            while (!words_.empty() && is_one_of(words_.front(), {"away", "out", "rid", "of"}))
                words_.erase(words_.begin());
        if (words_.empty()) throw UsageError("expected what to change after the verb, found the end of the sentence");
        switch (verb_) {
            case Verb::remove: return remove();
            case Verb::move: return move();
            case Verb::put: return is_article(words_.front()) ? move() : add();
            case Verb::add: return add();
            case Verb::replace: return replace();
            case Verb::turn: return turn();
            case Verb::make:
            case Verb::color: return make();
            case Verb::none: break;
        }
    }

  private:
    std::vector<std::string> things(const std::string& words) {
        if (!is_one_of(words, {"it", "them", "they"}))
            last_ = named(editor_.document(), editor_.room(), words, editor_.pack());
        else if (last_.empty()) throw UsageError("what is \"{}\"? nothing was named before", words);
        return last_;
    }
    PromptSpec read(const std::string& words) const { return understand_prompt(words, false, editor_.pack()); }

    // "the rug and the two plants"
    void remove() {
        while (is_one_of(words_.back(), {"away", "out"})) words_.pop_back();
        EditStep step;
        step.kind = EditStep::Kind::remove;
        std::vector<Words> parts{{}};
        for (const std::string& w : words_) {
            if (!is_joint(w)) parts.back().push_back(w);
            else if (!parts.back().empty()) parts.emplace_back();
        }
        for (const Words& part : parts)
            if (!part.empty())
                for (const std::string& id : things(text_of(part))) step.ids.push_back(id);
        editor_.apply(step);
    }

    // Where words say that a thing stands: "to the window", "next to the bed"; the thing is read with them.
    PromptObject place_of(const std::string& thing, const Words& words) const {
        const std::string rest = text_of(words);
        Words plain = words;
        if (is_one_of(plain.front(), {"to", "into", "over", "onto", "at", "towards", "near"}))
            plain.erase(plain.begin());
        if (!plain.empty() && plain.front() == "to") plain.erase(plain.begin());
        const std::string place = text_of(plain);
        for (const std::string& said : {rest, "next to " + place, "in " + place, "against " + place, "on " + place}) {
            // Of "over to the window", over is no place.
            if (said == rest && words.size() > 1 && words[0] == "over" && words[1] == "to") continue;
            if (said == rest && words.front() == "to") continue;
            const PromptSpec spec = read("a " + thing + " " + said);
            if (!spec.objects.empty() && !spec.objects.front().relation.empty()) return spec.objects.front();
        }
        throw UsageError("expected a place in the room, found \"{}\"", rest);
    }

    // A thing's words end where its place begins: before the first word that is a relation or "to".
    std::size_t end_of_thing(std::size_t from = 0) const {
        static constexpr std::array<std::string_view, 30> kPlaces{
            "to",      "into",  "onto", "on",     "in",    "next",  "beside",  "near",    "under",    "below",
            "beneath", "above", "over", "behind", "front", "by",    "between", "against", "opposite", "facing",
            "around",  "along", "at",   "before", "left",  "right", "towards", "across",  "close",    "underneath"};
        for (std::size_t i = std::max<std::size_t>(1, from); i < words_.size(); ++i) {
            // "the left nightstand", "the right one"
            if (is_one_of(words_[i], {"left", "right"}) && !(i + 1 < words_.size() && words_[i + 1] == "of")) continue;
            if (std::find(kPlaces.begin(), kPlaces.end(), words_[i]) != kPlaces.end()) return i;
        }
        return words_.size();
    }

    void move() {
        // "the chair at the desk to the window": the last "to" of a move begins the place.
        std::size_t end = end_of_thing();
        for (std::size_t i = words_.size(); i-- > end + 1;)
            if (is_one_of(words_[i], {"to", "into", "onto"}) &&
                !is_one_of(words_[i - 1], {"next", "close", "over", "closer", "up"})) {
                end = i;
                break;
            }
        if (end >= words_.size())
            throw UsageError("expected where to move \"{}\", for example \"to the window\"", text_of(words_));
        EditStep step;
        step.kind = EditStep::Kind::place;
        step.ids = things(text_of(words_, 0, end));
        const Placed& first = placed(step.ids.front());
        std::string kind = first.wish.kind.empty() ? first.piece.kind : first.wish.kind;
        std::replace(kind.begin(), kind.end(), '_', ' ');
        step.wish = place_of(kind, Words(words_.begin() + static_cast<std::ptrdiff_t>(end), words_.end()));
        editor_.apply(step);
    }
    const Placed& placed(const std::string& id) const {
        const std::vector<DocumentThing>& all = editor_.document().things;
        const auto at = std::find_if(all.begin(), all.end(), [&](const DocumentThing& t) { return t.id == id; });
        return editor_.room().furnished.placed[static_cast<std::size_t>(at - all.begin())];
    }

    // "a floor lamp beside the bed and two plants in the corner"
    void add() {
        const PromptSpec spec = read(text_of(words_));
        std::vector<std::string> places;
        std::vector<PromptObject> wishes;
        for (const PromptObject& o : spec.objects) {
            if (std::find(places.begin(), places.end(), o.kind) != places.end() || is_shell(o.kind) ||
                has_role(o.kind, Role::opening))
                continue;
            // Places that are named stand already, unless they are asked for anew.
            places.push_back(o.relation_to), places.push_back(o.relation_and);
            wishes.push_back(o);
        }
        const auto unknown = spec.words_with(PromptWord::Fate::not_understood);
        if (!unknown.empty()) throw UsageError("expected a thing to add, found \"{}\"", unknown.front().words);
        if (wishes.empty()) throw UsageError("expected a thing to add, found \"{}\"", text_of(words_));
        for (PromptObject wish : wishes) {
            if (wish.relation.empty()) near_openings(spec, wish);
            EditStep step;
            step.kind = EditStep::Kind::add;
            step.wish = wish;
            if (!wish.relation_to.empty()) check_place(wish.relation_to);
            editor_.apply(step);
            last_ = {editor_.document().things.back().id};
        }
    }
    // "a plant at the window": the reader takes no place from "at".
    void near_openings(const PromptSpec& spec, PromptObject& wish) const {
        const std::size_t end = end_of_thing();
        if (end >= words_.size() || !is_one_of(words_[end], {"at", "near", "by"})) return;
        for (const PromptObject& o : spec.objects)
            if (o.kind != wish.kind) wish.relation = "next to", wish.relation_to = o.kind;
    }
    // What something is to stand at must be there.
    void check_place(const std::string& kind) {
        if (is_shell(kind) || is_one_of(kind, {"wall", "floor", "ceiling", "window", "door", "doorway"})) return;
        const std::vector<DocumentThing>& all = editor_.document().things;
        if (std::none_of(all.begin(), all.end(),
                         [&](const DocumentThing& t) { return t.kind == kind || (t.asked && t.asked->kind == kind); }))
            things(kind);  // says so
    }

    void replace() {
        const auto with = std::find_if(words_.begin(), words_.end(), [](const std::string& w) {
            return is_one_of(w, {"with", "for", "by"});
        });
        if (with == words_.end() || with + 1 == words_.end())
            throw UsageError("expected \"replace … with …\", found \"{}\"", text_of(words_));
        const auto ids = things(text_of(words_, 0, static_cast<std::size_t>(with - words_.begin())));
        const PromptSpec spec = read(text_of(Words(with + 1, words_.end())));
        if (spec.objects.empty())
            throw UsageError("expected a thing, found \"{}\"", text_of(Words(with + 1, words_.end())));
        const Placed old = placed(ids.front());
        EditStep step;
        step.kind = EditStep::Kind::remove;
        step.ids = ids;
        editor_.apply(step);
        step = {};
        step.kind = EditStep::Kind::add;
        step.wish = spec.objects.front();
        step.position = flat(old.position);
        step.yaw = old.yaw;
        editor_.apply(step);
    }

    // "around", "by 90 degrees"; "off the lamps"
    void turn() {
        if (const auto lamps = lamps_said()) return light(*lamps);
        EditStep step;
        step.kind = EditStep::Kind::turn;
        step.yaw = kPi;
        std::size_t end = words_.size();
        for (std::size_t i = 1; i < words_.size(); ++i) {
            if (is_one_of(words_[i], {"around", "by", "round"})) end = std::min(end, i);
            float degrees = 0;
            const std::string& w = words_[i];
            if (std::from_chars(w.data(), w.data() + w.size(), degrees).ec == std::errc())
                step.yaw = degrees * kPi / 180, end = std::min(end, i);
            if (is_one_of(w, {"towards", "toward", "to"}))
                throw UsageError("expected \"around\" or \"by 90 degrees\", found \"{}\"", text_of(words_, i));
        }
        if (end == words_.size()) {  // "turn the walls green"
            return make();
        }
        step.ids = things(text_of(words_, 0, end));
        editor_.apply(step);
    }
    std::optional<std::string> lamps_said() const {
        const std::string all = " " + text_of(words_) + " ";
        if (all.find("lamp") == std::string::npos && all.find("light") == std::string::npos) return {};
        if (all.find(" on ") != std::string::npos) return "lamps on";
        if (all.find(" off ") != std::string::npos) return "lamps off";
        return {};
    }
    void light(const std::string& value) {
        EditStep step;
        step.kind = EditStep::Kind::light;
        step.value = value;
        editor_.apply(step);
    }

    // "the sofa green", "it night", "the walls sage", "the rug larger", "the style to japandi"
    void make() {
        std::size_t end = words_.size();
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (is_one_of(words_[i], {"into", "to", "in"}) && i > 0) {
                end = i;
                break;
            }
        const std::string all = text_of(words_);
        if (of_the_room()) return;
        Words subject(words_.begin(), words_.begin() + static_cast<std::ptrdiff_t>(end));
        Words value = end < words_.size() ? Words(words_.begin() + static_cast<std::ptrdiff_t>(end) + 1, words_.end())
                                          : Words{};
        if (value.empty()) split_looks(subject, value);
        if (value.empty()) throw UsageError("expected how to make it, for example \"green\", after \"{}\"", all);
        EditStep step;
        step.kind = EditStep::Kind::recolor;
        if (const float factor = factor_said(value); factor != 1) {
            step.kind = EditStep::Kind::resize;
            step.factor = factor;
        } else {
            step.wish = looks_named(text_of(value));
        }
        step.surface = surface_said(text_of(subject));
        if (step.surface.empty()) step.ids = things(text_of(subject));
        editor_.apply(step);
    }
    static float factor_said(const Words& value) {
        constexpr float kMore = 1.25f;  // to be seen at once
        for (const std::string& w : value) {
            if (is_one_of(w, {"larger", "bigger"})) return kMore;
            if (w == "smaller") return 1 / kMore;
        }
        return 1;
    }
    static std::string surface_said(const std::string& words) {
        const auto word = look_up(words.starts_with("the ") ? words.substr(4) : words);
        if (words.find("accent wall") != std::string::npos) return "accent_wall";
        if (!word) return {};
        return is_one_of(word->meaning, {"wall", "floor", "ceiling"}) ? word->meaning : std::string();
    }
    // The last words, as far as they are looks.
    static void split_looks(Words& subject, Words& value) {
        for (std::size_t i = 1; i < subject.size(); ++i) {
            const Words last(subject.begin() + static_cast<std::ptrdiff_t>(i), subject.end());
            if (factor_said(last) == 1) try {
                    looks_named(text_of(last));
                } catch (const UsageError&) {
                    continue;
                }
            value = last;
            subject.resize(i);
            return;
        }
    }
    // Of the whole room: its style, hour and weather. Says whether the clause was about that.
    bool of_the_room() {
        if (const auto lamps = lamps_said()) return light(*lamps), true;
        const bool of_it = words_.front() == "it" || words_.front() == "them";
        if (!of_it && !is_one_of(words_.front(), {"everything"}) && text_of(words_).find("room") == std::string::npos &&
            text_of(words_).find("style") == std::string::npos && text_of(words_).find("time") == std::string::npos)
            return false;
        const PromptSpec spec = read(text_of(words_));
        EditStep step;
        step.kind = EditStep::Kind::light;
        bool told = false;
        for (const std::string* value : {&spec.time, &spec.weather, &spec.outlook})
            if (!value->empty()) step.value = *value, editor_.apply(step), told = true;
        if (!spec.style.empty()) {
            step.kind = EditStep::Kind::restyle;
            step.value = spec.style;
            editor_.apply(step);
            told = true;
        }
        if (!told && of_it) return false;  // of what was named before
        if (!told)
            throw UsageError("expected a style, an hour or a weather for the room, found \"{}\"", text_of(words_));
        return true;
    }

    Editor& editor_;
    Verb verb_ = Verb::none;
    Words words_;
    std::vector<std::string>& last_;
};

}  // namespace
}  // namespace editing

EditResult edit_by_sentence(const RoomDocument& document, const std::string& sentence,
                            std::shared_ptr<const FurniturePack> pack, const Run& run) {
    check_prompt(sentence);
    editing::Editor editor(document, std::move(pack), run);
    std::vector<std::string> last;
    for (const auto& clause : editing::clauses_of(sentence)) editing::Clause(editor, clause, last).act();
    return editor.result();
}

}  // namespace fastscene
