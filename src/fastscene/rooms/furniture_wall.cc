// What hangs on walls besides pictures: a sign of neon, boards that are written on or pinned full, hangings of cloth
// and of knotted cord, antlers, a map of the world, a flag.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

using Stroke = std::vector<Vec2f>;  // a line on the wall, metres, y up

// Lines drawn flat on the plane z.
class Chalk {
  public:
    Chalk(Kit& k, int material, float z, float width) : k_(k), material_(material), z_(z), width_(width) {}
    void line(const Stroke& points) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec2f along = points[i + 1] - points[i];
            const float l = length(along);
            if (!(l > 1e-5f)) continue;
            const Vec2f d = along * (1.f / l), side = Vec2f{-d.y, d.x} * (0.5f * width_),
                        p = points[i] - d * (0.3f * width_), q = points[i + 1] + d * (0.3f * width_);
            quad({p - side, q - side, q + side, p + side});
        }
    }
    void fill(Vec2f low, Vec2f high) { quad({low, {high.x, low.y}, high, {low.x, high.y}}); }
    // Words that nobody can read: loops of one height, now and then a taller one.
    void words(float x0, float x1, float y, float high) {
        float x = x0;
        while (x < x1 - 2 * high) {
            const float end = std::min(x1, x + high * k_.dice.uniform(2.f, 6.f));
            Stroke word;
            for (bool up = false; x < end; x += high * k_.dice.uniform(0.2f, 0.34f), up = !up) {
                const float tall = up ? (k_.dice.chance(0.22f) ? 1.f : 0.6f) : (k_.dice.chance(0.1f) ? -0.35f : 0.f);
                word.push_back({x, y + high * (tall + k_.dice.uniform(-0.06f, 0.06f))});
            }
            if (word.size() > 1) line(shapes::curve(word, 3));
            x += high * 0.75f;
        }
    }
    void box(Vec2f low, Vec2f high) { line({low, {high.x, low.y}, high, {low.x, high.y}, low}); }
    void arrow(Vec2f from, Vec2f to, float head) {
        const Vec2f d = (to - from) * (1.f / std::max(length(to - from), 1e-4f)), side{-d.y, d.x};
        line({from, to});
        line({to - d * head + side * (0.6f * head), to, to - d * head - side * (0.6f * head)});
    }
    void circle(Vec2f middle, Vec2f radii) {
        Stroke s;
        for (int i = 0; i <= 24; ++i) {
            const float a = kTau * static_cast<float>(i) / 24.f + 0.6f;
            s.push_back(middle + Vec2f{radii.x * std::cos(a), radii.y * std::sin(a)});
        }
        line(s);
    }
    ~Chalk() {
        if (mesh_.triangles.empty()) return;
        shapes::lay_grain(mesh_);
        k_.add(std::move(mesh_), material_);
    }
    Chalk(const Chalk&) = delete;
    Chalk& operator=(const Chalk&) = delete;

  private:
    void quad(std::array<Vec2f, 4> corners) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (const Vec2f c : corners) mesh_.positions.push_back({c.x, c.y, z_}), mesh_.normals.push_back({0, 0, 1});
        mesh_.triangles.insert(mesh_.triangles.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    Kit& k_;
    int material_;
    float z_, width_;
    Mesh mesh_;
};

// A frame of four bars about s.x by s.y on the wall.
void wall_frame(Kit& k, int material, Vec3f s, float wide, float deep) {
    for (const float sg : {-1.f, 1.f}) {
        k.board(material, {sg * 0.5f * (s.x - wide), 0, 0.5f * deep}, {wide, s.y, deep}, 0.003f);
        k.board(material, {0, sg > 0 ? s.y - wide : 0.f, 0.5f * deep}, {s.x - 2 * wide, wide, deep}, 0.003f);
    }
}

// ---- neon

