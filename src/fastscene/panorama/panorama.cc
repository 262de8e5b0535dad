#include "fastscene/panorama/panorama.h"

#include "fastscene/base/file.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/trace/changed_pixels.h"
#include "fastscene/trace/standable.h"

namespace fastscene {

std::shared_ptr<const FurniturePack> furniture_pack(const PanoramaParams& params,
                                                    std::vector<std::string>* complaints) {
    std::vector<std::string> unheard;
    return FurniturePack::open(params.assets, complaints ? *complaints : unheard);
}

PromptSpec read_prompt(const std::string& prompt, const PanoramaParams& params, std::vector<std::string>* complaints) {
    return understand_prompt(prompt, params.strict, furniture_pack(params, complaints));
}

namespace {

// Panorama 0 and visitor positions: surfaces visible from none of them get fewer light paths.
std::vector<Vec3f> places_to_look_from(const TracedRoom& room) {
    constexpr int kApart = 8;  // in cells
    constexpr float kEyeHeight_m = 1.5f;
    const StandableFloor floor = passable_floor(room);
    std::vector<Vec3f> places{Vec3f{}};
    for (const auto& [column, row] : standable_cells(floor)) {
        const Vec2f at = floor.center(column, row);
        if (column % kApart == 0 && row % kApart == 0)
            places.push_back({at.x, floor.level_at(column, row) - kEyeHeight_m, at.y});
    }
    return places;
}

}  // namespace

DocumentRoom known_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run) {
    if (!origin.document.empty())
        return furnish_document(read_document(origin.document, "room.json"), "room.json", furniture_pack(params), run);
    DocumentRoom room{read_prompt(origin.prompt, params), {}, run.seed};
    room.furnished = furnish_room(room.spec, run);
    return room;
}

namespace {

std::shared_ptr<TracedRoom> lit(Room room, const PanoramaParams& params, const Run& run) {
    auto traced = std::make_shared<TracedRoom>(std::move(room));
    light_room(*traced, params, {}, run);
    return traced;
}

}  // namespace

std::shared_ptr<TracedRoom> make_traced_room(PromptSpec& prompt, const PanoramaParams& params, const Run& run) {
    return lit(make_room(prompt, run), params, run);
}

std::shared_ptr<TracedRoom> make_traced_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run) {
    DocumentRoom room = known_room(origin, params, run);
    return lit(room_of(room), params, run);
}

TracedRoom make_unlit_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run) {
    DocumentRoom room = known_room(origin, params, run);
    return TracedRoom(room_of(room));
}

ShotParts panorama_parts(const TraceParams& trace) {
    // With the denoiser: a quarter of pixel_samples where light is smooth, up to twice as many where rays disagree
    // (soft shadows, reflections, outlines).
    return {.color = true,
            .range = true,
            .object = true,
            .pixel_samples = 4 * trace.pixel_samples,
            .contacts = true,
            .denoise = !trace.keep_noise,
            .noise = 0.012f};
}

void light_room(TracedRoom& room, const PanoramaParams& params, const std::filesystem::path& file, const Run& run) {
    try {
        if (std::filesystem::exists(file) && room.take_light(params.trace, read_file(file), file.string())) return;
    } catch (const Error& e) {
        run.note(fmt::format("{}: the light is gathered again", e.what()));
    }
    room.gather_light(params.trace, run, places_to_look_from(room));
}

namespace {

// Renders what the edit changed over the earlier panorama. Returns the share of pixels that stay.
double render_changes(const TracedRoom& room, const EarlierRoom& earlier, const ShotParts& parts, ImageColor& color,
                      const Run& run) {
    const EquirectSize size{color.width, color.height};
    const ImageMask changed = ChangedPixels(*earlier.room, room, parts).in_panorama({}, size, run);
    ShotParts only = parts;
    only.range = only.object = false;
    only.only = &changed;
    const ImageColor shown = room.panorama({}, size, only, run).color;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < color.size(); ++i) {
        kept += changed.pixels[i] == 0;
        color.pixels[i] = (changed.pixels[i] != 0 ? shown : earlier.color).pixels[i];
    }
    return static_cast<double>(kept) / static_cast<double>(color.size());
}

}  // namespace

RoomPanorama panorama_of_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run,
                              const EarlierRoom* earlier) {
    if (params.width % 2 != 0)
        throw UsageError("--panorama-width: expected an even number of pixels, found {}", params.width);
    RoomPanorama made;
    DocumentRoom room = known_room(origin, params, run);
    made.room = std::make_shared<TracedRoom>(room_of(room));
    const std::vector<Vec3f> viewpoints = places_to_look_from(*made.room);
    if (earlier) made.kept_light = made.room->gather_light_again(params.trace, run, viewpoints, *earlier->room);
    else made.room->gather_light(params.trace, run, viewpoints);
    made.prompt = room.spec;
    if (made.prompt.pack)
        for (const std::string& reason : made.prompt.pack->damage()) run.warn(reason);
    const EquirectSize size{params.width, params.width / 2};
    ShotParts parts = panorama_parts(params.trace);
    const bool again = made.kept_light > 0 && earlier->color.width == size.width;
    if (again) {
        made.panorama.color = ImageColor(size.width, size.height);
        made.kept_pixels = render_changes(*made.room, *earlier, parts, made.panorama.color, run);
    }
    parts.color = !again;
    Shot shot = made.room->panorama({}, size, parts, run);
    if (!again) made.panorama.color = std::move(shot.color);
    made.panorama.range = std::move(shot.range);
    made.file = room_file_json(document_of(room), made.room->room(), shot.object);
    return made;
}

}  // namespace fastscene
