#include "fastscene/splat/reference.h"

#include <array>

#include "fastscene/base/check.h"
#include "fastscene/image/color.h"
#include "fastscene/splat/depth_loss.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {
namespace {

constexpr int kReach = 5;

std::array<double, 2 * kReach + 1> window() {
    std::array<double, 2 * kReach + 1> w{};
    double sum = 0;
    for (int k = -kReach; k <= kReach; ++k)
        sum += w[static_cast<std::size_t>(k + kReach)] = std::exp(-k * k / (2 * 1.5 * 1.5));
    for (double& x : w) x /= sum;
    return w;
}

// Calls visit(neighbour, weight) for the part of the 11x11 window that lies in the picture.
template <class Visit>
void each_neighbour(int x, int y, int width, int height, Visit&& visit) {
    static const auto w = window();
    for (int j = -kReach; j <= kReach; ++j)
        for (int i = -kReach; i <= kReach; ++i)
            if (x + i >= 0 && x + i < width && y + j >= 0 && y + j < height)
                visit(
                    static_cast<std::size_t>(y + j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x + i),
                    w[static_cast<std::size_t>(i + kReach)] * w[static_cast<std::size_t>(j + kReach)]);
}

}  // namespace

ReferenceLoss loss_reference(const std::vector<Vec3d>& picture, const View& view, double lambda) {
    const int width = view.color.width, height = view.color.height;
    FASTSCENE_CHECK_EQ(picture.size(), view.color.size());
    const double scale = 1.0 / (3.0 * static_cast<double>(picture.size()));
    ReferenceLoss out;
    out.v.assign(picture.size(), {});
    for (std::size_t c = 0; c < 3; ++c) {
        const auto target = [&](std::size_t i) {
            return static_cast<double>(unit_from_srgb8(view.color.pixels[i])[c]);
        };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                      static_cast<std::size_t>(x);
                double weight = view.weight.empty() ? 1.0 : view.weight.pixels[i] / 255.0;
                if (view.model == CameraModel::equirectangular) weight *= latitude_weight(y, height);
                double mx = 0, my = 0, squares = 0, product = 0;
                each_neighbour(x, y, width, height, [&](std::size_t n, double w) {
                    const double a = picture[n][c], b = target(n);
                    mx += w * a, my += w * b, squares += w * (a * a + b * b), product += w * a * b;
                });
                const double a1 = 2 * mx * my + 1e-4, a2 = 2 * (product - mx * my) + 9e-4;
                const double b1 = mx * mx + my * my + 1e-4, b2 = squares - mx * mx - my * my + 9e-4;
                const double ssim = a1 * a2 / (b1 * b2), difference = picture[i][c] - target(i);
                out.loss += scale * weight * ((1 - lambda) * std::abs(difference) + lambda * (1 - ssim));
                out.squared_error += scale * weight * difference * difference;
                out.v[i][c] += scale * weight * (1 - lambda) * (difference > 0 ? 1 : difference < 0 ? -1 : 0);
                const double p = 2 * my * (a2 - a1) / (b1 * b2) - 2 * mx * ssim * (1 / b1 - 1 / b2);
                const double q = -ssim / b2, r = 2 * a1 / (b1 * b2), k = -scale * weight * lambda;
                each_neighbour(x, y, width, height, [&](std::size_t n, double w) {
                    out.v[n][c] += k * w * (p + 2 * picture[n][c] * q + target(n) * r);
                });
            }
    }
    return out;
}

double depth_loss_reference(ReferencePicture<double>& picture, const View& view, const ImageF& depth, double strength,
                            std::vector<double>& v_depth) {
    const double scale = strength / static_cast<double>(picture.pixels.size());
    double sum = 0;
    v_depth.clear();
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        double weight = scale * (view.weight.empty() ? 1.0 : view.weight.pixels[i] / 255.0);
        if (view.model == CameraModel::equirectangular)
            weight *= latitude_weight(static_cast<int>(i) / picture.width, picture.height);
        const DepthLoss<double> l = depth_loss(picture.depth_sum[i], picture.pixels[i].transmittance,
                                               static_cast<double>(depth.pixels[i]));
        picture.depth_sum[i] = l.total, sum += weight * l.loss;
        v_depth.push_back(weight * l.v);
    }
    return sum;
}

double transmittance_loss_reference(const ReferencePicture<double>& picture, const View& view, double strength,
                                    std::vector<double>& v_transmittance) {
    const double scale = strength / static_cast<double>(picture.pixels.size());
    double sum = 0;
    v_transmittance.clear();
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        double weight = scale * (view.weight.empty() ? 1.0 : view.weight.pixels[i] / 255.0);
        if (view.model == CameraModel::equirectangular)
            weight *= latitude_weight(static_cast<int>(i) / picture.width, picture.height);
        v_transmittance.push_back(weight);
        sum += weight * picture.pixels[i].transmittance;
    }
    return sum;
}

}  // namespace fastscene::splat
