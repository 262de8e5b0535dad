#include "fastscene/depth/metric_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/math/solve.h"

namespace fastscene {
namespace {

constexpr float kNearestMetres = 0.1f;

// A pixel that may belong to the floor (sine < 0 is down) or the ceiling.
struct Sample {
    double relative, sine, weight;  // weight: solid angle
};

// Only steep rays distinguish a level plane from a wall: 20 degrees from the horizon and more.
std::vector<Sample> steep_samples(const ImageF& relative) {
    const EquirectSize size{relative.width, relative.height};
    const int step = std::max(1, relative.width / 256);
    std::vector<Sample> samples;
    for (int y = step / 2; y < relative.height; y += step) {
        const double lat = (0.5 - (y + 0.5) / relative.height) * std::numbers::pi;
        if (std::abs(lat) < 20 * std::numbers::pi / 180) continue;
        for (int x = step / 2; x < relative.width; x += step)
            if (std::isfinite(relative.at(x, y)))
                samples.push_back({relative.at(x, y), std::sin(lat), pixel_solid_angle(y, size)});
    }
    return samples;
}

// Scale, shift and ceiling height that explain the samples.
struct Planes {
    double scale = 0, shift = 0, ceiling = 0;
};

// Height of a sample relative to its plane, metres.
double misfit(const Sample& s, const Planes& p, double camera_height) {
    const double height = (p.scale * s.relative + p.shift) * s.sine;
    return s.sine < 0 ? height + camera_height : height - p.ceiling;
}
// Geman-McClure weight: outliers have almost no influence.
double trust(double residual, double sigma) {
    const double q = sigma * sigma / (sigma * sigma + residual * residual);
    return q * q;
}

// Iteratively reweighted least squares: samples near the previous planes dominate.
bool refit(const std::vector<Sample>& samples, double camera_height, double sigma, UnknownOfRange unknown,
           Planes& planes) {
    // Weak regularization towards "shift 0, ceiling 1 m", so that a room without a ceiling is solvable.
    Mat3d m{{}, {0, 1e-4, 0}, {0, 0, 1e-4}};
    Vec3d right{0, 0, 1e-4};
    for (const Sample& s : samples) {
        const Vec3d row{s.relative * s.sine, s.sine, s.sine < 0 ? 0. : -1.},
            weighted = row * (s.weight * trust(misfit(s, planes, camera_height), sigma));
        m.row0 += weighted * row.x, m.row1 += weighted * row.y, m.row2 += weighted * row.z;
        right += weighted * (s.sine < 0 ? -camera_height : 0.);
    }
    if (unknown == UnknownOfRange::scale) m.row1 = {0, 1, 0}, right.y = 0;
    const std::optional<Vec3d> found = solved(m, right, 1e-18);
    if (!found) return false;
    planes = {found->x, found->y, found->z};
    return planes.scale > 0 && std::isfinite(planes.shift) && std::isfinite(planes.ceiling);
}

double nadir_median(const std::vector<Sample>& samples) {
    std::vector<double> values;
    for (const Sample& s : samples)
        if (s.sine < -0.85) values.push_back(s.relative * -s.sine);
    if (values.empty()) return 0;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

}  // namespace

MetricFit fit_metres(const ImageF& relative, float camera_height_m, UnknownOfRange unknown) {
    FASTSCENE_CHECK(camera_height_m > 0.f && !relative.empty());
    const std::vector<Sample> samples = steep_samples(relative);
    const double height = camera_height_m, nadir = nadir_median(samples);
    MetricFit fit;
    fit.camera_height_m = camera_height_m;
    fit.scale = nadir > 0 ? static_cast<float>(height / nadir) : camera_height_m;

    // Several initial shifts, each refined; the one that explains most of the sphere wins.
    double best = 0;
    Planes found;
    const auto shift_shares = unknown == UnknownOfRange::scale ? std::vector<double>{0.}
                                                               : std::vector<double>{0., -0.3, -0.6, 0.25, 0.5, 0.75};
    for (const double shift_share : shift_shares) {
        Planes planes{nadir > 0 ? height * (1 - shift_share) / nadir : height, height * shift_share, 1.};
        bool good = planes.scale > 0;
        for (const double sigma : {0.6, 0.4, 0.25, 0.15, 0.1, 0.07, 0.05, 0.05, 0.05, 0.05})
            good = good && refit(samples, height, sigma * height, unknown, planes);
        // A shift near the camera's height turns everything into a sphere, which has a bit of floor, too: reject.
        if (!good || !(planes.ceiling > 0.1 * height) || !(std::abs(planes.shift) < 0.9 * height)) continue;
        double explained = 0;
        for (const Sample& s : samples) explained += s.weight * trust(misfit(s, planes, height), 0.05 * height);
        if (explained > best) best = explained, found = planes;
    }
    if (!(best > 0)) return fit;

    double floor = 0, ceiling = 0, below = 0, above = 0;
    for (const Sample& s : samples) {
        const double on = s.weight * (std::abs(misfit(s, found, height)) < 0.1 * height);
        (s.sine < 0 ? floor : ceiling) += on;
        (s.sine < 0 ? below : above) += s.weight;
    }
    fit.floor_share = below > 0 ? static_cast<float>(floor / below) : 0;
    // A tenth of the lower hemisphere: less may be a table.
    if (!(fit.floor_share > 0.1f)) return fit;
    fit.scale = static_cast<float>(found.scale);
    fit.shift = static_cast<float>(found.shift);
    fit.ceiling_m = above > 0 && ceiling / above > 0.1 ? static_cast<float>(found.ceiling) : 0.f;
    fit.sure = true;
    return fit;
}

ImageF metric_range(const ImageF& relative, const MetricFit& fit) {
    ImageF range = relative;
    for (float& r : range.pixels) r = std::max(kNearestMetres, fit.scale * r + fit.shift);
    return range;
}

}  // namespace fastscene
