#include "fastscene/rooms/style.h"

#include <algorithm>
#include <array>

#include "fastscene/base/error.h"
#include "fastscene/image/color.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene {
namespace {

// Nothing in a room is brighter than fresh paint, or darker than soot; a strong color may lack one of the three almost
// wholly.
Vec3f real_paint(Vec3f c) {
    constexpr float kLeast = 0.012f, kSoot = 0.03f, kMost = 0.85f;
    c = {std::clamp(c.x, kLeast, kMost), std::clamp(c.y, kLeast, kMost), std::clamp(c.z, kLeast, kMost)};
    const float lift = std::max(0.f, kSoot - luminance(c));
    return c + Vec3f{lift, lift, lift};
}
Vec3f srgb(std::uint32_t rgb) {
    const Vec3f c = linear_from_srgb8(
        {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)});
    return real_paint(c);
}
Vec3f named(std::string_view name) { return *color_named(name); }
Vec3f darker(Vec3f c, float f) { return c * f; }

Material make(std::string name, Pattern pattern, Vec3f a, Vec3f b, float scale, float roughness, float bump = 0.f) {
    Material m;
    m.name = std::move(name);
    m.pattern = pattern;
    m.color_a = a;
    m.color_b = b;
    m.color_c = a;
    m.scale_m = scale;
    m.roughness = roughness;
    m.bump_m = bump;
    return m;
}
Material paint(std::string_view color) {
    return make(std::string(color) + " paint", Pattern::plaster, named(color), named(color), 0.1f, 0.75f, 0.0003f);
}
Material timber(std::string_view kind, float roughness = 0.45f) {
    return make(std::string(kind), Pattern::wood, named(kind), darker(named(kind), 0.62f), 0.1f, roughness, 0.0003f);
}
Material boards(Pattern pattern, std::string_view kind, float width) {
    return make(std::string(kind) + " floor", pattern, named(kind), darker(named(kind), 0.66f), width, 0.4f, 0.0006f);
}
Material cloth(std::string_view color) {
    return make(std::string(color) + " fabric", Pattern::fabric, named(color), darker(named(color), 0.8f), 0.002f,
                0.85f, 0.0004f);
}
Material hide(std::string_view color) {
    return make(std::string(color) + " leather", Pattern::leather, named(color), darker(named(color), 0.65f), 0.01f,
                0.42f, 0.0004f);
}
Material alloy(std::string_view color, Vec3f tint, float roughness) {
    Material m = make(std::string(color), Pattern::metal, tint, tint, 0.05f, roughness);
    m.metal = 1.f;
    return m;
}
Material black_metal() {
    Material m = make("black metal", Pattern::plain, {0.035f, 0.035f, 0.037f}, {0.035f, 0.035f, 0.037f}, 0.05f, 0.45f);
    return m;
}
// Burnt unevenly, in soft mortar; in full red a wall of it would shout. More yellow than blue: the light of a room and
// film make it pink else.
Material red_brick() {
    Material m = make("red brick", Pattern::brick, {0.27f, 0.088f, 0.048f}, named("stone") * 0.8f, 0.065f, 0.85f,
                      0.006f);
    m.color_c = {0.085f, 0.045f, 0.036f};
    return m;
}
Material brass() { return alloy("brass", {0.72f, 0.52f, 0.22f}, 0.3f); }
Material chrome() { return alloy("chrome", {0.62f, 0.63f, 0.64f}, 0.18f); }
Material veil(std::string_view color, float through) {
    Material m = cloth(color);
    m.name = std::string(color) + " curtain";
    m.transmission = through;
    return m;
}
Material carpet_of(Pattern pattern, std::string_view a, std::string_view b, std::string_view c) {
    Material m = make(std::string(a) + " rug", pattern, named(a), named(b), 1.f, 1.f, 0.003f);
    m.color_c = named(c);
    return m;
}
std::vector<Vec3f> palette_of(std::initializer_list<std::string_view> names) {
    std::vector<Vec3f> out;
    for (const auto n : names) out.push_back(named(n));
    return out;
}

