# Attention through the matrix unit (AMX) is compiled for the processors that have one, whatever the rest is compiled for, and asked for at
# run time. Source flags come last on the command line, so they win over -march=native.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-march=sapphirerapids FASTSCENE_HAS_AMX)
if(FASTSCENE_HAS_AMX AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set_source_files_properties(${PROJECT_SOURCE_DIR}/src/fastscene/nn/attention_amx.cc PROPERTIES
    COMPILE_OPTIONS "-march=sapphirerapids;-Wno-uninitialized;-Wno-maybe-uninitialized")
endif()
