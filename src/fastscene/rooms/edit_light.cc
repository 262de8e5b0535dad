// The light of a room: its hour, its weather, its lamps; "more light", "it is too dark".
#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/daylight.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/style_choices.h"

namespace fastscene::editing {
namespace {

constexpr float kFull = 0.99f, kDimmed = 0.4f, kOut = 0.1f;  // of the lamps' power

bool is_flame(const Placed& p) {
    return std::any_of(p.piece.materials.begin(), p.piece.materials.end(),
                       [](const Material& m) { return m.burns && m.emission != Vec3f{}; });
}

}  // namespace

bool can_shine(const Placed& placed) {
    return std::any_of(placed.piece.materials.begin(), placed.piece.materials.end(),
                       [](const Material& m) { return m.emission != Vec3f{} && m.pattern != Pattern::screen; });
}

void Editor::light(const std::string& value) {
    DocumentLight& light = result_.document.light;
    if (is_one_of(value, {"morning", "day", "evening", "dusk", "night"})) {
        light.hour = value;
        light.lamps.reset(), light.towards_sun.reset();
        if (light.light == "neon" || light.light == "lamps on") light.light.clear();
        // A low sun is behind clouds.
        if (value == "evening" && is_one_of(light.weather, {"overcast", "rainy", "snowy"})) light.weather.clear();
    } else if (is_one_of(value, {"sunny", "overcast", "rainy", "snowy"})) {
        light.weather = value;
        light.towards_sun.reset();
    } else if (value == "lamps on" || value == "lamps off") {
        light.lamps = value == "lamps on" ? 1.f : 0.f;
        // All of them, those too of which something else was said.
        for (std::size_t i = 0; i < result_.document.things.size(); ++i)
            if (!is_flame(placed(static_cast<int>(i)))) result_.document.things[i].lit.reset();
    } else if (std::ranges::find(kNamesOf<Sky::View>, value) != kNamesOf<Sky::View>.end()) {
        light.outlook = value;
    } else if (is_one_of(value, {"brighter", "darker", "lamps brighter", "lamps darker"})) {
        return brighten(value.ends_with("brighter"), value.starts_with("lamps"));
    } else {
        throw UsageError(
            "expected an hour (morning, day, evening, dusk, night) or a weather (sunny, overcast, rainy, snowy), found "
            "\"{}\"",
            value);
    }
    tell("room", "light: " + value);
    build();
}

// By what changes least: the lamps first, then the weather, then the hour.
void Editor::brighten(bool more, bool lamps_alone) {
    DocumentLight& light = result_.document.light;
    const float level = light.lamps.value_or(lamp_level(room_.spec, plan()));
    const std::string hour = room_.spec.time;
    if (more && level < kFull) light.lamps = 1.f;
    else if (more && !lamps_alone && is_one_of(light.weather, {"overcast", "rainy", "snowy"}))
        return this->light("sunny");
    else if (more && !lamps_alone && is_one_of(hour, {"evening", "dusk", "night"})) return this->light("day");
    else if (more)
        throw Error(lamps_alone ? "the lamps are on already; \"make it day\" and \"add a floor lamp\" bring more light"
                                : "it is day and the lamps are on already; \"add a floor lamp\" and \"make the walls "
                                  "white\" bring more light");
    else if (level > kOut) light.lamps = kDimmed * level > kOut ? kDimmed * level : 0.f;
    else if (lamps_alone) throw Error("the lamps are off already");
    else if (is_one_of(hour, {"morning", "day"})) return this->light("evening");
    else if (hour == "evening") return this->light("dusk");
    else throw Error("it is {} and the lamps are off already", hour);
    tell("room", *light.lamps >= kFull ? "light: lamps on"
                 : *light.lamps > 0    ? "light: lamps dimmed"
                                       : "light: lamps off");
    build();
}

// One by one, whatever the others do.
void Editor::shine(const EditStep& step) {
    const float room = result_.document.light.lamps.value_or(lamp_level(room_.spec, plan()));
    for (const std::string& id : step.ids) {
        const int i = index_of(id);
        if (!can_shine(placed(i)))
            throw UsageError("only lamps are turned on and off, and candles and fires: {} does not shine", id);
        const bool known = placed(i).lit || !is_flame(placed(i));
        const float now = placed(i).lit.value_or(known ? room : 1.f);
        float to = step.value == "on" ? 1.f : 0.f;
        if (step.value == "brighter") to = now > kOut ? std::min(1.f, now / kDimmed) : 1.f;
        if (step.value == "darker") to = kDimmed * now > kOut ? kDimmed * now : 0.f;
        const bool more = step.value == "brighter", less = step.value == "darker";
        if (known && to == now && (more || less)) throw Error("{}: it is {} already", id, more ? "on" : "off");
        thing(i).lit = to;
        tell(id, to > kFull ? "light: on" : to > 0 ? fmt::format("light: {:.0f} percent", 100 * to) : "light: off");
    }
    build();
}

std::string lamps_said(const Words& words) {
    const bool lamps = std::any_of(words.begin(), words.end(), [](const std::string& w) {
        return w.find("lamp") != std::string::npos || is_one_of(w, {"light", "lights"});
    });
    // "The desk lamp", "the lamp" is one of them.
    const bool all = std::all_of(words.begin(), words.end(), [](const std::string& w) {
        return is_definite(w) || is_one_of(w, {"lamps", "lights", "light", "on", "off", "out", "all", "of", "every",
                                               "both", "room's", "again", "up", "back", "in", "room"});
    });
    if (!lamps || !all || words.size() > 5) return {};
    const std::size_t last = words.size() - 1;
    for (const auto& [word, value] : {std::pair{"on", "lamps on"}, {"off", "lamps off"}, {"out", "lamps off"}})
        if (words.front() == word || words[last] == word) return value;
    return {};
}

bool shine_said(Talk& talk, const Words& words) {
    const auto tells = [](const std::string& w) { return is_one_of(w, {"on", "off", "out"}); };
    const std::size_t last = words.size() - (words.back() == "only" && words.size() > 1 ? 2 : 1);
    if (words.size() < 2 || (!tells(words.front()) && !tells(words[last]))) return false;
    // "the floor lamp only on": no other one
    if (const std::size_t only = find_word(words, {"only", "just"}); only < words.size()) {
        Words rest = words;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(only));
        if (rest.front() == "on" || rest.back() == "on") {
            EditStep others;
            others.kind = EditStep::Kind::light, others.value = "lamps off";
            talk.editor.apply(others);
        }
        return shine_said(talk, rest);
    }
    const bool first = tells(words.front());
    EditStep step;
    step.kind = EditStep::Kind::shine;
    step.value = (first ? words.front() : words.back()) == "on" ? "on" : "off";
    const Words what = first ? part_of(words, 1) : part_of(words, 0, words.size() - 1);
    // "Light the fire, turn everything else off"
    if (is_one_of(what.front(), {"everything", "all"}) && is_one_of(what.back(), {"everything", "else", "rest"})) {
        for (const Placed& p : talk.editor.room().furnished.placed)
            if (can_shine(p) && has_role(p.piece.kind, Role::light) && !is_among(p.id, talk.last))
                step.ids.push_back(p.id);
        if (step.ids.empty()) throw UsageError("nothing else shines in the room");
    } else step.ids = talk.things_of_parts(what);
    talk.editor.apply(step);
    return true;
}

