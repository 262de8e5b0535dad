// Scores: the result of one measure for a folder of pictures, cached on disk by everything it depends on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"

namespace fastscene {

struct Score {
    Json value;  // mean over the pictures that have a value; "inf" if all equal their references; null: none
    int pictures = 0, counted = 0;   // counted: number in the mean
    std::vector<std::string> notes;  // pictures excluded from the mean, with reasons; other caveats
};

struct ScoreInputs {
    std::filesystem::path pictures, reference;  // folders; reference may be empty
    std::string pictures_key, reference_key;    // hash of their content
    std::string prompt;                         // empty: none
    std::filesystem::path weights;
    std::string parameters;  // identity of the measure's parameter files
};
// Caches in `kept`/`measure`/. Throws Error if a picture is invalid.
Score score_of(const std::string& measure, const ScoreInputs& inputs, const std::filesystem::path& kept,
               const Run& run);

// From the report of measure_images (metrics/images.h); `transparent`: number of partly transparent pictures.
Score score_from_report(const Json& report, const std::string& measure, int transparent);

}  // namespace fastscene
