// What a prompt says of the room as a whole, in the plan: sizes in metres, "everything is pink", "not brown".
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/prints.h"
#include "fastscene/rooms/user_texture.h"

namespace fastscene {

// Color and material wishes of a surface of the shell.
void apply_wish(Material& m, const PromptObject& wish, bool boarded, std::span<const Vec3f> palette) {
    const float scale = m.scale_m;
    if (const auto material = wish.material.empty() ? std::nullopt : material_named(wish.material)) {
        // Wood comes as boards on floors and walls; bare grain is for furniture.
        const bool herringbone = m.pattern == Pattern::herringbone || m.pattern == Pattern::parquet;
        m = *material;
        if (boarded && m.pattern == Pattern::wood)
            m.pattern = herringbone ? Pattern::herringbone : Pattern::planks, m.scale_m = herringbone ? 0.08f : 0.12f;
    } else if (!wish.material.empty()) {
        m = texture_called(wish.material);  // all other names of the lexicon are materials
    }
    if (!(m.scale_m > 0.f)) m.scale_m = scale;
    if (const auto color = wish.color.empty() ? std::nullopt : color_named(wish.color)) {
        // The pattern's other colors keep their relation to the main one.
        const float ratio_b = luminance(m.color_b) / std::max(0.02f, luminance(m.color_a)),
                    ratio_c = luminance(m.color_c) / std::max(0.02f, luminance(m.color_a));
        m.color_a = *color;
        m.color_b = *color * std::clamp(ratio_b, 0.6f, 1.4f);
        m.color_c = *color * std::clamp(ratio_c, 0.6f, 1.4f);
    }
    const auto second = wish.color2.empty() ? std::nullopt : color_named(wish.color2);
    // Tiles of two colors alternate.
    const bool two_tiles = wish.pattern.empty() && second &&
                           is_one_of(wish.material, {"tile", "marble", "vinyl", "linoleum"});
    print_on(m, two_tiles ? "checkered" : wish.pattern,
             wish.material == "carpet" ? PrintGround::rug : PrintGround::paper, second,
             wish.color.empty() ? palette : std::span<const Vec3f>{});
}

void apply_fittings(Style& style, const PromptObject& wish) {
    // "gold" is a color and a metal: of taps it is the metal.
    std::optional<Material> metal = wish.material.empty() ? std::nullopt : material_named(wish.material);
    if (!metal && is_one_of(wish.color, {"gold", "golden", "brass", "copper", "silver", "chrome"}))
        metal = material_named(wish.color);
    if (!metal && !wish.color.empty()) {
        metal = material_named("iron");
        metal->name = wish.color + " metal";
        if (const auto color = color_named(wish.color)) metal->color_a = metal->color_b = metal->color_c = *color;
    }
    if (metal) style.metal = style.tap = *metal;
}

void cover_everything(const PromptObject& everything, Plan& plan) {
    if (everything.kind.empty()) return;
    Style& s = plan.style;
    for (Material* m : {&s.wall, &s.accent_wall, &s.floor, &s.ceiling}) apply_wish(*m, everything, true);
    if (everything.color.empty()) return;
    PromptObject color;
    color.color = everything.color;
    for (Material* m : {&s.trim, &s.wood, &s.wood2, &s.fabric, &s.fabric2, &s.leather, &s.curtain, &s.rug})
        apply_wish(*m, color);
    // Shades of it, so that shapes stay apart.
    const Vec3f base = *color_named(everything.color);
    constexpr std::array<float, 6> kShades{1.f, 0.75f, 1.2f, 0.6f, 0.9f, 1.1f};
    for (std::size_t i = 0; i < s.palette.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            s.palette[i][c] = std::clamp(base[c] * kShades[i % kShades.size()], 0.03f, 0.85f);
}

void avoid_colors(PromptSpec& spec) {
    static constexpr std::array<const char*, 6> kOthers{"off white",  "sage",     "slate blue",
                                                        "terracotta", "charcoal", "mustard"};
    constexpr float kApart = 0.3f;  // in linear albedo
    for (PromptObject& o : spec.objects) {
        const auto not_this = o.not_color.empty() || !o.color.empty() ? std::nullopt : color_named(o.not_color);
        if (!not_this) continue;
        for (const char* name : kOthers)
            if (length(*color_named(name) - *not_this) > kApart) {
                o.color = name;
                spec.assumed.push_back("color of the " + o.words + ": " + name + ", as not " + o.not_color);
                break;
            }
    }
}

namespace {

constexpr float kLeastSide = 2.2f, kUsualMostSide = 10.f, kLeastHeight = 2.1f, kUsualMostHeight = 6.f;

std::string metres(float value) {
    const int centimetres = static_cast<int>(std::lround(value * 100));
    return std::to_string(centimetres / 100) + "." + std::to_string(centimetres / 10 % 10) +
           std::to_string(centimetres % 10) + " m";
}

}  // namespace

void take_measures(const PromptSpec& spec, Plan& plan) {
    const Vec3f& said = spec.size_m;
    const RoomType& type = room_type(spec.room);
    constexpr float kBeyondUsual = 1.3f;  // who says how large it is may have it larger than halls usually are
    const float most_side = std::max(
        {kUsualMostSide, kBeyondUsual * type.width_high_m, kBeyondUsual * type.depth_high_m});
    const float most_height = std::max(kUsualMostHeight, type.height_high_m);
    if (spec.area_m2 > 0) {
        const float grow = std::sqrt(spec.area_m2 / (plan.width * plan.depth));
        plan.width = std::clamp(plan.width * grow, kLeastSide, most_side);
        plan.depth = std::clamp(spec.area_m2 / plan.width, kLeastSide, most_side);
    }
    if (said.x > 0) plan.width = std::clamp(said.x, kLeastSide, most_side);
    if (said.z > 0) plan.depth = std::clamp(said.z, kLeastSide, most_side);
    if (said.y > 0) plan.height = std::clamp(said.y, kLeastHeight, most_height);
    plan.measured = said.x > 0 || said.z > 0 || spec.area_m2 > 0;
}

void tell_measures(PromptSpec& spec, const Plan& plan) {
    constexpr float kOff = 0.05f;
    const Vec3f& said = spec.size_m;
    const bool kept = (!(said.x > 0) || std::abs(said.x - plan.width) < kOff) &&
                      (!(said.z > 0) || std::abs(said.z - plan.depth) < kOff) &&
                      (!(said.y > 0) || std::abs(said.y - plan.height) < kOff) &&
                      (!(spec.area_m2 > 0) || std::abs(spec.area_m2 - plan.width * plan.depth) < 0.02f * spec.area_m2);
    if (kept) return;
    for (PromptWord& word : spec.words)
        if (word.measure && word.object < 0) {
            word.fate = PromptWord::Fate::approximated;
            word.meaning = "the room is " + metres(plan.width) + " by " + metres(plan.depth) + ", " +
                           metres(plan.height) + " high";
        }
}

}  // namespace fastscene
