// A command: its flags, and what it does once they are parsed. One file per command.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"

namespace fastscene::cli {

// Flags that every command has.
struct Common {
    int threads = 0;
    bool json = false;
    std::string progress = "auto";
};

// What main passes to a command.
struct Session {
    Common common;
    EventSink* events = nullptr;
    std::stop_token stop;

    Run run(std::uint64_t seed) const { return {seed, events, stop}; }
    // Prints results, the only output on stdout: JSON if --json was given, else the text.
    void print(const std::string& text, const Json& json) const;
};

struct Verb {
    CLI::App* app = nullptr;
    std::function<void(const Session&)> act;
};

Verb add_make(CLI::App& app);
Verb add_panorama(CLI::App& app);
Verb add_depth(CLI::App& app);
Verb add_walk(CLI::App& app);
Verb add_views(CLI::App& app);
Verb add_splat(CLI::App& app);
Verb add_metrics(CLI::App& app);
Verb add_evaluate(CLI::App& app);
Verb add_batch(CLI::App& app);
Verb add_render(CLI::App& app);
Verb add_convert(CLI::App& app);
Verb add_view(CLI::App& app);
Verb add_studio(CLI::App& app);
Verb add_models(CLI::App& app);
Verb add_assets(CLI::App& app);
Verb add_doctor(CLI::App& app);
Verb add_rooms(CLI::App& app);
Verb add_dataset(CLI::App& app);
Verb add_edit(CLI::App& app);
Verb add_export(CLI::App& app);
Verb add_completion(CLI::App& app);
Verb add_demo(CLI::App& app);
Verb add_version(CLI::App& app);

}  // namespace fastscene::cli
