// What lies about in rooms that nobody keeps: left to decay, being renovated, moved into, untidy.
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

// A flat bar from a to b in a plane of constant x: `wide` along x, `thick` across.
void strut(Kit& k, int material, Vec3f a, Vec3f b, float wide, float thick) {
    const Vec3f d = b - a;
    Mesh m = shapes::box({wide, length(d), thick}, 0.003f);
    shapes::turn(m, {1, 0, 0}, std::atan2(d.z, d.y) * 180.f / kPi);
    k.add(std::move(m), material, (a + b) * 0.5f);
}

// Steps in front, a frame to lean on behind, a cap on top; splashed with paint.
void step_ladder(Kit& k) {
    const float high = 1.55f, half = 0.21f, front = 0.42f, back = -0.42f;
    Material wood = *material_named("pine");
    wood.color_a = wood.color_a * 0.85f;
    const bool metal = k.style.name == "modern" || k.style.name == "industrial";
    const int rail = k.main(metal ? plain("aluminium", {0.52f, 0.53f, 0.54f}, 0.35f) : wood),
              cap = k.material(plain("ladder cap", metal ? Vec3f{0.6f, 0.12f, 0.04f} : wood.color_a, 0.5f)),
              cord = k.material(plain("cord", {0.5f, 0.44f, 0.33f}, 0.9f)),
              paint = k.material(plain("dried paint", {0.74f, 0.73f, 0.7f}, 0.6f));
    const auto at = [&](float y, float foot) { return foot * (1.f - y / (high + 0.12f)); };
    for (const float sx : {-1.f, 1.f}) {
        strut(k, rail, {sx * (half + 0.04f), 0.003f, front}, {sx * half, high, at(high, front)}, 0.026f, 0.062f);
        strut(k, rail, {sx * (half - 0.02f), 0.003f, back}, {sx * (half - 0.04f), high - 0.03f, at(high, back)}, 0.024f,
              0.042f);
        k.rod(cord, {sx * (half + 0.01f), 0.62f, at(0.62f, front)}, {sx * (half - 0.03f), 0.62f, at(0.62f, back)},
              0.004f, -1, 6);
    }
    for (int i = 1; i <= 5; ++i) {
        const float y = 0.27f * static_cast<float>(i);
        k.board(rail, {0, y, at(y, front) - 0.005f}, {2 * half + 0.05f, 0.022f, 0.1f}, 0.003f);
        if (k.dice.chance(0.7f))
            k.add(
                shapes::ball({k.dice.uniform(-0.13f, 0.13f), y + 0.022f, at(y, front) + k.dice.uniform(-0.02f, 0.02f)},
                             {0.03f, 0.0025f, 0.02f}, 12),
                paint);
    }
    for (const float y : {0.4f, 1.05f})
        k.rod(rail, {-half + 0.02f, y, at(y, back)}, {half - 0.02f, y, at(y, back)}, 0.012f, -1, 10);
    k.board(cap, {0, high - 0.02f, 0.0f}, {2 * half + 0.06f, 0.035f, 0.17f}, 0.006f);
    k.top(high + 0.015f, 0, 0, 0.14f, 0.06f);
}

