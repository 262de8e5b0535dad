#include "fastscene/pipeline/earlier_splats.h"

#include "fastscene/base/json.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/splat/continued.h"
#include "fastscene/trace/scene_bvh.h"

namespace fastscene {
namespace fs = std::filesystem;

std::optional<Splats> earlier_splats(const EarlierRun& earlier, const RunFolder& folder,
                                     const std::vector<SurfacePoint>& points, const SplatParams& params,
                                     const Run& run) {
    constexpr double kLeastKept = 0.15;  // share of panorama 0's pixels
    constexpr float kNear_m = 0.04f;     // of a changed surface: farther than a splat reaches
    const fs::path about = folder.stage("panorama") / kAboutName;
    if (!fs::exists(about) || read_json(about).value("kept_pixels", 0.) < kLeastKept) return {};
    if (!fs::exists(earlier.folder.scene_ply())) return {};
    Splats before;
    try {
        before = load_splats(earlier.folder.scene_ply()).splats;
    } catch (const Error& e) {
        run.note(fmt::format("splat: begins from scratch: {}", e.what()));
        return {};
    }
    if (before.sh_degree != params.sh_degree) return {};
    const SceneBvh changed(earlier.change.surfaces);
    Splats begun = continued_splats(
        before, points, [&](Vec3f p) { return changed.nearest(p, kNear_m) < kNear_m; }, params, run);
    begun.antialias = params.antialias;
    run.note(fmt::format("splat: begins from the {} Gaussians of {}", begun.size(), earlier.folder.root.string()));
    return begun;
}

}  // namespace fastscene
