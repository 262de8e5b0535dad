// Neon sign.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {
namespace {

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

}  // namespace

// A glowing tube bent to a figure or a word, on clear standoffs, its wire going down. In the asked color, else one of
// those that signs have.
void build_neon_sign(Kit& k) {
    static constexpr std::array<const char*, 9> kFigures{"heart", "hello", "bolt", "love",  "moon",
                                                         "dream", "star",  "open", "cactus"};
    static constexpr std::array<Vec3f, 4> kGases{
        Vec3f{0.8f, 0.1f, 0.34f}, {0.1f, 0.52f, 0.8f}, {0.8f, 0.34f, 0.06f}, {0.42f, 0.12f, 0.8f}};
    const std::string_view asked = k.request.pattern;
    const char* figure = kFigures[static_cast<std::size_t>(k.rng.index(static_cast<int>(kFigures.size())))];
    const bool known = is_one_of(asked,
                                 {"heart", "hello", "bolt", "love", "moon", "dream", "star", "open", "cactus", "bar"});
    const int gas = k.main(plain("neon", kGases[static_cast<std::size_t>(k.rng.index(4))], 0.3f)),
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

}  // namespace fastscene::furniture
