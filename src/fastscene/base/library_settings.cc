#include "fastscene/base/library_settings.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace fastscene {
namespace {

std::string from_environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

// Several settings of the C library share one variable, separated by colons.
std::string with_tunable(const std::string& tunables, const std::string& more) {
    if (tunables.find(more) != std::string::npos) return tunables;
    return tunables.empty() ? more : tunables + ":" + more;
}

}  // namespace

std::vector<Setting> library_settings(Isa limit) {
#if defined(__x86_64__)
    if (limit == Isa::avx2)
        return {{"ATEN_CPU_CAPABILITY", "avx2"},
                {"DNNL_MAX_CPU_ISA", "AVX2"},
                {"ONEDNN_MAX_CPU_ISA", "AVX2"},
                {"OPENBLAS_CORETYPE", "Haswell"}};
    // The C library's sines and exponentials have FMA variants, whose last bits differ.
    if (limit == Isa::sse4)
        return {{"ATEN_CPU_CAPABILITY", "default"},
                {"DNNL_MAX_CPU_ISA", "SSE41"},
                {"ONEDNN_MAX_CPU_ISA", "SSE41"},
                {"OPENBLAS_CORETYPE", "Nehalem"},
                {"GLIBC_TUNABLES",
                 with_tunable(from_environment("GLIBC_TUNABLES"), "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F")}};
#endif
    return {};
}

void begin_with(const std::vector<Setting>& settings, char** argv) {
    bool anew = false;
    for (const Setting& s : settings)
        if (from_environment(s.name.c_str()) != s.value) anew |= ::setenv(s.name.c_str(), s.value.c_str(), 1) == 0;
    if (anew) ::execv("/proc/self/exe", argv);
}

void begin_within_isa(char** argv) { begin_with(library_settings(isa()), argv); }

}  // namespace fastscene
