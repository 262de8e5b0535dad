// Prompt weighting in the syntax introduced by AUTOMATIC1111's web UI, which Diffusion360 uses.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "fastscene/nn/tokenizer.h"

namespace fastscene {
namespace {

constexpr double kRound = 1.1, kSquare = 1 / 1.1;

// ":1.3)" at the start of `text`: the number and how many bytes it takes.
struct Colon {
    double weight = 1;
    std::size_t bytes = 0;
};
std::optional<Colon> colon_weight(std::string_view text) {
    if (!text.starts_with(':')) return std::nullopt;
    const std::size_t close = text.find(')');
    if (close == std::string_view::npos) return std::nullopt;
    std::string_view number = text.substr(1, close - 1);
    if (number.starts_with('+')) number.remove_prefix(1);
    if (number.starts_with("-") && text[1] == '+') return std::nullopt;
    if (number.find_first_not_of("+-.0123456789") != std::string_view::npos) return std::nullopt;
    double weight = 0;
    const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), weight);
    if (code != std::errc() || end != number.data() + number.size() || !std::isfinite(weight)) return std::nullopt;
    return Colon{weight, close + 1};
}

class Parser {
  public:
    std::vector<WeightedText> parse(std::string_view text) {
        while (!text.empty()) text.remove_prefix(take(text));
        for (const std::size_t from : round_) multiply(from, kRound);
        for (const std::size_t from : square_) multiply(from, kSquare);
        return merged();
    }

  private:
    // Consumes the next element; returns its length.
    std::size_t take(std::string_view text) {
        const char c = text[0];
        if (c == '\\') {  // escape: the next bracket or backslash is plain text; a lone backslash is dropped
            const bool escapes = text.size() > 1 && std::string_view("()[]\\").find(text[1]) != std::string_view::npos;
            out_.push_back({std::string(text.substr(1, escapes ? 1 : 0)), 1});
            return escapes ? 2 : 1;
        }
        if (c == '(' || c == '[') {
            (c == '(' ? round_ : square_).push_back(out_.size());
            return 1;
        }
        if (const auto colon = colon_weight(text)) {
            if (round_.empty()) out_.push_back({std::string(text.substr(0, colon->bytes)), 1});
            else close(round_, colon->weight);
            return colon->bytes;
        }
        if (c == ')' && !round_.empty()) return close(round_, kRound);
        if (c == ']' && !square_.empty()) return close(square_, kSquare);
        const std::size_t end = c == ')' || c == ']' || c == ':' ? 1
                                                                 : std::min(text.find_first_of("\\()[]:"), text.size());
        out_.push_back({std::string(text.substr(0, end)), 1});
        return end;
    }
    std::size_t close(std::vector<std::size_t>& open, double weight) {
        multiply(open.back(), weight);
        open.pop_back();
        return 1;
    }
    void multiply(std::size_t from, double weight) {
        for (std::size_t i = from; i < out_.size(); ++i) out_[i].weight *= weight;
    }
    std::vector<WeightedText> merged() const {
        std::vector<WeightedText> runs;
        for (const WeightedText& piece : out_) {
            if (!runs.empty() && runs.back().weight == piece.weight) runs.back().text += piece.text;
            else runs.push_back(piece);
        }
        if (runs.empty()) runs.push_back({"", 1});
        return runs;
    }
    std::vector<WeightedText> out_;
    std::vector<std::size_t> round_, square_;  // start positions of open brackets
};

}  // namespace

std::vector<WeightedText> parse_weights(std::string_view prompt) { return Parser().parse(prompt); }

std::vector<WeightedTokens> weighted_tokens(const ClipTokenizer& tokenizer, const std::vector<std::string>& prompts,
                                            int pad, std::vector<bool>* cut) {
    constexpr std::size_t limit = kMaxChunks * kChunkTokens;
    std::vector<std::vector<int>> tokens;
    std::vector<std::vector<float>> weights;
    std::size_t longest = 1;
    if (cut) cut->clear();
    for (const std::string& prompt : prompts) {
        std::vector<int> t;
        std::vector<float> w;
        for (const WeightedText& piece : parse_weights(prompt)) {
            const std::vector<int> more = tokenizer.encode(piece.text);
            t.insert(t.end(), more.begin(), more.end());
            w.resize(t.size(), static_cast<float>(piece.weight));
        }
        if (cut) cut->push_back(t.size() > limit);
        t.resize(std::min(t.size(), limit));
        w.resize(t.size());
        longest = std::max(longest, t.size());
        tokens.push_back(std::move(t));
        weights.push_back(std::move(w));
    }
    const int chunks = static_cast<int>((longest - 1) / kChunkTokens + 1);
    std::vector<WeightedTokens> out;
    for (std::size_t i = 0; i < prompts.size(); ++i) {
        WeightedTokens padded{{ClipTokenizer::kBegin}, {}, chunks};
        padded.tokens.insert(padded.tokens.end(), tokens[i].begin(), tokens[i].end());
        padded.tokens.resize(static_cast<std::size_t>(chunks * kChunkTokens + 1), pad);
        padded.tokens.push_back(ClipTokenizer::kEnd);
        padded.weights.assign(static_cast<std::size_t>(chunks * ClipTokenizer::kContext), 1.f);
        for (std::size_t k = 0; k < weights[i].size(); ++k)  // entries 0 and 76 of each chunk's 77 are begin and end
            padded.weights[k / kChunkTokens * ClipTokenizer::kContext + 1 + k % kChunkTokens] = weights[i][k];
        out.push_back(std::move(padded));
    }
    return out;
}

}  // namespace fastscene
