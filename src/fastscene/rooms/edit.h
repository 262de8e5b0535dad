// Edits of a room document: things are taken away, moved, added and recolored; all others keep their poses. By steps,
// or by a sentence ("move the armchair to the window, make the sofa green"). docs/room-document.md has examples.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fastscene/rooms/document.h"

namespace fastscene {

struct EditStep {
    enum class Kind : unsigned char {
        remove,   // what stands on it goes as well
        move,     // to `position` and `yaw`; what stands on it moves along
        place,    // moves it to where `wish` says: relation, relation_to
        shift,    // by `by`
        turn,     // by `yaw`
        face,     // turns it towards what `wish` says: relation_to
        swap,     // the first of `ids` and the second change places
        recolor,  // color, material, pattern; on a surface (wall, floor, ceiling, trim) as `surface`
        resize,   // by `factor`: as much of it as there is room for, or `exactly`
        reshape,  // into the shape `value`: round, oval, square, rectangular
        line,     // `ids` side by side with their backs to a wall: `wall`, or that with room for them
        circle,   // `ids` in a circle, or a `value` semicircle, that looks inwards: about `at`, `position`, or
                  // themselves
        rows,     // `ids` in `wish.count` rows that look along `yaw`, about `position` or the middle of the room
        join,     // two tables of `ids` together: side by side, end to end by `value` long, back to
                  // back by facing; about `position`
        space,    // `ids` with even gaps: along their row, or around their table
        add,      // `wish`, where it says, near `position`, or where such things stand
        replace,  // by `wish`, as many as it says, each where one of `ids` stood
        restyle,  // the room, by `value`
        light,    // hour, weather or lamps, by `value`
        shine,    // of `ids`, each what shines: on, off, brighter or darker, by `value`
    } kind = Kind::remove;
    std::vector<std::string> ids;  // of things; none for add, restyle and light
    std::string surface;
    PromptObject wish{};  // what to add; of a move the place, of a recoloring the looks
    // Of a place: the very things that relation_to and relation_and mean; none: any of that kind.
    std::vector<std::string> at{}, at_and{};
    bool slightly = false;            // of a turn to something: some degrees that way
    int wall = -1;                    // … at this wall; of a recoloring, that wall alone
    bool elsewhere = false;           // … not where it is now: another wall, another corner
    bool opposite = false;            // … but at the wall that faces it
    bool each = false;                // add: in as many corners as have room
    bool on_floor = false;            // … and small things there stand on the floor
    bool centered = false;            // … in the middle of its top
    std::optional<Vec2f> position{};  // x, z in the room
    std::optional<float> yaw{};       // radians
    Vec3f by{};                       // metres: as much of it as there is room for, or `exactly`
    bool exactly = false;
    bool about = false;     // of a shift: any way will do that leads about there, as "away from the wall"
    Vec3f factor{1, 1, 1};  // of width, height, depth
    float brighter = 1;     // recolor: the color that it has, so many times as bright
    std::string value;
};

// In place of an id: what was asked for and could not be done.
inline constexpr const char* kNotDone = "not done";

struct EditChange {
    std::string id;    // of a thing, or "room", "wall" …, or kNotDone
    std::string what;  // "moved 1.20 m", "color: green"
};
struct EditResult {
    RoomDocument document;
    std::vector<EditChange> changes;
};

// Throws UsageError for what names nothing or several things (it lists them), Error for what finds no place. The
// document is completed first, so that nothing of it is drawn anew.
EditResult edit_document(const RoomDocument& document, const std::vector<EditStep>& steps,
                         std::shared_ptr<const FurniturePack> pack, const Run& run);
// Clause by clause: each sees what those before it did. What cannot be done is warned of, and among the changes, as
// kNotDone; where nothing can be done at all, it throws.
EditResult edit_by_sentence(const RoomDocument& document, const std::string& sentence,
                            std::shared_ptr<const FurniturePack> pack, const Run& run);

// The things that words mean: "chair-2", "the red armchair at the window", "both nightstands". Throws UsageError for
// none, or for several where one is meant.
std::vector<std::string> things_named(const RoomDocument& document, const std::string& words,
                                      std::shared_ptr<const FurniturePack> pack);
// A color, a material or a pattern in words: "dark green", "velvet". Throws UsageError for other words.
PromptObject looks_named(const std::string& words);

}  // namespace fastscene