Stroke bow(Vec2f middle, Vec2f radii, float from_deg, float to_deg, int steps = 14) {
    Stroke s;
    for (int i = 0; i <= steps; ++i) {
        const float a = (from_deg + (to_deg - from_deg) * static_cast<float>(i) / static_cast<float>(steps)) * kPi /
                        180.f;
        s.push_back(middle + Vec2f{radii.x * std::cos(a), radii.y * std::sin(a)});
    }
    return s;
}
// A capital of the height 1, its lines as a bent tube makes them; its width.
std::pair<std::vector<Stroke>, float> tube_letter(char c) {
    switch (c) {
        case 'A': return {{{{0, 0}, {0.3f, 1}, {0.6f, 0}}, {{0.1f, 0.33f}, {0.5f, 0.33f}}}, 0.6f};
        case 'B':
            return {{{{0, 0}, {0, 1}, {0.3f, 1}, {0.46f, 0.9f}, {0.46f, 0.63f}, {0.3f, 0.53f}, {0, 0.53f}},
                     {{0.3f, 0.53f}, {0.52f, 0.42f}, {0.52f, 0.12f}, {0.3f, 0}, {0, 0}}},
                    0.54f};
        case 'D': return {{{{0, 0}, {0, 1}, {0.28f, 1}, {0.54f, 0.78f}, {0.54f, 0.22f}, {0.28f, 0}, {0, 0}}}, 0.54f};
        case 'E': return {{{{0.46f, 1}, {0, 1}, {0, 0}, {0.46f, 0}}, {{0, 0.52f}, {0.38f, 0.52f}}}, 0.46f};
        case 'H': return {{{{0, 0}, {0, 1}}, {{0.52f, 0}, {0.52f, 1}}, {{0, 0.5f}, {0.52f, 0.5f}}}, 0.52f};
        case 'L': return {{{{0, 1}, {0, 0}, {0.44f, 0}}}, 0.44f};
        case 'M': return {{{{0, 0}, {0.04f, 1}, {0.36f, 0.3f}, {0.68f, 1}, {0.72f, 0}}}, 0.72f};
        case 'N': return {{{{0, 0}, {0, 1}, {0.54f, 0}, {0.54f, 1}}}, 0.54f};
        case 'O': return {{bow({0.3f, 0.5f}, {0.3f, 0.5f}, 95, 445, 24)}, 0.6f};
        case 'P':
            return {{{{0, 0}, {0, 1}, {0.32f, 1}, {0.5f, 0.88f}, {0.5f, 0.58f}, {0.32f, 0.46f}, {0, 0.46f}}}, 0.5f};
        case 'R':
            return {{{{0, 0}, {0, 1}, {0.32f, 1}, {0.5f, 0.88f}, {0.5f, 0.6f}, {0.32f, 0.48f}, {0, 0.48f}},
                     {{0.26f, 0.48f}, {0.52f, 0}}},
                    0.52f};
        case 'V': return {{{{0, 1}, {0.29f, 0}, {0.58f, 1}}}, 0.58f};
        default: return {{}, 0.3f};
    }
}
std::vector<Stroke> neon_word(std::string_view word, float high) {
    std::vector<Stroke> out;
    float x = 0;
    for (const char c : word) {
        const auto [strokes, wide] = tube_letter(c);
        for (Stroke s : strokes) {
            for (Vec2f& p : s) p = Vec2f{p.x + x, p.y} * high;
            out.push_back(std::move(s));
        }
        x += wide + 0.24f;
    }
    return out;
}
// Figures about half a metre high.
std::vector<Stroke> neon_figure(std::string_view name) {
    if (name == "heart") {
        Stroke s;
        for (int i = 0; i <= 48; ++i) {
            const float a = kTau * (static_cast<float>(i) * 0.97f + 0.7f) / 48.f, sn = std::sin(a);
            s.push_back(Vec2f{16 * sn * sn * sn,
                              13 * std::cos(a) - 5 * std::cos(2 * a) - 2 * std::cos(3 * a) - std::cos(4 * a)} *
                        0.0165f);
        }
        return {s};
    }
    if (name == "bolt")
        return {{{0.06f, 0.3f},
                 {-0.13f, -0.03f},
                 {0.01f, -0.03f},
                 {-0.07f, -0.32f},
                 {0.16f, 0.06f},
                 {0.015f, 0.06f},
                 {0.1f, 0.3f},
                 {0.06f, 0.3f}}};
    if (name == "star") {
        Stroke s;
        for (int i = 0; i <= 10; ++i) {
            const float a = kTau * static_cast<float>(i) / 10.f, r = i % 2 == 0 ? 0.28f : 0.125f;
            s.push_back({r * std::sin(a), r * std::cos(a)});
        }
        return {s};
    }
    if (name == "moon") {
        Stroke s = bow({0, 0}, {0.27f, 0.27f}, 55, 305, 30);
        const Stroke in = bow({0.11f, 0}, {0.225f, 0.225f}, 281, 79, 24);
        s.insert(s.end(), in.begin(), in.end());
        s.push_back(s.front());
        return {s, {{0.2f, 0.1f}, {0.2f, -0.02f}}, {{0.14f, 0.04f}, {0.26f, 0.04f}}};
    }
    if (name == "cactus") {
        Stroke body = bow({0, 0.2f}, {0.075f, 0.09f}, 0, 180, 12),
               left = {{-0.075f, -0.06f}, {-0.16f, -0.06f}, {-0.2f, -0.02f}, {-0.2f, 0.1f}},
               right = {{0.075f, -0.12f}, {0.15f, -0.12f}, {0.19f, -0.08f}, {0.19f, 0.02f}};
        body.insert(body.begin(), {0.075f, -0.24f});
        body.push_back({-0.075f, -0.24f});
        return {body,
                left,
                right,
                {{-0.14f, -0.24f}, {-0.11f, -0.31f}, {0.11f, -0.31f}, {0.14f, -0.24f}, {-0.14f, -0.24f}}};
    }
    std::string word(name);
    for (char& c : word) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return neon_word(word, 0.26f);
}
// A tube cannot be folded: each corner becomes a short bend.
std::vector<Vec3f> bent(const Stroke& s, float z, float bend) {
    std::vector<Vec3f> path{{s.front().x, s.front().y, z}};
    for (std::size_t i = 1; i + 1 < s.size(); ++i) {
        const Vec2f in = s[i] - s[i - 1], out = s[i + 1] - s[i];
        const float a = length(in), b = length(out), r = std::min({bend, 0.45f * a, 0.45f * b});
        const Vec2f from = s[i] - in * (r / a), to = s[i] + out * (r / b);
        for (int j = 0; j <= 4; ++j) {
            const float t = static_cast<float>(j) / 4.f;
            const Vec2f p = from * ((1 - t) * (1 - t)) + s[i] * (2 * t * (1 - t)) + to * (t * t);
            if (length(Vec3f{p.x, p.y, z} - path.back()) > 1e-4f) path.push_back({p.x, p.y, z});
        }
    }
    if (length(Vec3f{s.back().x, s.back().y, z} - path.back()) > 1e-4f) path.push_back({s.back().x, s.back().y, z});
    return path;
}
// A glowing tube bent to a figure or a word, on clear standoffs, its wire going down. In the asked color, else one of
// those that signs have.
void neon_sign(Kit& k) {
    static constexpr std::array<const char*, 9> kFigures{"heart", "hello", "bolt", "love",  "moon",
                                                         "dream", "star",  "open", "cactus"};
    static constexpr std::array<Vec3f, 4> kGases{
        Vec3f{0.8f, 0.1f, 0.34f}, {0.1f, 0.52f, 0.8f}, {0.8f, 0.34f, 0.06f}, {0.42f, 0.12f, 0.8f}};
    const std::string_view asked = k.request.pattern;
    const char* figure = kFigures[static_cast<std::size_t>(k.dice.index(static_cast<int>(kFigures.size())))];
    const bool known = is_one_of(asked,
                                 {"heart", "hello", "bolt", "love", "moon", "dream", "star", "open", "cactus", "bar"});
    const int gas = k.main(plain("neon", kGases[static_cast<std::size_t>(k.dice.index(4))], 0.3f)),
              clip = k.material(plain("clear clip", {0.6f, 0.6f, 0.6f}, 0.2f)),
              wire = k.material(plain("white wire", {0.66f, 0.65f, 0.63f}, 0.5f));
    Material& m = k.piece.materials[static_cast<std::size_t>(gas)];
    // A gas is purer than paint.
    const float most = std::max(max_component(m.color_a), 0.05f);
    Vec3f hue;
    for (std::size_t a = 0; a < 3; ++a) hue[a] = std::pow(m.color_a[a] / most, 1.8f);
    const Vec3f dye = m.color_a;
    m = plain(m.name, dye, 0.3f);
    m.emission = (hue + Vec3f{0.02f, 0.02f, 0.02f}) *
                 (0.9f /
                  std::max(luminance(hue), 0.25f));  // brighter, the wall behind it would be as white as the tube
    m.pattern = Pattern::screen;                     // a sign is on by day too
    float low = 1e9f;
    const std::vector<Stroke> strokes = neon_figure(known ? asked : figure);
    for (const Stroke& s : strokes) {
        const std::vector<Vec3f> path = bent(s, 0.042f, 0.022f);
        k.add(shapes::tube(path, 0.008f, 8), gas);
        for (std::size_t i = path.size() / 6; i < path.size(); i += std::max<std::size_t>(8, path.size() / 3))
            k.rod(clip, {path[i].x, path[i].y, 0}, {path[i].x, path[i].y, 0.038f}, 0.004f, -1, 8);
        for (const Vec3f p : path) low = std::min(low, p.y);
    }
    // From its lowest point a wire goes to a small transformer.
    const Vec2f from = *std::min_element(strokes.back().begin(), strokes.back().end(),
                                         [](Vec2f a, Vec2f b) { return a.y < b.y; });
    const std::array<Vec3f, 4> lead{Vec3f{from.x, from.y, 0.03f},
                                    {from.x + 0.01f, from.y - 0.03f, 0.008f},
                                    {from.x + 0.015f, low - 0.07f, 0.005f},
                                    {from.x + 0.015f, low - 0.1f, 0.005f}};
    k.add(shapes::tube(lead, 0.003f, 6), wire);
    k.board(wire, {from.x + 0.015f, low - 0.128f, 0.009f}, {0.06f, 0.03f, 0.018f}, 0.004f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.42f;
}

// ---- boards

void whiteboard(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.95f, 0.05f});
    const int frame = k.material(steel());
    const int board = k.main(plain("enamel board", {0.78f, 0.79f, 0.79f}, 0.18f));
    k.board(board, {0, 0.01f, 0.009f}, {s.x - 0.01f, s.y - 0.02f, 0.012f}, 0.001f);
    wall_frame(k, frame, s, 0.022f, 0.02f);
    const auto ink = [&](Vec3f color) { return k.material(plain("marker", color, 0.5f)); };
    const int blue = ink({0.03f, 0.07f, 0.35f}), red = ink({0.5f, 0.03f, 0.03f}), black = ink({0.03f, 0.03f, 0.035f}),
              green = ink({0.02f, 0.22f, 0.06f});
    const float z = 0.0156f, w = 0.5f * s.x, h = s.y, u = std::min(s.x / 1.5f, s.y / 0.95f);
    {
        Chalk pen(k, black, z, 0.006f * u);
        pen.words(-0.9f * w, -0.25f * w, 0.85f * h, 0.06f * u);
        pen.line({{-0.9f * w, 0.82f * h}, {-0.3f * w, 0.815f * h}});
        for (int i = 0; i < 4; ++i) {
            const float y = h * (0.68f - 0.1f * static_cast<float>(i));
            pen.words(-0.82f * w, k.dice.uniform(-0.35f, -0.12f) * w, y, 0.034f * u);
            pen.box({-0.9f * w, y}, {-0.9f * w + 0.03f * u, y + 0.03f * u});
        }
    }
    {
        // A chart of boxes.
        Chalk pen(k, blue, z, 0.006f * u);
        const Vec2f size{0.2f * w, 0.09f * h}, a{0.12f * w, 0.8f * h}, b{0.62f * w, 0.8f * h}, c{0.62f * w, 0.58f * h};
        for (const Vec2f p : {a, b, c}) {
            pen.box(p - size * 0.5f, p + size * 0.5f);
            pen.words(p.x - 0.4f * size.x, p.x + 0.4f * size.x, p.y - 0.012f * u, 0.028f * u);
        }
        pen.arrow({a.x + 0.55f * size.x, a.y}, {b.x - 0.58f * size.x, b.y}, 0.035f * u);
        pen.arrow({b.x, b.y - 0.55f * size.y}, {c.x, c.y + 0.6f * size.y}, 0.035f * u);
    }
    {
        Chalk pen(k, red, z, 0.006f * u);
        pen.circle({0.62f * w, 0.58f * h}, {0.17f * w, 0.085f * h});
        pen.line({{-0.89f * w, 0.695f * h}, {-0.875f * w, 0.685f * h}, {-0.84f * w, 0.73f * h}});
        pen.words(0.28f * w, 0.8f * w, 0.12f * h, 0.045f * u);
    }
    {
        // A curve over its axes.
        Chalk pen(k, green, z, 0.006f * u);
        const Vec2f o{0.0f * w, 0.2f * h};
        pen.arrow(o, {o.x + 0.5f * w, o.y}, 0.03f * u);
        pen.arrow(o, {o.x, o.y + 0.32f * h}, 0.03f * u);
        Stroke curve;
        for (int i = 0; i <= 12; ++i) {
            const float t = static_cast<float>(i) / 12.f;
            curve.push_back({o.x + 0.44f * w * t, o.y + h * (0.03f + 0.24f * t * t + 0.02f * std::sin(9 * t))});
        }
        pen.line(curve);
    }
    // The tray with pens and the sponge.
    k.board(frame, {0, 0.f, 0.035f}, {0.5f * s.x, 0.008f, 0.06f}, 0.002f);
    for (const auto& [x, cap] : {std::pair{-0.12f, blue}, {-0.02f, red}, {0.06f, black}}) {
        k.rod(board, {x * s.x, 0.016f, 0.045f}, {x * s.x + 0.1f, 0.016f, 0.047f}, 0.008f, -1, 12);
        k.rod(cap, {x * s.x + 0.1f, 0.016f, 0.047f}, {x * s.x + 0.135f, 0.016f, 0.047f}, 0.0085f, -1, 12);
    }
    k.board(blue, {0.19f * s.x, 0.008f, 0.042f}, {0.11f, 0.026f, 0.045f}, 0.004f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.98f;
}

