// What the edit*.cc files share: a sentence while it is acted on, and what its clauses do.
#pragma once

#include "fastscene/rooms/edit_editor.h"
#include "fastscene/rooms/edit_reading.h"

namespace fastscene::editing {

// ---- edit_sentence.cc: what clauses do

// "The rest", "the others": what else was spoken of.
bool says_the_rest(const Words& words);

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
    bool more_came = false;                      // the clause before it said "more"
    bool vague = false;                          // it names no thing: what it was taken as is told
    bool more = false;                           // it says "more", "another": beside those that are there
    std::optional<Vec2f> last_gone{};            // where what was removed last stood: "there"
    std::optional<float> last_gone_yaw{};        // … and how that was turned
    std::string last_gone_from{};                // … and what carried it; "clear the table and put a bowl there"
    std::vector<std::string> kept{};             // "leave the rug as it is"
    std::vector<EditStep> turns{};               // what this sentence turned, and how it is turned: moves keep that
    std::vector<std::string>
        mentioned{};              // all that was named so far, as a thing or as a place: "the other" is none of these
    Words too_far{}, too_near{};  // "it is too far from the sofa": "closer" is closer to that
    std::string unclear{};        // why nobody knows what was last spoken of

    std::vector<std::string> things(const Words& words);
    // "On the other desk", where one of two was named before: on that one, by its id.
    Words with_others(const Words& words) const;
    // "On the other two": the words for each of them.
    std::vector<Words> each_of_the_others(const Words& words) const;
    void mention(const std::vector<std::string>& ids);
    // The things of a place, or what a thing came to stand at there.
    void mention_place(const EditStep& place, const std::vector<std::string>& fresh = {});
    std::vector<std::string> things_of_parts(const Words& words);
    std::vector<std::string> all_but(const Words& words, Words others);
    std::optional<std::vector<std::string>> the_rest(const Words& words) const;
    void act(const Clause& clause);

  private:
    std::vector<std::string> meant(const Words& words);
};
// ---- edit_verbs.cc
Words lowered(const Clause& clause);  // "lower the lamp": down
// "Raise the desk by 20 cm": what stands on the floor is taller by that; false: no such words.
bool made_taller(Talk& talk, const Clause& clause);
void tidy(Talk& talk, const Clause& clause);
Words with_word(Words words, const std::string& word);  // "enlarge the rug by 20 percent": larger by that
Words covered(const Clause& clause);                    // "tile the walls", "carpet the room": with that
std::string size_word(const Clause& clause);            // "widen the rug": wider
// ---- edit_spoken.cc
std::string asked_kind(const Placed& p);  // as it was asked for
std::size_t find_word(const Words& words, std::initializer_list<std::string_view> any, std::size_t from = 0);
bool has_word(const Words& words, std::initializer_list<std::string_view> any);
void add_new(std::vector<std::string>& to, const std::vector<std::string>& more);
bool is_among(const std::string& id, const std::vector<std::string>& ids);
// ---- edit_guests.cc
// "Set the table for six": as many places as are missing; false: no such words.
bool set_for_guests(Talk& talk, const Words& words);
// "So that eight people can sit", "seating for eight": how many; 0: no such words.
int guests_said(const Words& words);
// As many chairs at the table that the words name, or the room's, as are missing.
void seat_guests(Talk& talk, const Words& words, int guests);
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
// ---- edit_together.cc
// Without seats at tables that are among them: they go along. edit_pairs.cc.
std::vector<std::string> without_companions(const Editor& editor, const std::vector<std::string>& ids);
float gap_between_edges(const Placed& a, const Placed& b);
bool put_together(Talk& talk, const std::vector<std::string>& ids);  // edit_pairs.cc
std::vector<std::string> nearest_of(Talk& talk, const Words& thing, const Words& where,
                                    const std::vector<std::string>& spoken);
bool join_tables(Talk& talk, const Words& said, const std::vector<std::string>& spoken);
// ---- edit_vague.cc
// Something small on the floor, that stands nowhere in particular.
bool lies_about(const Editor& editor, const std::string& id);
// "It cozier", "the room less cluttered": what that is taken as is told; false: no such words.
bool made_vaguely(Talk& talk, const Words& words);
// ---- edit_turn.cc
void turn(Talk& talk, const Words& words);
void turn_as_said(Talk& talk, const std::vector<std::string>& ids);
void face(Talk& talk, const Words& words);  // "the sofa towards the tv", "the chair at the desk"
// ---- edit_arrange.cc
// "the chairs in a circle", "the pictures out evenly"; false: no such words.
bool arrange(Talk& talk, const Words& words);
// ---- edit_grid.cc
// Of many things of one kind and a few others, those few stay: the teacher's desk of twelve school desks.
void without_strangers(Talk& talk, std::vector<std::string>& ids);
// "the chairs in two rows facing the screen"; false: no such words.
bool set_in_rows(Talk& talk, const Words& words);
// ---- edit_put.cc
void put(Talk& talk, const Words& words);
bool put_where(Talk& talk, const Clause& clause);  // "a plant where the pouf is"; false: no such words
bool says_so_that(const Words& words);             // "the desk so that it faces the window"
Words instead_of(const Words& old, const Words& by);
// Of what goes for something new, that which stands where the new one comes: "a vase on the desk instead of the books".
std::vector<std::string> those_instead(Talk& talk, const Words& old, const Words& by);
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
// ---- edit_like_those.cc
// "Three more tables" are tables as there are, where those are of one kind.
void as_those_there(const Editor& editor, const Words& words, PromptObject& wish);
// "Three stools on the other side of the island", where bar stools stand at it: bar stools.
void as_those_at(const Editor& editor, Addition& addition);
// ---- edit_add.cc
void add(Talk& talk, const Words& words);
void add_there(Talk& talk, const Words& words);
// ---- edit_add_parts.cc
// "A lamp here and the bench under the window": the bench is there, and moves.
bool stands_already(const Talk& talk, const Words& words);
// Each part of the words at its own place, at that of the next one, or at what came before it.
void add_parts(Talk& talk, const std::vector<Words>& parts, const Words& words);
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
// ---- edit_make_each.cc
// "the chairs alternately black and white"; false: no such words.
bool make_by_turns(Talk& talk, const Words& words);
// "each wall a different color", "the chairs in various colors": one after the other; false: no such words.
bool make_various(Talk& talk, const Words& words);
// "The table into a round one with four chairs", "the sofa green with two cushions": those come to it; false: no such
// words.
bool made_with(Talk& talk, const Words& words);
// "The walls black and red curtains": what is there already is made so, what is not comes; false: no such words.
bool made_and_wanted(Talk& talk, const Words& words);
// "Every desk a plant": one at each; false: no such words.
bool given(Talk& talk, const Words& words);
// "The floor" by "checkered tiles": how it is to look; false: the words are about no surface.
bool resurfaced(Talk& talk, const Words& old, const Words& by);
void recolor(Talk& talk, const std::string& surface, const Value& value);  // wall, floor, ceiling, trim
bool swap_colors(Talk& talk, const Words& words);  // "the colors of the sofa and the rug"; false: no such words
// ---- edit_want.cc: "I want a plant", "the sofa should be green", "it is too dark"
void want(Talk& talk, const Words& words);
bool is_complaint(const std::string& word);  // of what is too much so: "big", "dark"
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
