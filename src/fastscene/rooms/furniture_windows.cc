// What hangs in windows besides curtains: blinds of slats, rolled and folded blinds, shutters, paper screens. They fill
// their opening: size.x by size.y, origin at the middle of the lower edge of the opening's outer plane; what is drawn
// up leaves the lower part free.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

constexpr Vec3f kUsualWindow{1.2f, 1.35f, 0.05f};

// Of cloth: what is dyed deeply lets less through.
int blind_cloth(Kit& k, Material m, float through) {
    m.transmission = through;
    m.specular = 0.02f;
    const int cloth = k.main(std::move(m));
    constexpr float kVeil = 0.5f, kLeast = 0.12f;
    Material& dyed = k.piece.materials[static_cast<std::size_t>(cloth)];
    dyed.transmission = through * std::clamp(luminance(dyed.color_a) / kVeil, kLeast, 1.f);
    return cloth;
}
// Where a drawn blind ends: its share of the window, by the request's seed alone, so that all windows of a room are
// drawn alike.
float drawn(Kit& k, float least, float most) { return Random(k.request.seed, "drawn").uniform(least, most); }

// Painted where the style's wood is painted or dark, of wood where rooms are of wood.
Material slat_material(const Kit& k) {
    if (is_one_of(k.style.name, {"japandi", "boho", "rustic", "mid-century"})) return k.style.wood;
    if (k.style.name == "industrial") return steel();
    return plain("blind", {0.74f, 0.73f, 0.7f}, 0.4f);
}

// Slats on ladder cords between a head rail and a bottom rail, tilted so that light falls in and one sees out between
// them.
void venetian_blind(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    const bool wooden = slat_material(k).pattern == Pattern::wood || k.request.material == "wood" ||
                        k.request.material == "bamboo";
    const int slat = k.main(slat_material(k)), cord = k.material(plain("blind cord", {0.6f, 0.58f, 0.54f}, 0.8f));
    const float deep = 0.046f, thick = wooden ? 0.003f : 0.0014f, pitch = 0.042f, head = 0.045f, w = s.x,
                share = drawn(k, 0.f, 1.f) < 0.7f ? 1.f : 0.62f;
    const float low = s.y * (1.f - share) + 0.004f, top = s.y - head, mid = 0.025f;
    k.board(slat, {0, top, mid}, {w, head, 0.05f}, 0.004f);
    const float tilt = drawn(k, 30.f, 40.f);
    // What is drawn up lies as a stack on the bottom rail.
    const int stacked = share < 1.f ? static_cast<int>((s.y - s.y * share) / pitch) : 0;
    const float stack = static_cast<float>(stacked) * (thick + 0.0012f), rail = 0.022f;
    k.board(slat, {0, low, mid}, {w - 0.004f, rail, 0.042f}, 0.005f);
    Mesh one = shapes::slab(1, 4, thick, [&](float u, float v) {
        return Vec3f{(w - 0.006f) * (u - 0.5f), 0.0035f * (1.f - 4.f * (v - 0.5f) * (v - 0.5f)), deep * (0.5f - v)};
    });
    Mesh slats;
    for (int i = 0; i < stacked; ++i) {
        Mesh flat = one;
        shapes::append(slats,
                       shapes::move(flat, {0, low + rail + (thick + 0.0012f) * (static_cast<float>(i) + 0.6f), mid}));
    }
    shapes::turn(one, {1, 0, 0}, tilt);
    for (float y = low + rail + stack + 0.5f * pitch; y < top - 0.012f; y += pitch) {
        Mesh next = one;
        for (Vec3f& c : next.coords) c = c + Vec3f{k.dice.uniform(0, 3), k.dice.uniform(0, 3), 0};
        shapes::append(slats, shapes::move(next, {0, y, mid}));
    }
    k.add(std::move(slats), slat);
    const int ladders = w > 1.1f ? 3 : 2;
    for (int i = 0; i < ladders; ++i) {
        const float x = (w - 0.3f) * (static_cast<float>(i) / static_cast<float>(ladders - 1) - 0.5f);
        for (const float z : {mid - 0.023f, mid + 0.023f})
            k.rod(cord, {x, low + rail, z}, {x, top, z}, wooden ? 0.0022f : 0.0012f, -1, 5);
    }
    k.rod(cord, {0.5f * w - 0.07f, top - 0.5f * s.y * share, 0.052f}, {0.5f * w - 0.07f, top, 0.052f}, 0.004f, -1, 8);
    k.piece.mount = Mount::wall;
}

