# cpack -G DEB: fastscene (the program) and libfastscene-dev (static libraries, headers, examples).
set(CPACK_PACKAGE_NAME fastscene)
set(CPACK_PACKAGE_VENDOR "fastscene")
set(CPACK_PACKAGE_CONTACT "fastscene maintainers <root@localhost>")  # who builds packages for others says so here
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME fastscene)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Makes a furnished room from a sentence, path traces it, and trains 3D Gaussians
 that any browser shows. It also makes scenes of panoramas and photographs.")
# What the program is linked with, as dpkg-shlibdeps finds it.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Without OpenBLAS libtorch multiplies matrices four times as slowly, on one core.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS libopenblas0-openmp)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "libvulkan1, sweethome3d-furniture, ffmpeg, colmap, nodejs")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfastscene-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Static libraries, headers and CMake files: a trainer, renderer and file formats
 for 3D Gaussian splats; a maker of furnished rooms with a path tracer; and the
 whole of fastscene.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libfmt-dev, nlohmann-json3-dev, libtbb-dev, libpng-dev, libjpeg-dev, \
libwebp-dev, libtiff-dev, libopenexr-dev, zlib1g-dev, libzstd-dev, libtomlplusplus-dev, libpugixml-dev, libmeshoptimizer-dev, libheif-dev, \
libjxl-dev, pkg-config")
# Only those who link fastscene::rooms (Embree) or fastscene::fastscene need these.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "libembree-dev, libtorch-dev, libgloo-dev, libicu-dev, \
libcurl4-openssl-dev, libssl-dev")

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libfastscene-dev RENAME copyright
  COMPONENT development)
include(CPack)
