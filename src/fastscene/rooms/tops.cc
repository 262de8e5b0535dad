#include "fastscene/rooms/tops.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/rooms/catalogue.h"

namespace fastscene {
namespace {

constexpr float kCell = 0.02f;                      // metres
constexpr float kLevel = 0.03f;                     // metres: cushions are a little round
constexpr float kLowest = 0.1f, kHighest = 1.3f;    // metres above its base
constexpr float kLeastSide = 0.14f, kLeast = 0.2f;  // metres; of the piece's box
constexpr float kNone = -1;

// How high a piece is, seen from above.
class Heights {
  public:
    explicit Heights(const Piece& piece)
        : size_(piece.size_m),
          wide_(std::max(1, static_cast<int>(std::ceil(size_.x / kCell)))),
          deep_(std::max(1, static_cast<int>(std::ceil(size_.z / kCell)))),
          y_(static_cast<std::size_t>(wide_ * deep_), kNone) {
        for (const Mesh& m : piece.meshes)
            for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3)
                add(m.positions[m.triangles[t]], m.positions[m.triangles[t + 1]], m.positions[m.triangles[t + 2]]);
    }
    int wide() const { return wide_; }
    int deep() const { return deep_; }
    float at(int i, int k) const { return y_[static_cast<std::size_t>(k * wide_ + i)]; }
    float x(int i) const { return (static_cast<float>(i) - 0.5f * static_cast<float>(wide_)) * size_.x / wide_f(); }
    float z(int k) const { return (static_cast<float>(k) - 0.5f * static_cast<float>(deep_)) * size_.z / deep_f(); }

  private:
    float wide_f() const { return static_cast<float>(wide_); }
    float deep_f() const { return static_cast<float>(deep_); }
    void add(Vec3f a, Vec3f b, Vec3f c) {
        const float area = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
        if (std::abs(area) < 1e-9f) return;
        const auto cell = [](float at, float extent, float count) { return (at / extent + 0.5f) * count; };
        const auto low = [](float v) { return std::max(0, static_cast<int>(std::floor(v))); };
        const int i0 = low(cell(std::min({a.x, b.x, c.x}), size_.x, wide_f()));
        const int k0 = low(cell(std::min({a.z, b.z, c.z}), size_.z, deep_f()));
        const int i1 = std::min(wide_ - 1, low(cell(std::max({a.x, b.x, c.x}), size_.x, wide_f())));
        const int k1 = std::min(deep_ - 1, low(cell(std::max({a.z, b.z, c.z}), size_.z, deep_f())));
        for (int k = k0; k <= k1; ++k)
            for (int i = i0; i <= i1; ++i) {
                const float px = (x(i) + x(i + 1)) / 2, pz = (z(k) + z(k + 1)) / 2;
                const float u = ((px - a.x) * (c.z - a.z) - (pz - a.z) * (c.x - a.x)) / area;
                const float v = ((b.x - a.x) * (pz - a.z) - (b.z - a.z) * (px - a.x)) / area;
                if (u < 0 || v < 0 || u + v > 1) continue;
                float& y = y_[static_cast<std::size_t>(k * wide_ + i)];
                y = std::max(y, a.y + (b.y - a.y) * u + (c.y - a.y) * v);
            }
    }

    Vec3f size_;
    int wide_, deep_;
    std::vector<float> y_;
};

struct Box {
    int i0 = 0, i1 = 0, k0 = 0, k1 = 0;
    int cells() const { return (i1 - i0) * (k1 - k0); }
};

// The largest rectangle of cells in [y - kLevel, y].
Box largest_at(const Heights& heights, float y) {
    const auto level = [&](int i, int k) { return heights.at(i, k) <= y && heights.at(i, k) > y - kLevel; };
    std::vector<int> run(static_cast<std::size_t>(heights.wide()), 0);  // rows that end here
    Box best;
    for (int k = 0; k < heights.deep(); ++k)
        for (int i = 0; i < heights.wide(); ++i) {
            int& here = run[static_cast<std::size_t>(i)];
            here = level(i, k) ? here + 1 : 0;
            for (int from = i, rows = here; from >= 0 && rows > 0; --from) {
                rows = std::min(rows, run[static_cast<std::size_t>(from)]);
                const Box box{from, i + 1, k + 1 - rows, k + 1};
                if (box.cells() > best.cells()) best = box;
            }
        }
    return best;
}

}  // namespace

std::optional<Surface> flat_top(const Piece& piece) {
    constexpr float kWidest = 4;  // metres: nothing to stand on is larger
    if (piece.mount == Mount::wall || piece.mount == Mount::ceiling || has_role(piece.kind, Role::no_top)) return {};
    if (std::max(piece.size_m.x, piece.size_m.z) > kWidest || piece.meshes.empty()) return {};
    const Heights heights(piece);
    std::vector<float> levels;
    for (int k = 0; k < heights.deep(); ++k)
        for (int i = 0; i < heights.wide(); ++i)
            if (const float y = heights.at(i, k); y > kLowest && y < kHighest) levels.push_back(y);
    std::sort(levels.begin(), levels.end());
    constexpr float kApart = 0.01f;  // metres between the heights that are tried
    Box best;
    float high = kNone;
    for (float last = kNone; const float y : levels) {
        if (y < last + kApart) continue;
        last = y;
        if (const Box box = largest_at(heights, y + kApart); box.cells() > best.cells()) best = box, high = y + kApart;
    }
    if (best.cells() == 0) return {};
    const float x0 = heights.x(best.i0), x1 = heights.x(best.i1), z0 = heights.z(best.k0), z1 = heights.z(best.k1);
    if (std::min(x1 - x0, z1 - z0) < kLeastSide || (x1 - x0) * (z1 - z0) < kLeast * piece.size_m.x * piece.size_m.z)
        return {};
    float top = kNone;
    for (int k = best.k0; k < best.k1; ++k)
        for (int i = best.i0; i < best.i1; ++i) top = std::max(top, std::min(high, heights.at(i, k)));
    return Surface{{(x0 + x1) / 2, top, (z0 + z1) / 2}, {(x1 - x0) / 2, (z1 - z0) / 2}};
}

void add_flat_top(Piece& piece) {
    if (!piece.surfaces.empty()) return;
    if (const auto top = flat_top(piece)) piece.surfaces.push_back(*top);
}

}  // namespace fastscene
