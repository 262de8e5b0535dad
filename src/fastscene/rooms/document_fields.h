// The fields of a room document, each defined once: its key, its member, its rule and its sentence. The writer, the
// reader and the JSON Schema are derived from them.
#pragma once

#include <string_view>

#include "fastscene/rooms/document.h"
#include "fastscene/rooms/style_choices.h"

namespace fastscene {

template <>
inline constexpr std::array<std::string_view, 4> kNamesOf<Mount>{"floor", "wall", "ceiling", "surface"};
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<Opening::Kind>{"window", "door", "doorway"};
template <>
inline constexpr std::array<std::string_view, 4> kNamesOf<Opening::Shape>{"square", "arched", "round", "rounded"};
template <>
inline constexpr std::array<std::string_view, 6> kNamesOf<Block::Kind>{"corner", "breast", "column",
                                                                       "cut",    "curve",  "stairs"};
template <>
inline constexpr std::array<std::string_view, 2> kNamesOf<Platform::Kind>{"tier", "step"};

namespace document_fields {

inline constexpr double kFar = 100;      // metres: no room is larger
inline constexpr double kMostColor = 4;  // of a pattern that lightens its ground
inline constexpr double kBright = 1000;  // radiance of the strongest lamp

struct Rule {
    double low = -kFar, high = kFar;        // of numbers, and of the components of vectors
    bool needed = false;                    // the document must have it
    bool always = false;                    // written even when it is as usual
    bool degrees = false;                   // radians in memory
    bool color = false;                     // also by name or as "#rrggbb"
    std::vector<std::string_view> names{};  // a text must be one of these, or empty
};

template <class V>
void visit_fields(Opening& o, V&& v) {
    v("kind", o.kind, Rule{.always = true}, "What it is.");
    v("wall", o.wall, Rule{.low = 0, .high = 3, .needed = true, .always = true},
      "0 far (+z), 1 (+x), 2 near (-z), 3 (-x).");
    v("from_m", o.u0, Rule{.low = 0, .needed = true, .always = true},
      "Its right side along the wall, from the right end as seen from inside.");
    v("to_m", o.u1, Rule{.low = 0, .needed = true, .always = true}, "Its right side.");
    v("low_m", o.y0, Rule{.low = 0, .always = true}, "Its lower edge above the floor.");
    v("high_m", o.y1, Rule{.low = 0, .needed = true, .always = true}, "Its upper edge.");
    v("shape", o.shape, Rule{}, "Its shape within that box.");
    v("glazing", o.glazing, Rule{}, "What is in it, if it is a window: vehicles have screens and doors of glass.");
    v("requested", o.requested, Rule{}, "Whether the prompt asked for it.");
}
template <class V>
void visit_fields(Block& b, V&& v) {
    v("kind", b.kind, Rule{.always = true},
      "A corner that is not room, a chimney breast, a column, or a corner of the box that is cut off straight or by a "
      "curve.");
    v("low", b.low, Rule{.needed = true, .always = true}, "x, z of its lower corner.");
    v("high", b.high, Rule{.needed = true, .always = true}, "x, z of its upper corner.");
}
template <class V>
void visit_fields(Platform& p, V&& v) {
    v("kind", p.kind, Rule{.always = true}, "A tier, which things may stand on, or a step that leads up to one.");
    v("low", p.low, Rule{.needed = true, .always = true}, "x, z of its lower corner.");
    v("high", p.high, Rule{.needed = true, .always = true}, "x, z of its upper corner.");
    v("height_m", p.height, Rule{.low = 0, .needed = true, .always = true}, "Of its top above y = 0.");
}
template <class V>
void visit_fields(Skylight& s, V&& v) {
    v("wall", s.wall, Rule{.low = 1, .high = 3, .always = true}, "The wall below its slope: 1 or 3.");
    v("from_z_m", s.z0, Rule{.needed = true, .always = true}, "Where it begins along the wall.");
    v("to_z_m", s.z1, Rule{.needed = true, .always = true}, "Where it ends.");
    v("from_up_m", s.s0, Rule{.low = 0, .needed = true, .always = true}, "Its lower edge, up the slope.");
    v("to_up_m", s.s1, Rule{.low = 0, .needed = true, .always = true}, "Its upper edge.");
}
template <class V>
void visit_fields(Material& m, V&& v) {
    v("name", m.name, Rule{.always = true}, "What people call it.");
    v("pattern", m.pattern, Rule{.always = true}, "Its procedural pattern.");
    v("color_a", m.color_a, Rule{.low = 0, .high = kMostColor, .always = true, .color = true},
      "Linear albedo, or a color by name.");
    v("color_b", m.color_b, Rule{.low = 0, .high = kMostColor, .always = true, .color = true},
      "The pattern's second color.");
    v("color_c", m.color_c, Rule{.low = 0, .high = kMostColor, .always = true, .color = true},
      "The pattern's third color.");
    v("scale_m", m.scale_m, Rule{.low = 0}, "Size of the pattern's unit.");
    v("bump_m", m.bump_m, Rule{.low = -1, .high = 1}, "Height of its relief.");
    v("crease_m", m.crease_m, Rule{.low = 0, .high = 1}, "Depth of the creases of soft things.");
    v("sheen", m.sheen, Rule{.low = 0, .high = 1}, "Share of light that upright fibers scatter at grazing angles.");
    v("roughness", m.roughness, Rule{.low = 0, .high = 1}, "0 polished, 1 matt.");
    v("specular", m.specular, Rule{.low = 0, .high = 1}, "Reflectance of its coat at normal incidence.");
    v("metal", m.metal, Rule{.low = 0, .high = 1}, "1: the color is the mirror's.");
    v("transmission", m.transmission, Rule{.low = 0, .high = 1},
      "Share of diffuse light that thin sheets let through.");
    v("mirror", m.mirror, Rule{.low = 0, .high = 1}, "1: mirror glass.");
    v("emission", m.emission, Rule{.low = 0, .high = kBright}, "Radiance of what shines.");
    v("seed", m.seed, Rule{.low = 0, .high = 4294967295.0}, "Of the pattern's variation.");
}
template <class V>
void visit_fields(PromptObject& o, V&& v) {
    v("kind", o.kind, Rule{.needed = true, .always = true}, "The kind that was asked for.");
    v("words", o.words, Rule{}, "As they were said.");
    for (const auto& [key, member] : {std::pair{"color", &PromptObject::color},
                                      {"color2", &PromptObject::color2},
                                      {"material", &PromptObject::material},
                                      {"pattern", &PromptObject::pattern},
                                      {"size", &PromptObject::size},
                                      {"holder_color", &PromptObject::holder_color},
                                      {"holder_material", &PromptObject::holder_material},
                                      {"back_color", &PromptObject::back_color},
                                      {"back_material", &PromptObject::back_material},
                                      {"style", &PromptObject::style},
                                      {"relation", &PromptObject::relation},
                                      {"relation_to", &PromptObject::relation_to},
                                      {"relation_and", &PromptObject::relation_and}})
        v(key, o.*member, Rule{}, "As it was said.");
    v("size_m", o.size_m, Rule{.low = 0}, "Width, height and depth that were said; 0: none.");
    v("count", o.count, Rule{.low = 0, .high = 1000}, "How many were asked for.");
    v("forbidden", o.forbidden, Rule{}, "There is to be none.");
}
template <class V>
void visit_fields(DocumentThing& t, V&& v) {
    v("id", t.id, Rule{.needed = true, .always = true}, "Its name within the room: unique.");
    v("kind", t.kind, Rule{.needed = true, .always = true}, "What it is: a class of furniture.");
    v("position", t.position, Rule{.needed = true, .always = true},
      "Of its base in the room: x to the left of who faces the far wall, y up, z to that wall.");
    v("yaw_deg", t.yaw, Rule{.low = -720, .high = 720, .always = true, .degrees = true},
      "Its turn about the vertical; 0: it faces the far wall (+z), 90: wall 1 (+x).");
    v("size_m", t.size_m, Rule{.low = 0},
      "Width, height and depth. Others than it is built in scale it; without it, it is as usual.");
    v("on", t.on, Rule{}, "Id of what carries it.");
    v("below", t.below, Rule{}, "Id of the table that it stands under.");
    v("with", t.with, Rule{}, "Id of what it was placed by.");
    v("window", t.window, Rule{.low = -1, .high = 1000},
      "Index of the opening on whose sill it stands, or in which it hangs.");
    v("color", t.color, Rule{}, "Color of its main part, by name or as #rrggbb; empty: as the style has it.");
    v("color2", t.color2, Rule{}, "Second color of its pattern.");
    v("material", t.material, Rule{}, "Material of its main part, by name.");
    v("pattern", t.pattern, Rule{}, "Pattern or form, by name.");
    v("holder_color", t.holder_color, Rule{}, "Of what holds it: a bouquet's vase, a bunk's bedding, a worktop.");
    v("holder_material", t.holder_material, Rule{}, "Of the same.");
    v("back_color", t.back_color, Rule{}, "Of the wall behind a worktop.");
    v("back_material", t.back_material, Rule{}, "Of the same.");
    v("style", t.style, Rule{}, "Its style, if it is not the room's.");
    v("seed", t.seed, Rule{.always = true}, "Of its variation.");
    v("cooks", t.cooks, Rule{}, "kitchen_counter: with oven, hob and hood.");
    v("screens", t.screens, Rule{.low = 0, .high = 10}, "Desks: how many monitors will stand on it.");
    v("size_factor", t.size_factor, Rule{.low = 0.25, .high = 4}, "Of the usual size.");
    v("asked_size_m", t.asked_size_m, Rule{.low = 0}, "The extents asked of its builder; 0: as usual.");
    v("model", t.model, Rule{}, "Path of its model in the furniture pack.");
    v("mount", t.mount, Rule{}, "How it stands or hangs, where that is not as usual.");
    v("flat", t.flat, Rule{}, "One may stand on it; without it, rugs.");
    v("overhead", t.overhead, Rule{}, "One may stand below it; without it, what hangs from the ceiling.");
    v("lit", t.lit, Rule{.low = 0, .high = 1},
      "Share of its light that a lamp, a candle or a fire gives; without it, as the room's lamps do.");
    v("asked", t.asked, Rule{}, "What of a prompt or an edit it is.");
}
template <class V>
void visit_fields(DocumentPlan& p, V&& v) {
    v("width_m", p.width, Rule{.low = 0}, "Inside, along x.");
    v("depth_m", p.depth, Rule{.low = 0}, "Inside, along z.");
    v("height_m", p.height, Rule{.low = 0}, "Inside.");
    v("polygon", p.polygon, Rule{},
      "In place of width, depth and blocks: the corners (x, z) in order; right angles, but for corners of "
      "the box that are cut off.");
    v("blocks", p.blocks, Rule{}, "Parts of the box that are not room.");
    v("platforms", p.platforms, Rule{}, "Parts of the floor that are raised: tiers of seats with their steps.");
    v("openings", p.openings, Rule{}, "Windows, doors and doorways; without it, as rooms of the type have them.");
    v("skylights", p.skylights, Rule{}, "Windows in a sloped ceiling.");
    v("knee_m", p.knee, Rule{.low = 0},
      "Height at which a sloped ceiling begins at the walls 1 and 3; 0: it is level.");
    v("slope_run_m", p.slope_run, Rule{.low = 0}, "How far from the wall the slope reaches the full height.");
    v("measured", p.measured, Rule{}, "Width or depth were said.");
    v("accent_wall", p.accent_wall, Rule{.low = 0, .high = 3}, "The wall in the accent material.");
    v("beams", p.beams, Rule{}, "Beams below the ceiling.");
    v("tray", p.tray, Rule{}, "The ceiling steps down along the walls.");
    v("neon", p.neon, Rule{}, "Strips of colored light below the ceiling.");
    v("neon_color", p.neon_color, Rule{.low = 0, .high = kMostColor, .color = true},
      "Their color; without it pink and blue.");
    v("recessed_lights", p.recessed_lights, Rule{}, "Small lamps sunk into the ceiling.");
    v("coffers", p.coffers, Rule{}, "A grid of beams below the ceiling.");
    v("bay", p.bay, Rule{}, "The recess of the far wall is all window.");
    v("wall_relief", p.wall_relief, Rule{}, "What walls are built of, beyond their material.");
    v("cabin", p.cabin, Rule{}, "Of a vehicle or a lift: thin panels, no skirting, panes in rubber.");
    v("cove_m", p.cove, Rule{.low = 0, .high = 1}, "Radius of the curve between the walls 1 and 3 and the ceiling.");
    v("mezzanine_m", p.mezzanine.depth, Rule{.low = 0}, "Depth of a mezzanine, from the far wall; 0: there is none.");
    v("mezzanine_floor_m", p.mezzanine.floor, Rule{.low = 0}, "Height of its floor.");
    v("mezzanine_stairs", p.mezzanine.stairs_wall, Rule{.low = 1, .high = 3}, "The wall of its stairs: 1 or 3.");
    v("vault", p.vault, Rule{}, "The shape of a ceiling that is not level.");
    v("spring_m", p.spring, Rule{.low = 0}, "Height at the walls at which a vault begins.");
    v("oculus_m", p.oculus, Rule{.low = 0, .high = 2}, "Radius of an opening to the sky at the top of a dome.");
    v("tunnel", p.tunnel, Rule{}, "The windows show the wall of a tunnel, and no daylight comes in.");
    v("panelling", p.panelling, Rule{}, "Walls are panelled to the height of a chair's back.");
    v("asked", p.asked, Rule{}, "What was said of windows, doors and other parts of the shell.");
}
// `member`: the style's material that the field stands for.
template <class V>
void visit_surfaces(DocumentSurfaces& s, V&& v) {
    v("floor", s.floor, &Style::floor, "The floor.");
    v("wall", s.wall, &Style::wall, "The walls.");
    v("accent_wall", s.accent_wall, &Style::accent_wall, "The wall that stands out.");
    v("ceiling", s.ceiling, &Style::ceiling, "The ceiling.");
    v("trim", s.trim, &Style::trim, "Mouldings, frames and doors.");
    v("wood", s.wood, &Style::wood, "Of furniture.");
    v("wood2", s.wood2, &Style::wood2, "The second wood of furniture.");
    v("metal", s.metal, &Style::metal, "Of furniture.");
    v("fabric", s.fabric, &Style::fabric, "Of furniture.");
    v("fabric2", s.fabric2, &Style::fabric2, "The second fabric of furniture.");
    v("leather", s.leather, &Style::leather, "Of furniture.");
    v("curtain", s.curtain, &Style::curtain, "Curtains.");
    v("rug", s.rug, &Style::rug, "Rugs.");
    v("tap", s.tap, &Style::tap, "Taps.");
    v("wet_wall", s.wet_wall, &Style::wet_wall, "Tiled walls.");
    v("wet_floor", s.wet_floor, &Style::wet_floor, "Tiled floors.");
}
template <class V>
void visit_fields(DocumentSurfaces& s, V&& v) {
    visit_surfaces(s, [&](std::string_view key, std::optional<Material>& m, Material Style::*, std::string_view said) {
        v(key, m, Rule{}, said);
    });
    v("wall_0", s.walls[0], Rule{}, "The far wall, where it is not like the others.");
    v("wall_1", s.walls[1], Rule{}, "Wall 1, at +x.");
    v("wall_2", s.walls[2], Rule{}, "Wall 2, the near one.");
    v("wall_3", s.walls[3], Rule{}, "Wall 3, at -x.");
    v("palette", s.palette, Rule{.low = 0, .high = kMostColor, .color = true},
      "Six colors of cushions, books, art and vases; the first is the accent.");
    v("shelves", s.shelves, Rule{}, "What stands on shelves.");
}
template <class V>
void visit_fields(DocumentLight& l, V&& v) {
    v("hour", l.hour, Rule{.names = {"morning", "day", "evening", "dusk", "night"}}, "Of the day.");
    v("weather", l.weather, Rule{.names = {"sunny", "overcast", "rainy", "snowy"}}, "Without it a few clouds.");
    v("outlook", l.outlook, Rule{.names = {kNamesOf<Sky::View>.begin(), kNamesOf<Sky::View>.end()}},
      "What the windows show.");
    v("light", l.light, Rule{.names = {"bright", "dim", "lamps on", "neon"}}, "What was said of the light.");
    v("mood", l.mood, Rule{.names = {"cozy", "airy", "colorful"}}, "Of the room: cozy ones are lit warmly.");
    v("lamps", l.lamps, Rule{.low = 0, .high = 1},
      "Share of their light that lamps give; without it, as the hour asks.");
    v("towards_sun", l.towards_sun, Rule{.low = -1, .high = 1},
      "Direction of the sun or the moon; without it, it shines through the first window.");
}
template <class V>
void visit_fields(DocumentCamera& c, V&& v) {
    v("position", c.position, Rule{.needed = true, .always = true}, "Of the first panorama.");
    v("looks", c.looks, Rule{.low = -1, .high = 1}, "Where the middle of the picture looks: level, of length 1.");
}
template <class V>
void visit_fields(DocumentNextRoom& n, V&& v) {
    v("room", n.type, Rule{.needed = true, .always = true}, "Its type.");
    v("room_from_next", n.room_from_next, Rule{.needed = true, .always = true},
      "From its frame into the room's: four rows of four.");
    v("plan", n.plan, Rule{.needed = true, .always = true}, "The empty room; its wall 2 is the back of ours.");
    v("surfaces", n.surfaces, Rule{}, "Materials that are not the style's.");
    v("things", n.things, Rule{.always = true}, "What stands in it, in the frame of the first room.");
}
template <class V>
void visit_fields(RoomDocument& d, V&& v) {
    v("room", d.type, Rule{.needed = true, .always = true}, "Its type: bedroom, living, kitchen …");
    v("style", d.style, Rule{.always = true}, "Its style: modern, japandi …; without it, one that such rooms have.");
    v("prompt", d.prompt, Rule{}, "The words it came from; what is drawn by chance is drawn by them.");
    v("seed", d.seed, Rule{}, "Of what is drawn by chance.");
    v("furnish", d.furnish, Rule{}, "Complete it as a room of its type has it; what the document says stays.");
    v("light", d.light, Rule{.always = true}, "Hour, weather, and what the lamps do.");
    v("camera", d.camera, Rule{}, "Of the first panorama; without it, where most is seen.");
    v("plan", d.plan, Rule{.always = true}, "The empty room.");
    v("surfaces", d.surfaces, Rule{}, "Materials that are not the style's.");
    v("things", d.things, Rule{.always = true}, "What stands, lies and hangs in it, in any order.");
    v("next_room", d.next_room, Rule{}, "The room behind the doorway.");
}

// Keys of panorama/room.json that follow from the room, and are not read.
struct Derived {
    std::string_view key, sentence;
};
inline constexpr std::array<Derived, 4> kDerived{{{"objects", "What the panorama shows, with poses in its frame."},
                                                  {"bounds_m", "The room's box in the panorama's frame."},
                                                  {"sun_direction", "In the panorama's frame."},
                                                  {"windows", "How many openings let light in."}}};

}  // namespace document_fields
}  // namespace fastscene
