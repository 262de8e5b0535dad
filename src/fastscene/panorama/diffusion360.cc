#include "fastscene/panorama/diffusion360.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "fastscene/base/content_identity.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/image/orientation.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/diffusion360.h"
#include "fastscene/nn/painting_files.h"
#include "fastscene/nn/upscale360.h"
#include "fastscene/panorama/kept_pictures.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

Diffusion360Settings settings_of(const PanoramaParams& params) {
    Diffusion360Settings settings = params.diffusion;
    settings.width = params.width;
    return settings;
}

Diffusion360 painter(const PaintingSource& source, const PanoramaParams& params, const Run& run) {
    return {source.weights, settings_of(params), run,
            source.photo.empty() ? Diffusion360::From::text : Diffusion360::From::photo};
}

Upscale360Settings enlarging_of(const PanoramaParams& params) {
    const Diffusion360Settings& painting = params.diffusion;
    Upscale360Settings settings;
    settings.to = painting.upscale;
    settings.device = painting.device;
    settings.precision = painting.precision;
    settings.low_memory = painting.low_memory;
    settings.negative = painting.negative;
    return settings;
}

double times_of(const PanoramaParams& params) {
    return times_the_painting(params.width, params.diffusion.steps, enlarging_of(params));
}

Upscale360 enlarger(const PaintingSource& source, const PanoramaParams& params, const Run& run) {
    return {source.weights, params.width, enlarging_of(params), run};
}

// The photo rotated upright by its EXIF orientation.
ImageRgb8 upright_photo(const fs::path& photo) { return upright(load_rgb8(photo), picture_info(photo).orientation); }

std::string hash_of_files(const std::vector<fs::path>& files, const fs::path& root) {
    Hash hash;
    for (const fs::path& file : files)
        hash.add(file.lexically_relative(root).generic_string()).add(content_identity(file));
    return hash.hex();
}

// The settings of the painting, without those of later upscaling.
Json painting_fields(const PanoramaParams& params) {
    Diffusion360Settings painting = params.diffusion;
    painting.upscale = "none";
    return fields_json(painting);
}

// Hash of everything that the painting depends on.
std::string painting_key(const PaintingSource& source, const PanoramaParams& params, const Run& run,
                         const std::string& salt) {
    return Hash()
        .add(salt)
        .add(diffusion360_identity(source.weights, !source.photo.empty()))
        .add(source.prompt)
        .add(run.seed)
        .add(source.photo.empty() ? std::string() : read_file(source.photo))
        .add(params.width)
        .add(painting_fields(params).dump())
        .hex();
}

std::string time_text(double seconds) {
    return seconds < 90     ? fmt::format("{:.0f} s", seconds)
           : seconds < 5400 ? fmt::format("{:.0f} min", seconds / 60)
                            : fmt::format("{:.1f} h", seconds / 3600);
}

struct Enlarging {
    const PaintingSource& source;
    const PanoramaParams& params;
    const KeptPictures& kept;
    std::string key;          // of the picture
    double painting_seconds;  // 0: unknown
};

ImageRgb8 made_larger(const ImageRgb8& picture, const Enlarging& how, const Run& run) {
    const std::string& to = how.params.diffusion.upscale;
    std::string key = how.key;
    bool said = how.painting_seconds == 0;
    const auto say = [&] {
        if (std::exchange(said, true)) return;
        const double about = how.painting_seconds * times_of(how.params);
        run.note(fmt::format("diffusion360: {} times as large takes about {}, as the painting took {}", to,
                             time_text(about), time_text(how.painting_seconds)));
    };
    const Upscale360::Keep keep = [&](const std::string& step, const std::function<ImageRgb8()>& make) {
        key = Hash().add(key).add(step).add(enlarger_identity(how.source.weights, step)).hex();
        KeptPicture one = how.kept.get(step, key, [&] {
            say();
            return make();
        });
        if (one.was_there)
            run.note(fmt::format("{} times as large: was there already: {}", step, how.kept.file_of(step).string()));
        return std::move(one.picture);
    };
    return enlarger(how.source, how.params, {run.seed, nullptr, run.stop})
        .enlarge(picture, how.source.prompt, run, keep);
}

}  // namespace

void check_enlarging(const PaintingSource& source, const PanoramaParams& params, int width, const Run& run) {
    if (width < 256 || width % 128 != 0)
        throw UsageError(
            "--panorama-upscale: expected a picture whose width is a multiple of 128 from 256, found {}; "
            "--panorama-width {} reduces it first",
            width, std::max(256, width / 128 * 128));
    PanoramaParams wide = params;
    wide.width = width;
    (void)enlarger(source, wide, run);
    run.note(fmt::format("diffusion360: {} times as large takes about {:.0f} times as long as to paint {} x {}",
                         params.diffusion.upscale, times_of(wide), width, width / 2));
}

void check_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run) {
    if (!source.photo.empty()) (void)upright_photo(source.photo);
    (void)painter(source, params, run);
    if (params.diffusion.upscale != "none") check_enlarging(source, params, params.width, run);
}

std::string diffusion360_identity(const fs::path& weights, bool from_photo) {
    return hash_of_files(painting_files(weights, from_photo), weights);
}

std::string enlarger_identity(const fs::path& weights, const std::string& to) {
    return hash_of_files(enlarging_files(weights, to), weights);
}

ImageRgb8 panorama_by_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run,
                                   const Diffusion360::Preview& look, const PaintingMemory& memory) {
    const Run quiet{run.seed, nullptr, run.stop};  // notes were already emitted when the request was checked
    const KeptPictures kept(memory.folder);
    const std::string key = painting_key(source, params, run, memory.salt);
    // free the generator's networks before the upscaling networks are loaded
    KeptPicture found = kept.get("1", key, [&] {
        const Diffusion360 with = painter(source, params, quiet);
        return source.photo.empty() ? with.paint(source.prompt, run, look)
                                    : with.paint_around(upright_photo(source.photo), source.prompt, run, look);
    });
    if (found.was_there) run.note(fmt::format("the painting was there already: {}", kept.file_of("1").string()));
    if (params.diffusion.upscale == "none") return std::move(found.picture);
    if (look) look(found.picture);
    return made_larger(found.picture, {source, params, kept, key, found.seconds}, run);
}

ImageRgb8 enlarged_by_diffusion360(const ImageRgb8& picture, const PaintingSource& source, const PanoramaParams& params,
                                   const Run& run, const PaintingMemory& memory) {
    PanoramaParams wide = params;
    wide.width = picture.width;
    Hash key;
    key.add(memory.salt).add(source.prompt).add(run.seed).add(painting_fields(params).dump()).add(picture.width);
    key.add_bytes(picture.pixels.data(), picture.pixels.size() * sizeof(Rgb8));
    return made_larger(picture, {source, wide, KeptPictures(memory.folder), key.hex(), 0}, run);
}

}  // namespace fastscene
