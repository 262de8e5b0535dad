#include "fastscene/evaluate/measures.h"

#include "fastscene/base/content_identity.h"
#include "fastscene/base/file.h"
#include "fastscene/evaluate/measure_sheet.h"
#include "fastscene/evaluate/picture.h"
#include "fastscene/evaluate/stills.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/metrics/images.h"
#include "fastscene/pipeline/hole_report.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/splat/splat.h"
#include "fastscene/pipeline/truth.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class SceneMeasures {
  public:
    SceneMeasures(const MeasureInputs& inputs, const Run& run) : in_(inputs), run_(run), sheet_(inputs, run) {}

    void stills(const RunFolder& folder) {
        const StillsParams& p = in_.suite->stills;
        const fs::path dir = sheet_.made("stills", stills_json(), folder, [&](const fs::path& to) {
            const Panorama first = load_first_panorama(folder);
            const Splats splats = load_splat_ply(folder.scene_ply());
            const Pinhole camera = still_camera(p, first.color.width);
            save_walked_stills(to / "walked", splats, p, camera, first.range, run_);
            save_origin_stills(to / "origin", splats, p, camera, run_);
            save_input_stills(to / "input", first, p, camera, run_);
        });
        sheet_.scores("stills", "", dir / "walked", "");
        sheet_.scores("stills", kOriginGroup, dir / "origin", "");
        sheet_.scores("stills", kInputGroup, dir / "input", "");
        sheet_.show_stills("The splats, from within " + fmt::format("{} m of panorama 0", p.radius_m), dir / "walked");
        sheet_.show_pairs("Panorama 0's own crop, and the splats from the same place", {"panorama 0", dir / "input"},
                          {"splats", dir / "origin"});
    }
    // Another system's results: its own pictures, or its splats rendered with the cameras of our scene.
    void stills(const OtherScene& other, const std::optional<RunFolder>& ours, int width) {
        fs::path dir = other.pictures;
        if (dir.empty() && other.splats.empty()) return sheet_.note_all("stills", "needs pictures or splats");
        if (dir.empty()) {
            Json params = stills_json();
            params.update({{"splats", content_identity(other.splats)}, {"width", ours ? 0 : width}});
            const auto draw = [&](const fs::path& to) {
                const Panorama first = ours ? load_first_panorama(*ours) : Panorama{};
                const StillsParams& p = in_.suite->stills;
                save_walked_stills(to / "walked", load_splats(other.splats).splats, p,
                                   still_camera(p, ours ? first.color.width : width), first.range, run_);
            };
            dir = (ours ? sheet_.made("stills", params, *ours, draw) : sheet_.kept("stills", params, draw)) / "walked";
        }
        sheet_.scores("stills", "", dir, "");
        sheet_.show_stills("", dir);
    }

    void source(const RunFolder& folder) {
        source(folder, {}, "splats",
               [&](int width) { return sphere_of(load_splat_ply(folder.scene_ply()), width, {}).color; });
    }
    void source(const OtherScene& other, const std::optional<RunFolder>& ours) {
        if (other.sphere.empty() && other.splats.empty())
            return sheet_.note_all("source", "needs source.png, or splats in our frame");
        if (!ours)
            return sheet_.note_all("source", "needs our own run of the scene, whose panorama it is compared with");
        const fs::path& given = other.sphere.empty() ? other.splats : other.sphere;
        source(*ours, {{"given", content_identity(given)}, {"sphere", !other.sphere.empty()}}, "theirs",
               [&](int width) {
                   if (other.sphere.empty()) return sphere_of(load_splats(other.splats).splats, width, {}).color;
                   ImageRgb8 sphere = load_rgb8(other.sphere);
                   if (sphere.width != width || 2 * sphere.height != width)
                       throw Error("{}: expected {} x {} as panorama 0 of {} is, found {} x {}", other.sphere.string(),
                                   width, width / 2, ours->root.string(), sphere.width, sphere.height);
                   return sphere;
               });
    }

    void held_out(const RunFolder& folder) { held_out(folder, {}); }
    void held_out(const OtherScene& other, const std::optional<RunFolder>& ours) {
        if (other.splats.empty()) return sheet_.note_all("held-out", "needs splats in our frame");
        if (!ours) return sheet_.note_all("held-out", "needs our own run of the scene, whose room it is compared with");
        held_out(*ours, other.splats);
    }

    void holes(const RunFolder& folder) {
        const fs::path dir = sheet_.made("holes", {}, folder, [&](const fs::path& to) {
            save_hole_table(to, hole_table_of_run(folder.root, has_room(recorded_run(folder).request.source), run_));
        });
        const Json table = read_json(dir / "hole_table.json");
        for (const Json& row : table.at("rows")) {
            const std::string axis = row.at("axis");
            Sample& sample = sheet_.sample_of(fmt::format("{} {:+.2f}", axis, row.at("share").get<double>()));
            sample.series = "along " + axis;
            sample.at = row.at("share").get<double>();
            const auto percent = [](const Json& share) { return Json(100 * share.get<double>()); };
            sample.values["holes_paper"] = percent(row.at("paper"));
            sample.values["holes_published"] = percent(row.at("published"));
            sample.values["holes"] = percent(row.at("ours"));
            if (row.contains("truth")) sample.values["holes_true"] = percent(row.at("truth").at("ratio"));
            else
                sample.notes["holes_true"] = {row.at("in_room").get<bool>() ? "needs a room behind the scene"
                                                                            : "the step ends in or behind a surface"};
        }
    }

    Measured take() { return sheet_.take(); }

  private:
    Json stills_json() const {
        const StillsParams& p = in_.suite->stills;
        return {{"count", p.count}, {"size", p.size_px}, {"fov", p.fov_deg}, {"radius", p.radius_m}};
    }

    // Compares `sphere`, rendered at the width of the folder's panorama 0, against it.
    void source(const RunFolder& folder, const Json& params, const std::string& label,
                const std::function<ImageRgb8(int width)>& sphere) {
        const fs::path dir = sheet_.made("source", params, folder, [&](const fs::path& to) {
            const ImageRgb8 first = load_rgb8(folder.panorama_color());
            make_directories(to / "splats");
            make_directories(to / "panorama");
            save_png(to / "splats/sphere.png", sphere(first.width));
            save_png(to / "panorama/sphere.png", first);
        });
        sheet_.scores("source", "", dir / "splats", dir / "panorama");
        sheet_.show_pairs("All around, from panorama 0's place", {"panorama 0", dir / "panorama"},
                          {label, dir / "splats"}, true);
    }

    // `theirs`: evaluated instead of the run's own splats.
    void held_out(const RunFolder& folder, const fs::path& theirs) {
        if (!has_room(recorded_run(folder).request.source))
            return sheet_.note_all("held-out", "needs a room behind the scene: a prompt, not a picture");
        const HeldOutParams& p = in_.suite->held_out;
        const Run poses_run{0, run_.events, run_.stop};
        RunTruth room(folder.root, in_.truth, poses_run);
        const bool several = p.radii_m.size() + p.room > 1;
        for (const double radius : p.radii_m) {
            const std::string within = fmt::format("within {} m", radius);
            held_out_at(room, folder, theirs, near_params(radius, theirs),
                        {fmt::format("held-out-{}", radius), several ? within : "", within});
            if (several) sheet_.sample_of(within).at = radius;
        }
        if (!p.room) return;
        const std::string anywhere = "anywhere in the room";
        held_out_at(room, folder, theirs, room_params(theirs), {"held-out-room", several ? anywhere : "", anywhere});
    }

    TruthParams room_params(const fs::path& theirs) const {
        const HeldOutParams& p = in_.suite->held_out;
        return {.where = "room", .views = p.views, .size_px = p.size_px, .bounds = in_.bounds && theirs.empty()};
    }
    TruthParams near_params(double radius, const fs::path& theirs) const {
        TruthParams params = room_params(theirs);
        params.where = "near";
        params.radius_m = static_cast<float>(radius);
        return params;
    }

    // Pose sampling region, as labelled in the report.
    struct HeldOutPlace {
        std::string folder, group, caption;
    };
    void held_out_at(RunTruth& room, const RunFolder& folder, const fs::path& theirs, const TruthParams& params,
                     const HeldOutPlace& place) {
        Json key{{"views", params.views}, {"size", params.size_px}, {"bounds", params.bounds}};
        if (params.where == "near") key["radius"] = params.radius_m;
        if (!theirs.empty()) key["splats"] = content_identity(theirs);
        const auto make = [&](const fs::path& to) { make_held_out(room, folder, theirs, params, to); };
        const fs::path dir = sheet_.made(place.folder, key, folder, make);
        add_truth(place.group, read_json(dir / "truth.json"), !theirs.empty());
        sheet_.scores("held-out", place.group, dir / "splats", dir / "truth");
        sheet_.show_pairs("At poses never trained on, " + place.caption, {"the traced room", dir / "truth"},
                          {theirs.empty() ? "splats" : "theirs", dir / "splats"});
    }

    void make_held_out(RunTruth& room, const RunFolder& folder, const fs::path& theirs, const TruthParams& params,
                       const fs::path& to) {
        const HeldOutParams& p = in_.suite->held_out;
        const bool in_run = theirs.empty() && !in_.read_only;
        const fs::path strips = in_run ? folder.metrics() : in_.work / "strips";
        const Json truth = room.measure(params, theirs, strips).at("truth");
        make_directories(to / "truth");
        make_directories(to / "splats");
        for (const fs::path& strip : pictures_in(strips / "truth", "held-out")) {
            const std::string name = strip.filename().string();
            // from an earlier evaluation of this scene with more views
            if (std::stoi(strip.stem().string()) >= p.views) continue;
            const ImageRgb8 all = load_rgb8(strip);
            save_png(to / "truth" / name, cut_out(all, 0, 0, all.height, all.height));
            save_png(to / "splats" / name, cut_out(all, all.height, 0, all.height, all.height));
        }
        if (!in_run) fs::remove_all(strips / "truth");
        write_json(to / "truth.json", truth);
    }

    void add_truth(const std::string& group, const Json& truth, bool of_another) {
        Sample& sample = sheet_.sample_of(group);
        const auto put = [&](const char* key, const Json& from, const char* name, double scale = 1) {
            if (from.contains(name) && from.at(name).is_number())
                sample.values[key] = scale * from.at(name).get<double>();
            else sample.notes[key] = {"nothing to compare"};
        };
        put("psnr", truth, "psnr_mean");
        put("ssim", truth, "ssim_mean");
        put("psnr_seen", truth, "psnr_seen_mean");
        put("psnr_unseen", truth, "psnr_unseen_mean");
        put("psnr_worst", truth, "psnr_worst");
        put("psnr_worst5", truth, "psnr_worst5_mean");
        put("low_alpha", truth, "low_alpha_share", 100);
        put("floor", truth, "floor_db");
        if (!truth.contains("bounds")) {
            const char* why = of_another ? "says something of our own trainer"
                                         : "not asked: bounds = true in [held-out]";
            for (const char* key : {"psnr_a", "psnr_b", "gap_a", "closed", "walked", "splat_loss"})
                sample.notes[key] = {why};
            return;
        }
        put("psnr_a", truth.at("bounds").at("A"), "psnr_mean");
        put("psnr_b", truth.at("bounds").at("B"), "psnr_mean");
        put("gap_a", truth, "gap_to_a_db");
        put("closed", truth, "closed_share", 100);
        // absent in measurements by earlier versions
        const Json at_walked = truth.value("walked_poses", Json::object());
        put("walked", at_walked, "walk_psnr_mean");
        put("splat_loss", at_walked, "splat_stage_loses_db");
    }

    const MeasureInputs& in_;
    const Run& run_;
    MeasureSheet sheet_;
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

