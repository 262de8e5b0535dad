// What the edit*.cc files share.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/rooms/edit.h"
#include "fastscene/rooms/layout_ways.h"

namespace fastscene::editing {

inline constexpr const char* kAtTheEnds = "at the ends of";  // a relation of seats and tables

std::string in_words(std::string kind);  // "coffee_table" -> "coffee table"

// ---- edit_candidates.cc
// A place on the floor.
struct Candidate {
    Vec2f at;
    float yaw = 0;
    float cost = 0;
    float off = 1e9f;  // metres from what it was asked at
};
bool is_rug(const Piece& piece);
// Left or right of a thing is beside it, not before it.
bool is_beside(const std::vector<Placed>& all, const Placed& piece, const PromptObject& wish);
// By a bed, along its foot, where nightstands do not stand.
bool is_at_foot(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p);

// ---- edit_squeeze.cc
// What is given up for a place.
struct Squeeze {
    bool narrow = false;  // ways are kNarrow
    float scale = 1;      // of its usual size
    float further = 0;    // metres further off what it was asked at
    bool pushes = false;  // small things move aside
};
inline constexpr float kLeastSeat = 0.8f;  // of its usual size: smaller, nobody can sit on it
inline constexpr Passage kNarrow{.body_radius = 0.225f, .eye_radius = 0.45f};  // a way of 0.45 m
std::vector<Squeeze> squeezes(bool may_shrink);
// What stands, what came last, and the room's things that were moved for it.
struct Squeezed {
    std::vector<Placed> all;
    std::vector<int> pushed;
    float off = 0;  // metres from what it was asked at
};

// A document while it is edited, with its room. edit.cc; poses in edit_poses.cc, places in edit_layout.cc,
// exchanges in edit_exchange.cc.
class Editor {
  public:
    Editor(const RoomDocument& document, std::shared_ptr<const FurniturePack> pack, const Run& run);

    void apply(const EditStep& step);
    const RoomDocument& document() const { return result_.document; }
    const DocumentRoom& room() const { return room_; }
    const Plan& plan() const { return room_.furnished.plan; }
    const std::shared_ptr<const FurniturePack>& pack() const { return pack_; }
    const EditResult& result() const { return result_; }
    // Tells what was not done as it was said.
    void note(const std::string& id, const std::string& what) { tell(id, what), ++notes_; }
    // How many changes there are beside what was only told.
    std::size_t deeds() const { return result_.changes.size() - notes_; }
    int index_of(const std::string& id) const;
    const Placed& placed(const std::string& id) const;
    Vec3f usual_size(const PromptObject& wish) const;     // of such a thing, were it new; 0: there is none
    std::string color_seen(const std::string& id) const;  // by name, else "#rrggbb"
    // Square to the room, towards what words mean from where things stand: radians. edit_grid.cc.
    float way_to_face(const std::vector<std::string>& ids, const std::vector<std::string>& target) const;
    // All of it, or nothing.
    void together(const std::function<void()>& change);
    // With all that stands on them.
    std::vector<int> with_riders(const std::vector<int>& roots) const;

  private:
    struct Pose {
        Vec3f position;
        float yaw = 0;
    };
    // What stands without some of it, and which of the room's things each one is.
    struct Standing {
        std::vector<Placed> placed;
        std::vector<int> was, now;
    };

    // What is wished for, and what stands: the very things that a place means bear a name of their own.
    struct Asked {
        PromptSpec spec;
        std::vector<Placed> among;
    };

    void build();
    void tell(const std::string& id, const std::string& what);
    DocumentThing& thing(int index) { return result_.document.things[static_cast<std::size_t>(index)]; }
    const Placed& placed(int index) const { return room_.furnished.placed[static_cast<std::size_t>(index)]; }
    std::string new_id(const std::string& kind) const;

    // ---- edit_poses.cc
    void set_pose(int index, Pose pose, const std::vector<int>& along);
    void tell_pose(int index, Vec3f from);
    void checked(const std::function<void()>& change, const Passage& passage = {});
    std::string new_fault(const std::vector<Placed>& all) const;
    std::vector<Placed> with_pose(int index, Pose pose, const std::vector<int>& along) const;
    std::vector<int> seats_at(int table) const;
    // Whether those have room where they go with it.
    bool seats_clear(int table, const Placed& there, const std::vector<int>& seats,
                     const std::vector<int>& along) const;
    std::optional<Vec2f> target_of(const EditStep& step, int from) const;
    void move(const EditStep& step);
    bool turned_aside(int index, float turn, const std::vector<int>& along);
    void shift(const EditStep& step);
    void shift_one(int index, const EditStep& step);
    void turn_one(int index, const EditStep& step);
    void face(const EditStep& step);
    void face_one(int index, const EditStep& step);
    void resize(const EditStep& step);
    void resize_one(int index, Vec3f factor, bool exactly);
    std::string resize_to(int index, Vec3f factor);
    void keep_seats(int index, const Placed& before);
    void carry_riders(int index, const Placed& before, Vec3f factor);

