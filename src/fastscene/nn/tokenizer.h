// CLIP's byte pair encoding (Radford et al. 2021): text -> ids of 49408 tokens.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace fastscene {

class ClipTokenizer {
  public:
    static constexpr int kBegin = 49406, kEnd = 49407;  // <|startoftext|>, <|endoftext|>
    static constexpr int kContext = 77;

    // `vocabulary`: bpe_simple_vocab_16e6.txt.gz as published by OpenAI, or a diffusers folder tokenizer/ (merges.txt,
    // and vocab.json, which must agree). Throws Error naming the file, expected and actual.
    explicit ClipTokenizer(const std::filesystem::path& vocabulary);

    // Tokens without begin and end, of any length.
    std::vector<int> encode(std::string_view text) const;
    // begin, tokens, end, then `pad` up to 77; longer texts are truncated before the end token.
    std::vector<int> padded(std::string_view text, int pad) const;
    // The padding token that the folder's models were trained with: 49407 (SD 1.x) or 0 (SD 2.x, CLIP itself); 49407
    // for a .gz.
    int pad() const { return pad_; }
    // Tokens that a folder's added_tokens.json adds to CLIP's (textual inversion): not supported.
    const std::vector<std::string>& unread() const { return unread_; }

  private:
    void read_merges(std::string_view lines, const std::filesystem::path& path);
    void append_word(std::string_view bytes, std::vector<int>& out) const;

    // (left, right) -> (rank, merged token). Tokens: 256 bytes, 256 bytes that end a word, then one per merge.
    std::unordered_map<std::uint64_t, std::pair<int, int>> merges_;
    int pad_ = kEnd;
    std::vector<std::string> unread_;
};

// A part of a prompt with its weight: ( ) = x1.1 each, [ ] = /1.1, (text:1.3) = x1.3, \( = a literal parenthesis.
struct WeightedText {
    std::string text;
    double weight = 1;
};
std::vector<WeightedText> parse_weights(std::string_view prompt);

// A prompt as chunks of 75 tokens, each between begin and end. `tokens`: begin, all tokens, padding, end (75 n + 2);
// chunk i consists of tokens 75 i + 1 … 75 i + 75. `weights` has 77 n entries, 1 for begin and end.
struct WeightedTokens {
    std::vector<int> tokens;
    std::vector<float> weights;
    int chunks = 1;
};
inline constexpr int kMaxChunks = 3, kChunkTokens = 75;
// Prompts padded to the same number of chunks (prompt and negative prompt share a batch). At most 225 tokens each: the
// rest is truncated, and `cut` (if given) says for which.
std::vector<WeightedTokens> weighted_tokens(const ClipTokenizer& tokenizer, const std::vector<std::string>& prompts,
                                            int pad, std::vector<bool>* cut = nullptr);

}  // namespace fastscene
