// Statistics of a data set, for `dataset stats` and the card.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/dataset/set.h"
#include "fastscene/image/image.h"

namespace fastscene::dataset {

// Ranges are counted in bins of this width; the last bin holds whatever is farther.
inline constexpr float kRangeBin_m = 0.5f;
inline constexpr int kRangeBins = 40;

// Counts of one picture, as its JSON keeps them: {"1": 8210, …} by class, and a list of bins without the empty last
// ones. `range`: +inf outside, which is in no bin.
Json class_pixels_json(const ImageMask& classes);
Json range_pixels_json(const ImageF& range);

struct Statistics {
    struct Class {
        std::string name;
        std::int64_t pixels = 0, pictures = 0, things = 0;  // `things`: visible ones, a picture each
    };
    std::int64_t pictures = 0, rooms = 0;
    std::map<std::string, std::int64_t> room_types, styles;  // rooms
    std::vector<Class> classes;                              // by number; 0: outside
    std::vector<std::int64_t> range_bins;
    std::map<std::string, std::uint64_t> bytes;  // by channel
    std::uint64_t all_bytes() const;
    std::int64_t pixels() const;
};
// Throws Error naming a picture whose JSON lacks something.
Statistics statistics_of(const DataSet& set);

Json to_json(const Statistics& statistics);
std::string to_text(const Statistics& statistics);

// "812 B", "3.2 MB".
std::string bytes_in_words(std::uint64_t bytes);

}  // namespace fastscene::dataset
