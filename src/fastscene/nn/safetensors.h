// The safetensors format: 8 bytes little endian = length of a JSON header, the header, then the tensors' bytes.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/nn/mapped_file.h"
#include "fastscene/nn/weights.h"

namespace fastscene {

// Every offset, shape and size is held against the file before anything is used. Throws Error naming the file and the
// tensor.
Weights load_safetensors(std::shared_ptr<const MappedFile> file);

// Writes under a temporary name, then renames: a full disk leaves what was there. Floating tensors are converted when
// `as` says so.
enum class SaveAs { unchanged, f32, f16, bf16 };
void save_safetensors(const std::filesystem::path& path, const Weights& weights, SaveAs as = SaveAs::unchanged);

}  // namespace fastscene
