#include "fastscene/walk/room_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fastscene/trace/changed_pixels.h"
#include "fastscene/walk/room_viewpoints.h"

namespace fastscene {
namespace {

// Columns crowd towards the poles: one of this many pixels in a row is traced and copied to the others.
int columns_a_ray(int y, EquirectSize size) {
    const float latitude = kPi * (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height));
    return std::clamp(static_cast<int>(1.f / std::max(1e-3f, std::cos(latitude))), 1, size.width);
}

// The column whose ray a pixel of the row shows.
int traced_column(int x, int step, int width) {
    const int column = x / step * step + step / 2;
    return column < width ? column : column - step;
}

// Renders the pixels in `changed` (null: all) over `color`.
void trace_evenly(const TracedRoom& room, const Rigid& world_from_pano, ShotParts parts, const ImageMask* changed,
                  ImageColor& color, const Run& run) {
    const EquirectSize size{color.width, color.height};
    ImageMask asked(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (!changed || changed->at(x, y) != 0)
                asked.at(traced_column(x, columns_a_ray(y, size), size.width), y) = 255;
    parts.only = &asked;
    const ImageColor traced = room.panorama(world_from_pano, size, parts, run).color;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int column = traced_column(x, columns_a_ray(y, size), size.width);
            if (asked.at(column, y) != 0) color.at(x, y) = traced.at(column, y);
        }
}

// Range for the trainer: through flat mirrors, to the virtual image.
void trace_range(const TracedRoom& room, const Rigid& world_from_pano, const ImageMask* changed, ImageF& range,
                 const Run& run) {
    const ShotParts parts{.color = false, .range = false, .mirrored_range = true, .only = changed};
    const ImageF traced = room.panorama(world_from_pano, {range.width, range.height}, parts, run).mirrored_range;
    for (std::size_t i = 0; i < range.size(); ++i)
        if (!changed || changed->pixels[i] != 0) range.pixels[i] = traced.pixels[i];
}

Panorama seen_from(const TracedRoom& room, const Rigid& world_from_pano, EquirectSize size, const ShotParts& parts,
                   const Run& run) {
    Panorama out{ImageColor(size.width, size.height), ImageF(size.width, size.height), {}, world_from_pano};
    trace_evenly(room, world_from_pano, parts, nullptr, out.color, run);
    trace_range(room, world_from_pano, nullptr, out.range, run);
    return out;
}

// GGX width of the sharpest reflection that SH of degree 2 can represent. Sharper ones differ between neighbouring
// viewpoints by more than the splats can interpolate, and left patches on steel fronts and polished floors.
constexpr float kMinAlpha = 0.3f;

}  // namespace

Json walk_through_room(const Panorama& given, const TracedRoom& room, const StandableFloor& floor,
                       const WalkParams& params, const ShotParts& shot, const Run& run, const TakePanorama& take,
                       const EarlierWalk* earlier) {
    Panorama first = given;
    if (!first.mirrored_range.empty()) first.range = std::move(first.mirrored_range);
    first.mirrored_range = {};
    Json about{{"kind", kRoomWalk}, {"standable_m2", standable_area_m2(floor)}};
    RoomViewpointParams choice{.most = params.room_viewpoints};
    if (earlier) choice.earlier_m = earlier->positions_m;
    RoomViewpoints viewpoints = choose_room_viewpoints(room, floor, choice, run);
    if (viewpoints.samples == 0) {
        run.warn(
            "nobody can stand in this room: viewpoints are around the first panorama only, and quality degrades "
            "farther away");
        viewpoints.positions_m = choose_viewpoints(first, params);
        viewpoints.earlier.assign(viewpoints.positions_m.size(), -1);
    } else {
        about["unseen_share"] = viewpoints.unseen_share;
        about["coarse_share"] = viewpoints.coarse_share;
        about["one_sided_share"] = viewpoints.one_sided_share;
    }
    about["viewpoints"] = viewpoints.positions_m.size();
    ShotParts parts = shot;
    parts.pixel_samples = params.pixel_samples;
    parts.contacts = parts.denoise = false;  // noise of single views averages out in the splats,
    parts.denoise_reflections = true;        // but for specks on glossy surfaces, which their harmonics would fit
    parts.noise = 0;
    parts.frugal = true;
    parts.min_alpha = kMinAlpha;
    parts.range = parts.object = false;
    std::optional<ChangedPixels> changed;
    if (earlier) changed.emplace(*earlier->room, room, parts);
    double rendered = 0;  // panoramas
    const int width = params.width > 0 ? params.width / 2 * 2 : first.color.width;
    const Rigid pose = first.world_from_pano;
    take(std::move(first));
    Progress progress(run, "walk", static_cast<std::int64_t>(viewpoints.positions_m.size()));
    for (std::size_t i = 0; i < viewpoints.positions_m.size(); ++i) {
        run.check_stop();
        const Rigid here{pose.rotation, viewpoints.positions_m[i]};
        const EquirectSize size{width, width / 2};
        // Different camera rays at each viewpoint, so that noise is independent between panoramas.
        const Run own{run.seed + i + 1, nullptr, run.stop};
        if (changed && viewpoints.earlier[i] >= 0) {
            Panorama known = earlier->panorama(static_cast<std::size_t>(viewpoints.earlier[i]));
            if (known.color.width == width) {
                const ImageMask mask = changed->in_panorama(here, size, own);
                trace_evenly(room, here, parts, &mask, known.color, own);
                trace_range(room, here, &mask, known.range, own);
                known.world_from_pano = here;
                rendered += static_cast<double>(mask.size() - static_cast<std::size_t>(std::count(
                                                                  mask.pixels.begin(), mask.pixels.end(), 0))) /
                            static_cast<double>(mask.size());
                take(std::move(known));
                progress.advance();
                continue;
            }
        }
        ++rendered;
        take(seen_from(room, here, size, parts, own));
        progress.advance();
    }
    if (earlier) about["rendered_panoramas"] = rendered;
    return about;
}

}  // namespace fastscene
