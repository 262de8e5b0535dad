#include "fastscene/rooms/materials.h"

#include <algorithm>

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
// Late wood is darker and redder than early wood.
Vec3f late_wood(Vec3f early) { return early * Vec3f{0.66f, 0.57f, 0.47f}; }

}  // namespace

namespace materials {

Material make(std::string name, Pattern pattern, Vec3f a, Vec3f b, float scale, float roughness, float bump) {
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
Material timber(std::string_view kind, float roughness) {
    return make(std::string(kind), Pattern::wood, named(kind), late_wood(named(kind)), 0.1f, roughness, 0.0003f);
}
Material boards(Pattern pattern, std::string_view kind, float width) {
    return make(std::string(kind) + " floor", pattern, named(kind), late_wood(named(kind)), width, 0.4f, 0.0006f);
}
Material cloth(std::string_view color) {
    Material m = make(std::string(color) + " fabric", Pattern::fabric, named(color), darker(named(color), 0.8f), 0.002f,
                      0.85f, 0.0004f);
    m.sheen = 0.12f;
    return m;
}
Material leather(std::string_view color) {
    return make(std::string(color) + " leather", Pattern::leather, named(color), darker(named(color), 0.65f), 0.01f,
                0.42f, 0.0004f);
}
Material veil(std::string_view color, float through) {
    Material m = cloth(color);
    m.name = std::string(color) + " curtain";
    m.transmission = through;
    return m;
}
Material carpet(Pattern pattern, std::string_view a, std::string_view b, std::string_view c) {
    Material m = make(std::string(a) + " rug", pattern, named(a), named(b), 1.f, 1.f, 0.003f);
    m.color_c = named(c);
    return m;
}

Material ceiling_boards(std::string_view color, std::string_view joint, float width) {
    Material m = boards(Pattern::planks, "oak", width);
    m.name = std::string(color) + " ceiling boards";
    m.color_a = m.color_c = named(color);
    m.color_b = named(joint);
    m.roughness = 0.7f;
    return m;
}
Material tiles(Pattern pattern, std::string_view color, std::string_view grout, float size) {
    Material m = *material_named(pattern == Pattern::marble     ? "marble"
                                 : pattern == Pattern::terrazzo ? "terrazzo"
                                 : pattern == Pattern::concrete ? "concrete"
                                                                : "tile");
    m.pattern = pattern;
    m.color_a = named(color);
    m.color_b = named(grout);
    m.color_c = pattern == Pattern::terrazzo ? m.color_b * 0.6f : m.color_a;
    m.scale_m = size;
    return m;
}

}  // namespace materials

namespace {
using namespace materials;

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

}  // namespace

std::string plain_name(std::string_view name) {
    std::string out(name);
    for (char& c : out) c = c == '-' || c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    for (auto at = out.find("grey"); at != std::string::npos; at = out.find("grey")) out[at + 2] = 'a';
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
    if (first == "linen") return base;                      // "linen red" is cloth
    if (const auto fine = color_named(first)) return fine;  // "olive green", "mustard yellow"
    return std::nullopt;
}

std::optional<Material> material_named(std::string_view name) {
    const std::string n = plain_name(name);
    for (const auto kind : {"oak", "walnut", "teak", "mahogany", "cherry", "maple", "pine", "birch", "ebony"})
        if (n == kind || n == std::string(kind) + " wood") return timber(kind);
    if (n == "wood" || n == "wooden" || n == "timber") return timber("oak");
    if (n == "bamboo") return timber("wheat");
    if (n == "leather") return leather("cognac");
    if (n == "velvet") {
        Material m = cloth("emerald");
        m.name = "velvet";
        m.roughness = 0.6f;
        m.sheen = 0.6f;
        return m;
    }
    if (n == "voile" || n == "sheer") return materials::veil("white", 0.6f);
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
    if (n == "cork") {
        Material m = make("cork", Pattern::terrazzo, named("tan"), named("brown"), 0.008f, 0.8f);
        m.color_c = named("sand");
        return m;
    }
    // In grains, as floors of gyms have it.
    if (n == "rubber")
        return make("rubber", Pattern::terrazzo, {0.05f, 0.05f, 0.055f}, {0.08f, 0.08f, 0.09f}, 0.015f, 0.8f);
    if (n == "linoleum" || n == "vinyl")
        return make(n, Pattern::terrazzo, named("stone"), named("stone") * 0.85f, 0.02f, n == "vinyl" ? 0.25f : 0.35f);
    if (n == "carpet") return carpet(Pattern::carpet, "ash", "silver", "white");
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
