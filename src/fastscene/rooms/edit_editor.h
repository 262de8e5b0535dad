// A document while it is edited by steps, with its room.
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

// ---- edit_camera.cc
// Whether a fault is that the camera stands in the way, and not that nobody could stand anywhere. edit_poses.cc.
bool is_of_camera(const std::string& fault);

inline constexpr float kSlightTurn = 20 * kPi / 180;  // "slightly", "a bit"

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
// The floor before a seat, where whoever sits there has his legs.
Footprint leg_room(const Placed& seat);
// Beside a seat, and yet before it, where the legs are.
bool is_before_seat(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p);
// Beside it, and yet no part of it at its arm.
bool is_ahead_of_seat(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p);
// A chair in front of a desk is drawn up to it; true for any other wish.
bool is_drawn_up_before(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p);
// A cabinet beside a fireplace, and yet before it.
bool is_before_front(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p);
// Beside a door, and yet off its wall.
bool is_off_wall_of_door(const Plan& plan, const PromptObject& wish, const Placed& p);
// By a bed, along its foot, where nightstands do not stand.
bool is_at_foot(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p);

// ---- edit_fronts.cc
// Whether something cannot be opened or used from its front since those came that follow the first `before`.
bool blocks_fronts(const Plan& plan, const std::vector<Placed>& all, std::size_t before);

// ---- edit_search.cc
bool sits_before_table(const PromptObject& wish);

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
// The one small thing that is wished on another; nothing: the wish is a different one. edit_nearer.cc.
std::optional<PieceRequest> small_wished_on(Layout& layout);
// A request for so much of its usual size; what one walks into keeps its height.
PieceRequest shrunk_to(PieceRequest request, float scale);
Vec3f shrunk_size(const Piece& usual, float scale);
// What stands, what came last, and the room's things that were moved for it.
struct Squeezed {
    std::vector<Placed> all;
    std::vector<int> pushed;
    float off = 0;  // metres from what it was asked at
};

// ---- edit_seat_places.cc
// Where a seat stands, and how it is turned.
struct Seat {
    Vec3f at;
    float yaw = 0;
};
Seat seat_of(Vec3f middle, Vec3f out, float off);
// Each of those that stand goes to the nearest place; the places that are left.
std::vector<std::size_t> left_over(const std::vector<Vec3f>& from, const std::vector<Seat>& to,
                                   std::vector<std::size_t>& taken);
// Evenly around a round table; none: they would stand in each other.
std::vector<Seat> seats_around(const Placed& table, Vec3f middle, int count, Vec3f size, float first, float least);
// So many of these angles, which ascend, as far apart as may be; how far.
std::pair<std::vector<float>, float> spread(const std::vector<float>& free, int count);

