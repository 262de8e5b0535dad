#include "fastscene/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/shortest.h"
#include "fastscene/geometry/outlook.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/walk/complete.h"
#include "fastscene/walk/free_space.h"
#include "fastscene/walk/mirrors.h"
#include "fastscene/walk/published_walk.h"
#include "fastscene/walk/ready.h"

namespace fastscene {
namespace {

// An invented surface must be clearly in front of an observed one to occlude it.
constexpr float kObservedWins = 1.03f;
constexpr float kObservedWins_m = 0.02f;

// Composites observed and invented surfaces; `known` records each pixel's origin.
CoarseView compose(CoarseView view, const CoarseView& other, Image<Known>& known) {
    known = Image<Known>(view.color.width, view.color.height, Known::invented);
    for (std::size_t i = 0; i < view.color.size(); ++i) {
        const bool seen = view.cover.pixels[i] != Cover::hole && view.cover.pixels[i] != Cover::guess;
        const bool guessed = view.cover.pixels[i] == Cover::guess &&
                             other.range.pixels[i] > kFarthestRange;             // equivalent to sky inpainted earlier
        const bool painted = other.cover.pixels[i] == Cover::front && !guessed;  // invented surfaces have no back side
        if (painted && (!seen || other.range.pixels[i] * kObservedWins + kObservedWins_m < view.range.pixels[i])) {
            view.color.pixels[i] = other.color.pixels[i];
            view.range.pixels[i] = other.range.pixels[i];
            view.plane.pixels[i] = other.plane.pixels[i];
            view.cover.pixels[i] = Cover::front;
            known.pixels[i] = Known::carried;
        } else if (view.cover.pixels[i] == Cover::front) {
            known.pixels[i] = Known::original;
        }
    }
    return view;
}

// One sample per pixel aliases silhouettes. Pixels next to them become the mean of four quarters; a quarter without
// known content takes the inpainted color of this pixel, or of a neighbour on that side.
ImageColor smooth_silhouettes(const Panorama& next, const std::vector<WarpSource>& observed,
                              const std::vector<PackedSource>& invented, Vec3f position) {
    const int w = next.color.width, h = next.color.height;
    ImageMask beside = range_edges(next.range);
    for (std::uint8_t& bits : beside.pixels) bits &= kFarSide | kNearSide;
    Image<Known> known;
    const CoarseView quarters = compose(quarters_view(observed, beside, position),
                                        quarters_view(invented, beside, position), known);
    ImageColor out = next.color;
    std::size_t quarter = 0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (!beside.at(x, y)) continue;
            Vec3f sum;
            float count = 0;
            const auto take = [&](Vec3f color) { sum += color, ++count; };
            for (int k = 0; k < 4; ++k, ++quarter) {
                if (known.pixels[quarter] != Known::invented) {
                    take(quarters.color.pixels[quarter]);
                    continue;
                }
                const int x1 = wrap_column(x + (k % 2 ? 1 : -1), w), y1 = std::clamp(y + (k / 2 ? 1 : -1), 0, h - 1);
                if (next.known.at(x, y) == Known::invented) take(next.color.at(x, y));
                else if (next.known.at(x1, y) == Known::invented) take(next.color.at(x1, y));
                else if (next.known.at(x, y1) == Known::invented) take(next.color.at(x, y1));
            }
            if (count > 0) out.at(x, y) = sum / count;
        }
    return out;
}

// The part of an inpainted region that later viewpoints see: pixels connected to others. An isolated one would be a
// speck in front of the background.
ImageMask carried_part(const ImageMask& painted) {
    ImageMask out(painted.width, painted.height);
    for (int y = 0; y + 1 < painted.height; ++y)
        for (int x = 0; x < painted.width; ++x) {
            const int r = wrap_column(x + 1, painted.width);
            if (painted.at(x, y) && painted.at(r, y) && painted.at(x, y + 1) && painted.at(r, y + 1))
                out.at(x, y) = out.at(r, y) = out.at(x, y + 1) = out.at(r, y + 1) = 1;
        }
    return out;
}

// A reach larger than the room is clipped; this is reported once, with the result, and recorded.
Json what_was_clipped(const Panorama& first, const std::vector<Vec3f>& positions, const WalkParams& params,
                      const Run& run) {
    float nearest = std::numeric_limits<float>::infinity(), reached = 0;
    for (const Vec3f& world : positions) {
        const Vec3f p = inverse(first.world_from_pano) * world;
        nearest = std::min(nearest, distance_ahead(first.range, normalize(p)));
        reached = std::max(reached, length(p));
    }
    Json about{{"viewpoints", positions.size()}, {"reached_m", shortest(reached)}};
    if (nearest < params.reach_m) {
        run.warn(
            fmt::format("walk: a reach of {} m would leave the room (a surface is {:.2f} m away); viewpoints are "
                        "clipped to {:.0f} % of the free distance",
                        params.reach_m, nearest, 100 * params.clearance));
        about["clipped"] = {{"wanted_m", shortest(params.reach_m)},
                            {"nearest_surface_m", shortest(nearest)},
                            {"share_of_free_distance", shortest(params.clearance)}};
    }
    return about;
}

// Divides the viewpoints among all given panoramas.
std::vector<Vec3f> all_viewpoints(const Panorama& first, const std::vector<Panorama>& more, const WalkParams& params) {
    if (more.empty()) return choose_viewpoints(first, params);
    WalkParams share = params;
    const int given = 1 + static_cast<int>(more.size());
    share.viewpoints = (params.viewpoints + given - 1) / given;
    std::vector<Vec3f> all = choose_viewpoints(first, share);
    for (const Panorama& one : more) {
        const std::vector<Vec3f> about = choose_viewpoints(one, share);
        all.insert(all.end(), about.begin(), about.end());
    }
    all.resize(std::min(all.size(), static_cast<std::size_t>(params.viewpoints)));
    return all;
}

// Mirrors act like windows: the virtual image is behind them and moves accordingly.
Panorama looking_into_mirrors(Panorama panorama) {
    if (!panorama.mirrored_range.empty()) panorama.range = std::move(panorama.mirrored_range);
    panorama.mirrored_range = {};
    return panorama;
}

// What the first panorama invented (parts that its picture did not have) is not original elsewhere, either.
void mark_carried(const Panorama& first, Vec3f position, Panorama& next) {
    const auto is_invented = [](Known known) { return known == Known::invented; };
    if (std::none_of(first.known.pixels.begin(), first.known.pixels.end(), is_invented)) return;
    const EquirectSize size = next.size();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float range = next.range.at(x, y);
            if (next.known.at(x, y) != Known::original) continue;
            const Vec3f d = direction_of_pixel(x, y, size);
            const Vec2f at = pixel_of_direction(std::isfinite(range) ? position + d * range : d, first.size());
            if (is_invented(first.known.at(wrap_column(static_cast<int>(at.x), first.color.width),
                                           std::min(static_cast<int>(at.y), first.color.height - 1))))
                next.known.at(x, y) = Known::carried;
        }
}

