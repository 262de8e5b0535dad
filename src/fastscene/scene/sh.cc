#include "fastscene/scene/sh.h"

#include <cmath>
#include <numbers>

namespace fastscene {
namespace {

// Gauss-Legendre quadrature with 4 heights and 8 azimuths is exact for polynomials up to degree 7 on the sphere; the
// product of two functions of degree 3 has degree 6.
constexpr std::array<double, 4> kHeights{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                         0.8611363115940526};
constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                         0.3478548451374538};
constexpr int kTurns = 8;

// Rotations about the axes give integers: removes rounding noise.
double snapped(double v) {
    const double whole = std::round(v);
    return std::fabs(v - whole) < 1e-12 ? whole : v;
}

bool same_band(std::size_t i, std::size_t j) {
    const auto band = [](std::size_t k) { return k < 3 ? 1 : k < 8 ? 2 : 3; };
    return band(i) == band(j);
}

}  // namespace

// Projection onto the orthonormal basis: coefficient i of the rotated color is the integral of basis_i(d) *
// color(old_from_new d).
ShTurn sh_turn(const Mat3d& new_from_old) {
    const Mat3d old_from_new = transpose(new_from_old);
    ShTurn turn{};
    for (std::size_t h = 0; h < kHeights.size(); ++h)
        for (int t = 0; t < kTurns; ++t) {
            const double z = kHeights[h], r = std::sqrt(1 - z * z), angle = (t + 0.5) * 2 * std::numbers::pi / kTurns;
            const Vec3d d{r * std::cos(angle), r * std::sin(angle), z};
            const double weight = kWeights[h] * 2 * std::numbers::pi / kTurns;
            const auto now = sh_basis(d), before = sh_basis(old_from_new * d);
            for (std::size_t i = 0; i + 1 < kShFunctions; ++i)
                for (std::size_t j = 0; j + 1 < kShFunctions; ++j)
                    if (same_band(i, j)) turn[i][j] += weight * now[i + 1] * before[j + 1];
        }
    for (auto& row : turn)
        for (double& v : row) v = snapped(v);
    return turn;
}

}  // namespace fastscene
