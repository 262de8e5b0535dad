#include "fastscene/rooms/layout_recipe.h"

#include <algorithm>
#include <array>
#include <optional>

#include "fastscene/rooms/layout_groups.h"
#include "fastscene/rooms/layout_patterns.h"

namespace fastscene::furnishing {
namespace {

using Names = std::vector<std::string>;

bool one_asked(const Wishes& wishes, const Names& things) {
    return std::any_of(things.begin(), things.end(), [&](const std::string& t) { return wishes.asked(t); });
}
std::optional<int> first_placed(const Layout& layout, const Names& things) {
    for (const std::string& thing : things)
        if (const auto found = layout.find(thing)) return found;
    return {};
}

bool is_asked(const RecipeStep& step, const Wishes& wishes) {
    const auto& group = step.kind->asked_by;
    return (!step.thing.empty() && wishes.asked(step.thing)) || one_asked(wishes, step.first_asked) ||
           std::any_of(group.begin(), group.end(), [&](std::string_view t) { return wishes.asked(t); });
}

bool is_due(const RecipeStep& step, Placement& p) {
    const StepConditions& when = step.when;
    const Wishes& wishes = p.wishes();
    const auto stands = [&](const Names& things) { return first_placed(p.layout(), things).has_value(); };
    const bool asked = is_asked(step, wishes);
    if (when.only_asked && !asked) return false;
    if (!asked && (one_asked(wishes, when.unless_asked) || stands(when.unless_placed))) return false;
    if (!when.if_asked.empty() && !one_asked(wishes, when.if_asked)) return false;
    if (one_asked(wishes, when.if_not_asked) || stands(when.if_not_placed)) return false;
    if (!when.if_to_place.empty() && std::none_of(when.if_to_place.begin(), when.if_to_place.end(),
                                                  [&](const std::string& t) { return wishes.has(t); }))
        return false;
    return when.if_placed.empty() || stands(when.if_placed);
}

void follow(const std::vector<RecipeStep>& steps, Placement& p, int anchor);

Placement::Then then_of(const RecipeStep& step, Placement& p) {
    if (step.then.empty()) return {};
    return [&step, &p](int piece) { follow(step.then, p, piece); };
}

float probability_of(const RecipeStep& step, const Placement& p) {
    return step.by_clutter ? step.probability * p.clutter() : step.probability;
}

// What the room needs comes at once, and if it has a probability, as often; all else through `put`.
void place(Placement& p, const RecipeStep& step, const Placement::How& how) {
    const std::string thing = thing_of(step, p);
    if (!step.needed) return p.put(thing, probability_of(step, p), how, then_of(step, p));
    if (!p.wishes().asked(thing) && step.probability < 1 && !p.chance(probability_of(step, p))) return;
    if (const auto piece = p.main(thing, how)) follow(step.then, p, *piece);
}

void place_at_wall(Placement& p, const RecipeStep& step, int) {
    const Layout::WallWish wish{
        .center_pull = step.center_pull, .window_pull = step.window_pull, .corner = step.corner};
    place(p, step, [&p, wish](const PieceRequest& r, const PromptObject& o) { return p.at_wall(r, wish, o); });
}

void place_free(Placement& p, const RecipeStep& step, int) {
    place(p, step, [&p](const PieceRequest& r, const PromptObject& o) { return p.layout().free_standing(r, o); });
}

// Turned to a piece, or to the middle of the room.
void place_facing(Placement& p, const RecipeStep& step, int anchor) {
    const Vec2f to = anchor >= 0 ? flat(p.at(anchor).position) : Vec2f{0, 0};
    place(p, step,
          [&p, to](const PieceRequest& r, const PromptObject& o) { return p.layout().angled_towards(to, r, o); });
}

void place_on_wall(Placement& p, const RecipeStep& step, int) { p.on_wall(thing_of(step, p), probability_of(step, p)); }

void place_top(Placement& p, const RecipeStep& step, int anchor) {
    p.top(anchor, thing_of(step, p), probability_of(step, p));
}

void place_above(Placement& p, const RecipeStep& step, int anchor) {
    p.above(anchor, thing_of(step, p), probability_of(step, p));
}

void place_beside(Placement& p, const RecipeStep& step, int anchor) {
    const int side = step.side != 0 ? step.side : p.chance(0.5f) ? 1 : -1;
    p.beside(anchor, thing_of(step, p), probability_of(step, p), side, step.gap_m, then_of(step, p));
}

void place_before(Placement& p, const RecipeStep& step, int anchor) {
    p.before(anchor, thing_of(step, p), probability_of(step, p), step.gap_m, step.facing, then_of(step, p));
}

void place_seats(Placement& p, const RecipeStep& step, int anchor) {
    p.seats_around(anchor, thing_of(step, p), step.seats, step.probability);
}

void place_rug(Placement& p, const RecipeStep& step, int anchor) {
    const float edge = step.from_edge ? p.size(anchor).z / 2 : 0.f;
    p.rug(anchor, probability_of(step, p), step.width_m, step.depth_m, edge + step.shift_m);
}

void do_steps(Placement& p, const RecipeStep& step, int anchor) { follow(step.then, p, anchor); }

void carry_out(const RecipeStep& step, Placement& p, int anchor) {
    if (!step.at.empty()) {
        anchor = first_placed(p.layout(), step.at).value_or(-1);
        if (anchor < 0 && step.kind->at_a_piece) return;
    }
    for (int i = 0; i < step.count; ++i) step.kind->place(p, step, anchor);
}

void follow(const std::vector<RecipeStep>& steps, Placement& p, int anchor) {
    for (const RecipeStep& step : steps) {
        if (!is_due(step, p)) continue;
        // By then more may stand than now.
        if (step.late)
            p.later([&step, &p, anchor] {
                if (is_due(step, p)) carry_out(step, p, anchor);
            });
        else carry_out(step, p, anchor);
    }
}

std::vector<std::string_view> with_thing(std::vector<std::string_view> keys) {
    keys.insert(keys.end(), {"thing", "first_asked", "other", "thing_share", "probability", "by_clutter"});
    return keys;
}

}  // namespace

std::string thing_of(const RecipeStep& step, Placement& p) {
    for (const std::string& thing : step.first_asked)
        if (p.wishes().asked(thing)) return thing;
    return step.other.empty() || p.chance(step.thing_share) ? step.thing : step.other;
}

std::span<const StepKind> step_kinds() {
    static const std::vector<StepKind> all = [] {
        std::vector<StepKind> out{
            {"wall", with_thing({"needed", "then", "center_pull", "window_pull", "corner"}), false, {}, place_at_wall},
            {"free", with_thing({"needed", "then"}), false, {}, place_free},
            {"facing", with_thing({"needed", "then"}), false, {}, place_facing},
            {"on_wall", with_thing({}), false, {}, place_on_wall},
            {"top", with_thing({}), true, {}, place_top},
            {"above", with_thing({}), true, {}, place_above},
            {"beside", with_thing({"then", "side", "gap_m"}), true, {}, place_beside},
            {"before", with_thing({"then", "gap_m", "facing"}), true, {}, place_before},
            {"around", {"thing", "first_asked", "seats", "probability"}, true, {}, place_seats},
            {"rug",
             {"probability", "by_clutter", "width_m", "depth_m", "shift_m", "from_edge"},
             true,
             {"rug"},
             place_rug},
            {kStepsAlone, {"then"}, false, {}, do_steps},
        };
        const auto groups = group_kinds();
        out.insert(out.end(), groups.begin(), groups.end());
        const auto patterns = pattern_kinds();
        out.insert(out.end(), patterns.begin(), patterns.end());
        return out;
    }();
    return all;
}

void follow_steps(const std::vector<RecipeStep>& steps, Placement& placement, int anchor) {
    follow(steps, placement, anchor);
}

void follow_recipe(const std::vector<RecipeStep>& recipe, Placement& placement) { follow(recipe, placement, -1); }

}  // namespace fastscene::furnishing
