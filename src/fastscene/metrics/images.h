// Pictures measured: each by itself (NIQE, BRISQUE), against the picture of the same name that it should be (PSNR,
// SSIM, LPIPS), against the sentence that it should show (CLIP score).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"

namespace fastscene {

struct ImageMeasures {
    std::filesystem::path pictures;   // a file or a folder of color pictures
    std::filesystem::path reference;  // same names; empty: none
    std::string prompt;               // empty: none
    std::filesystem::path weights;    // parameters and networks (metrics_weights_text says what goes where)
    std::vector<std::string> wanted;  // empty: all that these inputs allow
};
// Names that `wanted` may hold.
const std::vector<std::string>& image_measure_names();

// {"count": pictures measured, "pictures": [{"name", "psnr", …}], "left_out": {picture: why it, or its partner, cannot
// be read}, "mean": {…}, "mean_of": {measure: pictures with a finite value}, "missing": {measure: what to fetch, or
// what is wrong with its file}, "undefined": {picture: {measure: why}}, "models": {measure: [{"file", "sha256"}]},
// "transparent": [files measured over black], "without_picture": references that nothing was compared with}.
// A measure that is not there or whose file is broken is in "missing", never silently absent, and costs no other.
// Throws Error or UsageError: no pictures, none that can be read, no partner, other sizes.
Json measure_images(const ImageMeasures& inputs, const Run& run);
// The same as a table for people.
std::string image_table(const Json& report);
// Those of `wanted` that no picture of the report has a value of.
std::vector<std::string> not_measured(const Json& report, const std::vector<std::string>& wanted);

// Measures of `wanted` (empty: all) whose parameters or networks the folder lacks: name -> what to fetch.
Json missing_measures(const std::filesystem::path& weights, const std::vector<std::string>& wanted);
// The files, or folders of files, that a measure takes its parameters and networks from, as far as they are there.
std::vector<std::filesystem::path> measure_files(const std::filesystem::path& weights, const std::string& measure);

// `given`, which must be a folder (Error), else $FASTSCENE_WEIGHTS, else metrics/ in the user's cache.
std::filesystem::path metrics_weights(const std::filesystem::path& given);
// What the measures are, which files the folder should hold, and where they come from.
std::string metrics_weights_text();

// Pictures of a file or folder, by name.
std::vector<std::filesystem::path> pictures_in(const std::filesystem::path& place, const std::string& flag);

}  // namespace fastscene
