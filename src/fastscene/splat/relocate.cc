#include "fastscene/splat/relocate.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/random.h"

namespace fastscene::splat {
namespace {

constexpr float kDeadOpacity = 0.005f;
constexpr double kMostMoved = 0.05;   // of all splats at a time: the picture must recover between moves
constexpr int kMostCopies = 8;

double opacity_of(float logit) { return 1 / (1 + std::exp(-static_cast<double>(logit))); }

bool is_finite_splat(const Cloud& cloud, std::int64_t i) {
    double sum = 0;
    for (int p = 0; p < kParameters; ++p) sum += std::fabs(cloud.parameters[cloud.at(i, p)]);
    return sum < 1e9;
}

}  // namespace

SharedLook shared_look(float opacity, int copies) {
    const double one = 1 - std::pow(1 - static_cast<double>(opacity), 1.0 / copies);
    double denominator = 0;
    for (int i = 1; i <= copies; ++i) {
        double binomial = 1, power = one;
        for (int k = 0; k <= i - 1; ++k) {
            denominator += binomial * (k % 2 ? -1 : 1) / std::sqrt(k + 1.0) * power;
            power *= one;
            binomial = binomial * (i - 1 - k) / (k + 1);
        }
    }
    return {static_cast<float>(one), static_cast<float>(opacity / denominator)};
}

std::int64_t relocate(Cloud& cloud, std::uint64_t seed, int step) {
    std::vector<std::int64_t> dead, alive;
    std::vector<double> error_up_to;  // running sum over `alive`
    double sum = 0;
    for (std::int64_t i = 0; i < cloud.count; ++i) {
        const double opacity = opacity_of(cloud.parameters[cloud.at(i, 10)]);
        if (!(opacity >= kDeadOpacity) || !is_finite_splat(cloud, i)) {
            dead.push_back(i);
            continue;
        }
        sum += std::max(0.f, cloud.seen_error[static_cast<std::size_t>(i)]);
        alive.push_back(i);
        error_up_to.push_back(sum);
    }
    dead.resize(std::min(dead.size(), static_cast<std::size_t>(kMostMoved * static_cast<double>(cloud.count)) + 1));
    std::int64_t moved = 0;
    if (sum > 0 && !dead.empty()) {
        std::vector<int> copies(static_cast<std::size_t>(cloud.count), 1);
        std::vector<std::int64_t> source(dead.size());
        Random random(seed, "splat.relocate", static_cast<std::uint64_t>(step));
        for (std::int64_t& s : source) {
            const double at = sum * random.uniform();
            const auto k = std::min<std::ptrdiff_t>(std::upper_bound(error_up_to.begin(), error_up_to.end(), at) - error_up_to.begin(),
                                                    static_cast<std::ptrdiff_t>(alive.size()) - 1);
            s = alive[static_cast<std::size_t>(k)];
            copies[static_cast<std::size_t>(s)] = std::min(copies[static_cast<std::size_t>(s)] + 1, kMostCopies);
        }
        for (std::size_t k = 0; k < dead.size(); ++k) {
            const std::int64_t to = dead[k], from = source[k];
            for (int p = 0; p < kParameters; ++p) {
                cloud.parameters[cloud.at(to, p)] = cloud.parameters[cloud.at(from, p)];
                cloud.first_moment[cloud.at(to, p)] = cloud.second_moment[cloud.at(to, p)] = 0;
            }
            ++moved;
        }
        const auto share = [&](std::int64_t i, int n) {
            const auto opacity = static_cast<float>(std::min(opacity_of(cloud.parameters[cloud.at(i, 10)]), 0.995));
            const SharedLook l = shared_look(opacity, n);
            cloud.parameters[cloud.at(i, 10)] = std::log(l.opacity / (1 - l.opacity));
            for (int p = 3; p < 6; ++p) cloud.parameters[cloud.at(i, p)] += std::log(l.scale);
        };
        for (std::size_t k = 0; k < dead.size(); ++k) share(dead[k], copies[static_cast<std::size_t>(source[k])]);
        for (const std::int64_t i : alive)
            if (copies[static_cast<std::size_t>(i)] > 1) {
                share(i, copies[static_cast<std::size_t>(i)]);
                for (int p = 0; p < kParameters; ++p) cloud.first_moment[cloud.at(i, p)] = cloud.second_moment[cloud.at(i, p)] = 0;
            }
    }
    std::fill(cloud.seen_weight.begin(), cloud.seen_weight.end(), 0.f);
    std::fill(cloud.seen_error.begin(), cloud.seen_error.end(), 0.f);
    return moved;
}

}  // namespace fastscene::splat
