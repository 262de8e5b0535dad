#include "fastscene/nn/egformer_tables.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace fastscene {
namespace {

// Python's % on doubles: the result has the sign of the divisor.
double floored_modulo(double value, double divisor) {
    const double rest = std::fmod(value, divisor);
    return rest < 0 ? rest + divisor : rest;
}

// The end point is included: the last token is a full span after the first, as published.
std::vector<float> chord_table(int count, double span) {
    std::vector<float> angle(static_cast<std::size_t>(count));
    const float step = count > 1 ? static_cast<float>(count) / static_cast<float>(count - 1) : 0.f;
    for (int i = 0; i < count; ++i)
        angle[static_cast<std::size_t>(i)] = static_cast<float>(i) * step * static_cast<float>(span / count);
    std::vector<float> table;
    table.reserve(angle.size() * angle.size());
    for (const float from : angle)
        for (const float to : angle) {
            // In single precision, as published: 1 - cos loses precision near the diagonal, and the weights were
            // trained with that.
            const float turn = to - from;
            const float chord = std::sqrt(2.f * (1.f - std::cos(turn)));
            table.push_back(turn > 0 ? chord : -chord);
        }
    return table;
}

}  // namespace

std::vector<float> tangent_patch_table(int height, int width) {
    // The patch in the tangent plane (gnomonic projection), with the pixel spacing of the equator.
    double right[3], down[3];
    for (int r = -1; r <= 1; ++r) {
        right[r + 1] = std::tan(r * 2 * std::numbers::pi / width);
        down[r + 1] = std::tan(r * std::numbers::pi / height) / std::cos(r * 2 * std::numbers::pi / width);
    }
    std::vector<float> table;
    table.reserve(static_cast<std::size_t>(height) * static_cast<std::size_t>(width) * 18);
    for (int i = 0; i < height; ++i) {
        const double lat0 = (static_cast<double>(i) / height - 0.5) * std::numbers::pi;
        for (int j = 0; j < width; ++j) {
            const double lon0 = (static_cast<double>(j) / width - 0.5) * 2 * std::numbers::pi;
            for (int tap = 0; tap < 9; ++tap) {
                const double x = right[tap % 3], y = down[tap / 3];
                const double rho = tap == 4 ? 1e-8 : std::sqrt(x * x + y * y);
                const double nu = std::atan(rho);
                const double lat = std::asin(std::cos(nu) * std::sin(lat0) + y * std::sin(nu) * std::cos(lat0) / rho);
                // atan instead of atan2: beyond a pole the tap stays on this side. As published; the weights depend on
                // it.
                const double lon = std::atan(
                                       x * std::sin(nu) /
                                       (rho * std::cos(lat0) * std::cos(nu) - y * std::sin(lat0) * std::sin(nu))) +
                                   lon0;
                table.push_back(static_cast<float>((lat / std::numbers::pi + 0.5) * height));
                table.push_back(
                    static_cast<float>(floored_modulo((lon / (2 * std::numbers::pi) + 0.5) * width, width)));
            }
        }
    }
    return table;
}

std::vector<float> vertical_chord_table(int count) { return chord_table(count, std::numbers::pi); }
std::vector<float> horizontal_chord_table(int count) { return chord_table(count, 2 * std::numbers::pi); }

}  // namespace fastscene
