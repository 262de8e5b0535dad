#include <algorithm>
#include <cmath>
#include <map>

#include "fastscene/cli/checks.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/metrics.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/depth_scores.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, DepthAlignment> kAlignments{
    {"none", DepthAlignment::none}, {"scale", DepthAlignment::scale}, {"affine", DepthAlignment::affine}};

// A run folder stands for its range map.
fs::path map_of(const std::string& given) {
    return fs::is_directory(given) ? RunFolder{given}.depth_range() : fs::path(given);
}

// Nearest neighbour: an interpolated range lies on neither surface.
ImageF at_size_of(const ImageF& found, const ImageF& truth) {
    if (found.same_size(truth)) return found;
    ImageF out(truth.width, truth.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.at(x, y) = found.at((2 * x + 1) * found.width / (2 * out.width),
                                    (2 * y + 1) * found.height / (2 * out.height));
    return out;
}

Json json_of(const DepthScores& s) {
    return {{"abs_rel", s.abs_rel}, {"sq_rel", s.sq_rel},   {"rmse_m", s.rmse},     {"rmse_log", s.rmse_log},
            {"delta1", s.delta[0]}, {"delta2", s.delta[1]}, {"delta3", s.delta[2]}, {"scale", s.scale},
            {"shift_m", s.shift},   {"pixels", s.pixels},   {"missing", s.missing}};
}

// Median ratio of found to true: a value like 1000 means wrong units, not an inaccurate estimate.
void tell_what_looks_wrong(const DepthScores& s, const ImageF& found, const ImageF& truth, double farthest,
                           DepthAlignment alignment, const std::string& name, const Run& run) {
    constexpr float kOtherUnit = 100;
    if (s.missing > 0)
        run.warn(fmt::format("{}: {} of {} measured pixels have no estimate (NaN or infinite) and are not counted",
                             name, s.missing, s.missing + s.pixels));
    if (alignment != DepthAlignment::none) return;  // alignment corrects units
    std::vector<float> ratios;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (const float f = found.pixels[i], t = truth.pixels[i];
            f > 0 && std::isfinite(f) && t > 0 && static_cast<double>(t) <= farthest)
            ratios.push_back(f / t);
    if (ratios.empty()) return;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    if (*middle > kOtherUnit || *middle < 1 / kOtherUnit)
        run.warn(
            fmt::format("{}: expected metres as in the truth, found {:.4g} times as much (in the middle): are these "
                        "millimetres, or no metres at all?",
                        name, *middle));
}

}  // namespace

Verb add_metrics_depth(CLI::App& metrics) {
    struct Flags {
        std::string found, truth, align = "affine", farthest = "10";
        bool solid_angle = false;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = metrics.add_subcommand(
        "depth", "An estimated range map against a measured one: AbsRel, RMSE, delta < 1.25 …");
    verb->add_option("found", flags->found,
                     "Estimated range map (.exr, .pfm, .tif, 16-bit .png in millimetres), or the folder of a run.")
        ->type_name("MAP")
        ->required();
    verb->add_option("truth", flags->truth, "Measured range map; 0 = not measured; or the folder of a run.")
        ->type_name("MAP")
        ->required();
    verb->add_option("--align", flags->align,
                     "What is set right first: none, the scale (by the median), or scale and shift (least squares), as "
                     "published.")
        ->type_name("none|scale|affine")
        ->check(one_of({"none", "scale", "affine"}))
        ->capture_default_str();
    verb->add_option("--farthest", flags->farthest,
                     "Pixels whose truth is farther than this, in metres, are not counted.")
        ->type_name("M")
        ->capture_default_str();
    verb->add_flag("--solid-angle", flags->solid_angle,
                   "Weigh pixels by their solid angle; published figures count them alike.");
    verb->footer("Example:\n  fastscene metrics depth out/photo measured.png --align scale");
    return {verb, [flags](const Session& session) {
                const double farthest = number_from<double>("--farthest", flags->farthest);
                if (!(farthest > 0)) throw UsageError("--farthest: expected metres above 0, found {}", farthest);
                const ImageF truth = load_float(map_of(flags->truth)), found = load_float(map_of(flags->found));
                if (static_cast<std::int64_t>(found.width) * truth.height !=
                    static_cast<std::int64_t>(found.height) * truth.width)
                    throw Error("{}: expected the shape of {} ({} x {}), found {} x {}", flags->found, flags->truth,
                                truth.width, truth.height, found.width, found.height);
                const ImageF seen = at_size_of(found, truth);
                const DepthScores s = depth_scores(seen, truth,
                                                   {kAlignments.at(flags->align), farthest, flags->solid_angle,
                                                    map_of(flags->found).string(), map_of(flags->truth).string()});
                tell_what_looks_wrong(s, seen, truth, farthest, kAlignments.at(flags->align), flags->found,
                                      session.run(0));
                session.print(fmt::format("AbsRel {:.4f}  SqRel {:.4f}  RMSE {:.4f} m  RMSElog {:.4f}  d1 {:.4f}  d2 "
                                          "{:.4f}  d3 {:.4f}   ({} pixels; range = {:.4f} x + {:.4f} m)",
                                          s.abs_rel, s.sq_rel, s.rmse, s.rmse_log, s.delta[0], s.delta[1], s.delta[2],
                                          s.pixels, s.scale, s.shift),
                              json_of(s));
            }};
}

}  // namespace fastscene::cli
