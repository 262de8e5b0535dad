#include "fastscene/nn/runtime.h"

#include <ATen/ATen.h>
#include <gtest/gtest.h>

#include <functional>
#include <new>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

TEST(TorchErrors, AreOneLineAndLackOfMemoryIsKnown) {
    const auto caught = [](const std::function<void()>& act) {
        try {
            act();
        } catch (const std::exception& e) {
            return std::pair{short_message(e), is_lack_of_memory(e)};
        }
        return std::pair{std::string("none"), false};
    };
    const auto sizes = caught([] { (void)at::add(at::zeros({2}), at::zeros({3})); });
    EXPECT_NE(sizes.first.find("must match the size"), std::string::npos) << sizes.first;
    EXPECT_EQ(sizes.first.find('\n'), std::string::npos) << sizes.first;
    EXPECT_EQ(sizes.first.find("frame #"), std::string::npos) << sizes.first;
    EXPECT_FALSE(sizes.second);
    EXPECT_TRUE(caught([] { (void)at::empty({std::int64_t{1} << 48}, at::kFloat); }).second);
    EXPECT_TRUE(caught([] { throw std::bad_alloc(); }).second);
    EXPECT_EQ(caught([] { throw Error("a file: expected this, found that"); }).first, "a file: expected this, found that");
}

}  // namespace
}  // namespace fastscene
