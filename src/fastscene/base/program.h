// Other programs, run by name (ffmpeg, colmap, splat-transform): always optional, never linked.
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace fastscene {

// Where the program lies, if it is on PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);

struct ProgramOptions {
    std::filesystem::path log;             // stdout and stderr go there; empty: stdout is thrown away, stderr is ours
    std::vector<std::string> environment;  // NAME=value, beside what this process has
    std::stop_token stop;                  // a request ends the program (SIGTERM), and run_program throws Stopped
};
// Runs it with these arguments and waits; returns its exit code (128 + signal when killed). Throws Error when it cannot
// be run.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const ProgramOptions& options = {});

}  // namespace fastscene
