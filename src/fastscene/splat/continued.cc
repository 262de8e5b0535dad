#include "fastscene/splat/continued.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "fastscene/base/parallel.h"

namespace fastscene {
namespace {

// Cells of a grid that hold a splat.
class Occupied {
  public:
    explicit Occupied(float cell_m) : cell_m_(cell_m) {}
    void add(Vec3f p) { cells_.insert(key(cell(p.x), cell(p.y), cell(p.z))); }
    // In the point's cell or one beside it.
    bool near(Vec3f p) const {
        for (int k = 0; k < 27; ++k)
            if (cells_.contains(key(cell(p.x) + k % 3 - 1, cell(p.y) + k / 3 % 3 - 1, cell(p.z) + k / 9 - 1)))
                return true;
        return false;
    }

  private:
    int cell(float v) const { return static_cast<int>(std::floor(v / cell_m_)); }
    static std::uint64_t key(int x, int y, int z) {
        const auto part = [](int v) { return static_cast<std::uint64_t>(v + (1 << 20)) & 0x1fffffu; };
        return part(x) << 42 | part(y) << 21 | part(z);
    }
    float cell_m_;
    std::unordered_set<std::uint64_t> cells_;
};

template <class T>
void append_of(std::vector<T>& to, const std::vector<T>& from, std::size_t i, std::size_t each = 1) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(i * each),
              from.begin() + static_cast<std::ptrdiff_t>((i + 1) * each));
}

void append_splat(Splats& to, const Splats& from, std::size_t i) {
    append_of(to.mean_m, from.mean_m, i);
    append_of(to.log_scale, from.log_scale, i);
    append_of(to.rotation, from.rotation, i);
    append_of(to.opacity_logit, from.opacity_logit, i);
    append_of(to.sh0, from.sh0, i);
    append_of(to.sh_rest, from.sh_rest, i, 3 * static_cast<std::size_t>(from.rest_coefficients()));
}

}  // namespace

Splats continued_splats(const Splats& earlier, const std::vector<SurfacePoint>& points,
                        const std::function<bool(Vec3f)>& is_changed, const SplatParams& params, const Run& run) {
    constexpr float kApart_m = 0.06f;  // a point farther than this from every splat is bare
    const auto changed_of = [&](std::size_t count, const auto& position) {
        std::vector<std::uint8_t> out(count);
        parallel_for(static_cast<std::int64_t>(count), 4096, [&](std::int64_t begin, std::int64_t end) {
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
                out[i] = length(position(i)) < kOutside_m && is_changed(position(i));
        });
        return out;
    };
    const auto changed_splats = changed_of(earlier.size(), [&](std::size_t i) { return earlier.mean_m[i]; });
    const auto changed_points = changed_of(points.size(), [&](std::size_t i) { return points[i].position_m; });

    Occupied occupied(kApart_m);
    for (std::size_t i = 0; i < earlier.size(); ++i)
        if (!changed_splats[i]) occupied.add(earlier.mean_m[i]);
    std::vector<SurfacePoint> bare;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (changed_points[i] || (length(points[i].position_m) < kOutside_m && !occupied.near(points[i].position_m)))
            bare.push_back(points[i]);
    const double density = std::min(1., static_cast<double>(count_for(points, params)) /
                                            static_cast<double>(std::max<std::size_t>(1, points.size())));
    SplatParams of_bare = params;
    of_bare.per_m2 = 0;
    of_bare.count = static_cast<int>(std::ceil(density * static_cast<double>(bare.size())));
    Splats added = initial_splats(bare, of_bare, run);
    added.sh_degree = earlier.sh_degree;
    added.resize(added.size());

    Splats out;
    out.sh_degree = earlier.sh_degree, out.filter = earlier.filter;
    for (std::size_t i = 0; i < earlier.size(); ++i)
        if (!changed_splats[i]) append_splat(out, earlier, i);
    for (std::size_t i = 0; i < added.size(); ++i) append_splat(out, added, i);
    return out;
}

}  // namespace fastscene
