#include "fastscene/evaluate/measures.h"

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/columns.h"
#include "fastscene/evaluate/picture.h"
#include "fastscene/evaluate/stills.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/metrics/images.h"
#include "fastscene/pipeline/hole_report.h"
#include "fastscene/pipeline/stage_cache.h"
#include "fastscene/pipeline/stages.h"
#include "fastscene/pipeline/still.h"
#include "fastscene/pipeline/truth.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr int kShownPairs = 3, kShownStills = 8;

Run quiet(const Run& run) { return {run.seed, nullptr, run.stop}; }

class SceneMeasures {
  public:
    SceneMeasures(const MeasureInputs& inputs, const Run& run) : in_(inputs), run_(run) {}

    void stills(const RunFolder& folder) {
        const StillsParams& p = in_.suite->stills;
        const fs::path dir = made("stills", {{"count", p.count}, {"size", p.size_px}, {"fov", p.fov_deg}, {"radius", p.radius_m}}, folder, [&](const fs::path& to) {
            const Panorama first = load_first_panorama(folder);
            const Splats splats = load_splat_ply(folder.scene_ply());
            const Pinhole camera = still_camera(p, first.color.width);
            save_walked_stills(to / "walked", splats, p, camera, first.range, run_);
            save_origin_stills(to / "origin", splats, p, camera, run_);
            save_input_stills(to / "input", first, p, camera, run_);
        });
        scores("stills", "", dir / "walked", "");
        scores("stills", kOriginGroup, dir / "origin", "");
        scores("stills", kInputGroup, dir / "input", "");
        show_stills("The splats, from within " + fmt::format("{} m of panorama 0", p.radius_m), dir / "walked");
        show_pairs("Panorama 0's own crop, and the splats from the same place", {"panorama 0", dir / "input"}, {"splats", dir / "origin"});
    }

    void source(const RunFolder& folder) {
        const fs::path dir = made("source", {}, folder, [&](const fs::path& to) {
            const ImageRgb8 first = load_rgb8(folder.panorama_color());
            const ImageRgb8 ours = sphere_of(load_splat_ply(folder.scene_ply()), first.width, {}).color;
            make_directories(to / "splats");
            make_directories(to / "panorama");
            save_png(to / "splats/sphere.png", ours);
            save_png(to / "panorama/sphere.png", first);
        });
        scores("source", "", dir / "splats", dir / "panorama");
        show_pairs("All around, from panorama 0's place", {"panorama 0", dir / "panorama"}, {"splats", dir / "splats"}, true);
    }

    void held_out(const RunFolder& folder) {
        if (!recorded_run(folder).request.source.has_room()) {
            const std::string why = "needs a room behind the scene: a prompt, not a picture";
            Sample& sample = sample_of("");
            for (const Column& column : columns())
                if (column.measure == "held-out") sample.notes[column.key] = why;
            return;
        }
        const HeldOutParams& p = in_.suite->held_out;
        const Run poses_run{0, run_.events, run_.stop};
        RunTruth room(folder.root, in_.truth, poses_run);
        for (const double radius : p.radii_m) {
            const std::string group = p.radii_m.size() > 1 ? fmt::format("within {} m", radius) : "";
            const fs::path dir = made(fmt::format("held-out-{}", radius), {{"views", p.views}, {"bounds", in_.bounds}, {"radius", radius}}, folder,
                                      [&](const fs::path& to) { make_held_out(room, folder, radius, to); });
            add_truth(group, read_json(dir / "truth.json"));
            if (!group.empty()) sample_of(group).at = radius;
            scores("held-out", group, dir / "splats", dir / "truth");
            show_pairs(fmt::format("At poses never trained on, {}", group.empty() ? fmt::format("within {} m", radius) : group), {"the traced room", dir / "truth"}, {"splats", dir / "splats"});
        }
    }

    void holes(const RunFolder& folder) {
        const fs::path dir = made("holes", {}, folder, [&](const fs::path& to) {
            save_hole_table(to, hole_table_of_run(folder.root, recorded_run(folder).request.source.has_room(), run_));
        });
        const Json table = read_json(dir / "hole_table.json");
        for (const Json& row : table.at("rows")) {
            const std::string axis = row.at("axis");
            Sample& sample = sample_of(fmt::format("{} {:+.2f}", axis, row.at("share").get<double>()));
            sample.series = "along " + axis;
            sample.at = row.at("share").get<double>();
            const auto percent = [](const Json& share) { return Json(100 * share.get<double>()); };
            sample.values["holes_paper"] = percent(row.at("paper"));
            sample.values["holes_published"] = percent(row.at("published"));
            sample.values["holes"] = percent(row.at("ours"));
            if (row.contains("truth")) sample.values["holes_true"] = percent(row.at("truth").at("ratio"));
            else sample.notes["holes_true"] = row.at("in_room").get<bool>() ? "needs a room behind the scene" : "the step ends in or behind a surface";
        }
    }

