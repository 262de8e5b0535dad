// What every depth backend promises, asked of each that is registered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fastscene/depth/estimator.h"

namespace fastscene {
namespace {

DepthParams params_for(const std::string& backend) {
    DepthParams params;
    params.backend = backend;
    params.tta = 1;
    return params;
}

// A gray room under a bright ceiling, with a window's edge in it.
ImageColor some_picture(EquirectSize size) {
    ImageColor color(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float v = y < size.height / 3 ? 0.8f : y > 2 * size.height / 3 ? 0.2f : 0.5f;
            color.at(x, y) = x > size.width / 4 && x < size.width / 3 ? Vec3f{0.9f, 0.9f, 1.f} : Vec3f{v, v, v};
        }
    return color;
}

class EveryDepthBackend : public testing::TestWithParam<DepthBackend> {
  protected:
    void SetUp() override {
        params_ = params_for(GetParam().name);
        if (GetParam().ready && !GetParam().ready(params_)) GTEST_SKIP() << "its weights are not here";
    }
    DepthParams params_;
    const fastscene::Run run_;
};

TEST_P(EveryDepthBackend, GivesMetresOfThePicturesSize) {
    for (const EquirectSize size : {EquirectSize{128, 64}, EquirectSize{200, 100}}) {
        const EstimatedRange found = make_depth_estimator(params_)->estimate(some_picture(size), run_);
        ASSERT_EQ(found.range.width, size.width);
        ASSERT_EQ(found.range.height, size.height);
        for (const float r : found.range.pixels) ASSERT_TRUE(std::isfinite(r) && r > 0) << r;
        EXPECT_EQ(found.assumptions.at("backend"), GetParam().name);
    }
}

TEST_P(EveryDepthBackend, IsDeterministic) {
    const auto estimator = make_depth_estimator(params_);
    const ImageColor picture = some_picture({128, 64});
    const ImageF first = estimator->estimate(picture, run_).range;
    EXPECT_EQ(estimator->estimate(picture, run_).range, first);
    EXPECT_EQ(make_depth_estimator(params_)->estimate(picture, run_).range, first);
}

TEST_P(EveryDepthBackend, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const auto estimator = make_depth_estimator(params_);
    EXPECT_THROW(estimator->estimate(some_picture({128, 64}), fastscene::Run{0, nullptr, stop.get_token()}), Stopped);
}

TEST_P(EveryDepthBackend, IsAChoiceOfTheFlag) {
    EXPECT_FALSE(GetParam().about.empty());
    const std::vector<std::string> names = depth_choices();
    EXPECT_EQ(std::count(names.begin(), names.end(), GetParam().name), 1);
    EXPECT_NE(about_depth_choices().find(GetParam().name + ": " + GetParam().about), std::string::npos);
    check_fields("depth", params_);
}

INSTANTIATE_TEST_SUITE_P(All, EveryDepthBackend, testing::ValuesIn(registered<DepthBackend>()),
                         [](const auto& info) { return info.param.name; });

TEST(DepthBackends, AnUnknownNameIsToldTheNames) {
    try {
        make_depth_estimator(params_for("sonar"));
        FAIL() << "expected an error";
    } catch (const UsageError& e) {
        EXPECT_EQ(std::string(e.what()),
                  "--depth-backend: expected da2, egformer, layout, prior or torchscript, found \"sonar\"");
    }
}

// Without weights, auto takes what needs none; the baseline only by its name.
TEST(DepthBackends, AutoTakesTheBestThatIsReady) {
    std::vector<std::string> looked_for;
    for (const DepthBackend* backend : depth_backends_with_models({})) looked_for.push_back(backend->name);
    EXPECT_EQ(looked_for, (std::vector<std::string>{"da2", "egformer"}));
    EXPECT_TRUE(depth_backends_with_models(params_for("layout")).empty());
    const bool built_in = registered_entry<DepthBackend>("", "egformer").ready({});
    EXPECT_EQ(depth_backend_of({}).name, built_in ? "egformer" : "layout");
    EXPECT_EQ(depth_backend_of(params_for("prior")).name, "prior");
}

}  // namespace
}  // namespace fastscene
