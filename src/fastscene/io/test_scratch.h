// For tests: a temporary file specific to the running test suite.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace fastscene {

inline std::filesystem::path scratch(const std::string& name) {
    const std::filesystem::path dir = std::filesystem::path(::testing::TempDir()) / "fastscene_io_test" /
                                      ::testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
    std::filesystem::create_directories(dir);
    return dir / name;
}

}  // namespace fastscene