    // The columns of `measure` that pictures fill, over a folder of them; `reference`: what they should be.
    void scores(const std::string& measure, const std::string& group, const fs::path& pictures, const fs::path& reference) {
        Sample& sample = sample_of(group);
        ImageMeasures wanted{pictures, reference, in_.prompt, in_.weights, {}};
        std::map<std::string, std::string> column_of_measure;
        for (const std::string& key : in_.suite->columns) {
            const Column& column = column_of(key);
            if (column.measure != measure || column.image_measure.empty()) continue;
            if (column.image_measure.starts_with("clip") && in_.prompt.empty()) {
                sample.notes[key] = "needs a prompt";
                continue;
            }
            wanted.wanted.push_back(column.image_measure);
            column_of_measure[column.image_measure] = key;
        }
        if (wanted.wanted.empty()) return;
        const Json missing = missing_measures(in_.weights, wanted.wanted);
        const std::string name = fmt::format("scores-{}-{}", measure, slug_of(group.empty() ? "all" : group));
        const Json params{{"wanted", wanted.wanted}, {"prompt", in_.prompt}, {"missing", missing}, {"pictures", fingerprint(pictures)}, {"reference", reference.empty() ? "" : fingerprint(reference)}};
        const fs::path dir = kept(name, params, [&](const fs::path& to) {
            run_.note(fmt::format("{}: judging {} pictures", group.empty() ? measure : group, pictures_in(pictures, measure).size()));
            write_json(to / "scores.json", measure_images(wanted, quiet(run_)));
        });
        const Json report = read_json(dir / "scores.json");
        for (const auto& [name_of_measure, key] : column_of_measure) {
            const Json mean = report.at("mean").value(name_of_measure, Json());
            if (missing.contains(name_of_measure)) sample.notes[key] = "fetch " + missing.at(name_of_measure).get<std::string>();
            else if (!mean.is_null()) sample.values[key] = mean;
            else why_undefined(report, name_of_measure, key, sample);
        }
    }

    void show_stills(const std::string& caption, const fs::path& pictures) {
        Figure figure{caption, {}, false};
        const std::vector<fs::path> files = pictures_in(pictures, "stills");
        const std::size_t step = std::max<std::size_t>(1, files.size() / kShownStills);
        for (std::size_t i = 0; i < files.size() && figure.pictures.size() < kShownStills; i += step) figure.pictures.emplace_back("", fs::relative(files[i], in_.out));
        figures_.push_back(std::move(figure));
    }

    Measured take() { return {std::move(samples_), std::move(figures_)}; }

  private:
    // All pictures are equal, or the measure is not defined for any of them.
    static void why_undefined(const Json& report, const std::string& measure, const std::string& key, Sample& sample) {
        for (const Json& row : report.at("pictures"))
            if (row.contains(measure) && row.at(measure).is_string()) {
                sample.values[key] = row.at(measure);
                return;
            }
        for (const auto& [picture, reasons] : report.at("undefined").items())
            if (reasons.contains(measure)) sample.notes[key] = fmt::format("{}: {}", picture, reasons.at(measure).get<std::string>());
    }

    void make_held_out(RunTruth& room, const RunFolder& folder, double radius, const fs::path& to) {
        const HeldOutParams& p = in_.suite->held_out;
        const TruthParams params{.views = p.views, .radius_m = static_cast<float>(radius), .bounds = in_.bounds};
        const Json truth = room.measure(params).at("truth");
        make_directories(to / "truth");
        make_directories(to / "splats");
        for (const fs::path& strip : pictures_in(folder.metrics() / "truth", "held-out")) {
            const std::string name = strip.filename().string();
            if (std::stoi(strip.stem().string()) >= p.views) continue;  // of an earlier, longer look at this scene
            const ImageRgb8 all = load_rgb8(strip);
            save_png(to / "truth" / name, cut_out(all, 0, 0, all.height, all.height));
            save_png(to / "splats" / name, cut_out(all, all.height, 0, all.height, all.height));
        }
        write_json(to / "truth.json", truth);
    }

    void add_truth(const std::string& group, const Json& truth) {
        Sample& sample = sample_of(group);
        const auto put = [&](const char* key, const Json& from, const char* name, double scale = 1) {
            if (from.contains(name) && from.at(name).is_number()) sample.values[key] = scale * from.at(name).get<double>();
            else sample.notes[key] = "nothing to compare";
        };
        put("psnr", truth, "psnr_mean");
        put("ssim", truth, "ssim_mean");
        put("psnr_seen", truth, "psnr_seen_mean");
        put("psnr_unseen", truth, "psnr_unseen_mean");
        put("psnr_worst", truth, "psnr_worst");
        put("floor", truth, "floor_db");
        if (!truth.contains("bounds")) {
            for (const char* key : {"psnr_a", "psnr_b", "gap_a", "closed"}) sample.notes[key] = "not asked: bounds = true in [held-out]";
            return;
        }
        put("psnr_a", truth.at("bounds").at("A"), "psnr_mean");
        put("psnr_b", truth.at("bounds").at("B"), "psnr_mean");
        put("gap_a", truth, "gap_to_a_db");
        put("closed", truth, "closed_share", 100);
    }

