#include "fastscene/walk/room_walk.h"

#include <algorithm>
#include <cmath>

#include "fastscene/walk/room_viewpoints.h"

namespace fastscene {
namespace {

// Columns crowd towards the poles: one of this many pixels in a row is traced and copied to the others.
int columns_a_ray(int y, EquirectSize size) {
    const float latitude = kPi * (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height));
    return std::clamp(static_cast<int>(1.f / std::max(1e-3f, std::cos(latitude))), 1, size.width);
}

ImageColor evenly_traced(const TracedRoom& room, const Rigid& world_from_pano, EquirectSize size, ShotParts parts,
                         const Run& run) {
    ImageMask asked(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        const int step = columns_a_ray(y, size);
        for (int x = step / 2; x < size.width; x += step) asked.at(x, y) = 255;
    }
    parts.only = &asked;
    ImageColor color = room.panorama(world_from_pano, size, parts, run).color;
    for (int y = 0; y < size.height; ++y) {
        const int step = columns_a_ray(y, size);
        for (int x = 0; step > 1 && x < size.width; ++x) {
            const int traced = x / step * step + step / 2;
            color.at(x, y) = color.at(traced < size.width ? traced : traced - step, y);
        }
    }
    return color;
}

Panorama seen_from(const TracedRoom& room, const Rigid& world_from_pano, EquirectSize size, ShotParts parts,
                   const Run& run) {
    parts.range = parts.object = false;
    ImageColor color = evenly_traced(room, world_from_pano, size, parts, run);
    // Range for the trainer: through flat mirrors, to the virtual image.
    ImageF range = room.panorama(world_from_pano, size, {.color = false, .range = false, .mirrored_range = true}, run)
                       .mirrored_range;
    return {std::move(color), std::move(range), {}, world_from_pano};
}

// GGX width of the sharpest reflection that SH of degree 2 can represent. Sharper ones differ between neighbouring
// viewpoints by more than the splats can interpolate, and left patches on steel fronts and polished floors.
constexpr float kMinAlpha = 0.3f;

}  // namespace

Json walk_through_room(const Panorama& given, const TracedRoom& room, const StandableFloor& floor,
                       const WalkParams& params, const ShotParts& shot, const Run& run, const TakePanorama& take) {
    Panorama first = given;
    if (!first.mirrored_range.empty()) first.range = std::move(first.mirrored_range);
    first.mirrored_range = {};
    Json about{{"kind", kRoomWalk}, {"standable_m2", standable_area_m2(floor)}};
    RoomViewpoints viewpoints = choose_room_viewpoints(room, floor, {.most = params.room_viewpoints}, run);
    if (viewpoints.samples == 0) {
        run.warn(
            "nobody can stand in this room: it is looked at from around the first panorama only, and breaks where one "
            "goes farther");
        viewpoints.positions_m = choose_viewpoints(first, params);
    } else {
        about["unseen_share"] = viewpoints.unseen_share;
        about["coarse_share"] = viewpoints.coarse_share;
        about["one_sided_share"] = viewpoints.one_sided_share;
    }
    about["viewpoints"] = viewpoints.positions_m.size();
    ShotParts parts = shot;
    parts.pixel_samples = params.pixel_samples;
    parts.contacts = parts.denoise = false;  // noise of single views averages out in the splats
    parts.noise = 0;
    parts.frugal = true;
    parts.min_alpha = kMinAlpha;
    const int width = params.width > 0 ? params.width / 2 * 2 : first.color.width;
    const Rigid pose = first.world_from_pano;
    take(std::move(first));
    Progress progress(run, "walk", static_cast<std::int64_t>(viewpoints.positions_m.size()));
    for (std::size_t i = 0; i < viewpoints.positions_m.size(); ++i) {
        run.check_stop();
        // Different camera rays at each viewpoint, so that noise is independent between panoramas.
        take(seen_from(room, {pose.rotation, viewpoints.positions_m[i]}, {width, width / 2}, parts,
                       Run{run.seed + i + 1, nullptr, run.stop}));
        progress.advance();
    }
    return about;
}

}  // namespace fastscene