std::vector<Style> make_styles() {
    const Material white_ceiling = paint("white");
    const Material white_trim = make("white trim", Pattern::plain, named("white"), named("white"), 0.1f, 0.4f);
    std::vector<Style> all;
    // name, floor, wall, accent, ceiling, trim, wood, wood2, metal, fabric, fabric2, leather, curtain, rug, palette, …
    all.push_back({"modern",
                   boards(Pattern::planks, "oak", 0.125f),
                   paint("white"),
                   paint("slate"),
                   white_ceiling,
                   white_trim,
                   timber("walnut"),
                   timber("oak"),
                   black_metal(),
                   cloth("gray"),
                   cloth("charcoal"),
                   hide("black"),
                   veil("white", 0.45f),
                   carpet_of(Pattern::rug, "off white", "ash", "silver"),
                   palette_of({"teal", "mustard", "charcoal", "white", "slate", "rust"}),
                   LampFamily::dome,
                   LegType::metal_frame,
                   SofaType::block,
                   Mouldings::none,
                   1,
                   1,
                   0.4f,
                   0.4f,
                   2.75f,
                   false,
                   {10.f, 7.8f, 5.4f}});
    all.push_back({"scandinavian",
                   boards(Pattern::planks, "birch", 0.115f),
                   paint("white"),
                   paint("duck egg"),
                   white_ceiling,
                   white_trim,
                   timber("birch"),
                   timber("oak"),
                   black_metal(),
                   cloth("light greige"),
                   cloth("cream"),
                   hide("camel"),
                   veil("linen", 0.5f),
                   carpet_of(Pattern::rug, "cream", "charcoal", "silver"),
                   palette_of({"sage", "dusty pink", "mustard", "charcoal", "cream", "sky"}),
                   LampFamily::drum,
                   LegType::tapered,
                   SofaType::slim,
                   Mouldings::plain,
                   2,
                   2,
                   0.7f,
                   0.55f,
                   2.6f,
                   false,
                   {9.f, 6.8f, 4.4f}});
    all.push_back({"japandi",
                   boards(Pattern::planks, "natural", 0.15f),
                   paint("greige"),
                   make("oak slats", Pattern::planks, named("oak"), darker(named("oak"), 0.6f), 0.055f, 0.5f, 0.002f),
                   white_ceiling,
                   timber("oak"),
                   timber("oak"),
                   timber("ebony"),
                   black_metal(),
                   cloth("oatmeal"),
                   cloth("stone"),
                   hide("taupe"),
                   veil("linen", 0.5f),
                   carpet_of(Pattern::carpet, "oatmeal", "sand", "taupe"),
                   palette_of({"clay", "sage", "charcoal", "oatmeal", "taupe", "olive"}),
                   LampFamily::paper,
                   LegType::tapered,
                   SofaType::slim,
                   Mouldings::none,
                   1,
                   3,
                   0.5f,
                   0.25f,
                   2.5f,
                   false,
                   {9.f, 7.f, 4.8f}});
    all.push_back({"industrial",
                   make("concrete floor", Pattern::concrete, {0.2f, 0.183f, 0.162f}, {0.135f, 0.122f, 0.108f}, 0.6f,
                        0.5f, 0.0006f),
                   paint("ash"),
                   red_brick(),
                   make("concrete ceiling", Pattern::concrete, {0.36f, 0.345f, 0.32f}, {0.27f, 0.255f, 0.235f}, 0.6f,
                        0.8f, 0.0006f),
                   black_metal(),
                   timber("honey oak", 0.6f),
                   timber("walnut", 0.6f),
                   black_metal(),
                   cloth("charcoal"),
                   cloth("umber"),
                   hide("cognac"),
                   veil("gray", 0.3f),
                   carpet_of(Pattern::rug, "rust", "midnight", "sand"),
                   palette_of({"rust", "charcoal", "mustard", "denim", "umber", "stone"}),
                   LampFamily::cage,
                   LegType::metal_frame,
                   SofaType::block,
                   Mouldings::none,
                   3,
                   4,
                   0.4f,
                   0.6f,
                   3.2f,
                   true,
                   {11.f, 7.2f, 3.8f}});
    all.push_back({"classic",
                   boards(Pattern::herringbone, "oak", 0.09f),
                   paint("ivory"),
                   make("damask wallpaper", Pattern::damask, named("sage"), named("eucalyptus"), 0.45f, 0.7f),
                   white_ceiling,
                   white_trim,
                   timber("mahogany", 0.3f),
                   timber("cherry", 0.3f),
                   brass(),
                   cloth("champagne"),
                   cloth("burgundy"),
                   hide("oxblood"),
                   veil("wine", 0.12f),
                   carpet_of(Pattern::rug, "burgundy", "navy", "champagne"),
                   palette_of({"burgundy", "gold", "navy", "ivory", "forest", "rose"}),
                   LampFamily::candelabra,
                   LegType::turned,
                   SofaType::rolled,
                   Mouldings::rich,
                   2,
                   4,
                   0.4f,
                   0.6f,
                   3.1f,
                   false,
                   {9.f, 6.2f, 3.6f}});
    all.push_back({"boho",
                   boards(Pattern::planks, "pine", 0.11f),
                   paint("cream"),
                   paint("terracotta"),
                   white_ceiling,
                   white_trim,
                   timber("teak"),
                   timber("pine"),
                   brass(),
                   cloth("oatmeal"),
                   cloth("terracotta"),
                   hide("caramel"),
                   veil("cream", 0.5f),
                   carpet_of(Pattern::rug, "terracotta", "cream", "teal"),
                   palette_of({"terracotta", "mustard", "teal", "dusty pink", "olive", "plum"}),
                   LampFamily::paper,
                   LegType::splayed,
                   SofaType::slim,
                   Mouldings::none,
                   2,
                   2,
                   1.f,
                   0.9f,
                   2.7f,
                   false,
                   {10.f, 6.8f, 3.8f}});
    all.push_back({"rustic",
                   boards(Pattern::planks, "teak", 0.145f),
                   paint("cream"),
                   make("rough planks", Pattern::planks, named("umber"), named("chocolate"), 0.18f, 0.75f, 0.003f),
                   paint("ivory"),
                   timber("teak", 0.65f),
                   timber("pine", 0.6f),
                   timber("teak", 0.65f),
                   black_metal(),
                   cloth("linen"),
                   cloth("brick"),
                   hide("brown"),
                   veil("linen", 0.35f),
                   carpet_of(Pattern::rug, "brick", "cream", "olive"),
                   palette_of({"brick", "olive", "mustard", "cream", "denim", "umber"}),
                   LampFamily::drum,
                   LegType::square,
                   SofaType::rolled,
                   Mouldings::plain,
                   2,
                   3,
                   0.6f,
                   0.7f,
                   2.6f,
                   true,
                   {9.f, 6.f, 3.4f}});
    all.push_back({"mid-century",
                   boards(Pattern::parquet, "teak", 0.06f),
                   paint("off white"),
                   paint("petrol"),
                   white_ceiling,
                   timber("walnut"),
                   timber("walnut", 0.35f),
                   timber("teak", 0.35f),
                   brass(),
                   cloth("mustard"),
                   cloth("teal"),
                   hide("cognac"),
                   veil("cream", 0.4f),
                   carpet_of(Pattern::rug, "cream", "burnt orange", "teal"),
                   palette_of({"burnt orange", "teal", "mustard", "olive", "cream", "walnut"}),
                   LampFamily::globe,
                   LegType::tapered,
                   SofaType::slim,
                   Mouldings::none,
                   2,
                   1,
                   0.6f,
                   0.5f,
                   2.6f,
                   false,
                   {10.f, 7.4f, 4.6f}});
    all.push_back({"mediterranean",
                   make("terracotta tiles", Pattern::tile, named("terracotta"), named("sand"), 0.3f, 0.6f, 0.002f),
                   make("lime plaster", Pattern::plaster, named("ivory"), named("cream"), 0.1f, 0.85f, 0.001f),
                   paint("azure"),
                   paint("white"),
                   timber("teak"),
                   timber("teak", 0.55f),
                   timber("pine", 0.55f),
                   black_metal(),
                   cloth("white"),
                   cloth("cobalt"),
                   hide("tan"),
                   veil("white", 0.5f),
                   carpet_of(Pattern::rug, "navy", "cream", "terracotta"),
                   palette_of({"cobalt", "terracotta", "lemon", "white", "turquoise", "olive"}),
                   LampFamily::globe,
                   LegType::turned,
                   SofaType::block,
                   Mouldings::none,
                   2,
                   3,
                   0.8f,
                   0.5f,
                   2.8f,
                   true,
                   {9.f, 6.8f, 4.2f}});
    all.push_back({"art deco",
                   make("checkered marble", Pattern::checker, named("ivory"), named("charcoal"), 0.4f, 0.18f, 0.0005f),
                   paint("champagne"),
                   paint("bottle green"),
                   white_ceiling,
                   make("black trim", Pattern::plain, named("black"), named("black"), 0.1f, 0.25f),
                   timber("ebony", 0.2f),
                   timber("mahogany", 0.22f),
                   brass(),
                   cloth("emerald"),
                   cloth("navy"),
                   hide("black"),
                   veil("champagne", 0.2f),
                   carpet_of(Pattern::rug, "charcoal", "gold", "ivory"),
                   palette_of({"gold", "emerald", "navy", "blush", "charcoal", "ivory"}),
                   LampFamily::globe,
                   LegType::tapered,
                   SofaType::rolled,
                   Mouldings::rich,
                   2,
                   2,
                   0.4f,
                   0.5f,
                   3.f,
                   false,
                   {10.f, 7.4f, 4.4f}});
    for (Style& s : all) {
        s.tap = chrome();
        s.rug.scale_m = 1.2f;
        s.rug.specular = s.fabric.specular = s.fabric2.specular = s.curtain.specular = 0.02f;
    }
    return all;
}
const std::vector<Style>& all_styles() {
    static const std::vector<Style> all = make_styles();
    return all;
}

