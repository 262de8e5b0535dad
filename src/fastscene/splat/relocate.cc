#include "fastscene/splat/relocate.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/random.h"

namespace fastscene::splat {
namespace {

constexpr float kDeadOpacity = 0.005f;  // hardly above 1/255 anywhere

// Splits a splat in two along its longest axis, with sizes and offsets such that the pair looks much like the original
// (the sum, 0.75 sigma wide and 1.2 sigma apart, is within 4 % of one Gaussian of 1 sigma).
constexpr float kHalfOffset = 0.6f, kHalfSize = 0.75f;
constexpr double kHalfDensity = 0.72;  // share of -ln(1 - opacity) that each half gets

double opacity_of(const Cloud& c, std::int64_t i) {
    return 1 / (1 + std::exp(-static_cast<double>(c.parameters[c.at(i, kLogit)])));
}

bool is_finite_splat(const Cloud& cloud, std::int64_t i) {
    double sum = 0;
    for (int p = 0; p < kParameters; ++p) sum += std::fabs(cloud.parameters[cloud.at(i, p)]);
    return sum < 1e9;
}

// Indices of the splats to move, ascending.
std::vector<std::int64_t> useless_splats(const Cloud& cloud, double fraction) {
    std::vector<float> weights(cloud.seen_weight.begin(), cloud.seen_weight.begin() + cloud.count);
    const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(cloud.count));
    float limit = -1;
    if (rank > 0) {
        std::nth_element(weights.begin(), weights.begin() + rank, weights.end());
        limit = weights[static_cast<std::size_t>(rank)];
    }
    std::vector<std::int64_t> out;
    for (std::int64_t i = 0; i < cloud.count; ++i)
        if (cloud.seen_weight[static_cast<std::size_t>(i)] < limit || !(opacity_of(cloud, i) >= kDeadOpacity) ||
            !is_finite_splat(cloud, i))
            out.push_back(i);
    return out;
}

// `count` distinct splats, sampled with probability proportional to their error, none of them in `excluded` (sorted).
std::vector<std::int64_t> splats_to_split(const Cloud& cloud, const std::vector<std::int64_t>& excluded,
                                          std::size_t count, Random random) {
    std::vector<std::int64_t> candidates;
    std::vector<double> up_to;  // cumulative sum of the errors
    double sum = 0;
    auto skip = excluded.begin();
    for (std::int64_t i = 0; i < cloud.count; ++i) {
        if (skip != excluded.end() && *skip == i) {
            ++skip;
            continue;
        }
        const float error = cloud.seen_error[static_cast<std::size_t>(i)];
        if (!(error > 0)) continue;
        candidates.push_back(i);
        up_to.push_back(sum += error);
    }
    std::vector<std::int64_t> out;
    if (candidates.empty()) return out;
    std::vector<bool> taken(candidates.size());
    for (std::size_t k = 0; k < count; ++k) {
        const auto found = std::upper_bound(up_to.begin(), up_to.end(), sum * random.uniform()) - up_to.begin();
        const auto c = static_cast<std::size_t>(
            std::min<std::ptrdiff_t>(found, static_cast<std::ptrdiff_t>(candidates.size()) - 1));
        if (!taken[c]) out.push_back(candidates[c]);
        taken[c] = true;
    }
    return out;
}

}  // namespace

void split(Cloud& cloud, std::int64_t from, std::int64_t to) {
    auto& x = cloud.parameters;
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a)
        if (x[cloud.at(from, 3 + static_cast<int>(a))] > x[cloud.at(from, 3 + static_cast<int>(axis))]) axis = a;
    const auto get = [&](int p) { return x[cloud.at(from, p)]; };
    const Vec3f along = matrix_of(Quatf{get(6), get(7), get(8), get(9)}).column(axis);
    const int scale = 3 + static_cast<int>(axis);
    const Vec3f offset = along * (kHalfOffset * std::exp(get(scale)));
    const double opacity = 1 - std::pow(1 - std::min(opacity_of(cloud, from), 0.995), kHalfDensity);
    x[cloud.at(from, scale)] += std::log(kHalfSize);
    x[cloud.at(from, kLogit)] = static_cast<float>(std::log(opacity / (1 - opacity)));
    for (int p = 0; p < kParameters; ++p) {
        x[cloud.at(to, p)] = get(p);
        for (const std::int64_t i : {from, to})
            cloud.first_moment[cloud.at(i, p)] = cloud.second_moment[cloud.at(i, p)] = 0;
    }
    for (int a = 0; a < 3; ++a) {
        x[cloud.at(from, a)] -= offset[static_cast<std::size_t>(a)];
        x[cloud.at(to, a)] += offset[static_cast<std::size_t>(a)];
    }
    for (int k = 0; k < 3 * rest_functions(cloud.degree); ++k) {
        cloud.rest[cloud.rest_at(to, k)] = cloud.rest[cloud.rest_at(from, k)];
        for (const std::int64_t i : {from, to})
            cloud.rest_first_moment[cloud.rest_at(i, k)] = cloud.rest_second_moment[cloud.rest_at(i, k)] = 0;
    }
}

std::int64_t grow(Cloud& cloud, std::int64_t wanted, std::uint64_t seed, int step) {
    wanted = std::min(wanted, cloud.capacity - cloud.count);
    if (wanted <= 0) return 0;
    const std::vector<std::int64_t> sources = splats_to_split(
        cloud, {}, static_cast<std::size_t>(wanted), Random(seed, "splat.grow", static_cast<std::uint64_t>(step)));
    for (const std::int64_t from : sources) split(cloud, from, cloud.count++);
    return static_cast<std::int64_t>(sources.size());
}

void add_noise(Cloud& cloud, float size_m, std::uint64_t seed, int step) {
    constexpr double kGate = 100, kGateOpacity = 0.005;  // values of the published implementation
    for (std::int64_t i = 0; i < cloud.count; ++i) {
        const double gate = 1 / (1 + std::exp(kGate * (opacity_of(cloud, i) - kGateOpacity)));
        if (!(gate > 1e-6)) continue;
        Random random(seed, "splat.noise", static_cast<std::uint64_t>(step) << 32 | static_cast<std::uint64_t>(i));
        const auto get = [&](int p) { return cloud.parameters[cloud.at(i, p)]; };
        const Mat3f turn = matrix_of(Quatf{get(6), get(7), get(8), get(9)});
        Vec3f local;
        for (std::size_t a = 0; a < 3; ++a) local[a] = random.normal() * std::exp(get(3 + static_cast<int>(a)));
        const Vec3f by = turn * local * (static_cast<float>(gate) * size_m);
        for (int a = 0; a < 3; ++a) cloud.parameters[cloud.at(i, a)] += by[static_cast<std::size_t>(a)];
    }
}

std::int64_t relocate(Cloud& cloud, const Relocation& how, std::uint64_t seed, int step) {
    const std::vector<std::int64_t> useless = useless_splats(cloud, how.useless_fraction);
    const std::vector<std::int64_t> sources = splats_to_split(
        cloud, useless, useless.size(), Random(seed, "splat.relocate", static_cast<std::uint64_t>(step)));
    for (std::size_t k = 0; k < sources.size(); ++k) split(cloud, sources[k], useless[k]);
    std::fill(cloud.seen_weight.begin(), cloud.seen_weight.end(), 0.f);
    std::fill(cloud.seen_error.begin(), cloud.seen_error.end(), 0.f);
    return static_cast<std::int64_t>(sources.size());
}

}  // namespace fastscene::splat