// Slate in a frame of wood: a list, a drawing, wiped places.
void chalkboard(Kit& k) {
    const bool kitchen = k.style.shelves == Shelves::kitchen;
    const Vec3f s = k.wanted(kitchen ? Vec3f{0.7f, 0.95f, 0.05f} : Vec3f{1.35f, 0.9f, 0.05f});
    Material slate = plain("slate board",
                           k.style.mouldings == Mouldings::rich || k.dice.chance(0.4f) ? Vec3f{0.035f, 0.06f, 0.045f}
                                                                                       : Vec3f{0.04f, 0.041f, 0.043f},
                           0.85f);
    slate.pattern = Pattern::plaster;
    slate.scale_m = 0.5f;
    slate.color_b = slate.color_a * 1.7f + Vec3f{0.012f, 0.012f, 0.012f};
    slate.color_c = slate.color_b;
    const int board = k.main(slate), wood = k.material(k.style.wood);
    k.board(board, {0, 0.01f, 0.008f}, {s.x - 0.02f, s.y - 0.02f, 0.012f}, 0.001f);
    wall_frame(k, wood, s, 0.04f, 0.024f);
    const auto stick = [&](Vec3f color) { return k.material(plain("chalk", color, 0.95f)); };
    const int white = stick({0.6f, 0.6f, 0.57f}), yellow = stick({0.6f, 0.46f, 0.15f}),
              pink = stick({0.55f, 0.24f, 0.28f});
    const float z = 0.0146f, w = 0.5f * s.x, h = s.y, u = kitchen ? s.x / 0.7f : s.y / 0.9f;
    {
        Chalk pen(k, white, z, 0.0065f * u);
        pen.words(kitchen ? -0.5f * w : -0.45f * w, 0.6f * w, 0.83f * h, 0.075f * u);
        pen.line({{-0.5f * w, 0.79f * h}, {0.5f * w, 0.785f * h}});
        for (int i = 0; i < 5; ++i) {
            const float y = h * (0.67f - 0.095f * static_cast<float>(i));
            pen.words(-0.8f * w, (kitchen ? 0.3f : -0.1f) * w, y, 0.038f * u);
            if (kitchen) pen.words(0.55f * w, 0.85f * w, y, 0.038f * u);
        }
        // A steaming cup, or a figure with its angles.
        if (kitchen) {
            const Vec2f o{0.35f * w, 0.1f * h};
            pen.line(bow(o + Vec2f{0, 0.07f * u}, {0.06f * u, 0.07f * u}, 180, 360));
            pen.line({o + Vec2f{-0.06f * u, 0.07f * u}, o + Vec2f{0.06f * u, 0.07f * u}});
            pen.line(bow(o + Vec2f{0.062f * u, 0.045f * u}, {0.022f * u, 0.02f * u}, -80, 80));
            for (const float x : {-0.025f, 0.02f})
                pen.line({o + Vec2f{x, 0.09f} * u, o + Vec2f{x + 0.012f, 0.11f} * u, o + Vec2f{x - 0.006f, 0.13f} * u,
                          o + Vec2f{x + 0.008f, 0.15f} * u});
        } else {
            pen.line({{0.15f * w, 0.24f * h}, {0.75f * w, 0.24f * h}, {0.6f * w, 0.64f * h}, {0.15f * w, 0.24f * h}});
            pen.circle({0.46f * w, 0.375f * h}, {0.135f * h, 0.135f * h});
        }
    }
    {
        Chalk pen(k, yellow, z, 0.0065f * u);
        pen.words(-0.8f * w, -0.1f * w, 0.12f * h, 0.045f * u);
        if (!kitchen) pen.line(bow({0.15f * w, 0.24f * h}, {0.09f * h, 0.09f * h}, 0, 45));
    }
    {
        Chalk pen(k, pink, z, 0.0065f * u);
        for (const float x : {-0.72f, 0.72f}) {  // flowers in the upper corners
            const Vec2f o{x * w, 0.87f * h};
            for (int i = 0; i < 5; ++i) {
                const float a = kTau * static_cast<float>(i) / 5.f;
                pen.circle(o + Vec2f{std::cos(a), std::sin(a)} * (0.024f * u), {0.016f * u, 0.016f * u});
            }
        }
    }
    k.board(wood, {0, -0.004f, 0.035f}, {0.8f * s.x, 0.012f, 0.05f}, 0.003f);
    for (const auto& [x, material] : {std::pair{-0.2f, white}, {0.05f, yellow}, {0.14f, pink}})
        k.rod(material, {x * s.x, 0.014f, 0.045f}, {x * s.x + 0.055f, 0.014f, 0.043f}, 0.0055f, -1, 10);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = kitchen ? 1.1f : 1.f;
}

