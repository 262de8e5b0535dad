// Rooms: a sentence becomes a furnished room. Prompt -> PromptReport -> Room.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// One piece of the prompt that was understood, and as what.
struct Understood {
    std::string words;    // as written
    std::string meaning;  // "object: armchair (color red)"
};

// What the prompt asks for. Empty text = not said (the room's maker chooses and reports it as assumed).
struct PromptObject {
    std::string klass;      // canonical class: "armchair"
    std::string words;      // as written
    int count = 1;
    std::string color, material, pattern, size;
    std::string relation, relation_to;  // "under" "window"; optional
    bool forbidden = false;             // "no/without X"
};
struct PromptSpec {
    std::string text;
    std::string room, style, time, weather, mood, size;
    std::vector<PromptObject> objects;
    std::vector<std::string> colors;    // global accents, bound to no object
    // The report: written to panorama/prompt.json.
    std::vector<Understood> understood;
    std::vector<std::string> assumed;        // "room: living room"
    std::vector<std::string> approximated;   // "chesterfield -> sofa"
    std::vector<std::string> not_placed;     // filled by make_room: "piano: no free wall"
    std::vector<std::string> not_understood; // words as written
};

// Throws UsageError for an empty, overlong (> 2000 bytes) or non-UTF-8 prompt; with `strict` also for unknown words.
PromptSpec understand_prompt(const std::string& text, bool strict);
Json to_json(const PromptSpec& spec);

// Lays out and furnishes the room; the camera of panorama 0 is the world's origin, at eye height, clear of furniture.
// Fills spec.assumed and spec.not_placed. Deterministic in (spec, run.seed).
Room make_room(PromptSpec& spec, const Run& run);

// The contents of panorama/room.json (objects; visible_pixels from `object_of_pixel`, which may be empty).
Json room_json(const Room& room, const Image<std::int32_t>& object_of_pixel);

}  // namespace fastscene
