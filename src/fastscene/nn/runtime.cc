#include "fastscene/nn/runtime.h"

#include <ATen/Parallel.h>

#include <algorithm>

#include "fastscene/base/parallel.h"

namespace fastscene {

void use_our_threads() {
    const int threads = std::max(1, thread_count());
    if (at::get_num_threads() != threads) at::set_num_threads(threads);
}

}  // namespace fastscene