// Cork with notes, cards and photographs on pins.
void pin_board(Kit& k) {
    const Vec3f s = k.wanted({1.05f, 0.72f, 0.03f});
    Material cork = plain("cork", {0.42f, 0.26f, 0.13f}, 0.95f);
    cork.pattern = Pattern::terrazzo;
    cork.scale_m = 0.008f;
    cork.color_b = {0.3f, 0.17f, 0.08f};
    cork.color_c = {0.5f, 0.34f, 0.19f};
    const int board = k.main(cork), wood = k.material(k.style.wood2),
              ink = k.material(plain("ink", {0.05f, 0.05f, 0.08f}, 0.7f));
    k.board(board, {0, 0.01f, 0.007f}, {s.x - 0.02f, s.y - 0.02f, 0.012f}, 0.001f);
    wall_frame(k, wood, s, 0.026f, 0.02f);
    static constexpr std::array<Vec3f, 5> kPapers{Vec3f{0.74f, 0.73f, 0.69f},
                                                  {0.7f, 0.62f, 0.2f},
                                                  {0.68f, 0.4f, 0.42f},
                                                  {0.4f, 0.58f, 0.66f},
                                                  {0.5f, 0.62f, 0.36f}};
    std::array<int, 5> papers{};
    for (std::size_t i = 0; i < 5; ++i) papers[i] = k.material(plain("note", kPapers[i], 0.9f));
    std::array<int, 3> pins{};
    for (std::size_t i = 0; i < 3; ++i)
        pins[i] = k.material(
            plain("pin", std::array{Vec3f{0.5f, 0.03f, 0.03f}, Vec3f{0.03f, 0.1f, 0.4f}, Vec3f{0.65f, 0.5f, 0.04f}}[i],
                  0.25f));
    const int columns = std::max(2, static_cast<int>(s.x / 0.165f)), rows = std::max(1, static_cast<int>(s.y / 0.19f));
    for (int i = 0; i < columns * rows; ++i) {
        if (k.dice.chance(0.12f)) continue;
        const float cx = s.x * ((static_cast<float>(i % columns) + 0.5f) / static_cast<float>(columns) - 0.5f) * 0.9f +
                         k.dice.uniform(-0.018f, 0.018f),
                    cy = 0.06f + (s.y - 0.12f) * (static_cast<float>(i / columns) + 0.5f) / static_cast<float>(rows) +
                         k.dice.uniform(-0.02f, 0.02f);
        const int kind = k.dice.index(4);
        const float pw = kind == 0   ? 0.125f
                         : kind == 1 ? 0.1f
                                     : k.dice.uniform(0.12f, 0.17f),
                    ph = kind == 0   ? 0.17f
                         : kind == 1 ? 0.1f
                                     : pw * 0.72f,
                    turn = k.dice.uniform(-7.f, 7.f);
        const float z = 0.0145f + 0.0007f * static_cast<float>(i % 3);
        const std::size_t first = k.piece.meshes.size();
        // Photographs have a white rim; the rest is written on.
        const int sheet = papers[kind == 3 || kind == 0 ? 0 : 1 + static_cast<std::size_t>(k.dice.index(4))];
        k.board(sheet, {0, -0.5f * ph, 0}, {pw, ph, 0.0008f}, 0.0002f);
        if (kind == 3) {
            Material photo = plain("photo", k.accent(), 0.35f);
            photo.pattern = Pattern::art;
            photo.color_b = k.accent();
            photo.color_c = k.accent();
            photo.scale_m = pw;
            photo.seed = k.seed();
            Mesh face = shapes::box({pw - 0.016f, ph - 0.016f, 0.0006f}, 0.0001f);
            face.coords = face.positions;
            for (Vec3f& c : face.coords) c = {c.x + 0.5f * pw, 0.5f * ph - c.y, c.z};
            k.add(std::move(face), k.material(photo), {0, 0, 0.0006f});
        } else {
            Chalk pen(k, ink, 0.0007f, 0.0022f);
            for (int j = 0; j < (kind == 0 ? 6 : 3); ++j)
                pen.words(-0.42f * pw, 0.42f * pw, ph * (0.28f - (kind == 0 ? 0.12f : 0.22f) * static_cast<float>(j)),
                          0.0085f);
        }
        for (std::size_t j = first; j < k.piece.meshes.size(); ++j)
            shapes::move(shapes::turn(k.piece.meshes[j], {0, 0, 1}, turn), {cx, cy, z});
        const int pin = pins[static_cast<std::size_t>(k.dice.index(3))];
        k.add(shapes::ball({cx, cy + 0.42f * ph, z + 0.006f}, {0.0065f, 0.0065f, 0.006f}, 10), pin);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.15f;
}

// ---- cloth

// A rod for a hanging, with balls at its ends and a cord over a nail.
void hanging_rod(Kit& k, int wood, float half, float y, float z, float r) {
    k.rod(wood, {-half, y, z}, {half, y, z}, r, -1, 14);
    for (const float sx : {-1.f, 1.f}) k.add(shapes::ball({sx * half, y, z}, {1.5f * r, 1.5f * r, 1.5f * r}, 12), wood);
    const int cord = k.material(plain("cord", {0.58f, 0.5f, 0.37f}, 0.9f));
    const std::array<Vec3f, 3> path{Vec3f{-0.86f * half, y, z}, {0, y + 0.3f * half, 0.01f}, {0.86f * half, y, z}};
    k.add(shapes::tube(std::array{path[0], lerp(path[0], path[1], 0.5f), path[1]}, 0.0028f, 6), cord);
    k.add(shapes::tube(std::array{path[1], lerp(path[1], path[2], 0.5f), path[2]}, 0.0028f, 6), cord);
    k.rod(k.material(k.style.metal), {0, y + 0.3f * half - 0.004f, 0}, {0, y + 0.3f * half - 0.004f, 0.02f}, 0.004f, -1,
          8);
}

// A woven cloth: medallions with a border where rooms are formal, else a sun over hills.
void tapestry(Kit& k) {
    const Vec3f s = k.wanted({1.15f, 1.45f, 0.04f});
    const bool woven = is_one_of(k.style.name, {"classic", "art deco", "rustic", "mediterranean", "industrial"}) ||
                       is_one_of(k.request.pattern, {"damask", "floral"});
    const float half = 0.5f * s.x, hem = 0.1f, top = s.y - 0.3f * (half + 0.05f) - 0.01f, fringe = 0.1f;
    const int wood = k.material(k.style.wood);
    hanging_rod(k, wood, half + 0.04f, top, 0.022f, 0.011f);
    const float phase = k.dice.uniform(0, kTau);
    const auto cloth_at = [&](float x, float y, float out) {
        return Vec3f{x, y,
                     0.016f + out + 0.0045f * std::sin(9.f * x / s.x * 2.2f + phase) * std::min(1.f, (top - y) / 0.4f)};
    };
    const auto field = [&](const std::function<Vec2f(float, float)>& at, int columns, int rows, float out,
                           int material) {
        k.add(shapes::sheet(columns, rows,
                            [&](float u, float v) {
                                const Vec2f p = at(u, v);
                                return cloth_at(p.x, p.y, out);
                            }),
              material);
    };
    Material ground = k.style.rug;
    if (woven) {
        ground.pattern = Pattern::rug;
        ground.seed = std::array<std::uint32_t, 4>{4, 6, 7, 11}[static_cast<std::size_t>(k.dice.index(4))];
        ground.scale_m = half;
    } else {
        ground = k.style.fabric;
        ground.name = "tapestry";
        ground.color_a = lerp(k.style.palette[4 % k.style.palette.size()], {0.68f, 0.6f, 0.46f}, 0.75f);
        ground.color_b = ground.color_a * 0.9f;
    }
    ground.bump_m = 0.001f;
    const int main = k.main(ground);
    Mesh base = shapes::slab(
        40, 12, 0.003f, [&](float u, float v) { return cloth_at(s.x * (u - 0.5f), fringe + (top - fringe) * v, 0.f); });
    if (woven)
        for (std::size_t i = 0; i < base.coords.size(); ++i)
            base.coords[i] = {base.positions[i].x, 0.5f * (top - fringe), base.positions[i].y - 0.5f * (top + fringe)};
    k.add(std::move(base), main);
    if (!woven) {
        const auto yarn = [&](Vec3f color) {
            Material m = plain("yarn", color, 0.95f);
            m.pattern = Pattern::fabric;
            m.scale_m = 0.006f;
            m.color_b = m.color_a * 0.85f;
            m.specular = 0.02f;
            return k.material(m);
        };
        const float r = 0.2f * s.x;
        const Vec2f sun{0.04f * s.x, fringe + 0.66f * (top - fringe)};
        const int gold = yarn(lerp(k.style.palette[1], {0.6f, 0.36f, 0.08f}, 0.4f)),
                  rust = yarn(lerp(k.style.palette[0], {0.42f, 0.15f, 0.06f}, 0.4f));
        field(
            [&](float u, float v) {
                return sun + Vec2f{std::cos(kTau * u), std::sin(kTau * u)} * (r * (0.02f + 0.98f * (1.f - v)));
            },
            40, 3, 0.0016f, gold);
        for (int i = 0; i < 20; ++i) {  // rays
            const float a = kTau * static_cast<float>(i) / 20.f, from = 1.14f * r, to = (i % 2 ? 1.42f : 1.6f) * r;
            const Vec2f d{std::cos(a), std::sin(a)}, side{-d.y, d.x};
            field(
                [&](float u, float v) {
                    return sun + d * (from + (to - from) * u) + side * ((v - 0.5f) * 0.02f * s.x * (1.2f - u));
                },
                3, 1, 0.0016f, rust);
        }
        // Hills, the nearer the darker.
        for (int i = 0; i < 4; ++i) {
            const float high = fringe + (top - fringe) * (0.46f - 0.115f * static_cast<float>(i)),
                        p = k.dice.uniform(0, kTau), swing = 0.05f * s.y;
            const int hill = i == 0
                                 ? rust
                                 : yarn(lerp(k.style.palette[static_cast<std::size_t>(i + 1) % k.style.palette.size()],
                                             {0.2f, 0.12f, 0.07f}, 0.14f * static_cast<float>(i)));
            field(
                [&](float u, float v) {
                    const float x = (u - 0.5f) * (s.x - 0.012f);
                    return Vec2f{x, std::lerp(fringe + 0.004f,
                                              high + swing * std::sin(5.f * x / s.x + p) +
                                                  0.4f * swing * std::sin(11.f * x / s.x + 2 * p),
                                              v)};
                },
                40, 6, 0.0026f + 0.001f * static_cast<float>(i), hill);
        }
    }
    // Fringe: bundles of threads.
    Mesh threads;
    const int count = static_cast<int>(s.x / 0.021f);
    for (int i = 0; i < count; ++i) {
        const Vec3f from = cloth_at(s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f),
                                    fringe + 0.004f, 0.f);
        shapes::append(threads,
                       shapes::rod(from,
                                   from + Vec3f{k.dice.uniform(-0.004f, 0.004f), -(hem - k.dice.uniform(0.f, 0.012f)),
                                                k.dice.uniform(-0.002f, 0.003f)},
                                   0.0032f, 0.0046f, 6));
    }
    k.add(std::move(threads),
          k.material(plain("fringe",
                           lerp(k.piece.materials[static_cast<std::size_t>(main)].color_a, {0.66f, 0.6f, 0.48f}, 0.6f),
                           0.95f)));
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.85f;
}

