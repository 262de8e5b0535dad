// Symmetric matrices of moderate size: eigenvalues by Jacobi rotations, as NIQE needs them.
#pragma once

#include <vector>

namespace fastscene {

// x' A^+ x for the symmetric n x n matrix `a` (row-major), with the pseudo-inverse A^+: eigenvalues below n * eps * the
// largest count as 0 (MATLAB's pinv).
double pseudo_inverse_form(std::vector<double> a, const std::vector<double>& x);

}  // namespace fastscene
