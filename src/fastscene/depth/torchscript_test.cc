// The depth backend "torchscript": what it gives networks, and what it makes of their outputs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/depth/box_layout.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/image/color.h"
#include "fastscene/nn/made_script.h"

namespace fastscene {
namespace {

// The true range of a box room is painted into the picture's red; the networks read it there.
BoxLayout room() {
    BoxLayout box;
    box.wall_m.fill(2.f);
    box.floor_m = 1.5f, box.ceiling_m = 1.f;
    return box;
}
constexpr float kWhole_m = 5;
ImageColor picture_of(const ImageF& range) {
    ImageColor out(range.width, range.height);
    for (std::size_t i = 0; i < out.size(); ++i)
        out.pixels[i] = {linear_from_srgb(range.pixels[i] / kWhole_m), 0.5f, 0.25f};
    return out;
}
float mean_error(const ImageF& a, const ImageF& b) {
    float sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(a.pixels[i] / b.pixels[i] - 1);
    return sum / static_cast<float>(a.size());
}

DepthParams params_for(const MadeScript& made) {
    DepthParams params;
    params.backend = "torchscript";
    params.weights = made.file.string();
    params.trusted = {made.file.string()};
    params.camera_height_m = 1.5f;
    params.script_width = 256;
    return params;
}

TEST(TorchscriptDepth, RangeDisparityAndMetres) {
    const ImageF range = range_of_box(room(), {256, 128});
    const ImageColor picture = picture_of(range);
    for (const auto& [body, output] : {std::pair{"    return 0.7 * x[:, 0:1]\n", "range"},
                                       {"    return 0.2 / torch.clamp(x[:, 0:1], 0.01)\n", "disparity"},
                                       {"    return x[:, 0] * 5.0\n", "metres"}}) {
        const MadeScript made(std::string("def forward(self, x):\n") + body);
        DepthParams params = params_for(made);
        params.script_output = output;
        const EstimatedRange found = make_depth_estimator(params)->estimate(picture, {});
        ASSERT_TRUE(found.range.same_size(range));
        EXPECT_LT(mean_error(found.range, range), 0.04f) << output;
        EXPECT_EQ(found.assumptions.at("backend"), "torchscript");
        EXPECT_EQ(found.assumptions.at("sha256").get<std::string>().size(), 64u);
    }
}

TEST(TorchscriptDepth, TheJsonBesideItAndNormalization) {
    const ImageF range = range_of_box(room(), {256, 128});
    // Undoes ImageNet's normalization, so that the range is right only if it was applied.
    const MadeScript made(
        "def forward(self, x):\n    return {\"a\": x, \"depth\": (x[:, 0:1] * 0.229 + 0.485) * 5.0}\n");
    write_file(
        made.file.string() + ".json",
        std::string_view("{\"output\": \"metres\", \"normalize\": \"imagenet\", \"width\": 256, \"key\": \"depth\"}"));
    DepthParams params = params_for(made);
    params.script_width = 0;
    const EstimatedRange found = make_depth_estimator(params)->estimate(picture_of(range), {});
    EXPECT_LT(mean_error(found.range, range), 0.03f);
    EXPECT_EQ(found.assumptions.at("width"), 256);
    write_file(made.file.string() + ".json", std::string_view("{\"output\": \"depth\"}"));
    EXPECT_THROW(make_depth_estimator(params), Error);
    std::filesystem::remove(made.file.string() + ".json");
}

TEST(TorchscriptDepth, TurnsHideTheSeam) {
    // Darkens towards the picture's border columns, as padding does.
    const MadeScript made(
        "def forward(self, x):\n"
        "    c = torch.arange(x.size(3)).to(x.dtype)\n"
        "    edge = torch.minimum(c, x.size(3) - 1 - c)\n"
        "    return (2.0 - torch.clamp(1 - edge / 20, 0)).view([1, 1, 1, -1]).expand(1, 1, x.size(2), x.size(3))\n");
    DepthParams params = params_for(made);
    params.script_output = "metres";
    const ImageColor picture(256, 128, Vec3f{0.5f, 0.5f, 0.5f});
    EXPECT_NEAR(make_depth_estimator(params)->estimate(picture, {}).range.at(0, 64), 1.f, 0.1f);
    params.tta = 4;
    EXPECT_NEAR(make_depth_estimator(params)->estimate(picture, {}).range.at(0, 64), 1.75f, 0.1f);
}

TEST(TorchscriptDepth, RefusesWhatItCannotUse) {
    const ImageColor picture(256, 128, Vec3f{0.5f, 0.5f, 0.5f});
    for (const auto& [body, said] : {std::pair{"    return x\n", "one plane twice as wide as high"},
                                     {"    return x[:, 0] / 0.0\n", "finite numbers"},
                                     {"    return x[:, 0] * 0.0\n", "positive numbers"}}) {
        const MadeScript made(std::string("def forward(self, x):\n") + body);
        try {
            make_depth_estimator(params_for(made))->estimate(picture, {});
            FAIL() << "expected an error: " << body;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find(made.file.string()), std::string::npos) << e.what();
        }
    }
    DepthParams params;
    params.backend = "torchscript";
    EXPECT_THROW(make_depth_estimator(params), UsageError);
    const MadeScript made("def forward(self, x):\n    return x[:, 0]\n");
    params.weights = made.file.string();
    EXPECT_THROW(make_depth_estimator(params), UsageError);  // not trusted
}

}  // namespace
}  // namespace fastscene
