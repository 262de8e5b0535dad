// Picture metrics: without reference (NIQE, BRISQUE), against a reference of the same name (PSNR, SSIM, LPIPS), against
// a text (CLIP score).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"

namespace fastscene {

struct ImageMeasures {
    std::filesystem::path pictures;   // a file, or a folder of color pictures
    std::filesystem::path reference;  // same names as the pictures; empty: none
    std::string prompt;               // empty: none
    std::filesystem::path weights;    // parameters and networks (metrics_weights_text describes the layout)
    std::vector<std::string> wanted;  // measures to compute; empty: all that the inputs allow
};
// Valid names for `wanted`.
const std::vector<std::string>& image_measure_names();

// Returns {"count": pictures measured, "pictures": [{"name", "psnr", …}], "left_out": {picture: why it or its partner
// cannot be read}, "mean": {…}, "mean_of": {measure: pictures with a finite value}, "missing": {measure: what to fetch,
// or what is wrong with its file}, "undefined": {picture: {measure: why}}, "models": {measure: [{"file", "sha256"}]},
// "transparent": [files measured over black], "without_picture": unused references}. Unavailable measures and measures
// with broken files are listed in "missing" and do not affect others. Throws Error or UsageError if there are no
// readable pictures, or partners are missing or differ in size.
Json measure_images(const ImageMeasures& inputs, const Run& run);
// The same as a table for people.
std::string image_table(const Json& report);
// Those of `wanted` for which no picture of the report has a value.
std::vector<std::string> not_measured(const Json& report, const std::vector<std::string>& wanted);

// Measures of `wanted` (empty: all) whose parameters or networks are missing in the folder: name -> what to fetch.
Json missing_measures(const std::filesystem::path& weights, const std::vector<std::string>& wanted);
// The existing files or folders that a measure takes its parameters and networks from.
std::vector<std::filesystem::path> measure_files(const std::filesystem::path& weights, const std::string& measure);

// `given`, which must be a folder (else Error), or $FASTSCENE_WEIGHTS, or metrics/ in the user's cache.
std::filesystem::path metrics_weights(const std::filesystem::path& given);
// Describes the measures, the files that the folder should contain, and where to get them.
std::string metrics_weights_text();

// Pictures of a file or folder, sorted by name.
std::vector<std::filesystem::path> pictures_in(const std::filesystem::path& place, const std::string& flag);

}  // namespace fastscene