// A tin with its rim and its handle; open ones show what is left in them, with a run down the side.
void paint_tin(Kit& k, Vec3f at, float r, float h, Vec3f color, bool open, int tin) {
    const int paint = k.material(plain("wet paint", color, 0.15f)),
              label = k.material(plain("tin label", lerp(color, {0.7f, 0.69f, 0.66f}, 0.45f), 0.5f));
    const std::array<Vec2f, 8> wall{
        Vec2f{r - 0.006f, 0},    {r, 0.006f},    {r, 0.16f * h},           {r - 0.001f, 0.17f * h},
        {r - 0.001f, 0.86f * h}, {r, 0.87f * h}, {r + 0.004f, h - 0.006f}, {r + 0.002f, h}};
    if (open) k.add(shapes::vessel(wall, 0.003f, 32), tin, at);
    else k.add(shapes::lathe(wall, 32), tin, at);
    const std::array<Vec2f, 2> band{Vec2f{r + 0.0012f, 0.2f * h}, {r + 0.0012f, 0.82f * h}};
    k.add(shapes::lathe(band, 32), label, at);
    if (open) {
        k.add(shapes::prism(shapes::circle(r - 0.005f, 32), 0.8f * h, 0.81f * h, 0.001f), paint, at);
        const float a = k.dice.uniform(0.f, kTau);
        for (int i = 0; i < 3; ++i) {
            const float b = a + 0.28f * static_cast<float>(i - 1), far = h * k.dice.uniform(0.25f, 0.6f);
            k.rod(paint, at + Vec3f{(r + 0.003f) * std::cos(b), h - 0.004f, (r + 0.003f) * std::sin(b)},
                  at + Vec3f{(r + 0.003f) * std::cos(b), h - far, (r + 0.003f) * std::sin(b)}, 0.006f, 0.009f, 8);
        }
    } else {
        k.add(shapes::prism(shapes::circle(r - 0.008f, 32), h - 0.004f, h + 0.002f, 0.001f), tin, at);
    }
    // The handle has fallen to one side.
    std::vector<Vec3f> wire;
    const float turn = k.dice.uniform(0.f, kTau);
    for (int i = 0; i <= 14; ++i) {
        const float b = kPi * static_cast<float>(i) / 14.f, out = (r + 0.012f) * std::sin(b);
        const Vec3f p{(r + 0.006f) * std::cos(b), 0.78f * h - 0.35f * h * std::sin(b),
                      0.35f * out + (r + 0.004f) * std::sin(b)};
        wire.push_back(
            at + Vec3f{p.x * std::cos(turn) + p.z * std::sin(turn), p.y, p.z * std::cos(turn) - p.x * std::sin(turn)});
    }
    k.add(shapes::tube(wire, 0.0022f, 6), tin);
}

// Three tins, a brush laid across the open one, a tray with its roller.
void paint_buckets(Kit& k) {
    const int tin = k.main(steel()), plastic = k.material(plain("paint tray", {0.05f, 0.05f, 0.055f}, 0.45f)),
              wood = k.material(*material_named("birch")),
              bristle = k.material(plain("bristles", {0.24f, 0.16f, 0.08f}, 0.9f)), metal = k.material(steel());
    const Vec3f color = k.request.color                ? *k.request.color
                        : k.request.color_name.empty() ? lerp(k.accent(), {0.72f, 0.7f, 0.66f}, 0.25f)
                                                       : color_named(k.request.color_name).value_or(k.accent());
    paint_tin(k, {-0.17f, 0, 0.02f}, 0.095f, 0.2f, color, true, tin);
    paint_tin(k, {0.06f, 0, -0.12f}, 0.095f, 0.2f, {0.74f, 0.73f, 0.7f}, false, tin);
    paint_tin(k, {-0.05f, 0, 0.2f}, 0.06f, 0.12f, lerp(k.accent(), color, 0.3f), false, tin);
    // The brush.
    k.board(wood, {-0.11f, 0.203f, 0.02f}, {0.13f, 0.012f, 0.024f}, 0.005f);
    k.board(metal, {-0.2f, 0.202f, 0.02f}, {0.05f, 0.015f, 0.05f}, 0.002f);
    k.board(bristle, {-0.25f, 0.203f, 0.02f}, {0.055f, 0.012f, 0.048f}, 0.003f);
    // The tray slopes down to its well.
    const int wet = k.material(plain("paint in the tray", color, 0.15f)),
              nap = k.material(plain("roller", lerp(color, {0.7f, 0.68f, 0.64f}, 0.2f), 0.95f));
    k.board(plastic, {0.27f, 0, 0.12f}, {0.25f, 0.012f, 0.34f}, 0.004f);
    for (const float sx : {-1.f, 1.f})
        k.board(plastic, {0.27f + sx * 0.12f, 0.01f, 0.12f}, {0.012f, 0.05f, 0.34f}, 0.003f);
    for (const float sz : {-1.f, 1.f})
        k.board(plastic, {0.27f, 0.01f, 0.12f + sz * 0.164f}, {0.25f, 0.05f, 0.012f}, 0.003f);
    k.board(wet, {0.27f, 0.011f, 0.19f}, {0.226f, 0.012f, 0.16f}, 0.001f);
    k.rod(nap, {0.18f, 0.048f, 0.04f}, {0.36f, 0.048f, 0.04f}, 0.032f, -1, 20);
    const std::array<Vec3f, 5> arm{Vec3f{0.36f, 0.048f, 0.04f},
                                   {0.385f, 0.055f, 0.04f},
                                   {0.385f, 0.075f, -0.02f},
                                   {0.3f, 0.1f, -0.06f},
                                   {0.27f, 0.115f, -0.12f}};
    k.add(shapes::tube(arm, 0.004f, 8), metal);
    k.rod(plastic, {0.27f, 0.115f, -0.1f}, {0.255f, 0.15f, -0.24f}, 0.013f, 0.015f, 12);
}

