#include "fastscene/nn/runtime.h"

#include <ATen/Parallel.h>
#include <c10/util/Exception.h>

#include <algorithm>
#include <new>

#include "fastscene/base/parallel.h"

namespace fastscene {

void use_our_threads() {
    const int threads = std::max(1, thread_count());
    if (at::get_num_threads() != threads) at::set_num_threads(threads);
}

std::string short_message(const std::exception& error) {
    const auto* torch = dynamic_cast<const c10::Error*>(&error);
    if (!torch) return error.what();
    std::string text = torch->what_without_backtrace();
    while (!text.empty() && std::string_view("\n ").find(text.back()) != std::string_view::npos) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return "a computation failed: " + text;
}

bool is_lack_of_memory(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) || dynamic_cast<const c10::OutOfMemoryError*>(&error)) return true;
    const auto* torch = dynamic_cast<const c10::Error*>(&error);  // the allocator of the CPU has no class of its own
    return torch && std::string_view(torch->what_without_backtrace()).find("DefaultCPUAllocator") != std::string_view::npos;
}

}  // namespace fastscene