    // ---- edit_layout.cc
    Standing without(const std::vector<int>& gone) const;
    std::vector<Placed> laid_out(const Standing& standing, const EditStep& step, const Placed* moving,
                                 bool finely = false) const;
    Asked asked_among(const Standing& standing, const EditStep& step) const;
    Layout begin_layout(PromptSpec& spec, Random& rng, const std::vector<Placed>& standing, const Placed* moving) const;
    bool at_a_wall(Layout& layout, const EditStep& step, const Placed* moving) const;
    bool near_a_point(Layout& layout, const EditStep& step) const;

    // ---- edit_why.cc
    std::string why_none_added(EditStep step) const;
    // ": it takes 1.60 x 0.60 m, and wardrobe-1 is in the way"; `gone`: what is moved there. Empty: nobody could tell.
    std::string what_is_missing(const EditStep& step, const Placed* moving, const std::vector<int>& gone) const;
    std::vector<std::string> fewest_in_the_way(const EditStep& step, const Placed* moving,
                                               const std::vector<int>& gone) const;

    // ---- edit_place.cc
    void place(const EditStep& step);
    void place_with_seats(int index, const EditStep& step);
    void tell_distance(const std::string& id, const EditStep& step);
    void bring_seats(int table, const std::vector<int>& seats);
    void place_one(int index, const std::vector<int>& along, EditStep step);
    void stand_at_found(int index, const Placed& found, const Standing& standing, const EditStep& step,
                        const std::vector<int>& along);

    // ---- edit_layout.cc
    std::vector<Placed> with_added(const EditStep& step, bool& smaller) const;
    void add(const EditStep& step);
    void tell_aside(const std::string& id, const EditStep& step);
    // `how` it came, each its own way or all alike.
    std::vector<std::string> admit(const std::vector<Placed>& all, const Standing& standing,
                                   const std::vector<std::string>& how);

    // ---- edit_search.cc
    std::vector<Candidate> candidates_for(Layout& layout, const EditStep& step, const Piece& piece,
                                          float further) const;
    bool search_finely(Layout& layout, const EditStep& step) const;
    bool at_the_ends(Layout& layout) const;
    bool seats_in_row(Layout& layout) const;
    bool in_the_middle(Layout& layout, const EditStep& step, const Placed* moving) const;
    bool on_the_floor(Layout& layout, const EditStep& step) const;
    bool hang_behind(Layout& layout) const;
    bool stands_clear(int index, const Footprint& box, const std::vector<int>& along) const;

    // ---- edit_squeeze.cc
    // The first place that `accepts` takes.
    std::optional<Squeezed> squeezed_in(const Standing& standing, const EditStep& step, const Placed* moving,
                                        const Squeeze& how, const std::function<bool(const Squeezed&)>& accepts) const;
    std::optional<Squeezed> squeezed_on_wall(Layout& layout, const EditStep& step, const Placed* moving,
                                             const Squeeze& how,
                                             const std::function<bool(const Squeezed&)>& accepts) const;
    std::optional<Squeezed> squeezed_on_top(Layout& layout, const Placed* moving) const;  // edit_tops.cc
    std::set<std::string> fault_texts(const std::vector<Placed>& all, const Passage& passage = {}) const;
    bool place_squeezed(int index, const EditStep& step, const std::vector<int>& along);
    bool add_squeezed(const EditStep& step);
    void make_way(const Squeezed& found, const std::string& whom);
    void tell_squeeze(const std::string& id, const EditStep& step, const Squeezed& found, const Squeeze& how);

