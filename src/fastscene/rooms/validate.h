// Validator: what is wrong with a furnished room, found from the layout alone (milliseconds, nothing is rendered).
#pragma once

#include <string>
#include <vector>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/layout_measures.h"

namespace fastscene {

struct Fault {
    std::string
        kind;  // "overlap", "outside", "unsupported", "door", "window", "way", "camera"; of triangles: "crossing"
    std::string text;  // which piece, and what of it
};

// Boxes may share 1 cm before it counts. `camera` is where panorama 0 stands, in the room frame.
std::vector<Fault> room_faults(const Plan& plan, const std::vector<Placed>& placed, Vec3f camera,
                               const Passage& passage = {});
// … where some pieces, by number, are round: what stands at them may reach into the corners of their boxes.
std::vector<Fault> room_faults(const Plan& plan, const std::vector<Placed>& placed, Vec3f camera,
                               const Passage& passage, const std::vector<bool>& round);

// One room of a check over many.
struct CheckedRoom {
    std::string prompt;
    std::uint64_t seed = 0;
    std::vector<Fault> faults;
    LayoutMeasures measures;
};
// What is looked at besides boxes: triangles that reach into others (crossings.h), 0.1 CPU s a room; and the measures
// of a layout (layout_measures.h), half a CPU s.
struct CheckDepth {
    bool triangles = false, measures = false;
};
struct CheckReport {
    int rooms = 0, pieces = 0;
    std::vector<CheckedRoom> faulty;
    LayoutMeasures measures;            // of all rooms
    std::vector<CheckedRoom> measured;  // those of which the measures found something
};
// Furnishes each sentence for `count` seeds from `run.seed` on, and looks for faults.
CheckReport check_sentences(const std::vector<std::string>& sentences, int count, const CheckDepth& depth,
                            const Run& run);
// … "a <style> <room>" for every pair.
CheckReport check_rooms(const std::vector<std::string>& rooms, const std::vector<std::string>& styles, int count,
                        const CheckDepth& depth, const Run& run);

}  // namespace fastscene
