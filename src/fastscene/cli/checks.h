// Value checks of flags, with the wording of the fields' own check: "expected …, found …".
#pragma once

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "fastscene/base/suggest.h"

namespace fastscene::cli {

inline CLI::Validator one_of(std::vector<std::string> words) {
    return {[words = std::move(words)](std::string& text) {
                if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
                const std::string guess = nearest_word(text, words);
                return fmt::format("expected one of {}, found \"{}\"{}", fmt::join(words, ", "), text,
                                   guess.empty() ? "" : "; did you mean " + guess + "?");
            },
            ""};
}

inline CLI::Validator whole_number_within(int low, int high) {
    return {[low, high](std::string& text) {
                int value = 0;
                const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
                const bool good = code == std::errc() && end == text.data() + text.size() && value >= low &&
                                  value <= high;
                return good ? std::string()
                            : fmt::format("expected a whole number from {} to {}, found \"{}\"", low, high, text);
            },
            ""};
}

}  // namespace fastscene::cli
