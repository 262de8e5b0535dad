#include "fastscene/base/failure.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace fastscene {
namespace {

struct Foreign : std::runtime_error {
    using std::runtime_error::runtime_error;
};

TEST(Failure, OnlyItsOwnLibraryReadsAnException) {
    add_failure_reader([](const std::exception& error) -> std::optional<Failure> {
        if (!dynamic_cast<const Foreign*>(&error)) return {};
        return Failure{"a foreign failure", true};
    });
    const Foreign foreign("frame #0\nframe #1");
    EXPECT_EQ(short_message(foreign), "a foreign failure");
    EXPECT_TRUE(is_lack_of_memory(foreign));
    const std::runtime_error ours("a file: expected this, found that");
    EXPECT_EQ(short_message(ours), "a file: expected this, found that");
    EXPECT_FALSE(is_lack_of_memory(ours));
    EXPECT_TRUE(is_lack_of_memory(std::bad_alloc()));
}

}  // namespace
}  // namespace fastscene
