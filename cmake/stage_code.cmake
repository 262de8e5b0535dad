# What code each stage of the pipeline runs, so that a finished stage is made again when that code has changed
# (pipeline/stage_code.h).
#
#   fastscene_stage(walk pipeline/stage_walk.cc …)   the sources that the stage's work starts in
#   fastscene_hash_stage_code(target)                after all modules: the generated header, for `target`
#
# A module below layer 6 counts whole: its sources with all they embed, and its headers. Layers 6 and above hold all
# stages side by side, so there only the files count that the stage's sources include, each with its .cc. What each
# module links is what its fastscene_module() USES.
set(FASTSCENE_FIRST_SHARED_LAYER 6)

function(fastscene_stage name)
  set_property(GLOBAL APPEND PROPERTY FASTSCENE_STAGES ${name})
  set_property(GLOBAL PROPERTY FASTSCENE_STAGE_${name} ${ARGN})
endfunction()

# All that a module is made from: what its target compiles, what those sources embed, its headers.
function(fastscene_files_of_module name out)
  set(folder ${PROJECT_SOURCE_DIR}/src/fastscene/${name})
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${folder}/*.h)
  list(FILTER files EXCLUDE REGEX "/test_[^/]*$")
  get_target_property(sources fastscene_${name} SOURCES)
  foreach(source ${sources})
    if(NOT source OR source MATCHES "^\\$<|cmake_pch")
      continue()
    endif()
    get_filename_component(source ${source} ABSOLUTE)
    list(APPEND files ${source})
    get_source_file_property(embedded ${source} OBJECT_DEPENDS)
    if(embedded)
      list(APPEND files ${embedded})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES files)
  list(SORT files)
  set(${out} "${files}" PARENT_SCOPE)
endfunction()

function(fastscene_hash_stage_code target)
  get_property(modules GLOBAL PROPERTY FASTSCENE_MODULES)
  get_property(stages GLOBAL PROPERTY FASTSCENE_STAGES)
  set(lines "set(modules ${modules})\nset(stages ${stages})\n")
  set(all "")
  set(shared "")
  foreach(module ${modules})
    fastscene_files_of_module(${module} files)
    get_target_property(uses fastscene_${module} FASTSCENE_USES)
    if(NOT uses)
      set(uses "")
    endif()
    list(APPEND all ${files})
    string(APPEND lines "set(files_${module} ${files})\nset(uses_${module} ${uses})\n")
    get_property(layer GLOBAL PROPERTY FASTSCENE_LAYER_${module})
    if(layer GREATER_EQUAL FASTSCENE_FIRST_SHARED_LAYER)
      list(APPEND shared ${module})
    endif()
  endforeach()
  string(APPEND lines "set(shared ${shared})\n")
  foreach(stage ${stages})
    get_property(sources GLOBAL PROPERTY FASTSCENE_STAGE_${stage})
    string(APPEND lines "set(sources_${stage} ${sources})\n")
  endforeach()
  set(list ${PROJECT_BINARY_DIR}/generated/stage_code.cmake)
  file(CONFIGURE OUTPUT ${list} CONTENT "${lines}" @ONLY)

  set(generated ${PROJECT_BINARY_DIR}/generated/fastscene/build_sources.h)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/generated/fastscene)
  add_custom_command(OUTPUT ${generated}.stamp
    BYPRODUCTS ${generated}
    COMMAND ${CMAKE_COMMAND} -DLIST=${list} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DBINARY_DIR=${PROJECT_BINARY_DIR}
      -DOUTPUT=${generated} -DVERSION=${PROJECT_VERSION}
      "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" -DBUILD_TYPE=${CMAKE_BUILD_TYPE}
      -P ${PROJECT_SOURCE_DIR}/cmake/build_sources.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${generated}.stamp
    DEPENDS ${all} ${list} ${PROJECT_SOURCE_DIR}/cmake/build_sources.cmake
    COMMENT "Hashing the code of each stage" VERBATIM)
  add_custom_target(fastscene_build_sources DEPENDS ${generated}.stamp)
  add_dependencies(${target} fastscene_build_sources)
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated)
endfunction()
