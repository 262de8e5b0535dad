#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/prompt_parts.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene {
namespace {

using namespace reading;

std::string described(const PromptObject& object) {
    std::string text = object.kind;
    const bool units = object.kind.starts_with("kitchen_");
    for (const auto& [name, value] : {std::pair{"color", &object.color},
                                      {"and", &object.color2},
                                      {has_role(object.kind, Role::bed)        ? "bedding in color"
                                       : units                                 ? "top in color"
                                       : object.holder_material == kTableCloth ? "cloth in color"
                                                                               : "vase in color",
                                       &object.holder_color},
                                      {units                                   ? "top of"
                                       : object.holder_material == kTableCloth ? "with a"
                                                                               : "vase of",
                                       &object.holder_material},
                                      {"wall behind in color", &object.back_color},
                                      {"wall behind of", &object.back_material},
                                      {"material", &object.material},
                                      {"pattern", &object.pattern},
                                      {"size", &object.size},
                                      {"style", &object.style}})
        if (!value->empty()) text += std::string(", ") + name + " " + *value;
    if (object.count > 1) text += ", " + std::to_string(object.count) + " of them";
    if (!object.relation.empty())
        text += ", " + object.relation + (object.relation_to.empty() ? "" : " the " + object.relation_to);
    return text;
}

// Nouns last: by now all that was bound to them is known.
void tell_nouns(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (!has_object(r.m[i]) || r.m[i].listed) continue;
        const PromptObject& object = r.object_of(i);
        const std::string meaning = (object.forbidden ? "without: " : "object: ") + described(object);
        // Of a church without a roof the roof is the ceiling: every room is built with one.
        const bool always = object.forbidden && is_one_of(object.kind, {"ceiling", "floor", "wall"});
        if (always) r.tell_near(i, meaning + ": every room is built with one", object.id);
        else if (r.m[i].word->exact) r.tell(i, meaning, object.id);
        else r.tell_near(i, meaning, object.id);
    }
}

void collect(const Matches& matches, PromptSpec& spec) {
    for (const Match& m : matches) {
        if (!m.listed) continue;
        PromptWord word{m.words, m.fate, m.meaning, m.about, m.relation, m.measure};
        if (!m.note.empty()) {
            word.fate = PromptWord::Fate::approximated;
            word.meaning = m.note + (m.meaning.empty() ? "" : "; " + m.meaning);
        }
        spec.words.push_back(std::move(word));
    }
}

}  // namespace

bool PromptSpec::names_a_room() const {
    return !room.empty() || !style.empty() || !objects.empty() || !colors.empty() || !time.empty() ||
           !weather.empty() || !mood.empty() || !light.empty() || !clutter.empty() || !structure.empty() ||
           !everything.kind.empty() || size_m != Vec3f{} || area_m2 > 0;
}

std::vector<PromptWord> PromptSpec::words_with(PromptWord::Fate fate) const {
    std::vector<PromptWord> out;
    std::copy_if(words.begin(), words.end(), std::back_inserter(out),
                 [&](const PromptWord& w) { return w.fate == fate; });
    return out;
}

PromptSpec understand_prompt(const std::string& text, bool strict, std::shared_ptr<const FurniturePack> pack) {
    check_prompt(text);
    PromptSpec spec;
    spec.text = text;
    spec.pack = std::move(pack);
    const std::vector<std::string> tokens = with_numbers_apart(tokens_of(text));
    const Tongue tongue = tongue_of(tokens);
    spec.language = tongue.language;
    spec.unread = tongue.unread;
    if (!spec.unread.empty())
        spec.assumed.push_back("language: " + spec.unread + " is not read; only words that English shares with it are");
    Reading r{spec, match(tokens, tongue, spec.pack.get()), tongue.language};
    settle_quantities(r.m);
    settle_double_meanings(r);
    find_nouns(r);
    bind_measures(r);
    bind_adjectives(r);
    seat_people(r);
    read_scopes(r);
    read_themes(r);
    read_globals(r);
    read_state(r);
    relate(r);
    tell_nouns(r);
    collect(r.m, spec);

    const auto unknown = spec.words_with(PromptWord::Fate::not_understood);
    if (strict && !unknown.empty()) {
        std::string list;
        for (const PromptWord& w : unknown) list += (list.empty() ? "" : ", ") + w.words;
        throw UsageError("--strict: expected only words that are understood, found {}", list);
    }
    if (strict && !spec.names_a_room())
        throw UsageError("--strict: expected a prompt about a room, found \"{}\"", text);
    return spec;
}

