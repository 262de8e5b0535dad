#include "fastscene/io/plot_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/file.h"

namespace fastscene {
namespace {

constexpr double kWidth = 300, kHeight = 220, kLeft = 56, kTop = 40, kGap = 40, kBottom = 86;
constexpr const char* kColors[] = {"#3366aa", "#cc5533", "#338855", "#8855aa", "#888888"};

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}

struct Span {
    double low = 0, high = 0;  // zero is always included
    void hold(double v) {
        if (!std::isfinite(v)) return;
        low = std::min(low, v);
        high = std::max(high, v);
    }
    // 1, 2 or 5 times a power of ten, giving about five ticks.
    double step() const {
        const double rough = std::max(high - low, 1e-9) / 5, power = std::pow(10, std::floor(std::log10(rough)));
        return rough <= power ? power : rough <= 2 * power ? 2 * power : rough <= 5 * power ? 5 * power : 10 * power;
    }
};

struct Scale {
    Span x, y;
    Vec2d origin;
    double px(double v) const { return origin.x + (v - x.low) / (x.high - x.low) * kWidth; }
    double py(double v) const { return origin.y + kHeight - (v - y.low) / (y.high - y.low) * kHeight; }
};

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escaped(text));
}

std::string axes(const Plot& plot, const Scale& s) {
    std::string out = text_at(s.origin.x + kWidth / 2, s.origin.y - 12, "middle", plot.title, " font-weight=\"bold\"");
    for (double v = std::ceil(s.y.low / s.y.step()) * s.y.step(); v <= s.y.high * 1.0001; v += s.y.step())
        out += fmt::format("<path d=\"M{:.1f} {:.1f}h{}\" stroke=\"#ddd\"/>\n", s.origin.x, s.py(v), kWidth) +
               text_at(s.origin.x - 6, s.py(v) + 4, "end", fmt::format("{:.4g}", v));
    for (double v = std::ceil(s.x.low / s.x.step()) * s.x.step(); v <= s.x.high * 1.0001; v += s.x.step())
        out += text_at(s.px(v), s.origin.y + kHeight + 16, "middle",
                       fmt::format("{:.3g}", std::fabs(v) < 1e-12 ? 0.0 : v));
    out += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#555\"/>\n",
                       s.origin.x, s.origin.y, kWidth, kHeight);
    return out + text_at(s.origin.x + kWidth / 2, s.origin.y + kHeight + 34, "middle", plot.x_label);
}

std::string curve_of(const PlotCurve& curve, const Scale& s, const char* color) {
    std::string path, dots;
    for (const Vec2d& p : curve.points) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", s.px(p.x), s.py(p.y));
        dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", s.px(p.x), s.py(p.y),
                            color);
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"{}/>\n", path, color,
                       curve.dashed ? " stroke-dasharray=\"5 4\"" : "") +
           dots;
}

}  // namespace

void save_plots_svg(const std::filesystem::path& path, const std::vector<Plot>& plots) {
    Scale scale;
    std::vector<std::string> names;
    for (const Plot& plot : plots)
        for (const PlotCurve& curve : plot.curves) {
            if (std::find(names.begin(), names.end(), curve.name) == names.end()) names.push_back(curve.name);
            for (const Vec2d& p : curve.points) {
                scale.x.hold(p.x);
                scale.y.hold(p.y);
            }
        }
    scale.x.high += 0.04 * (scale.x.high - scale.x.low + 1e-9);
    scale.y.high += 0.04 * (scale.y.high - scale.y.low + 1e-9);
    const double width = kLeft + static_cast<double>(plots.size()) * (kWidth + kGap), height = kTop + kHeight + kBottom;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        width, height);
    const auto color_of = [&](const std::string& name) {
        return kColors[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()) %
                       std::size(kColors)];
    };
    for (std::size_t i = 0; i < plots.size(); ++i) {
        scale.origin = {kLeft + static_cast<double>(i) * (kWidth + kGap), kTop};
        svg += axes(plots[i], scale);
        for (const PlotCurve& curve : plots[i].curves) svg += curve_of(curve, scale, color_of(curve.name));
    }
    if (!plots.empty())
        svg += text_at(14, kTop + kHeight / 2, "middle", plots[0].y_label,
                       fmt::format(" transform=\"rotate(-90 14 {:.0f})\"", kTop + kHeight / 2));
    double x = kLeft;
    for (const std::string& name : names) {
        svg += fmt::format("<path d=\"M{:.0f} {:.0f}h20\" stroke=\"{}\" stroke-width=\"3\"/>\n", x, height - 18,
                           color_of(name)) +
               text_at(x + 26, height - 14, "start", name);
        x += 46 + 7.2 * static_cast<double>(name.size());
    }
    write_file(path, svg + "</svg>\n");
}

}  // namespace fastscene
