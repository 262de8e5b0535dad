// Memory estimates for panorama generation, made before any weights are loaded.
#pragma once

#include <cstdint>
#include <string>

namespace fastscene {

struct DiffusionMemory {
    int width = 1024;  // of the picture; the height is half of it
    bool low_memory = false;
    std::int64_t denoiser = 0, pictures = 0, text = 0, control = 0;  // bytes of weights as computed with
    std::int64_t largest = 0;  // the largest single parameter: what low-memory mode holds at a time
    bool tiled = false;        // the picture is decoded in tiles of 512 x 512 instead of full-width bands
};
// Peak bytes of a run. Working memory is based on measurements (docs/benchmarks.md).
std::int64_t diffusion_memory(const DiffusionMemory& run);

// The same for Stable Diffusion 1.5 (860 million parameters in the U-Net), for documentation tables. precision: float
// or bf16.
std::int64_t standard_diffusion_memory(int width, const std::string& precision, bool low_memory);

// Throws Error naming required and available memory if `need` does not fit. `remedies`: what the user can change.
void check_memory(const std::string& what, std::int64_t need, const std::string& remedies);
std::string gib_text(std::int64_t bytes);

}  // namespace fastscene
