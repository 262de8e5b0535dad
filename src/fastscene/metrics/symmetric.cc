#include "fastscene/metrics/symmetric.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/check.h"

namespace fastscene {
namespace {

// One Jacobi rotation that zeroes a(p, q), also applied to the coordinates of x.
void rotate(std::vector<double>& a, std::vector<double>& x, std::size_t n, std::size_t p, std::size_t q) {
    const double apq = a[p * n + q];
    if (apq == 0) return;
    const double theta = (a[q * n + q] - a[p * n + p]) / (2 * apq);
    const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    for (std::size_t k = 0; k < n; ++k) {
        const double akp = a[k * n + p], akq = a[k * n + q];
        a[k * n + p] = c * akp - s * akq;
        a[k * n + q] = s * akp + c * akq;
    }
    for (std::size_t k = 0; k < n; ++k) {
        const double apk = a[p * n + k], aqk = a[q * n + k];
        a[p * n + k] = c * apk - s * aqk;
        a[q * n + k] = s * apk + c * aqk;
    }
    const double xp = x[p], xq = x[q];
    x[p] = c * xp - s * xq;
    x[q] = s * xp + c * xq;
}

double off_diagonal(const std::vector<double>& a, std::size_t n) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (i != j) sum += a[i * n + j] * a[i * n + j];
    return sum;
}

}  // namespace

double pseudo_inverse_form(std::vector<double> a, const std::vector<double>& x) {
    const std::size_t n = x.size();
    FASTSCENE_CHECK_EQ(a.size(), n * n);
    double total = 0;
    for (const double v : a) total += v * v;
    std::vector<double> along = x;  // x in the eigenvector basis
    constexpr double eps = std::numeric_limits<double>::epsilon();
    for (int sweep = 0; sweep < 60 && off_diagonal(a, n) > eps * eps * total * 1e-4; ++sweep)
        for (std::size_t p = 0; p < n; ++p)
            for (std::size_t q = p + 1; q < n; ++q) rotate(a, along, n, p, q);
    double largest = 0, sum = 0;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(a[i * n + i]));
    for (std::size_t i = 0; i < n; ++i)
        if (const double v = a[i * n + i]; std::abs(v) > static_cast<double>(n) * eps * largest)
            sum += along[i] * along[i] / v;
    return sum;
}

}  // namespace fastscene
