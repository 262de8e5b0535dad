// The workbench of the furnisher: what the layout_*.cc files that fill rooms hand to each other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/layout.h"

namespace fastscene::furnishing {

// Things that stand on others or hang on walls: whoever asks for one at a piece wants it there, not anywhere.
bool is_small(std::string_view klass);
bool lies_about(std::string_view klass);     // on floors, nowhere in particular: clothes, paper, rubble
bool lies_on_seats(std::string_view klass);  // small things that need no table
// Whether a lamp above such a piece hangs from the ceiling.
bool hangs_over(std::string_view klass);
// What one sits or lies on: nothing is put there by itself.
bool is_seat(std::string_view klass);
// Blinds and shutters: they hang in windows, in all of them.
// "a wall mounted TV": above its stand, not on it.
bool is_hung_screen(const PromptObject& wish);
bool is_blind(std::string_view klass);
// What lights a room from its ceiling when it was asked for: the usual lamp is left out.
bool lights_from_above(std::string_view klass);

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
bool is_settled(const PromptSpec& spec, std::string_view klass);

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

    bool forbids(std::string_view klass) const;
    // The next wish of this class that binds nowhere, taken; null: there is none.
    const PromptObject* next(std::string_view klass);
    void give_back(const PromptObject* wish);
    // How many of this class are still to be placed, bound or not.
    int count(std::string_view klass) const;
    bool has(std::string_view klass) const { return count(klass) > 0; }
    bool asked(std::string_view klass) const;  // placed or not
    std::vector<Ask>& asks() { return asks_; }

  private:
    const PromptSpec& spec_;
    std::vector<Ask> asks_;
};

// The furnisher. Its one order: what was asked to stand somewhere in the shell, while that is free; the room's main
// pieces, each at once with all that was asked for at it; what else was asked for; then what a room of its kind has
// besides; then clutter.
class Furnisher {
  public:
    explicit Furnisher(Layout& layout);
    void run();

  private:
    using How = std::function<std::optional<int>(const PieceRequest&, const PromptObject&)>;
    using Then = std::function<void(int)>;

    // ---- layout_furnisher.cc: placing
    // "only a bed": nothing stands that nobody asked for.
    bool is_furnished() const { return !is_one_of(l_.spec().clutter, {"empty", "renovation"}); }
    // Nobody hangs pictures and waters plants there.
    bool is_left() const { return is_one_of(l_.spec().clutter, {"abandoned", "moving"}); }
    bool chance(float p) { return l_.dice().chance(p); }
    // Places a piece through `how`: at once if it was asked for; else, with this probability, when all that was asked
    // for stands. `then` goes on from it.
    void put(const std::string& klass, float probability, const How& how, const Then& then = {});
    // What the room cannot do without: at once. The piece that was asked for elsewhere in the room, if there is one.
    std::optional<int> main(const std::string& klass, const How& how);
    std::optional<int> main_at_wall(const std::string& klass, Layout::WallWish wish);
    void wall(const std::string& klass, float probability, Layout::WallWish wish = {}, const Then& then = {});
    void beside(int anchor, const std::string& klass, float probability, int side, float gap, const Then& then = {});
    void before(int anchor, const std::string& klass, float probability, float gap, bool facing, const Then& then = {});
    void top(int anchor, const std::string& klass, float probability);
    void above(int anchor, const std::string& klass, float probability);
    void on_wall(const std::string& klass, float probability);
    void picture(float probability);
    void rug(int anchor, float probability, float width, float depth, float shift);
    // Later, or now if all that was asked for stands.
    void later(std::function<void()> what);
    std::optional<int> at_wall(const PieceRequest& request, Layout::WallWish wish, const PromptObject& from);
    std::optional<int> laid_under(int anchor, PieceRequest request, Vec2f size, float shift, const PromptObject& from);

