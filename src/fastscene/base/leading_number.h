// Numbers in text, in the notation of C whatever the locale: std::stod and strtod read "1.5" as 1 in a program that
// called setlocale for a language with decimal commas.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace fastscene {

// The number that `text` begins with, after blanks; `text` is then what follows it. None: there is no number, or no
// double holds it.
inline std::optional<double> leading_number(std::string_view& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    std::string_view rest = text.substr(begin);
    if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (code != std::errc()) return {};
    text = rest.substr(static_cast<std::size_t>(end - rest.data()));
    return value;
}

// The same where nothing else matters.
inline std::optional<double> number_in(std::string_view text) { return leading_number(text); }

}  // namespace fastscene
