#include "fastscene/pipeline/earlier_splats.h"

#include <algorithm>
#include <cstdlib>

#include "fastscene/base/json.h"
#include "fastscene/geometry/grown.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/splat/continued.h"
#include "fastscene/trace/scene_bvh.h"

namespace fastscene {
namespace fs = std::filesystem;

namespace {

// Where two runs look different from a viewpoint that both have.
struct SeenChange {
    Rigid pano_from_world;
    ImageMask changed;
    ImageF range;  // metres, of the new run

    // Whether the point is seen there, or stands before what is seen there.
    bool holds(Vec3f point) const {
        constexpr float kBehind = 1.02f, kBehind_m = 0.03f;  // still the same surface
        const Vec3f seen = pano_from_world * point;
        const Vec2f at = pixel_of_direction(seen, {changed.width, changed.height});
        const int x = std::clamp(static_cast<int>(at.x), 0, changed.width - 1),
                  y = std::clamp(static_cast<int>(at.y), 0, changed.height - 1);
        return changed.at(x, y) != 0 && length(seen) < kBehind * range.at(x, y) + kBehind_m;
    }
};

// Training soon corrects slight tints. Splats of what looks quite different keep traces of it.
ImageMask clearly_changed(const ImageRgb8& before, const ImageRgb8& now) {
    constexpr int kClear = 8;   // of 255, in any channel
    constexpr int kAround = 2;  // pixels
    ImageMask out(now.width, now.height);
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Rgb8 a = before.pixels[i], b = now.pixels[i];
        const int most = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        out.pixels[i] = most > kClear ? 255 : 0;
    }
    return grown(out, kAround, true);
}

std::vector<SeenChange> seen_changes(const fs::path& before, const fs::path& now) {
    const std::vector<Viewpoint> earlier = load_viewpoints(before / "poses.json");
    std::vector<SeenChange> out;
    for (const Viewpoint& viewpoint : load_viewpoints(now / "poses.json")) {
        const auto same = std::find_if(earlier.begin(), earlier.end(), [&](const Viewpoint& other) {
            return other.world_from_pano.translation == viewpoint.world_from_pano.translation;
        });
        if (same == earlier.end()) continue;
        const ImageRgb8 a = load_rgb8(before / same->name / "color.png"),
                        b = load_rgb8(now / viewpoint.name / "color.png");
        if (!a.same_size(b)) continue;
        out.push_back({inverse(viewpoint.world_from_pano), clearly_changed(a, b),
                       load_float(now / viewpoint.name / "range.exr")});
    }
    return out;
}

}  // namespace

std::optional<Splats> earlier_splats(const EarlierRun& earlier, const RunFolder& folder,
                                     const std::vector<SurfacePoint>& points, const SplatParams& params,
                                     const Run& run) {
    constexpr double kLeastKept = 0.15;  // share of panorama 0's pixels
    constexpr float kNear_m = 0.04f;     // of a changed surface: farther than a splat reaches
    if (about_of_stage(folder.stage("panorama")).value("kept_pixels", 0.) < kLeastKept) return {};
    if (!fs::exists(earlier.folder.scene_ply())) return {};
    Splats before;
    try {
        before = load_splats(earlier.folder.scene_ply()).splats;
    } catch (const Error& e) {
        run.note(fmt::format("splat: begins from scratch: {}", e.what()));
        return {};
    }
    if (before.sh_degree != params.sh_degree) return {};
    const SceneBvh surfaces(earlier.change.surfaces);
    const std::vector<SeenChange> seen = seen_changes(earlier.folder.walk(), folder.walk());
    const auto is_changed = [&](Vec3f point) {
        return surfaces.nearest(point, kNear_m) < kNear_m ||
               std::any_of(seen.begin(), seen.end(), [&](const SeenChange& view) { return view.holds(point); });
    };
    Splats begun = continued_splats(before, points, is_changed, params, run);
    begun.filter = params.filter();
    run.note(fmt::format("splat: begins from the {} Gaussians of {}", begun.size(), earlier.folder.root.string()));
    return begun;
}

}  // namespace fastscene