// A cloth from a roller, with a bar in its hem; of bamboo, canes side by side.
void roller_blind(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    const bool canes = is_one_of(k.request.material, {"bamboo", "rattan", "wicker", "cane", "wood"});
    const float share = drawn(k, 0.3f, 0.52f), low = s.y * (1.f - share), w = s.x, r = canes ? 0.03f : 0.02f,
                z = 0.026f;
    const int metal = k.material(k.style.metal);
    if (canes) {
        const int cane = k.main(*material_named("bamboo")),
                  cord = k.material(plain("blind cord", {0.42f, 0.33f, 0.2f}, 0.9f));
        Mesh all;
        for (float y = low + 0.012f; y < s.y - 0.012f; y += 0.0105f)
            shapes::append(all, shapes::rod({-0.5f * w + k.dice.uniform(0.f, 0.004f), y, z},
                                            {0.5f * w - k.dice.uniform(0.f, 0.004f), y, z},
                                            0.0042f + 0.0006f * k.dice.uniform(), 0.0042f, 6));
        // What is rolled up hangs as a roll below.
        shapes::append(all, shapes::rod({-0.5f * w, low, z}, {0.5f * w, low, z}, r, r, 18));
        shapes::append(all, shapes::rod({-0.5f * w, s.y - 0.02f, z}, {0.5f * w, s.y - 0.02f, z}, 0.018f, 0.018f, 12));
        k.add(std::move(all), cane);
        for (const float x : {-0.36f * w, 0.36f * w}) {
            k.rod(cord, {x, low - r, z + 0.006f}, {x, s.y, z + 0.006f}, 0.003f, -1, 6);
            Mesh loop = shapes::ring(r + 0.002f, 0.005f, 20);
            shapes::turn(loop, {0, 0, 1}, 90);
            k.add(std::move(loop), cord, {x, low, z});
        }
        k.piece.mount = Mount::wall;
        return;
    }
    Material linen = plain("blind cloth", lerp(k.style.curtain.color_a, {0.7f, 0.68f, 0.63f}, 0.35f), 0.9f);
    linen.pattern = Pattern::fabric;
    linen.scale_m = 0.004f;
    linen.color_b = linen.color_a * 0.86f;
    const int cloth = blind_cloth(k, linen, 0.4f);
    k.rod(cloth, {-0.5f * w + 0.012f, s.y - r - 0.006f, z}, {0.5f * w - 0.012f, s.y - r - 0.006f, z}, r, -1, 24);
    for (const float sx : {-1.f, 1.f})
        k.board(metal, {sx * (0.5f * w - 0.006f), s.y - 0.05f, z}, {0.008f, 0.05f, 0.045f}, 0.002f);
    k.add(shapes::sheet(
              8, 10,
              [&](float u, float v) {
                  return Vec3f{(w - 0.03f) * (u - 0.5f), low + 0.02f + (s.y - r - 0.01f - low - 0.02f) * v, z + r};
              }),
          cloth);
    k.board(metal, {0, low, z + r}, {w - 0.03f, 0.022f, 0.01f}, 0.003f);
    // The chain at one side.
    const float x = 0.5f * w - 0.016f, reach = 0.55f * s.y;
    for (const float dz : {-0.014f, 0.014f})
        k.rod(metal, {x, s.y - reach, z + dz}, {x, s.y - 0.03f, z + dz}, 0.0016f, -1, 5);
    k.piece.mount = Mount::wall;
}

