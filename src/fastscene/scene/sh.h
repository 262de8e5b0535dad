// Real spherical harmonics in the convention of 3DGS files (Kerbl et al. 2023): degree l has 2l+1 functions, m = -l..l,
// with the signs of that paper's code. Color of a splat seen along d (unit, from the camera to the splat): 0.5 + sum of
// coefficient * basis(d).
#pragma once

#include <array>

#include "fastscene/math/rigid.h"
#include "fastscene/math/vec.h"

namespace fastscene {

inline constexpr int kHighestShDegree = 3;
inline constexpr int kShFunctions = 16;  // of degrees 0 to 3

// The (degree + 1)^2 basis functions up to `degree`, of 16, at a unit direction.
template <class F>
std::array<F, kShFunctions> sh_basis(Vec3<F> d) {
    const F x = d.x, y = d.y, z = d.z, xx = x * x, yy = y * y, zz = z * z;
    return {F(0.28209479177387814),
            F(-0.4886025119029199) * y,
            F(0.4886025119029199) * z,
            F(-0.4886025119029199) * x,
            F(1.0925484305920792) * x * y,
            F(-1.0925484305920792) * y * z,
            F(0.31539156525252005) * (F(2) * zz - xx - yy),
            F(-1.0925484305920792) * x * z,
            F(0.5462742152960396) * (xx - yy),
            F(-0.5900435899266435) * y * (F(3) * xx - yy),
            F(2.890611442640554) * x * y * z,
            F(-0.4570457994644658) * y * (F(4) * zz - xx - yy),
            F(0.3731763325901154) * z * (F(2) * zz - F(3) * xx - F(3) * yy),
            F(-0.4570457994644658) * x * (F(4) * zz - xx - yy),
            F(1.445305721320277) * z * (xx - yy),
            F(-0.5900435899266435) * x * (xx - F(3) * yy)};
}

// Transformation of the coefficients of degrees 1 to 3 under an orthogonal change of axes (rotation or reflection): row
// i, column j, in the order of f_rest. Blocks of 3, 5 and 7; zero elsewhere.
using ShTurn = std::array<std::array<double, kShFunctions - 1>, kShFunctions - 1>;
ShTurn sh_turn(const Mat3d& new_from_old);

}  // namespace fastscene
