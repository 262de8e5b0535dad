// The inpainter "torchscript": pictures and masks as LaMa's exported file wants them.
#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/inpaint/inpaint.h"
#include "fastscene/nn/made_script.h"

namespace fastscene {
namespace {

// Composites as LaMa's file does, and paints the column's share of the width: says what it got, and where.
constexpr const char* kPaints =
    "def forward(self, image, mask):\n"
    "    assert image.size(2) % 8 == 0 and image.size(3) % 8 == 0\n"
    "    assert bool(torch.all((mask == 0) | (mask == 1)))\n"
    "    assert bool(torch.all(image >= 0)) and bool(torch.all(image <= 1))\n"
    "    across = torch.arange(image.size(3)).to(image.dtype) / image.size(3)\n"
    "    return image * (1 - mask) + mask * across.view([1, 1, 1, -1])\n";

struct Holed {
    ImageColor color;
    ImageMask hole;
};
Holed holed(int w, int h) {
    Holed p{ImageColor(w, h), ImageMask(w, h)};
    Random r(4, "torchscript");
    for (Vec3f& c : p.color.pixels) c = {r.uniform(), r.uniform(), r.uniform(0, 1.4f)};  // brighter than white, too
    for (int y = h / 4; y < h / 2; ++y)
        for (int x = w / 3; x < w; ++x) p.hole.at(x, y) = 255;
    return p;
}

TEST(TorchscriptInpainter, PadsToEightAndKeepsKnownPixels) {
    const MadeScript made(kPaints);
    const auto inpainter = make_inpainter("torchscript", made.file, "cpu", {made.file.string()});
    EXPECT_TRUE(inpainter->invents());
    const Holed p = holed(97, 61);  // padded to 104 x 64
    const ImageColor out = inpainter->fill(p.color, p.hole, {});
    for (int y = 0; y < 61; ++y)
        for (int x = 0; x < 97; ++x)
            if (!p.hole.at(x, y)) ASSERT_EQ(out.at(x, y), p.color.at(x, y));
            else ASSERT_NEAR(srgb_from_linear(out.at(x, y).y), static_cast<float>(x) / 104, 1e-4f);
}

TEST(TorchscriptInpainter, LargePicturesAreHalved) {
    const MadeScript made(kPaints);
    const auto inpainter = make_inpainter("torchscript", made.file, "cpu", {made.file.string()});
    Holed p{ImageColor(2048, 1024, Vec3f{0.5f, 0.5f, 0.5f}), ImageMask(2048, 1024)};
    for (int y = 600; y < 700; ++y)
        for (int x = 100; x < 1900; ++x) p.hole.at(x, y) = 255;
    const ImageColor out = inpainter->fill(p.color, p.hole, {});
    EXPECT_NEAR(srgb_from_linear(out.at(1000, 650).x), 0.488f, 0.01f);
    EXPECT_NEAR(srgb_from_linear(out.at(1500, 650).x), 0.732f, 0.01f);
    EXPECT_EQ(out.at(50, 650), p.color.at(50, 650));
}

TEST(TorchscriptInpainter, NeedsAFileAndTrust) {
    const MadeScript made(kPaints);
    EXPECT_THROW(make_inpainter("torchscript"), UsageError);
    EXPECT_THROW(make_inpainter("torchscript", made.file), UsageError);
    const MadeScript other("def forward(self, image, mask):\n    return mask\n");
    const Holed p = holed(64, 64);
    const auto inpainter = make_inpainter("torchscript", other.file, "cpu", {other.file.string()});
    try {
        inpainter->fill(p.color, p.hole, {});
        FAIL() << "expected an error";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("expected 3 planes of 64 x 64, found 1"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace fastscene
