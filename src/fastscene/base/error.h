// Error: the outside world is wrong (a file, a flag, a prompt, the disk). The message names the place, expected and
// actual. Programming errors are FASTSCENE_CHECK (check.h); optional values are std::optional.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace fastscene {

// The run failed: the program exits with code 1.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
    template <class... Args>
    requires(sizeof...(Args) > 0) explicit Error(fmt::format_string<Args...> format, Args&&... args)
        : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

// The request itself is invalid (flag, command, prompt): the program exits with code 2.
struct UsageError : Error {
    using Error::Error;
};

// The user (or the cluster) asked the program to stop; finished work is kept.
struct Stopped : std::runtime_error {
    Stopped() : std::runtime_error("stopped") {}
};

}  // namespace fastscene