// A sheet over the floor, with folds and splashes; of plastic it is thin and lets light through.
void drop_cloth(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 0.012f, 1.4f});
    const bool film = k.request.material == "plastic" || k.request.material == "lacquer";
    Material cloth = plain(film ? "plastic sheet" : "canvas sheet",
                           film ? Vec3f{0.7f, 0.72f, 0.73f} : Vec3f{0.6f, 0.56f, 0.47f}, film ? 0.25f : 0.95f);
    if (film) cloth.specular = 0.06f;
    else cloth.pattern = Pattern::fabric, cloth.scale_m = 0.002f;
    if (const auto color = k.request.color ? k.request.color : color_named(k.request.color_name);
        color && (k.request.color || !k.request.color_name.empty()))
        cloth = tinted(cloth, *color);
    const int sheet = k.piece.main_material = k.material(cloth);
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(
              56, 44, 0.001f,
              [=](float u, float v) {
                  const float x = (u - 0.5f) * s.x, z = (0.5f - v) * s.z;
                  const float edge = std::min(std::min(u, 1.f - u), std::min(v, 1.f - v));
                  const float fold = std::pow(1.f - std::fabs(shapes::wobble({x * 2.3f, 1.f, z * 2.3f}, seed)), 5.f);
                  const float ragged = 0.04f * shapes::wobble({x * 1.7f, 4.f, z * 1.7f}, seed + 1);
                  return Vec3f{x * (1.f - 0.03f * edge) + ragged * (edge < 0.2f ? 1.f : 0.4f), 0.0015f + 0.0065f * fold,
                               z + 0.8f * ragged};
              }),
          sheet);
    for (int i = 0; i < (film ? 3 : 9); ++i) {
        const int splash = k.material(plain("paint splash", i % 3 == 0 ? k.accent() : Vec3f{0.74f, 0.73f, 0.7f}, 0.4f));
        const float r = k.dice.uniform(0.012f, 0.045f);
        k.add(shapes::ball({k.dice.uniform(-0.4f, 0.4f) * s.x, 0.0045f, k.dice.uniform(-0.4f, 0.4f) * s.z},
                           {r, 0.004f, r * k.dice.uniform(0.6f, 1.f)}, 14),
              splash);
    }
}

// One garment dropped on the floor: a low mound with deep folds, wider than high.
void garment(Kit& k, Vec3f at, float rx, float rz, float high, Vec3f color, float turn) {
    Material m = tinted(k.style.fabric, color);
    m.name = "garment";
    m.pattern = k.dice.chance(0.3f) ? Pattern::knit : Pattern::fabric;
    if (m.pattern == Pattern::knit) m.scale_m = 0.008f, m.color_b = color * 0.7f;
    if (k.dice.chance(0.25f))
        m.pattern = Pattern::stripes, m.scale_m = 0.02f, m.color_b = lerp(color, {0.75f, 0.73f, 0.68f}, 0.8f);
    const std::uint32_t seed = k.seed();
    const float c = std::cos(turn), s = std::sin(turn);
    Mesh mound = shapes::slab(52, 22, 0.003f, [=](float u, float v) {
        const float a = kTau * u,
                    reach = 1.f + 0.28f * shapes::wobble({1.3f * std::cos(a), 2.f, 1.3f * std::sin(a)}, seed);
        const float r = 1.f - 0.985f * v, x = rx * reach * r * std::cos(a), z = -rz * reach * r * std::sin(a),
                    body = std::pow(std::max(0.f, 1.f - (1.f - v) * (1.f - v)), 0.7f);
        const float ridge = std::pow(1.f - std::fabs(shapes::wobble({x * 7.f, 3.f, z * 7.f}, seed + 1)), 2.f),
                    fine = shapes::wobble({x * 17.f, 6.f, z * 17.f}, seed + 2);
        const float y = high * body * (0.42f + 0.5f * ridge + 0.14f * fine) + 0.004f;
        return Vec3f{c * x + s * z, std::max(0.004f, y), c * z - s * x};
    });
    k.add(std::move(mound), k.material(m), at);
}

