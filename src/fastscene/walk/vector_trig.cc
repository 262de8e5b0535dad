#include "fastscene/walk/vector_trig.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/check.h"

#ifdef FASTSCENE_LIBMVEC
#include <immintrin.h>
extern "C" {   // the names that the x86-64 vector ABI gives them
__m256d _ZGVdN4v_sin(__m256d);
__m256d _ZGVdN4v_cos(__m256d);
__m256d _ZGVdN4vv_atan2(__m256d, __m256d);
}
#endif

namespace fastscene {
namespace {

#ifdef FASTSCENE_LIBMVEC
constexpr std::size_t kLanes = 4;

// Four numbers from `at` on; behind the end ones, which no function minds.
[[gnu::target("avx2,fma")]] __m256d four_of(std::span<const double> numbers, std::size_t at) {
    if (at + kLanes <= numbers.size()) return _mm256_loadu_pd(&numbers[at]);
    std::array<double, kLanes> some{1, 1, 1, 1};
    std::copy(numbers.begin() + static_cast<std::ptrdiff_t>(at), numbers.end(), some.begin());
    return _mm256_loadu_pd(some.data());
}
[[gnu::target("avx2,fma")]] void put_four(__m256d four, std::span<double> out, std::size_t at) {
    std::array<double, kLanes> some;
    _mm256_storeu_pd(some.data(), four);
    std::copy_n(some.begin(), std::min(kLanes, out.size() - at), out.begin() + static_cast<std::ptrdiff_t>(at));
}
[[gnu::target("avx2,fma")]] void vector_sines(std::span<const double> angles, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); i += kLanes) put_four(_ZGVdN4v_sin(four_of(angles, i)), out, i);
}
[[gnu::target("avx2,fma")]] void vector_cosines(std::span<const double> angles, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); i += kLanes) put_four(_ZGVdN4v_cos(four_of(angles, i)), out, i);
}
[[gnu::target("avx2,fma")]] void vector_arc_tangents(std::span<const double> y, std::span<const double> x, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); i += kLanes) put_four(_ZGVdN4vv_atan2(four_of(y, i), four_of(x, i)), out, i);
}
bool has_vector_trig() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#endif

}  // namespace

void sines(std::span<const double> angles, std::span<double> out) {
    FASTSCENE_CHECK(angles.size() == out.size());
#ifdef FASTSCENE_LIBMVEC
    if (has_vector_trig()) return vector_sines(angles, out);
#endif
    std::transform(angles.begin(), angles.end(), out.begin(), [](double a) { return std::sin(a); });
}

void cosines(std::span<const double> angles, std::span<double> out) {
    FASTSCENE_CHECK(angles.size() == out.size());
#ifdef FASTSCENE_LIBMVEC
    if (has_vector_trig()) return vector_cosines(angles, out);
#endif
    std::transform(angles.begin(), angles.end(), out.begin(), [](double a) { return std::cos(a); });
}

void arc_tangents(std::span<const double> y, std::span<const double> x, std::span<double> out) {
    FASTSCENE_CHECK(y.size() == out.size() && x.size() == out.size());
#ifdef FASTSCENE_LIBMVEC
    if (has_vector_trig()) return vector_arc_tangents(y, x, out);
#endif
    std::transform(y.begin(), y.end(), x.begin(), out.begin(), [](double b, double a) { return std::atan2(b, a); });
}

}  // namespace fastscene
