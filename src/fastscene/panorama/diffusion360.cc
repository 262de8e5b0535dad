#include "fastscene/panorama/diffusion360.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <vector>

#include "fastscene/base/hash.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/diffusion360.h"
#include "fastscene/nn/upscale360.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

Diffusion360Settings settings_of(const PanoramaParams& params) {
    Diffusion360Settings settings = params.diffusion;
    settings.width = params.width;
    return settings;
}

Diffusion360 painter(const PaintingSource& source, const PanoramaParams& params, const Run& run) {
    return {source.weights, settings_of(params), run, source.photo.empty() ? Diffusion360::From::text : Diffusion360::From::photo};
}

std::optional<Upscale360> enlarger(const PaintingSource& source, const PanoramaParams& params, const Run& run) {
    const Diffusion360Settings& painting = params.diffusion;
    if (painting.upscale == "none") return std::nullopt;
    Upscale360Settings settings;
    settings.to = painting.upscale;
    settings.precision = painting.precision;
    settings.low_memory = painting.low_memory;
    settings.negative = painting.negative;
    return Upscale360(source.weights, params.width, settings, run);
}

}  // namespace

void check_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run) {
    if (!source.photo.empty()) (void)load_rgb8(source.photo);
    (void)painter(source, params, run);
    (void)enlarger(source, params, run);
}

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

ImageRgb8 panorama_by_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run, const Diffusion360::Preview& look) {
    const Run quiet{run.seed, nullptr, run.stop};  // what it needs was said when the request was checked
    ImageRgb8 picture = [&] {  // the painter's networks leave memory before those that enlarge come
        const Diffusion360 with = painter(source, params, quiet);
        return source.photo.empty() ? with.paint(source.prompt, run, look) : with.paint_around(load_rgb8(source.photo), source.prompt, run, look);
    }();
    if (const auto larger = enlarger(source, params, quiet)) {
        if (look) look(picture);
        picture = larger->enlarge(picture, source.prompt, run);
    }
    return picture;
}

}  // namespace fastscene
