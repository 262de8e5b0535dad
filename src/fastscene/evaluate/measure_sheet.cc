#include "fastscene/evaluate/measure_sheet.h"

#include <algorithm>

#include "fastscene/base/content_identity.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/evaluate/columns.h"
#include "fastscene/evaluate/parameters.h"
#include "fastscene/evaluate/picture.h"
#include "fastscene/evaluate/scores.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/images.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShownPairs = 3, kShownStills = 8;

// Cache key of pictures: the settings that made them, or their content if they come from elsewhere.
std::string fingerprint(const fs::path& pictures) {
    if (pictures.empty()) return "";
    const auto stage = finished_stage(pictures.parent_path().parent_path(), pictures.parent_path().filename().string());
    if (stage) return stage->result;
    Hash hash;
    for (const fs::path& file : pictures_in(pictures, "pictures"))
        hash.add(file.filename().string()).add(content_identity(file));
    return hash.hex();
}

// Evenly spaced, since neighbours look alike.
std::vector<fs::path> some_of(const std::vector<fs::path>& files, std::size_t wanted) {
    const std::size_t count = std::min(files.size(), wanted);
    std::vector<fs::path> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back(files[i * files.size() / count]);
    return out;
}

}  // namespace

Sample& MeasureSheet::sample_of(const std::string& group) {
    for (Sample& sample : measured_.samples)
        if (sample.group == group) return sample;
    Sample sample;
    sample.group = group;
    return measured_.samples.emplace_back(std::move(sample));
}

void MeasureSheet::note_all(const std::string& measure, const std::string& note) {
    Sample& sample = sample_of("");
    for (const std::string& key : in_.suite->columns)
        if (column_of(key).measure == measure) sample.notes[key].push_back(note);
}

void MeasureSheet::scores(const std::string& measure, const std::string& group, const fs::path& pictures,
                          const fs::path& reference) {
    const ScoreInputs all{pictures, reference, fingerprint(pictures), fingerprint(reference), "", in_.weights, ""};
    const fs::path kept = in_.work / "scores" / fmt::format("{}-{}", measure, slug_of(group.empty() ? "all" : group));
    for (const std::string& key : in_.suite->columns) {
        const Column& column = column_of(key);
        if (column.measure != measure || column.image_measure.empty()) continue;
        Sample& sample = sample_of(group);
        const bool reads_prompt = column.image_measure.starts_with("clip");
        if (reads_prompt && in_.prompt.empty()) {
            sample.notes[key] = {"needs a prompt"};
            continue;
        }
        const Json missing = missing_measures(in_.weights, {column.image_measure});
        if (!missing.empty()) {
            const std::string what = missing.at(column.image_measure);
            sample.notes[key] = {what.starts_with("fetch") ? what : "fetch " + what};
            continue;
        }
        const ParameterFiles parameters = parameters_of(in_.weights, column.image_measure);
        ScoreInputs one = all;
        one.prompt = reads_prompt ? in_.prompt : "";
        one.parameters = parameters.identity;
        const Score score = score_of(column.image_measure, one, kept, run_);
        if (!score.value.is_null()) sample.values[key] = score.value;
        if (!score.notes.empty()) sample.notes[key] = score.notes;
        if (score.counted < score.pictures && score.counted > 0) sample.pictures[key] = {score.counted, score.pictures};
        if (parameters.files.empty()) continue;
        Json files = Json::array();
        for (const fs::path& file : parameters.files) files.push_back(file.generic_string());
        measured_.parameters[key] = {{"files", files}, {"identity", parameters.identity}};
    }
}

void MeasureSheet::show_stills(const std::string& caption, const fs::path& pictures) {
    Figure figure{caption, {}, false};
    for (const fs::path& file : some_of(pictures_in(pictures, "stills"), kShownStills))
        figure.pictures.emplace_back("", fs::relative(file, in_.out));
    measured_.figures.push_back(std::move(figure));
}

void MeasureSheet::show_pairs(const std::string& caption, const Labelled& truth, const Labelled& judged, bool wide) {
    const std::vector<fs::path> files = some_of(pictures_in(truth.second, "pictures"), kShownPairs);
    const fs::path errors = kept(
        "errors-" + slug_of(caption), {{"truth", fingerprint(truth.second)}, {"ours", fingerprint(judged.second)}},
        [&](const fs::path& to) {
            for (const fs::path& file : files)
                save_png(to / file.filename(), error_map(load_rgb8(file), load_rgb8(judged.second / file.filename())));
        });
    for (const fs::path& file : files) {
        const fs::path name = file.filename();
        measured_.figures.push_back({file == files.front() ? caption : "",
                                     {{truth.first, fs::relative(file, in_.out)},
                                      {judged.first, fs::relative(judged.second / name, in_.out)},
                                      {"difference", fs::relative(errors / name, in_.out)}},
                                     wide});
    }
}

fs::path MeasureSheet::kept(const std::string& name, const Json& params,
                            const std::function<void(const fs::path&)>& make) {
    make_directories(in_.work);
    run_stage(in_.work, name, stage_key("measures", params, {name}, 0), run_, make);
    return in_.work / name;
}

fs::path MeasureSheet::made(const std::string& name, Json params, const RunFolder& folder,
                            const std::function<void(const fs::path&)>& make) {
    for (const std::string_view stage : kStages)
        if (const auto record = finished_stage(folder.root, stage))
            params["stage-" + std::string(stage)] = record->result;
    return kept(name, params, make);
}

}  // namespace fastscene
