#include "fastscene/views/views.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/cubemap.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/geometry/resample.h"
#include "fastscene/image/color.h"
#include "fastscene/views/points.h"

namespace fastscene {
namespace {

constexpr std::size_t kViewsAPanorama = 14;

// Six faces and eight corners of the cube. Corner cameras are kept level.
std::array<Mat3f, kViewsAPanorama> view_rotations() {
    std::array<Mat3f, kViewsAPanorama> out;
    std::size_t n = 0;
    for (const CubeFace face : kCubeFaces) out[n++] = pano_from_face(face);
    for (const float y : {-1.f, 1.f})
        for (const Vec2f xz : {Vec2f{1, 1}, Vec2f{1, -1}, Vec2f{-1, -1}, Vec2f{-1, 1}}) {
            const Vec3f forward = normalize(Vec3f{xz.x, y, xz.y}), right = normalize(Vec3f{xz.y, 0, -xz.x});
            out[n++] = Mat3f::from_columns(right, cross(forward, right), forward);
        }
    return out;
}

// Weight of each pixel of a panorama; empty = all full.
ImageMask weights_of(const Panorama& panorama, const ViewsParams& params) {
    const bool all_original = panorama.known.empty() ||
                              std::all_of(panorama.known.pixels.begin(), panorama.known.pixels.end(),
                                          [](Known k) { return k == Known::original; });
    if (all_original) return {};
    const int w = panorama.color.width, h = panorama.color.height;
    const ImageMask cuts = range_edges(panorama.range);
    ImageMask out(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const Known known = panorama.known.at(x, y);
            int weight = known == Known::original || known == Known::looked ? 255
                         : known == Known::carried                          ? params.weight_carried
                                                                            : params.weight_invented;
            // A warped silhouette is accurate to a pixel at best.
            if (cuts.at(x, y) & (kFarSide | kNearSide)) weight = std::min(weight, params.weight_silhouette);
            out.at(x, y) = static_cast<std::uint8_t>(std::clamp(weight, 0, 255));
        }
    return out;
}

ImageMask cut_weights(const ImageMask& weights, const Pinhole& camera, const Mat3f& pano_from_camera) {
    ImageMask out(camera.width, camera.height);
    const EquirectSize size{weights.width, weights.height};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Vec2f at = pixel_of_direction(
                pano_from_camera * camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}),
                size);
            out.at(x, y) = weights.at(wrap_column(static_cast<int>(at.x), size.width),
                                      std::min(static_cast<int>(at.y), size.height - 1));
        }
    return out;
}

// The cutouts of panoramas of one size, with precomputed resampling. Bicubic: no trainer recovers the sharpness that
// bilinear resampling loses.
class Cuts {
  public:
    Cuts(EquirectSize size, const Pinhole& camera, const std::array<Mat3f, kViewsAPanorama>& rotations) : size_(size) {
        for (const Mat3f& rotation : rotations)
            plans_.emplace_back(equirect_picture(size), perspective_picture(camera, rotation), Filter::bicubic);
    }
    EquirectSize size() const { return size_; }
    ImageRgb8 cut(const ImageColor& unit, std::size_t i) const { return srgb8_from_unit(plans_[i].apply(unit)); }

  private:
    EquirectSize size_;
    std::vector<ResamplePlan> plans_;
};

}  // namespace

ViewSet project_views(std::vector<Panorama> panoramas, const ViewsParams& params, const Run& run,
                      const Outside* outside) {
    for (std::size_t p = 0; p < panoramas.size(); ++p)
        if (panoramas[p].range.empty()) throw Error("views: panorama {} has no range map; expected one a panorama", p);
    ViewSet set;
    const std::vector<SurfacePoint> behind = panoramas.empty() ? std::vector<SurfacePoint>{}
                                                               : backdrop_points(panoramas, params.backdrop, outside);
    // First, because it needs all panoramas at once, while cutting frees them one by one.
    set.points = sample_points(panoramas, params, run, outside);
    set.points.insert(set.points.end(), behind.begin(), behind.end());
    const Pinhole camera = Pinhole::with_fov(params.size, params.size, params.fov_deg);
    const auto rotations = view_rotations();
    std::optional<Cuts> cuts;
    Progress progress(run, "views", static_cast<std::int64_t>(panoramas.size()));
    for (std::size_t p = 0; p < panoramas.size(); ++p) {
        run.check_stop();
        const Panorama panorama = std::move(panoramas[p]);
        const ImageMask weights = weights_of(panorama, params);
        if (!cuts || cuts->size().width != panorama.color.width) cuts.emplace(panorama.size(), camera, rotations);
        const ImageColor color = unit_from_linear(
            panorama.color);  // in sRGB: bicubic interpolation in linear light would ring darkly around lamps
        for (std::size_t i = 0; i < rotations.size(); ++i) {
            View view;
            view.name = fmt::format("{:03}_{:02}.png", p, i);
            view.camera = camera;
            view.world_from_camera = {panorama.world_from_pano.rotation * rotations[i],
                                      panorama.world_from_pano.translation};
            view.color = cuts->cut(color, i);
            if (!weights.empty()) view.weight = cut_weights(weights, camera, rotations[i]);
            set.views.push_back(std::move(view));
        }
        progress.advance();
    }
    return set;
}

}  // namespace fastscene
