// Where models lie on this machine, and which are there.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "fastscene/models/registry.h"

namespace fastscene {

// $FASTSCENE_MODELS, else fastscene/models in the user's cache (XDG).
std::filesystem::path models_root();

// Where the file lies, under the first of its names that is there with the size it must have.
std::optional<std::filesystem::path> file_in_cache(const Model& model, const ModelFile& file,
                                                   const std::filesystem::path& root = models_root());
// All of the model's files are there.
bool is_in_cache(const Model& model, const std::filesystem::path& root = models_root());

// For whoever loads a network: the model's folder, when all of it is there.
std::optional<std::filesystem::path> cached_model(std::string_view name);
// The one file of a model that has only one.
std::optional<std::filesystem::path> cached_file(std::string_view name);

}  // namespace fastscene
