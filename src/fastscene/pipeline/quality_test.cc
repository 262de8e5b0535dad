#include "fastscene/pipeline/quality.h"

#include <gtest/gtest.h>

namespace fastscene {
namespace {

TEST(Quality, PresetsAreWithinBoundsAndGrow) {
    double last = 0;
    for (const std::string& name : qualities()) {
        const SceneParams params = params_of_quality(name);
        EXPECT_NO_THROW(check_params(params)) << name;
        const double work = static_cast<double>(params.panorama.width) * params.splat.steps * params.splat.count;
        EXPECT_GT(work, last) << name;
        last = work;
        EXPECT_GE(params.views.points, params.splat.count) << name;
    }
    EXPECT_THROW(params_of_quality("best"), UsageError);
}

TEST(Quality, StandardIsWhatTheReadmePromises) {
    const SceneParams params = params_of_quality("standard");
    EXPECT_EQ(params.panorama.width, 2048);
    EXPECT_GE(params.splat.count, 200'000);
}

TEST(Quality, ParamsSurviveJson) {
    SceneParams params = params_of_quality("high");
    params.panorama.trace.cell_m = 0.1f / 3;
    params.walk.reach_m = 0.123f;
    const Json json = Json::parse(json_of_params(params).dump());
    EXPECT_EQ(json_of_params(params_from_json(json, params_of_quality("draft"))), json_of_params(params));
}

TEST(Quality, MissingFieldsKeepTheirPreset) {
    const SceneParams params = params_from_json(Json::parse(R"({"splat": {"steps": 7}})"), params_of_quality("draft"));
    EXPECT_EQ(params.splat.steps, 7);
    EXPECT_EQ(params.splat.count, params_of_quality("draft").splat.count);
    EXPECT_THROW(params_from_json(Json::parse(R"({"splat": {"steps": "x"}})"), params), Error);
}

TEST(Quality, OddWidthsAreRefused) {
    SceneParams params = params_of_quality("draft");
    params.panorama.width = 1001;
    EXPECT_THROW(check_params(params), UsageError);
}

}  // namespace
}  // namespace fastscene
