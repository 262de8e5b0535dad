// Runs other programs by name (ffmpeg, colmap): always optional, never linked.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace fastscene {

// The program's path, if it is on PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);

struct ProgramOptions {
    std::filesystem::path log;             // receives stdout and stderr; empty: stdout is discarded, stderr inherited
    std::vector<std::string> environment;  // NAME=value, in addition to the inherited environment
    std::stop_token stop;  // a stop request terminates the program (SIGTERM), and run_program throws Stopped
    std::function<void(int pid)> started = {};  // called once it runs
};
// Runs it with these arguments and waits; returns its exit code (128 + signal if killed). Throws Error if it cannot be
// started.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const ProgramOptions& options = {});

}  // namespace fastscene
