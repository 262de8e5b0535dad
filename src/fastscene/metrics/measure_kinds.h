// Definitions of the picture metrics: name, requirements, parameter files, and construction.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fastscene/image/image.h"
#include "fastscene/nn/perceptual.h"

namespace fastscene {

// A picture to measure, and its reference (or empty).
struct Subject {
    const ImageRgb8& picture;
    const ImageRgb8& reference;
    // cached CLIP features by network; two measures share them
    std::map<const ClipMeasure*, std::vector<float>> seen = {};
};
// Throws Error if the score is undefined for this picture.
using PictureMeasure = std::function<double(Subject&)>;

enum class Needs { nothing, reference, prompt };
// What happens to a measure that was not requested by name.
enum class Unasked { measured, measured_if_there, left_out };
struct MeasureKind {
    std::string name, about;
    Needs needs = Needs::nothing;
    std::vector<std::string> files;  // relative to the weights' folder; alternatives separated by |
    std::string source;
    std::string model;  // its name for `models pull`; empty: not available there
    Unasked unasked = Unasked::measured;
};
const std::vector<MeasureKind>& measure_kinds();

// The files of a measure, from the folder or the pulled models; or what is missing and how to get it.
struct MeasureFiles {
    std::vector<std::filesystem::path> files;
    std::string absent;
};
MeasureFiles look_for(const MeasureKind& kind, const std::filesystem::path& weights);

// A measure with its parameters loaded, and the files that they came from.
struct ReadyMeasure {
    std::string name;
    PictureMeasure measure;
    std::vector<std::filesystem::path> files;
    std::shared_ptr<const ClipMeasure> clip = {};  // the network whose features it uses
};
// Networks shared between measures.
using LoadedClips = std::map<std::filesystem::path, std::shared_ptr<const ClipMeasure>>;
// Throws Error naming the file, expected and actual.
ReadyMeasure ready_measure(const MeasureKind& kind, const std::vector<std::filesystem::path>& files,
                           const std::string& prompt, LoadedClips& clips);
// Computes CLIP features for all pictures in batches. On failure the measures compute them one by one and report the
// reason per picture.
void look_together(std::vector<Subject>& subjects, const std::vector<ReadyMeasure>& measures);

}  // namespace fastscene
