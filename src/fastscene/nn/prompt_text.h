// What people type, made into what CLIP was trained on. CLIP's own tokenizer runs every caption through ftfy; without
// that even "((best quality))" becomes other tokens. These are its rules as far as prompts need them.
#pragma once

#include <string>
#include <string_view>

namespace fastscene {

// HTML entities (also doubly escaped; not in a text with "<", as ftfy decides), UTF-8 that was read as Windows-1252,
// ligatures, full-width forms, curly quotes, line breaks, control characters, NFC. Bytes that are not UTF-8 become
// U+FFFD.
std::string repaired_text(std::string_view utf8);

// Runs of white space become one space, none at the ends.
std::string single_spaced(std::string_view utf8);

// Lower case as Python's str.lower (final sigma, İ -> i + U+0307).
std::string lower_case(std::string_view utf8);

}  // namespace fastscene
