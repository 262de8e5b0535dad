// Of stations and airports: boards, signs, gates, desks, and a train at its platform.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/print_designs.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {
namespace {

// Words as one sees them from afar: blocks of the height of letters, from x0 until about x1.
void lettering(Kit& k, int ink, float x0, float x1, float y, float z, float height, int words) {
    float x = x0;
    for (int w = 0; w < words && x < x1; ++w) {
        const int letters = 3 + k.rng.index(5);
        for (int i = 0; i < letters && x + 0.5f * height < x1; ++i) {
            const float wide = height * k.rng.uniform(0.42f, 0.66f);
            block(k, ink, {x + 0.5f * wide, y, z}, {wide, height, 0.004f});
            x += wide + 0.16f * height;
        }
        x += 0.55f * height;
    }
}

// A filled arrow in the plane of a sign, pointing to `side`.
void arrow(Kit& k, int ink, Vec3f at, float size, float side) {
    block(k, ink, at + Vec3f{-side * 0.12f * size, -0.07f * size, 0}, {0.6f * size, 0.14f * size, 0.004f});
    for (const float up : {-1.f, 1.f})
        strut(k, ink, at + Vec3f{side * 0.42f * size, 0, 0}, at + Vec3f{side * 0.1f * size, up * 0.32f * size, 0},
              0.004f, 0.14f * size);
}

// The picture of a board of this size: a heading, and rows of what leaves next.
ImageColor departures(Random& rng, Vec2f size, bool trains) {
    static constexpr std::array<const char*, 16> kTowns{"LISBON", "OSLO",   "VIENNA", "MADRID", "ROME",   "DUBLIN",
                                                        "ATHENS", "ZURICH", "PRAGUE", "PARIS",  "BERLIN", "LONDON",
                                                        "TURIN",  "MILAN",  "LYON",   "BASEL"};
    static constexpr std::array<std::string_view, 4> kCarriers{"NA", "TP", "OS", "LX"},
        kTrains{"IC", "EC", "RE", "ICE"};
    constexpr Vec3f kAmber{0.95f, 0.52f, 0.06f}, kWhite{0.9f, 0.9f, 0.88f}, kGreen{0.2f, 0.8f, 0.25f},
        kRed{0.9f, 0.1f, 0.06f}, kGround{0.006f, 0.006f, 0.008f}, kBar{0.02f, 0.024f, 0.03f};
    constexpr float kPixelsPerM = 300, kRow_m = 0.125f, kHead_m = 0.3f;
    ImageColor image(static_cast<int>(size.x * kPixelsPerM), static_cast<int>(size.y * kPixelsPerM));
    Patch p(image, 0, 0, image.width, image.height);
    p.fill(kGround);
    const auto words = [&](std::string_view text, float x, float y, float high, Vec3f ink) {
        p.letters(text, {x * p.w, y}, {1, 0}, high, 0.15f * high, ink);
    };
    const float row = kRow_m * kPixelsPerM, high = 0.5f * row, top = p.h - kHead_m * kPixelsPerM;
    p.fill({0, top + 0.35f * row}, {p.w, p.h}, {0.02f, 0.05f, 0.14f});
    words("DEPARTURES", 0.03f, top + 0.85f * row, 0.1f * kPixelsPerM, kWhite);
    words("10:24", 0.88f, top + 0.85f * row, 0.1f * kPixelsPerM, kAmber);
    int minutes = 10 * 60 + 30;
    const int first = rng.index(static_cast<int>(kTowns.size()));
    for (int i = 0; top - row * static_cast<float>(i + 1) > 0.1f * row; ++i) {
        const float y = top - row * static_cast<float>(i + 1) + 0.2f * row;
        if (i % 2 == 0) p.fill({0, y - 0.25f * row}, {p.w, y + 0.75f * row}, kBar);
        minutes += 5 + 5 * rng.index(4);
        const std::string number = fmt::format("{} {}", one_of(rng, trains ? Words(kTrains) : Words(kCarriers)),
                                               100 + rng.index(880)),
                          where = trains
                                      ? fmt::format("{}", 1 + rng.index(14))
                                      : fmt::format("{}{}", static_cast<char>('A' + rng.index(4)), 1 + rng.index(40));
        words(fmt::format("{:02}:{:02}", minutes / 60 % 24, minutes % 60), 0.03f, y, high, kWhite);
        words(kTowns[static_cast<std::size_t>(first + 3 * i) % kTowns.size()], 0.16f, y, high, kAmber);
        words(number, 0.44f, y, high, kAmber);
        words(where, 0.64f, y, high, kWhite);
        const bool late = rng.chance(0.2f);
        if (late) words("DELAYED", 0.76f, y, high, kRed);
        else if (i < 2) words(trains ? "BOARDING" : "LAST CALL", 0.76f, y, high, kGreen);
        else if (!trains && rng.chance(0.5f)) words("GO TO GATE", 0.76f, y, high, kGreen);
        else words("ON TIME", 0.76f, y, high, kWhite);
    }
    return image;
}

}  // namespace

