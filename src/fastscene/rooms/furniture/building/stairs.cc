// Stairs and lifts, fronts of shops, vaults: what stands in a room and is part of the house.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

constexpr float kRise = 0.17f, kGoing = 0.28f, kRailing = 0.92f;  // of stairs one walks with ease, metres

struct Flight {
    Vec3f foot;   // middle of the lowest riser
    Vec3f along;  // horizontal unit vector, up the flight
    int steps;
    float width;
};

struct StairMaterials {
    int tread, side, metal, rail;
};

// Steps with a nosing on a closed string; a balustrade on the sides in `rails` (-1: left, going up).
void flight(Kit& k, const StairMaterials& m, const Flight& f, std::span<const float> rails) {
    const Vec3f across{f.along.z, 0, -f.along.x};
    const bool x_way = std::abs(f.along.x) > 0.5f;
    const auto sized = [&](float wide, float high, float deep) {
        return x_way ? Vec3f{deep, high, wide} : Vec3f{wide, high, deep};
    };
    for (int i = 0; i < f.steps; ++i) {
        const Vec3f at = f.foot + f.along * (kGoing * (static_cast<float>(i) + 0.5f)) +
                         Vec3f{0, kRise * static_cast<float>(i), 0};
        // Below it is closed down to the string's lower edge.
        const float down = std::min(kRise * static_cast<float>(i), 0.22f);
        block(k, m.side, at - Vec3f{0, down, 0}, sized(f.width - 0.02f, kRise - 0.03f + down, kGoing));
        k.board(m.tread, at + Vec3f{0, kRise - 0.03f, 0} - f.along * 0.01f, sized(f.width, 0.03f, kGoing + 0.02f),
                0.006f);
    }
    const float run = kGoing * static_cast<float>(f.steps), up = kRise * static_cast<float>(f.steps);
    for (const float side : rails) {
        const Vec3f edge = f.foot + across * (side * (0.5f * f.width - 0.04f));
        for (int i = 0; i < f.steps; ++i)
            for (const float part : {0.25f, 0.75f}) {
                const Vec3f base = edge + f.along * (kGoing * (static_cast<float>(i) + part)) +
                                   Vec3f{0, kRise * static_cast<float>(i + 1), 0};
                const float slope = kRise * (part - 1.f);
                k.rod(m.metal, base, base + Vec3f{0, kRailing + slope, 0}, 0.009f, -1, 6);
            }
        const Vec3f low = edge + Vec3f{0, kRise + kRailing - kRise, 0},
                    high = edge + f.along * run + Vec3f{0, up + kRailing, 0};
        k.rod(m.rail, low, high, 0.026f, -1, 10);
        k.rod(m.rail, edge, low + Vec3f{0, 0.06f, 0}, 0.04f, -1, 12);
    }
}

// A slab with a balustrade along its front edge (in x).
void landing(Kit& k, const StairMaterials& m, Vec3f low_center, Vec3f size) {
    k.board(m.side, low_center, {size.x, size.y - 0.03f, size.z}, 0.004f);
    k.board(m.tread, low_center + Vec3f{0, size.y - 0.03f, 0}, {size.x, 0.03f, size.z}, 0.004f);
}

}  // namespace

namespace {

// About a post, up to the ceiling: treads like slices, a helical handrail.
void spiral_stairs(Kit& k, Vec3f s) {
    const int tread = k.main(k.style.wood), metal = k.material(k.style.metal), rail = k.material(k.style.wood2);
    const float r = 0.5f * std::min(s.x, s.z);
    constexpr float kTurns = 1.1f, kPost = 0.06f;
    const int steps = std::max(8, static_cast<int>(s.y / 0.2f));
    k.rod(metal, {0, 0, 0}, {0, s.y, 0}, kPost, -1, 16);
    std::vector<Vec3f> hand;
    const float slice = kTau * kTurns / static_cast<float>(steps);
    for (int i = 0; i < steps; ++i) {
        const float y = s.y * static_cast<float>(i + 1) / static_cast<float>(steps + 1),
                    a = slice * static_cast<float>(i);
        std::vector<Vec2f> outline{{kPost * std::cos(a), kPost * std::sin(a)}};
        constexpr int kArc = 5;
        for (int j = 0; j <= kArc; ++j) {
            const float at = a + slice * 1.15f * (static_cast<float>(j) / kArc);
            outline.push_back({(r - 0.03f) * std::cos(at), (r - 0.03f) * std::sin(at)});
        }
        std::reverse(outline.begin(), outline.end());
        k.add(shapes::prism(outline, y - 0.035f, y, 0.004f), tread);
        const Vec3f out = around(a + 0.5f * slice) * (r - 0.05f), foot = out + Vec3f{0, y, 0};
        const float high = std::min(kRailing, s.y - y);
        if (high > 0.1f) k.rod(metal, foot, foot + Vec3f{0, high, 0}, 0.01f, -1, 6);
        if (y + kRailing < s.y) hand.push_back(foot + Vec3f{0, kRailing, 0});
    }
    if (hand.size() > 3) k.add(shapes::tube(hand, 0.022f, 8), rail);
    k.piece.clearance_front_m = 0.7f;
}

}  // namespace

