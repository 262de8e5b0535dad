// "The last row of desks", "the front two rows of chairs", "the desks in the back row".
#include <algorithm>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// Which rows, from the one in front on.
struct RowsSaid {
    Words noun;             // of what
    std::size_t count = 1;  // so many
    int first = -1;         // from this one on; -1: not said
    bool from_behind = false;
    bool all = false;
};

std::optional<RowsSaid> rows_said(const Words& words) {
    const std::size_t at = find_word(words, {"row", "rows"});
    if (at >= words.size()) return {};
    RowsSaid out;
    std::size_t from = 0;
    if (at + 2 < words.size() && words[at + 1] == "of") {
        out.noun = part_of(words, at + 2);
    } else if (at + 1 == words.size() && at > 1) {  // "the desks in the last row"
        const std::size_t in = find_word(words, {"in", "of", "from"}, 1);
        if (in >= at) return {};
        out.noun = part_of(words, 0, in), from = in;
    } else return {};
    static constexpr std::array<std::string_view, 5> kOrdinals{"first", "second", "third", "fourth", "fifth"};
    for (std::size_t i = from; i < at; ++i) {
        for (std::size_t k = 0; k < kOrdinals.size(); ++k)
            if (words[i] == kOrdinals[k]) out.first = static_cast<int>(k);
        if (words[i] == "front") out.first = 0;
        if (is_one_of(words[i], {"last", "back", "rear"})) out.first = 0, out.from_behind = true;
        if (is_one_of(words[i], {"all", "every", "each", "both"})) out.all = true;
        const auto number = is_definite(words[i]) || is_one_of(words[i], {"a", "an"}) ? std::nullopt
                                                                                      : number_said(words[i]);
        if (number) out.count = static_cast<std::size_t>(std::max(1.f, *number));
    }
    std::erase_if(out.noun, [](const std::string& w) { return is_definite(w); });
    return out;
}

// In rows across the way that all of them look, none if they look several ways; what one works at has its front towards
// who sits there.
std::vector<std::vector<int>> rows_of(const Editor& editor, std::vector<int> found) {
    constexpr float kOneWay = 0.94f;  // cosine of 20 degrees
    constexpr float kApart = 0.4f;    // metres between one row and the next
    const auto at = [&](int i) -> const Placed& { return editor.room().furnished.placed[static_cast<std::size_t>(i)]; };
    const Vec3f front = front_of(at(found.front()).yaw);
    if (std::any_of(found.begin(), found.end(), [&](int i) { return dot(front_of(at(i).yaw), front) < kOneWay; }))
        return {};
    const float sign = has_role(at(found.front()).piece.kind, Role::work_place) ? -1.f : 1.f;
    const auto ahead = [&](int i) { return sign * dot(at(i).position, front); };
    std::stable_sort(found.begin(), found.end(), [&](int a, int b) { return ahead(a) > ahead(b); });
    std::vector<std::vector<int>> out;
    for (const int i : found) {
        if (out.empty() || ahead(out.back().back()) - ahead(i) > kApart) out.emplace_back();
        out.back().push_back(i);
    }
    return out;
}

}  // namespace

std::optional<std::vector<int>> in_rows(const Editor& editor, const Words& words) {
    const auto said = rows_said(words);
    if (!said || said->noun.empty()) return {};
    std::vector<int> found = all_named(editor, "all " + text_of(said->noun));
    if (found.empty()) return {};
    std::vector<std::vector<int>> rows = rows_of(editor, found);
    if (said->all || (rows.size() == 1 && said->first < 0)) return found;
    if (rows.size() < 2 || said->first < 0)
        throw UsageError("nobody could tell which row; name them by number or place, found \"{}\"", text_of(words));
    const std::size_t first = static_cast<std::size_t>(said->first);
    if (first + said->count > rows.size())
        throw UsageError("there are only {} rows of them, found \"{}\"", rows.size(), text_of(words));
    if (said->from_behind) std::reverse(rows.begin(), rows.end());
    std::vector<int> out;
    for (std::size_t k = first; k < first + said->count; ++k) out.insert(out.end(), rows[k].begin(), rows[k].end());
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace fastscene::editing
