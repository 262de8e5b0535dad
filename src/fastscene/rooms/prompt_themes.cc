// Themes ("a pirate bedroom", "a gamer's den") and motifs ("dinosaurs", "a painting of a lion"): what the room shows of
// them.
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

struct ThemedPiece {
    std::string_view kind, pattern = {}, color = {}, relation = {}, to = {};
    int count = 1;
};
struct Theme {
    std::string_view name, light;
    std::vector<ThemedPiece> pieces;
};
const std::vector<Theme>& themes() {
    static const std::vector<Theme> all{
        {"pirate",
         "",
         {{"trunk"}, {"picture", "skull"}, {"picture", "map"}, {"ship_model"}, {"rug", "striped", "navy"}}},
        {"gaming",
         "neon",
         {{"desk"},
          {"monitor", "", "", "on", "desk", 2},
          {"office_chair"},
          {"pc_tower", "", "", "next to", "desk"},
          {"picture", "gamepad"},
          {"picture", "invader"}}},
        {"space", "", {{"picture", "rocket"}, {"picture", "planet"}, {"picture", "moon"}}},
        {"safari", "", {{"picture", "lion"}, {"picture", "elephant"}, {"plant"}}},
        {"nautical", "", {{"picture", "anchor"}, {"picture", "ship"}, {"ship_model"}}},
    };
    return all;
}

std::string value_of(const Match& m, std::string_view key) {
    if (!m.word || m.negated || !m.word->adds.starts_with(key)) return {};
    return m.word->adds.substr(key.size());
}

bool is_forbidden(const PromptSpec& spec, std::string_view kind) {
    return std::any_of(spec.objects.begin(), spec.objects.end(),
                       [&](const PromptObject& o) { return o.forbidden && o.kind == kind; });
}

// What a theme brings where the prompt has not named it, and other rooms of a kind have not.
void bring(Reading& r, std::size_t i, const Theme& theme) {
    std::string list;
    int first = -1;
    for (const ThemedPiece& p : theme.pieces) {
        if (is_forbidden(r.spec, p.kind)) continue;
        const bool there = std::any_of(r.spec.objects.begin(), r.spec.objects.end(), [&](const PromptObject& o) {
            return !o.forbidden && o.kind == p.kind && (p.kind != "picture" || o.pattern == p.pattern);
        });
        if (!there) {
            PromptObject& object = r.add_object(std::string(p.kind), r.m[i].words);
            object.pattern = p.pattern;
            object.color = p.color;
            object.relation = p.relation;
            object.relation_to = p.to;
            object.count = p.count;
            if (first < 0) first = object.id;
        }
        std::string name(p.pattern.empty() || p.kind != "picture" ? p.kind : p.pattern);
        std::replace(name.begin(), name.end(), '_', ' ');
        list += (list.empty() ? "" : ", ") + (p.kind == "picture" ? "a picture (" + name + ")" : name);
    }
    // An hour or a light that the prompt names is kept.
    const bool lit = std::any_of(r.m.begin(), r.m.end(),
                                 [](const Match& m) { return m.is(WordKind::light) || m.is(WordKind::time); });
    if (!theme.light.empty() && !lit) r.spec.light = theme.light, list += ", colored light";
    const bool is_room = r.m[i].is(WordKind::room);
    if (list.empty() || is_room) return;
    r.tell(i, "theme, shown by: " + list, first);
    r.m[i].settled = true;
}

// The picture that a motif is of: "a painting of a lion", "dinosaur posters".
PromptObject* picture_of(Reading& r, std::size_t i) {
    const auto is_picture = [&](const Match& m) {
        return has_object(m) && m.is(WordKind::object) && m.word->meaning == "picture" && !m.negated;
    };
    for (std::size_t k = i; k-- > 0 && k + 4 > i;) {
        if (is_picture(r.m[k])) return &r.object_of(k);
        if (!modifies(r.m[k]) && !r.m[k].is(WordKind::function) && !(r.m[k].is(WordKind::nuance))) break;
    }
    for (std::size_t k = i + 1; k < r.m.size() && k < i + 3; ++k) {
        if (is_picture(r.m[k])) return &r.object_of(k);
        if (!modifies(r.m[k])) break;
    }
    return nullptr;
}

}  // namespace

