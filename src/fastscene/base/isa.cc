#include "fastscene/base/isa.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

constexpr Isa kAll[] = {Isa::sse4, Isa::avx2, Isa::avx512};

}  // namespace

const char* isa_name(Isa isa) { return isa == Isa::avx512 ? "avx512" : isa == Isa::avx2 ? "avx2" : "sse4"; }

Isa processor_isa() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                    __builtin_cpu_supports("bmi2");
    const bool v4 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
    return v3 && v4 ? Isa::avx512 : v3 ? Isa::avx2 : Isa::sse4;
#else
    return Isa::sse4;
#endif
}

Isa compiled_isa() {
#if defined(__AVX512F__)
    return Isa::avx512;
#elif defined(__AVX2__)
    return Isa::avx2;
#else
    return Isa::sse4;
#endif
}

Isa limited_isa(const char* text, Isa best) {
    if (!text || !*text) return best;
    for (const Isa named : kAll)
        if (std::string_view(text) == isa_name(named)) return std::min(named, best);
    throw UsageError("FASTSCENE_ISA: expected sse4, avx2 or avx512, found \"{}\"", text);
}

Isa isa() {
    static const Isa in_use = limited_isa(std::getenv("FASTSCENE_ISA"), processor_isa());
    return in_use;
}

}  // namespace fastscene
