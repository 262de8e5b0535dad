// How recipes (layout_recipe.h) and groups of pieces (layout_groups.h) place things.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/layout_parts.h"

namespace fastscene::furnishing {

class Placement {
  public:
    // Finds a place for what was requested and puts it there; returns its index, or nothing when there is no room.
    using How = std::function<std::optional<int>(const PieceRequest&, const PromptObject&)>;
    using Then = std::function<void(int)>;

    explicit Placement(Layout& layout);
    virtual ~Placement() = default;
    Placement(const Placement&) = delete;
    Placement& operator=(const Placement&) = delete;

    Layout& layout() { return l_; }
    Wishes& wishes() { return wishes_; }
    float clutter() const { return clutter_; }  // in [0, 1]
    bool chance(float p) { return l_.rng().chance(p); }
    // "only a bed": nothing stands that nobody asked for.
    bool is_furnished() const;
    // Nobody hangs pictures and waters plants there.
    bool is_left() const;

    // Places a piece through `how`: at once if it was asked for; else, with this probability, when all that was asked
    // for stands. `then` goes on from it.
    void put(const std::string& kind, float probability, const How& how, const Then& then = {});
    // What the room cannot do without: at once. The piece that was asked for elsewhere in the room, if there is one.
    std::optional<int> main(const std::string& kind, const How& how);
    // Later, or now if all that was asked for stands.
    void later(std::function<void()> what);

    // Ways to place a piece with `put` and `main`. `anchor` is the index of a piece that stands.
    std::optional<int> main_at_wall(const std::string& kind, Layout::WallWish wish);
    void wall(const std::string& kind, float probability, Layout::WallWish wish = {}, const Then& then = {});
    void beside(int anchor, const std::string& kind, float probability, int side, float gap, const Then& then = {});
    void before(int anchor, const std::string& kind, float probability, float gap, bool facing, const Then& then = {});
    void top(int anchor, const std::string& kind, float probability);
    void above(int anchor, const std::string& kind, float probability);
    void on_wall(const std::string& kind, float probability);
    void rug(int anchor, float probability, float width, float depth, float shift);
    // Seats around a table or along a worktop: as many as were asked for; else, with this probability, `usual`.
    void seats_around(int table, const std::string& kind, int usual, float probability);
    // Seats at one of many tables, by the number that was asked for; without a number all seats are like the wish.
    // Returns that wish, for the next table: `like`.
    const PromptObject* seats_of_pattern(int table, const std::string& kind, int usual, const PromptObject* like);
    std::optional<int> at_wall(const PieceRequest& request, Layout::WallWish wish, const PromptObject& from);
    std::optional<int> laid_under(int anchor, PieceRequest request, Vec2f size, float shift, const PromptObject& from);

    const Placed& at(int i) const { return l_.placed()[static_cast<std::size_t>(i)]; }
    const std::string& kind_of(int i) const { return at(i).piece.kind; }
    const Vec3f& size(int i) const { return at(i).piece.size_m; }
    Vec2f front_point(int anchor, float far) const;
    // The wall that a piece with its back at a wall faces: 0..3.
    int wall_opposite(int anchor) const;

    // Places what was asked for at this piece.
    virtual void attend(int index) = 0;
    // Sees to it that a piece of this class stands, if one was asked for.
    virtual void summon(const std::string& kind) = 0;
    // The floor and the wall that wait for what was asked for at a piece of this class.
    virtual Spare spare_for(const std::string& kind) = 0;

  protected:
    // From here on all that was asked for stands: what was put off is placed.
    void place_the_rest();

    Layout& l_;
    Wishes wishes_;
    float clutter_;

  private:
    bool adding_ = false;  // all that was asked for stands
    std::vector<std::function<void()>> later_;
};

}  // namespace fastscene::furnishing
