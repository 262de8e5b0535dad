#include "fastscene/nn/tokenizer.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/nn/prompt_text.h"
#include "fastscene/nn/tiny_model.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

TEST(PromptText, IsRepairedAsCaptionsWere) {
    EXPECT_EQ(repaired_text("&amp;amp; caf&eacute;"), "& café");
    EXPECT_EQ(repaired_text("a < b &amp; c"), "a < b &amp; c") << "a text with < is not HTML escaped";
    EXPECT_EQ(repaired_text("donâ€™t Ã©tÃ©"), "don't été");
    EXPECT_EQ(repaired_text("ﬁne “q” ＡＢ\u3000c"), "fine \"q\" AB c");
    EXPECT_EQ(repaired_text("a\x07\x1b[31mb\r\nc"), "ab\n\nc");
    EXPECT_EQ(repaired_text("e\u0301"), "\u00e9");
    EXPECT_EQ(repaired_text("ÉTÉ à Â"), "ÉTÉ à Â") << "what only looks like mojibake stays";
    EXPECT_EQ(single_spaced("  a \t\n b\u00a0c "), "a b c");
    EXPECT_EQ(lower_case("ΣΑΣ İ"), "σας i\u0307");
}

TEST(PromptText, AnyBytesAreAnswered) {
    for (int seed = 0; seed < 200; ++seed) {
        std::string bytes;
        for (int i = 0; i < 40; ++i) bytes += static_cast<char>((seed * 131 + i * i * 17 + i) & 255);
        const std::string once = repaired_text(bytes);
        EXPECT_EQ(repaired_text(once), once) << "repairing twice changes nothing";
    }
}

std::vector<std::pair<std::string, double>> parsed(const std::string& prompt) {
    std::vector<std::pair<std::string, double>> out;
    for (const WeightedText& piece : parse_weights(prompt)) out.emplace_back(piece.text, piece.weight);
    return out;
}
using Pieces = std::vector<std::pair<std::string, double>>;

TEST(PromptWeights, BracketsNestAndNumbersMultiply) {
    EXPECT_EQ(parsed("plain"), (Pieces{{"plain", 1}}));
    EXPECT_EQ(parsed(""), (Pieces{{"", 1}}));
    EXPECT_EQ(parsed("a (b:1.3) c"), (Pieces{{"a ", 1}, {"b", 1.3}, {" c", 1}}));
    EXPECT_EQ(parsed("((x))"), (Pieces{{"x", 1.1 * 1.1}}));
    EXPECT_EQ(parsed("[x] (y"), (Pieces{{"x", 1 / 1.1}, {" ", 1}, {"y", 1.1}}));
    EXPECT_EQ(parsed("\\(x\\) ) ]"), (Pieces{{"(x) ) ]", 1}}));
    EXPECT_EQ(parsed("a:b:1.2)"), (Pieces{{"a:b:1.2)", 1}})) << "no bracket is open";
    EXPECT_EQ(parsed("(a:1.2.3)"), (Pieces{{"a:1.2.3", 1.1}})) << "that is no number";
}

class WithVocabulary : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = fs::temp_directory_path() / "fastscene_tokenizer_test";
        fs::remove_all(folder_);
        write_tiny_tokenizer(folder_);
    }
    static fs::path folder_;
};
fs::path WithVocabulary::folder_;

TEST_F(WithVocabulary, PadsAndCuts) {
    const ClipTokenizer t(folder_);
    const std::vector<int> one = t.padded("hi", 0);
    ASSERT_EQ(one.size(), 77u);
    EXPECT_EQ(one[0], ClipTokenizer::kBegin);
    EXPECT_EQ(one[1 + t.encode("hi").size()], ClipTokenizer::kEnd);
    EXPECT_EQ(one[76], 0);
    std::string words;
    for (int i = 0; i < 100; ++i) words += "1 ";
    EXPECT_EQ(t.encode(words).size(), 100u) << "each digit is a word";
    EXPECT_EQ(t.padded(words, 0)[76], ClipTokenizer::kEnd);
}

TEST_F(WithVocabulary, LongPromptsBecomeChunks) {
    const ClipTokenizer t(folder_);
    std::string words;
    for (int i = 0; i < 80; ++i) words += "1";
    std::vector<bool> cut;
    const auto both = weighted_tokens(t, {"(2:1.5)" + words, "3"}, 9, &cut);
    EXPECT_EQ(cut, (std::vector{false, false}));
    EXPECT_EQ(both[0].chunks, 2);
    EXPECT_EQ(both[1].chunks, 2) << "a prompt and its negative go through the network together";
    EXPECT_EQ(both[0].tokens.size(), 152u);
    EXPECT_EQ(both[0].weights.size(), 154u);
    EXPECT_EQ(both[0].weights[1], 1.5f);
    EXPECT_EQ(both[1].tokens[5], 9);
    EXPECT_EQ(both[1].tokens[151], ClipTokenizer::kEnd);
    for (int i = 0; i < 200; ++i) words += "1";
    EXPECT_EQ(weighted_tokens(t, {"3", words}, 9, &cut)[0].chunks, 3);
    EXPECT_EQ(cut, (std::vector{false, true}));
}

TEST_F(WithVocabulary, DamagedVocabulariesAreRefused) {
    const fs::path other = folder_ / "other";
    fs::create_directories(other);
    EXPECT_THROW(ClipTokenizer{other}, Error) << "no merges.txt";
    write_file(other / "merges.txt", "#version: 0.2\na b\n");
    EXPECT_THROW(ClipTokenizer{other}, Error) << "too few merges";
    write_file(other / "merges.txt", "#version: 0.2\nab c\n");
    EXPECT_THROW(ClipTokenizer{other}, Error) << "a piece that never was";
    fs::copy_file(folder_ / "merges.txt", other / "merges.txt", fs::copy_options::overwrite_existing);
    write_file(other / "vocab.json", "{\"a\": 0}");
    EXPECT_THROW(ClipTokenizer{other}, Error) << "another vocabulary";
}

}  // namespace
}  // namespace fastscene
