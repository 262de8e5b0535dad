# One source, three instruction sets; choose_kernel.cc picks at run time. (GCC 12 warns inside its own AVX-512 header.) Elsewhere than on x86-64 all three are the plain build.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  fastscene_own_flags(splat/isa_avx512.cc -march=x86-64-v4 -Wno-uninitialized -Wno-maybe-uninitialized)
  fastscene_own_flags(splat/isa_avx2.cc -march=x86-64-v3)
  fastscene_own_flags(splat/isa_baseline.cc -march=x86-64)
endif()
if(TARGET splat_test)
  target_include_directories(splat_test PRIVATE ${PROJECT_SOURCE_DIR})  # bench/textured_room.h
endif()
