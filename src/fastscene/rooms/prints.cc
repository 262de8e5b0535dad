#include "fastscene/rooms/prints.h"

#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/style.h"

namespace fastscene {
namespace {

struct Print {
    std::string_view name;
    Pattern pattern;
    float cloth_m, paper_m, rug_m;  // size of the motif
    bool quiet = false;             // on paper: tone on tone
};
constexpr Print kPrints[] = {
    {"striped", Pattern::stripes, 0.05f, 0.16f, 0.1f},
    {"floral", Pattern::floral, 0.18f, 0.3f, 0.32f},
    {"damask", Pattern::damask, 0.18f, 0.4f, 0.36f, true},
    {"checkered", Pattern::checker, 0.05f, 0.3f, 0.2f},
    {"dots", Pattern::dots, 0.09f, 0.16f, 0.24f},
    {"zigzag", Pattern::zigzag, 0.1f, 0.22f, 0.24f},
    {"herringbone", Pattern::twill, 0.03f, 0.1f, 0.12f, true},
    {"geometric", Pattern::geometric, 0.11f, 0.2f, 0.28f},
    {"diamonds", Pattern::diamonds, 0.08f, 0.18f, 0.24f},
    {"lattice", Pattern::lattice, 0.13f, 0.26f, 0.34f, true},
    {"stars", Pattern::stars, 0.14f, 0.24f, 0.34f},
    {"gingham", Pattern::gingham, 0.05f, 0.09f, 0.16f},
    {"plaid", Pattern::plaid, 0.17f, 0.34f, 0.4f},
    {"houndstooth", Pattern::houndstooth, 0.06f, 0.12f, 0.2f},
    {"patchwork", Pattern::patchwork, 0.16f, 0.34f, 0.3f},
    {"leopard", Pattern::leopard, 0.24f, 0.36f, 0.42f},
    {"zebra", Pattern::zebra, 0.26f, 0.45f, 0.5f},
    {"camouflage", Pattern::camouflage, 0.3f, 0.6f, 0.6f},
    {"paisley", Pattern::paisley, 0.16f, 0.28f, 0.34f},
    {"encaustic", Pattern::encaustic, 0.18f, 0.2f, 0.3f},
    {"peeling", Pattern::peeling, 0.8f, 0.8f, 0.8f},
};

const Print* print_named(std::string_view name) {
    const auto at = std::find_if(std::begin(kPrints), std::end(kPrints),
                                 [&](const Print& p) { return p.name == name; });
    return at == std::end(kPrints) ? nullptr : &*at;
}

float apart(Vec3f a, Vec3f b) { return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}); }

// A color that shows on this ground.
Vec3f shown_on(Vec3f ground, bool quiet) {
    const Vec3f pale{0.74f, 0.7f, 0.62f};
    const bool dark = luminance(ground) < 0.3f;
    if (quiet) return dark ? lerp(ground, pale, luminance(ground) < 0.08f ? 0.13f : 0.22f) : ground * 0.7f;
    return dark ? lerp(ground, pale, 0.75f) : ground * 0.35f;
}

bool is_paper(Pattern pattern) {
    return std::any_of(std::begin(kPrints), std::end(kPrints),
                       [&](const Print& p) { return p.pattern == pattern && pattern != Pattern::checker; });
}

}  // namespace

bool is_print(std::string_view name) { return print_named(name) != nullptr; }

void print_on(Material& m, std::string_view name, PrintGround ground, std::optional<Vec3f> second,
              std::span<const Vec3f> palette) {
    const Print* print = print_named(name);
    if (!print) return;
    const bool boards = m.pattern == Pattern::planks || m.pattern == Pattern::parquet ||
                        m.pattern == Pattern::herringbone,
               tiled = m.pattern == Pattern::tile || m.pattern == Pattern::subway;
    if (is_one_of(name, {"herringbone", "zigzag"}) && boards) {
        m.pattern = Pattern::herringbone, m.scale_m = 0.08f;
        return;
    }
    if (name == "herringbone" && tiled) {
        m.pattern = Pattern::laid_tiles, m.scale_m = 0.065f;
        m.color_b = second.value_or(luminance(m.color_a) > 0.5f ? Vec3f{0.42f, 0.41f, 0.39f}
                                                                : Vec3f{0.66f, 0.64f, 0.6f});  // the joint
        return;
    }
    if (name == "peeling") {  // of what there is: paint or paper on plaster
        if (m.pattern == Pattern::plaster || m.pattern == Pattern::plain || is_paper(m.pattern))
            m.pattern = Pattern::peeling, m.scale_m = print->paper_m, m.color_b = {0.42f, 0.38f, 0.33f},
            m.bump_m = 0.002f;
        return;
    }
    const bool ornament = is_one_of(name,
                                    {"damask", "floral", "geometric", "lattice", "paisley", "diamonds", "encaustic"});
    m.pattern = tiled && ornament ? Pattern::encaustic : print->pattern;
    m.scale_m = ground == PrintGround::paper || ground == PrintGround::curtain ? print->paper_m
                : ground == PrintGround::rug                                   ? print->rug_m
                                                                               : print->cloth_m;
    m.bump_m = tiled ? m.bump_m : std::min(m.bump_m, 0.001f);
    if (tiled) m.scale_m = name == "checkered" ? 0.3f : 0.2f;
    const bool quiet = ground == PrintGround::paper && print->quiet && !tiled;
    const float strength = ground == PrintGround::paper && !tiled ? 0.5f : 0.85f;  // walls that shout tire
    const auto from_palette = [&](std::size_t i) -> std::optional<Vec3f> {
        // The first of the palette's colors from there that shows.
        for (std::size_t k = 0; k < palette.size(); ++k)
            if (const Vec3f c = lerp(m.color_a, palette[(i + k) % palette.size()], strength);
                apart(c, m.color_a) > 0.14f)
                return c;
        return {};
    };
    if (!second && !quiet) second = from_palette(0);
    m.color_b = second.value_or(shown_on(m.color_a, ground == PrintGround::paper));
    m.color_c = from_palette(1).value_or(lerp(m.color_a, shown_on(m.color_a, false), 0.5f));
    if (quiet) m.color_c = lerp(m.color_a, m.color_b, 0.6f);
}

}  // namespace fastscene
