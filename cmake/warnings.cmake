# Flags of our own sources, not of the libraries we use.
add_library(fastscene_warnings INTERFACE)
target_compile_options(fastscene_warnings INTERFACE -Wall -Wextra -Wshadow -Wno-psabi -Wno-restrict)
# The picture does not depend on errno or on trapping; NaN and infinity keep their meaning.
add_compile_options(-fno-math-errno -fno-trapping-math)
# What some libraries ask for (threads; libtorch names the ABI): with it everywhere all sources can share their precompiled headers.
add_compile_options(-pthread -D_GLIBCXX_USE_CXX11_ABI=1)
# What the compiler may assume of the processor. Kernels for wider vectors are compiled for each instruction set and chosen at run time
# (splat/simd.cmake), so one build serves machines with and without AVX-512 and everything else computes the same on both.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_BUILD_TYPE STREQUAL "Release")
  add_compile_options(-march=${FASTSCENE_ARCH})
endif()
