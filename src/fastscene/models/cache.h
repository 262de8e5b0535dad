// Location of models on this machine, and which are present.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "fastscene/models/registry.h"

namespace fastscene {

// $FASTSCENE_MODELS, or fastscene/models in the user's cache (XDG).
std::filesystem::path models_root();

// Path of the file, under the first of its names that exists with the right size.
std::optional<std::filesystem::path> file_in_cache(const Model& model, const ModelFile& file,
                                                   const std::filesystem::path& root = models_root());
// Whether all of the model's files exist.
bool is_in_cache(const Model& model, const std::filesystem::path& root = models_root());

// The model's folder, if complete; for code that loads networks.
std::optional<std::filesystem::path> cached_model(std::string_view name);
// The file of a single-file model.
std::optional<std::filesystem::path> cached_file(std::string_view name);

}  // namespace fastscene
