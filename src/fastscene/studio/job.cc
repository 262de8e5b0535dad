#include "fastscene/studio/job.h"

#include <algorithm>

#include "fastscene/base/error.h"

namespace fastscene::studio {
namespace {

constexpr std::size_t kMostWarnings = 20;  // a page shows no more

JobState state_named(const std::string& name) {
    const auto at = std::find(kJobStates.begin(), kJobStates.end(), name);
    if (at == kJobStates.end()) throw Error("unknown state");
    return static_cast<JobState>(at - kJobStates.begin());
}

std::string_view name_of(JobState state) { return kJobStates[static_cast<std::size_t>(state)]; }

}  // namespace

Json json_of_job(const Job& job) {
    return {{"id", job.id},           {"state", name_of(job.state)}, {"error", job.error},
            {"work", job.work},       {"overall", job.overall},      {"seconds_left", job.seconds_left},
            {"seconds", job.seconds}, {"warnings", job.warnings},    {"request", job.request}};
}

Json record_of_job(const Job& job) {
    return {{"id", job.id},           {"arguments", job.arguments},  {"look", job.look},
            {"request", job.request}, {"state", name_of(job.state)}, {"error", job.error},
            {"pid", job.pid}};
}

Job job_from_record(const Json& record, const std::string& file) {
    try {
        Job job;
        job.id = record.at("id");
        job.arguments = record.at("arguments").get<std::vector<std::string>>();
        job.look = record.at("look").get<std::vector<std::string>>();
        job.request = record.at("request");
        job.state = state_named(record.at("state"));
        job.error = record.at("error");
        job.pid = record.at("pid");
        return job;
    } catch (const std::exception& e) {
        throw Error("{}: expected the record of a job: {}", file, e.what());
    }
}

void read_line_of_log(std::string_view line, Job& job) {
    if (line.starts_with("fastscene: ")) {
        job.error = line.substr(std::string_view("fastscene: ").size());
        return;
    }
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) return;
    const std::string event = json.value("event", "");
    if (event == "progress") {
        job.work = json.value("work", "");
        job.overall = json.value("overall", job.overall);
        job.seconds_left = json.value("seconds_left", -1.0);
    } else if (event == "warning" && job.warnings.size() < kMostWarnings) {
        const std::string text = json.value("text", "");
        if (std::find(job.warnings.begin(), job.warnings.end(), text) == job.warnings.end())
            job.warnings.push_back(text);
    }
}

}  // namespace fastscene::studio
