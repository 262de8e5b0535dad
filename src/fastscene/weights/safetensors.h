// The safetensors format: an 8 byte little-endian length, a JSON header of that length, then the tensors' bytes.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/weights/mapped_file.h"
#include "fastscene/weights/weights.h"

namespace fastscene {

// Validates every offset, shape and size against the file before use. Throws Error naming the file and the tensor.
Weights load_safetensors(std::shared_ptr<const MappedFile> file);

// Writes under a temporary name, then renames, so that a full disk cannot destroy an existing file. Floating-point
// tensors are converted as `as` says.
enum class SaveAs { unchanged, f32, f16, bf16 };
void save_safetensors(const std::filesystem::path& path, const Weights& weights, SaveAs as = SaveAs::unchanged);

}  // namespace fastscene
