#include "fastscene/cli/flag_table.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace fastscene::cli {
namespace {

bool names_a_place(const std::string& kind) {
    return kind.find("FILE") != std::string::npos || kind.find("DIR") != std::string::npos || kind == "PATH" ||
           kind == "MAP" || kind == "SUITE";
}

// The words of "auto|plain|FILE" that are meant literally: without capitals.
std::vector<std::string> literal_words(const std::string& kind) {
    std::vector<std::string> words;
    if (kind.find('|') == std::string::npos) return words;
    for (std::size_t at = 0; at <= kind.size();) {
        const std::size_t end = std::min(kind.find('|', at), kind.size());
        const std::string word = kind.substr(at, end - at);
        if (!word.empty() && std::none_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'Z'; }))
            words.push_back(word);
        at = end + 1;
    }
    return words;
}

std::string first_sentence(const std::string& text) {
    const std::size_t end = text.find(". ");
    std::string out = text.substr(0, end);
    if (!out.empty() && out.back() == '.') out.pop_back();
    return out;
}

FlagEntry flag_entry(const CLI::Option& option) {
    FlagEntry entry;
    for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
    for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
    entry.about = first_sentence(option.get_description());
    if (option.get_expected_max() > 0) entry.value = option.get_type_name();
    entry.choices = literal_words(entry.value);
    return entry;
}

void add_command(const CLI::App& app, std::vector<std::string> words, std::vector<CommandEntry>& out) {
    CommandEntry entry{std::move(words), first_sentence(app.get_description()), {}, {}, false};
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional()) entry.takes_place = entry.takes_place || names_a_place(option->get_type_name());
        else entry.flags.push_back(flag_entry(*option));
    }
    const auto parts = app.get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* part : parts)
        entry.subcommands.emplace_back(part->get_name(), first_sentence(part->get_description()));
    out.push_back(entry);
    for (const CLI::App* part : parts) {
        std::vector<std::string> below = entry.words;
        below.push_back(part->get_name());
        add_command(*part, std::move(below), out);
    }
}

// In single quotes of a shell. zsh and fish want the same, but for what is said below.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}
// In a specification of zsh's _arguments, brackets and colons have meanings of their own.
std::string zsh_text(const std::string& text) {
    std::string out;
    for (const char c : text) out += std::string(c == '[' || c == ']' || c == ':' || c == '\\' ? "\\" : "") + c;
    return out;
}
std::string fish_text(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += std::string(c == '\'' || c == '\\' ? "\\" : "") + c;
    return out + "'";
}
std::string function_of(const CommandEntry& command) {
    std::string out = "_fastscene";
    for (const std::string& word : command.words) out += "_" + word;
    std::replace(out.begin(), out.end(), '-', '_');
    return out;
}

std::vector<std::string> names_of(const CommandEntry& command) {
    std::vector<std::string> all;
    for (const auto& [name, about] : command.subcommands) all.push_back(name);
    return all;
}

}  // namespace

bool FlagEntry::takes_place() const { return names_a_place(value); }
std::string CommandEntry::name() const { return fmt::format("{}", fmt::join(words, " ")); }

std::vector<CommandEntry> command_table(const CLI::App& app) {
    std::vector<CommandEntry> out;
    add_command(app, {}, out);
    return out;
}

std::string bash_completion(const std::vector<CommandEntry>& commands) {
    std::string subcommands, flags, values;
    for (const CommandEntry& command : commands) {
        const std::string key = quoted(command.name());
        subcommands += fmt::format("    {}) words='{}' ;;\n", key, fmt::join(names_of(command), " "));
        std::vector<std::string> names;
        for (const FlagEntry& flag : command.flags) {
            names.insert(names.end(), flag.names.begin(), flag.names.end());
            if (flag.value.empty()) continue;
            for (const std::string& name : flag.names)
                values += fmt::format("    '{} {}') value={} words='{}' ;;\n", command.name(), name,
                                      flag.takes_place() ? "place" : "text", fmt::join(flag.choices, " "));
        }
        flags += fmt::format("    {}) words='{}' ;;\n", key, fmt::join(names, " "));
    }
    return "# bash completion of fastscene, made by `fastscene completion bash`.\n"
           "_fastscene() {\n"
           "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= words= value= i\n"
           "  COMPREPLY=()\n"
           "  # --flag=value comes in three words.\n"
           "  if [ \"$current\" = = ]; then current=\n"
           "  elif [ \"$before\" = = ]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi\n"
           "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
           "    _fastscene_subcommands \"$command\"\n"
           "    case \" $words \" in *\" ${COMP_WORDS[i]} \"*) command=\"${command:+$command }${COMP_WORDS[i]}\" ;; "
           "esac\n"
           "  done\n"
           "  _fastscene_value \"$command $before\"\n"
           "  if [ -n \"$value\" ]; then\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
           "    if [ \"$value\" = place ]; then\n"
           "      compopt -o filenames 2>/dev/null\n"
           "      local IFS=$'\\n'\n"
           "      COMPREPLY+=($(compgen -f -- \"$current\"))\n"
           "    fi\n"
           "    return\n"
           "  fi\n"
           "  case $current in\n"
           "    -*) _fastscene_flags \"$command\" ;;\n"
           "    *) _fastscene_subcommands \"$command\" ;;\n"
           "  esac\n"
           "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
           "}\n"
           "_fastscene_subcommands() {\n  words=\n  case $1 in\n" +
           subcommands + "  esac\n}\n_fastscene_flags() {\n  words=\n  case $1 in\n" + flags +
           "  esac\n}\n_fastscene_value() {\n  words= value=\n  case $1 in\n" + values +
           "  esac\n}\ncomplete -o default -F _fastscene fastscene\n";
}