// Knotted cords on a branch: a net of lozenges that ends in a point, long ends below.
void macrame(Kit& k) {
    const Vec3f s = k.wanted({0.8f, 1.15f, 0.05f});
    Material cotton = plain("cotton cord", {0.7f, 0.65f, 0.54f}, 0.95f);
    cotton.specular = 0.02f;
    const int cord = k.main(cotton), wood = k.material(*material_named("walnut"));
    const float half = 0.5f * s.x, top = s.y - 0.3f * half - 0.02f;
    // A branch is not quite straight.
    std::vector<Vec3f> branch;
    for (int i = 0; i <= 12; ++i) {
        const float t = static_cast<float>(i) / 6.f - 1.f;
        branch.push_back({t * half, top + 0.006f * std::sin(5 * t + 1.f), 0.026f + 0.003f * std::sin(7 * t)});
    }
    k.add(shapes::tube(branch, 0.012f, 10), wood);
    for (const float sx : {-1.f, 1.f})
        k.add(shapes::tube(
                  std::array{Vec3f{sx * 0.8f * half, top, 0.03f}, Vec3f{sx * 0.4f * half, top + 0.15f * half, 0.02f},
                             Vec3f{0, top + 0.3f * half, 0.012f}},
                  0.004f, 6),
              cord);
    k.rod(k.material(k.style.metal), {0, top + 0.29f * half, 0}, {0, top + 0.29f * half, 0.025f}, 0.004f, -1, 8);
    constexpr int kPairs = 14;
    const float step = 2 * 0.9f * half / (kPairs - 1), row = 0.95f * step;
    const auto x_of = [&](float i) { return (i - 0.5f * (kPairs - 1)) * step; };
    Mesh all;
    const auto tie = [&](float x, float y, float size) {
        shapes::append(all, shapes::ball({x, y, 0.03f}, {size, 0.8f * size, 0.75f * size}, 10));
    };
    // Rows of knots: each lower row has one less, until a point is left; cords run between them.
    const auto knot_y = [&](int j) { return top - 0.055f - row * static_cast<float>(j); };
    for (int i = 0; i < kPairs; ++i) {
        shapes::append(all, shapes::ball({x_of(static_cast<float>(i)), top, 0.026f}, {0.011f, 0.0165f, 0.0165f},
                                         10));  // the lark's head about the branch
        for (const float d : {-0.005f, 0.005f})
            shapes::append(
                all, shapes::rod({x_of(static_cast<float>(i)) + d, top - 0.01f, 0.038f},
                                 {x_of(static_cast<float>(i)) + 0.4f * d, knot_y(0), 0.03f}, 0.0042f, 0.0042f, 6));
    }
    constexpr int kRows = 9;
    for (int j = 0; j < kRows; ++j) {
        const int count = kPairs - j;
        for (int i = 0; i < count; ++i) {
            const float x = x_of(static_cast<float>(i) + 0.5f * static_cast<float>(j));
            tie(x, knot_y(j), 0.0145f);
            if (j + 1 == kRows) continue;
            for (const float way : {-0.5f, 0.5f}) {
                const float to = static_cast<float>(i) + 0.5f * static_cast<float>(j) + way;
                if (to < 0.5f * static_cast<float>(j + 1) - 0.01f ||
                    to > static_cast<float>(kPairs - 1) - 0.5f * static_cast<float>(j + 1) + 0.01f)
                    continue;
                shapes::append(
                    all, shapes::rod({x, knot_y(j), 0.03f}, {x_of(to), knot_y(j + 1), 0.03f}, 0.0065f, 0.0065f, 6));
            }
        }
    }
    // Long ends: from the slanting edge down, shortest at the sides.
    for (int i = 0; i < 3 * kPairs; ++i) {
        const float at = (static_cast<float>(i) + 0.5f) / 3.f - 0.5f,
                    side = std::min(at + 0.5f, static_cast<float>(kPairs) - 0.5f - at), x = x_of(at);
        const float from = knot_y(
                        static_cast<int>(std::min(static_cast<float>(kRows - 1), std::max(0.f, 2.f * side - 1.f)))),
                    to = (0.34f * s.y) * std::abs(x) / half + k.dice.uniform(0.f, 0.018f);
        if (to > from - 0.06f) continue;
        const float sway = k.dice.uniform(-0.006f, 0.006f);
        shapes::append(all, shapes::tube(std::array{Vec3f{x, from, 0.026f}, Vec3f{x + sway, 0.5f * (from + to), 0.022f},
                                                    Vec3f{x + 0.4f * sway, to + 0.03f, 0.02f}, Vec3f{x, to, 0.02f}},
                                         0.0058f, 6));
    }
    k.add(std::move(all), cord);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.95f;
}

