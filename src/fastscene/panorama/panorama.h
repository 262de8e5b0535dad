// Panorama stage: prompt -> equirectangular picture. Paper: text-to-panorama (Diffusion360). Backends: "rooms" (a
// furnished, path traced room; no download needed), "image" (the user's own picture) and "diffusion360" (the paper's:
// Stable Diffusion fine-tuned on panoramas, with weights provided by the user; diffusion360.h).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/nn/diffusion360.h"
#include "fastscene/panorama/sphere_part.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct DocumentRoom;  // rooms/document.h

template <class V>
void visit_fields(Diffusion360Settings& p, V&& v) {
    v("steps", p.steps, Bounds{1, 1000}, "diffusion360: number of sampling steps.");
    v("guidance", p.guidance, Bounds{1, 50}, "diffusion360: classifier-free guidance scale.");
    v("sampler", p.sampler, Choices{{"euler-ancestral", "ddim", "unipc"}}, "diffusion360: sampler.");
    v("device", p.device, Choices{{"auto", "cpu", "cuda"}},
      "diffusion360: device; auto: CUDA if libtorch supports it.");
    v("precision", p.precision, Choices{{"float", "bf16", "fp16"}},
      "diffusion360: number type of the U-Net; 16 bits need half the memory (fp16: on CUDA only).");
    v("low-memory", p.low_memory, "diffusion360: load weights layer by layer, and decode the picture in tiles.");
    v("upscale", p.upscale, Choices{{"none", "3", "6", "6-refined"}},
      "diffusion360: upscale the picture's width by this factor with its super-resolution chain; slow.");
    v("photo-fov-deg", p.photo_fov_deg, Bounds{20, 140},
      "diffusion360: horizontal field of view of --photo in degrees.");
    v("negative", p.negative, "diffusion360: negative prompt; empty: the published one.");
    v("published-seam", p.published_seam,
      "diffusion360: reproduce the published text pipeline, in which the left 32 columns repeat the right ones.");
}

struct PanoramaParams {
    std::string backend = "rooms";
    int width = 2048;  // the height is half of it
    bool strict = false;
    // Free of obligations when publishing the scene; "all" requires credits.txt to be distributed with it; a folder of
    // the user's own models (assets_named in rooms/pack.h).
    std::string assets = "cc0";
    TraceParams trace;
    PictureLayout layout;            // of the user's picture
    Diffusion360Settings diffusion;  // its width is the field above
};
template <class V>
void visit_fields(PanoramaParams& p, V&& v) {
    v("backend", p.backend, Choices{{"rooms", "image", "diffusion360"}}, "What makes the panorama.");
    v("width", p.width, Bounds{64, 8192}, "Width of the panorama in pixels; its height is half of it.");
    v("strict", p.strict, "Refuse a prompt with words that are not understood.");
    v("assets", p.assets,
      "Models beyond the built-in ones: of the furniture pack none, those in the public domain (cc0), or also those "
      "that "
      "require attribution (all; credits.txt); or a folder of your own models, textures and skies.");
    visit_fields(p.layout, v);
    visit_fields(p.trace, v);
    visit_fields(p.diffusion, v);
}

// The furniture pack selected by the settings; missing or damaged files are reported in `complaints`, if given.
std::shared_ptr<const FurniturePack> furniture_pack(const PanoramaParams& params,
                                                    std::vector<std::string>* complaints = nullptr);
// Parses the prompt, including the pack's model names.
PromptSpec read_prompt(const std::string& prompt, const PanoramaParams& params,
                       std::vector<std::string>* complaints = nullptr);

// What a known room is made from: a prompt, or the text of a document (rooms/document.h).
struct RoomOrigin {
    std::string prompt, document;
};
// The room before it becomes triangles; of a prompt by run.seed, of a document by its own seed, if it has one.
DocumentRoom known_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run);

