// A suite: what to make and measure, as described by a file. docs/evaluate.md is its reference; suites/ contains the
// built-in ones.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/pipeline/pipeline.h"

namespace fastscene {

// A scene: a prompt or a panorama, made once per seed; or a finished run.
struct SuiteScene {
    std::string name;  // names its folders; unique
    SceneSource source;
    std::vector<std::uint64_t> seeds{0};
    std::filesystem::path
        run;  // folder of a finished run, read-only; empty: make the scene. Source and seed are then the run's
    std::string variant;  // for runs: the row that it belongs to
};
// One row of the table: settings that differ from the suite's.
struct SuiteVariant {
    std::string name;
    std::string quality;  // the preset that `params` started from
    SceneParams params;
    bool bounds = false;  // held-out: include bounds A and B
};
// Another system's pictures or splats (peers.h).
struct SuitePeer {
    std::string name;
    std::filesystem::path folder;
};
// A row of published figures, by column.
struct PublishedRow {
    std::string name;
    std::map<std::string, double> values;
    bool ours = false;  // the row that our results should be compared with
};
// Pictures of a scene without reference.
struct StillsParams {
    int count = 30;
    int size_px = 0;  // 0: the panorama's resolution
    double fov_deg = 75, radius_m = 0.3;
};
struct HeldOutParams {
    int views = 10, size_px = 512;
    std::vector<double> radii_m{0.3};
    bool room = false;  // also from wherever a visitor can stand
    bool bounds = false;
};

struct Suite {
    std::string name, title, about;
    std::vector<std::string> measures;  // from measure_names()
    std::vector<std::string> columns;   // from columns(), in the table's order
    std::vector<std::string> notes;     // how this protocol differs from the published one
    StillsParams stills;
    HeldOutParams held_out;
    std::vector<SuiteScene> scenes;
    std::vector<SuiteVariant> variants;  // at least one
    std::vector<PublishedRow> published;
    std::vector<SuitePeer> peers;
    bool has(std::string_view measure) const;
};
// "stills", "source", "held-out", "holes".
const std::vector<std::string>& measure_names();

// Folder name for scenes, rows and peers: like slug_of, but keeping letters of other alphabets: "Rote Küche" ->
// "rote-küche". At most 60 bytes of UTF-8.
std::string folder_name_of(std::string_view text);

// The last stage that the suite's measures need: "depth" if only holes are measured, else "splat".
std::string last_stage_of(const Suite& suite);

// `quality` (if not empty) overrides every quality in the file. Relative paths in the file start at its folder. Throws
// Error naming file, line and key, expected and actual, and the most similar known key; also for what would fail later:
// columns without a measure, missing weights, folders and runs.
Suite read_suite(std::string_view text, const std::string& name, const std::filesystem::path& file,
                 const std::string& quality = "");

// A built-in suite by name, or a file.
struct SuiteText {
    std::string name, text;
    std::filesystem::path file;  // its name in errors
};
SuiteText find_suite(const std::string& name_or_file);
// Names of the built-in suites, with titles.
std::vector<std::pair<std::string, std::string>> shipped_suites();

}  // namespace fastscene
