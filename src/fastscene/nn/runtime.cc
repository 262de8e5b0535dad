#include "fastscene/nn/runtime.h"

#include <ATen/ATen.h>
#include <ATen/Parallel.h>
#include <c10/util/Exception.h>
#include <sys/mman.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/base/failure.h"
#include "fastscene/base/parallel.h"

namespace fastscene {
namespace {

// The buffer that OpenBLAS allocates per thread. Where it cannot (`ulimit -v`), OpenBLAS retries forever.
constexpr std::size_t kWorkspaceMib = 128;

void take_workspace(int threads) {
    const std::size_t mib = (kWorkspaceMib + 1) * static_cast<std::size_t>(threads);
    void* const room = ::mmap(nullptr, mib << 20, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED)
        throw Error(
            "memory: expected {} MiB of address space for matrix products ({} threads), found less: raise the limit "
            "(ulimit -v), or use fewer --threads",
            mib, threads);
    ::munmap(room, mib << 20);
    // Forces the allocation now; the product is large enough for the kernels that use the buffer.
    const at::Tensor square = at::zeros({128, 128});
    at::mm(square, square);
}

// libtorch's messages have a stack trace, which what() includes.
std::optional<Failure> read_failure(const std::exception& error) {
    const auto* torch = dynamic_cast<const c10::Error*>(&error);
    if (!torch) return {};
    std::string text = torch->what_without_backtrace();
    // The CPU allocator has no exception class of its own.
    const bool lack_of_memory = dynamic_cast<const c10::OutOfMemoryError*>(&error) ||
                                text.find("DefaultCPUAllocator") != std::string::npos;
    while (!text.empty() && std::string_view("\n ").find(text.back()) != std::string_view::npos) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return Failure{"a computation failed: " + text, lack_of_memory};
}

[[maybe_unused]] const bool failures_are_read = (add_failure_reader(read_failure), true);

}  // namespace

void use_our_threads() {
    const int threads = std::max(1, thread_count());
    if (at::get_num_threads() != threads) at::set_num_threads(threads);
    static std::once_flag taken;
    std::call_once(taken, take_workspace, threads);
}

}  // namespace fastscene
