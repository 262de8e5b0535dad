// A job: a scene being made, in its own process. What outlives the studio is kept in .studio/jobs/ID.json.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <ios>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"

namespace fastscene::studio {

enum class JobState : std::uint8_t { waiting, running, stopped, failed, finished };
inline constexpr std::array<std::string_view, 5> kJobStates{"waiting", "running", "stopped", "failed", "finished"};

struct Job {
    std::string id;                      // the scene's folder
    std::vector<std::string> arguments;  // of the program, without those that only the studio needs
    std::vector<std::string> look;       // arguments of a quick first picture; empty: none
    Json request;                        // what was asked for, as the page shows it: title, seed, quality, from
    JobState state = JobState::waiting;
    std::string error;  // why it failed
    int pid = 0;        // of the running process
    // While it runs.
    std::string work;  // what it does: "panorama", "splat: training"
    double overall = 0, seconds_left = -1, seconds = 0;
    std::vector<std::string> warnings;
};

Json json_of_job(const Job& job);  // for pages
Json record_of_job(const Job& job);
// Throws Error for other JSON.
Job job_from_record(const Json& record, const std::string& file);

// What a line of `--progress json` says; other lines are the program's own words, and an error begins with its name.
void read_line_of_log(std::string_view line, Job& job);
// What a log says from `read` on, up to its last whole line; moves `read`. Returns whether there was anything.
bool read_more_of_log(const std::filesystem::path& log, std::streamoff& read, Job& job);

}  // namespace fastscene::studio
