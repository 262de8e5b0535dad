// The inner loops for this instruction set; its compiler flags are in simd.cmake.
#define FASTSCENE_ISA avx2
#include "fastscene/splat/isa_kernel.h"
