// Collects the results of measuring one scene: figures by row and column, pictures for the page, and the folder that
// caches both.
#pragma once

#include <functional>

#include "fastscene/evaluate/measures.h"

namespace fastscene {

class MeasureSheet {
  public:
    MeasureSheet(const MeasureInputs& inputs, const Run& run) : in_(inputs), run_(run) {}

    Sample& sample_of(const std::string& group);
    // Adds the same note to every column of a measure.
    void note_all(const std::string& measure, const std::string& note);
    // Fills the picture-based columns of `measure` from a folder; `reference`: folder of reference pictures, or empty.
    void scores(const std::string& measure, const std::string& group, const std::filesystem::path& pictures,
                const std::filesystem::path& reference);

    void show_stills(const std::string& caption, const std::filesystem::path& pictures);
    using Labelled = std::pair<std::string, std::filesystem::path>;
    // Shows pictures of equal names, and their differences.
    void show_pairs(const std::string& caption, const Labelled& truth, const Labelled& judged, bool wide = false);

    // A folder in the scene's work folder, made by `make` unless it already exists with the same params.
    std::filesystem::path kept(const std::string& name, const Json& params,
                               const std::function<void(const std::filesystem::path&)>& make);
    // The same, additionally keyed by the current state of the run's stages.
    std::filesystem::path made(const std::string& name, Json params, const RunFolder& folder,
                               const std::function<void(const std::filesystem::path&)>& make);

    Measured take() { return std::move(measured_); }

  private:
    const MeasureInputs& in_;
    const Run& run_;
    Measured measured_;
};

}  // namespace fastscene
