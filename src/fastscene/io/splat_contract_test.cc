// What every splat format promises, asked of each that is registered: a new one is held to it by being there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "fastscene/base/file.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/test_scratch.h"
#include "fastscene/io/test_splats.h"

namespace fastscene {
namespace {

class EverySplatFormat : public testing::TestWithParam<SplatFormat> {
  protected:
    const SplatFormat& format() const { return GetParam(); }
    std::filesystem::path file(const std::string& name) const { return scratch(name + format().ending); }
    LoadedSplats saved_and_loaded(const Splats& splats) const {
        save_splats(file("contract"), splats);
        return load_splats(file("contract"));
    }
    // Formats that sort their splats give them back in another order: each original has its nearest.
    Splats in_order_of(const Splats& original, const Splats& back) const {
        if (format().keeps_order) return back;
        std::vector<std::uint32_t> order;
        for (const Vec3f p : original.mean_m)
            order.push_back(static_cast<std::uint32_t>(
                std::min_element(back.mean_m.begin(), back.mean_m.end(),
                                 [&](Vec3f a, Vec3f b) { return length(a - p) < length(b - p); }) -
                back.mean_m.begin()));
        return chosen(back, order);
    }
    std::string refusal(const std::function<void()>& act) const {
        try {
            act();
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    }
};

constexpr float kRounding = 2e-5f;

void expect_near(const Splats& back, const Splats& splats, const SplatPrecision& within) {
    const auto near = [](Vec3f a, Vec3f b, float step, const char* what, std::size_t i) {
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], step + kRounding) << what << " of splat " << i;
    };
    for (std::size_t i = 0; i < splats.size(); ++i) {
        near(back.mean_m[i], splats.mean_m[i], within.mean_m, "position", i);
        near(back.log_scale[i], splats.log_scale[i], within.log_scale, "scale", i);
        near(back.sh0[i], splats.sh0[i], within.sh0, "color", i);
        EXPECT_NEAR(back.opacity_logit[i], splats.opacity_logit[i], within.opacity_logit + kRounding);
        const Mat3f a = matrix_of(back.rotation[i]), b = matrix_of(splats.rotation[i]);
        for (std::size_t axis = 0; axis < 3; ++axis)  // an axis and its opposite are the same Gaussian
            EXPECT_LT(std::min(length(a.column(axis) - b.column(axis)), length(a.column(axis) + b.column(axis))),
                      within.rotation + kRounding)
                << "rotation of splat " << i;
    }
    for (std::size_t i = 0; i < splats.sh_rest.size(); ++i)
        ASSERT_NEAR(back.sh_rest[i], splats.sh_rest[i], within.sh_rest + kRounding) << "harmonic " << i;
}

TEST_P(EverySplatFormat, SaysWhatItIs) {
    EXPECT_TRUE(format().ending.starts_with('.'));
    EXPECT_FALSE(format().about.empty());
    EXPECT_FALSE(format().readers.empty());
    EXPECT_EQ(splat_format_of_name("A" + format().ending)->name, format().name);
    std::string upper = format().ending;
    std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) { return std::toupper(c); });
    EXPECT_EQ(splat_format_of_name("a" + upper)->name, format().name);
    EXPECT_NE(splat_endings().find(format().ending), std::string::npos);
}

TEST_P(EverySplatFormat, IsInTheDocs) {
    const std::string row = fmt::format("| `{}` | {} | {} | {} | {} |", format().ending, format().about,
                                        format().sh_degree ? fmt::format("0-{}", format().sh_degree) : "0",
                                        axes_in_words(format().file_from_world), format().readers);
    EXPECT_NE(read_file(std::string(FASTSCENE_SOURCE_DIR) + "/docs/formats.md").find("\n" + row + "\n"),
              std::string::npos)
        << "docs/formats.md: expected this row:\n"
        << row;
}

TEST_P(EverySplatFormat, ComesBackWithinItsPrecision) {
    for (const std::size_t count : {1, 700})
        for (int degree = 0; degree <= 3; ++degree) {
            Splats splats = some_splats(count, degree);
            const LoadedSplats loaded = saved_and_loaded(splats);
            EXPECT_EQ(loaded.format->name, format().name);
            EXPECT_EQ(loaded.cleaned.dropped, 0u);
            reduce_sh(splats, format().sh_degree);
            ASSERT_EQ(loaded.splats.size(), count);
            ASSERT_EQ(loaded.splats.sh_degree, splats.sh_degree);
            expect_near(in_order_of(splats, loaded.splats), splats, format().precision);
        }
}

