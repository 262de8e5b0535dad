#include "fastscene/pipeline/depth_report.h"

#include <ctime>
#include <set>
#include <utility>
#include <vector>

#include "fastscene/depth/estimator.h"
#include "fastscene/depth/examples.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/depth_scores.h"

namespace fastscene {
namespace {

constexpr std::pair<const char*, DepthAlignment> kAlignments[] = {
    {"affine", DepthAlignment::affine}, {"scale", DepthAlignment::scale}, {"none", DepthAlignment::none}};

// The first picture of each place.
std::vector<DepthFiles> chosen(const DepthCheck& check, const Run& run) {
    std::vector<DepthFiles> out;
    std::set<std::string> seen;
    for (const DepthFiles& files : find_depth_files(check.data))
        if ((check.all || files.held_out) && seen.insert(files.place).second &&
            static_cast<int>(out.size()) < check.count)
            out.push_back(files);
    if (out.empty())
        throw Error("{}: expected {}places, found none{}", check.data.string(), check.all ? "" : "held-out ",
                    check.all ? "" : ": --all takes those of a set that the network never saw");
    if (static_cast<int>(out.size()) < check.count)
        run.warn(fmt::format("{}: expected {} {}places, found {}{}", check.data.string(), check.count,
                             check.all ? "" : "held-out ", out.size(),
                             check.all ? "" : ": --all takes all, if the network never saw this set"));
    return out;
}

Json json_of(const DepthScores& s) {
    return {{"abs_rel", s.abs_rel},
            {"rmse_m", s.rmse},
            {"delta1", s.delta[0]},
            {"delta2", s.delta[1]},
            {"delta3", s.delta[2]}};
}

}  // namespace

Json check_depth(const DepthCheck& check, const Run& run) {
    const std::vector<DepthFiles> all = chosen(check, run);
    const auto estimator = make_depth_estimator(check.depth);
    std::vector<DepthScores> scores[std::size(kAlignments)];
    Json pictures = Json::array(), report = Json::object();
    std::string backend;
    double seconds = 0;
    Progress progress(run, "pictures", static_cast<std::int64_t>(all.size()));
    std::vector<std::string> left_out;
    for (const DepthFiles& files : all) {
        run.check_stop();
        progress.advance();
        try {
            const ImageF truth = load_float(files.range);
            const ImageColor color = linear_from_srgb8(load_rgb8(files.color));
            const std::clock_t begin = std::clock();
            const EstimatedRange found = estimator->estimate(color, run);
            const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
            Json one{{"picture", files.color.filename().string()}};
            DepthScores each[std::size(kAlignments)];
            for (std::size_t i = 0; i < std::size(kAlignments); ++i) {
                DepthScoreOptions options;
                options.alignment = kAlignments[i].second;
                options.found_name = "range estimated of " + files.color.string(),
                options.truth_name = files.range.string();
                each[i] = depth_scores(found.range, truth, options);
                one[kAlignments[i].first] = json_of(each[i]);
            }
            for (std::size_t i = 0; i < std::size(kAlignments); ++i) scores[i].push_back(each[i]);
            seconds += took;
            backend = found.assumptions.value("backend", "");
            pictures.push_back(one);
        } catch (const Error& e) {
            left_out.push_back(e.what());
            run.warn(fmt::format("left out: {}", e.what()));
        }
    }
    if (pictures.empty())
        throw Error("{}: expected {}pictures with range, found none of {} that can be used; the first: {}",
                    check.data.string(), check.all ? "" : "held-out ", all.size(), left_out[0]);
    report["backend"] = backend;
    report["pictures"] = pictures.size();
    report["held_out"] = !check.all;
    report["left_out"] = left_out;
    report["cpu_s_per_picture"] = seconds / static_cast<double>(pictures.size());
    for (std::size_t i = 0; i < std::size(kAlignments); ++i)
        report[kAlignments[i].first] = json_of(mean_scores(scores[i]));
    report["each"] = pictures;
    return report;
}

std::string depth_check_text(const Json& report) {
    const std::size_t left_out = report.at("left_out").size();
    std::string text = fmt::format("{}, {} {}places{}, {:.1f} CPU seconds a picture\n{:8} {:>8} {:>8} {:>8} {:>8}",
                                   report.at("backend").get<std::string>(), report.at("pictures").get<int>(),
                                   report.at("held_out").get<bool>() ? "held-out " : "",
                                   left_out == 0 ? "" : fmt::format(" ({} more cannot be used)", left_out),
                                   report.at("cpu_s_per_picture").get<double>(), "aligned", "AbsRel", "RMSE m", "d1",
                                   "d2");
    for (const auto& [name, alignment] : kAlignments) {
        const Json& s = report.at(name);
        text += fmt::format("\n{:8} {:8.4f} {:8.4f} {:8.4f} {:8.4f}", name, s.at("abs_rel").get<double>(),
                            s.at("rmse_m").get<double>(), s.at("delta1").get<double>(), s.at("delta2").get<double>());
    }
    return text;
}

}  // namespace fastscene
