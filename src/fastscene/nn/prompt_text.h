// Normalizes prompts to the form of CLIP's training data. CLIP's tokenizer runs every caption through ftfy; without it
// even "((best quality))" gives other tokens. This implements ftfy's rules as far as prompts need them.
#pragma once

#include <string>
#include <string_view>

namespace fastscene {

// Handles HTML entities (also doubly escaped; not in a text with "<", like ftfy), mojibake of Windows-1252, ligatures,
// full-width forms, curly quotes, line breaks, control characters, NFC. Invalid UTF-8 becomes U+FFFD.
std::string repaired_text(std::string_view utf8);

// Collapses white space to single spaces, and trims.
std::string single_spaced(std::string_view utf8);

// Lower case as Python's str.lower (final sigma, İ -> i + U+0307).
std::string lower_case(std::string_view utf8);

}  // namespace fastscene
