// The text of a prompt as words: checked, lower case, without accents.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

// Throws UsageError for an empty, overlong (> 2000 bytes), binary or non-UTF-8 prompt.
void check_prompt(const std::string& text);

// Lower case; Latin letters without their marks ("fußböden" -> "fussboden", "Café" -> "cafe"), Greek and Cyrillic lower
// case; typographic quotes and dashes as ASCII ones; "grey" and "colour" as "gray" and "color". Valid UTF-8 in, valid
// UTF-8 out.
std::string folded(std::string_view text);

// The words of a prompt, folded; a comma (or another mark) between phrases is a token of its own. A hyphen ends a word,
// an apostrophe joins an English ending ("don't" -> "dont"), ends other words ("l'angolo" -> "l angolo") and stays in
// "kid's"; "1.80" and "1,80" are one word, "12'" is "12", "feet".
std::vector<std::string> tokens_of(std::string_view text);

}  // namespace fastscene
