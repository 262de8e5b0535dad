// How libtorch runs here. The start scripts set OMP_WAIT_POLICY=passive before it loads: threads that wait at a barrier sleep, where
// spinning ones take the core from those that work.
#pragma once

namespace fastscene {

// Gives libtorch as many threads as everything else has (base/parallel.h). Every network calls it before it runs.
void use_our_threads();

}  // namespace fastscene
