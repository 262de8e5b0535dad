#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/splat/kernel.h"

namespace fastscene::splat {
namespace {

bool runs(std::string_view name) {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (name == "avx512")
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
    if (name == "avx2") return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
    return name == "baseline";
}

}  // namespace

const Kernel& choose_kernel(const char* name) {
    if (name && !runs(name)) throw UsageError("splat: this processor cannot run the \"{}\" kernel", name);
    const std::string_view want = name ? name : runs("avx512") ? "avx512" : runs("avx2") ? "avx2" : "baseline";
    return want == "avx512" ? avx512::kernel() : want == "avx2" ? avx2::kernel() : baseline::kernel();
}

}  // namespace fastscene::splat
