// Pictures for training, validation and testing: by room, as pictures of one room resemble each other.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/dataset/set.h"

namespace fastscene::dataset {

inline constexpr std::array<std::string_view, 3> kSplits{"train", "val", "test"};

// Shares of the rooms, in the order of kSplits; they add up to 1.
using SplitShares = std::array<double, 3>;
// "0.8,0.1,0.1". Throws UsageError naming --splits for anything else.
SplitShares split_shares(const std::string& text);

// Of a room of the set with this seed: index of kSplits. It does not depend on how many rooms there are.
std::size_t split_of(std::uint64_t seed, int room, const SplitShares& shares);

// The pictures of each split, in the order of their numbers.
std::array<std::vector<const SetPicture*>, 3> split_pictures(const DataSet& set, const SplitShares& shares);

}  // namespace fastscene::dataset
