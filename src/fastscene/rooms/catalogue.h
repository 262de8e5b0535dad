// The catalogue of things: what is known of each kind of furniture, fixture or decoration, one row a kind.
// The rows stand in catalogue/*.toml; docs/extend/thing.md says what a row holds.
#pragma once

#include <bitset>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

enum class Role : std::uint8_t {
    shell,               // a part of the room itself: wall, window, beams
    opening,             // a hole in a wall: window, door
    countable,           // of the shell: "three windows" are three
    unbuilt,             // understood, but no room is built with one yet
    bed,                 // one sleeps in it
    along_wall,          // a bed whose long side stands at the wall
    framed_bed,          // a bed one climbs into: the color that was said is its frame's
    seat,                // one sits or lies on it: nothing is put there by itself
    easy_chair,          // a seat for one that is no armchair and yet stands where those do
    sofa,                // seats for two and more
    sits_before,         // a seat that may face a piece which it stands before
    work_seat,           // drawn up to a work place
    work_place,          // a chair is drawn up to it
    takes_accent,        // "leather furniture" covers it
    takes_woven_accent,  // "rattan furniture" means it
    lamp_above,          // a lamp above it hangs from the ceiling
    small,               // stands on others or hangs on a wall
    hung,                // hangs where it is asked to: what stands below is placed first
    likely_above,        // "a picture above …": it hangs there
    too_low_below,       // nothing hangs above it
    too_tall_below,      // nothing hangs above it
    no_top,              // nothing stands on it
    blind,               // hangs in windows, in all of them
    ceiling_light,       // lights the room from its ceiling: the usual lamp is left out
    overhead,            // hangs from the ceiling
    light,               // shines
    litter,              // lies about on floors, nowhere in particular
    lies_on_seats,       // small, and needs no table
    soft,                // gives way: what touches it does not cross it
    room_maker,          // what a room keeps even when nobody asked for it
    main_piece,          // aligned with the middle of its wall
    focus,               // sofas look at it
    centerpiece,         // stands free, square to the walls
    at_edges,            // stands near a wall or in a corner
    movable,             // may be taken away to show what was asked for
    moves_out,           // gone from a room that its owner has left
    never_plural,        // "curtains" are one thing
    heap,                // one thing is many: "a stack of books"
    tall,                // one length in metres is its height
    laid,                // takes a cloth and place settings
    vase,                // flowers stand in it
    person,              // people are not drawn
    prefers_model,       // the furniture pack shows it better than our builder does
    in_groups,           // several of them stand on one top
    beside_window,       // takes no floor beside a window that it hangs or stands beside
    garland,             // hung along an edge
    nothing_above,       // hangs at eye height: nothing is hung above it
    on_mantels,          // on a mantel it hangs at the wall above
    under_windows,       // "facing the window": it stands below
    between_beds,        // of a pair of beds and one of these, this stands between
    shows_motif,         // "… of a lion" is what it shows
    climbed,             // a ladder or stairs: of a bunk they are parts
    may_be_round,        // "a round rug": its shape
    pet,                 // may be asleep
    drawn_up,            // asked for before a piece, it is turned to that
    rug_before,          // a rug for it lies before it
    shades_windows,      // too tall to stand near a window
    spread_out,          // lies flat where others work
    before_seats,        // lies on a table before whoever sits there
    covers_wall,         // a part of the wall: what stands before it does not hide it
    roof,                // over a whole room: its box reaches over the walls of a round one
    two_of_them,         // one piece is a pair: "two escalators" are one
    cozy,                // comes where a room that is to be cozier has none
    alike,               // several in a room are bought alike
    count_               // not a role
};

// How likely a thing stands on another in a room of usual clutter.
struct TopHabit {
    std::string thing;
    float probability;
};

struct Thing {
    std::string kind;  // "coffee_table"
    std::bitset<static_cast<std::size_t>(Role::count_)> roles;
    bool built = true;                // has a builder of ours: furniture/*/, build_<kind>
    int nyu40 = 40;                   // NYU Depth v2 label
    float floor_m2 = 0.f;             // floor that a wish for one adds to the room
    std::string style;                // who names no style, but this, means that style
    std::string room;                 // who names no room, but this, means that room
    std::vector<std::string> called;  // in a room whose recipe has one: "counter" in a shop means its checkout
    std::vector<std::string> parts;   // of it that people name as if they stood by themselves: a counter's stove
    std::string small_form;           // what stands in its place on a table or a shelf
    std::string for_child;            // what stands in its place in a child's room
    std::vector<std::string> models;  // of the furniture pack that serve for it, best first
    std::string stand_in;             // the kind of ours that is built when there is no model
    std::vector<TopHabit> on_top;

    bool has(Role role) const { return roles[static_cast<std::size_t>(role)]; }
};

// All rows, in the order of the files.
std::span<const Thing> things();
// Null for a kind that no row is about: the furniture pack has more.
const Thing* find_thing(std::string_view kind);
bool has_role(std::string_view kind, Role role);
std::vector<std::string> kinds_with(Role role);
// What stands in its place on a table or a shelf: "plant_small" of "plant"; itself, where it has no such form.
std::string small_form_of(const std::string& kind);
// Whether a kind is that one in a form of its own: "plant_tree" is a "plant", "pallet_rack" is no "pallet".
bool is_form_of(std::string_view kind, std::string_view plain);

// The names of NYU40's labels (Gupta, Arbelaez and Malik 2013), 0 "outside" to 40 "other prop"; Structured3D and
// ScanNet use the same numbers.
std::span<const std::string_view> nyu40_labels();
// The label of a kind: its row's, else by the words of its name.
int nyu40_label(std::string_view kind);
// Whether NYU40 calls it so.
bool has_nyu40_label(std::string_view kind, std::string_view label);
bool is_curtain(std::string_view kind);  // by its NYU40 label

// A small model of the furniture pack that stands on the floor nevertheless.
bool is_floor_model(std::string_view model);

// A file of the catalogue: its name without ending, its text.
struct CatalogueFile {
    std::string_view name, text;
};
// Throws Error with file, line and row for unknown keys, roles and labels, and for kinds that stand twice or nowhere.
std::vector<Thing> read_things(std::span<const CatalogueFile> files);

}  // namespace fastscene
