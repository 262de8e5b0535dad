#include "fastscene/nn/tokenizer.h"

#include <unicode/uchar.h>
#include <unicode/unistr.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/io/gzip.h"
#include "fastscene/nn/prompt_text.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr int kBytes = 256;
constexpr int kMerges = ClipTokenizer::kBegin - 2 * kBytes;  // 48894

// GPT-2 maps bytes to printable characters: printable Latin-1 characters map to themselves, the others to U+0100 and
// up. Tokens are ordered with printable bytes first.
struct ByteOrder {
    std::array<int, kBytes> piece_of_byte{};
    std::unordered_map<char32_t, int> piece_of_character;
    ByteOrder() {
        const auto printable = [](int b) { return (b >= 33 && b <= 126) || (b >= 161 && b <= 172) || b >= 174; };
        int piece = 0;
        for (int b = 0; b < kBytes; ++b)
            if (printable(b)) add(b, static_cast<char32_t>(b), piece++);
        char32_t stand_in = 0x100;
        for (int b = 0; b < kBytes; ++b)
            if (!printable(b)) add(b, stand_in++, piece++);
    }
    void add(int byte, char32_t character, int piece) {
        piece_of_byte[static_cast<std::size_t>(byte)] = piece;
        piece_of_character[character] = piece;
    }
};
const ByteOrder& byte_order() {
    static const ByteOrder order;
    return order;
}

std::uint64_t pair_key(int left, int right) {
    return static_cast<std::uint64_t>(left) << 32 | static_cast<std::uint32_t>(right);
}

// Word splitting of a cleaned text, by the alternatives 's 't 're 've 'm 'll 'd, letters, one digit, others.
enum class Kind { space, letter, number, other };
Kind kind_of(UChar32 c) {
    if (u_isUWhiteSpace(c)) return Kind::space;
    switch (u_charType(c)) {
        case U_UPPERCASE_LETTER:
        case U_LOWERCASE_LETTER:
        case U_TITLECASE_LETTER:
        case U_MODIFIER_LETTER:
        case U_OTHER_LETTER: return Kind::letter;
        case U_DECIMAL_DIGIT_NUMBER:
        case U_LETTER_NUMBER:
        case U_OTHER_NUMBER: return Kind::number;
        default: return Kind::other;
    }
}
std::size_t contraction(std::string_view text) {
    for (const std::string_view tail : {"'s", "'t", "'re", "'ve", "'m", "'ll", "'d"})
        if (text.starts_with(tail)) return tail.size();
    return text.starts_with("'\u017f") ? std::string_view("'\u017f").size()
                                       : 0;  // case-insensitive regexes match the long s as s
}
// Bytes of the UTF-8 character that starts here; the text is valid.
std::size_t character_bytes(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    return std::min(text.size(), lead < 0x80   ? std::size_t{1}
                                 : lead < 0xe0 ? std::size_t{2}
                                 : lead < 0xf0 ? std::size_t{3}
                                               : std::size_t{4});
}
UChar32 character_at(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<UChar32>(static_cast<unsigned char>(text[i])); };
    switch (character_bytes(text)) {
        case 1: return byte(0);
        case 2: return (byte(0) & 0x1f) << 6 | (byte(1) & 0x3f);
        case 3: return (byte(0) & 0x0f) << 12 | (byte(1) & 0x3f) << 6 | (byte(2) & 0x3f);
        default: return (byte(0) & 0x07) << 18 | (byte(1) & 0x3f) << 12 | (byte(2) & 0x3f) << 6 | (byte(3) & 0x3f);
    }
}
std::size_t word_bytes(std::string_view text) {
    if (const std::size_t n = contraction(text)) return n;
    const Kind kind = kind_of(character_at(text));
    std::size_t end = character_bytes(text);
    if (kind == Kind::number || kind == Kind::space) return end;
    while (end < text.size() && kind_of(character_at(text.substr(end))) == kind)
        end += character_bytes(text.substr(end));
    return end;
}

// The padding token that a diffusers folder names in special_tokens_map.json or tokenizer_config.json.
std::string pad_name(const fs::path& folder) {
    for (const char* name : {"special_tokens_map.json", "tokenizer_config.json"}) {
        if (!fs::exists(folder / name)) continue;
        const Json json = read_json(folder / name);
        const auto pad = json.find("pad_token");
        if (pad == json.end()) continue;
        if (pad->is_string()) return pad->get<std::string>();
        if (pad->is_object() && pad->contains("content") && (*pad)["content"].is_string())
            return (*pad)["content"].get<std::string>();
    }
    return "<|endoftext|>";
}

// Tokens of added_tokens.json that CLIP does not have.
std::vector<std::string> added_pieces(const fs::path& file) {
    std::vector<std::string> out;
    if (!fs::exists(file)) return out;
    const Json json = read_json(file);
    if (!json.is_object())
        throw Error("{}: expected an object of pieces and their numbers, found {}", file.string(), json.type_name());
    for (const auto& [piece, id] : json.items()) {
        const bool own = (piece == "<|startoftext|>" && id == ClipTokenizer::kBegin) ||
                         (piece == "<|endoftext|>" && id == ClipTokenizer::kEnd);
        if (!own) out.push_back(piece);
    }
    return out;
}