namespace {

// "piano: no free wall" by the words before the colon; the same line may be there many times.
std::string reason_for(const PromptSpec& spec, const PromptObject& object) {
    for (const std::string& line : spec.not_placed)
        if (line.starts_with(object.words + ": ")) return line.substr(object.words.size() + 2);
    return {};
}

struct Missing {
    int pieces = 0;
    std::string reason;
};
Missing missing(const PromptSpec& spec, const PromptObject& object) {
    if (object.forbidden) return {};
    Missing out{object.count - object.placed, reason_for(spec, object)};
    if (out.reason.empty()) out.pieces = 0;
    return out;
}

// Why a word of the prompt shows nowhere, if so.
std::string why_not(const PromptSpec& spec, const PromptWord& word) {
    if (word.object < 0) return {};
    const PromptObject& object = spec.objects[static_cast<std::size_t>(word.object)];
    const Missing lacking = missing(spec, object);
    if (lacking.pieces <= 0) return {};
    if (object.placed == 0) return (word.words == object.words ? "" : "of the " + object.words + ": ") + lacking.reason;
    // Some stand, others do not: the number was not kept.
    if (word.meaning.starts_with("count ") || (!object.counted && word.words == object.words))
        return std::to_string(lacking.pieces) + " of " + std::to_string(object.count) + " " + object.words + ": " +
               lacking.reason;
    return {};
}

Json entry(const PromptWord& word, const char* key, const std::string& value) {
    return {{"words", word.words}, {key, value}};
}

}  // namespace

Json to_json(const PromptSpec& spec) {
    Json objects = Json::array();
    for (const PromptObject& o : spec.objects)
        objects.push_back({{"class", o.kind},
                           {"words", o.words},
                           {"count", o.count},
                           {"placed", o.placed},
                           {"color", o.color},
                           {"color2", o.color2},
                           {"material", o.material},
                           {"pattern", o.pattern},
                           {"holder_color", o.holder_color},
                           {"holder_material", o.holder_material},
                           {"back_color", o.back_color},
                           {"back_material", o.back_material},
                           {"size", o.size},
                           {"size_m", Json{o.size_m.x, o.size_m.y, o.size_m.z}},
                           {"not_color", o.not_color},
                           {"style", o.style},
                           {"relation", o.relation},
                           {"relation_to", o.relation_to},
                           {"relation_and", o.relation_and},
                           {"forbidden", o.forbidden}});
    Json understood = Json::array(), approximated = Json::array(), not_placed = Json::array(),
         not_understood = Json::array(), assumed = Json::array();
    for (const PromptWord& w : spec.words) {
        if (const std::string reason = why_not(spec, w); !reason.empty())
            not_placed.push_back(entry(w, "reason", reason));
        else if (w.fate == PromptWord::Fate::understood) understood.push_back(entry(w, "meaning", w.meaning));
        else if (w.fate == PromptWord::Fate::approximated) approximated.push_back(entry(w, "meaning", w.meaning));
        else not_understood.push_back(w.words);
    }
    for (const std::string& line : spec.assumed) {
        const auto colon = line.find(": ");
        assumed.push_back(
            {{"what", line.substr(0, colon)}, {"value", colon == std::string::npos ? "" : line.substr(colon + 2)}});
    }
    const auto metres = [](Vec3f size) { return Json{size.x, size.y, size.z}; };
    return {{"text", spec.text},
            {"language", spec.language.empty() ? "en" : spec.language},
            {"unread_language", spec.unread},
            {"room", spec.room},
            {"structure", spec.structure},
            {"outline", spec.outline},
            {"size_m", metres(spec.size_m)},
            {"area_m2", spec.area_m2},
            {"everything", {{"color", spec.everything.color}, {"material", spec.everything.material}}},
            {"style", spec.style},
            {"time", spec.time},
            {"weather", spec.weather},
            {"outlook", spec.outlook},
            {"mood", spec.mood},
            {"light", spec.light},
            {"light_color", spec.light_color},
            {"clutter", spec.clutter},
            {"size", spec.size},
            {"colors", spec.colors},
            {"accents", spec.accents},
            {"objects", objects},
            {"understood", understood},
            {"assumed", assumed},
            {"approximated", approximated},
            {"not_placed", not_placed},
            {"not_understood", not_understood}};
}

}  // namespace fastscene
