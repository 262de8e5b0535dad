// A sentence as clauses, and what its words mean in a room: things, places, looks.
#pragma once

#include "fastscene/rooms/edit_editor.h"

namespace fastscene::editing {

struct Talk;

// ---- edit_clauses.cc: a sentence as clauses, each with its verb

using Words = std::vector<std::string>;

enum class Verb : unsigned char {
    none,
    remove,
    clear,  // "clear the table": what stands on it goes
    move,
    put,
    make,
    add,
    want,  // "I want a plant", "the sofa should be green": the rest says what is to be done
    replace,
    swap,
    turn,
    face,
    color,
    larger,
    smaller,
    brighter,
    darker,
    tidy,
    center,
    copy,
    kindle,  // "light the candles", "put out the fire"
    quench,
    keep,    // "leave the rug as it is"
    line,    // "line up the chairs along the wall"
    remark,  // "the chairs don't match": what follows says what is to be done
    refuse,  // understood, and nothing that a sentence does
};
struct Clause {
    Verb verb = Verb::none;
    std::string said;  // the verb's word
    Words words;
    bool there = false;       // it ended with "there", "in its place"
    bool its_place = false;   // it ended with "in its place"
    bool taken_back = false;  // what follows is said in place of it
    bool otherwise = false;   // "or replace it": only where the clause before it could not be done
    bool amends = false;      // "no, blue": the clause before it, with these words
};
std::vector<Clause> clauses_of(const std::string& sentence);

// ---- edit_clause_pairs.cc

// "everything but the sofa", "all pictures but the largest one"
bool says_all(const Words& words);
// Where words take back what was said before, past them; 0: none do.
std::size_t taken_back_at(const Words& words, std::size_t at);
// Those that say one thing become one; what is taken as a remark becomes one.
void join_clauses(std::vector<Clause>& clauses);

// ---- edit_clauses.cc

std::string text_of(const Words& words, std::size_t from = 0, std::size_t to = std::string::npos);
Words part_of(const Words& words, std::size_t from, std::size_t to = std::string::npos);
Words joined_words(Words first, const Words& second);
bool is_joint(const std::string& word);     // a comma, "and" …
bool is_definite(const std::string& word);  // "the", "my" …
bool begins_anew(const Words& words);       // "a plant", "two chairs", "another lamp", "books": none of those there
// What stands between joints. "Between the bed and the window" is one.
std::vector<Words> parts_of(const Words& words);
std::optional<float> number_said(const std::string& word);  // "3", "two", "half"

// ---- edit_beginnings.cc

struct Beginning {
    Words words;
    Verb verb;
};
// The longest that stands there; null: none.
const Beginning* beginning_at(const Words& words, std::size_t at);
// Whether they begin with what is to be done: "move", "get rid of".
bool begins_clause(const Words& words);
// Behind "please", "could you".
std::size_t past_polite(const Words& words, std::size_t at);
bool stands_at(const Words& words, std::size_t at, std::string_view phrase);

// ---- edit_phrases.cc

// "Apart from the vase" as "except the vase", "a tad" as "a bit".
Words in_plain_words(Words words);
std::string stem_of_gerund(const std::string& word);  // "move" of "moving"; empty: no clause begins so

// ---- edit_corrections.cc

// How many words at `at` say that what was said before is taken back, with the marks behind them; 0: none do.
// `begins_clause`: what follows them has a verb of its own.
std::size_t correction_at(const Words& words, std::size_t at, bool begins_clause);
// "Two chairs" and "three" are three chairs.
Clause amended(const Clause& before, const Clause& anew);
// Nothing of it is done; what it named is "it".
void take_back(Talk& talk, const Clause& clause);

// ---- edit_words.cc: which things of the room words mean

std::string singular(const std::string& word);  // "chair" of "chairs"; edit_nouns.cc
// The words as a prompt about such a room.
PromptSpec read_in_room(const Editor& editor, const std::string& words);
std::vector<int> called_in_full(const Editor& editor, const Words& head, PromptObject& said);  // edit_nouns.cc
// All that they may mean; none if nothing is like it.
std::vector<int> all_named(const Editor& editor, const std::string& words);
bool says_several(const Words& words, const PromptObject& said);  // "all chairs", "both"
// Throws UsageError for none, or for several where one is meant.
std::vector<std::string> named(const Editor& editor, const std::string& words);
[[noreturn]] void refuse_shell();
// "The table near the door", where none is close to it: the nearest, or so many.
void nearest_to(const Editor& editor, const std::string& kind, std::vector<int>& found, std::size_t count);

// ---- edit_pick.cc

// "the second chair", "the last one", "the left nightstand", "the larger plant".
void pick(const Words& words, const PromptObject& said, const Editor& editor, std::vector<int>& found);
// Those that were said to look so; where nobody said how they look, the one that looks most like it.
void with_looks(const PromptObject& said, const Editor& editor, std::vector<int>& found);

// ---- edit_which.cc: by distance; none, or several

// "The table closest to the door", "the two chairs farthest from the window"; nothing: no such words.
std::optional<std::vector<int>> by_distance(const Editor& editor, const Words& words);

// ---- edit_rows.cc

// "The last row of desks", "the chairs in the front two rows"; nothing: no such words. Throws UsageError where nobody
// could tell which row.
std::optional<std::vector<int>> in_rows(const Editor& editor, const Words& words);

// ---- edit_carried.cc

// "The chairs at the ends of the table"; nothing: no such words.
std::optional<std::vector<int>> at_ends_of_table(const Editor& editor, const Words& words);
// "The chairs on the window side of the table"; nothing: no such words.
std::optional<std::vector<int>> on_side_of_table(const Editor& editor, const Words& words);

// "The tables that don't have a candle", "the shelf with books": by what stands on them; nothing: no such words.
std::optional<std::vector<int>> by_what_they_carry(const Editor& editor, const Words& words);

// ---- edit_which.cc

// "which chair? chair-1 by desk-1, chair-2 at the door"
[[noreturn]] void refuse_many(const std::string& words, const Editor& editor, const std::vector<int>& found);
bool is_viewpoint(const std::string& word);  // where the room is seen from, which is no thing
// With the few that are most like it: of its class, or the largest.
[[noreturn]] void refuse_none(const std::string& words, const Editor& editor, const std::string& kind);

// ---- edit_compounds.cc: "the desk lamp", "the table"

// Of what words of several nouns mean, those that stand where the first of them says: the lamps on the desk.
void at_support(const Editor& editor, const Words& words, std::vector<int>& found);
// Of several, those on the left or the right side of a thing as the camera sees it; false: the words say no such place.
bool beside_as_seen(const Editor& editor, const PromptObject& where, std::vector<int>& found);
// Of those found, the ones that stand as `relation` says at those very things.
void at_anchors(const Editor& editor, const std::string& relation, const std::vector<int>& anchors,
                std::vector<int>& found);
// What "the coffee table books" are, where the lexicon has no such word: books on a coffee table.
std::vector<int> compound_named(const Editor& editor, const Words& words);
// Where "a desk lamp", "a bedside lamp" comes to stand; nothing: the words name no such thing.
std::optional<EditStep> on_support(const Editor& editor, const Words& words);
// Of several of different kinds, the one that "the table" means in such a room; none: nobody could tell.
std::vector<int> main_of(const Editor& editor, const std::vector<int>& found);

// ---- edit_remarks.cc, by edit_sentence.cc: what is said beside what is to be done, and what was not done as it was
// said

void remark(Talk& talk, const Words& words);
void keep(Talk& talk, const Words& words);
void check_kept(const Talk& talk, const RoomDocument& before);
// Throws UsageError for what only something quite different stands for: a piano for a keyboard.
void check_stand_in(const PromptObject& wish);
// Of what came by these words: what stands in for something else, and which words nothing shows.
void tell_unshown(Talk& talk, const std::vector<std::string>& ids, const PromptObject& wish, const Words& words);
bool done_with(Talk& talk, const Clause& clause);
// "the table with plates and candles" -> "plates and candles on the table"; nothing: no such words.
std::optional<Words> laid_with(const Talk& talk, const Words& words);
// "the chairs along the wall", "the plants under the window"
void line_up(Talk& talk, const Words& words);

// ---- edit_walls.cc: "the wall behind the bed"

// Whether words mean one wall and not all.
bool is_one_wall(const Words& words);
// Its number; throws UsageError where nobody could tell which.
int wall_meant(const Editor& editor, const Words& words, const std::vector<std::string>& spoken);
// That of the openings of this kind; several walls: nobody could tell.
std::optional<int> wall_with(const Plan& plan, const std::string& kind);
bool is_tiled(const Material& m);
// "the tiles": floor, wall; throws UsageError where both are tiled, or none.
std::string tiled_surface(const Editor& editor);

// ---- edit_place_words.cc: the words of places

struct Relation {
    std::string name;
    std::size_t next = 0;  // where the words of its place begin
};
std::optional<Relation> relation_at(const Words& words, std::size_t at);
// "the far left corner", "another wall", "the window": a part of the room.
struct Part {
    std::string noun;  // corner, middle, wall, side, floor, ceiling, window, door, doorway, room
    Words modifiers;
    std::size_t next = 0;