Measured measure_other(const MeasureInputs& inputs, const OtherScene& other, const std::optional<RunFolder>& ours,
                       int width, const Run& run) {
    SceneMeasures measures(inputs, run);
    if (inputs.suite->has("source")) measures.source(other, ours);
    if (inputs.suite->has("held-out")) measures.held_out(other, ours);
    if (inputs.suite->has("stills")) measures.stills(other, ours, width);
    return measures.take();
}

Json json_of(const Measured& measured) {
    Json samples = Json::array(), figures = Json::array();
    for (const Sample& s : measured.samples) {
        samples.push_back({{"group", s.group}, {"values", s.values}, {"notes", s.notes}});
        for (const auto& [column, share] : s.pictures)
            samples.back()["pictures"][column] = {{"counted", share.counted}, {"of", share.of}};
        if (s.shared) samples.back()["shared"] = true;
        if (s.at) samples.back().update({{"series", s.series}, {"at", *s.at}});
    }
    for (const Figure& f : measured.figures) {
        Json pictures = Json::array();
        for (const auto& [label, file] : f.pictures)
            pictures.push_back({{"label", label}, {"file", file.generic_string()}});
        figures.push_back({{"caption", f.caption}, {"wide", f.wide}, {"pictures", pictures}});
    }
    return {{"samples", samples}, {"figures", figures}, {"parameters", measured.parameters}};
}

}  // namespace fastscene
