#include "fastscene/evaluate/scores.h"

#include <map>

#include "fastscene/base/file.h"
#include "fastscene/metrics/images.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// The report lists all transparent files, including references.
int transparent_in(const Json& report, const fs::path& folder) {
    int count = 0;
    for (const Json& file : report.at("transparent"))
        count += file.is_string() && fs::path(file.get<std::string>()).parent_path() == folder;
    return count;
}

// Each reason once, with the first picture that it applies to.
void note_undefined(const Json& report, const std::string& measure, Score& score) {
    std::map<std::string, std::pair<std::string, int>> reasons;
    for (const auto& [picture, why] : report.at("undefined").items())
        if (why.contains(measure)) {
            auto& [first, count] = reasons[why.at(measure).get<std::string>()];
            if (count++ == 0) first = picture;
        }
    for (const auto& [reason, where] : reasons)
        score.notes.push_back(fmt::format("undefined for {} of {} pictures, which the mean leaves out ({}: {})",
                                          where.second, score.pictures, where.first, reason));
}

}  // namespace

Score score_from_report(const Json& report, const std::string& measure, int transparent) {
    Score score;
    int infinite = 0;
    for (const Json& picture : report.at("pictures")) {
        const Json value = picture.value(measure, Json());
        ++score.pictures;
        score.counted += value.is_number();
        infinite += value.is_string();
    }
    score.value = score.counted == 0 && infinite > 0 ? Json("inf") : report.at("mean").value(measure, Json());
    if (report.at("missing").contains(measure))
        score.notes.push_back(report.at("missing").at(measure));  // the file exists but is broken
    note_undefined(report, measure, score);
    if (const Json left_out = report.value("left_out", Json::object()); !left_out.empty())
        score.notes.push_back(fmt::format("{} of {} pictures cannot be read and are left out ({})", left_out.size(),
                                          left_out.size() + report.at("pictures").size(),
                                          left_out.front().get<std::string>()));
    if (infinite > 0 && score.counted > 0)
        score.notes.push_back(
            fmt::format("infinite for {} of {} pictures, which equal what they should be: the mean leaves them out",
                        infinite, score.pictures));
    if (transparent > 0)
        score.notes.push_back(fmt::format("{} of {} pictures are transparent in parts: measured over black",
                                          transparent, score.pictures));
    return score;
}

Score score_of(const std::string& measure, const ScoreInputs& inputs, const fs::path& kept, const Run& run) {
    const Json what{{"measure", measure},
                    {"pictures", inputs.pictures_key},
                    {"reference", inputs.reference_key},
                    {"prompt", inputs.prompt},
                    {"parameters", inputs.parameters}};
    make_directories(kept);
    run_stage(kept, measure, stage_key("scores", what, {}, 0), run, [&](const fs::path& to) {
        run.note(fmt::format("{}: judging {} pictures", measure, pictures_in(inputs.pictures, measure).size()));
        const Json report = measure_images(
            {inputs.pictures, inputs.reference, inputs.prompt, inputs.weights, {measure}},
            Run{run.seed, nullptr, run.stop});
        write_json(to / "score.json", report);
    });
    const Json report = read_json(kept / measure / "score.json");
    return score_from_report(report, measure, transparent_in(report, inputs.pictures));
}

}  // namespace fastscene