void read_themes(Reading& r) {
    if (r.spec.clutter == "empty") return;
    constexpr int kMostPictures = 3;
    int hung = 0;
    std::string last;
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (const std::string name = value_of(r.m[i], "theme="); !name.empty() && name != last) {
            last = name;
            for (const Theme& theme : themes())
                if (theme.name == name) bring(r, i, theme);
        }
        const std::string motif = value_of(r.m[i], "motif=");
        if (motif.empty() || !r.m[i].is(WordKind::nuance)) continue;
        if (PromptObject* picture = picture_of(r, i); picture && picture->pattern.empty()) {
            picture->pattern = motif;
            r.tell(i, "the picture shows it: " + motif, picture->id);
        } else if (!is_forbidden(r.spec, "picture") && hung++ < kMostPictures) {
            PromptObject& object = r.add_object("picture", r.m[i].words);
            object.pattern = motif;
            r.tell_near(i, "a picture shows it: " + motif, object.id);
        } else continue;
        r.m[i].settled = true;
    }
}

// What lies about in a room that was left to decay, is lived in carelessly, renovated or moved into.
void read_state(Reading& r) {
    struct Thing {
        std::string_view kind;
        int count = 1;
        std::string_view relation = {}, to = {};
    };
    const std::string& state = r.spec.clutter;
    if (!is_state(state)) return;
    std::vector<Thing> things;
    if (state == "abandoned") things = {{"cobweb", 2}, {"rubble"}, {"paper_litter"}};
    if (state == "renovation")
        things = {{"step_ladder"}, {"drop_cloth"}, {"paint_buckets", 1, "next to", "step_ladder"}, {"moving_boxes"}};
    if (state == "moving") things = {{"moving_boxes", 3}};
    if (state == "messy") {
        static const RoomType unnamed;
        const RoomType* type = find_room_type(r.spec.room);
        for (const MessyThing& m : (type ? *type : unnamed).mess)
            things.push_back({m.thing, m.count, m.on_floor ? "on" : "", m.on_floor ? "floor" : ""});
    }
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        const bool said = r.m[i].word && (r.m[i].is(WordKind::mood) ? r.m[i].word->meaning == state
                                                                    : r.m[i].is(WordKind::style) &&
                                                                          added_by(*r.m[i].word, "clutter") == state);
        if (!said || r.m[i].negated || !r.m[i].listed) continue;
        std::string list;
        int first = -1;
        for (const Thing& thing : things) {
            if (is_forbidden(r.spec, thing.kind)) continue;
            const bool there = std::any_of(r.spec.objects.begin(), r.spec.objects.end(),
                                           [&](const PromptObject& o) { return o.kind == thing.kind && !o.forbidden; });
            if (!there) {
                PromptObject& object = r.add_object(std::string(thing.kind), r.m[i].words);
                object.count = thing.count;
                object.relation = thing.relation;
                object.relation_to = thing.to;
                if (first < 0) first = object.id;
            }
            std::string name(thing.kind);
            std::replace(name.begin(), name.end(), '_', ' ');
            list += (list.empty() ? "" : ", ") + name;
        }
        const std::string_view how = state == "abandoned"
                                         ? "peeling walls, dust over everything, hardly anything kept: "
                                     : state == "renovation" ? "bare plaster, no furniture but what is named: "
                                     : state == "moving"     ? "hardly anything unpacked: "
                                                             : "things everywhere: ";
        r.tell(i, "state: " + state + ", shown by: " + std::string(how) + list, first);
        return;
    }
}

}  // namespace fastscene::reading