// Fills the holes with renderings of the known room.
void look_into_room(CoarseView& view, const ImageMask& hole, const RoomLook& look, const Rigid& world_from_pano,
                    const Run& run) {
    const RoomSight sight = look(world_from_pano, hole, {run.seed, nullptr, run.stop});
    FASTSCENE_CHECK(sight.color.same_size(hole) && sight.range.same_size(hole));
    for (std::size_t i = 0; i < hole.size(); ++i) {
        if (!hole.pixels[i]) continue;
        view.color.pixels[i] = sight.color.pixels[i];
        view.range.pixels[i] = sight.range.pixels[i] < kFarthestRange ? sight.range.pixels[i]
                                                                      : std::numeric_limits<float>::infinity();
        view.plane.pixels[i] = kNoPlane;
    }
}

Json walk_our_way(const Panorama& given, const std::vector<Panorama>& more, const WalkParams& params, const Run& run,
                  const TakePanorama& take, const RoomLook& look) {
    const EquirectSize size = given.size();
    // viewpoints must not be inside a mirror's virtual space
    const std::vector<Vec3f> positions = all_viewpoints(given, more, params);
    Json about = what_was_clipped(given, choose_viewpoints(given, params), params, run);
    about["viewpoints"] = positions.size();
    const bool looks = params.inpainter == kLookIntoRoom;
    std::vector<Mirror> mirrors = looks ? std::vector<Mirror>{} : find_mirrors(given);
    const Panorama first = looking_into_mirrors(given);
    const auto inpainter = looks ? nullptr
                                 : make_inpainter(params.inpainter, params.inpaint_weights, params.device,
                                                  params.trusted);
    const std::vector<ScenePlane> planes = find_planes(first.range, run.seed);
    const Image<std::int16_t> label = label_planes(first.range, planes);

    std::vector<WarpSource> observed;
    std::vector<PackedSource> invented;
    observed.push_back(make_warp_source(first.color, first.range, label, {}, {}));
    const Image<std::int16_t> no_planes(size.width, size.height, kNoPlane);  // planes are known for the first only
    for (const Panorama& one : more)
        observed.push_back(make_warp_source(one.color, one.range, no_planes, {},
                                            inverse(first.world_from_pano) * one.world_from_pano.translation));
    WalkWorld world;
    if (!looks)
        world = {first.range,
                 paint_planes(observed[0].color, first.range, label, observed[0].cuts, planes, *inpainter, run),
                 outside_picture(first.color, first.range), inpainter.get()};

    take(first);
    for (const Panorama& one : more) take(one);
    Progress progress(run, "walk", static_cast<std::int64_t>(positions.size()));
    for (const Vec3f& world_position : positions) {
        run.check_stop();
        const Vec3f position = inverse(first.world_from_pano) * world_position;
        Panorama next;
        CoarseView view = compose(coarse_view(observed, size, position), coarse_view(invented, size, position),
                                  next.known);
        look_into(mirrors, position, view, next.known);
        run.check_stop();  // steps on large pictures take long
        ImageMask hole(size.width, size.height);
        for (std::size_t i = 0; i < hole.size(); ++i) hole.pixels[i] = next.known.pixels[i] == Known::invented;
        next.world_from_pano = {first.world_from_pano.rotation, world_position};
        if (looks) look_into_room(view, hole, look, next.world_from_pano, run);
        else complete_holes(view, hole, position, world, run);
        PackedSource painted(make_warp_source(view.color, view.range, view.plane, carried_part(hole), position));
        next.color = std::move(view.color);
        next.range = std::move(view.range);
        next.color = smooth_silhouettes(next, observed, invented, position);
        invented.push_back(std::move(painted));  // later viewpoints process silhouettes themselves
        mark_carried(first, position, next);
        for (std::size_t i = 0; looks && i < hole.size(); ++i)
            if (hole.pixels[i]) next.known.pixels[i] = Known::looked;
        take(std::move(next));
        progress.advance();
    }
    return about;
}

}  // namespace

