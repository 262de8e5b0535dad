#include "fastscene/pipeline/fit_report.h"

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/plot_svg.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

ImageRgb8 beside(const ImageRgb8& left, const ImageRgb8& right) {
    ImageRgb8 both(left.width + right.width, std::max(left.height, right.height));
    for (int y = 0; y < left.height; ++y)
        for (int x = 0; x < left.width; ++x) both.at(x, y) = left.at(x, y);
    for (int y = 0; y < right.height; ++y)
        for (int x = 0; x < right.width; ++x) both.at(left.width + x, y) = right.at(x, y);
    return both;
}

// Every step that occurs in either list, in order; missing values are empty cells.
std::string csv_of(const FittedSplats& fitted) {
    std::string text = "step,loss,psnr_train,psnr_held_out,ssim_held_out\n";
    auto c = fitted.curve.begin();
    auto e = fitted.evals.begin();
    while (c != fitted.curve.end() || e != fitted.evals.end()) {
        const bool has_curve = c != fitted.curve.end() && (e == fitted.evals.end() || c->step <= e->step);
        const bool has_eval = e != fitted.evals.end() && (c == fitted.curve.end() || e->step <= c->step);
        text += fmt::format("{},", has_curve ? c->step : e->step);
        text += has_curve ? fmt::format("{},{},", c->loss, c->psnr) : ",,";
        text += has_eval ? fmt::format("{},{}\n", e->psnr, e->ssim) : ",\n";
        c += has_curve, e += has_eval;
    }
    return text;
}

}  // namespace

std::string device_of_fit(const fs::path& dir) {
    if (!fs::exists(dir / "curve.json")) return {};
    return read_json(dir / "curve.json").value("device", "");
}

void save_curves(const fs::path& out, const FittedSplats& fitted) {
    Json curve = Json::array(), evals = Json::array();
    PlotCurve train{"training views", {}, false}, held_out{"held-out views", {}, false};
    for (const CurvePoint& p : fitted.curve) {
        curve.push_back({{"step", p.step}, {"loss", p.loss}, {"psnr", p.psnr}});
        train.points.push_back({static_cast<double>(p.step), p.psnr});
    }
    for (const EvalPoint& e : fitted.evals) {
        evals.push_back({{"step", e.step}, {"psnr", e.psnr}, {"ssim", e.ssim}});
        held_out.points.push_back({static_cast<double>(e.step), e.psnr});
    }
    Json json{{"curve", curve}, {"steps", fitted.steps}, {"device", fitted.device}};
    if (!fitted.evals.empty()) json["held_out"] = evals;
    write_json(out / "curve.json", json);
    write_file(out / "curve.csv", std::string_view(csv_of(fitted)));
    Plot plot{"Training", "step", "PSNR, dB", {}};
    for (const PlotCurve* c : {&train, &held_out})
        if (!c->points.empty()) plot.curves.push_back(*c);
    if (!plot.curves.empty()) save_plots_svg(out / "curve.svg", {plot});
    if (!fitted.eval_pictures.empty()) make_directories(out / "eval");
    for (std::size_t i = 0; i < fitted.eval_pictures.size(); ++i) {
        const EvalPicture& p = fitted.eval_pictures[i];
        save_png(out / "eval" / fmt::format("{:02}-{}.png", i, fs::path(p.view).stem().string()),
                 beside(p.picture, p.truth));
    }
}

}  // namespace fastscene
