#include "fastscene/io/codebook.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fastscene/base/parallel.h"

namespace fastscene {

namespace {

// Where many fine steps are worth most: their density is the cube root of the values' (Panter and Dite). From it
// Lloyd's iteration starts near the optimum, which it would be slow to reach in the tails. `values` ascend.
ScalarCodebook companded(const std::vector<float>& values) {
    // Wide enough that most bins hold dozens of values: the cube root of a noisy count would favour full bins.
    const std::size_t bins = std::clamp<std::size_t>(values.size() / 64, 32, 4096);
    const float low = values.front(), width = std::max(1e-12f, (values.back() - low) / static_cast<float>(bins));
    std::vector<double> weight(bins);
    for (const float v : values) ++weight[std::min(bins - 1, static_cast<std::size_t>((v - low) / width))];
    for (double& w : weight) w = std::cbrt(w);
    const double all = std::accumulate(weight.begin(), weight.end(), 0.0);
    ScalarCodebook book{};
    std::size_t bin = 0;
    double passed = 0;
    for (std::size_t k = 0; k < book.size(); ++k) {
        const double wanted = all * (static_cast<double>(k) + 0.5) / static_cast<double>(book.size());
        while (bin + 1 < bins && passed + weight[bin] < wanted) passed += weight[bin++];
        const double share = weight[bin] > 0 ? std::clamp((wanted - passed) / weight[bin], 0.0, 1.0) : 0.5;
        book[k] = low + width * static_cast<float>(static_cast<double>(bin) + share);
    }
    return book;
}

}  // namespace

ScalarCodebook scalar_codebook(std::vector<float> values) {
    ScalarCodebook book{};
    if (values.empty()) return book;
    std::sort(values.begin(), values.end());
    std::vector<double> sum(values.size() + 1);  // of the first i values
    for (std::size_t i = 0; i < values.size(); ++i) sum[i + 1] = sum[i] + static_cast<double>(values[i]);
    book = companded(values);
    constexpr int kRounds = 40;  // the error falls by less than a percent in more
    for (int round = 0; round < kRounds; ++round) {
        std::size_t first = 0;
        for (std::size_t k = 0; k < book.size(); ++k) {
            const auto end = k + 1 == book.size()
                                 ? values.end()
                                 : std::upper_bound(values.begin(), values.end(), 0.5f * (book[k] + book[k + 1]));
            const auto last = std::max(first, static_cast<std::size_t>(end - values.begin()));
            if (last > first)
                book[k] = static_cast<float>((sum[last] - sum[first]) / static_cast<double>(last - first));
            first = last;
        }
        std::sort(book.begin(), book.end());
    }
    return book;
}

std::uint8_t nearest_in(const ScalarCodebook& book, float value) {
    const auto above = std::lower_bound(book.begin(), book.end(), value);
    if (above == book.begin()) return 0;
    if (above == book.end()) return 255;
    const bool lower = value - *(above - 1) <= *above - value;
    return static_cast<std::uint8_t>(above - book.begin() - (lower ? 1 : 0));
}

namespace {

constexpr std::size_t kLanes = 16;
constexpr std::size_t kCells = 256;
constexpr std::size_t kCellSample = 1 << 16;  // points that the cells are made from
constexpr int kCellRounds = 10, kRounds = 8, kRefinements = 3;
constexpr std::size_t kProbes = 12;    // cells around a point that are searched
constexpr std::int64_t kGrain = 1024;  // points a task

// Centroids in groups of kLanes, their numbers side by side, so that a point meets a whole group at once. Compared is
// |c|^2 / 2 - x c, which differs from half the squared distance by the same for all centroids.
class PackedCentroids {
  public:
    PackedCentroids(const float* centroids, std::size_t count, std::size_t dimensions)
        : dimensions_(dimensions), groups_((count + kLanes - 1) / kLanes), rows_(groups_ * (dimensions + 1) * kLanes) {
        for (std::size_t i = 0; i < groups_ * kLanes; ++i) {
            float* column = rows_.data() + i / kLanes * (dimensions + 1) * kLanes + i % kLanes;
            float squared = 0;
            for (std::size_t d = 0; d < dimensions && i < count; ++d) {
                const float v = centroids[i * dimensions + d];
                column[(d + 1) * kLanes] = -v;
                squared += v * v;
            }
            column[0] = i < count ? 0.5f * squared : 1e30f;
        }
    }
    // Improves `best` and `index` where a centroid is nearer; its index counts from `first`.
    void nearest(const float* x, std::uint32_t first, float& best, std::uint32_t& index) const {
        std::array<float, kLanes> least;
        std::array<std::uint32_t, kLanes> where{};
        least.fill(1e30f);
        for (std::size_t g = 0; g < groups_; ++g) {
            const float* row = rows_.data() + g * (dimensions_ + 1) * kLanes;
            std::array<float, kLanes> sum;
            for (std::size_t k = 0; k < kLanes; ++k) sum[k] = row[k];
            for (std::size_t d = 0; d < dimensions_; ++d)
                for (std::size_t k = 0; k < kLanes; ++k) sum[k] += x[d] * row[(d + 1) * kLanes + k];
            for (std::size_t k = 0; k < kLanes; ++k) {
                where[k] = sum[k] < least[k] ? static_cast<std::uint32_t>(g) : where[k];
                least[k] = sum[k] < least[k] ? sum[k] : least[k];
            }
        }
        for (std::size_t k = 0; k < kLanes; ++k)
            if (least[k] < best) best = least[k], index = first + where[k] * kLanes + static_cast<std::uint32_t>(k);
    }

