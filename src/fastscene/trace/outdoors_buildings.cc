#include "fastscene/trace/outdoors_buildings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/trace/outdoors_plants.h"

namespace fastscene::outdoors {
namespace {

constexpr std::array<Vec3f, 9> kWalls{Vec3f{0.56f, 0.5f, 0.4f}, {0.6f, 0.58f, 0.54f}, {0.3f, 0.14f, 0.09f},
                                      {0.45f, 0.42f, 0.38f},    {0.52f, 0.4f, 0.28f}, {0.36f, 0.35f, 0.33f},
                                      {0.55f, 0.46f, 0.42f},    {0.36f, 0.2f, 0.14f}, {0.64f, 0.63f, 0.6f}};
constexpr std::array<Vec3f, 3> kRoofs{Vec3f{0.23f, 0.095f, 0.06f}, {0.085f, 0.088f, 0.1f}, {0.14f, 0.1f, 0.08f}};

// A wall as a frame: `right` and `out` are unit vectors, the origin is its lower left corner seen from outside.
struct Wall {
    Vec3f origin, right, out;
    Vec3f at(float x, float y, float off = 0) const { return origin + right * x + Vec3f{0, y, 0} + out * off; }
};

// A slab that stands out from the wall: front, top, bottom and ends.
void add_slab(QuadMesh& mesh, const Wall& w, float x0, float x1, float y0, float y1, float back, float front,
              std::uint16_t paint) {
    mesh.quad(w.at(x0, y0, front), w.at(x1, y0, front), w.at(x1, y1, front), w.at(x0, y1, front), paint);
    mesh.quad(w.at(x0, y1, front), w.at(x1, y1, front), w.at(x1, y1, back), w.at(x0, y1, back), paint);
    mesh.quad(w.at(x0, y0, front), w.at(x1, y0, front), w.at(x1, y0, back), w.at(x0, y0, back), paint);
    mesh.quad(w.at(x0, y0, front), w.at(x0, y1, front), w.at(x0, y1, back), w.at(x0, y0, back), paint);
    mesh.quad(w.at(x1, y0, front), w.at(x1, y1, front), w.at(x1, y1, back), w.at(x1, y0, back), paint);
}

// A window set back into the wall, with reveals, frame, bars and sill.
void add_window(QuadMesh& mesh, const Wall& w, float x0, float x1, float y0, float y1, std::uint16_t reveal,
                bool bars) {
    constexpr float kDeep = 0.16f, kFrame = 0.07f;
    mesh.quad(w.at(x0, y0), w.at(x0, y1), w.at(x0, y1, -kDeep), w.at(x0, y0, -kDeep), reveal);
    mesh.quad(w.at(x1, y0), w.at(x1, y1), w.at(x1, y1, -kDeep), w.at(x1, y0, -kDeep), reveal);
    mesh.quad(w.at(x0, y1), w.at(x1, y1), w.at(x1, y1, -kDeep), w.at(x0, y1, -kDeep), reveal);
    mesh.quad(w.at(x0, y0, -kDeep), w.at(x1, y0, -kDeep), w.at(x1, y1, -kDeep), w.at(x0, y1, -kDeep), kGlass);
    const auto bar = [&](float a, float b, float c, float d) {
        add_slab(mesh, w, a, b, c, d, -kDeep, -kDeep + 0.05f, kTrim);
    };
    bar(x0, x0 + kFrame, y0, y1);
    bar(x1 - kFrame, x1, y0, y1);
    bar(x0, x1, y0, y0 + kFrame);
    bar(x0, x1, y1 - kFrame, y1);
    const float middle = 0.5f * (x0 + x1), cross = y0 + 0.66f * (y1 - y0);
    if (x1 - x0 > 0.8f) bar(middle - 0.03f, middle + 0.03f, y0, y1);
    if (bars) bar(x0, x1, cross - 0.025f, cross + 0.025f);
    add_slab(mesh, w, x0 - 0.08f, x1 + 0.08f, y0 - 0.07f, y0, -0.02f, 0.09f, kTrim);
}

struct Bays {
    float bay_m, window_m;  // width of a bay, and of its window
    float storey_m, ground_m;
    int floors;
    float sill, head;  // of a window, as shares of the storey
    bool bars, shops;
};

// A wall of equal bays. Cells of the grid are wall, or wall around a window.
void add_facade(QuadMesh& mesh, const Wall& w, float wide, const Bays& b, std::uint16_t wall, Random& random) {
    const int bays = std::max(1, static_cast<int>(wide / b.bay_m));
    const float bay = wide / static_cast<float>(bays);
    float low = 0;
    for (int f = 0; f < b.floors; ++f) {
        const bool shop = b.shops && f == 0;
        const float high = low + (f == 0 ? b.ground_m : b.storey_m), tall = high - low;
        const float y0 = low + tall * (shop ? 0.1f : b.sill), y1 = low + tall * (shop ? 0.78f : b.head);
        for (int k = 0; k < bays; ++k) {
            const float left = bay * static_cast<float>(k), right = left + bay;
            const float half = 0.5f * std::min(bay - 0.3f, shop ? 0.86f * bay : b.window_m);
            const float x0 = 0.5f * (left + right) - half, x1 = x0 + 2 * half;
            const auto patch = [&](float a, float c, float d, float e) {
                mesh.quad(w.at(a, d), w.at(c, d), w.at(c, e), w.at(a, e), wall);
            };
            if (!b.shops && f > 0 && random.chance(0.06f)) {
                patch(left, right, low, high);
                continue;
            }
            patch(left, right, low, y0);
            patch(left, right, y1, high);
            patch(left, x0, y0, y1);
            patch(x1, right, y0, y1);
            add_window(mesh, w, x0, x1, y0, y1, wall, b.bars);
        }
        if (b.shops) add_slab(mesh, w, 0, wide, high - (f == 0 ? 0.3f : 0.12f), high, 0, f == 0 ? 0.16f : 0.06f, kTrim);
        low = high;
    }
}

std::array<Wall, 4> walls_of_box(float wide, float deep) {
    const float a = 0.5f * wide, b = 0.5f * deep;
    return {Wall{{-a, 0, -b}, {1, 0, 0}, {0, 0, -1}}, Wall{{a, 0, b}, {-1, 0, 0}, {0, 0, 1}},
            Wall{{-a, 0, b}, {0, 0, -1}, {-1, 0, 0}}, Wall{{a, 0, -b}, {0, 0, 1}, {1, 0, 0}}};
}

}  // namespace

void add_box(QuadMesh& mesh, Vec3f low, Vec3f high, std::uint16_t paint) {
    const Vec3f size = high - low, middle = (low + high) * 0.5f;
    for (const Wall& w : walls_of_box(size.x, size.z)) {
        const Wall moved{w.origin + Vec3f{middle.x, low.y, middle.z}, w.right, w.out};
        const float wide = std::abs(w.right.x) > 0.5f ? size.x : size.z;
        mesh.quad(moved.at(0, 0), moved.at(wide, 0), moved.at(wide, size.y), moved.at(0, size.y), paint);
    }
    mesh.quad({low.x, high.y, low.z}, {high.x, high.y, low.z}, {high.x, high.y, high.z}, {low.x, high.y, high.z},
              paint);
}

QuadMesh build_house(World& world, std::uint32_t seed) {
    Random random(seed, "outdoors.house");
    QuadMesh mesh;
    const std::uint16_t wall = world.add({Finish::matt, kWalls[static_cast<std::size_t>(random.index(9))], {}, 0.18f}),
                        roof = world.add({Finish::matt, kRoofs[static_cast<std::size_t>(random.index(3))], {}, 0.35f});
    const float wide = random.uniform(8.5f, 12.f), deep = random.uniform(7.f, 9.f), storey = 2.8f;
    const int floors = random.chance(0.65f) ? 2 : 1;
    const float eaves = storey * static_cast<float>(floors) + 0.25f;
    const Bays bays{random.uniform(2.1f, 2.9f),
                    random.uniform(1.f, 1.45f),
                    storey,
                    storey + 0.25f,
                    floors,
                    0.32f,
                    0.84f,
                    random.chance(0.5f),
                    false};
    const auto walls = walls_of_box(wide, deep);
    for (std::size_t k = 0; k < 4; ++k) add_facade(mesh, walls[k], k < 2 ? wide : deep, bays, wall, random);
    // Roof: two slopes as thin plates, overhanging.
    const float over = 0.5f, rise = random.uniform(0.62f, 0.95f), ridge = eaves + rise * 0.5f * deep,
                a = 0.5f * wide + 0.35f, b = 0.5f * deep + over, low = eaves - rise * over;
    for (const float hand : {-1.f, 1.f}) {
        const auto slope = [&](float off, std::uint16_t paint) {
            mesh.quad({-a, low + off, hand * b}, {a, low + off, hand * b}, {a, ridge + off, 0}, {-a, ridge + off, 0},
                      paint);
        };
        slope(0.2f, roof);
        slope(0, kTrim);
        mesh.quad({-a, low, hand * b}, {a, low, hand * b}, {a, low + 0.2f, hand * b}, {-a, low + 0.2f, hand * b},
                  kTrim);
        for (const float end : {-a, a})
            mesh.quad({end, low, hand * b}, {end, ridge, 0}, {end, ridge + 0.2f, 0}, {end, low + 0.2f, hand * b},
                      kTrim);
        const float gable = hand * 0.5f * wide;
        mesh.quad({gable, eaves, -0.5f * deep}, {gable, eaves, 0.5f * deep}, {gable, ridge, 0}, {gable, ridge, 0},
                  wall);
        // A gutter, and a downpipe at one corner.
        add_tube(mesh, {-a, low - 0.03f, hand * (b + 0.05f)}, {a, low - 0.03f, hand * (b + 0.05f)}, 0.06f, 0.06f, 5,
                 kIron);
        const float corner = hand * (0.5f * wide - 0.15f);
        add_tube(mesh, {corner, 0, hand * (0.5f * deep + 0.06f)}, {corner, low, hand * (0.5f * deep + 0.06f)}, 0.045f,
                 0.045f, 5, kIron);
    }
    const float stack = random.uniform(-0.3f, 0.3f) * wide;
    add_box(mesh, {stack - 0.35f, ridge - 1.2f, -0.3f}, {stack + 0.35f, ridge + 0.9f, 0.3f}, wall);
    add_box(mesh, {stack - 0.42f, ridge + 0.9f, -0.37f}, {stack + 0.42f, ridge + 1.f, 0.37f}, kTrim);
    return mesh;
}

QuadMesh build_block(World& world, float wide, float deep, int floors, std::uint32_t seed) {
    Random random(seed, "outdoors.block");
    QuadMesh mesh;
    const std::uint16_t wall = world.add({Finish::matt, kWalls[static_cast<std::size_t>(random.index(9))], {}, 0.25f}),
                        roof = world.add(
                            {Finish::matt, kRoofs[static_cast<std::size_t>(1 + random.index(2))], {}, 0.3f});
    const Bays bays{random.uniform(2.2f, 3.2f),  random.uniform(1.05f, 1.6f), random.uniform(3.f, 3.5f), 4.1f, floors,
                    random.uniform(0.16f, 0.3f), random.uniform(0.8f, 0.88f), random.chance(0.6f),       true};
    const auto walls = walls_of_box(wide, deep);
    for (std::size_t k = 0; k < 4; ++k) add_facade(mesh, walls[k], k < 2 ? wide : deep, bays, wall, random);
    const float top = bays.ground_m + bays.storey_m * static_cast<float>(floors - 1), a = 0.5f * wide, b = 0.5f * deep;
    for (std::size_t k = 0; k < 4; ++k)
        add_slab(mesh, walls[k], -0.3f, (k < 2 ? wide : deep) + 0.3f, top, top + 0.35f, -0.1f, 0.32f, kTrim);
    if (random.chance(0.55f)) {
        // A mansard with dormers.
        const float rise = 2.7f, in = 1.15f, up = top + 0.35f;
        const std::array<Vec3f, 4> foot{Vec3f{-a, up, -b}, {a, up, -b}, {a, up, b}, {-a, up, b}};
        const std::array<Vec3f, 4> head{Vec3f{-a + in, up + rise, -b + in},
                                        {a - in, up + rise, -b + in},
                                        {a - in, up + rise, b - in},
                                        {-a + in, up + rise, b - in}};
        for (std::size_t k = 0; k < 4; ++k) mesh.quad(foot[k], foot[(k + 1) % 4], head[(k + 1) % 4], head[k], roof);
        mesh.quad(head[0], head[1], head[2], head[3], roof);
        for (std::size_t k = 0; k < 2; ++k)
            for (float x = 1.8f; x < wide - 1.8f; x += 3.2f) {
                const Wall w{walls[k].at(0, up, -0.45f), walls[k].right, walls[k].out};
                add_slab(mesh, w, x - 0.6f, x + 0.6f, 0.3f, 1.9f, -1.f, 0, wall);
                add_slab(mesh, w, x - 0.75f, x + 0.75f, 1.9f, 2.02f, -1.f, 0.12f, roof);
                mesh.quad(w.at(x - 0.4f, 0.5f, 0.01f), w.at(x + 0.4f, 0.5f, 0.01f), w.at(x + 0.4f, 1.75f, 0.01f),
                          w.at(x - 0.4f, 1.75f, 0.01f), kGlass);
            }
    } else {
        add_box(mesh, {-a, top, -b}, {a, top + 0.9f, b}, wall);
        add_box(mesh, {-0.2f * a, top + 0.9f, -0.3f * b}, {0.3f * a, top + 3.f, 0.3f * b}, wall);
    }
    for (int k = 0; k < 3; ++k) {
        const float x = random.uniform(-0.8f, 0.8f) * a, z = random.uniform(-0.5f, 0.5f) * b;
        add_box(mesh, {x - 0.3f, top, z - 0.25f}, {x + 0.3f, top + random.uniform(3.2f, 4.6f), z + 0.25f}, wall);
    }
    return mesh;
}

QuadMesh build_tower(World& world, float wide, float deep, float high, std::uint32_t seed) {
    Random random(seed, "outdoors.tower");
    QuadMesh mesh;
    const std::uint16_t wall = world.add({Finish::facade, kWalls[static_cast<std::size_t>(random.index(9))] * 0.8f});
    add_box(mesh, {-0.5f * wide, 0, -0.5f * deep}, {0.5f * wide, high, 0.5f * deep}, wall);
    if (random.chance(0.5f))
        add_box(mesh, {-0.3f * wide, high, -0.3f * deep},
                {0.3f * wide, high * random.uniform(1.05f, 1.3f), 0.3f * deep}, wall);
    return mesh;
}

QuadMesh build_lamp() {
    QuadMesh mesh;
    add_tube(mesh, {}, {0, kLampHeight_m, 0}, 0.07f, 0.045f, 6, kIron);
    add_tube(mesh, {0, kLampHeight_m - 0.15f, 0}, {0, kLampHeight_m + 0.2f, 0}, 0.1f, 0.17f, 6, kLampGlass);
    add_tube(mesh, {0, kLampHeight_m + 0.2f, 0}, {0, kLampHeight_m + 0.36f, 0}, 0.22f, 0.03f, 6, kIron);
    return mesh;
}

}  // namespace fastscene::outdoors