    const Placed& at(int i) const { return l_.placed()[static_cast<std::size_t>(i)]; }
    const std::string& klass_of(int i) const { return at(i).piece.klass; }
    const Vec3f& size(int i) const { return at(i).piece.size_m; }
    Vec2f front_point(int anchor, float far) const;
    int wall_opposite(int anchor) const;
    void finish();
    // ---- layout_reveal.cc: what was asked for is seen
    void reveal();
    void uncover(Vec3f eye);

    // ---- layout_asked.cc: what was asked for
    // Places what was asked for at this piece.
    void attend(int index);
    // Sees to it that a piece of this class stands, if one was asked for.
    void summon(const std::string& klass);
    Spare spare_for(const std::string& klass);
    Spare spare_for(const PromptObject& wish, const Piece& piece);
    void asked_in_the_shell();
    void remaining_wishes(bool small);
    std::optional<int> at_piece(int anchor, const Ask& ask);
    std::optional<int> on_piece(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> at_the_foot(int anchor, const PieceRequest& r, const PromptObject& wish);
    std::optional<int> above_piece(int anchor, const Ask& ask, const PieceRequest& r, const Piece& piece);
    std::optional<int> under_piece(int anchor, const Ask& ask, const PieceRequest& r, const Piece& piece);
    std::optional<int> before_piece(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> next_to_piece(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> rug_at(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> in_shell(const Ask& ask);
    // Where the words say, searched for everywhere.
    std::optional<int> where_asked(const PromptObject& wish, const PieceRequest& r, const Piece& piece);
    std::optional<int> on_a_top_there(const PromptObject& wish, const PieceRequest& r, std::optional<int> anchor);
    std::optional<int> kitchen_units(PieceRequest r, const PromptObject& wish);
    std::optional<int> next_in_row(const PromptObject& wish, const PieceRequest& r);
    std::optional<int> on_a_table_of_its_own(const PieceRequest& r, const PromptObject& wish);
    std::optional<int> anywhere(const PromptObject& wish);
    std::optional<int> strewn(const PieceRequest& r, const PromptObject& wish);
    // Beside the other monitors at the back of a desk, the outer ones turned to who sits there.
    std::optional<int> next_screen(int desk, const PieceRequest& r, const PromptObject& wish);
    std::optional<int> screen_above(int stand, const PieceRequest& r, const PromptObject& wish);
    std::optional<int> television(const PieceRequest& r, const PromptObject& wish);
    bool stands_on_others(const PromptObject& wish) const;
    // A lamp on the wall beside a bed, a mirror, a picture, a fire: the emptier side of the first that has not two.
    std::optional<int> wall_lamp(const PieceRequest& r, const PromptObject& wish);
    std::optional<int> wall_lamp_at(int anchor, const PieceRequest& r, const PromptObject& wish);
    // Where nobody's head is: beside windows, in corners.
    std::optional<int> hung_aside(const PieceRequest& r, const PromptObject& wish);
    bool on_a_seat(const PromptObject& wish);

    // ---- layout_groups.cc: what belongs into which room
    void groups();
    void bedroom();
    void kids_room();
    void kitchen();
    void dining();
    void bathroom();
    void study();
    void hallway();
    void laundry();
    void sunroom();
    void loft();
    void living();
    void sleeping_place(const std::string& klass);
    void sleeping_place_along(const std::string& klass);
    // The first of these that was asked for; else the last.
    std::string first_asked(std::initializer_list<const char*> classes) const;
    // Where one sits alone: the chair that was asked for, else an armchair.
    std::string easy_chair() const;
    void reading_corner(float probability);
    void working_place(float probability);
    void seating_group();
    void focus_of(int sofa);
    bool is_eaten_here() const;
    void eating_place(int seats);
    void seats_at(int island);

    Layout& l_;
    Wishes wishes_;
    float clutter_;
    bool adding_ = false;  // all that was asked for stands
    std::vector<std::function<void()>> later_;
    std::vector<std::string> summoned_;  // classes that another piece waited for
};

}  // namespace fastscene::furnishing
