#include "fastscene/pipeline/stage_views.h"

#include "fastscene/base/file.h"
#include "fastscene/io/view_io.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/sfm.h"

namespace fastscene {
namespace fs = std::filesystem;

void make_views(const RunFolder& folder, const ViewsParams& params, const fs::path& out, const Run& run) {
    const Outside outside = load_outside(folder);
    const ViewSet known = project_views(load_walk(folder), params, run, &outside);
    save_views(out, known);
    if (params.sfm == "known") return;
    // The splats are trained from COLMAP's model; the known one is stored next to it.
    const SfmResult found = structure_from_motion(out, known, params.sfm, run);
    make_directories(out / "known");
    fs::rename(out / "sparse", out / "known" / "sparse");
    fs::rename(out / "transforms.json", out / "known" / "transforms.json");
    save_views(out, found.set);
    write_json(out / "sfm.json", to_json(found.report));
    write_file(out / "sfm.txt", table_of(found.report));
    const SfmReport& r = found.report;
    run.note(
        fmt::format("COLMAP: {} of {} views registered, {} points, {:.0f} s; position off by {:.4f} m (median), "
                    "rotation by {:.3f} degrees; views/sfm.txt has all",
                    r.registered, r.views, r.points, r.seconds, r.position_median_m, r.rotation_median_deg));
    if (r.registered < r.views)
        run.warn(fmt::format("COLMAP did not register {} of {} views: the splats are trained without them",
                             r.views - r.registered, r.views));
}

}  // namespace fastscene
