// 3 x 3 linear systems.
#pragma once

#include <cmath>
#include <optional>

#include "fastscene/math/rigid.h"

namespace fastscene {

// Solves m * x = right by Cramer's rule; none if |det m| <= `least_determinant` (in the units of m) or NaN, since the
// equations are then linearly dependent.
template <class F>
std::optional<Vec3<F>> solved(const Mat3<F>& m, const Vec3<F>& right, F least_determinant) {
    using std::abs;
    const Vec3<F> across = cross(m.row1, m.row2);
    const F determinant = dot(m.row0, across);
    if (!(abs(determinant) > least_determinant)) return std::nullopt;
    return (across * right.x + cross(m.row2, m.row0) * right.y + cross(m.row0, m.row1) * right.z) / determinant;
}

}  // namespace fastscene
