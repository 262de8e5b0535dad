#include "fastscene/walk/published_warp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/parallel.h"
#include "fastscene/walk/vector_trig.h"

namespace fastscene {
namespace {

// Sines and cosines of row latitudes and column longitudes.
struct Angles {
    std::vector<double> sine, cosine;
    template <class AngleOf>
    Angles(int n, AngleOf angle_of) : sine(static_cast<std::size_t>(n)), cosine(static_cast<std::size_t>(n)) {
        std::vector<double> angle(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) angle[static_cast<std::size_t>(i)] = angle_of(i);
        sines(angle, sine);
        cosines(angle, cosine);
    }
};

// Unit directions of a picture's pixels.
struct OfficialDirections {
    Angles row, column;
    OfficialDirections(int width, int height)
        : row(height, [&](int y) { return (1 - 2.0 * y / height) * std::numbers::pi / 2; }),
          column(width, [&](int x) { return 2 * std::numbers::pi * (0.5 - static_cast<double>(x) / width); }) {}
    Vec3d at(std::size_t x, std::size_t y) const {
        return {row.cosine[y] * column.cosine[x], row.sine[y], -(row.cosine[y] * column.sine[x])};
    }
};

// Where a source pixel is projected to, and its new range.
struct Landing {
    std::int32_t target = kNoSource;
    double range = 0;
};

}  // namespace

double PublishedWarp::hole_ratio() const {
    return static_cast<double>(std::count(source.pixels.begin(), source.pixels.end(), kNoSource)) /
           static_cast<double>(source.size());
}

Image<Vec3d> published_directions(int width, int height) {
    const OfficialDirections direction(width, height);
    Image<Vec3d> out(width, height);
    for (std::size_t y = 0, i = 0; y < static_cast<std::size_t>(height); ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x, ++i) out.pixels[i] = direction.at(x, y);
    return out;
}

PublishedWarp published_warp(const ImageRgb8& color, const Image<double>& range, Vec3d move) {
    FASTSCENE_CHECK(color.same_size(range));
    const int w = color.width, h = color.height;
    const OfficialDirections direction(w, h);
    Image<Landing> landing(w, h);
    parallel_for(h, 16, [&](std::int64_t begin, std::int64_t end) {
        const auto columns = static_cast<std::size_t>(w);
        // Per row: the pixels' positions relative to the new viewpoint, and their angles.
        std::vector<double> far(columns), up(columns), flat(columns), ahead(columns), left(columns), theta(columns),
            phi(columns);
        for (auto y = static_cast<std::size_t>(begin); y < static_cast<std::size_t>(end); ++y) {
            Landing* const row = &landing.pixels[y * columns];
            for (std::size_t x = 0; x < columns; ++x) {
                const std::size_t i = y * columns + x;
                const Vec3d p = direction.at(x, y) * range.pixels[i] - move;
                far[x] = length(p);
                const Vec3d to = p / far[x];
                up[x] = to.y;
                flat[x] = std::sqrt(to.x * to.x + to.z * to.z);
                ahead[x] = to.x;
                left[x] = -to.z;
            }
            arc_tangents(up, flat, theta);
            arc_tangents(left, ahead, phi);
            for (std::size_t x = 0; x < columns; ++x) {
                const double ty = std::floor((0.5 - theta[x] / std::numbers::pi) * h),
                             tx = std::floor((0.5 - phi[x] / (2 * std::numbers::pi)) * w);
                if (far[x] > 0 && ty > 0 && ty < h && tx > 0 && tx < w)
                    row[x] = {static_cast<std::int32_t>(ty) * w + static_cast<std::int32_t>(tx), far[x]};
            }
        }
    });
    PublishedWarp out{ImageRgb8(w, h, Rgb8{255, 255, 255}), Image<double>(w, h), Image<std::int32_t>(w, h, kNoSource)};
    for (std::size_t i = 0; i < landing.size(); ++i) {
        if (landing.pixels[i].target == kNoSource) continue;
        const auto target = static_cast<std::size_t>(landing.pixels[i].target);
        if (out.source.pixels[target] != kNoSource && !(landing.pixels[i].range < out.range.pixels[target])) continue;
        out.source.pixels[target] = static_cast<std::int32_t>(i);
        out.range.pixels[target] = landing.pixels[i].range;
        out.color.pixels[target] = color.pixels[i];
    }
    return out;
}

Image<double> published_units(const Image<double>& range) {
    double most = 0;
    for (const double r : range.pixels)
        if (std::isfinite(r)) most = std::max(most, r);
    if (!(most > 0)) throw Error("walk: expected a range map with at least one range > 0, found none");
    Image<double> out = range;
    for (double& r : out.pixels) r = r > 0 && std::isfinite(r) ? r / most : 1.0;
    return out;
}

}  // namespace fastscene