void clothes_heap(Kit& k) {
    k.piece.main_material = 0;
    const std::array<Vec3f, 5> usual{Vec3f{0.06f, 0.09f, 0.19f},
                                     {0.5f, 0.48f, 0.44f},
                                     {0.05f, 0.05f, 0.055f},
                                     {0.3f, 0.05f, 0.05f},
                                     {0.24f, 0.25f, 0.27f}};  // denim, white, black, red, gray
    const auto color = [&] {
        return k.dice.chance(0.35f) ? k.accent() : usual[static_cast<std::size_t>(k.dice.index(5))];
    };
    const Vec3f first = k.request.color                ? *k.request.color
                        : k.request.color_name.empty() ? color()
                                                       : color_named(k.request.color_name).value_or(color());
    garment(k, {0, 0, 0}, 0.3f, 0.2f, 0.12f, first, k.dice.uniform(0.f, kTau));
    garment(k, {0.12f, 0.025f, 0.09f}, 0.19f, 0.14f, 0.1f, color(), k.dice.uniform(0.f, kTau));
    garment(k, {-0.3f, 0, 0.16f}, 0.2f, 0.11f, 0.06f, color(), k.dice.uniform(0.f, kTau));
    if (k.dice.chance(0.7f)) garment(k, {0.1f, 0, -0.28f}, 0.13f, 0.08f, 0.05f, color(), k.dice.uniform(0.f, kTau));
    for (Mesh& m : k.piece.meshes)
        for (Vec3f& p : m.positions) p.y = std::max(p.y, 0.f);
}

// Sheets that slid apart, some balled up.
void paper_litter(Kit& k) {
    const bool old = k.style.name == "rustic" || k.style.name == "classic";
    const int paper = k.main(plain("paper", old ? Vec3f{0.58f, 0.5f, 0.36f} : Vec3f{0.72f, 0.71f, 0.67f}, 0.95f)),
              ink = k.material(plain("ink", {0.12f, 0.12f, 0.13f}, 0.95f));
    const int sheets = 9 + k.dice.index(4);
    for (int i = 0; i < sheets; ++i) {
        const float turn = k.dice.uniform(0.f, 360.f), curl = k.dice.chance(0.4f) ? k.dice.uniform(0.008f, 0.03f) : 0.f,
                    far = std::sqrt(k.dice.uniform()) * 0.62f, a = k.dice.uniform(0.f, kTau);
        const float level = 0.001f + 0.0009f * static_cast<float>(i);
        Mesh m = shapes::slab(8, 8, 0.0004f, [=](float u, float v) {
            return Vec3f{(u - 0.5f) * 0.21f, curl * std::pow(std::max(0.f, u + v - 0.8f), 2.f), (0.5f - v) * 0.297f};
        });
        shapes::turn(m, {0, 1, 0}, turn);
        const Vec3f at{far * std::cos(a), level, 0.8f * far * std::sin(a)};
        k.add(std::move(m), paper, at);
        // Lines of writing on those that lie flat.
        for (int line = 0; curl == 0.f && line < 7; ++line) {
            Mesh words = shapes::box({0.15f - 0.05f * k.dice.uniform(), 0.0003f, 0.005f}, 0.0001f);
            shapes::move(words, {0, 0.0006f, -0.1f + 0.03f * static_cast<float>(line)});
            shapes::turn(words, {0, 1, 0}, turn);
            k.add(std::move(words), ink, at);
        }
    }
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t seed = k.seed();
        const float r = k.dice.uniform(0.028f, 0.042f);
        Mesh ball = shapes::ball({}, {r, r, r}, 20);
        for (Vec3f& p : ball.positions) p = p * (1.f + 0.16f * shapes::wobble(p * (3.2f / r), seed));
        shapes::smooth_normals(ball);
        const float a = k.dice.uniform(0.f, kTau), far = k.dice.uniform(0.25f, 0.65f);
        k.add(std::move(ball), paper, {far * std::cos(a), 0.9f * r, 0.8f * far * std::sin(a)});
    }
}