  private:
    std::size_t dimensions_, groups_;
    std::vector<float> rows_;
};

// Points chosen by index.
struct Chosen {
    const float* points;
    std::size_t dimensions;
    std::span<const std::uint32_t> of;
    const float* at(std::size_t i) const { return points + of[i] * dimensions; }
};

// Each centroid becomes the mean of its points; one without points stays.
void move_to_means(const Chosen& chosen, std::span<const std::uint32_t> labels, std::vector<float>& centroids) {
    const std::size_t d = chosen.dimensions;
    std::vector<double> sum(centroids.size());
    std::vector<std::uint32_t> count(centroids.size() / d);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        ++count[labels[i]];
        for (std::size_t k = 0; k < d; ++k) sum[labels[i] * d + k] += static_cast<double>(chosen.at(i)[k]);
    }
    for (std::size_t c = 0; c < count.size(); ++c)
        for (std::size_t k = 0; k < d && count[c]; ++k)
            centroids[c * d + k] = static_cast<float>(sum[c * d + k] / count[c]);
}

// Lloyd's iteration from points spread evenly over the list.
std::vector<float> k_means(const Chosen& chosen, std::size_t count, int rounds) {
    const std::size_t d = chosen.dimensions;
    std::vector<float> centroids(count * d);
    for (std::size_t c = 0; c < count; ++c)
        std::copy_n(chosen.at((2 * c + 1) * chosen.of.size() / (2 * count)), d, centroids.data() + c * d);
    if (count >= chosen.of.size()) return centroids;
    std::vector<std::uint32_t> labels(chosen.of.size());
    for (int round = 0; round < rounds; ++round) {
        const PackedCentroids packed(centroids.data(), count, d);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            float best = 1e30f;
            packed.nearest(chosen.at(i), 0, best, labels[i]);
        }
        move_to_means(chosen, labels, centroids);
    }
    return centroids;
}

double squared_distance(const float* a, const float* b, std::size_t dimensions) {
    double sum = 0;
    for (std::size_t k = 0; k < dimensions; ++k) sum += static_cast<double>((a[k] - b[k]) * (a[k] - b[k]));
    return sum;
}

// How many of `count` centroids each cell gets: what makes the whole error least if it falls in a cell as
// (centroids)^(-2/d).
std::vector<std::size_t> shares_of_cells(const std::vector<std::vector<std::uint32_t>>& members,
                                         const std::vector<double>& error, std::size_t dimensions, std::size_t count) {
    const double d = static_cast<double>(dimensions);
    std::vector<double> weight(members.size());
    for (std::size_t c = 0; c < members.size(); ++c) weight[c] = std::pow(error[c], d / (d + 2));
    const double all = std::max(1e-30, std::accumulate(weight.begin(), weight.end(), 0.0));
    std::vector<std::size_t> shares(members.size());
    for (std::size_t c = 0; c < members.size(); ++c) {
        const auto wanted = 1 + static_cast<std::size_t>(weight[c] / all * static_cast<double>(count - members.size()));
        shares[c] = std::min(members[c].size(), wanted);
    }
    return shares;
}

// Two levels of centroids over all points.
class Search {
  public:
    Search(std::span<const float> points, std::size_t dimensions, std::size_t count)
        : points_(points), dimensions_(dimensions), all_(points.size() / dimensions) {
        std::iota(all_.begin(), all_.end(), 0u);
        make_cells();
        fill_cells(count);
    }
    VectorCodebook refined() {
        VectorCodebook book{dimensions_, {}, std::vector<std::uint32_t>(all_.size())};
        for (const std::vector<float>& part : centroids_)
            book.centroids.insert(book.centroids.end(), part.begin(), part.end());
        for (int round = 0; round <= kRefinements; ++round) {
            label(book);
            if (round < kRefinements) move_to_means({points_.data(), dimensions_, all_}, book.labels, book.centroids);
        }
        return book;
    }

