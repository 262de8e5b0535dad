# Everything comes from Debian packages: packaging/apt.txt.
include(${CMAKE_CURRENT_LIST_DIR}/fastscene-dependencies.cmake)
foreach(library splat rooms fastscene)
  fastscene_dependencies(${library} REQUIRED)
endforeach()
find_package(CLI11 REQUIRED)
# Debian's httplib is a compiled library whose flags change its layout: take them from pkg-config.
pkg_check_modules(httplib REQUIRED IMPORTED_TARGET cpp-httplib)
if(FASTSCENE_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
endif()

find_program(FASTSCENE_CCACHE ccache)
if(FASTSCENE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${FASTSCENE_CCACHE})
endif()
