# The libraries that others link (docs/library.md). A library is the modules that its front modules stand on, less those
# of the libraries below it, in one static archive; the modules keep their own targets for the build.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(FASTSCENE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/fastscene)

# The modules that `modules` stand on, themselves included, lower ones first.
function(fastscene_module_closure out)
  set(found "")
  foreach(module ${ARGN})
    get_target_property(uses fastscene_${module} FASTSCENE_USES)
    if(uses)
      fastscene_module_closure(below ${uses})
      list(APPEND found ${below})
    endif()
    list(APPEND found ${module})
  endforeach()
  list(REMOVE_DUPLICATES found)
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# fastscene_library(name FRONTS module… [ON library])
# Its target is fastscene::name, here and where it is installed; its header is src/fastscene/name.h.
function(fastscene_library name)
  cmake_parse_arguments(LIBRARY "" "ON" "FRONTS" ${ARGN})
  set(target fastscene_library_${name})
  fastscene_module_closure(modules ${LIBRARY_FRONTS})
  if(LIBRARY_ON)
    get_target_property(below fastscene_library_${LIBRARY_ON} FASTSCENE_MODULES)
    list(REMOVE_ITEM modules ${below})
  endif()

  set(objects "")
  set(links "")
  foreach(module ${modules})
    get_target_property(type fastscene_${module} TYPE)
    if(type STREQUAL "STATIC_LIBRARY")
      list(APPEND objects $<TARGET_OBJECTS:fastscene_${module}>)
      get_target_property(others fastscene_${module} FASTSCENE_OBJECTS)
      if(others)
        list(APPEND objects ${others})
      endif()
    endif()
    get_target_property(linked fastscene_${module} INTERFACE_LINK_LIBRARIES)
    if(linked)
      list(FILTER linked EXCLUDE REGEX "fastscene_")
      list(APPEND links ${linked})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES links)

  add_library(${target} STATIC ${objects})
  add_library(fastscene::${name} ALIAS ${target})
  set(output fastscene-${name})
  if(name STREQUAL PROJECT_NAME)
    set(output fastscene)
  endif()
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${name} OUTPUT_NAME ${output}
    ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib FASTSCENE_MODULES "${below};${modules}")
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} INTERFACE cxx_std_20)
  if(LIBRARY_ON)
    target_link_libraries(${target} INTERFACE fastscene_library_${LIBRARY_ON})
  endif()
  target_link_libraries(${target} INTERFACE ${links})

  install(TARGETS ${target} EXPORT fastscene-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT fastscene-${name} NAMESPACE fastscene:: FILE fastscene-${name}-targets.cmake
    DESTINATION ${FASTSCENE_CMAKE_DIR} COMPONENT development)
endfunction()

# The headers that the libraries' own headers reach, the version header, and what find_package reads.
function(fastscene_install_development)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/version.h.in ${PROJECT_BINARY_DIR}/generated/fastscene/version.h @ONLY)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/fastscene-config.cmake.in
    ${PROJECT_BINARY_DIR}/fastscene-config.cmake INSTALL_DESTINATION ${FASTSCENE_CMAKE_DIR})
  # Before 1.0 a minor version may break callers.
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/fastscene-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/fastscene-config.cmake ${PROJECT_BINARY_DIR}/fastscene-config-version.cmake
    ${PROJECT_SOURCE_DIR}/cmake/fastscene-dependencies.cmake DESTINATION ${FASTSCENE_CMAKE_DIR} COMPONENT development)
  install(FILES ${PROJECT_BINARY_DIR}/generated/fastscene/version.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fastscene COMPONENT development)
  # Computed when it is installed, so that no edit of a header asks for a new configuration.
  install(CODE "set(SOURCES \"${PROJECT_SOURCE_DIR}/src\")
set(DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")
include(\"${PROJECT_SOURCE_DIR}/cmake/install_headers.cmake\")" COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT development)
endfunction()
