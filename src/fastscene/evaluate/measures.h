// Measures of one scene: pictures are made and judged, figures come back by column. Everything is kept on disk under a
// key, so that what was measured once is not measured again.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// Figures of one scene for one row. A value is a number, or "inf" for equal pictures; a column without one has notes
// why, and one with a value may have notes on what it leaves out.
struct Sample {
    std::string group;   // which of the variant's rows; empty: its own
    std::string series;  // with `at`: a point of a curve (holes along x over the step; PSNR over the radius)
    std::optional<double> at;
    std::map<std::string, Json> values{};
    std::map<std::string, std::vector<std::string>> notes{};
    struct Share {
        int counted = 0, of = 0;
    };
    std::map<std::string, Share> pictures{};  // of columns whose mean leaves pictures out
    bool shared = false;                      // one figure for all scenes: it has no deviation
};
// Pictures side by side, for the report; files relative to the output folder.
struct Figure {
    std::string caption;
    std::vector<std::pair<std::string, std::filesystem::path>> pictures;  // label, file
    bool wide = false;                                                    // panoramas: one below the other
};
struct Measured {
    std::vector<Sample> samples;
    std::vector<Figure> figures;
    std::map<std::string, Json> parameters;  // column -> {"files", "identity"}: what its measure was given
};

struct MeasureInputs {
    const Suite* suite = nullptr;
    std::filesystem::path out;      // figures' files are relative to this
    std::filesystem::path work;     // where this scene's measures are kept
    std::filesystem::path truth;    // where true pictures are kept that scenes of one room share
    bool bounds = false;            // held out: also A and B
    bool read_only = false;         // the run is somebody else's: nothing is written into it
    std::filesystem::path weights;  // parameters and networks
    std::string prompt;             // for the CLIP score; empty: none
};

// The measures of the suite, on the run in `folder`. Throws Error when a picture or a file is wrong.
Measured measure_scene(const MeasureInputs& inputs, const RunFolder& folder, const Run& run);

// What another system has of a scene; any may be empty.
struct OtherScene {
    std::filesystem::path pictures;  // a folder of its own stills
    std::filesystem::path sphere;    // all around, from panorama 0's place
    std::filesystem::path splats;    // in our frame: panorama 0 stands at the origin
};
// The measures of the suite that these allow. Our own run of the scene, where there is one, lends its panorama, its
// cameras and its room; without one splats are seen by the cameras of a panorama `width` pixels wide.
Measured measure_other(const MeasureInputs& inputs, const OtherScene& other, const std::optional<RunFolder>& ours,
                       int width, const Run& run);

Json json_of(const Measured& measured);

// Names of rows within a variant.
inline constexpr const char* kOriginGroup = "seen from panorama 0's place";
inline constexpr const char* kInputGroup = "panorama 0's own crops";

}  // namespace fastscene