// Stairs in two flights with a landing at the back, up to a gallery, where there is the width; else a spiral.
void build_staircase(Kit& k) {
    constexpr float kLeastForTwo = 2.1f;
    if (k.request.size_m.x < kLeastForTwo) return spiral_stairs(k, k.wanted({1.5f, 2.35f, 1.5f}));
    const Vec3f s = k.wanted({2.6f, 4.1f, 4.4f});
    const StairMaterials m{k.main(k.style.wood), k.material(plain("string", {0.66f, 0.65f, 0.62f}, 0.5f)),
                           k.material(k.style.metal), k.material(k.style.wood2)};
    const float up = s.y - kRailing;
    const int all = std::max(6, static_cast<int>(up / kRise));
    const float width = 0.5f * s.x - 0.08f, deep = width;
    const int most = static_cast<int>((s.z - deep) / kGoing), first = std::min(all / 2, most),
              second = std::min(all - first, most);
    const float mid = kRise * static_cast<float>(first), top = mid + kRise * static_cast<float>(second),
                back = -0.5f * s.z;
    const float x = 0.5f * s.x - 0.5f * width, foot = back + deep + kGoing * static_cast<float>(first);
    const std::array<float, 2> both{-1.f, 1.f};
    flight(k, m, {{-x, 0, foot}, {0, 0, -1}, first, width}, both);
    landing(k, m, {0, mid - 0.2f, back + 0.5f * deep}, {s.x, 0.2f, deep});
    flight(k, m, {{x, mid, back + deep}, {0, 0, 1}, second, width}, both);
    // Behind the landing and at its sides.
    for (const float sx : {-1.f, 1.f}) {
        k.rod(m.rail, {sx * (0.5f * s.x - 0.05f), mid + kRailing, back + 0.05f},
              {sx * (0.5f * s.x - 0.05f), mid + kRailing, back + deep}, 0.026f);
        for (float z = back + 0.1f; z < back + deep; z += 0.14f)
            k.rod(m.metal, {sx * (0.5f * s.x - 0.05f), mid, z}, {sx * (0.5f * s.x - 0.05f), mid + kRailing, z}, 0.009f,
                  -1, 6);
    }
    k.board(m.side, {-0.5f * s.x + 0.1f, 0, back + 0.12f}, {0.14f, mid - 0.2f, 0.14f}, 0.01f);
    k.board(m.side, {0.5f * s.x - 0.1f, 0, back + 0.12f}, {0.14f, mid - 0.2f, 0.14f}, 0.01f);
    // The gallery that the second flight reaches, on a post.
    const float reach = std::min(1.f, 0.5f * s.z - (back + deep + kGoing * static_cast<float>(second)));
    if (reach > 0.4f) {
        const float z = 0.5f * s.z - 0.5f * reach;
        landing(k, m, {x, top - 0.2f, z}, {width, 0.2f, reach});
        k.board(m.side, {x, 0, 0.5f * s.z - 0.14f}, {0.14f, top - 0.2f, 0.14f}, 0.01f);
        for (const float sx : {-1.f, 1.f}) {
            const float px = x + sx * (0.5f * width - 0.04f);
            k.rod(m.rail, {px, top + kRailing, z - 0.5f * reach}, {px, top + kRailing, z + 0.5f * reach - 0.04f},
                  0.026f);
            for (float pz = z - 0.5f * reach + 0.07f; pz < z + 0.5f * reach; pz += 0.14f)
                k.rod(m.metal, {px, top, pz}, {px, top + kRailing, pz}, 0.009f, -1, 6);
        }
        k.rod(m.rail, {x - 0.5f * width + 0.04f, top + kRailing, z + 0.5f * reach - 0.04f},
              {x + 0.5f * width - 0.04f, top + kRailing, z + 0.5f * reach - 0.04f}, 0.026f);
    }
    k.piece.clearance_front_m = 1.f;
}

