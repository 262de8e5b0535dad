# fastscene_room(name FLOOR n USES other… LINKS libraries… SIMD files…)
#
# A room is a folder under src/fastscene/: one static library of its *.cc files and one test program of
# its *_test.cc files, linked with nothing but the rooms and libraries named here. The link list is the
# drawing in docs/architecture.md; tests/floors holds the includes against it.
function(fastscene_room name)
  cmake_parse_arguments(ROOM "" "FLOOR" "USES;LINKS" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/src/fastscene/${name})
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cc)
  file(GLOB tests CONFIGURE_DEPENDS ${folder}/*_test.cc)
  list(FILTER sources EXCLUDE REGEX "_test\\.cc$")

  if(sources)
    add_library(fastscene_${name} STATIC ${sources})
    set(scope PUBLIC)
  else()
    add_library(fastscene_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(fastscene_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  target_compile_features(fastscene_${name} ${scope} cxx_std_20)
  foreach(other ${ROOM_USES})
    target_link_libraries(fastscene_${name} ${scope} fastscene_${other})
  endforeach()
  target_link_libraries(fastscene_${name} ${scope} ${ROOM_LINKS})
  if(sources)
    target_link_libraries(fastscene_${name} PRIVATE fastscene_warnings)
  endif()

  if(tests AND FASTSCENE_TESTS)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE fastscene_${name} fastscene_warnings GTest::gtest GTest::gtest_main)
    # Half of all sources are tests, and they run once: what is saved in compiling them is worth more than their speed.
    target_compile_options(${name}_test PRIVATE -O1)
    target_compile_definitions(${name}_test PRIVATE FASTSCENE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    add_test(NAME ${name} COMMAND ${name}_test)
    set_tests_properties(${name} PROPERTIES TIMEOUT 600)
  endif()
endfunction()