void check_vocabulary(const fs::path& file) {
    const Json json = read_json(file);
    constexpr int size = ClipTokenizer::kEnd + 1;
    const auto has = [&](const char* piece, int id) {
        const auto found = json.find(piece);
        return found != json.end() && found->is_number_integer() && found->get<int>() == id;
    };
    if (!json.is_object() || json.size() < size || !has("<|startoftext|>", ClipTokenizer::kBegin) ||
        !has("<|endoftext|>", ClipTokenizer::kEnd))
        throw Error("{}: expected CLIP's vocabulary of {} pieces, found {} and other special tokens", file.string(),
                    size, json.size());
}

}  // namespace

ClipTokenizer::ClipTokenizer(const fs::path& vocabulary) {
    if (fs::is_directory(vocabulary)) {
        const fs::path merges = vocabulary / "merges.txt";
        if (!fs::exists(merges))
            throw Error("{}: expected merges.txt in the tokenizer's folder, found none", vocabulary.string());
        read_merges(read_file(merges), merges);
        if (fs::exists(vocabulary / "vocab.json")) check_vocabulary(vocabulary / "vocab.json");
        unread_ = added_pieces(vocabulary / "added_tokens.json");
        const std::string pad = pad_name(vocabulary);
        const std::vector<int> piece = encode(pad);
        // A plain character such as "!" is the token without end-of-word, id 0.
        pad_ = pad == "<|endoftext|>"                                             ? kEnd
               : piece.size() == 1 && piece[0] >= kBytes && piece[0] < 2 * kBytes ? piece[0] - kBytes
                                                                                  : kEnd;
        return;
    }
    const std::string bytes = read_file(vocabulary);
    read_merges(bytes.starts_with("\x1f\x8b") ? inflated(bytes, vocabulary) : bytes, vocabulary);
}

void ClipTokenizer::read_merges(std::string_view lines, const fs::path& path) {
    std::unordered_map<std::string, int> piece_of_text;
    for (const auto& [character, piece] : byte_order().piece_of_character) {
        std::string text;
        icu::UnicodeString(static_cast<UChar32>(character)).toUTF8String(text);
        piece_of_text[text] = piece;
        piece_of_text[text + "</w>"] = piece + kBytes;
    }
    int rank = 0, number = 0;
    for (std::size_t at = 0; at < lines.size() && rank < kMerges;) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size());
        std::string_view line = lines.substr(at, end - at);
        at = end + 1;
        ++number;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (number == 1) {
            if (line.find("#version") == std::string_view::npos)
                throw Error("{}:1: expected a line with \"#version\" (a list of merges), found \"{}\"", path.string(),
                            line.substr(0, 60));
            continue;
        }
        const std::size_t space = line.find(' ');
        const auto left = piece_of_text.find(std::string(line.substr(0, space)));
        const auto right = space == std::string_view::npos ? piece_of_text.end()
                                                           : piece_of_text.find(std::string(line.substr(space + 1)));
        if (left == piece_of_text.end() || right == piece_of_text.end())
            throw Error("{}:{}: expected two pieces that came before, found \"{}\"", path.string(), number,
                        line.substr(0, 60));
        const int merged = 2 * kBytes + rank;
        merges_.emplace(pair_key(left->second, right->second), std::pair{rank, merged});
        piece_of_text.emplace(left->first + right->first, merged);
        ++rank;
    }
    if (rank != kMerges) throw Error("{}: expected {} merges, found {}", path.string(), kMerges, rank);
}

void ClipTokenizer::append_word(std::string_view bytes, std::vector<int>& out) const {
    std::vector<int> pieces;
    for (const char c : bytes) pieces.push_back(byte_order().piece_of_byte[static_cast<unsigned char>(c)]);
    pieces.back() += kBytes;
    while (pieces.size() > 1) {
        std::pair<int, int> best{std::numeric_limits<int>::max(), 0};
        std::uint64_t best_key = 0;
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
            const auto found = merges_.find(pair_key(pieces[i], pieces[i + 1]));
            if (found != merges_.end() && found->second < best) best = found->second, best_key = found->first;
        }
        if (best.first == std::numeric_limits<int>::max()) break;
        std::vector<int> merged;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const bool here = i + 1 < pieces.size() && pair_key(pieces[i], pieces[i + 1]) == best_key;
            merged.push_back(here ? best.second : pieces[i]);
            if (here) ++i;
        }
        pieces = std::move(merged);
    }
    out.insert(out.end(), pieces.begin(), pieces.end());
}

std::vector<int> ClipTokenizer::encode(std::string_view text) const {
    constexpr std::string_view begin = "<|startoftext|>", end = "<|endoftext|>";
    const std::string clean = lower_case(single_spaced(repaired_text(text)));
    std::vector<int> out;
    for (std::string_view rest = clean; !rest.empty();) {
        if (rest.starts_with(begin) || rest.starts_with(end)) {
            out.push_back(rest.starts_with(begin) ? kBegin : kEnd);
            rest.remove_prefix(rest.starts_with(begin) ? begin.size() : end.size());
            continue;
        }
        const std::size_t size = word_bytes(rest);
        if (kind_of(character_at(rest)) != Kind::space) append_word(rest.substr(0, size), out);
        rest.remove_prefix(size);
    }
    return out;
}

std::vector<int> ClipTokenizer::padded(std::string_view text, int pad) const {
    std::vector<int> tokens = encode(text);
    if (tokens.size() > kContext - 2) tokens.resize(kContext - 2);
    tokens.insert(tokens.begin(), kBegin);
    tokens.push_back(kEnd);
    tokens.resize(kContext, pad);
    return tokens;
}

}  // namespace fastscene