// Rows of times, destinations, numbers and gates or platforms: amber on black.
void build_departure_board(Kit& k) {
    const Vec3f s = k.wanted({3.4f, 1.5f, 0.14f});
    constexpr Vec3f kLit{2.2f, 2.2f, 2.2f};
    const int frame = k.main(plain("board frame", {0.05f, 0.052f, 0.055f}, 0.4f));
    const Vec2f face{s.x - 0.06f, s.y - 0.06f};
    const int shown = lit_picture(k, departures(k.rng, face, k.request.pattern == kTrainsPattern), kLit, face.x);
    k.board(frame, {0, 0, 0.5f * s.z}, s, 0.012f);
    k.add(screen_box({face.x, face.y, 0.006f}), shown, {0, 0.03f, s.z});
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 2.1f;
}

// The name of a stop: a long enamel plate with a bar or a disc.
void build_station_sign(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 0.5f, 0.04f});
    const int plate = k.main(plain("enamel", {0.02f, 0.08f, 0.3f}, 0.2f)),
              white = color(k, "white enamel", {0.72f, 0.72f, 0.7f}, 0.25f),
              red = color(k, "red enamel", {0.55f, 0.03f, 0.03f}, 0.25f);
    k.board(white, {0, 0, 0.3f * s.z}, {s.x, s.y, 0.6f * s.z}, 0.008f);
    k.board(plate, {0, 0.03f, 0.75f * s.z}, {s.x - 0.06f, s.y - 0.06f, 0.4f * s.z}, 0.006f);
    Mesh disc = shapes::prism(shapes::circle(0.36f * s.y, 32), 0, 0.01f);
    shapes::turn(disc, {1, 0, 0}, 90);
    k.add(std::move(disc), red, {-0.5f * s.x + 0.5f * s.y, 0.5f * s.y, s.z + 0.004f});
    block(k, white, {-0.5f * s.x + 0.5f * s.y, 0.42f * s.y, s.z + 0.012f}, {0.9f * s.y, 0.16f * s.y, 0.006f});
    lettering(k, white, -0.5f * s.x + 1.15f * s.y, 0.5f * s.x - 0.12f, 0.3f * s.y, s.z + 0.004f, 0.4f * s.y, 2);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.75f;
}

// A sign that hangs over the way, with arrows; both sides are read.
void build_hanging_sign(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 0.9f, 0.12f});
    const int body = k.main(plain("sign", {0.035f, 0.037f, 0.04f}, 0.4f)), metal = k.material(steel()),
              yellow = lit(k, "lit yellow", {2.1f, 1.55f, 0.12f}), white = lit(k, "lit white", {1.9f, 1.9f, 1.85f});
    const float high = 0.36f, low = -s.y;
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * 0.36f * s.x, 0, 0}, {sx * 0.36f * s.x, low + high, 0}, 0.012f, -1, 8);
    k.board(body, {0, low, 0}, {s.x, high, s.z}, 0.01f);
    const std::uint64_t side = k.rng.next_u32() % 2;
    for (const float face : {1.f, -1.f}) {
        const float z = face * (0.5f * s.z + 0.003f), way = (side != 0 ? 1.f : -1.f) * face;
        arrow(k, yellow, {-way * face * (0.5f * s.x - 0.2f), low + 0.5f * high, z}, 0.26f, -way * face);
        block(k, yellow, {-0.12f * s.x, low + 0.2f * high, z}, {0.22f, 0.6f * high, 0.004f});
        lettering(k, white, 0.0f, 0.3f * s.x, low + 0.5f * high, z, 0.09f, 2);
        lettering(k, white, 0.0f, 0.26f * s.x, low + 0.22f * high, z, 0.05f, 2);
    }
    k.piece.mount = Mount::ceiling;
}

