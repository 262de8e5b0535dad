#include <optional>
#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/base/isa.h"
#include "fastscene/splat/kernel.h"

namespace fastscene::splat {
namespace {

// By the flag's name for it; "baseline" (x86-64-v2) runs on every x86-64 processor.
std::optional<Isa> isa_of(std::string_view kernel) {
    if (kernel == "avx512") return Isa::avx512;
    if (kernel == "avx2") return Isa::avx2;
    if (kernel == "baseline") return Isa::sse4;
    return std::nullopt;
}

}  // namespace

const Kernel& choose_kernel(const char* name) {
    const Isa in_use = isa();
    const std::optional<Isa> named = name ? isa_of(name) : in_use;
    if (!named) throw UsageError("splat: expected the kernel avx512, avx2 or baseline, found \"{}\"", name);
    if (*named > in_use)
        throw UsageError(
            "splat: the kernel \"{}\" is not for this processor or not within FASTSCENE_ISA: expected one up to {}",
            name, isa_name(in_use));
    return *named == Isa::avx512 ? avx512::kernel() : *named == Isa::avx2 ? avx2::kernel() : baseline::kernel();
}

}  // namespace fastscene::splat
