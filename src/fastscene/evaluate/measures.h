// Measures one scene: makes and evaluates pictures, returns figures by column. Everything is cached on disk by key, so
// that nothing is measured twice.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// Figures of one scene for one row. A value is a number, or "inf" for equal pictures; a missing value has notes with
// the reason, and a value may have notes on what it omits.
struct Sample {
    std::string group;   // selects one of the variant's rows; empty: its main row
    std::string series;  // with `at`: a point of a curve (holes along x over the step; PSNR over the radius)
    std::optional<double> at;
    std::map<std::string, Json> values{};
    std::map<std::string, std::vector<std::string>> notes{};
    struct Share {
        int counted = 0, of = 0;
    };
    std::map<std::string, Share> pictures{};  // for columns whose mean omits pictures
    bool shared = false;                      // one figure for all scenes, without deviation
};
// Pictures side by side, for the report; files relative to the output folder.
struct Figure {
    std::string caption;
    std::vector<std::pair<std::string, std::filesystem::path>> pictures;  // label, file
    bool wide = false;                                                    // panoramas: stacked vertically
};
struct Measured {
    std::vector<Sample> samples;
    std::vector<Figure> figures;
    std::map<std::string, Json> parameters;  // column -> {"files", "identity"}: the parameters that its measure used
};

struct MeasureInputs {
    const Suite* suite = nullptr;
    std::filesystem::path out;      // figures' files are relative to this folder
    std::filesystem::path work;     // cache of this scene's measures
    std::filesystem::path truth;    // cache of ground truth, shared by scenes of the same room
    bool bounds = false;            // held-out: include bounds A and B
    bool read_only = false;         // the run belongs to someone else: never write into it
    std::filesystem::path weights;  // parameters and networks
    std::string prompt;             // for the CLIP score; empty: none
};

// Computes the suite's measures for the run in `folder`. Throws Error if a picture or file is invalid.
Measured measure_scene(const MeasureInputs& inputs, const RunFolder& folder, const Run& run);

// What another system provides for a scene; each may be empty.
struct OtherScene {
    std::filesystem::path pictures;  // a folder of its own stills
    std::filesystem::path sphere;    // a panorama from panorama 0's position
    std::filesystem::path splats;    // in our frame: panorama 0 is at the origin
};
// Computes the suite's measures as far as these inputs allow. If our own run of the scene exists, its panorama, cameras
// and room are used; otherwise splats are rendered with the cameras of a panorama `width` pixels wide.
Measured measure_other(const MeasureInputs& inputs, const OtherScene& other, const std::optional<RunFolder>& ours,
                       int width, const Run& run);

Json json_of(const Measured& measured);

// Names of the rows within a variant.
inline constexpr const char* kOriginGroup = "seen from panorama 0's place";
inline constexpr const char* kInputGroup = "panorama 0's own crops";

}  // namespace fastscene
