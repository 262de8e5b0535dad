// World map.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {
namespace {

// ---- the world

// The coasts, coarsely: degrees of longitude and latitude.
const std::vector<Stroke>& coasts() {
    static const std::vector<Stroke> all{
        // North America, Greenland, South America
        {{-168, 66}, {-156, 71}, {-128, 70}, {-110, 68}, {-95, 72},  {-84, 72},  {-87, 66},  {-94, 60},
         {-82, 55},  {-79, 52},  {-78, 61},  {-66, 59},  {-56, 52},  {-65, 48},  {-61, 45},  {-70, 42},
         {-76, 36},  {-81, 31},  {-80, 25},  {-84, 30},  {-97, 28},  {-97, 20},  {-90, 21},  {-88, 15},
         {-83, 11},  {-78, 8},   {-85, 10},  {-95, 16},  {-105, 20}, {-112, 30}, {-117, 33}, {-124, 40},
         {-124, 48}, {-135, 58}, {-150, 60}, {-164, 55}, {-158, 59}, {-166, 62}},
        {{-55, 82}, {-30, 83}, {-20, 75}, {-25, 70}, {-42, 60}, {-52, 66}, {-56, 75}, {-68, 78}},
        {{-78, 8},
         {-72, 12},
         {-60, 9},
         {-50, 1},
         {-35, -6},
         {-39, -17},
         {-48, -26},
         {-58, -36},
         {-65, -42},
         {-68, -52},
         {-72, -53},
         {-75, -45},
         {-71, -30},
         {-71, -18},
         {-81, -5},
         {-78, 2}},
        // Europe and Asia, Africa, Australia
        {{-9, 38},  {-9, 43},  {-2, 44},  {-4, 48},  {4, 52},   {8, 57},   {10, 54},  {20, 55},  {24, 59},  {30, 60},
         {22, 61},  {22, 65},  {17, 62},  {16, 57},  {12, 56},  {6, 58},   {6, 62},   {15, 69},  {28, 71},  {42, 67},
         {55, 69},  {68, 69},  {75, 73},  {105, 77}, {115, 73}, {140, 73}, {160, 70}, {179, 68}, {178, 63}, {163, 60},
         {161, 53}, {156, 58}, {142, 59}, {136, 54}, {140, 48}, {130, 42}, {128, 35}, {125, 40}, {120, 38}, {122, 31},
         {116, 23}, {108, 21}, {109, 12}, {105, 9},  {101, 13}, {104, 2},  {101, 6},  {98, 9},   {98, 16},  {92, 22},
         {87, 21},  {80, 14},  {77, 8},   {73, 17},  {70, 22},  {62, 25},  {57, 26},  {50, 30},  {48, 30},  {54, 24},
         {59, 22},  {55, 17},  {45, 13},  {39, 21},  {35, 28},  {36, 36},  {28, 37},  {27, 40},  {35, 42},  {41, 41},
         {38, 47},  {31, 46},  {28, 42},  {24, 38},  {21, 37},  {19, 42},  {13, 45},  {18, 40},  {16, 38},  {9, 44},
         {3, 43},   {0, 39},   {-5, 36}},
        {{-6, 35}, {10, 37},  {11, 33},  {20, 31},  {32, 31},  {37, 22},  {43, 12},  {51, 12},  {46, 3},
         {40, -5}, {40, -15}, {35, -20}, {33, -27}, {26, -34}, {18, -34}, {14, -23}, {12, -15}, {13, -5},
         {9, 1},   {9, 4},    {4, 6},    {-8, 4},   {-13, 8},  {-17, 14}, {-16, 22}, {-10, 31}},
        {{114, -22},
         {122, -18},
         {130, -12},
         {136, -12},
         {136, -16},
         {141, -17},
         {143, -11},
         {146, -19},
         {153, -26},
         {150, -37},
         {145, -39},
         {138, -35},
         {131, -32},
         {123, -34},
         {115, -34}},
        // Islands
        {{44, -16}, {50, -15}, {47, -25}, {44, -23}},
        {{-5, 50}, {1, 51}, {0, 53}, {-2, 57}, {-5, 58}, {-5, 54}},
        {{-10, 52}, {-6, 52}, {-6, 55}, {-9, 54}},
        {{131, 32}, {135, 34}, {141, 36}, {142, 44}, {139, 40}, {135, 36}},
        {{109, 1}, {117, 7}, {119, 1}, {115, -4}, {110, -2}},
        {{95, 6}, {104, -1}, {106, -6}, {101, -3}},
        {{131, -1}, {141, -3}, {150, -10}, {143, -9}, {138, -8}},
        {{173, -35}, {178, -38}, {170, -46}, {167, -46}, {173, -41}},
        {{-24, 65}, {-15, 66}, {-15, 64}, {-22, 63.5f}},
        {{105, -6}, {114, -7}, {114, -8.5f}, {106, -7.5f}},
        {{119, 1}, {125, 1.5f}, {121, -1}, {123, -5}, {120, -5}},
        {{120, 18}, {124, 13}, {126, 7}, {122, 8}, {121, 13}},
        {{-84, 22}, {-75, 20}, {-78, 22.5f}},
        {{-74, 19.5f}, {-69, 19}, {-71, 18}},
        {{-90, 73}, {-80, 76}, {-62, 66}, {-66, 62}, {-74, 65}},
        {{-118, 72}, {-104, 73}, {-102, 69}, {-116, 69}},
        {{-95, 80}, {-70, 83}, {-76, 78}, {-92, 77}}};
    return all;
}

// A simple polygon cut into triangles, ear by ear: indices into it.
std::vector<std::array<std::size_t, 3>> ears_of(const Stroke& polygon) {
    std::vector<std::size_t> left(polygon.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    const auto area = [&](Vec2f a, Vec2f b, Vec2f c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
    float whole = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        whole += area({0, 0}, polygon[i], polygon[(i + 1) % polygon.size()]);
    if (whole < 0) std::reverse(left.begin(), left.end());
    std::vector<std::array<std::size_t, 3>> out;
    while (left.size() > 2) {
        bool cut = false;
        for (std::size_t i = 0; i < left.size() && !cut; ++i) {
            const std::array<std::size_t, 3> t{left[(i + left.size() - 1) % left.size()], left[i],
                                               left[(i + 1) % left.size()]};
            const Vec2f a = polygon[t[0]], b = polygon[t[1]], c = polygon[t[2]];
            if (area(a, b, c) <= 0) continue;
            const bool empty = std::none_of(left.begin(), left.end(), [&](std::size_t j) {
                if (j == t[0] || j == t[1] || j == t[2]) return false;
                const Vec2f p = polygon[j];
                return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
            });
            if (!empty) continue;
            out.push_back(t);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
            cut = true;
        }
        if (!cut) break;
    }
    return out;
}

}  // namespace

// The lands of the world on a framed sheet; parchment in old-fashioned rooms.
void build_world_map(Kit& k) {
    const Vec3f s = k.wanted({1.35f, 0.78f, 0.025f});
    const bool old = k.style.old_maps;
    const int frame = k.material(old ? k.style.wood : k.style.metal),
              sea = k.material(plain("map sheet", old ? Vec3f{0.56f, 0.43f, 0.26f} : Vec3f{0.66f, 0.7f, 0.7f}, 0.85f)),
              line = k.material(
                  plain("graticule", old ? Vec3f{0.36f, 0.24f, 0.12f} : Vec3f{0.45f, 0.52f, 0.54f}, 0.85f));
    const int land = k.main(
        plain("land", old ? Vec3f{0.27f, 0.16f, 0.07f} : lerp(k.style.palette[0], {0.3f, 0.36f, 0.34f}, 0.3f), 0.85f));
    const float f = 0.022f, z = 0.0142f;
    k.board(sea, {0, f, 0.007f}, {s.x - 2 * f, s.y - 2 * f, 0.013f}, 0.001f);
    wall_frame(k, frame, s, f, 0.024f);
    const float w = s.x - 2 * f - 0.07f, h = s.y - 2 * f - 0.07f;
    const auto on_sheet = [&](Vec2f p) { return Vec2f{w * p.x / 356.f, 0.5f * s.y + h * (p.y - 14.f) / 144.f}; };
    {
        Chalk pen(k, line, z - 0.0004f, 0.0014f);
        for (int lon = -180; lon <= 180; lon += 30)
            pen.line(
                {on_sheet({0.98f * static_cast<float>(lon), -58}), on_sheet({0.98f * static_cast<float>(lon), 86})});
        for (int lat = -40; lat <= 80; lat += 20)
            pen.line({on_sheet({-176, static_cast<float>(lat)}), on_sheet({176, static_cast<float>(lat)})});
        pen.box(on_sheet({-177.5f, -58}), on_sheet({177.5f, 86}));
    }
    Mesh lands;
    for (const Stroke& coast : coasts()) {
        const auto first = static_cast<std::uint32_t>(lands.positions.size());
        for (const Vec2f p : coast) {
            const Vec2f q = on_sheet(p);
            lands.positions.push_back({q.x, q.y, z}), lands.normals.push_back({0, 0, 1});
        }
        for (const auto& t : ears_of(coast))
            for (const std::size_t i : t) lands.triangles.push_back(first + static_cast<std::uint32_t>(i));
    }
    shapes::lay_grain(lands);
    k.add(std::move(lands), land);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.2f;
}

}  // namespace fastscene::furniture
