// Panorama stage: prompt -> equirectangular picture. Paper: text-to-panorama (Diffusion360).
// Backends: "rooms" (furnished room, path traced; needs no download), "image" (the user's own picture) and
// "diffusion360" (the paper's own: Stable Diffusion fine-tuned on panoramas, with weights of the user's;
// diffusion360.h).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/nn/diffusion360.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

template <class V>
void visit_fields(Diffusion360Settings& p, V&& v) {
    v("steps", p.steps, Bounds{1, 1000}, "diffusion360: steps from noise to picture.");
    v("guidance", p.guidance, Bounds{1, 50}, "diffusion360: how strictly the prompt is followed.");
    v("sampler", p.sampler, Choices{{"euler-ancestral", "ddim", "unipc"}}, "diffusion360: what makes a step.");
    v("device", p.device, Choices{{"auto", "cpu", "cuda"}},
      "diffusion360: where it is painted; auto: CUDA if libtorch has it.");
    v("precision", p.precision, Choices{{"float", "bf16", "fp16"}},
      "diffusion360: numbers of the denoiser; 16 bits need half the memory (fp16: on CUDA only).");
    v("low-memory", p.low_memory, "diffusion360: weights are read layer by layer, the picture is decoded in tiles.");
    v("upscale", p.upscale, Choices{{"none", "3", "6", "6-refined"}},
      "diffusion360: the picture made so many times as wide by its super-resolution chain; slow.");
    v("photo-fov-deg", p.photo_fov_deg, Bounds{20, 140}, "diffusion360: how wide the photo of --photo sees.");
    v("negative", p.negative, "diffusion360: what the picture must not be; empty: the published words.");
    v("published-seam", p.published_seam,
      "diffusion360: the published text path, whose left 32 columns repeat the right ones.");
}

struct PanoramaParams {
    std::string backend = "rooms";
    int width = 2048;  // height is half of it
    bool strict = false;
    std::string assets =
        "cc0";  // without obligations for who shows the scene; "all" asks to keep credits.txt beside it
    TraceParams trace;
    Diffusion360Settings diffusion;  // its width is the one above
};
template <class V>
void visit_fields(PanoramaParams& p, V&& v) {
    v("backend", p.backend, Choices{{"rooms", "image", "diffusion360"}}, "What makes the panorama.");
    v("width", p.width, Bounds{64, 8192}, "Width of the panorama in pixels; its height is half of it.");
    v("strict", p.strict, "Refuse a prompt with words that are not understood.");
    v("assets", p.assets, Choices{{"none", "cc0", "all"}},
      "Models of the furniture pack to use: none, public domain, or also those whose authors are named in "
      "credits.txt.");
    visit_fields(p.trace, v);
    visit_fields(p.diffusion, v);
}

// The furniture pack that the settings ask for; what is missing or damaged is told in `complaints`, when given.
std::shared_ptr<const FurniturePack> furniture_pack(const PanoramaParams& params,
                                                    std::vector<std::string>* complaints = nullptr);
// The prompt, read with that pack's names.
PromptSpec read_prompt(const std::string& prompt, const PanoramaParams& params,
                       std::vector<std::string>* complaints = nullptr);

// Backend "rooms". The traced room stays alive for the depth stage and for truth.
struct RoomPanorama {
    Panorama panorama;  // with exact range
    PromptSpec prompt;
    Image<std::int32_t> object_of_pixel;
    std::shared_ptr<TracedRoom> room;
};
// The room alone, its light gathered: deterministic, so that metrics can make the same room again.
std::shared_ptr<TracedRoom> make_traced_room(PromptSpec& prompt, const PanoramaParams& params, const Run& run);
// How its panoramas are shot; true panoramas for comparison are shot alike.
ShotParts panorama_parts(const TraceParams& trace);
RoomPanorama panorama_from_prompt(const std::string& prompt, const PanoramaParams& params, const Run& run);

// Backend "diffusion360".
struct PaintingSource {
    std::string prompt;
    std::filesystem::path weights;  // a folder as diffusers saves it, or the official folder of several
    std::filesystem::path photo;    // continued all around, turned upright as EXIF says; empty: none
};
// Where the painting and each larger picture are kept, so that a run that was stopped goes on after them; `salt`: of
// another, nothing is taken.
struct PaintingMemory {
    std::filesystem::path folder;  // empty: nothing is kept
    std::string salt;
};
// params.width x params.width / 2, or as many times larger as params.diffusion.upscale says; sRGB. `look` is shown what
// the picture is going to be, at half its size. Throws Error as check_diffusion360 (diffusion360.h) does.
ImageRgb8 panorama_by_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run,
                                   const Diffusion360::Preview& look = {}, const PaintingMemory& memory = {});
// A picture that is there already, as many times larger as params.diffusion.upscale says; of the source, the prompt and
// the weights count.
ImageRgb8 enlarged_by_diffusion360(const ImageRgb8& picture, const PaintingSource& source, const PanoramaParams& params,
                                   const Run& run, const PaintingMemory& memory = {});

// Backend "image": .jpg, .png (of any depth, gray and alpha too), or light in floats (.hdr, .exr, .pfm), which is
// exposed as a film would; turned upright as EXIF says. Throws Error when the picture is not 2:1, too small (< 64) or
// too large (> 16384), or the map does not fit.
Panorama panorama_from_image(const std::filesystem::path& picture);
// Its size, upright, from the header alone. Throws Error as above.
EquirectSize panorama_size(const std::filesystem::path& picture);
// Depth backend "image": range along the ray in metres from .exr, .pfm or 16-bit .png (millimetres); +inf: the sky.
// Zero and NaN mean "not measured" (completed_range), which `run` is told. Throws Error for another size, a negative
// range, or none at all.
ImageF range_from_file(const std::filesystem::path& map, EquirectSize size, const Run& run = {});
// What was not measured (0, NaN) is far background, +inf; but specks of less than three degrees take after their
// surroundings, and what is missing straight below the camera is level floor.
struct RangeGaps {
    std::int64_t unmeasured = 0, far = 0, closed = 0;  // pixels
};
ImageF completed_range(ImageF range, RangeGaps& gaps);
// A wider panorama is reduced to `width` (even); a narrower one stays. Color is averaged over areas, range is picked (a
// mean of two surfaces lies on neither). Clears `known`.
Panorama reduced_panorama(const Panorama& panorama, int width);
ImageF reduced_range(const ImageF& range, int width);

}  // namespace fastscene