// Backend "rooms". The traced room is kept for the depth stage and for ground truth.
struct RoomPanorama {
    Panorama panorama;  // with exact range
    PromptSpec prompt;
    Json file;  // panorama/room.json
    std::shared_ptr<TracedRoom> room;
    double kept_light = 0, kept_pixels = 0;  // shares of the earlier room's, in [0, 1]
};
// The room alone, with its light gathered. Deterministic, so that metrics can recreate the room.
std::shared_ptr<TracedRoom> make_traced_room(PromptSpec& prompt, const PanoramaParams& params, const Run& run);
// Render settings of its panoramas; ground truth is rendered with the same.
ShotParts panorama_parts(const TraceParams& trace);
std::shared_ptr<TracedRoom> make_traced_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run);
// … without its light.
TracedRoom make_unlit_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run);
// Lights a room that has none: with the light kept in `file` (TracedRoom::light), or by gathering it if there is no
// such file, or, with a note, if its light is of another room, of other settings, or damaged.
void light_room(TracedRoom& room, const PanoramaParams& params, const std::filesystem::path& file, const Run& run);

// A room before it was edited: lit, with its panorama.
struct EarlierRoom {
    std::shared_ptr<const TracedRoom> room;
    ImageColor color;
};
// With `earlier`, light is gathered and pixels are rendered again only where the edit changed them.
RoomPanorama panorama_of_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run,
                              const EarlierRoom* earlier = nullptr);

// Backend "diffusion360".
struct PaintingSource {
    std::string prompt;
    std::filesystem::path weights;  // a diffusers folder, or the official folder of several
    std::filesystem::path photo;    // a photo to outpaint, rotated upright by EXIF; empty: none
};
// Cache for the generated and upscaled pictures, so that interrupted runs can resume; `salt` distinguishes incompatible
// versions.
struct PaintingMemory {
    std::filesystem::path folder;  // empty: no cache
    std::string salt;
};
// Returns an sRGB picture of params.width x params.width / 2, times the factor of params.diffusion.upscale. `look`
// receives previews at half size. Throws Error as check_diffusion360 (diffusion360.h) does.
ImageRgb8 panorama_by_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run,
                                   const Diffusion360::Preview& look = {}, const PaintingMemory& memory = {});
// Upscales an existing picture by the factor of params.diffusion.upscale; of the source only the prompt and the weights
// are used.
ImageRgb8 enlarged_by_diffusion360(const ImageRgb8& picture, const PaintingSource& source, const PanoramaParams& params,
                                   const Run& run, const PaintingMemory& memory = {});

// Backend "image": .jpg, .png (any bit depth, gray, alpha), or floating-point radiance (.hdr, .exr, .pfm), which is
// tone mapped; rotated upright by EXIF. Throws Error if the picture is not 2:1, too small (< 64) or too large (>
// 16384), or if the range map does not match.
Panorama panorama_from_image(const std::filesystem::path& picture);
// The upright size, from the file header alone. Throws Error as above.
EquirectSize panorama_size(const std::filesystem::path& picture);
// Depth backend "image": range along the ray in metres from .exr, .pfm or 16-bit .png (millimetres); +inf: sky. Zero
// and NaN mean "not measured" (completed_range), which is reported to `run`. Throws Error for a mismatched size,
// negative ranges, or no range at all.
ImageF range_from_file(const std::filesystem::path& map, EquirectSize size, const Run& run = {});
// Unmeasured pixels (0, NaN) become far background, +inf; but specks smaller than three degrees are interpolated, and a
// gap straight below the camera becomes level floor.
struct RangeGaps {
    std::int64_t unmeasured = 0, far = 0, closed = 0;  // pixels
};
ImageF completed_range(ImageF range, RangeGaps& gaps);
// Downsamples a wider panorama to `width` (even); narrower ones are unchanged. Color is area-averaged, range uses
// nearest neighbours (an interpolated range lies on neither surface). Clears `known`.
Panorama reduced_panorama(const Panorama& panorama, int width);
ImageF reduced_range(const ImageF& range, int width);

}  // namespace fastscene
