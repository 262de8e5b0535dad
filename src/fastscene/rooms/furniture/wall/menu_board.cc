// Boards that are read: menus of cafés and snack bars, the chart of a doctor.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "fastscene/rooms/furniture/lettering.h"
#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {
namespace {

// Letters in chalk on the plane of the pen, from (x, y).
void write(Chalk& pen, std::string_view text, float x, float y, float height) {
    for (Stroke stroke : letter_strokes(text, height)) {
        for (Vec2f& p : stroke) p = p + Vec2f{x, y};
        pen.line(stroke);
    }
}

struct Line {
    std::string_view dish, price;
};

constexpr std::array<Line, 6> kCoffee{{{"ESPRESSO", "2.20"},
                                       {"MACCHIATO", "2.60"},
                                       {"CAPPUCCINO", "3.40"},
                                       {"FLAT WHITE", "3.80"},
                                       {"LATTE", "3.90"},
                                       {"MOCHA", "4.20"}}};
constexpr std::array<Line, 6> kMore{{{"TEA", "2.80"},
                                     {"COCOA", "3.60"},
                                     {"JUICE", "3.50"},
                                     {"CROISSANT", "2.40"},
                                     {"MUFFIN", "2.90"},
                                     {"CAKE", "4.20"}}};

// A cup with a saucer and steam, its middle at o.
void draw_cup(Chalk& pen, Vec2f o, float u) {
    pen.line(bow(o + Vec2f{0, 0.06f * u}, {0.075f * u, 0.08f * u}, 180, 360));
    pen.line({o + Vec2f{-0.075f, 0.06f} * u, o + Vec2f{0.075f, 0.06f} * u});
    pen.line(bow(o + Vec2f{0.085f, 0.035f} * u, {0.028f * u, 0.024f * u}, -80, 80));
    pen.line({o + Vec2f{-0.12f, -0.03f} * u, o + Vec2f{0.12f, -0.03f} * u});
    for (const float x : {-0.035f, 0.f, 0.035f}) {
        const Stroke steam{o + Vec2f{x, 0.09f} * u, o + Vec2f{x + 0.016f, 0.12f} * u, o + Vec2f{x - 0.006f, 0.15f} * u,
                           o + Vec2f{x + 0.012f, 0.18f} * u};
        pen.line(shapes::curve(steam, 3));
    }
}

}  // namespace

// Slate in a frame of wood: a heading, a cup, two columns with prices.
void build_menu_board(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.95f, 0.05f});
    Material slate = plain("slate board", {0.032f, 0.032f, 0.033f}, 0.85f);
    slate.pattern = Pattern::plaster;
    slate.scale_m = 0.5f;
    slate.color_b = slate.color_c = slate.color_a * 1.7f + Vec3f{0.01f, 0.01f, 0.01f};
    const int board = k.main(slate), wood = k.material(k.style.wood),
              white = color(k, "chalk", {0.66f, 0.65f, 0.6f}, 0.95f),
              warm = color(k, "chalk", {0.6f, 0.42f, 0.16f}, 0.95f);
    k.board(board, {0, 0.01f, 0.008f}, {s.x - 0.02f, s.y - 0.02f, 0.012f}, 0.001f);
    wall_frame(k, wood, s, 0.045f, 0.026f);
    const float z = 0.0148f, w = 0.5f * s.x, h = s.y, high = std::min(0.105f * h, 0.13f * w);
    {
        Chalk pen(k, warm, z, 0.1f * high);
        const float title = letters_width("COFFEE + CAKE", high);
        write(pen, "COFFEE + CAKE", -0.5f * title, 0.8f * h, high);
        for (const float side : {-1.f, 1.f})
            pen.line(
                {{side * 0.86f * w, 0.8f * h + 0.5f * high}, {side * (0.5f * title + 0.04f), 0.8f * h + 0.5f * high}});
        draw_cup(pen, {0, 0.1f * h}, std::min(h, 1.2f * w));
    }
    {
        Chalk pen(k, white, z, 0.011f * h);
        const float row = 0.105f * h, letter = std::min(0.055f * h, 0.075f * w);
        for (const auto& [lines, x0, x1] : {std::tuple{kCoffee, -0.88f * w, -0.08f * w}, {kMore, 0.08f * w, 0.88f * w}})
            for (std::size_t i = 0; i < lines.size(); ++i) {
                // the cup takes the middle of the two lowest rows
                const float y = 0.68f * h - row * static_cast<float>(i), cut = i > 3 ? 0.1f * w : 0.f,
                            left = x0 > 0 ? x0 + cut : x0, right = x0 > 0 ? x1 : x1 - cut;
                write(pen, lines[i].dish, left, y, letter);
                write(pen, lines[i].price, right - letters_width(lines[i].price, letter), y, letter);
                const float from = left + letters_width(lines[i].dish, letter) + 0.05f * w,
                            to = right - letters_width(lines[i].price, letter) - 0.04f * w;
                for (float x = from; x < to; x += 0.035f * w) pen.fill({x, y}, {x + 0.008f * w, y + 0.008f * w});
            }
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.35f;
}