    bool says(std::initializer_list<std::string_view> any) const {
        return std::any_of(modifiers.begin(), modifiers.end(),
                           [&](const std::string& w) { return std::find(any.begin(), any.end(), w) != any.end(); });
    }
    bool is_other() const { return says({"other", "another", "different", "opposite"}); }
};
std::optional<Part> room_part(const Words& words, std::size_t at);
std::string noun_of(const std::string& word);  // "corner", "wall", "window" …; empty: no part of a room
// "In front of the window so that I look outside": the place, and what is faced there; no target: no such words.
std::pair<Words, Words> place_and_view(const Words& part);
// Where a place's words begin, from the second word on; the number of words: nowhere.
std::size_t next_place(const Words& words, std::size_t from = 1);

// ---- edit_anchors.cc

// The things at which a place is, and their kind.
struct Anchor {
    std::string kind;
    std::vector<std::string> ids;  // none: any of the kind
};
std::string kind_of(const DocumentThing& t);  // as it was asked for
bool is_table(const std::string& kind);
bool is_sat_at(const std::string& kind);  // a table or a desk, and neither seat nor bed
bool carries(const Placed& p);
// Whether something can be so at it: "around" tables, "on" what carries.
bool fits(const std::string& relation, const Placed& there);
// What "to" and "at" mean there: a vase goes onto a table, a chair up to it.
std::string suited(const std::string& relation, const std::string& kind, const Placed& there);
// Of the things that the words of a place may mean, those of one kind: what suits the relation, else the largest.
std::vector<int> of_one_kind(const Editor& editor, std::vector<int> found, const std::string& relation);
Anchor anchor_of(const Editor& editor, std::vector<int> found, const std::string& relation);

// "The other desk": not that at which the mover stands.
std::vector<std::string> all_but_nearest(const Editor& editor, const std::string& kind, const std::string& mover);
// Of things so called the only one that has none of a kind, on it or at it: its id. Throws UsageError where it is not
// one.
std::string lacking_one(const Editor& editor, const Words& noun, const std::string& kind);

// ---- edit_room_parts.cc: parts of the room as the camera sees them

// Left, right, far or near; nothing: none was said.
std::optional<Vec3f> direction_said(const Editor& editor, const Part& part);
int wall_towards(const Plan& plan, Vec3f direction);
std::vector<Vec2f> corners_of_room(const Plan& plan);
bool has_opening(const Plan& plan, const std::string& kind);
// A doorway is called a door, too. Throws UsageError where there is none.
std::string opening_there(const Plan& plan, const std::string& kind);
// "The left window", "the far door", of several: a point before it.
std::optional<Vec2f> which_opening(const Editor& editor, const Part& part, const std::string& kind);
// Before the middle of the nearest such opening, a step off its wall, for what stands on the floor without a back.
std::optional<Vec2f> before_opening(const Editor& editor, const std::string& kind, const std::string& mover);
// Of the two corners that lie that way, the one with more free floor before it.
Vec2f freer_corner(const Editor& editor, Vec2f way, const std::string& mover);
// Of two corners that are about as near to a point, the one with more free floor before it; else the point.
Vec2f freer_of_two_corners(const Editor& editor, Vec2f near, const std::string& mover);
// Where it would be on the other side of the nearest such opening.
std::optional<Vec2f> beyond_opening(const Editor& editor, const std::string& kind, const std::string& mover);
// "The brick wall": the one that looks so; nothing: all do, or it was not said how it looks.
std::optional<int> wall_that_looks(const Plan& plan, const Part& part);

// ---- edit_places.cc: where words say

// A place's steps: relation, relation_to, at, wall …; nothing where the words are no place. `thing`: what is to stand
// there, the first of its kind or a new one.
struct Place {
    EditStep step;
    std::vector<std::vector<std::string>> each_at;  // "on both nightstands": one at each
    bool if_uncounted = false;  // … unless it was said how many: "candles to the tables", but "two candles"
    bool each_wall = false;     // "on each wall"
    int count = 0;              // "at each end": two; 0: as many as were said
};
// `mover`: the id of what is to move there; empty: it comes new. `spoken`: what "it" and "them" are.
std::optional<Place> place_of(const Editor& editor, const Words& words, const std::string& kind,
                              const std::string& mover, const std::vector<std::string>& spoken = {});
Mount mount_of(const Editor& editor, const std::string& kind);
// The things that a place is at.
std::vector<std::string> things_at(const Editor& editor, const EditStep& place);
// Takes "50 cm", "half a meter" out of the words: metres.
std::optional<float> take_length(Words& words);
// "50 cm to the left", "closer to the window": by how much things are to be moved.
std::optional<EditStep> shift_of(const Editor& editor, const Words& words, const std::string& id);

// ---- edit_values.cc: how words want things to be

struct Value {
    PromptObject looks;  // color, material, pattern
    Vec3f factor{1, 1, 1};
    Vec3f by{};  // metres
    float brighter = 1;
    bool exactly = false;             // "twice as large", "20 percent", "10 cm": that or nothing
    std::string shape;                // round oval square rectangular
    bool shines = false;              // "brighter", "dimmer": of lamps that is their light
    bool length = false;              // "longer", "shorter": of what is taller than wide that is its height
    std::vector<std::string> near{};  // words that have only something like them: "suede"
    bool resizes() const { return !(factor == Vec3f{1, 1, 1}) || !(by == Vec3f{}) || !shape.empty(); }
};
// Nothing unless all the words are looks or sizes.
std::optional<Value> value_of(const Words& words);
std::string comparative_of(const std::string& word);  // "longer" of "long"; empty: no word of size
// "tall", "low", "narrow" before a noun: of a new thing's usual width, height and depth; 1: no such word.
Vec3f usual_factor(const Words& words);
// "round", "a square shape"; empty: no shape.
std::string shape_said(const Words& words);
// "green", "light blue and white": nothing unless all are looks.
std::optional<PromptObject> looks_of(const std::string& words);

// ---- edit_where.cc
// Whether a thing is where its wish says, as people mean it.
bool is_where_asked(const Plan& plan, const std::vector<Placed>& all, const Placed& piece, const PromptObject& wish);
// At the wall below a window, and not beside that or a step before it: half of what is narrower is before the other.
bool is_below(const Footprint& box, const Footprint& window);
// What is wished for under a window stands below one; true for any other wish.
bool is_below_its_window(const Plan& plan, const std::vector<Placed>& all, const Placed& piece,
                         const PromptObject& wish);
// Beyond the short side of what the wish is at.
bool is_at_an_end(const std::vector<Placed>& all, const PromptObject& wish, Vec2f at);
// What is wished for in front of an opening stands before it, and not a step beside it; true for any other wish.
bool is_before_its_opening(const Plan& plan, const std::vector<Placed>& all, const Placed& piece,
                           const PromptObject& wish);
// ---- edit_search.cc
// The wall that is at a thing's back; -1: none.
int wall_behind(const Plan& plan, const Placed& p);
inline constexpr float kOffMiddle_m = 0.7f;  // further off the middle between two, it stands beside both of them
// How far a point is from the middle between two things that a place is said by, other than `own`; +inf: there are
// none.
float off_middle(const std::vector<Placed>& all, const PromptObject& wish, Vec2f at, const Placed* own = nullptr);
// The boxes of what a place is said by: things, or openings as thin boxes.
std::vector<Footprint> anchors_of(const Plan& plan, const std::vector<Placed>& placed, const std::string& kind);
// Things that are larger all around, so that what is further off is at them still.
std::vector<Placed> grown(std::vector<Placed> all, const PromptObject& wish, float by);
// ---- edit_hang.cc
// From the ceiling above a thing: its middle, else along it.
bool hang_above(Layout& layout, const PromptObject& wish);
// ---- edit_swap.cc
// Where another stood; `on`: what carried that, in the layout. `aside`: metres along it.
std::optional<int> take_place(Layout& layout, const PieceRequest& request, const PromptObject& wish,
                              const Placed& place, int on, float aside);
// ---- edit_shapes.cc
// round, oval, square or rectangular; empty: none of those.
std::string shape_of(const Piece& piece);
// Which of them are round tables.
std::vector<bool> round_ones(const std::vector<Placed>& all);

}  // namespace fastscene::editing
