#include "fastscene/walk/vector_trig.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/check.h"
#include "fastscene/base/isa.h"

#ifdef FASTSCENE_LIBMVEC
#include <immintrin.h>
extern "C" {  // names by the x86-64 vector ABI: d for AVX2, b for SSE
__m256d _ZGVdN4v_sin(__m256d);
__m256d _ZGVdN4v_cos(__m256d);
__m256d _ZGVdN4vv_atan2(__m256d, __m256d);
__m128d _ZGVbN2v_sin(__m128d);
__m128d _ZGVbN2v_cos(__m128d);
__m128d _ZGVbN2vv_atan2(__m128d, __m128d);
}
#endif

namespace fastscene {
namespace {

#ifdef FASTSCENE_LIBMVEC
constexpr std::size_t kAtOnce = 4;
using Four = std::array<double, kAtOnce>;

// The variants differ in the last bit of a tenth of the sines (AVX2 uses fused multiply-add), and both from the scalar
// function in more than half.
[[gnu::target("avx2,fma")]] void sines_avx2(const double* a, double* out) {
    _mm256_storeu_pd(out, _ZGVdN4v_sin(_mm256_loadu_pd(a)));
}
[[gnu::target("avx2,fma")]] void cosines_avx2(const double* a, double* out) {
    _mm256_storeu_pd(out, _ZGVdN4v_cos(_mm256_loadu_pd(a)));
}
[[gnu::target("avx2,fma")]] void arc_tangents_avx2(const double* y, const double* x, double* out) {
    _mm256_storeu_pd(out, _ZGVdN4vv_atan2(_mm256_loadu_pd(y), _mm256_loadu_pd(x)));
}
void sines_sse(const double* a, double* out) {
    for (const int i : {0, 2}) _mm_storeu_pd(out + i, _ZGVbN2v_sin(_mm_loadu_pd(a + i)));
}
void cosines_sse(const double* a, double* out) {
    for (const int i : {0, 2}) _mm_storeu_pd(out + i, _ZGVbN2v_cos(_mm_loadu_pd(a + i)));
}
void arc_tangents_sse(const double* y, const double* x, double* out) {
    for (const int i : {0, 2}) _mm_storeu_pd(out + i, _ZGVbN2vv_atan2(_mm_loadu_pd(y + i), _mm_loadu_pd(x + i)));
}
bool has_avx2() { return isa() >= Isa::avx2; }

// The trailing numbers, padded with ones, which are valid arguments for all functions.
Four last_of(std::span<const double> numbers, std::size_t at) {
    Four some{1, 1, 1, 1};
    std::copy(numbers.begin() + static_cast<std::ptrdiff_t>(at), numbers.end(), some.begin());
    return some;
}
void put_last(const Four& some, std::span<double> out, std::size_t at) {
    std::copy_n(some.begin(), out.size() - at, out.begin() + static_cast<std::ptrdiff_t>(at));
}
template <void (*function)(const double*, double*)>
void in_fours(std::span<const double> in, std::span<double> out) {
    std::size_t i = 0;
    for (; i + kAtOnce <= out.size(); i += kAtOnce) function(&in[i], &out[i]);
    if (i == out.size()) return;
    Four some = last_of(in, i);
    function(some.data(), some.data());
    put_last(some, out, i);
}
template <void (*function)(const double*, const double*, double*)>
void in_fours(std::span<const double> y, std::span<const double> x, std::span<double> out) {
    std::size_t i = 0;
    for (; i + kAtOnce <= out.size(); i += kAtOnce) function(&y[i], &x[i], &out[i]);
    if (i == out.size()) return;
    Four some = last_of(y, i);
    const Four others = last_of(x, i);
    function(some.data(), others.data(), some.data());
    put_last(some, out, i);
}
#endif

}  // namespace

void sines(std::span<const double> angles, std::span<double> out) {
    FASTSCENE_CHECK(angles.size() == out.size());
#ifdef FASTSCENE_LIBMVEC
    has_avx2() ? in_fours<sines_avx2>(angles, out) : in_fours<sines_sse>(angles, out);
#else
    std::transform(angles.begin(), angles.end(), out.begin(), [](double a) { return std::sin(a); });
#endif
}

void cosines(std::span<const double> angles, std::span<double> out) {
    FASTSCENE_CHECK(angles.size() == out.size());
#ifdef FASTSCENE_LIBMVEC
    has_avx2() ? in_fours<cosines_avx2>(angles, out) : in_fours<cosines_sse>(angles, out);
#else
    std::transform(angles.begin(), angles.end(), out.begin(), [](double a) { return std::cos(a); });
#endif
}

void arc_tangents(std::span<const double> y, std::span<const double> x, std::span<double> out) {
    FASTSCENE_CHECK(y.size() == out.size() && x.size() == out.size());
#ifdef FASTSCENE_LIBMVEC
    has_avx2() ? in_fours<arc_tangents_avx2>(y, x, out) : in_fours<arc_tangents_sse>(y, x, out);
#else
    std::transform(y.begin(), y.end(), x.begin(), out.begin(), [](double b, double a) { return std::atan2(b, a); });
#endif
}

}  // namespace fastscene
