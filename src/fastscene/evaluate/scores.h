// Scores: what one measure says of a folder of pictures, kept on disk under all that it hangs on, so that what was
// judged once is not judged again, and what changed is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"

namespace fastscene {

struct Score {
    Json value;  // the mean over the pictures that have one; "inf" where all are equal to their references; null: none
                 // has
    int pictures = 0, counted = 0;   // counted: those in the mean
    std::vector<std::string> notes;  // which pictures are not in it, and why; which are not what they seem
};

struct ScoreInputs {
    std::filesystem::path pictures, reference;  // folders; reference may be empty
    std::string pictures_key, reference_key;    // of what is in them
    std::string prompt;                         // empty: none
    std::filesystem::path weights;
    std::string parameters;  // identity of the measure's parameter files
};
// `kept`/`measure`/ has the score. Throws Error where a picture is wrong.
Score score_of(const std::string& measure, const ScoreInputs& inputs, const std::filesystem::path& kept,
               const Run& run);

// Of what measure_images reported (metrics/images.h); `transparent`: how many of the pictures are so in parts.
Score score_from_report(const Json& report, const std::string& measure, int transparent);

}  // namespace fastscene
