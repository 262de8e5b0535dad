#include "fastscene/nn/launch.h"

#include <charconv>

namespace fastscene {
namespace {

// Below the ports that systems give to outgoing connections.
constexpr int kFirstPort = 20000, kPorts = 10000;

int variable_in(const Environment& environment, const char* name) {
    const std::string text = environment(name);
    int value = 0;
    const char* end = text.data() + text.size();
    if (const auto [stop, code] = std::from_chars(text.data(), end, value);
        code != std::errc() || stop != end || value < 0)
        throw UsageError("{}: expected a whole number in this environment variable, found \"{}\"", name, text);
    return value;
}

bool has_all(const Environment& environment, std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (environment(name) == nullptr) return false;
    return true;
}

Launch from_srun(const Environment& environment) {
    // Two trainings on one node must not meet each other.
    const int port = kFirstPort +
                     (variable_in(environment, "SLURM_JOB_ID") + variable_in(environment, "SLURM_STEP_ID")) % kPorts;
    return {variable_in(environment, "SLURM_STEP_NUM_TASKS"), variable_in(environment, "SLURM_PROCID"),
            fmt::format("{}:{}", first_node(environment("SLURM_STEP_NODELIST")), port)};
}

}  // namespace

std::string first_node(const std::string& list) {
    std::string name;
    for (std::size_t i = 0; i < list.size() && list[i] != ','; ++i) {
        if (list[i] != '[') {
            name += list[i];
            continue;
        }
        const std::size_t close = list.find(']', i);
        const std::string numbers = list.substr(i + 1, close - i - 1);
        name += numbers.substr(0, numbers.find_first_of(",-"));
        if (close == std::string::npos) break;
        i = close;
    }
    return name;
}

std::optional<Launch> launch_from(const Environment& environment) {
    std::optional<Launch> launch;
    if (has_all(environment, {"RANK", "WORLD_SIZE", "MASTER_ADDR", "MASTER_PORT"}))
        launch = {variable_in(environment, "WORLD_SIZE"), variable_in(environment, "RANK"),
                  fmt::format("{}:{}", environment("MASTER_ADDR"), variable_in(environment, "MASTER_PORT"))};
    // srun's alone: a batch script has SLURM_NTASKS, too, but is one process.
    else if (has_all(environment,
                     {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID", "SLURM_STEP_NODELIST", "SLURM_JOB_ID", "SLURM_STEP_ID"}))
        launch = from_srun(environment);
    if (launch && launch->processes < 2) return {};
    return launch;
}

void take_launch(TrainingParams& params, const Environment& environment) {
    if (params.processes > 1 && !params.meet.empty()) return;
    const std::optional<Launch> launch = launch_from(environment);
    if (!launch) return;
    if (params.meet.empty()) params.meet = launch->meet;
    if (params.processes == 1) params.processes = launch->processes, params.process = launch->process;
}

}  // namespace fastscene
