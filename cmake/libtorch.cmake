# What a target needs besides libtorch itself. libtorch comes from anywhere: Debian's package, or an official build with
# CUDA (-DCMAKE_PREFIX_PATH=…).
set(FASTSCENE_CUDA_ARCH all-major CACHE STRING "What nvcc's -arch= says: all-major, native, sm_90 …")

# fastscene_own_headers(target own… TORCH includes…): an official libtorch brings headers of libraries that the program
# links in another version. Those in the folders `own` are found first.
function(fastscene_own_headers target)
  cmake_parse_arguments(HEADERS "" "" "OWN;TORCH" ${ARGN})
  set(first ${PROJECT_BINARY_DIR}/own_headers)
  file(MAKE_DIRECTORY ${first})
  foreach(name fmt nlohmann)
    foreach(folder ${HEADERS_TORCH})
      foreach(own ${HEADERS_OWN})
        if(EXISTS ${folder}/${name} AND EXISTS ${own}/${name} AND NOT EXISTS ${first}/${name} AND NOT folder STREQUAL own)
          file(CREATE_LINK ${own}/${name} ${first}/${name} SYMBOLIC)
        endif()
      endforeach()
    endforeach()
  endforeach()
  target_include_directories(${target} SYSTEM BEFORE PUBLIC ${first})
endfunction()

# fastscene_cuda(target): the sources of nn that know CUDA, for a libtorch with CUDA: only such a build can include its
# headers. The kernels of ours want CUDA's compiler (FASTSCENE_NVCC=NO: without), and the networks do without them.
function(fastscene_cuda target)
  get_filename_component(root ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../src ABSOLUTE)
  set(nn ${root}/fastscene/nn)
  set_property(SOURCE ${nn}/libtorch.cc ${nn}/replay.cc APPEND PROPERTY COMPILE_DEFINITIONS FASTSCENE_CUDA)
  find_program(FASTSCENE_NVCC nvcc HINTS ${CUDA_TOOLKIT_ROOT_DIR}/bin ${CUDAToolkit_BIN_DIR} ${FASTSCENE_CUDA_TOOLKIT}/bin /usr/local/cuda/bin)
  if(NOT FASTSCENE_NVCC)
    message(STATUS "No nvcc: the networks use libtorch's kernels only")
    return()
  endif()
  set(object ${PROJECT_BINARY_DIR}/kernels.o)
  add_custom_command(OUTPUT ${object}
    COMMAND ${FASTSCENE_NVCC} -c -O3 -std=c++17 -arch=${FASTSCENE_CUDA_ARCH} -ccbin ${CMAKE_CXX_COMPILER} --compiler-options -fPIC
      -I${root} ${nn}/kernels.cu -o ${object}
    DEPENDS ${nn}/kernels.cu ${nn}/kernels.h VERBATIM)
  set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  target_sources(${target} PRIVATE ${object})
  set_property(SOURCE ${nn}/fused.cc APPEND PROPERTY COMPILE_DEFINITIONS FASTSCENE_KERNELS)
  set_target_properties(${target} PROPERTIES FASTSCENE_OBJECTS ${object})
endfunction()