TEST_P(EverySplatFormat, KeepsAntialiasing) {
    for (const bool antialias : {false, true}) {
        Splats splats = some_splats(20, 0);
        splats.filter.antialias = antialias;
        EXPECT_EQ(saved_and_loaded(splats).splats.filter.antialias, antialias && format().antialias);
    }
}

TEST_P(EverySplatFormat, KeepsTheLowPass) {
    const float usual = FootprintFilter{}.low_pass_px2;
    for (const float low_pass : {usual, 0.125f}) {
        Splats splats = some_splats(20, 0);
        splats.filter.low_pass_px2 = low_pass;
        EXPECT_EQ(saved_and_loaded(splats).splats.filter.low_pass_px2, format().low_pass ? low_pass : usual);
    }
}

TEST_P(EverySplatFormat, WritesTheSameBytesTwice) {
    save_splats(file("once"), some_splats(300, 2));
    save_splats(file("twice"), some_splats(300, 2));
    EXPECT_EQ(read_file(file("once")), read_file(file("twice")));
}

TEST_P(EverySplatFormat, HoldsNoSplatsOrSaysSo) {
    if (format().empty) {
        EXPECT_EQ(saved_and_loaded({}).splats.size(), 0u);
    } else {
        const std::string said = refusal([&] { save_splats(file("none"), {}); });
        EXPECT_NE(said.find(file("none").string()), std::string::npos) << said;
        EXPECT_FALSE(std::filesystem::exists(file("none")));
    }
}

TEST_P(EverySplatFormat, RefusesToWriteWhatIsNotFinite) {
    Splats splats = some_splats(3, 1);
    splats.sh_rest[12] = std::numeric_limits<float>::quiet_NaN();
    const std::string said = refusal([&] { save_splats(file("nan"), splats); });
    EXPECT_NE(said.find(file("nan").string()), std::string::npos) << said;
    EXPECT_NE(said.find("splat 1 of 3"), std::string::npos) << said;
    EXPECT_FALSE(std::filesystem::exists(file("nan")));
}

TEST_P(EverySplatFormat, RefusesAFileThatEndsTooEarly) {
    save_splats(file("whole"), some_splats(40, 1));
    const std::string whole = read_file(file("whole"));
    for (const std::size_t missing : {std::size_t{1}, whole.size() / 3 + 1, whole.size() - 5}) {
        write_file(file("cut"), whole.substr(0, whole.size() - missing));
        const std::string said = refusal([&] { load_splats(file("cut")); });
        EXPECT_NE(said.find(file("cut").string()), std::string::npos) << missing << " missing: " << said;
    }
}

// Splats of a scene whose middle is not the origin, turned by no symmetry: the axes must be undone on reading.
TEST_P(EverySplatFormat, KeepsTheWorldsFrame) {
    Splats splats = some_splats(1, 0);
    splats.mean_m[0] = {1, 2, 3};
    const Vec3f p = saved_and_loaded(splats).splats.mean_m[0];
    EXPECT_LT(length(p - splats.mean_m[0]), 3 * format().precision.mean_m + kRounding);
    EXPECT_FALSE(axes_in_words(format().file_from_world).empty());
}

INSTANTIATE_TEST_SUITE_P(All, EverySplatFormat, testing::ValuesIn(registered<SplatFormat>()),
                         [](const auto& info) { return info.param.name; });

TEST(SplatFormatNames, TheLongerEndingCounts) {
    EXPECT_EQ(splat_format_of_name("a.compressed.ply")->name, "compressed_ply");
    EXPECT_EQ(splat_format_of_name("compressed.ply")->name, "ply");
    EXPECT_EQ(splat_format_of_name("a.xyz"), nullptr);
    try {
        save_splats(scratch("a.xyz"), some_splats(1, 0));
        FAIL() << "expected an error";
    } catch (const UsageError& e) {
        for (const SplatFormat& format : registered<SplatFormat>())
            EXPECT_NE(std::string(e.what()).find(format.ending), std::string::npos) << e.what();
    }
}

TEST(SplatFormatNames, AxesInWords) {
    EXPECT_EQ(axes_in_words({}), "x right, y down, z forward");
    EXPECT_EQ(axes_in_words(registered_entry<SplatFormat>("format", "spz").file_from_world), "x right, y up, z back");
    EXPECT_EQ(axes_in_words(registered_entry<SplatFormat>("format", "glb").file_from_world), "x left, y up, z forward");
}

}  // namespace
}  // namespace fastscene
