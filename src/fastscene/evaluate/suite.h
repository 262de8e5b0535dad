// A suite: what is to be made and measured, as a file says it. docs/evaluate.md is its reference; suites/ holds those
// that ship.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/pipeline/pipeline.h"

namespace fastscene {

// One scene: a sentence or a panorama, made once for each seed; or a finished run, taken as it is.
struct SuiteScene {
    std::string name;  // names its folders; unique
    SceneSource source;
    std::vector<std::uint64_t> seeds{0};
    std::filesystem::path
        run;  // the finished run's folder, read only; empty: the scene is made. Source and seed are then the run's
    std::string variant;  // of a run: the row that it belongs to
};
// One row of the table: what is set otherwise than in the suite.
struct SuiteVariant {
    std::string name;
    std::string quality;  // the preset that `params` came from
    SceneParams params;
    bool bounds = false;  // held out: also A and B
};
// Another system's pictures or splats (peers.h).
struct SuitePeer {
    std::string name;
    std::filesystem::path folder;
};
// A row of somebody's paper, by column.
struct PublishedRow {
    std::string name;
    std::map<std::string, double> values;
    bool ours = false;  // the row that this program should be held against
};
// Pictures of a scene without a reference.
struct StillsParams {
    int count = 30;
    int size_px = 0;  // 0: as fine as the panorama
    double fov_deg = 75, radius_m = 0.3;
};
struct HeldOutParams {
    int views = 10, size_px = 512;
    std::vector<double> radii_m{0.3};
    bool room = false;  // also wherever a visitor can stand
    bool bounds = false;
};

struct Suite {
    std::string name, title, about;
    std::vector<std::string> measures;  // of measure_names()
    std::vector<std::string> columns;   // of columns(), in the table's order
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

// A name as scenes, rows and peers have it on disk: as slug_of makes it, but letters of other alphabets stay: "Rote
// Küche" -> "rote-küche". At most 60 bytes of UTF-8.
std::string folder_name_of(std::string_view text);

// The stage that all measures of the suite can do with: "depth" where only holes are measured, else "splat".
std::string last_stage_of(const Suite& suite);

// `quality` (not empty) takes the place of every quality that the file names. Relative paths in the file start at its
// folder. Throws Error naming file, line and key, what was expected and found, and the known key that comes nearest;
// also for what could only fail later: columns that no measure fills, weights, folders and runs that are not there.
Suite read_suite(std::string_view text, const std::string& name, const std::filesystem::path& file,
                 const std::string& quality = "");

// A suite that ships, by name, or a file.
struct SuiteText {
    std::string name, text;
    std::filesystem::path file;  // what errors call it
};
SuiteText find_suite(const std::string& name_or_file);
// Names of those that ship, with their titles.
std::vector<std::pair<std::string, std::string>> shipped_suites();

}  // namespace fastscene