// A round clock with two faces on a rod.
void build_station_clock(Kit& k) {
    const Vec3f s = k.wanted({0.7f, 1.2f, 0.2f});
    const int rim = k.main(k.style.metal), face = lit(k, "lit dial", {1.3f, 1.28f, 1.2f}),
              ink = color(k, "hands", {0.01f, 0.01f, 0.012f}, 0.4f);
    const float r = 0.5f * s.x, cy = -s.y + r;
    k.rod(rim, {0, 0, 0}, {0, cy + r - 0.02f, 0}, 0.022f);
    Mesh drum = shapes::prism(shapes::circle(r, 44), -0.5f * s.z, 0.5f * s.z, 0.02f);
    shapes::turn(drum, {1, 0, 0}, 90);
    k.add(std::move(drum), rim, {0, cy, 0});
    const float minute = kTau * k.rng.uniform(), hour = kTau * k.rng.uniform();
    for (const float side : {-1.f, 1.f}) {
        Mesh dial = shapes::prism(shapes::circle(0.9f * r, 44), 0, 0.006f);
        shapes::turn(dial, {1, 0, 0}, 90);
        const float z = side * (0.5f * s.z + 0.003f), over = side * (0.5f * s.z + 0.012f);
        k.add(std::move(dial), face, {0, cy, z + (side > 0 ? 0.f : 0.006f)});
        for (int i = 0; i < 12; ++i) {
            const float a = kTau * static_cast<float>(i) / 12;
            const Vec3f out{std::sin(a), std::cos(a), 0};
            strut(k, ink, Vec3f{0, cy, over} + out * (0.72f * r), Vec3f{0, cy, over} + out * (0.84f * r), 0.004f,
                  i % 3 == 0 ? 0.035f : 0.016f);
        }
        for (const auto& [angle, reach, wide] : {std::tuple{minute, 0.68f, 0.018f}, {hour, 0.44f, 0.028f}})
            strut(k, ink, {0, cy, over},
                  Vec3f{side * std::sin(angle) * reach * r, cy + std::cos(angle) * reach * r, over}, 0.004f, wide);
    }
    k.piece.mount = Mount::ceiling;
}

