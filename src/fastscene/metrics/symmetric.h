// Symmetric matrices of moderate size: eigenvalues by Jacobi rotations, and what NIQE needs of them.
#pragma once

#include <vector>

namespace fastscene {

// x' A^+ x for the symmetric n x n matrix `a` (row-major), A^+ the pseudo-inverse: eigenvalues below
// n * eps * the largest count as 0 (MATLAB's pinv).
double pseudo_inverse_form(std::vector<double> a, const std::vector<double>& x);

}  // namespace fastscene
