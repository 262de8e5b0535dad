// What patterns (layout_patterns.h) share: the pieces of one, in order.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "fastscene/rooms/layout_recipe.h"

namespace fastscene::furnishing {

inline constexpr float kOffWall = 0.05f;  // of what stands with its back at a wall

// The pieces of one pattern: what was asked for first, then as many as the pattern has.
class Pattern {
  public:
    // `as_asked`: where the prompt says no number ("blue seats"), all are like the one that it asks for.
    Pattern(Placement& p, std::string thing, bool alike, bool as_asked = false)
        : p_(p), thing_(std::move(thing)), alike_(alike), as_asked_(as_asked) {}

    // Whether more may come.
    bool open() {
        const Wishes& wishes = p_.wishes();
        if (wishes.forbids(thing_)) return false;
        return wishes.has(thing_) || (p_.is_furnished() && !is_settled(p_.layout().spec(), thing_));
    }
    // Of this size, where the prompt says no other and the builder heeds it.
    void sized(Vec3f size) { size_ = size; }
    void patterned(const std::string& pattern) { pattern_ = pattern; }
    // The next piece, as it will be built.
    const Piece& piece() {
        const PromptObject* wish = p_.wishes().next(thing_);
        if (wish) p_.wishes().give_back(wish);
        if (!wish && as_asked_ && wish_ && !wish_->counted) wish = wish_;
        if (piece_ && alike_ && wish == wish_) return *piece_;
        wish_ = wish;
        PieceRequest r = p_.layout().request(thing_, wish, pattern_);
        for (std::size_t a = 0; a < 3; ++a)
            if (size_[a] > 0 && !(r.size_m[a] > 0)) r.size_m[a] = size_[a];
        piece_ = make_piece(r);
        return *piece_;
    }
    // The same after its size was changed.
    const Piece& fresh_piece() {
        piece_.reset();
        return piece();
    }
    // Through `how`; what was placed moves as one with the first.
    template <class How>
    std::optional<int> place(const How& how) {
        const PromptObject* wish = p_.wishes().next(thing_);
        const auto index = how(wish ? *wish : PromptObject{});
        if (!index) {
            if (wish) p_.wishes().give_back(wish);
            return {};
        }
        if (!alike_) piece_.reset();
        if (first_ < 0) first_ = *index;
        else p_.layout().join(*index, first_);
        p_.attend(*index);
        return index;
    }
    int first() const { return first_; }

  private:
    Placement& p_;
    std::string thing_;
    bool alike_, as_asked_;
    Vec3f size_{};
    std::string pattern_;
    std::optional<Piece> piece_;
    const PromptObject* wish_ = nullptr;
    int first_ = -1;
};

// Whether the step's pieces come at all.
inline bool is_due(Placement& p, const RecipeStep& step, const std::string& thing) {
    return p.wishes().asked(thing) || step.probability >= 1 || p.chance(step.probability);
}

// Along walls and on them (layout_wall_patterns.cc).
void place_run(Placement& p, const RecipeStep& step, int anchor);
void place_end(Placement& p, const RecipeStep& step, int anchor);
void place_bare(Placement& p, const RecipeStep& step, int anchor);
void place_around(Placement& p, const RecipeStep& step, int anchor);

}  // namespace fastscene::furnishing
