#include "fastscene/base/base64.h"

#include <array>
#include <cstdint>

namespace fastscene {
namespace {

constexpr std::string_view kBase64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64(std::string_view bytes) {
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const auto byte = [&](std::size_t k) {
            return k < left ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0u;
        };
        const std::uint32_t v = byte(0) << 16 | byte(1) << 8 | byte(2);
        out += kBase64Digits[v >> 18 & 63];
        out += kBase64Digits[v >> 12 & 63];
        out += left > 1 ? kBase64Digits[v >> 6 & 63] : '=';
        out += left > 2 ? kBase64Digits[v & 63] : '=';
    }
    return out;
}

std::optional<std::string> from_base64(std::string_view text) {
    static constexpr std::uint8_t kNone = 255;
    static const auto value_of = [] {
        std::array<std::uint8_t, 256> values;
        values.fill(kNone);
        for (std::size_t i = 0; i < kBase64Digits.size(); ++i)
            values[static_cast<unsigned char>(kBase64Digits[i])] = static_cast<std::uint8_t>(i);
        return values;
    }();
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    if (text.size() % 4 == 1) return {};
    std::string out;
    out.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint8_t value = value_of[static_cast<unsigned char>(text[i])];
        if (value == kNone) return {};
        bits = bits << 6 | value;
        // Digits 1, 2 and 3 of four complete a byte each.
        if (const std::size_t digit = i % 4; digit > 0) out += static_cast<char>(bits >> (6 - 2 * digit) & 0xff);
    }
    return out;
}

}  // namespace fastscene