// Printed panels side by side under a strip of light, of burgers, chips and drinks.
void build_snack_menu(Kit& k) {
    const Vec3f s = k.wanted({3.0f, 0.7f, 0.09f});
    const int frame = k.main(plain("menu frame", {0.03f, 0.03f, 0.032f}, 0.4f)),
              light = k.material(glow("menu light", {6, 5.6f, 5}));
    k.board(frame, {0, 0, 0.03f}, {s.x, s.y, 0.06f}, 0.006f);
    k.board(frame, {0, s.y - 0.02f, 0.06f}, {s.x, 0.04f, 0.12f}, 0.004f);
    k.board(light, {0, s.y - 0.028f, 0.1f}, {s.x - 0.1f, 0.01f, 0.03f}, 0.002f);
    static constexpr std::array<Vec3f, 4> kGrounds{
        Vec3f{0.4f, 0.06f, 0.03f}, {0.6f, 0.4f, 0.1f}, {0.035f, 0.035f, 0.037f}, {0.5f, 0.14f, 0.04f}};
    static constexpr std::array<std::string_view, 4> kWords{"BURGERS", "CHIPS", "MENU", "DRINKS"};
    const int bun = color(k, "bun", {0.5f, 0.27f, 0.09f}, 0.6f), meat = color(k, "patty", {0.1f, 0.045f, 0.025f}, 0.7f),
              salad = color(k, "salad", {0.18f, 0.32f, 0.05f}, 0.6f),
              cheese = color(k, "cheese", {0.62f, 0.38f, 0.05f}, 0.5f),
              red = color(k, "carton", {0.42f, 0.04f, 0.03f}, 0.5f),
              white = color(k, "cup", {0.7f, 0.69f, 0.66f}, 0.5f),
              cream = color(k, "letters", {0.7f, 0.66f, 0.55f}, 0.6f);
    const int panels = std::max(2, static_cast<int>(s.x / 0.75f));
    const float w = (s.x - 0.04f) / static_cast<float>(panels);
    for (int i = 0; i < panels; ++i) {
        const float x0 = -0.5f * s.x + 0.02f + w * static_cast<float>(i), z = 0.0615f;
        const Vec3f ground = kGrounds[static_cast<std::size_t>(i) % 4];
        const int panel = color(k, "panel", ground, 0.4f);
        k.board(panel, {x0 + 0.5f * w, 0.02f, 0.06f}, {w - 0.015f, s.y - 0.07f, 0.004f}, 0.001f);
        const Vec2f o{x0 + 0.32f * w, 0.2f * s.y};
        const float u = std::min(0.3f * s.y, 0.26f * w);
        const auto disc = [&](int material, Vec2f at, Vec2f radii, float up) {
            k.add(shapes::ball({at.x, at.y, z + up}, {radii.x, radii.y, 0.006f}, 14), material);
        };
        const auto bar = [&](int material, Vec2f low, Vec2f high) {
            block(k, material, {0.5f * (low.x + high.x), low.y, z + 0.003f}, {high.x - low.x, high.y - low.y, 0.008f});
        };
        switch (i % 4) {
            case 0:
            case 2:  // a burger
                bar(bun, o + Vec2f{-u, 0}, o + Vec2f{u, 0.3f * u});
                bar(meat, o + Vec2f{-1.05f * u, 0.3f * u}, o + Vec2f{1.05f * u, 0.55f * u});
                bar(cheese, o + Vec2f{-1.1f * u, 0.55f * u}, o + Vec2f{1.1f * u, 0.65f * u});
                bar(salad, o + Vec2f{-1.15f * u, 0.65f * u}, o + Vec2f{1.15f * u, 0.8f * u});
                disc(bun, o + Vec2f{0, 0.8f * u}, {u, 0.75f * u}, 0);
                break;
            case 1:  // chips
                for (int c = -3; c <= 3; ++c)
                    bar(cheese, o + Vec2f{0.2f * u * static_cast<float>(c) - 0.08f * u, 0.5f * u},
                        o + Vec2f{0.2f * u * static_cast<float>(c) + 0.08f * u,
                                  (1.6f - 0.2f * static_cast<float>(c * c % 3)) * u});
                bar(white, o + Vec2f{-0.8f * u, 0}, o + Vec2f{0.8f * u, 0.95f * u});
                break;
            default:  // a cup with a straw
                bar(white, o + Vec2f{-0.5f * u, 0}, o + Vec2f{0.5f * u, 1.4f * u});
                bar(red, o + Vec2f{-0.52f * u, 0.4f * u}, o + Vec2f{0.52f * u, 0.9f * u});
                bar(white, o + Vec2f{-0.6f * u, 1.4f * u}, o + Vec2f{0.6f * u, 1.55f * u});
                bar(red, o + Vec2f{0.1f * u, 1.55f * u}, o + Vec2f{0.18f * u, 2.2f * u});
                break;
        }
        Chalk pen(k, cream, z + 0.003f, 0.011f);
        const float head = std::min(0.11f * s.y, 0.1f * w);
        write(pen, kWords[static_cast<std::size_t>(i) % 4], x0 + 0.08f * w, 0.74f * s.y, head);
        for (int row = 0; row < 4; ++row) {
            const float y = (0.58f - 0.13f * static_cast<float>(row)) * s.y;
            pen.fill({x0 + 0.66f * w, y}, {x0 + 0.8f * w, y + 0.03f * s.y});
            write(pen, kCoffee[static_cast<std::size_t>(row + i) % 6].price, x0 + 0.83f * w, y, 0.042f * s.y);
        }
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 2.15f;
}

// Rows of letters, each smaller than the one above.
void build_eye_chart(Kit& k) {
    const Vec3f s = k.wanted({0.5f, 0.75f, 0.02f});
    const int paper = k.main(plain("chart", {0.74f, 0.74f, 0.72f}, 0.6f)),
              frame = color(k, "frame", {0.05f, 0.05f, 0.05f}, 0.4f),
              ink = color(k, "ink", {0.02f, 0.02f, 0.02f}, 0.6f), red = color(k, "line", {0.4f, 0.04f, 0.04f}, 0.6f);
    k.board(frame, {0, 0, 0.006f}, {s.x, s.y, 0.012f}, 0.002f);
    k.board(paper, {0, 0.012f, 0.013f}, {s.x - 0.024f, s.y - 0.024f, 0.004f}, 0.001f);
    static constexpr std::array<std::string_view, 7> kRows{"E",         "F P",         "T O Z",        "L P E D",
                                                           "P E C F D", "E D F C Z P", "F E L O P Z D"};
    float y = 0.93f * s.y, high = 0.19f * s.y;
    for (const std::string_view row : kRows) {
        y -= high;
        Chalk pen(k, ink, 0.0156f, 0.2f * high);
        write(pen, row, -0.5f * letters_width(row, high), y, high);
        y -= std::max(0.25f * high, 0.02f * s.y);
        high *= 0.68f;
    }
    block(k, red, {0, 0.27f * s.y, 0.0155f}, {0.7f * s.x, 0.006f, 0.002f});
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.25f;
}

}  // namespace fastscene::furniture
