// Other programs, run by name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fastscene::cli {

// Where the program lies, if it is on PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);
// Runs it with these arguments, its stdout thrown away; returns its exit code (128 + signal when killed).
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments);

}  // namespace fastscene::cli
