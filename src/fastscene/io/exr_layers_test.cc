// Multi-layer OpenEXR files, as written by renderers.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>

#include "fastscene/base/error.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

// 2 x 1 pixels; the k-th channel holds k + 1.
std::filesystem::path exr_with(const std::vector<std::string>& channels) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "fastscene-layers.exr";
    Imf::Header header(2, 1);
    Imf::FrameBuffer frame;
    std::vector<std::vector<float>> values;
    for (std::size_t k = 0; k < channels.size(); ++k) values.emplace_back(2, static_cast<float>(k + 1));
    for (std::size_t k = 0; k < channels.size(); ++k) {
        header.channels().insert(channels[k], Imf::Channel(Imf::FLOAT));
        frame.insert(channels[k], Imf::Slice::Make(Imf::FLOAT, values[k].data(), header.dataWindow()));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
    return path;
}

TEST(ExrLayers, RangeIsWhatIsCalledDepth) {
    EXPECT_EQ(load_float(exr_with({"A", "B", "G", "R", "Z"})).at(1, 0), 5.f);
    EXPECT_EQ(load_float(exr_with({"ViewLayer.Combined.A", "ViewLayer.Combined.R", "ViewLayer.Depth.Z"})).at(0, 0),
              3.f);
    EXPECT_EQ(load_float(exr_with({"ViewLayer.Combined.R", "ViewLayer.Depth.V"})).at(0, 0), 2.f);
    EXPECT_EQ(load_float(exr_with({"A", "distance"})).at(0, 0), 2.f);
    EXPECT_EQ(load_float(exr_with({"A", "R"})).at(0, 0), 2.f);
    for (const std::vector<std::string>& color :
         {std::vector<std::string>{"B", "G", "R"}, {"V.depth.B", "V.depth.G", "V.depth.R"}})
        EXPECT_THROW(load_float(exr_with(color)), Error) << color[0];
    EXPECT_EQ(load_float(exr_with({"anything"})).at(0, 0), 1.f);
    try {
        load_float(exr_with({"A", "normal"}));
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("found A, normal"), std::string::npos) << e.what();
    }
}

TEST(ExrLayers, ColorIsTheCombinedLayer) {
    const ImageColor color = load_light(
        exr_with({"Glossy.R", "Glossy.G", "Glossy.B", "V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Combined.A"}));
    EXPECT_EQ(color.at(1, 0), (Vec3f{4, 5, 6}));
    EXPECT_EQ(load_light(exr_with({"left.R", "left.G", "left.B"})).at(0, 0), (Vec3f{1, 2, 3}));
}

}  // namespace
}  // namespace fastscene
