#include "fastscene/cli/checks.h"
#include "fastscene/cli/flag_table.h"
#include "fastscene/cli/verb.h"

namespace fastscene::cli {

Verb add_completion(CLI::App& app) {
    auto shell = std::make_shared<std::string>();
    CLI::App* verb = app.add_subcommand("completion",
                                        "Prints a completion script for a shell: commands, flags, values.");
    verb->add_option("shell", *shell, "The shell.")
        ->type_name("bash|zsh|fish")
        ->check(one_of({"bash", "zsh", "fish"}))
        ->required();
    verb->footer(
        "Examples:\n  source <(fastscene completion bash)\n"
        "  fastscene completion zsh >~/.zfunc/_fastscene\n"
        "  fastscene completion fish >~/.config/fish/completions/fastscene.fish");
    return {verb, [shell, &app](const Session& session) {
                const std::vector<CommandEntry> commands = command_table(app);
                std::string text = *shell == "bash"  ? bash_completion(commands)
                                   : *shell == "zsh" ? zsh_completion(commands)
                                                     : fish_completion(commands);
                text.pop_back();  // print adds the last line's end
                session.print(text, {{"shell", *shell}, {"script", text}});
            }};
}

}  // namespace fastscene::cli
