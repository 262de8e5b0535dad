#include "fastscene/rooms/pack_parts.h"

namespace fastscene::packs {
namespace {

void append_utf8(std::string& out, unsigned code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | (code >> 6));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xe0 | (code >> 12));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

int hex_digit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

// \uXXXX, \n and Latin-1 bytes become UTF-8.
std::string decoded(std::string_view raw) {
    std::string out;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const auto c = static_cast<unsigned char>(raw[i]);
        if (c != '\\' || i + 1 >= raw.size()) {
            append_utf8(out, c);
            continue;
        }
        const char next = raw[++i];
        if (next != 'u') {
            out += next == 't' || next == 'n' || next == 'r' ? ' ' : next;
            continue;
        }
        unsigned code = 0;
        std::size_t digits = 0;
        while (digits < 4 && i + 1 < raw.size() && hex_digit(raw[i + 1]) >= 0)
            code = code * 16 + static_cast<unsigned>(hex_digit(raw[++i])), ++digits;
        if (digits == 4 && !(code >= 0xd800 && code < 0xe000))
            append_utf8(out, code);  // half of a pair has no name we could say
    }
    return out;
}

std::string_view trimmed(std::string_view s) {
    const auto begin = s.find_first_not_of(" \t\f\r"), end = s.find_last_not_of(" \t\f\r");
    return begin == std::string_view::npos ? std::string_view{} : s.substr(begin, end - begin + 1);
}

}  // namespace

std::map<std::string, std::string> read_properties(const std::string& text) {
    std::map<std::string, std::string> out;
    std::string line;
    const auto finish = [&] {
        const std::string_view whole = trimmed(line);
        if (!whole.empty() && whole.front() != '#' && whole.front() != '!')
            if (const auto at = whole.find('='); at != std::string_view::npos)
                out[decoded(trimmed(whole.substr(0, at)))] = decoded(trimmed(whole.substr(at + 1)));
        line.clear();
    };
    std::string_view rest = text;
    while (!rest.empty()) {
        const auto end = rest.find('\n');
        std::string_view piece = trimmed(rest.substr(0, end));
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        const bool goes_on = piece.ends_with('\\') && !piece.ends_with("\\\\");
        if (goes_on) piece.remove_suffix(1);
        line += piece;
        if (!goes_on) finish();
    }
    finish();
    return out;
}

}  // namespace fastscene::packs
