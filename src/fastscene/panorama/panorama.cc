#include "fastscene/panorama/panorama.h"

#include "fastscene/rooms/document.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/trace/standable.h"

namespace fastscene {

std::shared_ptr<const FurniturePack> furniture_pack(const PanoramaParams& params,
                                                    std::vector<std::string>* complaints) {
    std::vector<std::string> unheard;
    return FurniturePack::open(FurniturePack::default_folder(), assets_named(params.assets),
                               complaints ? *complaints : unheard);
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
        if (column % kApart == 0 && row % kApart == 0) places.push_back({at.x, floor.floor_y - kEyeHeight_m, at.y});
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
    traced->gather_light(params.trace, run, places_to_look_from(*traced));
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

RoomPanorama panorama_of_room(const RoomOrigin& origin, const PanoramaParams& params, const Run& run) {
    if (params.width % 2 != 0)
        throw UsageError("--panorama-width: expected an even number of pixels, found {}", params.width);
    RoomPanorama made;
    DocumentRoom room = known_room(origin, params, run);
    made.room = lit(room_of(room), params, run);
    made.prompt = room.spec;
    if (made.prompt.pack)
        for (const std::string& reason : made.prompt.pack->damage()) run.warn(reason);
    Shot shot = made.room->panorama({}, {params.width, params.width / 2}, panorama_parts(params.trace), run);
    made.panorama.color = std::move(shot.color);
    made.panorama.range = std::move(shot.range);
    made.file = room_file_json(document_of(room), made.room->room(), shot.object);
    return made;
}

}  // namespace fastscene
