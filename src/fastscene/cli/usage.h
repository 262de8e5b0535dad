// Error messages for invalid arguments: where, expected, actual.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fastscene::cli {

// The first unrecognized argument, with a suggestion.
std::string unknown_argument(const CLI::App& app);
// Whether there are words that no command accepted.
bool has_unknown_words(const CLI::App& app);
// The missing subcommand or required argument.
std::string missing_argument(const CLI::App& app);
// Rewords CLI11's message about a flag without value, or with a value of the wrong type.
std::string bad_value(const CLI::App& app, const CLI::ParseError& error);
// Throws UsageError for what CLI11 accepts: one number of three, and an empty file or folder name.
void check_values(const CLI::App& app);

}  // namespace fastscene::cli
