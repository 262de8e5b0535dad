#include "fastscene/rooms/cutout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fastscene {
namespace {

constexpr float kFinest_texels = 3;  // edges shorter than this are not halved

int wrapped_texel(int i, int n) { return ((i % n) + n) % n; }

// How much of a triangle in the picture is opaque: by its texels, at most kRows a side.
enum class Cover : std::uint8_t { none, some, all };
Cover cover_of(const std::array<Vec2f, 3>& uv, const ImageMask& alpha, int cutoff) {
    constexpr int kRows = 16;
    const Vec2f size{static_cast<float>(alpha.width), static_cast<float>(alpha.height)};
    float longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2f e = uv[(k + 1) % 3] - uv[k];
        longest = std::max({longest, std::abs(e.x) * size.x, std::abs(e.y) * size.y});
    }
    const int rows = std::clamp(static_cast<int>(longest) + 1, 2, kRows);
    bool any = false, all = true;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; i + j < rows; ++j) {
            const float a = (static_cast<float>(i) + 1.f / 3) / static_cast<float>(rows),
                        b = (static_cast<float>(j) + 1.f / 3) / static_cast<float>(rows);
            const Vec2f p = uv[0] * (1 - a - b) + uv[1] * a + uv[2] * b;
            const int x = wrapped_texel(static_cast<int>(std::floor(p.x * size.x)), alpha.width),
                      y = wrapped_texel(static_cast<int>(std::floor((1 - p.y) * size.y)), alpha.height);
            const bool opaque = alpha.at(x, y) >= cutoff;
            any |= opaque, all &= opaque;
        }
    return all ? Cover::all : any ? Cover::some : Cover::none;
}

class Cutter {
  public:
    Cutter(const Mesh& mesh, const ImageMask& alpha, int cutoff, std::size_t most)
        : alpha_(alpha), cutoff_(cutoff), most_(3 * most), out_(mesh) {
        out_.triangles.clear();
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3)
            cut({mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2]});
    }
    Mesh take() { return std::move(out_); }

  private:
    using Triangle = std::array<std::uint32_t, 3>;

    Vec2f uv(std::uint32_t v) const { return {out_.coords[v].x, out_.coords[v].y}; }
    float texels(std::uint32_t a, std::uint32_t b) const {
        const Vec2f e = uv(a) - uv(b);
        return std::hypot(e.x * static_cast<float>(alpha_.width), e.y * static_cast<float>(alpha_.height));
    }
    void cut(const Triangle& t) {
        const Cover cover = cover_of({uv(t[0]), uv(t[1]), uv(t[2])}, alpha_, cutoff_);
        if (cover == Cover::none) return;
        std::size_t longest = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (texels(t[k], t[(k + 1) % 3]) > texels(t[longest], t[(longest + 1) % 3])) longest = k;
        const std::uint32_t a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3];
        if (cover == Cover::all || texels(a, b) <= kFinest_texels || out_.triangles.size() >= most_) {
            // At the finest, a triangle is kept if its center is opaque.
            const Vec2f center = (uv(a) + uv(b) + uv(c)) * (1.f / 3);
            if (cover == Cover::some && cover_of({center, center, center}, alpha_, cutoff_) != Cover::all) return;
            out_.triangles.insert(out_.triangles.end(), t.begin(), t.end());
            return;
        }
        const std::uint32_t m = middle(a, b);
        cut({a, m, c});
        cut({m, b, c});
    }
    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto m = static_cast<std::uint32_t>(out_.positions.size());
        out_.positions.push_back((out_.positions[a] + out_.positions[b]) * 0.5f);
        out_.normals.push_back(normalize(out_.normals[a] + out_.normals[b]));
        out_.coords.push_back((out_.coords[a] + out_.coords[b]) * 0.5f);
        return m;
    }

    const ImageMask& alpha_;
    int cutoff_;
    std::size_t most_;
    Mesh out_;
};

}  // namespace

Mesh cut_out(const Mesh& mesh, const ImageMask& alpha, int cutoff, std::size_t most) {
    return Cutter(mesh, alpha, cutoff, most).take();
}

}  // namespace fastscene