// Moving stairs: steel, black handrails, grooved steps.
void build_escalator(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 3.6f, 6.2f});
    const int metal = k.main(steel()), step = color(k, "step", {0.09f, 0.09f, 0.095f}, 0.45f),
              rubber = color(k, "handrail", {0.012f, 0.012f, 0.012f}, 0.5f), pane = k.material(glass()),
              comb = color(k, "comb", {0.6f, 0.42f, 0.03f}, 0.5f);
    const float flat_m = 0.9f, up = s.y - 1.f, z0 = 0.5f * s.z, rise_run = s.z - 2 * flat_m;
    const auto height = [&](float z) {
        const float t = std::clamp((z0 - flat_m - z) / rise_run, 0.f, 1.f);
        return up * t * t * (3 - 2 * t) * 0.4f + up * t * 0.6f;
    };
    const int steps = static_cast<int>(s.z / 0.3f);
    for (int i = 0; i < steps; ++i) {
        const float z = z0 - 0.3f * (static_cast<float>(i) + 0.5f), y = height(z);
        block(k, step, {0, std::max(0.f, y - 0.2f), z}, {s.x - 0.44f, 0.04f + std::min(0.2f, y), 0.298f});
        block(k, comb, {0, y + 0.04f, z + 0.14f}, {s.x - 0.46f, 0.003f, 0.012f});
    }
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.12f);
        // The truss, the balustrade's pane, the handrail.
        k.add(shapes::slab(24, 1, 0.2f,
                           [&](float u, float v) {
                               const float z = z0 - s.z * u, y = height(z);
                               return Vec3f{sx > 0 ? x + 0.1f : x - 0.1f + 0.2f,
                                            std::lerp(std::max(0.f, y - 0.55f), y + 0.16f, sx > 0 ? v : v), z};
                           }),
              metal);
        k.add(shapes::sheet(24, 1,
                            [&](float u, float v) {
                                const float z = z0 - 0.1f - (s.z - 0.2f) * u;
                                return Vec3f{x, height(z) + 0.16f + 0.74f * v, z};
                            }),
              pane);
        std::vector<Vec3f> path;
        for (int i = 0; i <= 28; ++i) {
            const float z = z0 - 0.06f - (s.z - 0.12f) * static_cast<float>(i) / 28;
            path.push_back({x, height(z) + 0.93f, z});
        }
        path.insert(path.begin(), {x, height(z0) + 0.5f, z0 - 0.02f});
        k.add(shapes::tube(path, 0.04f, 10), rubber);
    }
    k.piece.clearance_front_m = 1.2f;
}

namespace {

// Steel that is brushed: it shines, and shows no picture of the room.
Material brushed(const char* name, Vec3f tone) {
    Material m = plain(name, tone, 0.42f);
    m.metal = 0.35f;
    return m;
}

// A digit of seven lit segments, by the middle of its lower edge.
void lit_digit(Kit& k, int ink, int digit, Vec3f at, float high) {
    constexpr std::array<unsigned, 10> kSegments{0x3f, 0x06, 0x5b, 0x4f, 0x66, 0x6d, 0x7d, 0x07, 0x7f, 0x6f};
    const float wide = 0.5f * high, thick = 0.13f * high, half = 0.5f * high;
    const std::array<std::pair<Vec2f, bool>, 7> places{{{{0, high - thick}, false},
                                                        {{0.5f * wide, half}, true},
                                                        {{0.5f * wide, 0}, true},
                                                        {{0, 0}, false},
                                                        {{-0.5f * wide, 0}, true},
                                                        {{-0.5f * wide, half}, true},
                                                        {{0, half - 0.5f * thick}, false}}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!(kSegments[static_cast<std::size_t>(digit)] >> i & 1u)) continue;
        const auto& [p, upright] = places[i];
        block(k, ink, at + Vec3f{p.x, p.y, 0}, upright ? Vec3f{thick, half, 0.003f} : Vec3f{wide, thick, 0.003f});
    }
}

