// Error: the outside world is wrong (a file, a flag, a prompt, the disk). The message names the
// place, what was expected and what was found. Our own mistakes are FASTSCENE_CHECK (check.h);
// a thing that may be absent is std::optional.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace fastscene {

// The run failed: the program ends with exit code 1.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
    template <class... Args>
    requires(sizeof...(Args) > 0) explicit Error(fmt::format_string<Args...> format, Args&&... args)
        : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

// The request itself is wrong (flag, verb, prompt): the program ends with exit code 2.
struct UsageError : Error {
    using Error::Error;
};

// The user (or the cluster) asked the program to stop; what is finished stays.
struct Stopped : std::runtime_error {
    Stopped() : std::runtime_error("stopped") {}
};

}  // namespace fastscene
