// Steps of make_plan. Private to rooms/plan*.cc; apply_wish also to the shell.
#pragma once

#include <span>
#include <algorithm>
#include <string_view>

#include "fastscene/rooms/plan.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {

// The first wish for this class, or, with `forbidden`, the first that says there shall be none; or nothing.
inline const PromptObject* wish_for(const PromptSpec& spec, std::string_view kind, bool forbidden = false) {
    for (const PromptObject& o : spec.objects)
        if (o.kind == kind && o.forbidden == forbidden) return &o;
    return nullptr;
}

// One of the paints that go with the room's style.
void choose_paint(const PromptSpec& spec, Plan& plan, Random& rng);
// Deep colors for studies and libraries of some styles.
void deepen_paint(const PromptSpec& spec, Plan& plan);
// Tiles for a bathroom or laundry, as the style has them.
void tile_wet_room(Plan& plan, Random& rng);

// Windows in the walls as asked for and as the room's type has them, and the door after them.
void add_windows(PromptSpec& spec, Plan& plan, Random& rng);
void add_door(PromptSpec& spec, Plan& plan, Random& rng);

// What the ceiling is made of and how it is shaped, where the prompt does not say it. Once the room has its shape and
// windows.
void choose_ceiling(const PromptSpec& spec, Plan& plan);

// What of a wish is not built, and why.
inline void report(PromptSpec& spec, const PromptObject& wish, int count, const std::string& why) {
    for (int i = 0; i < count; ++i) spec.not_placed.push_back(wish.words + ": " + why);
}

// The outline that the prompt asks for or the room's type has; and that outline for a plan that is a box. Where its
// size was not said, a round or octagonal room becomes as deep as it is wide.
Outline outline_asked(const PromptSpec& spec);
void cut_corners(Outline outline, Plan& plan);
// A vault as asked for or as the room's type has it, below which there are no beams and coffers.
void raise_vault(PromptSpec& spec, Plan& plan);

// A mezzanine, where one is asked for and the room takes it; and what is on it, once windows and doors stand.
void add_mezzanine(PromptSpec& spec, Plan& plan, Random& rng);
void open_mezzanine(PromptSpec& spec, Plan& plan);

// The shape that a window, a door or a doorway was asked in.
inline Opening::Shape shape_of(const PromptObject* wish) {
    if (!wish || wish->pattern.empty()) return Opening::Shape::square;
    return wish->pattern == "arched"  ? Opening::Shape::arched
           : wish->pattern == "round" ? Opening::Shape::round
                                      : Opening::Shape::square;
}

// Color, material and pattern wishes of a surface. A print takes its second color from the palette, where the prompt
// says none.
void apply_wish(Material& m, const PromptObject& wish, bool boarded = false, std::span<const Vec3f> palette = {});
// "gold taps", "black hardware": the metal of taps, handles, frames and lamps.
void apply_fittings(Style& style, const PromptObject& wish);
// "everything is pink": the materials of room and furniture alike.
void cover_everything(const PromptObject& everything, Plan& plan);
// "not brown", and no other color said: another one is chosen, and told in spec.assumed.
void avoid_colors(PromptSpec& spec);

// Sizes of the room that were said in metres, as far as rooms go; and, once the room has its shape, what became of
// them.
void take_measures(const PromptSpec& spec, Plan& plan);
void tell_measures(PromptSpec& spec, const Plan& plan);

// Something is to stand in every corner: no corner is left out of the room, and doors and windows keep off them.
inline bool wants_corners(const PromptSpec& spec) {
    constexpr int kMost = 3;  // of three, one may stand beside the door
    return std::any_of(spec.objects.begin(), spec.objects.end(), [](const PromptObject& o) {
        return !o.forbidden && o.relation == "in the corner" && o.count >= kMost;
    });
}
inline constexpr float kCornerMargin = 0.95f;

// The room, or the house around it, is of a type with a high ceiling; with a sloped one.
inline bool is_hall(const PromptSpec& spec) {
    const RoomType* around = find_room_type(spec.structure);
    return room_type(spec.room).high_ceiling || (around && around->high_ceiling);
}
inline bool is_below_roof(const PromptSpec& spec) {
    const RoomType* around = find_room_type(spec.structure);
    return room_type(spec.room).sloped_ceiling || (around && around->sloped_ceiling);
}

}  // namespace fastscene
