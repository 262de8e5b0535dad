// Panorama stage: prompt -> equirectangular picture. Paper: text-to-panorama (Diffusion360).
// Backends: "rooms" (furnished room, path traced; needs no download) and "image" (the user's own picture).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct PanoramaParams {
    std::string backend = "rooms";
    int width = 2048;          // height is half of it
    bool strict = false;
    TraceParams trace;
};
template <class V>
void visit_fields(PanoramaParams& p, V&& v) {
    v("backend", p.backend, Choices{{"rooms", "image"}}, "What makes the panorama.");
    v("width", p.width, Bounds{64, 8192}, "Width of the panorama in pixels; its height is half of it.");
    v("strict", p.strict, "Refuse a prompt with words that are not understood.");
    visit_fields(p.trace, v);
}

// Backend "rooms". The traced room stays alive for the depth stage and for truth.
struct RoomPanorama {
    Panorama panorama;      // with exact range
    PromptSpec prompt;
    Image<std::int32_t> object_of_pixel;
    std::shared_ptr<TracedRoom> room;
};
// The room alone, its light gathered: deterministic, so that metrics can make the same room again.
std::shared_ptr<TracedRoom> make_traced_room(PromptSpec& prompt, const PanoramaParams& params, const Run& run);
// How its panoramas are shot; true panoramas for comparison are shot alike.
ShotParts panorama_parts(const TraceParams& trace);
RoomPanorama panorama_from_prompt(const std::string& prompt, const PanoramaParams& params, const Run& run);

// Backend "image". Throws Error when the picture is not 2:1, too small (< 64) or too large (> 16384), or the map does not fit.
Panorama panorama_from_image(const std::filesystem::path& picture);
// Depth backend "image": range along the ray in metres from .exr, .pfm or 16-bit .png (millimetres).
// Zero means "not measured": such a pixel takes the nearest range of its row. Throws Error for another size, NaN, negative or all zero.
ImageF range_from_file(const std::filesystem::path& map, EquirectSize size);
// A wider panorama is reduced to `width` (even); a narrower one stays. Color is averaged over areas, range is picked (a mean
// of two surfaces lies on neither). Clears `known`.
Panorama reduced_panorama(const Panorama& panorama, int width);
ImageF reduced_range(const ImageF& range, int width);

}  // namespace fastscene
