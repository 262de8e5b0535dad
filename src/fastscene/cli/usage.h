// What is wrong with the arguments, in a sentence: where, what was expected, what was found.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fastscene::cli {

// The first argument that nobody took, and what may have been meant.
std::string unknown_argument(const CLI::App& app);
// There are words that no verb took.
bool has_unknown_words(const CLI::App& app);
// The part of a verb, or the argument, that must be there and is not.
std::string missing_argument(const CLI::App& app);
// What CLI11 says of a flag without its value, or of a value of another kind.
std::string bad_value(const CLI::App& app, const CLI::ParseError& error);
// Throws UsageError for what CLI11 lets pass: one number of three, and no name where a file or folder is named.
void check_values(const CLI::App& app);

}  // namespace fastscene::cli