constexpr int kLiftFloor = 4;  // the lamp above a lift's doors and its panel tell the same

// An arrow that points up.
void lit_arrow(Kit& k, int ink, Vec3f at, float high) {
    block(k, ink, at, {0.16f * high, 0.7f * high, 0.003f});
    for (const float side : {-1.f, 1.f})
        slat(k, ink, at + Vec3f{side * 0.32f * high, 0.58f * high, 0}, at + Vec3f{0, 0.95f * high, 0}, 0.16f * high,
             0.003f);
}

}  // namespace

// The leaves of a lift's door in a steel frame, with a lamp that tells the floor.
void build_elevator_doors(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 2.1f, 0.07f});
    const int leaf = k.main(brushed("brushed steel", {0.5f, 0.505f, 0.51f})),
              frame = k.material(brushed("door frame", {0.33f, 0.335f, 0.34f})),
              dark = color(k, "gap", {0.01f, 0.01f, 0.01f}, 0.7f),
              panel = color(k, "plate", {0.012f, 0.012f, 0.014f}, 0.2f);
    Material number = glow("floor", {3.2f, 0.5f, 0.15f});
    number.pattern = Pattern::screen;
    const int lamp = k.material(std::move(number));
    const float w = 0.5f * (s.x - 0.2f), high = s.y - 0.22f;
    for (const float sx : {-1.f, 1.f}) {
        k.board(leaf, {sx * 0.5f * w, 0, 0.02f}, {w - 0.004f, high, 0.03f}, 0.003f);
        k.board(frame, {sx * (w + 0.05f), 0, 0.5f * s.z}, {0.1f, high + 0.1f, s.z}, 0.006f);
    }
    block(k, dark, {0, 0, 0.034f}, {0.006f, high, 0.006f});
    k.board(frame, {0, high, 0.5f * s.z}, {s.x, s.y - high, s.z}, 0.006f);
    block(k, panel, {0, high + 0.04f, s.z}, {0.34f, 0.14f, 0.006f});
    lit_digit(k, lamp, kLiftFloor, {0.05f, high + 0.065f, s.z + 0.006f}, 0.09f);
    lit_arrow(k, lamp, {-0.07f, high + 0.065f, s.z + 0.006f}, 0.09f);
    // The sill, and the seams of the leaves.
    block(k, frame, {0, 0, 0.045f}, {2 * w, 0.012f, 0.04f});
    for (const float sx : {-1.f, 1.f})
        block(k, frame, {sx * (w - 0.012f), 0.02f, 0.0345f}, {0.012f, high - 0.02f, 0.003f});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.5f;
}

