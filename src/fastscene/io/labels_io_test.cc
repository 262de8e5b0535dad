// Labels beside splats and in their PLY.
#include <gtest/gtest.h>

#include "fastscene/base/file.h"
#include "fastscene/io/npy.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/test_scratch.h"
#include "fastscene/io/test_splats.h"

namespace fastscene {
namespace {

TEST(Npy, ComesBackAndRefusesWhatItIsNot) {
    const std::vector<std::uint16_t> values{0, 1, 65535, 7};
    const auto file = scratch("labels.npy");
    const std::string bytes = npy_bytes(values);
    write_file(file, bytes);
    EXPECT_EQ(load_npy(file), values);
    EXPECT_EQ((bytes.size() - 8) % 64, 0u) << "NumPy aligns the values";
    write_file(file, npy_bytes({}));
    EXPECT_TRUE(load_npy(file).empty());
    std::string floats = bytes;
    floats.replace(floats.find("<u2"), 3, "<f4");
    for (const std::string& bad :
         {std::string("no numbers"), bytes.substr(0, bytes.size() - 1), bytes.substr(0, 30), floats, std::string()}) {
        write_file(file, bad);
        EXPECT_THROW(load_npy(file), Error) << bad.size();
    }
}

TEST(LabelledPly, KeepsLabelsBesideTheirSplats) {
    const Splats splats = some_splats(50, 1);
    SplatLabels labels{{}, {"what they mean"}};
    for (std::size_t i = 0; i < splats.size(); ++i) labels.values.push_back(static_cast<std::uint16_t>(1300 * i));
    const auto file = scratch("labelled.ply");
    write_file(file, splat_ply_bytes(splats, PlyBands::present, {}, labels));
    const LabelledSplats found = load_labelled_ply(file);
    EXPECT_EQ(found.labels.values, labels.values);
    EXPECT_EQ(found.labels.comments, labels.comments);
    EXPECT_EQ(found.splats.mean_m, splats.mean_m);
    // Readers that know nothing of labels see the same splats.
    EXPECT_EQ(load_splats(file).splats.mean_m, splats.mean_m);
    save_splat_ply(file, splats);
    EXPECT_TRUE(load_labelled_ply(file).labels.values.empty());
}

}  // namespace
}  // namespace fastscene