std::string plain_name(std::string_view name) {
    std::string out(name);
    for (char& c : out) c = c == '-' || c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    for (auto at = out.find("grey"); at != std::string::npos; at = out.find("grey")) out[at + 2] = 'a';
    return out;
}

}  // namespace

const Style& style_named(std::string_view name) {
    for (const Style& s : all_styles())
        if (plain_name(s.name) == plain_name(name)) return s;
    std::string known;
    for (const Style& s : all_styles()) known += (known.empty() ? "" : ", ") + s.name;
    throw Error("style: expected one of {}, found '{}'", known, std::string(name));
}
std::vector<std::string> styles() {
    std::vector<std::string> out;
    for (const Style& s : all_styles()) out.push_back(s.name);
    return out;
}

std::optional<Vec3f> color_named(std::string_view name) {
    const std::string n = plain_name(name);
    if (const auto rgb = lexicon_color(n)) return srgb(*rgb);
    const auto space = n.find(' ');
    if (space == std::string::npos) return std::nullopt;
    const std::string first = n.substr(0, space), rest = n.substr(space + 1);
    const auto base = color_named(rest);
    if (!base) return std::nullopt;
    if (first == "light" || first == "pale" || first == "pastel" || first == "soft" || first == "faded" ||
        first == "powdery")
        return real_paint(lerp(*base, {0.8f, 0.8f, 0.78f}, 0.5f));
    if (first == "dusty" || first == "muted" || first == "smoky" || first == "washed" || first == "dull")
        return real_paint(lerp(*base, {0.45f, 0.43f, 0.42f}, 0.35f));
    if (first == "dark" || first == "deep") return real_paint(*base * 0.4f);
    if (first == "bright" || first == "vivid" || first == "neon" || first == "electric")
        return real_paint(*base * 1.2f);
    if (first == "warm") return real_paint(*base * Vec3f{1.06f, 1.f, 0.9f});
    if (first == "cool" || first == "cold" || first == "icy") return real_paint(*base * Vec3f{0.92f, 1.f, 1.08f});
    if (first == "rich" || first == "medium" || first == "classic" || first == "pure" || first == "natural" ||
        first == "matte")
        return base;
    if (const auto fine = color_named(first)) return fine;  // "olive green", "mustard yellow"
    return std::nullopt;
}

