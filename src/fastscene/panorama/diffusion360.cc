#include "fastscene/panorama/diffusion360.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "fastscene/base/hash.h"
#include "fastscene/nn/diffusion360.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

Diffusion360Settings settings_of(const PanoramaParams& params) {
    Diffusion360Settings settings = params.diffusion;
    settings.width = params.width;
    return settings;
}

}  // namespace

void check_diffusion360(const fs::path& weights, const PanoramaParams& params, const Run& run) { Diffusion360(weights, settings_of(params), run); }

std::string diffusion360_identity(const fs::path& weights) {
    constexpr std::size_t beginning = 1 << 12;  // a safetensors file begins with the names and places of all tensors
    std::vector<fs::path> files;
    if (fs::is_directory(weights))
        for (const auto& entry : fs::recursive_directory_iterator(weights))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    Hash hash;
    for (const fs::path& file : files) {
        std::string bytes(beginning, '\0');
        std::ifstream in(file, std::ios::binary);
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
        hash.add(fs::relative(file, weights).string()).add(static_cast<std::uint64_t>(fs::file_size(file))).add(bytes);
    }
    return hash.hex();
}

ImageRgb8 panorama_by_diffusion360(const std::string& prompt, const fs::path& weights, const PanoramaParams& params, const Run& run) {
    const Run quiet{run.seed, nullptr, run.stop};  // what it needs was said when the request was checked
    return Diffusion360(weights, settings_of(params), quiet).paint(prompt, run);
}

}  // namespace fastscene
