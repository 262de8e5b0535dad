# One source, three instruction sets; choose_kernel.cc picks at run time. Source flags come last on the
# command line, so they win over -march=native. (GCC 12 warns inside its own AVX-512 header.) Elsewhere than on x86-64 all three are the plain build.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(splat ${PROJECT_SOURCE_DIR}/src/fastscene/splat)
  set_source_files_properties(${splat}/isa_avx512.cc PROPERTIES COMPILE_OPTIONS "-march=x86-64-v4;-Wno-uninitialized;-Wno-maybe-uninitialized")
  set_source_files_properties(${splat}/isa_avx2.cc PROPERTIES COMPILE_OPTIONS "-march=x86-64-v3")
  set_source_files_properties(${splat}/isa_baseline.cc PROPERTIES COMPILE_OPTIONS "-march=x86-64")
endif()
if(TARGET splat_test)
  target_include_directories(splat_test PRIVATE ${PROJECT_SOURCE_DIR})  # bench/textured_room.h
endif()
