#include "fastscene/base/program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/forced_exit.h"

namespace fastscene {
namespace {

// Strings as the null-terminated array for exec; they must outlive it.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> out;
    for (std::string& text : texts) out.push_back(text.data());
    out.push_back(nullptr);
    return out;
}

std::vector<std::string> environment_with(const std::vector<std::string>& more) {
    std::vector<std::string> all = more;
    for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
    return all;
}

struct SpawnActions {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    explicit SpawnActions(const std::string& log) {
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.empty() ? "/dev/null" : log.c_str(),
                                         O_WRONLY | O_CREAT | O_APPEND, 0644);
        if (!log.empty()) posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
        // The child must not inherit this program's blocked signals.
        posix_spawnattr_init(&attributes);
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    }
    ~SpawnActions() {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
};

}  // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path program = std::filesystem::path(folder) / name;
        if (!folder.empty() && ::access(program.c_str(), X_OK) == 0) return program;
    }
    return {};
}

int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const ProgramOptions& options) {
    std::vector<std::string> texts{program.string()};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = environment_with(options.environment);
    const SpawnActions actions(options.log.string());
    pid_t child = 0;
    const int failed = ::posix_spawn(&child, program.c_str(), &actions.files, &actions.attributes,
                                     pointers_to(texts).data(), pointers_to(variables).data());
    if (failed) throw Error("{}: cannot be run: {}", program.string(), std::strerror(failed));
    // Who is asked to stop waits for those it asked: their folders are free when it has ended.
    std::optional<ExitHold> hold;
    if (options.stop.stop_possible()) hold.emplace();
    if (options.started) options.started(child);
    int status = 0;
    {
        const std::stop_callback on_stop(options.stop, [&] { ::kill(child, SIGTERM); });
        while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
    }
    if (options.stop.stop_requested()) throw Stopped();
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace fastscene
