#include "fastscene/dataset/split.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/random.h"

namespace fastscene::dataset {

SplitShares split_shares(const std::string& text) {
    SplitShares shares{};
    double sum = 0;
    std::size_t count = 0;
    bool is_good = true;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        double share = 0;
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), share);
        is_good = is_good && code == std::errc() && end == word.data() + word.size() && share >= 0 && share <= 1;
        if (count < shares.size()) shares[count] = share;
        sum += share;
        ++count;
    }
    if (!is_good || count != shares.size() || std::abs(sum - 1) > 1e-6)
        throw UsageError(
            "--splits: expected shares of train, val and test that add up to 1, as in 0.8,0.1,0.1; found "
            "\"{}\"",
            text);
    return shares;
}

std::size_t split_of(std::uint64_t seed, int room, const SplitShares& shares) {
    const double at = static_cast<double>(Random(seed, "dataset split", static_cast<std::uint64_t>(room)).next_u64() >>
                                          11) *
                      0x1p-53;
    return at < shares[0] ? 0 : at < shares[0] + shares[1] || shares[2] == 0 ? 1 : 2;
}

std::array<std::vector<const SetPicture*>, 3> split_pictures(const DataSet& set, const SplitShares& shares) {
    std::array<std::vector<const SetPicture*>, 3> out;
    for (const SetPicture& picture : set.pictures())
        out[split_of(set.made().seed, picture.room, shares)].push_back(&picture);
    return out;
}

}  // namespace fastscene::dataset
