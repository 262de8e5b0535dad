# Attention through the matrix unit (AMX) is compiled for the processors that have one, whatever the rest is compiled for, and asked for at
# run time.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-march=sapphirerapids FASTSCENE_HAS_AMX)
if(FASTSCENE_HAS_AMX AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  fastscene_own_flags(nn/attention_amx.cc -march=sapphirerapids -Wno-uninitialized -Wno-maybe-uninitialized)
endif()