// A flag on a staff along its upper edge, in bands; in one color when one was asked for.
void flag(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.8f, 0.04f});
    Material cloth = plain("flag cloth", k.style.palette[0], 0.8f);
    cloth.pattern = Pattern::fabric;
    cloth.scale_m = 0.003f;
    cloth.color_b = cloth.color_a * 0.9f;
    cloth.specular = 0.02f;
    const int main = k.main(cloth), metal = k.material(k.style.metal);
    const bool one_color = !k.request.color_name.empty() || k.request.color;
    const auto dyed = [&](Vec3f color) {
        Material m = cloth;
        m.color_a = color, m.color_b = color * 0.9f;
        m.color_c = color;
        return k.material(m);
    };
    const int middle = one_color ? main : dyed({0.72f, 0.71f, 0.67f}),
              last = one_color ? main : dyed(k.style.palette[2 % k.style.palette.size()]);
    const float p = k.dice.uniform(0, kTau), staff = s.y - 0.012f;
    const auto wave = [&](float x, float y) {
        return 0.03f + (0.016f * std::sin(15.f * x / s.x + p + 1.1f * y) +
                        0.007f * std::sin(31.f * x / s.x + 2 * p - 2.f * y)) *
                           std::min(1.f, 0.15f + (staff - y) / 0.3f);
    };
    for (int band = 0; band < 3; ++band) {
        const float x0 = s.x * (static_cast<float>(band) / 3.f - 0.5f);
        k.add(shapes::slab(24, 12, 0.002f,
                           [&](float u, float v) {
                               const float x = x0 + s.x * u / 3.f, y = staff * v;
                               return Vec3f{x, y, wave(x, y)};
                           }),
              band == 0   ? main
              : band == 1 ? middle
                          : last);
    }
    k.rod(metal, {-0.5f * s.x - 0.03f, staff, 0.03f}, {0.5f * s.x + 0.03f, staff, 0.03f}, 0.009f, -1, 12);
    for (const float x : {-0.4f * s.x, 0.4f * s.x}) k.rod(metal, {x, staff, 0}, {x, staff, 0.03f}, 0.006f, -1, 8);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.2f;
}