// Cardboard, taped; the one in front is still open.
void moving_boxes(Kit& k) {
    Material card = plain("cardboard", {0.37f, 0.24f, 0.125f}, 0.9f);
    const int board = k.main(card), tape = k.material(plain("packing tape", {0.5f, 0.38f, 0.22f}, 0.35f)),
              inside = k.material(plain("inside of a box", {0.2f, 0.125f, 0.065f}, 0.95f)),
              mark = k.material(plain("marker", {0.04f, 0.04f, 0.045f}, 0.8f));
    const auto closed = [&](Vec3f at, Vec3f size) {
        k.board(board, at, size, 0.006f);
        k.board(tape, at + Vec3f{0, size.y - 0.001f, 0}, {0.055f, 0.0018f, size.z - 0.004f}, 0.0004f);
        k.board(tape, at + Vec3f{0, 0.62f * size.y, 0.5f * size.z}, {0.055f, 0.38f * size.y, 0.0018f}, 0.0004f);
        for (int i = 0; i < 2; ++i)
            k.board(mark, at + Vec3f{-0.12f, 0.25f * size.y + 0.035f * static_cast<float>(i), 0.5f * size.z},
                    {0.11f - 0.03f * static_cast<float>(i), 0.012f, 0.0016f}, 0.0004f);
    };
    closed({-0.24f, 0, -0.08f}, {0.46f, 0.36f, 0.36f});
    closed({-0.2f, 0.36f, -0.09f}, {0.38f, 0.29f, 0.32f});
    // The open one: four walls, a dark inside, four flaps.
    const Vec3f s{0.4f, 0.3f, 0.34f}, at{0.25f, 0, 0.02f};
    for (const float sx : {-1.f, 1.f})
        k.board(board, at + Vec3f{sx * (0.5f * s.x - 0.004f), 0, 0}, {0.008f, s.y, s.z}, 0.002f);
    for (const float sz : {-1.f, 1.f})
        k.board(board, at + Vec3f{0, 0, sz * (0.5f * s.z - 0.004f)}, {s.x, s.y, 0.008f}, 0.002f);
    k.board(inside, at, {s.x - 0.012f, 0.2f * s.y, s.z - 0.012f}, 0.002f);
    for (const float sz : {-1.f, 1.f})
        strut(k, board, at + Vec3f{0, s.y - 0.002f, sz * 0.5f * s.z},
              at + Vec3f{0, s.y + 0.03f, sz * (0.5f * s.z + 0.13f)}, s.x - 0.01f, 0.005f);
    for (const float sx : {-1.f, 1.f}) {
        Mesh flap = shapes::box({0.005f, 0.14f, s.z - 0.01f}, 0.001f);
        shapes::turn(flap, {0, 0, 1}, -sx * 62.f);
        k.add(std::move(flap), board, at + Vec3f{sx * (0.5f * s.x + 0.06f), s.y + 0.03f, 0});
    }
    // Rolls and books look out.
    k.rod(k.material(plain("rolled paper", {0.66f, 0.62f, 0.54f}, 0.9f)), at + Vec3f{0.08f, 0.07f, 0.05f},
          at + Vec3f{0.13f, 0.5f, 0.0f}, 0.028f, -1, 16);
    for (int i = 0; i < 3; ++i)
        k.board(k.material(plain("book cover", k.accent(), 0.6f)),
                at + Vec3f{-0.12f + 0.05f * static_cast<float>(i), 0.07f, -0.03f},
                {0.035f, 0.2f + 0.03f * static_cast<float>(i), 0.17f}, 0.003f);
    k.top(0.65f, -0.2f, -0.09f, 0.15f, 0.12f);
}

// Two boxes one on the other, the lid of the upper one ajar, a slice left over, a can beside them.
void pizza_boxes(Kit& k) {
    const int card = k.main(plain("pizza box", {0.6f, 0.52f, 0.4f}, 0.85f)),
              red = k.material(plain("print", {0.45f, 0.04f, 0.03f}, 0.7f)),
              crust = k.material(plain("crust", {0.5f, 0.27f, 0.09f}, 0.8f)),
              cheese = k.material(plain("cheese", {0.66f, 0.4f, 0.08f}, 0.4f)),
              can = k.material(plain("soda can", {0.5f, 0.03f, 0.03f}, 0.25f)), lid = k.material(steel());
    const float w = 0.33f, h = 0.04f;
    k.board(card, {0, 0, 0}, {w, h, w}, 0.003f);
    const auto rim = [&](Vec3f at, Vec3f size) { k.board(card, at + Vec3f{0.015f, h, 0.012f}, size, 0.001f); };
    rim({0, 0, 0}, {w, 0.004f, w});
    for (const float s : {-1.f, 1.f}) {
        rim({s * (0.5f * w - 0.002f), 0.003f, 0}, {0.004f, h - 0.003f, w});
        rim({0, 0.003f, s * (0.5f * w - 0.002f)}, {w, h - 0.003f, 0.004f});
    }
    // A slice with its crust at the back.
    const std::array<Vec2f, 3> slice{Vec2f{-0.06f, -0.07f}, {0.06f, -0.07f}, {0.f, 0.1f}};
    k.add(shapes::prism(slice, h + 0.005f, h + 0.016f, 0.003f), cheese, {0.03f, 0, 0.02f});
    k.rod(crust, {-0.035f, h + 0.016f, -0.052f}, {0.095f, h + 0.016f, -0.052f}, 0.012f, -1, 10);
    for (int i = 0; i < 3; ++i)
        k.add(shapes::prism(shapes::circle(0.013f, 16), h + 0.015f, h + 0.019f, 0.001f), red,
              {0.03f + 0.028f * static_cast<float>(i - 1), 0, 0.0f + 0.03f * static_cast<float>(i % 2)});
    // The lid stands up at the back.
    const Vec3f hinge{0.015f, 2 * h, 0.012f - 0.5f * w};
    strut(k, card, hinge, hinge + Vec3f{0, 0.26f, -0.19f}, w, 0.004f);
    strut(k, red, hinge + Vec3f{0, 0.09f, -0.06f} + Vec3f{0, 0.0015f, 0.0022f},
          hinge + Vec3f{0, 0.17f, -0.12f} + Vec3f{0, 0.0015f, 0.0022f}, 0.2f, 0.001f);
    const std::array<Vec2f, 6> body{Vec2f{0.024f, 0}, {0.033f, 0.006f}, {0.033f, 0.1f},
                                    {0.028f, 0.112f}, {0.026f, 0.114f}, {0.0f, 0.112f}};
    k.add(shapes::lathe(body, 28), can, {0.24f, 0, 0.1f});
    k.add(shapes::prism(shapes::circle(0.025f, 24), 0.112f, 0.1135f, 0.0005f), lid, {0.24f, 0, 0.1f});
}

