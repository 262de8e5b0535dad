#include "fastscene/base/suggest.h"

#include <algorithm>
#include <cstddef>

namespace fastscene {
namespace {

// Damerau-Levenshtein distance: insertions, deletions, substitutions and transpositions of adjacent letters.
std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                least[i][j] = i + j;
                continue;
            }
            least[i][j] = std::min(
                {least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
        }
    return least[a.size()][b.size()];
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    // Up to a third of the letters may be wrong; beyond that a guess is noise. A missing prefix ("--width" for
    // "--panorama-width") counts as near, too.
    std::size_t least = word.size() / 3 + 1;
    const std::string tail = word.starts_with("--") ? word.substr(1) : word;
    for (const std::string& candidate : known) {
        const std::size_t distance = candidate.ends_with(tail) && tail.size() > 3 ? 1 : edits(word, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace fastscene