// The plate with the buttons of the floors.
void build_elevator_panel(Kit& k) {
    const Vec3f s = k.wanted({0.3f, 1.36f, 0.03f});
    const int plate = k.main(brushed("button plate", {0.55f, 0.555f, 0.56f})),
              ring = color(k, "button ring", {0.1f, 0.1f, 0.1f}, 0.3f),
              dark = color(k, "display", {0.01f, 0.01f, 0.012f}, 0.2f),
              ink = color(k, "number", {0.05f, 0.05f, 0.055f}, 0.5f);
    const auto shining = [&](const char* name, Vec3f radiance) {
        Material m = glow(name, radiance);
        m.pattern = Pattern::screen;
        return k.material(std::move(m));
    };
    const int pale = shining("button", {0.85f, 0.85f, 0.82f}), chosen = shining("chosen button", {3.4f, 1.3f, 0.12f}),
              digit = shining("display digit", {3.2f, 0.5f, 0.15f}),
              alarm = color(k, "alarm button", {0.6f, 0.03f, 0.02f}, 0.3f);
    k.board(plate, {0, 0, 0.5f * s.z}, s, 0.006f);
    block(k, dark, {0, s.y - 0.23f, s.z}, {0.2f, 0.16f, 0.004f});
    lit_digit(k, digit, kLiftFloor, {0.035f, s.y - 0.205f, s.z + 0.004f}, 0.1f);
    lit_arrow(k, digit, {-0.05f, s.y - 0.2f, s.z + 0.004f}, 0.09f);
    constexpr int kRows = 6;
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < 2; ++i) {
            const int number = 2 * j + i;
            const Vec3f at{0.062f * (i == 0 ? -1.f : 1.f), 0.26f + 0.135f * static_cast<float>(j), s.z};
            const int face = number == kLiftFloor + 2 || number == 0 ? chosen : pale;
            for (const auto& [r, deep, material] : {std::tuple{0.037f, 0.008f, ring}, {0.03f, 0.012f, face}}) {
                Mesh disc = shapes::prism(shapes::circle(r, 20), 0, deep, 0.002f);
                shapes::turn(disc, {1, 0, 0}, 90);
                k.add(std::move(disc), material, at + Vec3f{0, 0, deep});
            }
            const float z = s.z + 0.024f;
            if (number < 10) lit_digit(k, ink, number, at + Vec3f{0, -0.014f, z - s.z}, 0.028f);
            else
                for (const auto& [d, x] : {std::pair{1, -0.01f}, {number - 10, 0.01f}})
                    lit_digit(k, ink, d, at + Vec3f{x, -0.014f, z - s.z}, 0.026f);
        }
    for (const float x : {-0.062f, 0.062f}) {
        Mesh disc = shapes::prism(shapes::circle(0.032f, 20), 0, 0.014f, 0.003f);
        shapes::turn(disc, {1, 0, 0}, 90);
        k.add(std::move(disc), x < 0 ? alarm : ring, {x, 0.11f, s.z + 0.014f});
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.75f;
}

// A bar to hold along a wall.
void build_handrail(Kit& k) {
    const Vec3f s = k.wanted({1.4f, 0.08f, 0.09f});
    const int metal = k.main(steel());
    k.rod(metal, {-0.5f * s.x, 0.04f, 0.07f}, {0.5f * s.x, 0.04f, 0.07f}, 0.02f, -1, 14);
    for (float x = -0.5f * s.x + 0.12f; x < 0.5f * s.x; x += std::max(0.4f, s.x - 0.24f))
        k.rod(metal, {x, 0.04f, 0.f}, {x, 0.04f, 0.07f}, 0.012f, -1, 8);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.88f;
}

// One bay of a groin vault: two barrels that cross, on four springers.
void build_groin_vault(Kit& k) {
    const Vec3f s = k.wanted({3.2f, 1.5f, 3.2f});
    const int stone = k.main(k.style.wall), rib = k.material(tinted(k.style.wall, {0.5f, 0.47f, 0.42f}));
    constexpr float kThick = 0.02f;
    const float hx = 0.5f * s.x, hz = 0.5f * s.z, high = s.y - kThick;
    // The height of a half ellipse over [-1, 1].
    const auto arc = [](float t) { return std::sqrt(std::max(0.f, 1.f - t * t)); };
    constexpr int kCells = 28;
    k.add(shapes::sheet(kCells, kCells,
                        [&](float u, float v) {
                            // Denser towards the edges, where arches are steep.
                            const float a = -std::cos(kPi * u), b = std::cos(kPi * v);
                            return Vec3f{a * hx, -s.y + high * std::max(arc(a), arc(b)), b * hz};
                        }),
          stone);
    // Ribs along the groins and the bay's edges, within the bay.
    constexpr float kRib = 0.07f, kIn = 0.12f;
    for (const float sx : {-1.f, 1.f}) {
        std::vector<Vec3f> groin, edge_x, edge_z;
        for (int i = 0; i <= 28; ++i) {
            const float t = -std::cos(kPi * static_cast<float>(i) / 28), y = -s.y + high * arc(t) - kRib;
            groin.push_back({t * (hx - kIn), y, sx * t * (hz - kIn)});
            edge_x.push_back({t * (hx - kIn), y, sx * (hz - kRib)});
            edge_z.push_back({sx * (hx - kRib), y, t * (hz - kIn)});
        }
        for (const std::vector<Vec3f>& path : {groin, edge_x, edge_z}) k.add(shapes::tube(path, kRib, 8), rib);
    }
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
