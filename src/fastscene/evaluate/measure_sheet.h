// What the measures of one scene fill in: figures by row and column, pictures for the page, and the folder where both
// are kept.
#pragma once

#include <functional>

#include "fastscene/evaluate/measures.h"

namespace fastscene {

class MeasureSheet {
  public:
    MeasureSheet(const MeasureInputs& inputs, const Run& run) : in_(inputs), run_(run) {}

    Sample& sample_of(const std::string& group);
    // The same note in every column of a measure.
    void note_all(const std::string& measure, const std::string& note);
    // The columns of `measure` that pictures fill, over a folder of them; `reference`: what they should be, or empty.
    void scores(const std::string& measure, const std::string& group, const std::filesystem::path& pictures,
                const std::filesystem::path& reference);

    void show_stills(const std::string& caption, const std::filesystem::path& pictures);
    using Labelled = std::pair<std::string, std::filesystem::path>;
    // Pictures of equal names, and where they differ.
    void show_pairs(const std::string& caption, const Labelled& truth, const Labelled& judged, bool wide = false);

    // A folder below the scene's work folder, made by `make` unless it is there from the same params.
    std::filesystem::path kept(const std::string& name, const Json& params,
                               const std::function<void(const std::filesystem::path&)>& make);
    // The same; hangs also on the run's stages as they are now.
    std::filesystem::path made(const std::string& name, Json params, const RunFolder& folder,
                               const std::function<void(const std::filesystem::path&)>& make);

    Measured take() { return std::move(measured_); }

  private:
    const MeasureInputs& in_;
    const Run& run_;
    Measured measured_;
};

}  // namespace fastscene
