# Attention in bfloat16 is compiled for the processors that multiply such numbers, by their vectors or by a matrix unit (AMX), whatever the rest
# is compiled for, and asked for at run time.
include(CheckCXXCompilerFlag)
set(FASTSCENE_BF16_FLAGS -march=x86-64-v4 -mavx512bf16 -mamx-tile -mamx-bf16)
string(REPLACE ";" " " FASTSCENE_BF16_TEST "${FASTSCENE_BF16_FLAGS}")
check_cxx_compiler_flag("${FASTSCENE_BF16_TEST}" FASTSCENE_HAS_BF16)
if(FASTSCENE_HAS_BF16 AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  fastscene_own_flags(nn/attention_bf16.cc ${FASTSCENE_BF16_FLAGS} -Wno-uninitialized -Wno-maybe-uninitialized)
endif()
