#include "fastscene/studio/job.h"

#include <algorithm>
#include <fstream>
#include <iterator>

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
        // A single piece of work has no share in a whole: it is the whole.
        const double total = json.value("total", 0.0);
        job.overall = json.value("overall", total > 0 ? json.value("done", 0.0) / total : job.overall);
        job.seconds_left = json.value("seconds_left", -1.0);
    } else if (event == "warning" && job.warnings.size() < kMostWarnings) {
        const std::string text = json.value("text", "");
        if (std::find(job.warnings.begin(), job.warnings.end(), text) == job.warnings.end())
            job.warnings.push_back(text);
    }
}

bool read_more_of_log(const std::filesystem::path& log, std::streamoff& read, Job& job) {
    std::ifstream in(log, std::ios::binary);
    in.seekg(read);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t whole = text.rfind('\n') + 1;  // npos + 1 = 0
    for (std::size_t at = 0; at < whole;) {
        const std::size_t line = text.find('\n', at);
        read_line_of_log(std::string_view(text).substr(at, line - at), job);
        at = line + 1;
    }
    read += static_cast<std::streamoff>(whole);
    return whole > 0;
}

}  // namespace fastscene::studio
