#include "fastscene/base/isa.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "fastscene/base/error.h"
#include "fastscene/base/library_settings.h"

namespace fastscene {
namespace {

TEST(Isa, IsTheSmallerOfProcessorAndEnvironment) {
    for (const Isa best : {Isa::sse4, Isa::avx2, Isa::avx512}) {
        EXPECT_EQ(limited_isa(nullptr, best), best);
        EXPECT_EQ(limited_isa("", best), best);
        for (const Isa named : {Isa::sse4, Isa::avx2, Isa::avx512})
            EXPECT_EQ(limited_isa(isa_name(named), best), std::min(named, best));
    }
}

TEST(Isa, AWrongNameIsAUsageErrorThatNamesTheVariable) {
    for (const char* wrong : {"avx1024", "AVX2", "avx2 ", "baseline"}) {
        try {
            (void)limited_isa(wrong, Isa::avx512);
            FAIL() << wrong << " was taken";
        } catch (const UsageError& e) {
            EXPECT_EQ(std::string(e.what()),
                      "FASTSCENE_ISA: expected sse4, avx2 or avx512, found \"" + std::string(wrong) + "\"");
        }
    }
}

TEST(Isa, InUseIsNeverMoreThanTheProcessorHas) {
    EXPECT_LE(isa(), processor_isa());
    EXPECT_EQ(isa(), limited_isa(std::getenv("FASTSCENE_ISA"), processor_isa()));
}

TEST(LibrarySettings, LeaveLibrariesAloneWithoutALimit) { EXPECT_TRUE(library_settings(Isa::avx512).empty()); }

#if defined(__x86_64__)
TEST(LibrarySettings, SpeakToEveryLibraryUnderALimit) {
    for (const Isa limit : {Isa::sse4, Isa::avx2}) {
        const std::vector<Setting> settings = library_settings(limit);
        for (const char* name : {"ATEN_CPU_CAPABILITY", "DNNL_MAX_CPU_ISA", "ONEDNN_MAX_CPU_ISA", "OPENBLAS_CORETYPE"})
            EXPECT_EQ(std::count_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.name == name; }),
                      1)
                << name;
    }
}

// Test programs start with these settings (tests/test_main.cc), so they must be in effect here.
TEST(LibrarySettings, AreInForceInThisProgram) {
    for (const Setting& s : library_settings(isa())) {
        const char* value = std::getenv(s.name.c_str());
        ASSERT_TRUE(value) << s.name;
        EXPECT_EQ(value, s.value) << s.name;
    }
}
#endif

}  // namespace
}  // namespace fastscene
