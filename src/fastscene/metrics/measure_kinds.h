// The measures of pictures: what each is called, what it needs, where its parameters lie, and how it is made ready.
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

// What is measured: a picture, and the one it should be where there is one (else empty).
struct Subject {
    const ImageRgb8& picture;
    const ImageRgb8& reference;
    std::map<const ClipMeasure*, std::vector<float>> seen = {};  // by a network of CLIP; two measures read the same
};
// Throws Error when the score is not defined for this picture.
using PictureMeasure = std::function<double(Subject&)>;

enum class Needs { nothing, reference, prompt };
// What becomes of a measure that nobody asked for by name.
enum class Unasked { measured, measured_if_there, left_out };
struct MeasureKind {
    std::string name, about;
    Needs needs = Needs::nothing;
    std::vector<std::string> files;  // below the weights' folder; alternatives joined with |
    std::string source;
    std::string model;  // as `models` calls it; empty: not to be pulled
    Unasked unasked = Unasked::measured;
};
const std::vector<MeasureKind>& measure_kinds();

// The files of a measure, in the folder or among the models that were pulled, or what of them is not there and how to
// get it.
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
    std::shared_ptr<const ClipMeasure> clip = {};  // whose view of the picture it reads
};
// Networks that several measures share.
using LoadedClips = std::map<std::filesystem::path, std::shared_ptr<const ClipMeasure>>;
// Throws Error naming the file, what was expected and what was found.
ReadyMeasure ready_measure(const MeasureKind& kind, const std::vector<std::filesystem::path>& files,
                           const std::string& prompt, LoadedClips& clips);
// Fills what CLIP's networks see in the pictures, all at a time. Where that fails it is left to the measure, which says
// why of which picture.
void look_together(std::vector<Subject>& subjects, const std::vector<ReadyMeasure>& measures);

}  // namespace fastscene
