// Rooms: a sentence becomes a furnished room. Prompt -> PromptReport -> Room.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/room.h"

namespace fastscene {

class FurniturePack;  // pack.h

// What became of a word of the prompt. Articles and prepositions that carried nothing are not listed.
struct PromptWord {
    enum class Fate : unsigned char { understood, approximated, not_understood };
    std::string words;  // as read: lower case, without accents; several when they are one term ("coffee table")
    Fate fate = Fate::understood;
    std::string meaning;    // "object: armchair, color red"; "" when not understood
    int object = -1;        // index into PromptSpec::objects of the piece it speaks of
    bool relation = false;  // says where that piece stands
    bool measure = false;   // says in metres how large that piece, or the room, is
};

inline constexpr const char* kFullHeight = "full height";  // the pattern of windows from the floor to the ceiling

// A piece of the prompt's, or a part of the room's shell (window, wall, floor …).
// Empty text = not said (the room's maker chooses).
struct PromptObject {
    std::string kind;   // canonical class: "armchair"
    std::string words;  // as written
    int count = 1;
    std::string color, material, pattern, size;
    std::string color2;  // "a black and white floor"
    std::string holder_color,
        holder_material;  // of the vase that flowers stand in: "a blue vase with roses"; of a bunk's bedding
    std::string back_color,
        back_material;      // of the wall behind a kitchen's worktop, whose own are the holder's: "marble countertops"
    std::string not_color;  // "not brown": any other, when none is said
    Vec3f size_m;           // width, height, depth that were said, in metres; 0: as such pieces are
    std::string style;      // "an art deco lamp": its own, else the room's
    std::string relation, relation_to;  // "under" "window", a class; optional
    std::string relation_and;           // "between" has two
    bool forbidden = false;             // "no/without X"
    bool counted = false;               // the count was said, not guessed from a plural
    bool in_row = false;                // side by side: "three pictures in a row"
    int id = -1;                        // its index in PromptSpec::objects
    int placed = 0;                     // how many of them stand in the room; filled by make_room
};

// What the prompt asks for, and what became of it.
struct PromptSpec {
    std::string text;
    std::string language;  // "" English, de fr es it
    std::string unread;    // "Dutch": the prompt's language, when it is none of those
    std::string room, style, time, weather, size;
    std::string structure;    // "attic", "loft": the house around a room that serves another end ("an attic study")
    std::string outline;      // "round", "octagon", "apse"; empty: as the room's type has it
    std::string next_room;    // behind a doorway: "a bedroom with an en-suite bathroom"; empty: as the house has it
    Vec3f size_m;             // width, height, depth of the room that were said, in metres; 0: as such rooms are
    float area_m2 = 0;        // its floor, when that was said
    PromptObject everything;  // "everything is pink": color, material of all there is
    std::string mood;         // cozy airy colorful
    std::string light;        // bright dim "lamps on" neon
    std::string light_color;  // of neon: "purple"; empty: pink and blue
    std::string clutter;      // cluttered bare, or empty: nothing but what is named ("only a bed")
    std::string outlook;      // what the windows show: garden city sea mountains forest airfield court
    std::vector<PromptObject> objects;
    std::vector<std::string> colors;  // global accents, bound to no object
    std::vector<std::string>
        accents;  // materials of furniture, bound to no object: "rattan furniture", "leather and brass"
    // The report: written to panorama/prompt.json.
    std::vector<PromptWord> words;     // in the order of the prompt
    std::vector<std::string> assumed;  // "room: living room"
    std::vector<std::string>
        not_placed;  // filled by make_room: "piano: no free wall"; the object's words stand before the colon
    std::shared_ptr<const FurniturePack> pack;  // pieces beyond our own; null: none

    // Whether anything in the prompt shapes the room; "a volcano" does not.
    bool names_a_room() const;
    std::vector<PromptWord> words_with(PromptWord::Fate fate) const;
};

// Throws UsageError for an empty, overlong (> 2000 bytes) or non-UTF-8 prompt; with `strict` also for unknown words.
// With a furniture pack, the names of its catalogue are words too.
PromptSpec understand_prompt(const std::string& text, bool strict, std::shared_ptr<const FurniturePack> pack = nullptr);
// panorama/prompt.json: every word stands in one of understood, approximated, not_placed, not_understood.
Json to_json(const PromptSpec& spec);

// Lays out and furnishes the room; the camera of panorama 0 is the world's origin, at eye height, clear of furniture.
// Fills spec.assumed and spec.not_placed. Deterministic in (spec, run.seed).
Room make_room(PromptSpec& spec, const Run& run);

// The contents of panorama/room.json (objects; visible_pixels from `object_of_pixel`, which may be empty).
Json room_json(const Room& room, const Image<std::int32_t>& object_of_pixel);

}  // namespace fastscene
