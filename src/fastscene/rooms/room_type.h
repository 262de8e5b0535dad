// Room types: what a room of a kind is like, whatever its style. A type is a file, room_types/NAME.toml.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/rooms/recipe.h"
#include "fastscene/scene/room.h"
#include "fastscene/rooms/style_choices.h"

namespace fastscene {

// Windows, where the prompt does not say how they are.
enum class WindowSize : unsigned char { usual, small, large };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<WindowSize>{"usual", "small", "large"};
// What stands in an opening that is glazed: a window; of cabins also the screen before the driver, and pairs of doors.
enum class Glazing : unsigned char { window, windscreen, folding_doors, sliding_doors };
template <>
inline constexpr std::array<std::string_view, 4> kNamesOf<Glazing>{"window", "windscreen", "folding doors",
                                                                   "sliding doors"};
inline bool is_doors(Glazing g) { return g == Glazing::folding_doors || g == Glazing::sliding_doors; }
// Glazed parts of a cabin's wall that stand at certain places.
struct GlazedPart {
    Glazing glazing = Glazing::windscreen;
    int wall = 0;
    std::vector<float> places;  // of their middles, from 0 at the far end of a side wall to 1; of others: from the left
    float width_m = 0;          // 0: the whole wall
    float sill_m = 0, head_m = 2;
};

struct RoomWindows {
    WindowSize size = WindowSize::usual;
    int count = 0;  // 0: one, or two with second_probability
    float second_probability = 0.45f;
    bool first_on_far_wall = false;       // else at the visitor's right or before him
    float least_sill_m = 0;               // something stands below them
    float sill_beyond_doorway_m = 0.85f;  // where one looks into it through a doorway
    // Regular windows along these walls, in place of all that is said above: one every so many metres.
    bool regular = false;
    std::vector<int> walls;  // empty: there are none
    float every_m = 2.4f, width_m = 1.4f, sill_m = 0.9f, head_m = 2.3f;
    bool arched = false;
    bool round = false;                // portholes, as high as they are wide
    bool glazed = true;                // else open, with columns
    std::optional<Sky::View> outlook;  // what they show; nothing: as the style has it
    float outlook_probability = 0;
    bool tunnel = false;                   // the room is in one: nothing but its wall is seen, and no daylight comes in
    std::vector<GlazedPart> glazed_parts;  // before the regular ones, which stand between them
};

// What walls are built of, where that is more than their material: logs that lie one on the other, rough rock.
enum class WallRelief : unsigned char { flat, logs, rock };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<WallRelief>{"flat", "logs", "rock"};

// What the plan's outline is, beyond a box; an apse is a far end that is a half circle.
enum class Outline : unsigned char { box, octagon, round, apse };
template <>
inline constexpr std::array<std::string_view, 4> kNamesOf<Outline>{"box", "octagon", "round", "apse"};
// The shape of a ceiling that rises from all walls (a dome, over a box a cloister vault; a cone or pyramid) or from the
// walls at its sides (a barrel vault).
enum class Vault : unsigned char { flat, dome, cone, barrel };
template <>
inline constexpr std::array<std::string_view, 4> kNamesOf<Vault>{"flat", "dome", "cone", "barrel vault"};

// Whether a lamp stands on the floor: by day as often as not, and always after dark; after dark only; never.
enum class FloorLamp : unsigned char { usual, after_dark, never };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<FloorLamp>{"usual", "after dark", "never"};

struct MessyThing {
    std::string thing;
    int count = 1;
    bool on_floor = false;  // not on tops
};

// Words that mean another thing in such a room: a "sink" in a bathroom is a washbasin.
struct LocalMeaning {
    std::vector<std::string> words;
    std::string thing;
    bool near = false;  // the nearest thing that there is, not the very thing
};

enum class DoorForm : unsigned char { panelled, flush, glazed, planked, steel, none };
template <>
inline constexpr std::array<std::string_view, 6> kNamesOf<DoorForm>{"panelled", "flush", "glazed",
                                                                    "planked",  "steel", "none"};
struct RoomDoor {
    DoorForm form = DoorForm::panelled;
    float width_m = 0.88f, height_m = 2.06f;  // of all leaves; of a house
    bool arched = false;
    bool middle = false;               // in the middle of its wall, not at an end
    std::optional<Material> material;  // nothing: the style's trim or wood, and what its form is usually made of
};

struct RoomType {
    std::string name, title;              // "living", "living room"
    std::vector<std::string> words;       // of prompts that name it, beside those of the lexicon
    std::vector<std::string> words_near;  // of rooms that are like it: "bistro" for a dining room
    int rank = 0;                         // place among room_types(); the first stands in for unknown ones
    bool wet = false;                     // tiled; no paper, no boards on its ceiling
    bool for_children = false;
    bool deep_paints = false;               // may be painted dark
    std::array<std::string, 2> next_rooms;  // behind a doorway, one as often as the other
    bool next_door = true;                  // may lie behind a doorway that the prompt names
    std::string upstairs;                   // on a mezzanine; empty: more of the same
    std::string second_room;                // "a second room" of no named type is one of these
    std::vector<std::string> styles;        // that suit it; empty: any
    std::string look_at;                    // the thing that the first view looks at
    std::optional<float> look_along;        // it looks along the room to the far wall, from this share of its depth
    bool house = false;                     // other rooms may be in it: "a bedroom in a log cabin"
    std::string kind_of;                    // "kids" is a kind of "bedroom": who names both means one room
    bool sloped_ceiling = false;            // lies below a roof
    bool high_ceiling = false;              // a hall: high, columns, large windows
    bool beams = true;                      // has beams where its style has them
    bool coffers = false;                   // its ceiling may be coffered
    bool panelling = true;                  // its walls may be panelled
    bool accent_wall = true;                // one wall may have a paint of its own
    RoomDoor door;
    bool cabin = false;  // of a vehicle or a lift: thin panels, no skirting, panes in rubber
    float cove_m = 0;    // radius of the curve between its side walls and its ceiling
    Outline outline = Outline::box;
    Vault vault = Vault::flat;
    float rise_m = 0;    // of the vault, from the walls to its top
    float oculus_m = 0;  // radius of the opening at its top
    WallRelief wall_relief = WallRelief::flat;
    bool wall_tiles = false;  // tiles that a prompt names are on its walls
    RoomWindows windows;

