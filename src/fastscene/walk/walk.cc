#include "fastscene/walk/walk.h"

#include <limits>

#include "fastscene/walk/complete.h"

namespace fastscene {
namespace {

// An invented surface must stand clearly in front of an observed one to hide it.
constexpr float kObservedWins = 1.03f;
constexpr float kObservedWins_m = 0.02f;

void check_first(const Panorama& first) {
    if (first.range.empty() || !first.range.same_size(first.color))
        throw Error("walk: expected a range map of the panorama's size {} x {}, found {} x {}", first.color.width, first.color.height,
                    first.range.width, first.range.height);
    if (first.color.width != 2 * first.color.height || first.color.height < 8)
        throw Error("walk: expected a panorama twice as wide as high, found {} x {}", first.color.width, first.color.height);
    for (int y = 0; y < first.range.height; ++y)
        for (int x = 0; x < first.range.width; ++x)
            if (!(first.range.at(x, y) > 0.f))
                throw Error("walk: range at ({}, {}) is {}; expected metres > 0 (the depth stage fills what is missing)", x, y, first.range.at(x, y));
}

// What the observed and the invented surfaces show together; `known` says which pixel came from where.
CoarseView compose(const std::vector<WarpSource>& observed, const std::vector<WarpSource>& invented, Vec3f position, EquirectSize size,
                   Image<Known>& known) {
    CoarseView view = coarse_view(observed, size, position);
    const CoarseView other = coarse_view(invented, size, position);
    known = Image<Known>(size.width, size.height, Known::invented);
    for (std::size_t i = 0; i < view.color.size(); ++i) {
        const bool seen = view.cover.pixels[i] != Cover::hole && view.cover.pixels[i] != Cover::guess;
        const bool guessed = view.cover.pixels[i] == Cover::guess && other.range.pixels[i] > kFarthestRange;   // as good as sky painted earlier
        const bool painted = other.cover.pixels[i] == Cover::front && !guessed;   // what we made up has no back
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

}  // namespace

std::vector<Panorama> walk_through(const Panorama& first, const WalkParams& params, const Run& run) {
    check_first(first);
    const EquirectSize size = first.size();
    const std::vector<Vec3f> positions = choose_viewpoints(first, params);
    const auto inpainter = make_inpainter(params.inpainter);
    const std::vector<ScenePlane> planes = find_planes(first.range, run.seed);
    const Image<std::int16_t> label = label_planes(first.range, planes);

    std::vector<WarpSource> observed, invented;
    observed.push_back(make_warp_source(first.color, first.range, label, {}, {}));
    const WalkWorld world{first.range, paint_planes(observed[0].color, first.range, label, observed[0].cuts, planes, *inpainter, run),
                          outside_picture(first.color, first.range), inpainter.get()};

    std::vector<Panorama> walked{first};
    if (walked[0].known.empty()) walked[0].known = Image<Known>(size.width, size.height, Known::original);
    Progress progress(run, "walk", static_cast<std::int64_t>(positions.size()));
    for (const Vec3f& world_position : positions) {
        run.check_stop();
        const Vec3f position = inverse(first.world_from_pano) * world_position;
        Panorama next;
        CoarseView view = compose(observed, invented, position, size, next.known);
        ImageMask hole(size.width, size.height);
        for (std::size_t i = 0; i < hole.size(); ++i) hole.pixels[i] = next.known.pixels[i] == Known::invented;
        complete_holes(view, hole, position, world, run);
        invented.push_back(make_warp_source(view.color, view.range, view.plane, hole, position));
        next.color = std::move(view.color);
        next.range = std::move(view.range);
        next.world_from_pano = {first.world_from_pano.rotation, world_position};
        walked.push_back(std::move(next));
        progress.advance();
    }
    return walked;
}

}  // namespace fastscene
