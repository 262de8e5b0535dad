#include "fastscene/metrics/depth_scores.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

struct Pair {
    double found, truth, weight;
};

// "ranges from 812 to 9800", "no finite one": hints at the unit of a map without usable ranges.
std::string span_of(const ImageF& map) {
    float low = std::numeric_limits<float>::infinity(), high = 0;
    for (const float r : map.pixels)
        if (r > 0 && std::isfinite(r)) low = std::min(low, r), high = std::max(high, r);
    return high > 0 ? fmt::format("ranges from {:.4g} to {:.4g}", low, high) : "no finite one above 0";
}

std::vector<Pair> pairs_of(const ImageF& found, const ImageF& truth, const DepthScoreOptions& options,
                           std::size_t& missing) {
    if (!found.same_size(truth))
        throw Error("{}: expected the size of {}, {} x {}, found {} x {}", options.found_name, options.truth_name,
                    truth.width, truth.height, found.width, found.height);
    std::vector<Pair> pairs;
    pairs.reserve(found.size());
    for (int y = 0; y < truth.height; ++y) {
        const double weight = options.solid_angle ? pixel_solid_angle(y, {truth.width, truth.height}) : 1.;
        for (int x = 0; x < truth.width; ++x) {
            const float t = truth.at(x, y), f = found.at(x, y);
            if (!(t > 0 && t <= options.farthest_m)) continue;
            if (std::isfinite(f)) pairs.push_back({f, t, weight});
            else ++missing;
        }
    }
    if (pairs.empty() && missing == 0)
        throw Error("{}: expected pixels with a range above 0 and up to {} m, found {}", options.truth_name,
                    options.farthest_m, span_of(truth));
    if (std::none_of(pairs.begin(), pairs.end(), [](const Pair& p) { return p.found > 0; }))
        throw Error("{}: expected estimates above 0 where {} is measured, found none", options.found_name,
                    options.truth_name);
    return pairs;
}

void align(std::vector<Pair>& pairs, DepthAlignment alignment, DepthScores& scores) {
    if (alignment == DepthAlignment::scale) {
        std::vector<double> ratios;
        ratios.reserve(pairs.size());
        for (const Pair& p : pairs)
            if (p.found > 0) ratios.push_back(p.truth / p.found);
        if (ratios.empty()) return;
        const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
        std::nth_element(ratios.begin(), middle, ratios.end());
        scores.scale = *middle;
    }
    if (alignment == DepthAlignment::affine) {
        double w = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (const Pair& p : pairs) {
            w += p.weight;
            x += p.weight * p.found;
            y += p.weight * p.truth;
            xx += p.weight * p.found * p.found;
            xy += p.weight * p.found * p.truth;
        }
        const double spread = w * xx - x * x;
        // A constant map has no scale: only a shift can be fitted.
        scores.scale = spread > 1e-12 * w * xx ? (w * xy - x * y) / spread : 0;
        scores.shift = (y - scores.scale * x) / w;
    }
    for (Pair& p : pairs) p.found = scores.scale * p.found + scores.shift;
}

}  // namespace

DepthScores depth_scores(const ImageF& found, const ImageF& truth, const DepthScoreOptions& options) {
    DepthScores s;
    std::vector<Pair> pairs = pairs_of(found, truth, options, s.missing);
    s.pixels = pairs.size();
    align(pairs, options.alignment, s);
    double total = 0;
    for (const Pair& p : pairs) {
        // Ratios and logarithms need positive values: clamped to a centimetre, like the datasets' own evaluations.
        const double f = std::max(p.found, 0.01), error = f - p.truth, log_error = std::log(f / p.truth),
                     ratio = std::max(f / p.truth, p.truth / f);
        total += p.weight;
        s.abs_rel += p.weight * std::abs(error) / p.truth;
        s.sq_rel += p.weight * error * error / p.truth;
        s.rmse += p.weight * error * error;
        s.rmse_log += p.weight * log_error * log_error;
        for (int i = 0; i < 3; ++i) s.delta[i] += p.weight * (ratio < std::pow(1.25, i + 1));
    }
    s.abs_rel /= total;
    s.sq_rel /= total;
    s.rmse = std::sqrt(s.rmse / total);
    s.rmse_log = std::sqrt(s.rmse_log / total);
    for (double& d : s.delta) d /= total;
    return s;
}

DepthScores mean_scores(const std::vector<DepthScores>& scores) {
    DepthScores mean;
    mean.scale = 0;
    const double share = scores.empty() ? 0 : 1. / static_cast<double>(scores.size());
    for (const DepthScores& s : scores) {
        mean.abs_rel += share * s.abs_rel;
        mean.sq_rel += share * s.sq_rel;
        mean.rmse += share * s.rmse;
        mean.rmse_log += share * s.rmse_log;
        for (int i = 0; i < 3; ++i) mean.delta[i] += share * s.delta[i];
        mean.scale += share * s.scale;
        mean.shift += share * s.shift;
        mean.pixels += s.pixels;
    }
    return mean;
}

}  // namespace fastscene