  private:
    const float* point(std::size_t i) const { return points_.data() + i * dimensions_; }

    void make_cells() {
        const std::size_t step = std::max<std::size_t>(1, all_.size() / kCellSample);
        std::vector<std::uint32_t> sample;
        for (std::size_t i = 0; i < all_.size(); i += step) sample.push_back(static_cast<std::uint32_t>(i));
        cells_ = k_means({points_.data(), dimensions_, sample}, std::min(kCells, sample.size()), kCellRounds);
    }
    void fill_cells(std::size_t count) {
        const std::size_t cells = cells_.size() / dimensions_;
        const PackedCentroids packed(cells_.data(), cells, dimensions_);
        std::vector<std::uint32_t> cell_of(all_.size());
        parallel_for(static_cast<std::int64_t>(all_.size()), kGrain, [&](std::int64_t begin, std::int64_t end) {
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                float best = 1e30f;
                packed.nearest(point(i), 0, best, cell_of[i]);
            }
        });
        std::vector<std::vector<std::uint32_t>> members(cells);
        std::vector<double> error(cells);
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const std::uint32_t c = cell_of[i];
            members[c].push_back(static_cast<std::uint32_t>(i));
            error[c] += squared_distance(point(i), cells_.data() + c * dimensions_, dimensions_);
        }
        const std::vector<std::size_t> shares = shares_of_cells(members, error, dimensions_, count);
        centroids_.resize(cells);
        parallel_for(static_cast<std::int64_t>(cells), 1, [&](std::int64_t begin, std::int64_t end) {
            for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
                centroids_[c] = k_means({points_.data(), dimensions_, members[c]}, shares[c], kRounds);
        });
    }
    // Each point's nearest centroid in the kProbes cells whose middles are nearest.
    void label(VectorCodebook& book) const {
        std::vector<PackedCentroids> packed;
        std::vector<std::uint32_t> first;
        for (std::size_t c = 0, at = 0; c < centroids_.size(); ++c) {
            const std::size_t count = centroids_[c].size() / dimensions_;
            packed.emplace_back(book.centroids.data() + at * dimensions_, count, dimensions_);
            first.push_back(static_cast<std::uint32_t>(at));
            at += count;
        }
        parallel_for(static_cast<std::int64_t>(all_.size()), kGrain, [&](std::int64_t begin, std::int64_t end) {
            std::vector<std::pair<double, std::size_t>> near(centroids_.size());
            const auto probes = static_cast<std::ptrdiff_t>(std::min(kProbes, near.size()));
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                for (std::size_t c = 0; c < near.size(); ++c)
                    near[c] = {squared_distance(point(i), cells_.data() + c * dimensions_, dimensions_), c};
                std::partial_sort(near.begin(), near.begin() + probes, near.end());
                float best = 1e30f;
                for (std::ptrdiff_t p = 0; p < probes; ++p) {
                    const std::size_t c = near[static_cast<std::size_t>(p)].second;
                    packed[c].nearest(point(i), first[c], best, book.labels[i]);
                }
            }
        });
    }

    std::span<const float> points_;
    std::size_t dimensions_;
    std::vector<std::uint32_t> all_;
    std::vector<float> cells_;                   // middles
    std::vector<std::vector<float>> centroids_;  // of each cell
};

}  // namespace

VectorCodebook vector_codebook(std::span<const float> points, std::size_t dimensions, std::size_t count) {
    const std::size_t there = points.size() / dimensions;
    if (there > count && count > 2 * kCells) return Search(points, dimensions, count).refined();
    VectorCodebook book{dimensions, {}, std::vector<std::uint32_t>(there)};
    std::vector<std::uint32_t> all(there);
    std::iota(all.begin(), all.end(), 0u);
    if (there <= count) {  // each its own
        book.centroids.assign(points.begin(), points.end());
        book.labels = all;
        return book;
    }
    book.centroids = k_means({points.data(), dimensions, all}, count, kRounds);
    const PackedCentroids packed(book.centroids.data(), count, dimensions);
    for (std::size_t i = 0; i < there; ++i) {
        float best = 1e30f;
        packed.nearest(points.data() + i * dimensions, 0, best, book.labels[i]);
    }
    return book;
}

}  // namespace fastscene
