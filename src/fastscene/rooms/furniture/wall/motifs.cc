// Motifs of pictures, cut from discs, bars and triangles as a paper cutter does.
#include "fastscene/rooms/furniture/wall/motifs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace fastscene::furniture {
namespace {

enum class Ink : std::uint8_t { ground, accent, second, light, dark };

// In the unit square, x to the right and y up from its middle. Later marks lie on earlier ones.
struct Mark {
    enum class Shape : std::uint8_t { ellipse, bar, triangle, half } shape;
    Ink ink;
    std::array<float, 6> v;
};
Mark disc(Ink ink, float x, float y, float r) { return {Mark::Shape::ellipse, ink, {x, y, r, r}}; }
Mark oval(Ink ink, float x, float y, float rx, float ry) { return {Mark::Shape::ellipse, ink, {x, y, rx, ry}}; }
Mark bar(Ink ink, float x0, float y0, float x1, float y1, float width) {
    return {Mark::Shape::bar, ink, {x0, y0, x1, y1, width}};
}
Mark corner(Ink ink, float x0, float y0, float x1, float y1, float x2, float y2) {
    return {Mark::Shape::triangle, ink, {x0, y0, x1, y1, x2, y2}};
}
Mark half(Ink ink, float x, float y, float r) {
    return {Mark::Shape::half, ink, {x, y, r}};
}  // the upper half of a disc

struct Motif {
    Vec3f ground;  // albedo of the paper
    std::vector<Mark> marks;
};

constexpr Vec3f kPaper{0.72f, 0.69f, 0.6f}, kParchment{0.55f, 0.4f, 0.21f}, kNight{0.03f, 0.04f, 0.09f},
    kSky{0.34f, 0.52f, 0.62f}, kBlack{0.03f, 0.03f, 0.033f};

std::vector<Mark> face(Ink fur, bool pointed, bool mane) {
    std::vector<Mark> m;
    if (mane) m.push_back(disc(Ink::second, 0, 0, 0.38f));
    for (const float s : {-1.f, 1.f}) {
        if (pointed) m.push_back(corner(fur, s * 0.28f, 0.08f, s * 0.06f, 0.22f, s * 0.25f, 0.4f));
        else m.push_back(disc(fur, s * 0.2f, 0.22f, 0.1f));
    }
    m.push_back(disc(fur, 0, 0, 0.28f));
    m.push_back(oval(Ink::light, 0, -0.09f, 0.15f, 0.11f));
    for (const float s : {-1.f, 1.f}) m.push_back(disc(Ink::dark, s * 0.11f, 0.07f, 0.03f));
    m.push_back(oval(Ink::dark, 0, -0.04f, 0.045f, 0.032f));
    m.push_back(bar(Ink::dark, 0, -0.06f, 0, -0.13f, 0.014f));
    return m;
}

const std::map<std::string_view, Motif>& motifs() {
    using enum Ink;
    static const std::map<std::string_view, Motif> all{
        {"skull",
         {kBlack,
          {bar(light, -0.36f, -0.4f, 0.36f, -0.08f, 0.06f), bar(light, -0.36f, -0.08f, 0.36f, -0.4f, 0.06f),
           disc(light, -0.37f, -0.07f, 0.05f), disc(light, 0.37f, -0.07f, 0.05f), disc(light, -0.37f, -0.41f, 0.05f),
           disc(light, 0.37f, -0.41f, 0.05f), disc(light, 0, 0.14f, 0.25f), bar(light, 0, 0.02f, 0, -0.18f, 0.26f),
           disc(dark, -0.1f, 0.1f, 0.065f), disc(dark, 0.1f, 0.1f, 0.065f),
           corner(dark, -0.03f, -0.03f, 0.03f, -0.03f, 0, 0.04f), bar(dark, -0.05f, -0.18f, -0.05f, -0.09f, 0.014f),
           bar(dark, 0.05f, -0.18f, 0.05f, -0.09f, 0.014f)}}},
        {"ship",
         {kSky,
          {disc(light, 0.3f, 0.3f, 0.1f), bar(dark, 0, -0.2f, 0, 0.42f, 0.022f),
           bar(dark, -0.24f, -0.2f, -0.24f, 0.28f, 0.018f), corner(light, 0.03f, -0.12f, 0.34f, -0.1f, 0.03f, 0.36f),
           bar(light, -0.12f, -0.1f, -0.12f, 0.3f, 0.17f), bar(light, -0.33f, -0.1f, -0.33f, 0.2f, 0.14f),
           corner(accent, 0.01f, 0.42f, 0.01f, 0.34f, 0.15f, 0.38f), bar(second, -0.3f, -0.2f, 0.28f, -0.2f, 0.14f),
           corner(second, -0.3f, -0.27f, -0.3f, -0.13f, -0.42f, -0.12f),
           corner(second, 0.28f, -0.27f, 0.28f, -0.13f, 0.44f, -0.1f), bar(dark, -0.5f, -0.38f, 0.5f, -0.38f, 0.24f),
           half(light, -0.3f, -0.27f, 0.06f), half(light, -0.02f, -0.27f, 0.06f), half(light, 0.28f, -0.27f, 0.06f)}}},
        {"map",
         {kParchment,
          {oval(second, -0.2f, 0.16f, 0.2f, 0.15f), oval(second, -0.06f, 0.02f, 0.18f, 0.13f),
           oval(second, 0.24f, -0.2f, 0.19f, 0.14f), oval(second, 0.3f, 0.28f, 0.09f, 0.07f),
           bar(dark, -0.24f, 0.2f, -0.17f, 0.14f, 0.02f), bar(dark, -0.12f, 0.09f, -0.05f, 0.04f, 0.02f),
           bar(dark, 0, 0, 0.06f, -0.06f, 0.02f), bar(dark, 0.1f, -0.1f, 0.16f, -0.15f, 0.02f),
           bar(accent, 0.2f, -0.15f, 0.32f, -0.27f, 0.035f), bar(accent, 0.32f, -0.15f, 0.2f, -0.27f, 0.035f),
           bar(dark, -0.36f, -0.2f, -0.36f, -0.4f, 0.014f), bar(dark, -0.46f, -0.3f, -0.26f, -0.3f, 0.014f),
           corner(accent, -0.39f, -0.3f, -0.33f, -0.3f, -0.36f, -0.18f)}}},
        {"anchor",
         {kPaper,
          {disc(accent, 0, 0.34f, 0.1f), disc(ground, 0, 0.34f, 0.055f), bar(accent, 0, 0.26f, 0, -0.38f, 0.075f),
           bar(accent, -0.2f, 0.16f, 0.2f, 0.16f, 0.06f), bar(accent, 0, -0.39f, -0.2f, -0.3f, 0.075f),
           bar(accent, 0, -0.39f, 0.2f, -0.3f, 0.075f), bar(accent, -0.19f, -0.31f, -0.3f, -0.14f, 0.07f),
           bar(accent, 0.19f, -0.31f, 0.3f, -0.14f, 0.07f),
           corner(accent, -0.4f, -0.16f, -0.22f, -0.13f, -0.34f, 0.02f),
           corner(accent, 0.4f, -0.16f, 0.22f, -0.13f, 0.34f, 0.02f)}}},
        {"rocket",
         {kNight,
          {disc(light, -0.36f, 0.34f, 0.02f), disc(light, 0.34f, 0.1f, 0.024f), disc(light, -0.3f, -0.2f, 0.018f),
           disc(light, 0.22f, 0.4f, 0.016f), disc(second, 0.3f, -0.3f, 0.12f),
           corner(accent, -0.12f, -0.22f, -0.24f, -0.34f, -0.1f, 0.02f),
           corner(accent, 0.12f, -0.22f, 0.24f, -0.34f, 0.1f, 0.02f), oval(light, 0, 0.03f, 0.14f, 0.34f),
           corner(accent, -0.09f, 0.26f, 0.09f, 0.26f, 0, 0.44f), disc(second, 0, 0.1f, 0.065f),
           disc(dark, 0, 0.1f, 0.042f), corner(accent, -0.07f, -0.3f, 0.07f, -0.3f, 0, -0.47f)}}},
        {"planet",
         {kNight,
          {disc(light, -0.38f, 0.36f, 0.02f), disc(light, 0.36f, 0.3f, 0.026f), disc(light, -0.28f, -0.38f, 0.02f),
           disc(light, 0.28f, -0.4f, 0.016f), oval(second, 0, 0, 0.46f, 0.11f), oval(ground, 0, 0, 0.37f, 0.07f),
           disc(accent, 0, 0.02f, 0.24f), bar(second, -0.37f, -0.06f, 0.37f, -0.06f, 0.034f)}}},
        {"moon",
         {kNight,
          {disc(light, -0.05f, 0, 0.32f), disc(ground, 0.1f, 0.08f, 0.28f), disc(accent, 0.3f, 0.28f, 0.03f),
           disc(accent, 0.32f, -0.12f, 0.024f), disc(accent, 0.14f, 0.1f, 0.028f),
           disc(accent, -0.36f, 0.36f, 0.024f)}}},
        {"star",
         {kPaper,
          {corner(accent, -0.34f, 0.12f, 0.34f, 0.12f, 0, -0.14f), corner(accent, 0, 0.4f, -0.15f, -0.1f, 0.14f, 0.13f),
           corner(accent, 0, 0.4f, 0.15f, -0.1f, -0.14f, 0.13f),
           corner(accent, -0.22f, -0.34f, 0.02f, 0.18f, 0.13f, -0.06f),
           corner(accent, 0.22f, -0.34f, -0.02f, 0.18f, -0.13f, -0.06f)}}},
        {"dinosaur",
         {kPaper,
          {oval(accent, 0, -0.08f, 0.24f, 0.14f), corner(accent, -0.15f, 0.02f, -0.18f, -0.16f, -0.47f, -0.1f),
           bar(accent, 0.14f, -0.06f, 0.26f, 0.22f, 0.12f), oval(accent, 0.31f, 0.26f, 0.12f, 0.075f),
           bar(accent, -0.12f, -0.14f, -0.12f, -0.34f, 0.085f), bar(accent, 0.1f, -0.14f, 0.1f, -0.34f, 0.085f),
           corner(second, -0.16f, 0.03f, -0.04f, 0.05f, -0.1f, 0.15f),
           corner(second, -0.04f, 0.05f, 0.08f, 0.04f, 0.03f, 0.16f), disc(dark, 0.32f, 0.29f, 0.016f),
           bar(second, -0.5f, -0.37f, 0.5f, -0.37f, 0.04f)}}},
        {"bear", {kPaper, face(second, false, false)}},
        {"fox", {kPaper, face(accent, true, false)}},
        {"lion", {kPaper, face(accent, false, true)}},
        {"elephant",
         {kPaper,
          {disc(second, -0.24f, 0.06f, 0.19f), disc(second, 0.24f, 0.06f, 0.19f), disc(accent, 0, 0.06f, 0.24f),
           bar(accent, 0, -0.08f, 0, -0.3f, 0.11f), bar(accent, 0, -0.32f, 0.11f, -0.36f, 0.09f),
           disc(dark, -0.1f, 0.1f, 0.026f), disc(dark, 0.1f, 0.1f, 0.026f)}}},
        {"rabbit",
         {kPaper,
          {oval(second, -0.1f, 0.28f, 0.06f, 0.18f), oval(second, 0.1f, 0.28f, 0.06f, 0.18f),
           disc(second, 0, -0.06f, 0.24f), disc(dark, -0.09f, 0, 0.026f), disc(dark, 0.09f, 0, 0.026f),
           oval(accent, 0, -0.09f, 0.034f, 0.024f)}}},
        {"unicorn",
         {kPaper,
          {corner(accent, 0.02f, 0.2f, 0.12f, 0.22f, 0.14f, 0.47f), bar(light, 0.06f, 0.16f, -0.1f, -0.4f, 0.28f),
           oval(light, 0.2f, 0.04f, 0.2f, 0.12f), disc(accent, -0.08f, 0.2f, 0.08f), disc(second, -0.16f, 0.06f, 0.09f),
           disc(accent, -0.2f, -0.1f, 0.09f), disc(second, -0.26f, -0.26f, 0.09f), disc(dark, 0.12f, 0.09f, 0.02f)}}},
        {"bird",
         {kSky,
          {oval(accent, 0, 0, 0.22f, 0.13f), disc(accent, 0.2f, 0.12f, 0.1f),
           corner(second, 0.28f, 0.15f, 0.28f, 0.08f, 0.4f, 0.11f),
           corner(accent, -0.18f, 0.05f, -0.18f, -0.06f, -0.42f, 0.04f),
           corner(second, -0.1f, 0.05f, 0.1f, 0.04f, -0.14f, 0.32f), disc(dark, 0.22f, 0.14f, 0.016f),
           bar(dark, -0.5f, -0.24f, 0.5f, -0.2f, 0.02f)}}},
        {"butterfly",
         {kPaper,
          {oval(accent, -0.2f, 0.14f, 0.19f, 0.16f), oval(accent, 0.2f, 0.14f, 0.19f, 0.16f),
           oval(second, -0.16f, -0.16f, 0.14f, 0.13f), oval(second, 0.16f, -0.16f, 0.14f, 0.13f),
           oval(dark, 0, 0, 0.026f, 0.22f), bar(dark, 0, 0.2f, -0.1f, 0.36f, 0.012f),
           bar(dark, 0, 0.2f, 0.1f, 0.36f, 0.012f), disc(light, -0.22f, 0.15f, 0.05f),
           disc(light, 0.22f, 0.15f, 0.05f)}}},
        {"fish",
         {kSky,
          {oval(accent, 0.04f, 0, 0.28f, 0.16f), corner(accent, -0.2f, 0, -0.42f, 0.17f, -0.42f, -0.17f),
           corner(second, -0.02f, 0.13f, 0.16f, 0.13f, 0.02f, 0.28f), bar(light, 0.1f, -0.12f, 0.1f, 0.12f, 0.04f),
           disc(light, 0.21f, 0.04f, 0.035f), disc(dark, 0.215f, 0.04f, 0.018f), disc(light, 0.4f, 0.2f, 0.03f),
           disc(light, 0.44f, 0.32f, 0.02f)}}},
        {"whale",
         {kSky,
          {half(accent, -0.04f, -0.14f, 0.32f), bar(accent, -0.3f, -0.16f, 0.26f, -0.16f, 0.07f),
           corner(accent, 0.2f, -0.14f, 0.28f, -0.02f, 0.44f, 0.14f),
           corner(accent, 0.3f, -0.02f, 0.24f, 0.18f, 0.38f, 0.02f), disc(light, -0.2f, -0.04f, 0.024f),
           bar(light, -0.04f, 0.2f, -0.1f, 0.36f, 0.02f), bar(light, -0.04f, 0.2f, 0.02f, 0.36f, 0.02f),
           bar(dark, -0.5f, -0.33f, 0.5f, -0.33f, 0.28f)}}},
        {"heart",
         {kPaper,
          {disc(accent, -0.14f, 0.1f, 0.18f), disc(accent, 0.14f, 0.1f, 0.18f),
           corner(accent, -0.29f, 0, 0.29f, 0, 0, -0.34f), bar(accent, -0.16f, 0.03f, 0.16f, 0.03f, 0.1f)}}},
        {"note",
         {kPaper,
          {oval(dark, -0.2f, -0.26f, 0.11f, 0.08f), oval(dark, 0.2f, -0.2f, 0.11f, 0.08f),
           bar(dark, -0.105f, -0.26f, -0.105f, 0.3f, 0.03f), bar(dark, 0.295f, -0.2f, 0.295f, 0.36f, 0.03f),
           bar(accent, -0.12f, 0.27f, 0.31f, 0.33f, 0.09f)}}},
        {"ball",
         {{0.14f, 0.3f, 0.1f},
          {disc(light, 0, 0, 0.34f), disc(dark, 0, 0, 0.1f), disc(dark, 0, 0.27f, 0.06f),
           disc(dark, 0.25f, 0.09f, 0.06f), disc(dark, -0.25f, 0.09f, 0.06f), disc(dark, 0.16f, -0.22f, 0.06f),
           disc(dark, -0.16f, -0.22f, 0.06f), bar(dark, 0, 0, 0, 0.27f, 0.012f), bar(dark, 0, 0, 0.25f, 0.09f, 0.012f),
           bar(dark, 0, 0, -0.25f, 0.09f, 0.012f), bar(dark, 0, 0, 0.16f, -0.22f, 0.012f),
           bar(dark, 0, 0, -0.16f, -0.22f, 0.012f)}}},
        {"car",
         {kPaper,
          {bar(accent, -0.4f, -0.08f, 0.4f, -0.08f, 0.17f), half(accent, -0.02f, 0, 0.24f),
           half(light, -0.02f, 0.01f, 0.18f), bar(accent, -0.02f, 0, -0.02f, 0.22f, 0.04f),
           disc(dark, -0.22f, -0.17f, 0.1f), disc(dark, 0.22f, -0.17f, 0.1f), disc(light, -0.22f, -0.17f, 0.045f),
           disc(light, 0.22f, -0.17f, 0.045f), bar(second, -0.5f, -0.29f, 0.5f, -0.29f, 0.04f)}}},
        {"train",
         {kPaper,
          {bar(accent, -0.36f, -0.06f, 0.2f, -0.06f, 0.22f), bar(accent, 0.24f, -0.17f, 0.24f, 0.24f, 0.24f),
           bar(light, 0.24f, 0.06f, 0.24f, 0.18f, 0.13f), bar(second, 0.08f, 0.26f, 0.4f, 0.26f, 0.05f),
           bar(second, -0.24f, 0.04f, -0.24f, 0.22f, 0.09f), disc(light, -0.2f, 0.34f, 0.07f),
           disc(light, -0.08f, 0.4f, 0.06f), disc(dark, -0.26f, -0.22f, 0.09f), disc(dark, -0.03f, -0.22f, 0.09f),
           disc(dark, 0.24f, -0.22f, 0.09f), bar(dark, -0.5f, -0.33f, 0.5f, -0.33f, 0.024f)}}},
        {"gamepad",
         {kNight,
          {disc(accent, -0.24f, -0.06f, 0.17f), disc(accent, 0.24f, -0.06f, 0.17f),
           bar(accent, -0.24f, 0.03f, 0.24f, 0.03f, 0.2f), bar(light, -0.3f, 0.02f, -0.14f, 0.02f, 0.05f),
           bar(light, -0.22f, -0.06f, -0.22f, 0.1f, 0.05f), disc(second, 0.17f, 0.02f, 0.032f),
           disc(light, 0.29f, 0.02f, 0.032f), disc(light, 0.23f, 0.08f, 0.032f), disc(second, 0.23f, -0.04f, 0.032f)}}},
        {"invader",
         {kBlack,
          {bar(accent, -0.24f, 0.06f, 0.24f, 0.06f, 0.2f), bar(accent, -0.32f, 0, 0.32f, 0, 0.1f),
           bar(accent, -0.14f, 0.16f, -0.2f, 0.28f, 0.06f), bar(accent, 0.14f, 0.16f, 0.2f, 0.28f, 0.06f),
           bar(accent, -0.34f, -0.02f, -0.34f, -0.16f, 0.06f), bar(accent, 0.34f, -0.02f, 0.34f, -0.16f, 0.06f),
           bar(accent, -0.18f, -0.04f, -0.18f, -0.22f, 0.07f), bar(accent, 0.18f, -0.04f, 0.18f, -0.22f, 0.07f),
           bar(dark, -0.12f, 0.04f, -0.12f, 0.12f, 0.07f), bar(dark, 0.12f, 0.04f, 0.12f, 0.12f, 0.07f)}}},
        {"crown",
         {kPaper,
          {bar(accent, -0.28f, -0.18f, 0.28f, -0.18f, 0.12f),
           corner(accent, -0.28f, -0.14f, -0.06f, -0.14f, -0.32f, 0.2f),
           corner(accent, -0.16f, -0.14f, 0.16f, -0.14f, 0, 0.3f),
           corner(accent, 0.28f, -0.14f, 0.06f, -0.14f, 0.32f, 0.2f), disc(second, -0.32f, 0.22f, 0.035f),
           disc(second, 0, 0.33f, 0.035f), disc(second, 0.32f, 0.22f, 0.035f), disc(light, 0, -0.18f, 0.035f),
           disc(light, -0.16f, -0.18f, 0.03f), disc(light, 0.16f, -0.18f, 0.03f)}}},
        {"robot",
         {kPaper,
          {bar(second, 0, -0.34f, 0, -0.02f, 0.36f), bar(accent, 0, 0.02f, 0, 0.28f, 0.3f),
           bar(dark, 0, 0.28f, 0, 0.38f, 0.02f), disc(accent, 0, 0.4f, 0.035f), disc(light, -0.07f, 0.17f, 0.04f),
           disc(light, 0.07f, 0.17f, 0.04f), bar(dark, -0.08f, 0.07f, 0.08f, 0.07f, 0.03f),
           bar(accent, -0.24f, -0.06f, -0.24f, -0.28f, 0.07f), bar(accent, 0.24f, -0.06f, 0.24f, -0.28f, 0.07f),
           disc(light, 0, -0.16f, 0.06f)}}},
        {"rainbow",
         {kSky,
          {half(accent, 0, -0.2f, 0.42f), half(second, 0, -0.2f, 0.34f), half(light, 0, -0.2f, 0.26f),
           half(accent, 0, -0.2f, 0.18f), half(ground, 0, -0.2f, 0.11f), disc(light, -0.34f, -0.2f, 0.09f),
           disc(light, -0.24f, -0.22f, 0.08f), disc(light, 0.34f, -0.2f, 0.09f), disc(light, 0.24f, -0.22f, 0.08f)}}},
        {"bolt",
         {kPaper,
          {disc(second, 0, 0, 0.38f), disc(light, 0, 0, 0.32f), corner(accent, 0.1f, 0.3f, -0.16f, -0.04f, 0.06f, 0),
           corner(accent, -0.1f, -0.3f, 0.16f, 0.04f, -0.06f, 0)}}},
        {"leaf",
         {kPaper,
          {bar(second, 0, -0.44f, 0, 0.3f, 0.02f), oval(accent, -0.14f, -0.12f, 0.13f, 0.05f),
           oval(accent, 0.14f, -0.04f, 0.13f, 0.05f), oval(accent, -0.13f, 0.06f, 0.12f, 0.05f),
           oval(accent, 0.12f, 0.14f, 0.11f, 0.045f), oval(accent, -0.09f, 0.22f, 0.09f, 0.04f),
           oval(accent, 0, 0.34f, 0.045f, 0.1f)}}},
        {"mask",  // of a comedy
         {kNight,
          {oval(light, 0, 0, 0.24f, 0.3f), oval(dark, -0.09f, 0.07f, 0.05f, 0.03f),
           oval(dark, 0.09f, 0.07f, 0.05f, 0.03f), half(accent, 0, -0.2f, 0.13f),
           oval(light, 0, -0.08f, 0.14f, 0.05f)}}},
        {"castle",
         {kSky,
          {bar(second, 0, -0.36f, 0, 0.02f, 0.4f), bar(second, -0.26f, -0.36f, -0.26f, 0.14f, 0.16f),
           bar(second, 0.26f, -0.36f, 0.26f, 0.14f, 0.16f), corner(accent, -0.37f, 0.13f, -0.15f, 0.13f, -0.26f, 0.38f),
           corner(accent, 0.37f, 0.13f, 0.15f, 0.13f, 0.26f, 0.38f), bar(dark, 0, -0.36f, 0, -0.18f, 0.13f),
           half(dark, 0, -0.18f, 0.065f), bar(dark, -0.26f, 0, -0.26f, 0.07f, 0.04f),
           bar(dark, 0.26f, 0, 0.26f, 0.07f, 0.04f), bar(second, -0.12f, 0.02f, -0.12f, 0.07f, 0.07f),
           bar(second, 0.12f, 0.02f, 0.12f, 0.07f, 0.07f)}}},
    };
    return all;
}

std::vector<Vec2f> outline(const Mark& m) {
    const auto& v = m.v;
    std::vector<Vec2f> out;
    switch (m.shape) {
        case Mark::Shape::ellipse:
            for (const Vec2f p : shapes::circle(1.f, 28)) out.push_back({v[0] + p.x * v[2], v[1] + p.y * v[3]});
            break;
        case Mark::Shape::bar: {
            const float dx = v[2] - v[0], dy = v[3] - v[1], l = std::max(1e-4f, std::hypot(dx, dy)),
                        nx = -dy / l * 0.5f * v[4], ny = dx / l * 0.5f * v[4];
            out = {{v[0] - nx, v[1] - ny}, {v[2] - nx, v[3] - ny}, {v[2] + nx, v[3] + ny}, {v[0] + nx, v[1] + ny}};
            break;
        }
        case Mark::Shape::triangle: out = {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}}; break;
        case Mark::Shape::half:
            for (int i = 0; i <= 20; ++i) {
                const float a = kPi * static_cast<float>(i) / 20.f;
                out.push_back({v[0] + v[2] * std::cos(a), v[1] + v[2] * std::sin(a)});
            }
            break;
    }
    return out;
}

}  // namespace

