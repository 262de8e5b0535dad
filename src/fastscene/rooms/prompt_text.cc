#include "fastscene/rooms/prompt_text.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

constexpr std::size_t kMaxBytes = 2000;

// The byte where the text stops being UTF-8, or npos.
std::size_t first_bad_byte(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        const std::size_t length = c < 0x80                ? 1
                                   : c >= 0xc2 && c < 0xe0 ? 2
                                   : c >= 0xe0 && c < 0xf0 ? 3
                                   : c >= 0xf0 && c < 0xf5 ? 4
                                                           : 0;
        if (length == 0 || i + length > text.size()) return i;
        // Overlong forms, surrogates and what lies beyond U+10FFFF are no UTF-8 either (RFC 3629).
        const unsigned char second = length > 1 ? static_cast<unsigned char>(text[i + 1]) : 0x80;
        if ((c == 0xe0 && second < 0xa0) || (c == 0xed && second > 0x9f) || (c == 0xf0 && second < 0x90) ||
            (c == 0xf4 && second > 0x8f))
            return i;
        for (std::size_t k = 1; k < length; ++k)
            if ((static_cast<unsigned char>(text[i + k]) & 0xc0) != 0x80) return i;
        i += length;
    }
    return std::string_view::npos;
}

// One code point of valid UTF-8; `at` moves behind it.
char32_t next_code_point(std::string_view text, std::size_t& at) {
    const auto c = static_cast<unsigned char>(text[at]);
    const int more = c < 0x80 ? 0 : c < 0xe0 ? 1 : c < 0xf0 ? 2 : 3;
    char32_t code = c < 0x80 ? c : c & (0x3f >> more);
    for (int k = 1; k <= more && at + static_cast<std::size_t>(k) < text.size(); ++k)
        code = (code << 6) | (static_cast<unsigned char>(text[at + static_cast<std::size_t>(k)]) & 0x3f);
    at += static_cast<std::size_t>(more) + 1;
    return code;
}

void append_utf8(std::string& out, char32_t code) {
    const auto byte = [&](char32_t v) { out += static_cast<char>(v); };
    if (code < 0x80) byte(code);
    else if (code < 0x800) byte(0xc0 | (code >> 6)), byte(0x80 | (code & 0x3f));
    else if (code < 0x10000) byte(0xe0 | (code >> 12)), byte(0x80 | ((code >> 6) & 0x3f)), byte(0x80 | (code & 0x3f));
    else
        byte(0xf0 | (code >> 18)), byte(0x80 | ((code >> 12) & 0x3f)), byte(0x80 | ((code >> 6) & 0x3f)),
            byte(0x80 | (code & 0x3f));
}

// U+00C0 … U+017F (Latin-1 Supplement and Latin Extended-A) without their marks; '*' stands for more than one letter.
constexpr std::string_view kPlainLatin =
    "aaaaaa*ceeeeiiiidnooooo*ouuuuy**aaaaaa*ceeeeiiiidnooooo*ouuuuy*y"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiii**jjkkklllllll"
    "lllnnnnnn*nnoooooo**rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
static_assert(kPlainLatin.size() == 0x180 - 0xc0);

void append_folded(std::string& out, char32_t c) {
    if (c < 0x80) {
        out += static_cast<char>(std::tolower(static_cast<int>(c)));
    } else if (c == 0xd7) {
        out += " x ";  // "4 × 5 m"
    } else if (c == 0xb2) {
        out += '2';  // "20 m²"
    } else if (c >= 0xc0 && c < 0x180) {
        const char plain = kPlainLatin[c - 0xc0];
        if (plain != '*') out += plain;
        else if (c == 0xc6 || c == 0xe6) out += "ae";
        else if (c == 0xdf) out += "ss";
        else if (c == 0x152 || c == 0x153) out += "oe";
        else if (c == 0x132 || c == 0x133) out += "ij";
        else if (c == 0xde || c == 0xfe) out += "th";
        else out += ' ';
    } else if (c == 0x2018 || c == 0x2019 || c == 0x02bc) {
        out += '\'';
    } else if ((c >= 0x2010 && c <= 0x2015) || c == 0x2212) {
        out += '-';
    } else if ((c >= 0x201a && c <= 0x2026) || c == 0xab || c == 0xbb || (c >= 0x3001 && c <= 0x3002) ||
               (c >= 0xff01 && c <= 0xff0f)) {
        out += ',';
    } else if (c == 0xa0 || (c >= 0x2000 && c <= 0x200f) || c == 0x3000 || c == 0xfeff || (c >= 0x300 && c < 0x370)) {
        if (c < 0x300 || c >= 0x370) out += ' ';  // combining marks vanish
    } else if ((c >= 0x391 && c <= 0x3a9) || (c >= 0x410 && c <= 0x42f)) {
        append_utf8(out, c + 0x20);
    } else if (c >= 0x400 && c <= 0x40f) {
        append_utf8(out, c + 0x50);
    } else {
        append_utf8(out, c);
    }
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

bool is_english_ending(std::string_view letters) {
    constexpr std::array<std::string_view, 7> kEndings{"s", "t", "d", "m", "ll", "re", "ve"};
    return std::find(kEndings.begin(), kEndings.end(), letters) != kEndings.end();
}

}  // namespace

void check_prompt(const std::string& text) {
    if (std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) || c == 0; }))
        throw UsageError("prompt: expected a sentence such as \"a cozy bedroom with a red armchair\", found nothing");
    if (text.size() > kMaxBytes)
        throw UsageError("prompt: expected at most {} bytes, found {}", kMaxBytes, text.size());
    if (const std::size_t at = first_bad_byte(text); at != std::string_view::npos)
        throw UsageError("prompt: expected UTF-8 text, found another encoding at byte {}", at);
}

std::string folded(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) append_folded(out, next_code_point(text, at));
    replace_all(out, "grey", "gray");
    replace_all(out, "colour", "color");
    return out;
}

std::vector<std::string> tokens_of(std::string_view text) {
    const std::string plain = folded(text);
    std::vector<std::string> tokens;
    std::string word;
    const auto flush = [&] {
        if (!word.empty()) tokens.push_back(word);
        word.clear();
    };
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const auto c = static_cast<unsigned char>(plain[i]);
        const bool after_digit = i > 0 && std::isdigit(static_cast<unsigned char>(plain[i - 1])),
                   before_digit = i + 1 < plain.size() && std::isdigit(static_cast<unsigned char>(plain[i + 1]));
        if ((c == '.' || c == ',') && after_digit && before_digit) {
            word += '.';  // "1.80 m", "3,5 m"
        } else if (c == '\'' && after_digit &&
                   !(i + 1 < plain.size() && std::isalnum(static_cast<unsigned char>(plain[i + 1])))) {
            flush();
            tokens.push_back("feet");  // "12' x 14'"
        } else if (std::isalnum(c) || c >= 0x80) {
            word += static_cast<char>(c);
        } else if (c == '\'') {
            std::size_t end = i + 1;
            while (end < plain.size() && std::isalpha(static_cast<unsigned char>(plain[end]))) ++end;
            const std::string_view ending = std::string_view(plain).substr(i + 1, end - i - 1);
            if (ending == "s") word += '\'';
            else if (!is_english_ending(ending)) flush();
        } else {
            flush();
            if (std::ispunct(c) && c != '-' && c != '_' && c != '*' && c != '"') tokens.push_back(",");
        }
    }
    flush();
    return tokens;
}

}  // namespace fastscene
