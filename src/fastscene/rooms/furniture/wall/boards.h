// What boards on walls share: the frame, and lines drawn by hand.
#pragma once

#include <functional>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

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
            const float end = std::min(x1, x + high * k_.rng.uniform(2.f, 6.f));
            Stroke word;
            for (bool up = false; x < end; x += high * k_.rng.uniform(0.2f, 0.34f), up = !up) {
                const float tall = up ? (k_.rng.chance(0.22f) ? 1.f : 0.6f) : (k_.rng.chance(0.1f) ? -0.35f : 0.f);
                word.push_back({x, y + high * (tall + k_.rng.uniform(-0.06f, 0.06f))});
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
void wall_frame(Kit& k, int material, Vec3f s, float wide, float deep);

// ---- neon

Stroke bow(Vec2f middle, Vec2f radii, float from_deg, float to_deg, int steps = 14);

}  // namespace fastscene::furniture