    // What its furniture says of it and it of its furniture.
    int guess_rank = 0;                    // order in which types are guessed from things; 0: never
    std::string main_thing;                // stands for it as a part of another room: "a desk" for "an office corner"
    std::string as_thing;                  // what its words mean in a room that is named otherwise: "a staircase"
    std::vector<std::string> thing_words;  // those of its words of which that is true; empty: all
    std::vector<std::string> own_things;   // stand here and hardly anywhere else
    std::string table;                     // what "a table" means
    std::string table_when_near;           // … in a room of `words_near`
    bool cooks = true;                     // kitchen units have a stove
    bool upright_chairs = false;           // a rattan chair is a chair to sit at a table, none to lounge in
    std::vector<LocalMeaning> meanings;
    std::vector<std::string> per_person;  // "a study for two": two of each
    int most_people = 0;
    std::vector<MessyThing> mess{{"clothes_heap", 2}, {"paper_litter"}};  // what lies about where nobody tidies up

    std::string furnished_as;        // a type whose recipe it shares; empty: it has its own
    std::vector<RecipeStep> recipe;  // what stands in it

    float height_low_m = 0, height_high_m = 0;     // 0: as the style has it
    std::optional<Material> floor, wall, ceiling;  // nothing: as the style has them
    bool lived_in = true;                          // plants, baskets, books and vases stand about, as at home
    float width_low_m = 0, width_high_m = 0, depth_low_m = 0, depth_high_m = 0;  // usual inside sizes
    // How often rooms of the type have a feature.
    float breast_probability = 0, corner_probability = 0, bay_probability = 0, alcove_probability = 0,
          doorway_probability = 0;

    std::vector<std::string> pieces;  // what else it takes where its walls are bare, in order
    float pieces_per_m2 = 0;          // on the floor, all together, without clutter
    std::vector<std::string> sills;   // what stands at windows, in this order
    Shelves shelves = Shelves::books;
    float wall_shelf_probability = 0, mirror_probability = 0, clock_probability = 0;
    float picture_probability = 0.8f;  // of each picture
    bool curtains = true, chandeliers = true, radiators = true;
    FloorLamp floor_lamp = FloorLamp::usual;
};

// Throws Error naming file, line and key for what is missing, unknown or out of range.
RoomType read_room_type(std::string_view text, const std::string& file);
// By rank.
const std::vector<RoomType>& all_room_types();
// The first for a name that none has.
const RoomType& room_type(std::string_view name);
const RoomType& default_room_type();
// Null for a name that none has.
const RoomType* find_room_type(std::string_view name);
// Of whom this is one of the things that stand hardly anywhere else.
bool is_own_thing(std::string_view thing, const RoomType& type);
// What stands in a room of this type: its own recipe, or that of the type that it is furnished as.
const std::vector<RecipeStep>& recipe_of(std::string_view type);

}  // namespace fastscene
