// The furnisher's order, and what makes a room lived in.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_furnisher.h"
#include "fastscene/rooms/layout_recipe.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene::furnishing {

std::string_view for_a_child(std::string_view thing) {
    const Thing* row = find_thing(thing);
    return row && !row->for_child.empty() ? std::string_view(row->for_child) : thing;
}

std::string picture_for_a_child(Layout& layout) {
    static constexpr std::array<std::string_view, 16> kMotifs{
        "dinosaur", "rocket", "bear",     "rainbow",   "fox",   "whale", "train",  "rabbit",
        "lion",     "moon",   "elephant", "butterfly", "robot", "bird",  "planet", "star"};
    if (layout.rng().chance(0.2f)) return {};
    // One after the other, so that no two are alike.
    const auto first = static_cast<std::size_t>(hash_name(layout.spec().text) % kMotifs.size());
    return std::string(kMotifs[(first + 5 * static_cast<std::size_t>(layout.count("picture"))) % kMotifs.size()]);
}

void Furnisher::run() {
    asked_in_the_shell();
    follow_recipe(recipe_of(l_.spec().room), *this);
    remaining_wishes(false);
    place_the_rest();
    remaining_wishes(true);  // small things that may stand anywhere: what came later carries them too
    l_.improve();
    finish();
    reveal();
    l_.tell_apart();
}

void Furnisher::place_asked() {
    asked_in_the_shell();
    for (int i = 0, standing = static_cast<int>(l_.placed().size()); i < standing; ++i) attend(i);
    for (const bool small : {false, true}) remaining_wishes(small);
}

void Furnisher::picture(float probability) {
    put("picture", probability, [this](PieceRequest r, const PromptObject& o) {
        // Of many sizes; over a bare wall a large one first.
        const float w = l_.rng().uniform(0.4f, 1.25f);
        if (o.size.empty() && o.size_m == Vec3f{})
            r.size_m = {w, w * l_.rng().uniform(0.62f, w < 0.7f ? 1.35f : 0.95f), 0};
        if (room_type(l_.spec().room).for_children && o.kind.empty()) r.pattern = picture_for_a_child(l_);
        return l_.on_wall(r, {}, o);
    });
}

// What makes a room lived in: curtains, plants, pictures, light, small things.
void Furnisher::finish() {
    const PromptSpec& spec = l_.spec();
    const RoomType& type = room_type(spec.room);
    const bool blinds = std::any_of(wishes_.asks().begin(), wishes_.asks().end(),
                                    [](const Ask& a) { return is_blind(a.wish->kind); });
    if (!wishes_.forbids("curtain") && !wishes_.asked("curtain") && !blinds && type.curtains && is_furnished() &&
        !is_left())
        l_.at_windows(l_.request("curtain"));
    if (!l_.plan().asked("recessed_lights") &&
        std::none_of(l_.placed().begin(), l_.placed().end(),
                     [](const Placed& p) { return lights_from_above(p.piece.kind); })) {
        const bool grand = l_.plan().style.mouldings == Mouldings::rich && l_.plan().height > 2.7f && type.chandeliers;
        put(grand && !wishes_.forbids("chandelier") ? "chandelier" : "ceiling_lamp", 0.9f,
            [&](const PieceRequest& r, const PromptObject& o) {
                return l_.hanging(r, {0, 0.2f}, o);
            });
    }
    const int plants = is_left() || !type.lived_in
                           ? 0
                           : std::min(spec.clutter == "minimal" ? 1 : 9,
                                      static_cast<int>(std::lround(l_.plan().style.plants * 3.f)));
    for (int i = 0; i < plants && l_.count("plant") < 4; ++i)
        wall("plant", 0.8f, {.center_pull = 0, .window_pull = 0.8f, .corner = true});
    const int pictures = is_left() ? 0 : 1 + static_cast<int>(std::lround(clutter_ * 3.f));
    for (int i = 0; i < pictures && l_.count("picture") < 5; ++i) picture(type.picture_probability);
    if (type.lived_in) on_wall("shelf", 0.4f * clutter_);
    if (type.lived_in) wall("basket", 0.5f * clutter_, {.center_pull = 0, .corner = true});
    // After sunset a room wants light from more than its ceiling.
    const bool dark = spec.time == "night" || spec.time == "dusk" || spec.light == "lamps on";
    const bool has_light = type.floor_lamp == FloorLamp::never || l_.count("floor_lamp") > (dark ? 1 : 0);
    const float by_day = type.floor_lamp == FloorLamp::usual ? 0.5f : 0.f;
    wall("floor_lamp", has_light ? 0.f : dark ? 1.f : by_day, {.center_pull = 0, .corner = true});
    static constexpr std::array<const char*, 5> kSmall{"book_stack", "vase", "bowl", "candle", "book_stack"};
    const int small = is_left() || !type.lived_in
                          ? 0
                          : static_cast<int>(std::lround((spec.clutter == "minimal" ? 1 : 3) + 7 * clutter_));
    for (int i = 0; i < small; ++i) {
        std::string kind = kSmall[static_cast<std::size_t>(l_.rng().index(static_cast<int>(kSmall.size())))];
        if (type.for_children) kind = for_a_child(kind);
        put(kind, 1, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_any_top(r, o); });
    }
    if (is_furnished() && !is_left()) add_touches(l_, clutter_);
}

}  // namespace fastscene::furnishing

namespace fastscene {

void place_asked(Layout& layout) { furnishing::Furnisher(layout).place_asked(); }
void furnish(Layout& layout) { furnishing::Furnisher(layout).run(); }

}  // namespace fastscene
