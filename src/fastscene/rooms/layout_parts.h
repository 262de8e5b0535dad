// What the layout_*.cc files that furnish rooms share: facts about things, and the prompt's wishes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/layout.h"

namespace fastscene::furnishing {

// Things that stand on others or hang on walls: whoever asks for one at a piece wants it there, not anywhere.
bool is_small(std::string_view kind);
bool lies_about(std::string_view kind);     // on floors, nowhere in particular: clothes, paper, rubble
bool lies_on_seats(std::string_view kind);  // small things that need no table
// Whether a lamp above such a piece hangs from the ceiling.
bool hangs_over(std::string_view kind);
// What one sits or lies on: nothing is put there by itself.
bool is_seat(std::string_view kind);
// "a wall mounted TV": above its stand, not on it.
bool is_hung_screen(const PromptObject& wish);
// Blinds and shutters: they hang in windows, in all of them.
bool is_blind(std::string_view kind);
// What lights a room from its ceiling when it was asked for: the usual lamp is left out.
bool lights_from_above(std::string_view kind);

// What stands in a child's room in place of what grown-ups like to see.
std::string_view for_a_child(std::string_view thing);
// A picture's motif for such a room; empty: any.
std::string picture_for_a_child(Layout& layout);

// A wish and where it binds: the place it names, put the way the layout works (a table "on the rug" is a rug under the
// table).
struct Ask {
    const PromptObject* wish = nullptr;
    std::string relation, at, and_at;  // empty: anywhere. `at`: a class, or a part of the shell
    int left = 0;                      // how many are still to be placed

    bool at_piece() const;  // at something that is itself placed
    bool at_shell() const;  // at a window, a door, in a corner …
};

// Whether the room leaves this class to the prompt: it said none, or how many ("two plants" closes plant_tree and
// plant_small too).
bool is_settled(const PromptSpec& spec, std::string_view kind);

inline bool is_beside(std::string_view relation) {
    return is_one_of(relation, {"next to", "left of", "right of", "on both sides of"});
}

// While it lives, pieces stand where this wish says or not at all.
class Insisting {
  public:
    Insisting(Layout& layout, const PromptObject& wish) : l_(layout) { l_.insist(&wish); }
    ~Insisting() { l_.insist(nullptr); }
    Insisting(const Insisting&) = delete;
    Insisting& operator=(const Insisting&) = delete;

  private:
    Layout& l_;
};

// The prompt's wishes, used up one by one.
class Wishes {
  public:
    explicit Wishes(const PromptSpec& spec);

    bool forbids(std::string_view kind) const;
    // The next wish of this class that binds nowhere, taken; null: there is none.
    const PromptObject* next(std::string_view kind);
    void give_back(const PromptObject* wish);
    // How many of this class are still to be placed, bound or not.
    int count(std::string_view kind) const;
    bool has(std::string_view kind) const { return count(kind) > 0; }
    bool asked(std::string_view kind) const;  // placed or not
    std::vector<Ask>& asks() { return asks_; }

  private:
    const PromptSpec& spec_;
    std::vector<Ask> asks_;
};

// Units along the first wall that has room for them, as long as fit. `beside_m`: where there is room, so much stays
// free at one of their ends.
std::optional<int> kitchen_units(Layout& layout, PieceRequest request, const PromptObject& wish, float beside_m = 0);
// Beside the other monitors at the back of a desk, the outer ones turned to who sits there.
std::optional<int> next_screen(Layout& layout, int desk, const PieceRequest& request, const PromptObject& wish);
// On the wall above its stand; smaller where that has a window beside it.
std::optional<int> screen_above(Layout& layout, int stand, const PieceRequest& request, const PromptObject& wish);

}  // namespace fastscene::furnishing