// Plaster and brick that came down, on its own dust.
void rubble(Kit& k) {
    const int plaster = k.main(plain("plaster rubble", {0.5f, 0.47f, 0.42f}, 0.95f)),
              brick = k.material(plain("brick rubble", {0.33f, 0.13f, 0.08f}, 0.95f)),
              dust = k.material(plain("plaster dust", {0.46f, 0.43f, 0.385f}, 1.f));
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(
              48, 14, 0.002f,
              [=](float u, float v) {
                  const float a = kTau * u,
                              r = 0.5f * (1.f - 0.985f * v) *
                                  (1.f + 0.25f * shapes::wobble({1.5f * std::cos(a), 1.f, 1.5f * std::sin(a)}, seed));
                  const float x = r * std::cos(a), z = -0.75f * r * std::sin(a);
                  return Vec3f{
                      x,
                      std::max(0.002f, 0.05f * (v * (2.f - v)) *
                                               (0.8f + 0.6f * shapes::wobble({9.f * x, 2.f, 9.f * z}, seed + 1)) +
                                           0.002f),
                      z};
              }),
          dust);
    const int chunks = 16 + k.dice.index(6);
    for (int i = 0; i < chunks; ++i) {
        const bool red = k.dice.chance(0.35f);
        const float size = k.dice.uniform(0.035f, 0.1f), far = std::sqrt(k.dice.uniform()) * 0.42f,
                    a = k.dice.uniform(0.f, kTau);
        Mesh m = shapes::box(red ? Vec3f{size, 0.5f * size, 0.6f * size}
                                 : Vec3f{size * k.dice.uniform(0.8f, 1.6f), size * k.dice.uniform(0.25f, 0.5f), size},
                             0.12f * size);
        const std::uint32_t chip = k.seed();
        for (Vec3f& p : m.positions) p = p * (1.f + 0.22f * shapes::wobble(p * (2.f / size), chip));
        shapes::turn(m, {1, 0, 0}, k.dice.uniform(-25, 25));
        shapes::turn(m, {0, 1, 0}, k.dice.uniform(0.f, 360.f));
        const shapes::Box box = shapes::bounds(m);
        const float bed = 0.045f * std::max(0.f, 1.f - far / 0.5f);
        k.add(std::move(m), red ? brick : plaster,
              {far * std::cos(a), std::max(0.f, bed) - box.low.y - 0.006f * bed, 0.75f * far * std::sin(a)});
    }
}

constexpr Entry kUpheaval[] = {{"step_ladder", step_ladder},   {"paint_buckets", paint_buckets},
                               {"drop_cloth", drop_cloth},     {"clothes_heap", clothes_heap},
                               {"paper_litter", paper_litter}, {"moving_boxes", moving_boxes},
                               {"pizza_boxes", pizza_boxes},   {"rubble", rubble}};

}  // namespace

std::span<const Entry> upheaval() { return kUpheaval; }

}  // namespace fastscene::furniture