std::optional<Material> material_named(std::string_view name) {
    const std::string n = plain_name(name);
    for (const auto kind : {"oak", "walnut", "teak", "mahogany", "cherry", "maple", "pine", "birch", "ebony"})
        if (n == kind || n == std::string(kind) + " wood") return timber(kind);
    if (n == "wood" || n == "wooden" || n == "timber") return timber("oak");
    if (n == "bamboo") return timber("wheat");
    if (n == "leather") return hide("cognac");
    if (n == "velvet") {
        Material m = cloth("emerald");
        m.name = "velvet";
        m.roughness = 0.6f;
        return m;
    }
    if (n == "fabric" || n == "cloth" || n == "cotton" || n == "linen" || n == "silk" || n == "textile")
        return cloth("linen");
    if (n == "wool" || n == "knit" || n == "knitted")
        return make("wool", Pattern::knit, named("cream"), named("sand"), 0.012f, 0.9f, 0.003f);
    if (n == "rattan" || n == "wicker" || n == "cane")
        return make("wicker", Pattern::wicker, named("tan"), named("umber"), 0.02f, 0.7f, 0.003f);
    if (n == "marble") return make("marble", Pattern::marble, named("white"), named("slate"), 0.5f, 0.15f);
    if (n == "terrazzo") return make("terrazzo", Pattern::terrazzo, named("ivory"), named("terracotta"), 0.03f, 0.3f);
    if (n == "granite" || n == "stone" || n == "slate")
        return make(n, Pattern::concrete, named(n == "slate" ? "slate" : "stone"), named("gray"), 0.3f, 0.4f);
    if (n == "concrete" || n == "cement")
        return make("concrete", Pattern::concrete, named("concrete"), named("gray"), 0.6f, 0.7f, 0.0006f);
    if (n == "brick" || n == "bricks") return red_brick();
    if (n == "tile" || n == "tiles" || n == "tiled" || n == "ceramic" || n == "porcelain")
        return make("tiles", Pattern::tile, named("white"), named("silver"), 0.2f, 0.2f, 0.002f);
    if (n == "carpet") return carpet_of(Pattern::carpet, "ash", "silver", "white");
    if (n == "planks") return boards(Pattern::planks, "oak", 0.12f);
    if (n == "parquet") return boards(Pattern::herringbone, "oak", 0.08f);
    if (n == "plaster") return paint("off white");
    if (n == "brass" || n == "gold" || n == "golden") return brass();
    if (n == "copper") return alloy("copper", {0.75f, 0.4f, 0.26f}, 0.28f);
    if (n == "chrome" || n == "steel" || n == "stainless steel" || n == "silver" || n == "aluminium") return chrome();
    if (n == "metal" || n == "iron" || n == "wrought iron") return black_metal();
    if (n == "plastic" || n == "lacquer" || n == "lacquered" || n == "painted")
        return make("lacquer", Pattern::plain, named("white"), named("white"), 0.1f, 0.25f);
    if (n == "glass") {
        Material m = make("glass", Pattern::plain, {0.6f, 0.68f, 0.66f}, {0.6f, 0.68f, 0.66f}, 0.1f, 0.05f);
        m.specular = 0.08f;
        m.transmission = 0.8f;
        return m;
    }
    return std::nullopt;
}

}  // namespace fastscene
