# Everything comes from Debian packages: packaging/apt.txt.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TBB REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(embree 3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
# Debian's httplib is a compiled library whose flags change its layout: take them from pkg-config.
# Debian's OpenEXR CMake files want its Python bindings; pkg-config does not.
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR)
pkg_check_modules(httplib REQUIRED IMPORTED_TARGET cpp-httplib)
if(FASTSCENE_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
endif()

find_program(FASTSCENE_CCACHE ccache)
if(FASTSCENE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${FASTSCENE_CCACHE})
endif()