    // ---- edit_nearer.cc
    bool hang_in_row(Layout& layout) const;
    bool on_flat(Layout& layout) const;
    bool on_top_beside(Layout& layout) const;
    bool on_top_at_wall(Layout& layout, int wall) const;
    bool stand_near(Layout& layout, const EditStep& step) const;
    bool bring_nearer(Layout& layout, const EditStep& step, std::size_t before) const;
    void line_up(const EditStep& step);
    bool add_into_row(const EditStep& step);
    void tell_missing_corners(const EditStep& step, std::size_t added);
    void check_no_pair(const EditStep& step) const;

    // ---- edit_arrange.cc
    void encircle(const EditStep& step);
    void space_out(const EditStep& step);
    void space_seats(int table, const std::vector<int>& seats);
    void space_in_row(const std::vector<int>& all);
    void set_poses(const std::vector<int>& things, const std::vector<Pose>& poses, const std::string& already);

    // ---- edit_grid.cc
    void in_rows_of(const EditStep& step);

    // ---- edit_shapes.cc
    void reshape(const EditStep& step);
    void reshape_one(int index, const std::string& shape);
    void gather_about(int index, const Placed& before, const std::vector<int>& seats, float further);

    // ---- edit_swap.cc
    void swap(const EditStep& step);
    void swap_two(int a, int b, const std::vector<int>& with_a, const std::vector<int>& with_b, bool nearby);
    std::optional<Placed> in_its_place(Standing& among, const Placed& p, const Placed& place, bool nearby,
                                       std::vector<Squeezed>& pushed) const;

    // ---- edit_exchange.cc
    void replace(const EditStep& step);
    std::vector<Placed> in_place_of(const std::vector<Placed>& all, const Standing& standing, const EditStep& step,
                                    const Placed& old, int nth, int here) const;
    void set_down(const std::vector<std::pair<std::string, int>>& riders, const std::vector<std::string>& onto);

    // ---- edit.cc
    void take(const std::vector<std::string>& ids);
    void recolor(const EditStep& step);
    void recolor_surface(const EditStep& step, const std::string& said);
    void recolor_wall(int wall, const EditStep& step, const std::string& said);
    void restyle(const std::string& name);
    void light(const std::string& value);  // edit_light.cc
    void brighten(bool more, bool lamps_alone);
    void shine(const EditStep& step);

    std::shared_ptr<const FurniturePack> pack_;
    Run run_;
    EditResult result_;
    DocumentRoom room_;
    std::size_t notes_ = 0;
};

// " next to bed-1", " at a wall"; empty: it was not said where.
std::string place_in_words(const EditStep& step);

// Does some things one after the other. What cannot be done, or is so already, is told; where nothing else is done, it
// is thrown. `words`: what was said of each, if that is to be told with it.
void do_each(Editor& editor, std::size_t count, const std::function<void(std::size_t)>& act,
             const std::function<std::string(std::size_t)>& words = {});

// What was asked for is so without any change: another part of the sentence may do something.
class AlreadySo : public Error {
  public:
    explicit AlreadySo(const std::string& what) : Error("{}", what) {}
};

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

std::string singular(const std::string& word);  // "chair" of "chairs"
// The words as a prompt about such a room.
PromptSpec read_in_room(const Editor& editor, const std::string& words);
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
bool carries(const Placed& p);
// Whether something can be so at it: "around" tables, "on" what carries.
bool fits(const std::string& relation, const Placed& there);
// What "to" and "at" mean there: a vase goes onto a table, a chair up to it.
std::string suited(const std::string& relation, const std::string& kind, const Placed& there);
// Of the things that the words of a place may mean, those of one kind: what suits the relation, else the largest.
std::vector<int> of_one_kind(const Editor& editor, std::vector<int> found, const std::string& relation);
Anchor anchor_of(const Editor& editor, std::vector<int> found, const std::string& relation);

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
// Of the two corners that lie that way, the one with more free floor before it.
Vec2f freer_corner(const Editor& editor, Vec2f way, const std::string& mover);
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

// ---- edit_layout.cc
// Whether a thing is where its wish says, as people mean it.
bool is_where_asked(const Plan& plan, const std::vector<Placed>& all, const Placed& piece, const PromptObject& wish);
// ---- edit_search.cc
// The wall that is at a thing's back; -1: none.
int wall_behind(const Plan& plan, const Placed& p);
// How far a point is from the middle between two things that a place is said by, other than `own`; +inf: there are
// none.
float off_middle(const std::vector<Placed>& all, const PromptObject& wish, Vec2f at, const Placed* own = nullptr);
// The boxes of what a place is said by: things, or openings as thin boxes.
std::vector<Footprint> anchors_of(const Plan& plan, const std::vector<Placed>& placed, const std::string& kind);
// Things that are larger all around, so that what is further off is at them still.
std::vector<Placed> grown(std::vector<Placed> all, const PromptObject& wish, float by);
// From the ceiling above a thing: its middle, else along it.
bool hang_above(Layout& layout, const PromptObject& wish);
// ---- edit_exchange.cc
// Where another stood; `on`: what carried that, in the layout. `aside`: metres along it.
std::optional<int> take_place(Layout& layout, const PieceRequest& request, const PromptObject& wish,
                              const Placed& place, int on, float aside);
// ---- edit_shapes.cc
// round, oval, square or rectangular; empty: none of those.
std::string shape_of(const Piece& piece);

// ---- edit_sentence.cc: what clauses do

// A sentence while it is acted on.
struct Talk {
    Editor& editor;
    const RoomDocument was = editor.document();  // before the sentence
    std::vector<std::string> last{};             // the things last spoken of: "it"
    std::string noun{};                          // what they are called: "one"
    std::string lacks{};                         // what is missing, by a remark: "one" of the clause behind it
    EditStep last_place{};                       // where they were put
    std::string said{};                          // the clause's verb
    int wall = -1;                               // the wall last spoken of, "it" as well
    bool there = false;                          // the clause ends with "there"
    bool its_place = false;                      // the clause ends with "in its place"
    bool more = false;                           // it says "more", "another": beside those that are there
    std::optional<Vec2f> last_gone{};            // where what was removed last stood: "there"
    std::string last_gone_from{};                // … and what carried it; "clear the table and put a bowl there"
    std::vector<std::string> kept{};             // "leave the rug as it is"
    std::string unclear{};                       // why nobody knows what was last spoken of

