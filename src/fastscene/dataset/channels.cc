#include "fastscene/dataset/channels.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/suggest.h"

namespace fastscene::dataset {

std::vector<std::string> further_channels() {
    std::vector<std::string> out;
    for (const Channel& channel : kChannels)
        if (!channel.asked.empty() && std::find(out.begin(), out.end(), channel.asked) == out.end())
            out.emplace_back(channel.asked);
    return out;
}

std::vector<std::string> asked_channels(const std::string& list) {
    const std::vector<std::string> known = further_channels();
    std::vector<std::string> asked, out;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        if (std::find(known.begin(), known.end(), word) == known.end()) {
            const std::string guess = nearest_word(word, known);
            throw UsageError("--channels: expected {}, separated by commas, found \"{}\"{}", fmt::join(known, ", "),
                             word, guess.empty() ? "" : "; did you mean " + guess + "?");
        }
        asked.push_back(word);
    }
    for (const std::string& word : known)
        if (std::find(asked.begin(), asked.end(), word) != asked.end()) out.push_back(word);
    return out;
}

std::string ending_of(const Channel& channel, bool clean_film) {
    return fmt::format(".{}.{}", channel.name, channel.name == "color" && !clean_film ? "jpg" : channel.ending);
}

}  // namespace fastscene::dataset