// ---- antlers

// Turns triangles and normals about, if they look inward.
Mesh outward(Mesh m) {
    if (shapes::signed_volume(m) >= 0) return m;
    for (std::size_t t = 0; t < m.triangles.size(); t += 3) std::swap(m.triangles[t + 1], m.triangles[t + 2]);
    for (Vec3f& n : m.normals) n = -n;
    return m;
}
// A body about a line in the plane x = 0: at each point half its width and half its height.
Mesh limb(const std::vector<Vec3f>& line, const std::vector<Vec2f>& half, int sides) {
    const auto last = static_cast<float>(line.size() - 1);
    const auto smooth = [&](const auto& points, float t) {
        const auto i = std::min(static_cast<std::size_t>(t), points.size() - 2);
        const float f = t - static_cast<float>(i);
        const auto a = points[i > 0 ? i - 1 : 0], b = points[i], c = points[i + 1],
                   d = points[std::min(i + 2, points.size() - 1)];
        return (b * 2.f + (c - a) * f + (a * 2.f - b * 5.f + c * 4.f - d) * (f * f) +
                (b * 3.f - a - c * 3.f + d) * (f * f * f)) *
               0.5f;
    };
    return outward(shapes::sheet(sides, 4 * static_cast<int>(last), [&](float u, float v) {
        const float t = v * last;
        const Vec3f at = smooth(line, t),
                    along = normalize(smooth(line, std::min(last, t + 0.05f)) - smooth(line, std::max(0.f, t - 0.05f)));
        const Vec3f side{1, 0, 0}, up = normalize(cross(along, side));
        const Vec2f r = smooth(half, t);
        const float a = kTau * u;
        return at + side * (std::max(r.x, 0.001f) * std::cos(a)) + up * (std::max(r.y, 0.001f) * std::sin(a));
    }));
}
// A pair of antlers that rise from the roots at +-root.x.
void antler_pair(Kit& k, int horn, Vec3f root, float size) {
    for (const float sx : {-1.f, 1.f}) {
        const auto beam = [&](float t) {  // out, back and up, then in again
            return Vec3f{sx * (root.x + size * (0.5f * t + 0.12f * std::sin(kPi * t) - 0.12f * t * t * t)),
                         root.y + size * (0.95f * t - 0.1f * std::sin(kPi * t)),
                         root.z + size * (0.1f * std::sin(kPi * t) + 0.12f * t * t)};
        };
        constexpr int kSteps = 9;
        for (int i = 0; i < kSteps; ++i) {
            const float a = static_cast<float>(i) / kSteps, b = static_cast<float>(i + 1) / kSteps,
                        thick = 0.021f * size / 0.55f;
            k.rod(horn, beam(a), beam(b + 0.01f), thick * (1.f - 0.8f * a), thick * (1.f - 0.8f * b), 10);
        }
        for (const auto& [t, long_, lean] :
             {std::tuple{0.08f, 0.26f, 0.9f}, {0.34f, 0.3f, 0.5f}, {0.58f, 0.27f, 0.28f}, {0.78f, 0.2f, 0.12f}}) {
            const Vec3f from = beam(t), bend = from + Vec3f{-sx * 0.02f, 0.3f * long_, lean * long_} * size,
                        tip = bend + Vec3f{-sx * 0.03f, 0.62f * long_, 0.12f * long_} * size;
            const float thick = 0.0125f * size / 0.55f;
            k.rod(horn, from, bend, thick, 0.72f * thick, 8);
            k.rod(horn, bend, tip, 0.72f * thick, 0.12f * thick, 8);
        }
        k.add(shapes::ball(beam(0.01f), Vec3f{0.03f, 0.018f, 0.03f} * (size / 0.55f), 12), horn);
    }
}
// A shield of wood.
void shield_of_wood(Kit& k, int wood, float half, float low, float high, float thick) {
    std::vector<Vec2f> o;
    for (int i = 0; i < 40; ++i) {
        const float a = kTau * static_cast<float>(i) / 40.f, y = std::sin(a);
        const float x = half * std::cos(a) * (y > 0 ? 1.f : 1.f - 0.35f * y * y);
        o.push_back({x, -(0.5f * (low + high) + 0.5f * (high - low) * y)});
    }
    Mesh m = shapes::prism(o, 0.f, thick, 0.006f);
    shapes::turn(m, {1, 0, 0}, 90);
    k.add(std::move(m), wood);
}
void antlers(Kit& k) {
    const int horn = k.main(plain("antler", {0.36f, 0.25f, 0.15f}, 0.6f)), wood = k.material(k.style.wood),
              bone = k.material(plain("bone", {0.66f, 0.6f, 0.48f}, 0.7f));
    shield_of_wood(k, wood, 0.11f, 0.f, 0.27f, 0.022f);
    k.add(shapes::ball({0, 0.17f, 0.035f}, {0.058f, 0.05f, 0.03f}, 20), bone);
    antler_pair(k, horn, {0.032f, 0.205f, 0.045f}, 0.5f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.5f;
}
void deer_head(Kit& k) {
    const int coat = k.main(plain("deer hide", {0.27f, 0.16f, 0.085f}, 0.95f)), wood = k.material(k.style.wood),
              horn = k.material(plain("antler", {0.4f, 0.3f, 0.19f}, 0.6f)),
              dark = k.material(plain("muzzle", {0.035f, 0.03f, 0.028f}, 0.35f)),
              pale = k.material(plain("pale hide", {0.5f, 0.4f, 0.29f}, 0.95f));
    shield_of_wood(k, wood, 0.15f, 0.f, 0.42f, 0.024f);
    // The neck out of the shield and up; the head forward from it.
    k.add(limb({{0, 0.17f, 0.012f}, {0, 0.18f, 0.07f}, {0, 0.26f, 0.16f}, {0, 0.36f, 0.21f}, {0, 0.4f, 0.22f}},
               {{0.12f, 0.15f}, {0.115f, 0.145f}, {0.085f, 0.1f}, {0.062f, 0.075f}, {0.05f, 0.05f}}, 24),
          coat);
    k.add(limb({{0, 0.425f, 0.14f},
                {0, 0.42f, 0.17f},
                {0, 0.405f, 0.235f},
                {0, 0.375f, 0.31f},
                {0, 0.345f, 0.375f},
                {0, 0.335f, 0.4f}},
               {{0.012f, 0.012f}, {0.06f, 0.05f}, {0.072f, 0.07f}, {0.05f, 0.053f}, {0.038f, 0.037f}, {0.008f, 0.008f}},
               24),
          coat);
    k.add(shapes::ball({0, 0.345f, 0.392f}, {0.026f, 0.019f, 0.018f}, 14), dark);
    k.add(shapes::ball({0, 0.318f, 0.37f}, {0.027f, 0.016f, 0.03f}, 14), pale);
    for (const float sx : {-1.f, 1.f}) {
        k.add(shapes::ball({sx * 0.061f, 0.417f, 0.262f}, {0.011f, 0.013f, 0.015f}, 12), dark);
        // Ears: out and up a little, hollow to the front.
        Mesh ear = shapes::ball({0, 0, 0}, {0.032f, 0.078f, 0.013f}, 16),
             hollow = shapes::ball({0, 0.002f, 0.006f}, {0.021f, 0.062f, 0.011f}, 14);
        for (Mesh* m : {&ear, &hollow})
            shapes::turn(*m, {0, 0, 1}, -sx * 62.f), shapes::move(*m, {sx * 0.118f, 0.455f, 0.175f});
        k.add(std::move(ear), coat);
        k.add(std::move(hollow), pale);
    }
    antler_pair(k, horn, {0.03f, 0.46f, 0.19f}, 0.52f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.3f;
}

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
// The lands of the world on a framed sheet; parchment in old-fashioned rooms.
void world_map(Kit& k) {
    const Vec3f s = k.wanted({1.35f, 0.78f, 0.025f});
    const bool old = k.style.mouldings == Mouldings::rich ||
                     is_one_of(k.style.name, {"rustic", "industrial", "mid-century"});
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

// Twenty fields in two colors, rings and bull, three darts in it.
void dartboard(Kit& k) {
    const float r = 0.17f, rim = 0.2255f;
    const int board = k.main(plain("dartboard", {0.035f, 0.034f, 0.033f}, 0.85f)),
              cream = k.material(plain("sisal", {0.6f, 0.5f, 0.32f}, 0.9f)),
              black = k.material(plain("black sisal", {0.04f, 0.038f, 0.036f}, 0.9f)),
              red = k.material(plain("red sisal", {0.45f, 0.03f, 0.03f}, 0.9f)),
              green = k.material(plain("green sisal", {0.02f, 0.2f, 0.07f}, 0.9f)), wire = k.material(steel());
    Mesh disc = shapes::prism(shapes::circle(rim, 60), 0.f, 0.038f, 0.005f);
    shapes::turn(disc, {1, 0, 0}, 90);
    k.add(std::move(disc), board);
    const float z = 0.0385f;
    const std::array<float, 7> rings{0.f, 0.0065f, 0.016f, 0.099f, 0.107f, 0.162f, r};
    for (int i = 0; i < 20; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
            const bool odd = i % 2 != 0, scoring = j == 3 || j == 5;
            const int material = j == 0 ? red : j == 1 ? green : scoring ? (odd ? green : red) : (odd ? cream : black);
            k.add(shapes::sheet(3, 1,
                                [&](float u, float v) {
                                    const float a = kTau * (static_cast<float>(i) - 0.5f + u) / 20.f,
                                                d = std::max(0.0005f, std::lerp(rings[j + 1], rings[j], v));
                                    return Vec3f{-d * std::sin(a), d * std::cos(a), z};
                                }),
                  material);
        }
    for (const float d : {0.0065f, 0.016f, 0.099f, 0.107f, 0.162f, 0.17f, 0.2f}) {
        Mesh m = shapes::ring(d, 0.0014f, 40);
        k.add(std::move(shapes::turn(m, {1, 0, 0}, 90)), wire, {0, 0, z});
    }
    for (int i = 0; i < 3; ++i) {
        const float a = k.dice.uniform(0, kTau), d = k.dice.uniform(0.02f, 0.11f);
        const Vec3f at{d * std::cos(a), d * std::sin(a), z},
            back = at + Vec3f{k.dice.uniform(-0.012f, 0.012f), 0.012f, 0.085f}, out = normalize(back - at);
        k.rod(wire, at, at + out * 0.03f, 0.0012f, -1, 6);
        k.rod(wire, at + out * 0.025f, at + out * 0.07f, 0.0036f, -1, 10);
        k.rod(black, at + out * 0.07f, back + out * 0.02f, 0.002f, -1, 8);
        for (const float turn : {0.f, 90.f}) {
            Mesh flight = shapes::box({0.03f, 0.001f, 0.03f}, 0.0003f);
            shapes::turn(flight, {0, 0, 1}, turn + 45.f);
            k.add(std::move(flight), red, back + out * 0.02f);
        }
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.5f;
}

constexpr Entry kOnWalls[] = {{"dartboard", dartboard},   {"neon_sign", neon_sign}, {"whiteboard", whiteboard},
                              {"chalkboard", chalkboard}, {"pin_board", pin_board}, {"tapestry", tapestry},
                              {"macrame", macrame},       {"flag", flag},           {"antlers", antlers},
                              {"deer_head", deer_head},   {"world_map", world_map}};

}  // namespace

std::span<const Entry> on_walls() { return kOnWalls; }

}  // namespace fastscene::furniture