// The side of a train that has stopped: body, lit windows, doors, and the yellow line of the platform before it.
void build_platform_train(Kit& k) {
    const Vec3f s = k.wanted({9.f, 2.9f, 1.5f});
    const Vec3f livery = k.request.color ? *k.request.color : k.accent();
    const int body = k.main(plain("train body", {0.62f, 0.63f, 0.64f}, 0.25f)),
              stripe = color(k, "livery", livery, 0.25f), door = color(k, "train door", livery * 0.8f, 0.25f),
              dark = color(k, "underframe", {0.02f, 0.02f, 0.022f}, 0.7f), pane = k.material(glass()),
              seal = color(k, "seal", {0.02f, 0.02f, 0.02f}, 0.5f),
              inside = lit(k, "carriage light", {1.5f, 1.45f, 1.3f}), seat = color(k, "seat", livery * 0.6f, 0.8f),
              wall = color(k, "carriage wall", {0.55f, 0.54f, 0.5f}, 0.5f),
              yellow = color(k, "yellow line", {0.7f, 0.5f, 0.03f}, 0.7f),
              edge = color(k, "platform edge", {0.5f, 0.49f, 0.46f}, 0.8f);
    const float line = 0.42f, back = -0.5f * s.z, front = 0.5f * s.z - line, low = 0.06f, roof = s.y;
    // The platform's edge: light stone, then the line not to cross.
    k.board(edge, {0, 0, front + 0.14f}, {s.x, 0.012f, 0.26f}, 0.002f);
    k.board(yellow, {0, 0, front + 0.34f}, {s.x, 0.014f, 0.12f}, 0.002f);
    block(k, dark, {0, 0, 0.5f * (back + front) - 0.05f}, {s.x, low + 0.1f, front - back - 0.1f});
    // The inside, seen through panes.
    block(k, wall, {0, low, back + 0.05f}, {s.x, roof - low - 0.2f, 0.06f});
    k.board(inside, {0, roof - 0.36f, 0.5f * (back + front)}, {s.x - 0.4f, 0.04f, 0.28f});
    // Bays of a door and two windows.
    const int bays = std::max(1, static_cast<int>(std::lround(s.x / 3.f)));
    const float w = s.x / static_cast<float>(bays), door_w = 1.3f, sill = 0.95f, head = 2.05f;
    for (int i = 0; i < bays; ++i) {
        const float cx = -0.5f * s.x + w * (static_cast<float>(i) + 0.5f), side = 0.5f * (w - door_w);
        for (const float sx : {-1.f, 1.f}) {
            const float wx = cx + sx * (0.5f * door_w + 0.5f * side);
            k.board(body, {wx, low, front - 0.03f}, {side, sill - low, 0.06f}, 0.004f);
            k.board(stripe, {wx, sill - 0.28f, front + 0.004f}, {side, 0.16f, 0.008f}, 0.001f);
            k.board(body, {wx, head, front - 0.03f}, {side, roof - head - 0.14f, 0.06f}, 0.004f);
            for (const float e : {-1.f, 1.f})
                block(k, seal, {wx + e * (0.5f * side - 0.05f), sill, front - 0.03f}, {0.1f, head - sill, 0.05f});
            block(k, pane, {wx, sill, front - 0.03f}, {side - 0.18f, head - sill, 0.012f});
            // A bench along the far side.
            k.board(seat, {wx, low + 0.36f, back + 0.32f}, {side - 0.1f, 0.12f, 0.42f}, 0.03f);
            k.board(seat, {wx, low + 0.46f, back + 0.14f}, {side - 0.1f, 0.5f, 0.1f}, 0.03f);
            k.board(door, {cx + sx * 0.25f * door_w, low, front - 0.05f}, {0.5f * door_w - 0.012f, 0.86f, 0.05f},
                    0.01f);
            k.board(door, {cx + sx * 0.25f * door_w, head, front - 0.05f}, {0.5f * door_w - 0.012f, 0.1f, 0.05f},
                    0.01f);
            for (const float e : {-1.f, 1.f})
                block(k, door, {cx + sx * 0.25f * door_w + e * (0.25f * door_w - 0.06f), low + 0.86f, front - 0.05f},
                      {0.1f, head - low - 0.86f, 0.05f});
            block(k, pane, {cx + sx * 0.25f * door_w, low + 0.86f, front - 0.05f},
                  {0.5f * door_w - 0.2f, head - low - 0.86f, 0.01f});
        }
        block(k, seal, {cx, low, front - 0.045f}, {0.02f, head + 0.1f - low, 0.05f});
        k.board(body, {cx, head + 0.1f, front - 0.03f}, {door_w, roof - head - 0.24f, 0.06f}, 0.004f);
        k.rod(k.material(steel()), {cx, low, back + 0.75f}, {cx, roof - 0.3f, back + 0.75f}, 0.018f);
    }
    // The rounded roof.
    k.add(shapes::slab(2, 8, 0.03f,
                       [&](float u, float v) {
                           const float a = 0.5f * kPi * v;
                           return Vec3f{s.x * (u - 0.5f), roof - 0.2f + 0.17f * std::sin(a),
                                        front - (front - back) * (1 - std::cos(a))};
                       }),
          body);
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.6f;
}