// Cloth drawn up in soft folds over rods.
void roman_blind(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    Material linen = k.style.fabric;
    linen.color_a = lerp(k.style.curtain.color_a, k.style.fabric2.color_a,
                         k.style.mouldings == Mouldings::rich ? 0.8f : 0.3f);
    linen.color_b = linen.color_a * 0.85f;
    const int cloth = blind_cloth(k, linen, 0.24f), metal = k.material(plain("blind rail", {0.7f, 0.69f, 0.66f}, 0.5f));
    const float w = s.x - 0.006f, share = drawn(k, 0.38f, 0.56f), low = s.y * (1.f - share), z = 0.02f, fold = 0.2f;
    k.board(metal, {0, s.y - 0.03f, 0.014f}, {w, 0.03f, 0.028f}, 0.003f);
    // From the top down: flat fields with a slight belly between rods, then the folds that lie before each other.
    std::vector<Vec2f> profile;  // z, y
    const float gathered = low + 0.13f;
    const int fields = std::max(1, static_cast<int>(std::lround((s.y - gathered) / fold)));
    const float field = (s.y - gathered) / static_cast<float>(fields);
    for (int i = 0; i < fields; ++i)
        for (int j = 0; j < 6; ++j) {
            const float t = static_cast<float>(j) / 6.f;
            profile.push_back({z + 0.011f * std::sin(kPi * t) * (0.5f + 0.5f * t),
                               s.y - 0.004f - field * (static_cast<float>(i) + t)});
        }
    profile.push_back({z, gathered});
    profile.push_back({z + 0.004f, low + 0.03f});
    const std::uint32_t seed = k.seed();
    const int rows = static_cast<int>(profile.size()) - 1;
    Mesh m = shapes::sheet(24, rows, [&](float u, float v) {
        const Vec2f p = profile[static_cast<std::size_t>(std::lround((1.f - v) * static_cast<float>(rows)))];
        return Vec3f{w * (u - 0.5f), p.y, p.x + 0.0025f * shapes::wobble({u * 5.f, p.y * 6.f, 0}, seed)};
    });
    for (std::size_t i = 0; i < m.coords.size(); ++i) m.coords[i] = {m.positions[i].x, m.positions[i].y, 0};
    k.add(std::move(m), cloth);
    // What is drawn up: loops of cloth before each other, each hanging a little lower.
    constexpr int kFolds = 3;
    for (int i = 0; i < kFolds; ++i) {
        const float half = 0.05f + 0.008f * static_cast<float>(i),
                    y = low + 0.012f * static_cast<float>(kFolds - 1 - i) + half,
                    out = z + 0.012f + 0.012f * static_cast<float>(i);
        Mesh loop = shapes::sheet(20, 14, [&](float u, float v) {
            const float a = -kTau * v, x = (w - 0.002f) * (u - 0.5f);
            // Thicker where the cloth turns, below.
            return Vec3f{x, y + half * std::cos(a) + 0.002f * shapes::wobble({6 * x, static_cast<float>(i), 2}, seed),
                         out + (0.005f - 0.0022f * std::cos(a)) * std::sin(a) * -1.f};
        });
        for (std::size_t j = 0; j < loop.coords.size(); ++j)
            loop.coords[j] = {loop.positions[j].x, loop.positions[j].y, 0};
        k.add(std::move(loop), cloth);
    }
    k.piece.mount = Mount::wall;
}

// Panels of louvres on hinges, shut, their louvres open.
void shutters(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    Material paint = plain("shutter paint", {0.74f, 0.73f, 0.7f}, 0.4f);
    if (is_one_of(k.style.name, {"japandi", "boho", "rustic", "mid-century"})) paint = k.style.wood;
    if (k.style.name == "industrial") paint = plain("shutter paint", {0.08f, 0.085f, 0.09f}, 0.5f);
    if (k.style.name == "mediterranean") paint = plain("shutter paint", k.style.palette[0], 0.55f);
    const int wood = k.main(paint), metal = k.material(k.style.metal);
    const int panels = std::max(2, 2 * static_cast<int>(std::lround(s.x / 1.1f)));
    const float each = s.x / static_cast<float>(panels), stile = std::min(0.052f, 0.15f * each), rail = 0.075f,
                mid = 0.03f, thick = 0.028f;
    const float tilt = drawn(k, 18.f, 34.f);
    const bool divided = s.y > 1.25f;
    for (int p = 0; p < panels; ++p) {
        const float x = each * (static_cast<float>(p) + 0.5f) - 0.5f * s.x, w = each - 0.004f;
        for (const float sx : {-1.f, 1.f})
            k.board(wood, {x + sx * 0.5f * (w - stile), 0.003f, mid}, {stile, s.y - 0.006f, thick}, 0.003f);
        const float inner = w - 2 * stile, y1 = s.y - 0.003f - rail, half = 0.56f * s.y;
        k.board(wood, {x, 0.003f, mid}, {inner, rail, thick}, 0.003f);
        k.board(wood, {x, y1, mid}, {inner, rail, thick}, 0.003f);
        if (divided) k.board(wood, {x, half, mid}, {inner, 0.06f, thick}, 0.003f);
        const auto louvres = [&](float from, float to) {
            const int count = std::max(1, static_cast<int>(std::lround((to - from) / 0.056f)));
            const float step = (to - from) / static_cast<float>(count);
            Mesh all;
            for (int i = 0; i < count; ++i) {
                Mesh one = shapes::box({inner - 0.004f, 0.0085f, 0.058f}, 0.0035f);
                shapes::lay_grain(one, {k.dice.uniform(0, 3), k.dice.uniform(0, 3), 0});
                shapes::turn(one, {1, 0, 0}, tilt);
                shapes::append(all, shapes::move(one, {x, from + step * (static_cast<float>(i) + 0.5f), mid}));
            }
            k.add(std::move(all), wood);
            k.rod(wood, {x, from + 0.6f * step, mid + 0.034f}, {x, to - 0.6f * step, mid + 0.034f}, 0.005f, -1, 8);
        };
        if (divided) louvres(0.003f + rail, half), louvres(half + 0.06f, y1);
        else louvres(0.003f + rail, y1);
        if (p % 2 == 0)
            for (const float y : {0.16f * s.y, 0.84f * s.y})
                k.board(metal, {x - 0.5f * w + 0.004f, y, mid + 0.015f}, {0.012f, 0.07f, 0.006f}, 0.002f);
        else
            k.add(shapes::ball({x - 0.5f * w + 0.6f * stile, 0.48f * s.y, mid + 0.022f}, {0.01f, 0.01f, 0.011f}, 10),
                  metal);
    }
    k.piece.mount = Mount::wall;
}

