# The C library's vector mathematics (libmvec): sines since glibc 2.22, arc tangents since 2.35, on x86-64 only.
include(CheckCXXSourceCompiles)
include(CMakePushCheckState)
cmake_push_check_state(RESET)
set(CMAKE_REQUIRED_LIBRARIES mvec)
set(CMAKE_REQUIRED_FLAGS -mavx2)
check_cxx_source_compiles("
#include <immintrin.h>
extern \"C\" { __m256d _ZGVdN4v_sin(__m256d); __m256d _ZGVdN4v_cos(__m256d); __m256d _ZGVdN4vv_atan2(__m256d, __m256d); }
int main(int n, char**) {
    const __m256d a = _mm256_set1_pd(n);
    return static_cast<int>(_mm256_cvtsd_f64(_ZGVdN4vv_atan2(_ZGVdN4v_sin(a), _ZGVdN4v_cos(a))));
}" FASTSCENE_HAS_LIBMVEC)
cmake_pop_check_state()
if(FASTSCENE_HAS_LIBMVEC)
  target_link_libraries(fastscene_walk PRIVATE mvec)
  fastscene_own_flags(walk/vector_trig.cc -DFASTSCENE_LIBMVEC)
endif()