// Three gates in a row: steel cabinets with glass wings and a lit arrow.
void build_ticket_gate(Kit& k) {
    const Vec3f s = k.wanted({2.9f, 1.05f, 1.3f});
    const int steel_part = k.main(steel()), dark = color(k, "top", {0.03f, 0.03f, 0.032f}, 0.35f),
              wing = color(k, "wing", {0.6f, 0.05f, 0.03f}, 0.25f), green = lit(k, "arrow", {0.4f, 2.6f, 0.7f}),
              red = lit(k, "no entry", {2.6f, 0.2f, 0.15f});
    const int ways = std::max(1, static_cast<int>((s.x - 0.25f) / 0.85f));
    const float pitch = (s.x - 0.25f) / static_cast<float>(ways);
    for (int i = 0; i <= ways; ++i) {
        const float x = -0.5f * s.x + 0.125f + pitch * static_cast<float>(i);
        k.add(shapes::prism(shapes::rounded_rectangle(0.22f, s.z, 0.1f), 0, s.y - 0.06f, 0.006f), steel_part,
              {x, 0, 0});
        k.add(shapes::prism(shapes::rounded_rectangle(0.24f, s.z + 0.02f, 0.11f), s.y - 0.06f, s.y, 0.01f), dark,
              {x, 0, 0});
        block(k, i % 3 == 2 ? red : green, {x, 0.72f, 0.5f * s.z + 0.001f}, {0.1f, 0.1f, 0.012f});
        block(k, green, {x, s.y, 0.3f * s.z}, {0.09f, 0.006f, 0.14f});
        if (i == ways) break;
        for (const float side : {-1.f, 1.f}) {
            const float hinge = x + 0.5f * pitch + side * (0.5f * pitch - 0.11f);
            k.board(wing, {hinge - side * 0.13f, 0.35f, 0}, {0.26f, 0.5f, 0.02f}, 0.008f);
        }
    }
    k.piece.clearance_front_m = 1.f;
}

// Machines that sell tickets, side by side at a wall.
void build_ticket_machine(Kit& k) {
    const Vec3f s = k.wanted({0.8f, 1.8f, 0.5f});
    const int body = k.main(plain("machine", k.accent(), 0.35f)), face = color(k, "face", {0.5f, 0.51f, 0.52f}, 0.35f),
              dark = color(k, "slot", {0.015f, 0.015f, 0.015f}, 0.4f), head = lit(k, "lit head", {1.6f, 1.65f, 1.7f});
    const int screen = lit_screen(k, Shown::tickets, kMonitorWhite, 0.4f);
    k.board(body, {0, 0, 0}, s, 0.02f);
    const float z = 0.5f * s.z;
    k.board(face, {0, 0.62f, z}, {s.x - 0.12f, 0.82f, 0.02f}, 0.006f);
    k.add(screen_box({0.4f, 0.3f, 0.006f}), screen, {-0.08f, 1.02f, z + 0.012f});
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            block(k, dark,
                  {0.22f + 0.045f * static_cast<float>(i - 1), 1.05f + 0.05f * static_cast<float>(j), z + 0.012f},
                  {0.032f, 0.034f, 0.008f});
    block(k, dark, {0.2f, 0.88f, z + 0.012f}, {0.16f, 0.02f, 0.008f});
    k.board(dark, {0, 0.66f, z + 0.008f}, {0.34f, 0.14f, 0.012f}, 0.004f);
    block(k, head, {0, s.y - 0.24f, z + 0.002f}, {s.x - 0.14f, 0.16f, 0.01f});
    lettering(k, dark, -0.28f, 0.28f, s.y - 0.2f, z + 0.01f, 0.08f, 1);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.9f;
}

