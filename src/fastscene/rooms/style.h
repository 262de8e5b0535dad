// Styles: what an interior of a given taste is made of. A style is a file, styles/NAME.toml; no code knows its name.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/rooms/materials.h"
#include "fastscene/rooms/style_choices.h"

namespace fastscene {

struct Style;

// What a part of a piece is made of: one of the style's own materials, whatever a prompt has made of that, or another.
struct MadeOf {
    Material Style::*own = nullptr;
    Material other{};        // without `own`
    bool in_accent = false;  // `other` in the palette's first color
};

// What rooms of a style have of the pieces that come in several forms: the first a little more often.
template <class Form>
struct TwoForms {
    Form first{}, second{};
};

// Materials are complete (color, pattern, roughness); rooms/ may copy and recolor them.
struct Style {
    std::string name;
    int rank = 0;                    // place among styles() and in draws
    std::vector<std::string> words;  // that name it in a prompt, besides the lexicon's

    Material floor, wall, accent_wall, ceiling, trim;
    Material wood, wood2, metal, fabric, fabric2, leather, curtain, rug;
    Material tap{};                     // of basins, tubs and showers
    Material wet_wall, wet_floor;       // tiles of bathrooms
    std::vector<Vec3f> palette;         // 6 linear albedos for cushions, books, art, vases; the first is the accent
    std::vector<Vec3f> paints;          // of walls; some more than once, which makes them likelier
    std::vector<Vec3f> deep_paints;     // of walls in rooms that may be dark; may be empty
    std::vector<Vec3f> kitchen_paints;  // of fronts, two; none: they are of wood
    std::string wallpaper;              // the print of a wallpaper of which no more is said

    float ceiling_m = 2.7f;
    bool beams = false;  // visible ceiling beams
    float ceiling_boards_probability = 0, tray_probability = 0, recessed_lights_probability = 0;
    Material ceiling_boards;
    int window_columns = 1, window_rows = 1;  // panes
    bool radiators = true;

    LampFamily lamp = LampFamily::drum;
    Vec3f lamp_light{9.f, 6.6f, 4.2f};      // radiance of a lit shade, relative to daylight of about 1
    Sky::View outlook = Sky::View::garden;  // what is outside with this probability; else a garden
    float outlook_probability = 0;
    float plants = 0.5f;               // 0 none … 1 many
    float clutter = 0.5f;              // 0 bare … 1 full
    Shelves shelves = Shelves::books;  // set by the room, not by taste

    LegType legs = LegType::square;
    SofaType sofa = SofaType::block;
    Mouldings mouldings = Mouldings::none;
    PostForm bed_posts = PostForm::square;
    FanForm fan_blades = FanForm::boards;
    TapestryForm tapestry = TapestryForm::landscape;
    RugWeave rug_weave = RugWeave::any;
    struct {
        TwoForms<SofaForm> sofa;
        TwoForms<ArmchairForm> armchair;
        TwoForms<ChaiseForm> chaise_longue;
        TwoForms<BedForm> bed;
        TwoForms<DaybedForm> daybed;
        TwoForms<FloorBedForm> floor_bed;
        TwoForms<BunkForm> bunk;
        TwoForms<CoffeeTableForm> coffee_table;
        TwoForms<DiningTableForm> dining_table;
        TwoForms<ChestForm> chest;
        TwoForms<FloorLampForm> floor_lamp;
    } forms;
    // Of single pieces.
    struct {
        MadeOf blind_slats, shutters, shoji, bunk, bunk_boxes, chaise_longue, lounge_chair, butterfly_chair, throne,
            window_seat, clock_case, cactus_pot, bar_cart, bar_cart_shelves, lantern, fan_blades;
    } made_of;
    int sideboard_columns = 4, sideboard_most_rows = 1;  // of its fronts
    bool fresh_flowers = true;                           // in vases; else dried stems
    bool round_rugs = false;                             // now and then
    bool old_maps = false;                               // on parchment
    bool yellowed_paper = false;                         // sheets that lie about
    bool lacquered_play = false;                         // play tables, and bunks now and then
    bool black_cane = false;                             // of hanging chairs
    bool formal_clocks = false;                          // tall clocks with mouldings
    bool aluminium_ladders = false;                      // step ladders; else of pine

    // Where the prompt names no style: the place in the draw among those for a mood.
    std::map<StyleMood, int> drawn_for;

    Material of(const MadeOf& part) const;
};

// One of styles(); throws Error for another name.
const Style& style_named(std::string_view name);
// By rank: "modern", "scandinavian", "art deco" …
std::vector<std::string> styles();
const std::vector<Style>& all_styles();
// Those that a room of this mood may take when the prompt says none, in the order of the draw; never empty.
std::vector<std::string> styles_for(StyleMood mood);
// The first whose lamps have such shades; never empty.
std::string style_with_lamp(LampFamily lamp);

}  // namespace fastscene
