#include "fastscene/weights/shipped.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

// Every model of models/ is built into the program, complete and within its size limit.
TEST(Shipped, EveryModelOfTheSourcesIsThere) {
    std::uintmax_t total = 0;
    const std::filesystem::path folder = std::filesystem::path(FASTSCENE_SOURCE_DIR) / "models";
    std::size_t files = 0;
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().extension() != ".safetensors") continue;
            ++files;
            total += entry.file_size();
            const std::string name = entry.path().stem().string();
            ASSERT_TRUE(is_shipped(name)) << name;
            std::uintmax_t bytes = 0;
            for (const auto& [key, tensor] : shipped_weights(name).tensors) {
                bytes += tensor.bytes.size();
                EXPECT_EQ(tensor.type, NumberType::f16) << name << ": " << key;
                for (const float v : tensor.floats()) ASSERT_TRUE(std::isfinite(v)) << name << ": " << key;
            }
            EXPECT_LE(bytes, entry.file_size());
            EXPECT_GT(bytes, entry.file_size() * 9 / 10);
            EXPECT_TRUE(std::filesystem::exists(folder / (name + ".md"))) << name << " has no card";
        }
    EXPECT_EQ(shipped_names().size(), files);
    EXPECT_LE(total, std::uintmax_t{24} << 20);
}

TEST(Shipped, AnUnknownNameIsToldWithThoseThatThereAre) {
    EXPECT_FALSE(is_shipped("nothing"));
    EXPECT_THROW(shipped_weights("nothing"), Error);
}

}  // namespace
}  // namespace fastscene
