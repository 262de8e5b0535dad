// Checks a sentence against the rooms before and after it: by its words and by what stands where, independently of the
// code that carried it out. What is not true is reported.
#pragma once

#include <string>
#include <vector>

#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {

// A thing as it can be seen.
struct Shown {
    DocumentThing thing;
    Footprint box;
    Mount mount = Mount::floor;
    bool flat = false;
};
// The room at some time of the sentence.
struct Snapshot {
    std::vector<Shown> things;
    DocumentSurfaces surfaces;
    DocumentLight light;
    std::string style;
    std::size_t changes = 0;          // that were told
    std::vector<std::string> spoken;  // what "it" and "them" are

    const Shown* find(const std::string& id) const;
};
Snapshot snapshot_of(const Talk& talk);

// ---- edit_mentions.cc: the words of a clause that name something

struct Mention {
    enum class Kind : unsigned char { thing, part, look, relation, pronoun, unknown } kind = Kind::thing;
    std::size_t from = 0, to = 0;  // of the words
    std::string term;              // "red", "chairs", "next to"
    std::string meaning;           // the canonical class, part or relation
};
std::vector<Mention> mentions_in(const Words& words);
bool is_called(const DocumentThing& thing, const Mention& mention);

// ---- edit_holds.cc

// What a relation is to: a thing, or an opening of the wall.
struct Landmark {
    Footprint box;
    std::string id;  // empty: an opening
    bool flat = false;
    int opening = -1;
};
std::vector<Landmark> landmarks_called(const Editor& editor, const Snapshot& room, const Mention& mention);
Landmark landmark_of(const Shown& shown);
// Whether people would say so. `slack`: metres further off than usual.
bool holds_at(const Shown& shown, const std::string& relation, const Landmark& at, float slack = 0);
bool holds_in_room(const Plan& plan, const Shown& shown, const std::string& relation);
bool is_between_those(const Shown& shown, const std::vector<Landmark>& some, const std::vector<Landmark>& others);
float apart(const Shown& shown, const Landmark& at);  // metres between their edges

// ---- edit_audit.cc

// Tells what of a clause that was done cannot be seen.
void audit(Talk& talk, const Clause& clause, const Snapshot& before);

}  // namespace fastscene::editing