// A desk with a belt and scales beside it, a monitor above.
void build_check_in_desk(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 2.5f, 1.2f});
    const int front = k.main(plain("desk front", k.accent(), 0.35f)),
              top = color(k, "desk top", {0.62f, 0.62f, 0.6f}, 0.3f), metal = k.material(steel()),
              rubber = color(k, "belt", {0.02f, 0.02f, 0.021f}, 0.7f), lampm = lit(k, "logo", {1.8f, 1.8f, 1.75f});
    const int screen = lit_screen(k, Shown::check_in, kMonitorWhite * 1.3f, 0.6f * s.x),
              shell = color(k, "bezel", {0.025f, 0.025f, 0.027f}, 0.4f);
    const float desk = 0.62f * s.x, x = -0.5f * s.x + 0.5f * desk, high = 1.12f, z = 0.5f * s.z;
    k.board(front, {x, 0.08f, z - 0.06f}, {desk, high - 0.12f, 0.06f}, 0.006f);
    k.board(metal, {x, 0, z - 0.08f}, {desk, 0.08f, 0.05f}, 0.002f);
    k.board(top, {x, high - 0.04f, z - 0.16f}, {desk + 0.04f, 0.04f, 0.32f}, 0.008f);
    k.board(top, {x, 0.72f, z - 0.5f}, {desk, 0.035f, 0.5f}, 0.006f);
    lettering(k, lampm, x - 0.3f, x + 0.36f, 0.55f, z - 0.026f, 0.16f, 1);
    for (const float sx : {-1.f, 1.f})
        k.board(front, {x + sx * (0.5f * desk - 0.02f), 0, z - 0.4f}, {0.04f, high - 0.04f, 0.7f}, 0.004f);
    k.board(shell, {x, 0.76f, z - 0.46f}, {0.44f, 0.3f, 0.04f}, 0.008f);
    // The belt.
    const float bx = 0.5f * s.x - 0.5f * (s.x - desk), bw = s.x - desk - 0.06f;
    k.board(metal, {bx, 0, 0}, {bw + 0.06f, 0.26f, s.z}, 0.006f);
    k.board(rubber, {bx, 0.26f, 0}, {bw - 0.04f, 0.025f, s.z - 0.02f}, 0.008f);
    // The monitor over the desk, on posts behind it.
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {x + sx * 0.5f * desk, 0, -z + 0.05f}, {x + sx * 0.5f * desk, s.y, -z + 0.05f}, 0.03f);
    k.board(shell, {x, s.y - 0.46f, -z + 0.09f}, {desk + 0.06f, 0.46f, 0.08f}, 0.01f);
    k.add(screen_box({desk - 0.04f, 0.38f, 0.004f}), screen, {x, s.y - 0.42f, -z + 0.132f});
    k.piece.clearance_front_m = 1.2f;
}

// A trolley with bags on it.
void build_luggage_trolley(Kit& k) {
    const int metal = k.main(steel()), tire = color(k, "wheel", {0.02f, 0.02f, 0.02f}, 0.8f),
              grip = color(k, "grip", k.accent(), 0.5f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(metal, {sx * 0.27f, 0.16f, 0.5f}, {sx * 0.24f, 0.2f, -0.42f}, 0.014f);
        k.rod(metal, {sx * 0.24f, 0.2f, -0.42f}, {sx * 0.24f, 1.02f, -0.52f}, 0.016f);
        Mesh wheel = shapes::prism(shapes::circle(0.09f, 20), -0.02f, 0.02f, 0.006f);
        shapes::turn(wheel, {0, 0, 1}, 90);
        k.add(std::move(wheel), tire, {sx * 0.25f, 0.09f, -0.38f});
    }
    Mesh wheel = shapes::prism(shapes::circle(0.08f, 20), -0.02f, 0.02f, 0.006f);
    shapes::turn(wheel, {0, 0, 1}, 90);
    k.add(std::move(wheel), tire, {0, 0.08f, 0.44f});
    k.rod(grip, {-0.27f, 1.02f, -0.52f}, {0.27f, 1.02f, -0.52f}, 0.02f);
    for (int i = 0; i < 5; ++i) {
        const float z = -0.38f + 0.2f * static_cast<float>(i);
        k.rod(metal, {-0.26f, 0.185f, z}, {0.26f, 0.185f, z}, 0.008f, -1, 6);
    }
    float y = 0.2f;
    for (int i = 0; i < 2 + k.rng.index(2); ++i) {
        const int bag = k.material(plain("suitcase", i == 0 ? Vec3f{0.03f, 0.035f, 0.05f} : k.accent(), 0.45f));
        const Vec3f size{k.rng.uniform(0.42f, 0.5f), k.rng.uniform(0.22f, 0.3f), k.rng.uniform(0.62f, 0.74f)};
        const float x = k.rng.uniform(-0.02f, 0.02f);
        k.board(bag, {x, y, 0}, size, 0.035f);
        for (int rib = -1; rib <= 1; ++rib)
            k.board(bag, {x + 0.12f * static_cast<float>(rib), y + 0.006f, 0}, {0.04f, size.y, size.z - 0.1f}, 0.01f);
        k.rod(tire, {x - 0.09f, y + 0.5f * size.y, 0.5f * size.z + 0.02f},
              {x + 0.09f, y + 0.5f * size.y, 0.5f * size.z + 0.02f}, 0.011f, -1, 8);
        y += size.y;
    }
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
