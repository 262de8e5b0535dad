// The commands and flags of the program as data, read from the parser: what completions are made of.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fastscene::cli {

struct FlagEntry {
    std::vector<std::string> names;    // "--out", "-o"
    std::string about;                 // its first sentence
    std::string value;                 // "FILE"; empty: a switch without a value
    std::vector<std::string> choices;  // "splats", "room"; files are offered besides if `value` has FILE or DIR
    bool takes_place() const;          // a file or folder
};
struct CommandEntry {
    std::vector<std::string> words;  // "depth", "train"
    std::string about;
    std::vector<FlagEntry> flags;
    std::vector<std::pair<std::string, std::string>> subcommands;  // name, about
    bool takes_place = false;                                      // has arguments that are files or folders
    std::string name() const;                                      // "depth train"
};

// The program itself first, then every command before its subcommands.
std::vector<CommandEntry> command_table(const CLI::App& app);

// Completion scripts.
std::string bash_completion(const std::vector<CommandEntry>& commands);
std::string zsh_completion(const std::vector<CommandEntry>& commands);
std::string fish_completion(const std::vector<CommandEntry>& commands);

}  // namespace fastscene::cli
