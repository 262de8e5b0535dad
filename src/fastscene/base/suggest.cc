#include "fastscene/base/suggest.h"

#include <algorithm>
#include <cstddef>

namespace fastscene {
namespace {

// Levenshtein's distance: letters inserted, removed or changed.
std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
            diagonal = above;
        }
    }
    return row[b.size()];
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    // A third of the letters may be wrong; beyond that a guess is noise. A word that only lacks its prefix
    // ("--width" for "--panorama-width") is near too.
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