std::string zsh_completion(const std::vector<CommandEntry>& commands) {
    std::string out = "#compdef fastscene\n# zsh completion of fastscene, made by `fastscene completion zsh`.\n";
    for (const CommandEntry& command : commands) {
        out += fmt::format(
            "\n{}() {{\n  local context state state_descr line\n  typeset -A opt_args\n  _arguments -C \\\n",
            function_of(command));
        for (const FlagEntry& flag : command.flags) {
            std::string value;
            if (!flag.value.empty()) {
                const std::string words = fmt::format("({})", fmt::join(flag.choices, " "));
                value = ":" + zsh_text(flag.value) + ":" +
                        (flag.takes_place() && !flag.choices.empty()
                             ? fmt::format("{{_alternative \"words::{}\" \"files::_files\"}}", words)
                         : flag.takes_place()    ? "_files"
                         : !flag.choices.empty() ? words
                                                 : "");
            }
            for (const std::string& name : flag.names) {
                // A long flag also takes --flag=value.
                const bool equals = !value.empty() && name.starts_with("--");
                out += "    " + quoted(name + (equals ? "=" : "") + "[" + zsh_text(flag.about) + "]" + value) + " \\\n";
            }
        }
        if (command.subcommands.empty()) {
            out += command.takes_place ? "    '*:file:_files'\n}\n" : "    '*: :'\n}\n";
            continue;
        }
        out += "    '1: :->command' '*:: :->arguments'\n  case $state in\n    command)\n      local -a commands=(\n";
        for (const auto& [name, about] : command.subcommands)
            out += "        " + quoted(zsh_text(name) + ":" + about) + "\n";
        out += fmt::format(
            "      )\n      _describe command commands{}\n      ;;\n    arguments)\n      case $line[1] in\n",
            command.takes_place ? "\n      _files" : "");
        for (const auto& [name, about] : command.subcommands) {
            CommandEntry below{command.words, {}, {}, {}, false};
            below.words.push_back(name);
            out += fmt::format("        {}) {} ;;\n", name, function_of(below));
        }
        if (command.takes_place) out += "        *) _files ;;\n";
        out += "      esac\n      ;;\n  esac\n}\n";
    }
    // The file itself is the function _fastscene when zsh loads it from its path; else it is sourced.
    return out +
           "\nif [[ $funcstack[1] = _fastscene ]]; then _fastscene \"$@\"; else compdef _fastscene fastscene; fi\n";
}

std::string fish_completion(const std::vector<CommandEntry>& commands) {
    std::string out =
        "# fish completion of fastscene, made by `fastscene completion fish`.\n"
        "# Whether the words so far are this command, followed by none of its subcommands.\n"
        "function __fastscene_at\n"
        "  set -l words\n"
        "  for word in (commandline -opc)[2..]\n"
        "    string match -q -- '-*' $word; or set -a words $word\n"
        "  end\n"
        "  set -l count (count $argv[1])\n"
        "  set -l command (string split -n ' ' -- $argv[1])\n"
        "  test (count $words) -ge (count $command); or return 1\n"
        "  for i in (seq (count $command))\n"
        "    test \"$words[$i]\" = \"$command[$i]\"; or return 1\n"
        "  end\n"
        "  set -l next $words[(math (count $command) + 1)]\n"
        "  not contains -- \"$next\" $argv[2..]\n"
        "end\n";
    for (const CommandEntry& command : commands) {
        const std::string at = "complete -c fastscene -n " +
                               fish_text(fmt::format("__fastscene_at \"{}\" {}", command.name(),
                                                     fmt::join(names_of(command), " ")));
        if (!command.takes_place) out += at + " -f\n";
        for (const auto& [name, about] : command.subcommands)
            out += at + " -a " + name + " -d " + fish_text(about) + "\n";
        for (const FlagEntry& flag : command.flags) {
            out += at;
            for (const std::string& name : flag.names)
                out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            if (!flag.value.empty()) out += flag.takes_place() ? " -r -F" : " -x";
            if (!flag.choices.empty()) out += fmt::format(" -a '{}'", fmt::join(flag.choices, " "));
            out += " -d " + fish_text(flag.about) + "\n";
        }
    }
    return out;
}

}  // namespace fastscene::cli
