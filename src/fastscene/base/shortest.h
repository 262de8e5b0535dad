// Floats in JSON, whose numbers are doubles: 0.42 instead of 0.41999998688697815.
#pragma once

#include <charconv>

namespace fastscene {

// The double nearest to the shortest decimal that reads back as this float. Converts back to the same float, bit by
// bit.
inline double shortest(float value) {
    char text[32];
    const auto [end, code] = std::to_chars(text, text + sizeof text, value);
    double out = 0;
    if (code != std::errc() || std::from_chars(text, end, out).ec != std::errc()) return static_cast<double>(value);
    return static_cast<float>(out) == value ? out : static_cast<double>(value);
}

}  // namespace fastscene