    std::vector<std::string> things(const Words& words);
    std::vector<std::string> things_of_parts(const Words& words);
    std::vector<std::string> all_but(const Words& words, Words others);
    std::optional<std::vector<std::string>> the_rest(const Words& words) const;
    void act(const Clause& clause);
};
std::string asked_kind(const Placed& p);  // as it was asked for
std::size_t find_word(const Words& words, std::initializer_list<std::string_view> any, std::size_t from = 0);
bool has_word(const Words& words, std::initializer_list<std::string_view> any);
void add_new(std::vector<std::string>& to, const std::vector<std::string>& more);
bool is_among(const std::string& id, const std::vector<std::string>& ids);
// ---- edit_remove.cc
void remove(Talk& talk, Words words);
void remove_all(Talk& talk, const std::vector<std::string>& ids);
void clear(Talk& talk, const Words& words);  // "the table": what stands on it
// "everything on the table", "everything but the sofa"; false: the words do not speak of everything.
bool remove_everything(Talk& talk, const Words& words);
// "whatever is on the table", "all that stands on the shelf"; nothing: no such words.
std::optional<std::vector<std::string>> all_that_stands_on(Talk& talk, const Words& words);
// "all but one chair": of the chairs.
bool says_all_but_some(const Words& words);
// "the table together with its chairs": the table, and its chairs.
Words with_its(const Words& words);
// ---- edit_move.cc
void move(Talk& talk, const Words& words);
// Where it stood before the sentence moved it; nothing: it stands there still.
std::optional<Vec2f> left_by(const Talk& talk, const std::string& id);
void stand_at(Talk& talk, const std::vector<std::string>& ids, Vec2f at);
// ---- edit_turn.cc
void turn(Talk& talk, const Words& words);
void face(Talk& talk, const Words& words);  // "the sofa towards the tv", "the chair at the desk"
// ---- edit_arrange.cc
// "the chairs in a circle", "the pictures out evenly"; false: no such words.
bool arrange(Talk& talk, const Words& words);
// ---- edit_grid.cc
// Of twelve school desks and a teacher's desk in rows the latter stays.
void without_strangers(Talk& talk, std::vector<std::string>& ids);
// "the chairs in two rows facing the screen"; false: no such words.
bool set_in_rows(Talk& talk, const Words& words);
// ---- edit_put.cc
void put(Talk& talk, const Words& words);
bool put_where(Talk& talk, const Clause& clause);  // "a plant where the pouf is"; false: no such words
bool says_so_that(const Words& words);             // "the desk so that it faces the window"
Words instead_of(const Words& old, const Words& by);
// ---- edit_wishes.cc
// What words ask for that is new.
struct Addition {
    std::vector<PromptObject> wishes;
    std::optional<Place> place;
    std::string shape{};  // of the first
    Words said{};
    bool each = false;    // "two tables with two chairs each"
    bool in_row = false;  // "two tables in a row"
    bool on_it = false;   // "a table with six plants on it"
};
// "another chair", "two more plants", "a few books"
Words counted_anew(Words words);
bool is_a_part(const std::string& word);  // "drawers"
// "Rolled" of "a rolled towel", which no word of the lexicon is.
bool is_unknown_adjective(const Words& words, const std::string& said);
// What words ask for, beside each other in them: "a desk with a lamp".
std::vector<PromptObject> wishes_of(const Editor& editor, const Words& words);
// The shape that words ask for. Throws UsageError for one that nothing has: "star shaped".
std::string shape_asked(const Words& words);
// What came new has the shape that was said, or there is no such thing.
void shape_as_asked(Talk& talk, const std::vector<std::string>& ids, const std::string& shape);
// `spoken`: the ids of what "it" and "them" are.
Addition addition_of(const Talk& talk, const Words& said, const std::vector<std::string>& spoken);
// ---- edit_add.cc
void add(Talk& talk, const Words& words);
void add_there(Talk& talk, const Words& words);
// ---- edit_add_one.cc
// What is wished for comes to the place; without one, with its like or where such things stand.
void add_wish(Talk& talk, const PromptObject& wish, const std::optional<Place>& place);
// … or a form of it that needs no top: a lamp that stands on the floor.
void add_or_stand(Talk& talk, const PromptObject& wish, const std::optional<Place>& place);
Place beside_those(const Talk& talk, const std::vector<std::string>& ids);
// "Two more tables in a row": each beside the one before it.
void add_row(Talk& talk, PromptObject wish);
// Beside those that share its place, and no further from that than they; false: there is no such place.
bool grouped(Talk& talk, const PromptObject& wish, const Place& shared, const std::vector<std::string>& together);
// ---- edit_nouns.cc
// "A second armchair facing the first one": the first armchair.
Words with_noun(const Talk& talk, const Words& words);
// "A fourth mirror station" is one more salon station, where no other word calls it so.
Words by_kind_there(const Editor& editor, const Words& said);
// ---- edit_replace.cc
void copy(Talk& talk, const Words& words);
void replace(Talk& talk, const Words& old, const Words& by);
void swap(Talk& talk, Words words);
// ---- edit_center.cc
// "the rug under the table": their middles in line; false: the words say no such thing.
bool center(Talk& talk, const Words& words);
// ---- edit_groups.cc

// What is to be so, and how; either may be empty.
struct Group {
    std::vector<Words> subjects;
    std::vector<Words> values;  // "larger" and "black"
    Words by;                   // "into a rocking chair": another thing
};
// "the chairs white and the table black", "the sofa and the armchair green", "the sofa black and white"
// `unshown`: "with brass handles", which no look has.
std::vector<Group> groups_of(const Words& words, std::vector<Words>& unshown);
// "The color of the sofa", "the sofa's color" speak of the sofa.
Words bare_subject(Words words);
bool names_things(const Words& words);  // "a rocking chair", "brass lanterns"
Words as_made(Words words);             // "the sofa a green cover" -> "the sofa green"
// ---- edit_make.cc
// "the sofa green", "it night", "the walls sage", "the rug larger", "the style to japandi"
void make(Talk& talk, const Words& words);
bool each_on_or_off(const Words& words);
void recolor(Talk& talk, const std::string& surface, const Value& value);  // wall, floor, ceiling, trim
bool swap_colors(Talk& talk, const Words& words);  // "the colors of the sofa and the rug"; false: no such words
// ---- edit_want.cc: "I want a plant", "the sofa should be green", "it is too dark"
void want(Talk& talk, const Words& words);
// "a wooden floor", "blue walls": how surfaces are to look; false: the words are about none.
bool paint_wanted(Talk& talk, const Words& words);
// ---- edit_light.cc
// "the lamps on": what is to become of the lamps; empty: the words are not about that.
std::string lamps_said(const Words& words);
// "the floor lamp off", "on the desk lamp", "the candles": done; false: the words are not about one of them.
bool shine_said(Talk& talk, const Words& words);
bool can_shine(const Placed& placed);
// "more light", "it brighter", "the lamps dimmer": done; false: the words are not about that.
bool brightness_said(Talk& talk, const Words& words);

}  // namespace fastscene::editing