WalkParams resolved(WalkParams params, bool known_room) {
    if (params.kind == "auto") params.kind = known_room && params.inpainter == "auto" ? kRoomWalk : "ours";
    if (params.inpainter == "auto") params.inpainter = "aotgan";
    return params;
}

Json walk_through(const Panorama& given, const WalkParams& asked, const Run& run, const TakePanorama& take,
                  const WalkAdvice& advice, const std::vector<Panorama>& more) {
    const WalkParams params = resolved(asked, false);
    if (params.kind == kRoomWalk)
        throw UsageError("--walk {}: expected a known room, found only a panorama", kRoomWalk);
    if (params.inpainter == kLookIntoRoom && (params.kind != "ours" || !advice.room))
        throw UsageError(
            "--walk-inpainter {}: expected {}", kLookIntoRoom,
            params.kind != "ours" ? fmt::format("--walk ours, found {}", params.kind) : "a known room, found none");
    const Panorama first = ready_to_walk(given, run);
    if (!more.empty() && params.kind != "ours")
        throw UsageError("--walk {}: expected ours together with --more; the published walks support a single panorama",
                         params.kind);
    std::vector<Panorama> others;
    for (const Panorama& one : more) {
        FASTSCENE_CHECK(one.color.same_size(first.color) &&
                        one.world_from_pano.rotation == first.world_from_pano.rotation);
        others.push_back(ready_to_walk(one, run));
    }
    Json about = params.kind == "ours" ? walk_our_way(first, others, params, run, take, advice.room)
                                       : walk_as_published(first, params, run, take, advice.range);
    about["kind"] = params.kind;
    return about;
}

Walked walked_through(const Panorama& first, const WalkParams& params, const Run& run, const WalkAdvice& advice,
                      const std::vector<Panorama>& more) {
    Walked walked;
    walked.about = walk_through(
        first, params, run, [&](Panorama one) { walked.panoramas.push_back(std::move(one)); }, advice, more);
    return walked;
}

}  // namespace fastscene
