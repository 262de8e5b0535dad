// What an exception means to people: one line, and whether memory ran out. Libraries whose exceptions say more than
// people can use, such as libtorch's with their stack traces, add a reader when they are loaded.
#pragma once

#include <exception>
#include <optional>
#include <string>

namespace fastscene {

// An exception's message in one line.
std::string short_message(const std::exception& error);
// Whether it is an out-of-memory error, whatever threw it.
bool is_lack_of_memory(const std::exception& error);

struct Failure {
    std::string message;
    bool lack_of_memory = false;
};
// Empty: not an exception of that library.
using FailureReader = std::optional<Failure> (*)(const std::exception&);
void add_failure_reader(FailureReader reader);

}  // namespace fastscene
