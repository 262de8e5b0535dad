// Posters, and letters on walls.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "fastscene/rooms/furniture/lettering.h"
#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/wall/boards.h"
#include "fastscene/rooms/furniture/wall/motifs.h"

namespace fastscene::furniture {
namespace {

// Paper of the A series keeps its shape where only a width is asked for.
Vec3f in_shape(const Kit& k, Vec3f usual, Vec3f wanted) {
    if (k.request.size_m.x > 0 && !(k.request.size_m.y > 0)) wanted.y = usual.y * wanted.x / usual.x;
    return wanted;
}

// What posters are about, as patterns name it.
constexpr std::array<std::pair<std::string_view, Print>, 10> kTopics{{{"films", Print::film_posters},
                                                                      {"travel", Print::travel_posters},
                                                                      {"offers", Print::offers},
                                                                      {"food", Print::food_posters},
                                                                      {"sport", Print::sport_posters},
                                                                      {"concerts", Print::concert_posters},
                                                                      {"charts", Print::charts},
                                                                      {"notices", Print::notices},
                                                                      {"fashion", Print::fashion_posters},
                                                                      {"bakery", Print::bakery_posters}}};

const Print* find_topic(std::string_view pattern) {
    for (const auto& [name, print] : kTopics)
        if (name == pattern) return &print;
    return nullptr;
}

Print topic_of(const Kit& k) {
    const Print* topic = find_topic(k.request.pattern);
    return topic ? *topic : Print::travel_posters;
}

// Any poster on the topic, its middle at x = 0 and its lower edge at y, on the plane z.
void hang_poster(Kit& k, Print topic, Vec2f size, float y, float z) {
    const PrintSheet sheet = print_sheet(k, topic);
    const int cell = k.rng.index(sheet.cells);
    k.add(printed_face(sheet[cell], size), sheet.material, {-0.5f * size.x, y, z});
    k.piece.form = fmt::format("poster {} of {}", cell, static_cast<int>(topic));
}

bool in_capitals(std::string_view text) {
    return !text.empty() && std::none_of(text.begin(), text.end(),
                                         [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; });
}

}  // namespace

bool is_poster_topic(std::string_view name) { return find_topic(name) != nullptr; }

// Printed paper of the A series; in a thin frame, or held by strips above and below.
void build_poster(Kit& k) {
    constexpr Vec3f kUsual{0.594f, 0.841f, 0.02f};  // A1
    const Vec3f s = in_shape(k, kUsual, k.wanted(kUsual));
    const int frame = k.main(k.rng.chance(0.5f) ? k.style.metal : plain("poster strip", {0.03f, 0.03f, 0.03f}, 0.4f)),
              back = color(k, "poster back", {0.6f, 0.6f, 0.58f}, 0.8f);
    const bool framed = k.rng.chance(0.6f);
    const float f = framed ? 0.014f : 0.f, z = 0.008f;
    k.board(back, {0, f, 0.5f * z}, {s.x - 2 * f, s.y - 2 * f, z - 0.0005f}, 0.0005f);
    if (is_motif(k.request.pattern))
        draw_motif(k, k.request.pattern, {0, 0.5f * s.y, z + 0.001f}, s.x - 2 * f, s.y - 2 * f);
    else hang_poster(k, topic_of(k), {s.x - 2 * f, s.y - 2 * f}, f, z);
    if (framed) {
        wall_frame(k, frame, {s.x, s.y, 0}, f, 0.018f);
    } else {
        for (const float y : {0.f, s.y - 0.02f}) k.board(frame, {0, y, 0.007f}, {s.x + 0.01f, 0.02f, 0.014f}, 0.002f);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.62f - 0.5f * s.y;
}

// As stations have them: a large poster in a flat case of aluminium.
void build_billboard(Kit& k) {
    constexpr Vec3f kUsual{1.25f, 1.8f, 0.07f};
    const Vec3f s = in_shape(k, kUsual, k.wanted(kUsual));
    const int frame = k.main(plain("aluminium", {0.5f, 0.5f, 0.51f}, 0.35f));
    constexpr float kFrame = 0.05f;
    k.board(frame, {0, 0, 0.5f * s.z}, {s.x, s.y, s.z}, 0.006f);
    hang_poster(k, topic_of(k), {s.x - 2 * kFrame, s.y - 2 * kFrame}, kFrame, s.z + 0.002f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.75f;
}

// Letters that stand off the wall: the pattern, if it is in capitals.
void build_wall_letters(Kit& k) {
    static constexpr std::array<std::string_view, 3> kUsual{"WELCOME", "OPEN", "HELLO"};
    const std::string_view asked = k.request.pattern,
                           words = in_capitals(asked) ? asked : kUsual[static_cast<std::size_t>(k.rng.index(3))];
    constexpr float kUsualHigh = 0.34f;
    const Vec3f s = k.wanted({letters_width(words, kUsualHigh), 0, 0});
    const float high = kUsualHigh * s.x / letters_width(words, kUsualHigh), stroke = 0.17f * high, deep = 0.03f;
    // They stand out from the wall.
    constexpr float kDarkWall = 0.2f;
    const bool dark = luminance(k.style.wall.color_a) < kDarkWall && luminance(k.style.metal.color_a) < kDarkWall;
    const int face = k.main(dark ? plain("white letters", {0.66f, 0.65f, 0.61f}, 0.4f) : k.style.metal);
    for (const auto& line : letter_strokes(words, high)) {
        const Vec2f aside{-0.5f * s.x, 0.5f * stroke};
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Vec2f a = line[i] + aside, b = line[i + 1] + aside;
            slat(k, face, {a.x, a.y, 0.04f}, {b.x, b.y, 0.04f}, stroke, deep);
        }
        // Round joints, a hair shallower, so that no two faces lie in one plane.
        for (const Vec2f p : line) {
            Mesh joint = shapes::prism(shapes::circle(0.5f * stroke, 14), 0.f, deep - 0.001f, 0.002f);
            shapes::turn(joint, {1, 0, 0}, 90);
            k.add(std::move(joint), face, {p.x + aside.x, p.y + aside.y, 0.04f - 0.5f * deep + 0.0005f});
        }
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 2.3f;
}

}  // namespace fastscene::furniture