// Sliding panels of paper on a lattice, one before the other where they meet.
void shoji(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    const int wood = k.main(k.style.name == "japandi" ? k.style.wood : *material_named("oak"));
    Material rice = plain("shoji paper", {0.72f, 0.7f, 0.65f}, 0.95f);
    rice.transmission = 0.6f;
    rice.specular = 0.02f;
    const int paper = k.material(rice);
    const int panels = std::max(2, static_cast<int>(std::lround(s.x / 0.8f)));
    const float lap = 0.035f, each = (s.x + lap * static_cast<float>(panels - 1)) / static_cast<float>(panels);
    for (int p = 0; p < panels; ++p) {
        const float x = 0.5f * each + (each - lap) * static_cast<float>(p) - 0.5f * s.x,
                    z = p % 2 == 0 ? 0.012f : 0.036f, f = 0.036f, deep = 0.022f;
        for (const float sx : {-1.f, 1.f})
            k.board(wood, {x + sx * 0.5f * (each - f), 0.002f, z}, {f, s.y - 0.004f, deep}, 0.003f);
        for (const float y : {0.002f, s.y - 0.002f - 1.2f * f})
            k.board(wood, {x, y, z}, {each - 2 * f, 1.2f * f, deep}, 0.003f);
        const float inner = each - 2 * f, y0 = 1.2f * f, y1 = s.y - 1.2f * f;
        const int columns = std::max(2, static_cast<int>(std::lround(inner / 0.2f))),
                  rows = std::max(3, static_cast<int>(std::lround((y1 - y0) / 0.26f)));
        for (int i = 1; i < columns; ++i)
            k.board(wood, {x + inner * (static_cast<float>(i) / static_cast<float>(columns) - 0.5f), y0, z + 0.003f},
                    {0.011f, y1 - y0, 0.013f}, 0.002f);
        for (int i = 1; i < rows; ++i)
            k.board(wood, {x, y0 + (y1 - y0) * static_cast<float>(i) / static_cast<float>(rows) - 0.0055f, z + 0.004f},
                    {inner, 0.011f, 0.011f}, 0.002f);
        k.add(shapes::sheet(1, 1,
                            [&](float u, float v) {
                                return Vec3f{x + inner * (u - 0.5f), y0 + (y1 - y0) * v, z - 0.006f};
                            }),
              paper);
    }
    k.piece.mount = Mount::wall;
}

constexpr Entry kWindowCovers[] = {{"venetian_blind", venetian_blind},
                                   {"roller_blind", roller_blind},
                                   {"roman_blind", roman_blind},
                                   {"shutters", shutters},
                                   {"shoji", shoji}};

}  // namespace

std::span<const Entry> window_covers() { return kWindowCovers; }

}  // namespace fastscene::furniture