namespace {

bool names_room(const std::string& word) {
    const auto known = look_up(word);
    return known && known->kind == WordKind::room;
}

}  // namespace

bool brightness_said(Talk& talk, const Words& words) {
    // "more light", "less light"
    const std::string text = text_of(words);
    std::string value;
    for (const char* light : {"light", "lighting", "brightness", "daylight"}) {
        if (is_one_of(text, {std::string("more ") + light, std::string("some more ") + light,
                             std::string("a lot more ") + light, std::string("much more ") + light,
                             std::string("better ") + light}))
            value = "brighter";
        if (is_one_of(text, {std::string("less ") + light, std::string("much less ") + light})) value = "darker";
    }
    // "it a bit brighter", "the room darker", "the lights dimmer"
    bool lamps = false, room = false;
    for (const std::string& w : words) {
        if (!value.empty()) break;
        if (is_one_of(w, {"lights", "lamps", "lighting", "light"})) lamps = true;
        else if (is_one_of(w, {"it", "room", "everything", "space", "place", "here"}) || names_room(w)) room = true;
        else if (!is_definite(w) &&
                 !is_one_of(w, {"a", "bit", "little", "much", "lot", "all", "in", "whole", "more", "slightly", "up",
                                "down", "brighter", "darker", "lighter", "dimmer", "bright", "entire"}))
            return false;
    }
    if (value.empty() && words.front() == "it" && !talk.last.empty()) return false;
    if (value.empty() && (lamps || room || is_one_of(words.front(), {"brighter", "darker"}))) {
        const bool more = find_word(words, {"brighter", "lighter"}) < words.size() ||
                          (find_word(words, {"bright"}) < words.size() && find_word(words, {"more"}) < words.size());
        if (more) value = "brighter";
        else if (find_word(words, {"darker", "dimmer"}) < words.size()) value = "darker";
    }
    if (value.empty()) return false;
    EditStep step;
    step.kind = EditStep::Kind::light;
    step.value = (lamps && !room ? "lamps " : "") + value;
    talk.editor.apply(step);
    return true;
}

}  // namespace fastscene::editing
