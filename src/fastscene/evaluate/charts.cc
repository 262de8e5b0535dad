#include "fastscene/evaluate/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fastscene {
namespace {

constexpr double kWidth = 460, kBarHeight = 16, kLabelStep = 16, kBarGap = 12, kTop = 34;
constexpr std::size_t kLabelLetters = 54;  // of a line; phones enlarge them

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& style = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>", x, y, anchor,
                       style.empty() ? "" : " class=\"" + style + "\"", html_escaped(text));
}

// Breaks text into lines of at most that many letters, between words if possible.
std::vector<std::string> lines_of(const std::string& text, std::size_t letters) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = std::min(text.size(), begin + letters);
        if (end < text.size()) {
            const std::size_t space = text.rfind(' ', end);
            if (space != std::string::npos && space > begin) end = space;
            while (end > begin + 1 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
                --end;  // never inside a multi-byte character
        }
        lines.push_back(text.substr(begin, end - begin));
        begin = end + (end < text.size() && text[end] == ' ');
    }
    return lines;
}

std::string frame(double width, double height, const std::string& title, const std::string& inside) {
    return fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">{}</svg>\n", width, height,
                       html_escaped(title), inside);
}

// 1, 2 or 5 times a power of ten, giving about five ticks.
double nice_step(double span) {
    const double rough = std::max(span, 1e-9) / 5, power = std::pow(10, std::floor(std::log10(rough)));
    return rough <= power ? power : rough <= 2 * power ? 2 * power : rough <= 5 * power ? 5 * power : 10 * power;
}

struct Axis {
    double low = 0, high = 1, from = 0, to = 1;  // value range, and its pixel range
    double at(double v) const { return from + (v - low) / (high - low) * (to - from); }
    double step() const { return nice_step(high - low); }
    double first() const { return std::ceil(low / step() - 1e-9) * step(); }
};

Axis axis_over(const std::vector<Curve>& curves, bool values, double from, double to) {
    double low = 1e300, high = -1e300;
    for (const Curve& curve : curves)
        for (const auto& [x, y] : curve.points)
            low = std::min(low, values ? y : x), high = std::max(high, values ? y : x);
    if (!(low <= high)) low = 0, high = 1;
    if (values && low > 0 && low < 0.4 * high) low = 0;
    const double pad = 0.06 * std::max(high - low, 1e-6 * std::max(std::fabs(high), 1e-3));
    return {low == 0 ? 0 : low - pad, high + pad, from, to};
}

std::string number(double v) { return fmt::format("{:.4g}", std::fabs(v) < 1e-12 ? 0.0 : v); }

}  // namespace

std::string html_escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

std::string bar_chart(const std::string& title, const std::string& hint, const std::vector<Bar>& bars) {
    double most = 1e-9;
    for (const Bar& bar : bars) most = std::max(most, bar.value);
    constexpr double kValueWidth = 52;
    std::string inside = text_at(0, 16, "start", title, "chart-title") + text_at(kWidth, 16, "end", hint, "chart-hint");
    double y = kTop;
    for (const Bar& bar : bars) {
        inside += fmt::format("<g><title>{}: {}</title>", html_escaped(bar.label), html_escaped(bar.text));
        for (const std::string& line : lines_of(bar.label, kLabelLetters))
            inside += text_at(0, y + 11, "start", line, "chart-label"), y += kLabelStep;
        const double length = std::max(1.0, (kWidth - kValueWidth) * std::max(0.0, bar.value) / most);
        inside += fmt::format("<rect class=\"bar {}\" x=\"0\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" rx=\"3\"/>",
                              bar.kind, y, length, kBarHeight);
        inside += text_at(length + 6, y + 13, "start", bar.text, "chart-value") + "</g>";
        y += kBarHeight + kBarGap;
    }
    return frame(kWidth, y, title, inside);
}

std::string line_chart(const std::string& title, const std::string& x_label, const std::string& y_label,
                       const std::vector<Curve>& curves) {
    constexpr double kHeight = 190, kLeft = 46;
    const Axis x = axis_over(curves, false, kLeft, kWidth - 8), y = axis_over(curves, true, kTop + kHeight, kTop);
    std::string inside = text_at(0, 16, "start", title, "chart-title") +
                         text_at(kWidth, 16, "end", y_label, "chart-hint");
    for (double v = y.first(); v <= y.high; v += y.step())
        inside += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>", kLeft, y.at(v), kWidth - 8) +
                  text_at(kLeft - 6, y.at(v) + 4, "end", number(v), "chart-label");
    for (double v = x.first(); v <= x.high; v += x.step())
        inside += text_at(x.at(v), kTop + kHeight + 17, "middle", number(v), "chart-label");
    inside += text_at((kLeft + kWidth) / 2, kTop + kHeight + 34, "middle", x_label, "chart-label");
    double legend_x = kLeft, legend_y = kTop + kHeight + 56;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::string path, dots;
        for (const auto& [px, py] : curves[i].points) {
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.at(px), y.at(py));
            dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"><title>{}: {} at {}</title></circle>",
                                x.at(px), y.at(py), html_escaped(curves[i].name), number(py), number(px));
        }
        const double width = 40 + 6.6 * static_cast<double>(curves[i].name.size());
        if (legend_x + width > kWidth && legend_x > kLeft) legend_x = kLeft, legend_y += 20;
        inside += fmt::format("<g class=\"curve c{}{}\"><path d=\"{}\"/>{}<path d=\"M{:.0f} {:.0f}h18\"/>", i % 6,
                              curves[i].dashed ? " dashed" : "", path, dots, legend_x, legend_y - 4);
        inside += text_at(legend_x + 24, legend_y, "start", curves[i].name, "chart-label") + "</g>";
        legend_x += width;
    }
    return frame(kWidth, legend_y + 10, title, inside);
}

}  // namespace fastscene
