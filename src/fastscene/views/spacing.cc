#include "fastscene/views/spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "fastscene/base/parallel.h"

namespace fastscene {
namespace {

constexpr std::size_t kNeighbours = 3, kLeaf = 12;

// A k-d tree split at the median of the longest side; the order of the points encodes the tree.
class Tree {
  public:
    explicit Tree(const std::vector<Vec3f>& points) : points_(points), order_(points.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        build(0, order_.size());
    }

    // Squared distances of the nearest neighbours, ascending; infinite if there are fewer.
    std::array<float, kNeighbours> nearest(std::uint32_t of) const {
        std::array<float, kNeighbours> best;
        best.fill(std::numeric_limits<float>::infinity());
        search(0, order_.size(), of, best);
        return best;
    }

  private:
    std::size_t longest_side(std::size_t begin, std::size_t end) const {
        Vec3f low = points_[order_[begin]], high = low;
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t a = 0; a < 3; ++a)
                low[a] = std::min(low[a], points_[order_[i]][a]), high[a] = std::max(high[a], points_[order_[i]][a]);
        const Vec3f side = high - low;
        return side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
    }
    void build(std::size_t begin, std::size_t end) {
        if (axis_.empty()) axis_.resize(order_.size());
        if (end - begin <= kLeaf) return;
        const std::size_t middle = begin + (end - begin) / 2, a = longest_side(begin, end);
        std::nth_element(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                         order_.begin() + static_cast<std::ptrdiff_t>(middle),
                         order_.begin() + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t i, std::uint32_t j) {
                             return points_[i][a] != points_[j][a] ? points_[i][a] < points_[j][a] : i < j;
                         });
        axis_[middle] = static_cast<std::uint8_t>(a);
        build(begin, middle);
        build(middle + 1, end);
    }
    void consider(std::uint32_t candidate, std::uint32_t of, std::array<float, kNeighbours>& best) const {
        if (candidate == of) return;
        const Vec3f d = points_[candidate] - points_[of];
        float square = dot(d, d);
        for (float& b : best)
            if (square < b) std::swap(square, b);
    }
    void search(std::size_t begin, std::size_t end, std::uint32_t of, std::array<float, kNeighbours>& best) const {
        if (end - begin <= kLeaf) {
            for (std::size_t i = begin; i < end; ++i) consider(order_[i], of, best);
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2, a = axis_[middle];
        consider(order_[middle], of, best);
        const float side = points_[of][a] - points_[order_[middle]][a];
        if (side < 0) search(begin, middle, of, best);
        else search(middle + 1, end, of, best);
        if (!(side * side < best.back())) return;
        if (side < 0) search(middle + 1, end, of, best);
        else search(begin, middle, of, best);
    }

    const std::vector<Vec3f>& points_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint8_t> axis_;  // split axis at each median
};

}  // namespace

std::vector<float> spacings(const std::vector<Vec3f>& points) {
    std::vector<float> out(points.size());
    if (points.size() < 2) return out;
    const Tree tree(points);
    parallel_for(static_cast<std::int64_t>(points.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = begin; i < end; ++i) {
            float sum = 0, count = 0;
            for (const float square : tree.nearest(static_cast<std::uint32_t>(i)))
                if (std::isfinite(square)) sum += square, ++count;
            out[static_cast<std::size_t>(i)] = count > 0 ? std::sqrt(sum / count) : 0.f;
        }
    });
    return out;
}

}  // namespace fastscene
