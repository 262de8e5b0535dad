// The math libraries must respect FASTSCENE_ISA: none may use a larger instruction set.
#include <ATen/Version.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <string>

#include "fastscene/base/isa.h"

namespace fastscene::nn {
namespace {

// Looks up a function in a library linked through libtorch, whose headers are not needed otherwise; null if this
// libtorch uses another library.
template <class Function>
Function* exported(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, name));
}

TEST(Libraries, TorchKeepsToTheInstructionSet) {
    const std::string config = at::show_config();
    const auto usage = config.find("CPU capability usage: ");
    ASSERT_NE(usage, std::string::npos) << config;
    const std::string used = config.substr(usage, config.find('\n', usage) - usage);
    if (isa() < Isa::avx512) EXPECT_EQ(used.find("AVX512"), std::string::npos) << used;
    if (isa() < Isa::avx2) EXPECT_EQ(used.find("AVX2"), std::string::npos) << used;
}

TEST(Libraries, OpenBlasKeepsToTheInstructionSet) {
    auto* const core = exported<const char*()>("openblas_get_corename");
    if (!core) GTEST_SKIP() << "no OpenBLAS here";
    const std::string name = core();
    if (isa() == Isa::avx2) EXPECT_EQ(name, "Haswell");
    if (isa() == Isa::sse4) EXPECT_EQ(name, "Nehalem");
}

TEST(Libraries, OneDnnKeepsToTheInstructionSet) {
    auto* const effective = exported<int()>("dnnl_get_effective_cpu_isa");
    if (!effective) GTEST_SKIP() << "no oneDNN here";
    constexpr int kSse41 = 0x1, kAvx2 = 0x7;  // dnnl_cpu_isa_t: bit sets, each includes its predecessors
    if (isa() == Isa::avx2) EXPECT_EQ(effective(), kAvx2);
    if (isa() == Isa::sse4) EXPECT_EQ(effective(), kSse41);
}

}  // namespace
}  // namespace fastscene::nn
