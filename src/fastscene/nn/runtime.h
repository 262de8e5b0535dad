// Runtime setup of libtorch. The start scripts, or else cli/main.cc, set OMP_WAIT_POLICY=passive before it loads:
// threads waiting at a barrier then sleep instead of spinning on a core that others need.
#pragma once

namespace fastscene {

// Sets libtorch's thread count to ours (base/parallel.h) and allocates OpenBLAS's buffers. Every network calls it
// before running. Throws Error if the address space limit leaves no room for the buffers.
void use_our_threads();

}  // namespace fastscene
