#include "fastscene/pipeline/hole_report.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/plot_svg.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/pipeline/same_room.h"

namespace fastscene {
namespace fs = std::filesystem;

std::vector<HoleRow> hole_table_of_run(const fs::path& run_dir, bool truth, const Run& run) {
    const RunFolder folder{run_dir};
    const RecordedRun recorded = recorded_run(folder);
    if (!fs::exists(folder.depth_range()))
        throw UsageError(
            "{}: expected a run with a finished depth stage, found no depth/range.exr; make it with `fastscene depth "
            "{}`",
            run_dir.string(), run_dir.string());
    const ImageF range = load_float(folder.depth_range());
    if (!truth) return hole_table(range, run);
    const SceneSource& source = recorded.request.source;
    if (!has_room(source))
        throw UsageError("--truth: expected a scene from a prompt: the picture of {} has no known room to compare with",
                         run_dir.string());
    const TracedRoom room = make_unlit_room(origin_of(source), recorded.request.params.panorama,
                                            {recorded.seed, run.events, run.stop});
    check_same_room(room, range, run_dir);
    return hole_table(range, run, [&](Vec3f from, Vec3f direction) { return room.distance(from, direction); });
}

std::vector<HoleRow> hole_table_of_picture(const fs::path& picture, const fs::path& range_map, const Run& run) {
    return hole_table(range_from_file(range_map, panorama_from_image(picture).size(), run), run);
}

void save_hole_table(const fs::path& folder, const std::vector<HoleRow>& rows) {
    make_directories(folder);
    write_file(folder / "hole_table.txt", hole_table_text(rows));
    write_json(folder / "hole_table.json", hole_table_json(rows));
    std::vector<Plot> plots;
    for (const char axis : {'x', 'y', 'z'}) {
        Plot plot{fmt::format("along {}", axis),
                  "step, share of the greatest range",
                  "holes, % of the picture",
                  {{"published", {}, false},
                   {"ours", {}, false},
                   {"paper's scenes", {}, true},
                   {"true disocclusion", {}, true}}};
        for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
            if (row->axis != axis) continue;
            plot.curves[0].points.push_back({row->share, 100 * row->published});
            plot.curves[1].points.push_back({row->share, 100 * row->ours});
            plot.curves[2].points.push_back({row->share, 100 * row->paper});
            if (row->truth) plot.curves[3].points.push_back({row->share, 100 * row->truth->ratio});
        }
        std::erase_if(plot.curves, [](const PlotCurve& c) { return c.points.empty(); });
        plots.push_back(plot);
    }
    save_plots_svg(folder / "hole_table.svg", plots);
}

}  // namespace fastscene
