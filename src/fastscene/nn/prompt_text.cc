#include "fastscene/nn/prompt_text.h"

#include <unicode/locid.h>
#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>

#include <optional>

#include "fastscene/base/check.h"
#include "fastscene/nn/html_entities.h"

namespace fastscene {
namespace {

using Text = std::u32string;

Text from_utf8(std::string_view utf8) {
    const icu::UnicodeString in = icu::UnicodeString::fromUTF8(
        icu::StringPiece(utf8.data(), static_cast<std::int32_t>(utf8.size())));
    Text out;
    for (std::int32_t i = 0; i < in.length(); i = in.moveIndex32(i, 1)) out += static_cast<char32_t>(in.char32At(i));
    return out;
}
icu::UnicodeString icu_text(const Text& text) {
    return icu::UnicodeString::fromUTF32(reinterpret_cast<const UChar32*>(text.data()),
                                         static_cast<std::int32_t>(text.size()));
}
std::string to_utf8(const icu::UnicodeString& text) {
    std::string out;
    return text.toUTF8String(out);
}

const icu::Normalizer2& normalizer(bool compatible) {
    UErrorCode code = U_ZERO_ERROR;
    const icu::Normalizer2* found = compatible ? icu::Normalizer2::getNFKCInstance(code)
                                               : icu::Normalizer2::getNFCInstance(code);
    FASTSCENE_CHECK(U_SUCCESS(code));
    return *found;
}
icu::UnicodeString normal_form(const icu::UnicodeString& text, bool compatible) {
    UErrorCode code = U_ZERO_ERROR;
    icu::UnicodeString out = normalizer(compatible).normalize(text, code);
    FASTSCENE_CHECK(U_SUCCESS(code));
    return out;
}

// Windows-1252, 0x80..0x9f; 0 = unassigned.
constexpr char32_t kWindows1252[32] = {0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                       0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017d, 0,
                                       0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                       0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

// ---- HTML entities -------------------------------------------------------------------------------------------------

constexpr std::size_t kLongestEntity = 24;

std::optional<char32_t> numeric_entity(std::string_view digits) {
    const bool hexadecimal = digits.starts_with('x') || digits.starts_with('X');
    if (hexadecimal) digits.remove_prefix(1);
    if (digits.empty()) return std::nullopt;
    char32_t value = 0;
    for (const char c : digits) {
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : 99;
        if (digit >= (hexadecimal ? 16 : 10)) return std::nullopt;
        value = value * (hexadecimal ? 16 : 10) + static_cast<char32_t>(digit);
        if (value > 0x10ffff) return std::nullopt;
    }
    if (value >= 0x80 && value < 0xa0 && kWindows1252[value - 0x80]) return kWindows1252[value - 0x80];
    if (value == 0 || (value >= 0xd800 && value < 0xe000)) return std::nullopt;
    return value;
}

Text without_entities(const Text& in) {
    Text out;
    for (std::size_t i = 0; i < in.size();) {
        std::string name;
        std::size_t end = i + 1;
        while (in[i] == '&' && end < in.size() && in[end] < 128 && in[end] != ';' && name.size() <= kLongestEntity)
            name += static_cast<char>(in[end++]);
        std::optional<char32_t> character;
        if (in[i] == '&' && end < in.size() && in[end] == ';')
            character = name.starts_with('#') ? numeric_entity(std::string_view(name).substr(1)) : html_entity(name);
        out += character ? *character : in[i];
        i = character ? end + 1 : i + 1;
    }
    return out;
}

// ---- mojibake: UTF-8 that was decoded as Windows-1252 --------------------------------------------------------------

std::optional<unsigned> windows_byte(char32_t c) {
    if (c < 0x100) return static_cast<unsigned>(c);
    for (unsigned i = 0; i < 32; ++i)
        if (kWindows1252[i] == c) return 0x80 + i;
    return std::nullopt;
}

// Byte sequences that genuine text rarely contains: accented Latin, punctuation, emoji. (A capital accented letter
// before a quotation mark, as in a French title, is left alone.)
bool likely_lead(unsigned byte) { return byte == 0xc2 || byte == 0xc3 || byte == 0xe2 || byte == 0xf0; }

Text without_mojibake(const Text& in) {
    Text out;
    for (std::size_t i = 0; i < in.size();) {
        const auto lead = windows_byte(in[i]);
        const std::size_t more = !lead || !likely_lead(*lead) ? 0 : *lead >= 0xf0 ? 3 : *lead >= 0xe0 ? 2 : 1;
        char32_t value = more == 3 ? 0 : more == 2 ? *lead & 0x0f : more == 1 ? *lead & 0x1f : 0;
        bool whole = more > 0 && i + more < in.size();
        for (std::size_t k = 1; whole && k <= more; ++k) {
            const auto next = windows_byte(in[i + k]);
            whole = next && *next >= 0x80 && *next < 0xc0;
            if (whole) value = value << 6 | (*next & 0x3f);
        }
        if (whole && more == 3) whole = value >= 0x10000;
        if (whole && more == 2) whole = value >= 0x800;
        out += whole ? value : in[i];
        i += whole ? more + 1 : 1;
    }
    return out;
}

// ---- Single characters ---------------------------------------------------------------------------------------------

std::optional<std::u32string_view> ligature(char32_t c) {
    switch (c) {
        case 0x132: return U"IJ";
        case 0x133: return U"ij";
        case 0x149: return U"\u02bcn";
        case 0x1f1: return U"DZ";
        case 0x1f2: return U"Dz";
        case 0x1f3: return U"dz";
        case 0x1c4: return U"D\u017d";
        case 0x1c5: return U"D\u017e";
        case 0x1c6: return U"d\u017e";
        case 0x1c7: return U"LJ";
        case 0x1c8: return U"Lj";
        case 0x1c9: return U"lj";
        case 0x1ca: return U"NJ";
        case 0x1cb: return U"Nj";
        case 0x1cc: return U"nj";
        case 0xfb00: return U"ff";
        case 0xfb01: return U"fi";
        case 0xfb02: return U"fl";
        case 0xfb03: return U"ffi";
        case 0xfb04: return U"ffl";
        case 0xfb05: return U"\u017ft";
        case 0xfb06: return U"st";
        default: return std::nullopt;
    }
}
bool is_single_quote(char32_t c) { return c == 0x2bc || (c >= 0x2018 && c <= 0x201b); }
bool is_double_quote(char32_t c) { return c >= 0x201c && c <= 0x201f; }
bool is_control(char32_t c) {
    return c < 9 || c == 0x0b || (c >= 0x0e && c < 0x20) || c == 0x7f || (c >= 0x206a && c <= 0x206f) || c == 0xfeff ||
           (c >= 0xfff9 && c <= 0xfffc);
}
bool is_full_or_half_width(char32_t c) { return c >= 0xff01 && c <= 0xffef; }

void append_plain(char32_t c, Text& out) {
    if (c >= 0x80 && c < 0xa0 && c != 0x85 && kWindows1252[c - 0x80]) c = kWindows1252[c - 0x80];
    if (const auto letters = ligature(c)) return void(out += *letters);
    if (c == 0x3000) return void(out += U' ');
    if (is_full_or_half_width(c))
        return void(out += from_utf8(to_utf8(normal_form(icu::UnicodeString(static_cast<UChar32>(c)), true))));
    if (is_single_quote(c)) return void(out += U'\'');
    if (is_double_quote(c)) return void(out += U'"');
    if (c == '\r' || c == 0x85 || c == 0x2028 || c == 0x2029) return void(out += U'\n');
    if (!is_control(c)) out += c;
}

// ESC [ numbers letter: terminal colors.
Text without_terminal_colors(const Text& in) {
    Text out;
    for (std::size_t i = 0; i < in.size();) {
        std::size_t end = i + 2;
        if (in[i] == 0x1b && i + 1 < in.size() && in[i + 1] == '[')
            while (end < in.size() && ((in[end] >= '0' && in[end] <= '9') || in[end] == ';')) ++end;
        const bool letter = end < in.size() && in[i] == 0x1b && in[i + 1] == '[' && in[end] < 128 &&
                            u_isalpha(static_cast<UChar32>(in[end]));
        if (letter) i = end + 1;
        else out += in[i++];
    }
    return out;
}

bool is_space(char32_t c) { return u_isUWhiteSpace(static_cast<UChar32>(c)) || (c >= 0x1c && c <= 0x1f); }

}  // namespace

std::string repaired_text(std::string_view utf8) {
    Text text = from_utf8(utf8);
    bool entities = text.find(U'<') == Text::npos;
    // Repeated until nothing changes: decoding an entity may reveal another one or mojibake. Each round shortens the
    // text or keeps its length; the limit only guards against cycles.
    for (int round = 0; round < 16; ++round) {
        const Text before = text;
        if (entities) text = without_entities(text);
        text = without_terminal_colors(without_mojibake(text));
        Text plain;
        for (const char32_t c : text) append_plain(c, plain);
        text = from_utf8(to_utf8(normal_form(icu_text(plain), false)));
        if (text == before) break;
    }
    return to_utf8(icu_text(text));
}

std::string single_spaced(std::string_view utf8) {
    Text out;
    for (const char32_t c : from_utf8(utf8)) {
        if (!is_space(c)) out += c;
        else if (!out.empty() && out.back() != U' ') out += U' ';
    }
    if (!out.empty() && out.back() == U' ') out.pop_back();
    return to_utf8(icu_text(out));
}

std::string lower_case(std::string_view utf8) {
    icu::UnicodeString text = icu::UnicodeString::fromUTF8(
        icu::StringPiece(utf8.data(), static_cast<std::int32_t>(utf8.size())));
    return to_utf8(text.toLower(icu::Locale::getRoot()));
}

}  // namespace fastscene
