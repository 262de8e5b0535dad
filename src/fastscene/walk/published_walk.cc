#include "fastscene/walk/published_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/shortest.h"
#include "fastscene/depth/depth.h"
#include "fastscene/image/color.h"
#include "fastscene/walk/free_space.h"
#include "fastscene/walk/published_inpaint.h"
#include "fastscene/walk/published_warp.h"

namespace fastscene {
namespace {

constexpr int kFaceSize = 512;  // as published for 1024 columns; narrower panoramas use half their width

// The state carried from step to step.
struct Frame {
    ImageRgb8 color;
    Image<double> range;  // metres; sky: +inf
    Image<Known> known;
    Vec3f position;  // in panorama 0's frame
};

template <class T>
T greatest_range(const Image<T>& range) {
    T most = 0;
    for (const T r : range.pixels)
        if (std::isfinite(r)) most = std::max(most, r);
    return most;
}

// The warp of a step, plus what the official program does not track: sky, and each pixel's origin.
struct Stepped {
    PublishedWarp warp;  // range in metres
    Image<Known> known;
    ImageMask hole;
};
Stepped step_to(const Frame& from, Vec3d move_m) {
    const double most = greatest_range(from.range);
    Stepped to{published_warp(from.color, published_units(from.range), move_m / most),
               Image<Known>(from.color.width, from.color.height, Known::invented),
               ImageMask(from.color.width, from.color.height)};
    for (std::size_t i = 0; i < to.hole.size(); ++i) {
        const std::int32_t source = to.warp.source.pixels[i];
        if (source == kNoSource) {
            to.hole.pixels[i] = 255;
            continue;
        }
        const auto s = static_cast<std::size_t>(source);
        to.known.pixels[i] = from.known.pixels[s] == Known::original ? Known::original : Known::carried;
        to.warp.range.pixels[i] = std::isfinite(from.range.pixels[s]) ? to.warp.range.pixels[i] * most
                                                                      : std::numeric_limits<double>::infinity();
    }
    return to;
}

ImageF in_float(const Image<double>& image) {
    ImageF out(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), out.pixels.begin(),
                   [](double v) { return static_cast<float>(v); });
    return out;
}

// Without an estimator: the warped range with its holes smoothly interpolated, where the sky counts as the farthest
// range.
Image<double> filled_range(const PublishedWarp& warp) {
    ImageF range = in_float(warp.range);
    const float most = greatest_range(range);
    for (float& r : range.pixels) r = std::min(r, most);
    Panorama panorama;
    panorama.color = ImageColor(range.width, range.height);
    Image<double> filled = in_double(with_range(std::move(panorama), std::move(range), "warped range").range);
    for (std::size_t i = 0; i < filled.size(); ++i)
        if (std::isinf(warp.range.pixels[i])) filled.pixels[i] = warp.range.pixels[i];
    return filled;
}

}  // namespace

Json walk_as_published(const Panorama& first, const WalkParams& params, const Run& run, const TakePanorama& take,
                       const RangeEstimator& estimate) {
    const auto inpainter = make_inpainter(params.inpainter, params.inpaint_weights, params.device, params.trusted);
    const Painter paint = [&](const ImageRgb8& color, const ImageMask& hole) {
        const ImageColor linear = linear_from_srgb8(color);
        const bool is_panorama = color.width == 2 * color.height;  // paper-direct; else a cube face
        return srgb8_from_linear(is_panorama ? fill_panorama(*inpainter, linear, hole, run)
                                             : inpainter->fill(linear, hole, run));
    };
    const bool far = params.kind == "paper-far", direct = params.kind == "paper-direct";
    const int steps = far ? 1 : params.steps;
    const double share = far ? params.step * params.steps : params.step;
    const int face_size = std::min(kFaceSize, first.color.width / 2);
    const Image<double> first_range = in_double(first.range);
    const Frame start{srgb8_from_linear(first.color), first_range, first.known, {}};

    take(first);
    Json clipped = Json::array();
    Progress progress(run, "walk", static_cast<std::int64_t>(std::size(kPublishedDirections)) * steps);
    for (const PublishedDirection& direction : kPublishedDirections) {
        Frame frame = start;
        const Vec3d along = world_from_published(direction.move);
        const Vec3f toward = normalize(
            Vec3f{static_cast<float>(along.x), static_cast<float>(along.y), static_cast<float>(along.z)});
        // The official step length is a share of the greatest range, recomputed each time; here it also has to stay
        // inside the room.
        const double free_m = kMostOfTheWay * static_cast<double>(distance_ahead(first.range, toward));
        double reached_m = 0, wanted_m = 0;
        for (int step = 0; step < steps; ++step) {
            run.check_stop();
            const double long_m = share * greatest_range(frame.range) * length(direction.move);
            const double step_m = std::min(long_m, (free_m - reached_m) / (steps - step));
            const Vec3d move_m = direction.move * (step_m / length(direction.move));
            wanted_m += long_m;
            reached_m += step_m;
            Stepped next = step_to(frame, move_m);
            const ImageRgb8 painted = direct ? paint(next.warp.color, next.hole)
                                             : published_inpaint(next.warp.color, next.hole, face_size, paint);
            frame.color = painted;
            if (direct)  // in direct mode, too, only hole pixels are taken from the painted picture
                for (std::size_t i = 0; i < next.hole.size(); ++i)
                    if (!next.hole.pixels[i]) frame.color.pixels[i] = next.warp.color.pixels[i];
            frame.range = estimate ? in_double(estimate(linear_from_srgb8(frame.color), run)) : filled_range(next.warp);
            frame.known = std::move(next.known);
            const Vec3d moved = world_from_published(move_m);
            frame.position += Vec3f{static_cast<float>(moved.x), static_cast<float>(moved.y),
                                    static_cast<float>(moved.z)};
            take({linear_from_srgb8(frame.color),
                  in_float(frame.range),
                  frame.known,
                  {first.world_from_pano.rotation, first.world_from_pano * frame.position}});
            progress.advance();
        }
        if (reached_m < 0.999 * wanted_m) {
            run.warn(fmt::format(
                "walk: {:.2f} m towards {} would leave the room or enter an object; the steps were clipped to {:.2f} m",
                wanted_m, direction.name, reached_m));
            clipped.push_back({{"direction", direction.name},
                               {"wanted_m", shortest(static_cast<float>(wanted_m))},
                               {"reached_m", shortest(static_cast<float>(reached_m))}});
        }
    }
    return {{"depth", estimate ? "estimated from each new panorama"
                               : "no estimator: uses the warped range with smoothly filled holes"},
            {"steps", steps},
            {"step_share_of_greatest_range", shortest(static_cast<float>(share))},
            {"clipped", clipped}};
}

}  // namespace fastscene