    using Labelled = std::pair<std::string, fs::path>;
    void show_pairs(const std::string& caption, const Labelled& truth, const Labelled& ours, bool wide = false) {
        const std::vector<fs::path> files = pictures_in(truth.second, "pictures");
        const fs::path errors = kept("errors-" + slug_of(caption), {{"truth", fingerprint(truth.second)}, {"ours", fingerprint(ours.second)}}, [&](const fs::path& to) {
            for (std::size_t i = 0; i < std::min<std::size_t>(files.size(), kShownPairs); ++i) {
                const fs::path name = file_at(files, i).filename();
                save_png(to / name, error_map(load_rgb8(truth.second / name), load_rgb8(ours.second / name)));
            }
        });
        for (std::size_t i = 0; i < std::min<std::size_t>(files.size(), kShownPairs); ++i) {
            const fs::path name = file_at(files, i).filename();
            figures_.push_back({i == 0 ? caption : "", {{truth.first, fs::relative(truth.second / name, in_.out)}, {ours.first, fs::relative(ours.second / name, in_.out)},
                                                        {"difference", fs::relative(errors / name, in_.out)}}, wide});
        }
    }
    // Spread over all of them: neighbours look alike.
    static const fs::path& file_at(const std::vector<fs::path>& files, std::size_t i) { return files[i * files.size() / std::min<std::size_t>(files.size(), kShownPairs)]; }

    static std::string fingerprint(const fs::path& pictures) {
        const auto stage = finished_stage(pictures.parent_path().parent_path(), pictures.parent_path().filename().string());
        if (stage) return stage->result;
        std::string times;
        for (const fs::path& file : pictures_in(pictures, "pictures"))
            times += fmt::format("{} {} {}\n", file.filename().string(), fs::file_size(file), fs::last_write_time(file).time_since_epoch().count());
        return times;
    }

    fs::path kept(const std::string& name, const Json& params, const std::function<void(const fs::path&)>& make) {
        make_directories(in_.work);
        run_stage(in_.work, name, stage_key("metrics", params, {name}, 0), run_, make);
        return in_.work / name;
    }
    // Hangs on the run's stages as they are now.
    fs::path made(const std::string& name, Json params, const RunFolder& folder, const std::function<void(const fs::path&)>& make) {
        for (const std::string_view stage : kStages)
            if (const auto record = finished_stage(folder.root, stage)) params["stage-" + std::string(stage)] = record->result;
        return kept(name, params, make);
    }

    Sample& sample_of(const std::string& group) {
        for (Sample& sample : samples_)
            if (sample.group == group) return sample;
        return samples_.emplace_back(Sample{group, "", {}, {}, {}});
    }

    const MeasureInputs& in_;
    const Run& run_;
    std::vector<Sample> samples_;
    std::vector<Figure> figures_;
};

}  // namespace

Measured measure_scene(const MeasureInputs& inputs, const RunFolder& folder, const Run& run) {
    SceneMeasures measures(inputs, run);
    if (inputs.suite->has("holes")) measures.holes(folder);
    if (inputs.suite->has("source")) measures.source(folder);
    if (inputs.suite->has("held-out")) measures.held_out(folder);
    if (inputs.suite->has("stills")) measures.stills(folder);
    return measures.take();
}

Measured measure_pictures(const MeasureInputs& inputs, const fs::path& folder, const Run& run) {
    SceneMeasures measures(inputs, run);
    measures.scores("stills", "", folder, "");
    measures.show_stills("", folder);
    return measures.take();
}

Json json_of(const Measured& measured) {
    Json samples = Json::array(), figures = Json::array();
    for (const Sample& s : measured.samples) {
        samples.push_back({{"group", s.group}, {"values", s.values}, {"notes", s.notes}});
        if (s.at) samples.back().update({{"series", s.series}, {"at", *s.at}});
    }
    for (const Figure& f : measured.figures) {
        Json pictures = Json::array();
        for (const auto& [label, file] : f.pictures) pictures.push_back({{"label", label}, {"file", file.generic_string()}});
        figures.push_back({{"caption", f.caption}, {"wide", f.wide}, {"pictures", pictures}});
    }
    return {{"samples", samples}, {"figures", figures}};
}

}  // namespace fastscene