bool is_motif(std::string_view name) { return motifs().contains(name); }

void draw_motif(Kit& k, std::string_view name, Vec3f at, float width, float height) {
    const Motif& motif = motifs().at(name);
    const int ground = k.main(plain(std::string(name) + " print", motif.ground, 0.8f));
    constexpr float kSheet = 0.003f, kCut = 0.0006f;  // thickness of the sheet; how far each mark lies over those below
    k.board(ground, at - Vec3f{0, 0.5f * height, 0}, {width, height, kSheet}, 0.0005f);
    // Two inks that the style has and that the paper shows.
    const auto shows = [&](Vec3f c) { return std::abs(luminance(c) - luminance(motif.ground)) > 0.08f; };
    const auto first = static_cast<std::size_t>(k.rng.index(6));
    std::array<Vec3f, 2> inks{Vec3f{0.45f, 0.06f, 0.04f}, Vec3f{0.5f, 0.32f, 0.1f}};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 6 && found < 2; ++i)
        if (const Vec3f c = k.style.palette[(first + i) % 6]; shows(c)) inks[found++] = c;
    const std::array<int, 5> materials{ground, k.material(plain("ink", inks[0], 0.8f)),
                                       k.material(plain("second ink", inks[1], 0.8f)),
                                       k.material(plain("light ink", {0.7f, 0.67f, 0.58f}, 0.8f)),
                                       k.material(plain("dark ink", {0.035f, 0.033f, 0.03f}, 0.8f))};
    const float size = std::min(width, height);
    float z = 0.5f * kSheet;
    for (const Mark& mark : motif.marks) {
        std::vector<Vec2f> cut = outline(mark);
        // Prisms stand on the floor plan: (x, z) becomes the picture's (x, y).
        for (Vec2f& p : cut)
            p = {std::clamp(p.x * size, -0.5f * width, 0.5f * width),
                 std::clamp(-p.y * size, -0.5f * height, 0.5f * height)};
        z += kCut;
        Mesh m = shapes::prism(cut, -kCut, 0.f, 0.0001f);
        shapes::turn(m, {1, 0, 0}, 90);
        k.add(std::move(m), materials[static_cast<std::size_t>(mark.ink)], at + Vec3f{0, 0, z});
    }
}

}  // namespace fastscene::furniture