// ---- edit_tops.cc
// What is laid on a table before a seat: its place setting.
std::vector<int> laid_before(const std::vector<Placed>& all, int table, int seat);

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
    // Chairs that go with the table at which they stand. edit_poses.cc.
    std::vector<int> seats_at(int table) const;

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
    void act(const EditStep& step);
    void tell(const std::string& id, const std::string& what);
    void tell_smaller(const std::string& id);  // than usual
    DocumentThing& thing(int index) { return result_.document.things[static_cast<std::size_t>(index)]; }
    const Placed& placed(int index) const { return room_.furnished.placed[static_cast<std::size_t>(index)]; }
    std::string new_id(const std::string& kind) const;

    // ---- edit_poses.cc
    void set_pose(int index, Pose pose, const std::vector<int>& along);
    void tell_pose(int index, Vec3f from);
    void checked(const std::function<void()>& change, const Passage& passage = {});
    std::string new_fault(const std::vector<Placed>& all) const;
    std::vector<Placed> with_pose(int index, Pose pose, const std::vector<int>& along) const;
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

    // ---- edit_fronts.cc
    // The table before a sofa, and the rug below it: they turn with it where they would be in its way.
    std::vector<int> goes_before(int seat) const;

    // ---- edit_layout.cc
    Standing without(const std::vector<int>& gone) const;
    std::vector<Placed> laid_out(const Standing& standing, const EditStep& step, const Placed* moving,
                                 bool finely = false) const;
    Asked asked_among(const Standing& standing, const EditStep& step) const;
    Layout begin_layout(PromptSpec& spec, Random& rng, const std::vector<Placed>& standing, const Placed* moving) const;
    // What one more of the wish is made of, among what stands, like the last of `like` that it may be like; nothing:
    // there is no such thing.
    std::optional<PieceRequest> request_of_one(const EditStep& step, const std::string& stream,
                                               const std::vector<int>& like) const;
    bool at_a_wall(Layout& layout, const EditStep& step, const Placed* moving) const;
    bool several_at_wall(Layout& layout, int wall) const;
    bool near_a_point(Layout& layout, const EditStep& step) const;

    // ---- edit_why.cc
    std::string why_none_added(EditStep step) const;
    // ": it takes 1.60 x 0.60 m, and wardrobe-1 is in the way"; `gone`: what is moved there. Empty: nobody could tell.
    std::string what_is_missing(const EditStep& step, const Placed* moving, const std::vector<int>& gone) const;
    std::vector<std::string> fewest_in_the_way(const EditStep& step, const Placed* moving,
                                               const std::vector<int>& gone) const;
    void try_places(const EditStep& step, const Placed* moving, const std::vector<int>& gone,
                    const std::function<bool(const Standing&, const Asked&, const Placed&)>& each) const;
    // ", and picture-1 hangs there": what is above the thing already; empty: nothing.
    std::string what_hangs_above(const EditStep& step) const;
    // What would be wrong at a place where nothing stands in its way: "it would stand before a window"; empty: nothing,
    // or there is no such place.
    std::string fault_at_best(const EditStep& step, const Placed* moving, const std::vector<int>& gone) const;

    // ---- edit_place.cc
    void place(const EditStep& step);
    void place_with_seats(int index, const EditStep& step);
    void tell_distance(const std::string& id, const EditStep& step);
    void bring_seats(int table, const std::vector<int>& seats);
    void place_one(int index, const std::vector<int>& along, EditStep step);
    void stand_at_found(int index, const Placed& found, const Standing& standing, const EditStep& step,
                        const std::vector<int>& along);

    // ---- edit_add_one.cc
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
    std::string admit_squeezed(const EditStep& step, const Squeezed& found);
    // On a top, as large as usual, where small things move aside for it. False: not so, or there is no need.
    bool add_on_top(const EditStep& step);  // edit_tops.cc
    bool screen_on_desk(Layout& layout) const;
    // One before each seat of a table that has none yet. False: it is no such thing, or no such table.
    bool lay_before_seats(const EditStep& step);
    void make_way(const Squeezed& found, const std::string& whom);
    void tell_squeeze(const std::string& id, const EditStep& step, const Squeezed& found, const Squeeze& how);

    // ---- edit_hang.cc
    bool hang_in_row(Layout& layout) const;
    bool hang_behind(Layout& layout) const;
    bool add_into_row(const EditStep& step);

    // ---- edit_pairs.cc
    bool pair_before(Layout& layout) const;
    void tell_uneven_pair(const std::vector<std::string>& ids, const EditStep& step);

    // ---- edit_nearer.cc
    bool on_flat(Layout& layout) const;
    bool on_top_beside(Layout& layout) const;
    bool on_top_at_wall(Layout& layout, int wall) const;
    bool stand_near(Layout& layout, const EditStep& step) const;
    bool bring_nearer(Layout& layout, const EditStep& step, std::size_t before) const;
    void line_up(const EditStep& step);
    void tell_missing_corners(const EditStep& step, std::size_t added);
    void check_no_pair(const EditStep& step) const;

    // ---- edit_arrange.cc
    void encircle(const EditStep& step);
    void space_out(const EditStep& step);
    void space_seats(int table, const std::vector<int>& seats);
    void space_in_row(const std::vector<int>& all);
    void set_poses(const std::vector<int>& things, const std::vector<Pose>& poses, const std::string& already);

    // ---- edit_seats.cc
    std::vector<int> drawn_up_to(int table) const;
    std::vector<int> tables_meant(const EditStep& step) const;
    // More seats at a table, all of them evenly along its sides. False: it is no table, or they are no such seats.
    bool seat_more(const EditStep& step);
    // `comers`: seats of the room that come to it; none: so many new ones.
    bool seat_at(int table, const EditStep& step, int count, const std::vector<int>& comers = {});
    // Several seats of the room to a table, all of them evenly along its sides. False: it is no table, or they are no
    // such seats, or there is no room for all.
    bool seat_those(const EditStep& step);

    // ---- edit_camera.cc
    std::optional<Vec3f> free_viewpoint(const FurnishedRoom& room) const;
    bool camera_blocked() const;
    void settle_camera(Vec3f was, bool blocked_before);

    // ---- edit_together.cc
    void join(const EditStep& step);

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
    // This far to the side of the old place, at this scale, and nowhere else.
    struct Aside {
        float by, scale;
    };
    void replace(const EditStep& step);
    // The old one goes, and the new one comes near its place, where small things make room for it; false: they cannot.
    // edit_swap.cc.
    bool replaced_nearby(const EditStep& step);
    std::vector<Placed> in_place_of(const std::vector<Placed>& all, const Standing& standing, const EditStep& step,
                                    const Placed& old, int nth, int here, const std::optional<Aside>& only = {}) const;
    // Several in the place of one, side by side there and nowhere else; none: there is no room for that.
    std::vector<Placed> side_by_side(const Standing& standing, const EditStep& step, const Placed& old,
                                     int count) const;
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
    std::set<std::string> smaller_;  // of which that was told
    bool full_size_ = false;         // what comes is as large as usual, or it does not come
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

}  // namespace fastscene::editing
