#include "fastscene/cli/usage.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/suggest.h"

namespace fastscene::cli {
namespace {

// The command, then its subcommand: `depth`, `train`. The first entry is the program.
std::vector<const CLI::App*> parsed_apps(const CLI::App& app) {
    std::vector<const CLI::App*> chain{&app};
    while (!chain.back()->get_subcommands().empty()) chain.push_back(chain.back()->get_subcommands().front());
    return chain;
}

// "depth train", or empty.
std::string name_of(const std::vector<const CLI::App*>& chain) {
    std::string name;
    for (std::size_t i = 1; i < chain.size(); ++i) name += (i > 1 ? " " : "") + chain[i]->get_name();
    return name;
}

std::vector<std::string> parts_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* part : app.get_subcommands({})) names.push_back(part->get_name());
    return names;
}

// The subcommand's own flags, and those of its command, which it accepts too.
std::vector<std::string> flags_of(const std::vector<const CLI::App*>& chain) {
    std::vector<std::string> names;
    for (const CLI::App* app : chain)
        for (const CLI::Option* option : app->get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::string flag_of(const CLI::Option& option) {
    return option.get_lnames().empty() ? option.get_name(true) : "--" + option.get_lnames().front();
}

// Type of a flag's value in words, for "N" in --help's columns.
std::string kind_of(const CLI::Option& option) {
    const std::string kind = option.get_type_name();
    return kind.empty()                                   ? "no value"
           : kind == "N"                                  ? "a whole number"
           : kind == "X"                                  ? "a number"
           : kind.starts_with("X Y Z") || kind == "R G B" ? "numbers " + kind
                                                          : kind;
}

std::string see_help(const std::string& name) {
    return fmt::format(" (fastscene {}--help lists what there is)", name.empty() ? "" : name + " ");
}

// `walk tabel run`: the misspelt subcommand was taken for the folder.
std::string part_taken_for_argument(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
        if (option->get_positional() && option->count())
            for (const std::string& word : option->results())
                if (const std::string part = nearest_word(word, parts_of(app)); !part.empty())
                    return app.get_name() + " " + part;
    return "";
}

}  // namespace

bool has_unknown_words(const CLI::App& app) {
    for (const std::string& word : app.remaining(true))
        if (!word.starts_with("-")) return true;
    return false;
}

std::string unknown_argument(const CLI::App& app) {
    const std::vector<const CLI::App*> chain = parsed_apps(app);
    const std::string name = name_of(chain);
    const std::vector<std::string> rest = app.remaining(true);
    std::string word = rest.empty() ? "" : rest.front();
    if (chain.size() > 1)  // an unknown flag after a command is more informative than the words after it
        for (const std::string& argument : rest)
            if (argument.starts_with("-")) {
                word = argument;
                break;
            }
    word = word.substr(0, word.find('='));
    const bool is_flag = word.starts_with("-");
    const std::vector<std::string> parts = parts_of(*chain.back());
    std::string guess = nearest_word(word, is_flag ? flags_of(chain) : parts);
    if (guess.empty() && !is_flag && chain.size() > 1) guess = part_taken_for_argument(*chain.back());
    const char* kind = is_flag ? "flag" : chain.size() == 1 ? "verb" : "argument";
    return fmt::format("{}unknown {} {}{}{}", name.empty() ? "" : name + ": ", kind, word,
                       guess.empty() ? "" : "; did you mean " + guess + "?", see_help(name));
}

std::string missing_argument(const CLI::App& app) {
    const std::vector<const CLI::App*> chain = parsed_apps(app);
    const CLI::App& last = *chain.back();
    const std::string name = name_of(chain), where = name.empty() ? "" : name + ": ";
    if (last.get_require_subcommand_min() > 0)
        return fmt::format("{}expected one of {}, found none{}", where, fmt::join(parts_of(last), ", "),
                           see_help(name));
    for (const CLI::Option* option : last.get_options())
        if (option->get_required() && option->count() == 0)
            return fmt::format("{}expected {} {}, found none{}", where, flag_of(*option), option->get_type_name(),
                               see_help(name));
    return where + "an argument is missing" + see_help(name);
}

std::string bad_value(const CLI::App& app, const CLI::ParseError& error) {
    const std::string text = error.what();
    const std::vector<const CLI::App*> chain = parsed_apps(app);
    constexpr std::string_view kOtherKind = "Could not convert: ";
    for (const CLI::App* part : chain)
        for (const CLI::Option* option : part->get_options()) {
            const std::string flag = option->get_name();
            if (text.starts_with(flag + ": ") && text.ends_with(" missing"))
                return fmt::format("{}: expected {} after it, found nothing", flag, kind_of(*option));
            const std::string other = std::string(kOtherKind) + flag + " = ";
            if (text.starts_with(other))
                return fmt::format("{}: expected {}, found \"{}\"", flag, kind_of(*option), text.substr(other.size()));
        }
    return text;
}

void check_values(const CLI::App& app) {
    for (const CLI::App* part : parsed_apps(app))
        for (const CLI::Option* option : part->get_options()) {
            if (option->count() == 0) continue;
            const auto wanted = static_cast<std::size_t>(std::max(option->get_expected_min(), 1)),
                       found = option->results().size();
            if (wanted > 1 && wanted == static_cast<std::size_t>(option->get_expected_max()) && found % wanted != 0)
                throw UsageError("{}: expected {} numbers ({}), found {}", flag_of(*option), wanted,
                                 option->get_type_name(), found % wanted);
            const std::string kind = option->get_type_name();
            const bool names_a_place = kind.find("FILE") != std::string::npos ||
                                       kind.find("DIR") != std::string::npos || kind == "PATH" || kind == "MAP" ||
                                       kind == "SUITE";
            for (const std::string& text : option->results())
                if (names_a_place && text.empty())
                    throw UsageError("{}: expected {}, found an empty text", flag_of(*option), kind);
        }
}

}  // namespace fastscene::cli
