// Of several things those that are meant: "the second chair", "the larger one", "the red armchair".
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/materials.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

float to_the_right(const DocumentRoom& room, const DocumentThing& t) {
    const Vec3f looks = room.furnished.looks, d = t.position - room.furnished.camera;
    return dot(d, cross(looks, Vec3f{0, 1, 0}));
}

float volume_of(const Placed& p) { return p.piece.size_m.x * p.piece.size_m.y * p.piece.size_m.z; }

// "every second chair", "every other chair"
void every_second(const std::vector<std::string>& words, std::vector<int>& found) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const std::size_t step = words[i] != "every"                            ? 0
                                 : is_one_of(words[i + 1], {"second", "other"}) ? 2
                                 : words[i + 1] == "third"                      ? 3
                                                                                : 0;
        if (step == 0) continue;
        std::vector<int> out;
        for (std::size_t k = step - 1; k < found.size(); k += step) out.push_back(found[k]);
        found = out;
    }
}

}  // namespace

void pick(const std::vector<std::string>& words, const PromptObject& said, const Editor& editor,
          std::vector<int>& found) {
    // "The extra chairs" stand at no table.
    const auto is_apart = [&](int i) {
        const Placed& p = editor.room().furnished.placed[static_cast<std::size_t>(i)];
        return p.with < 0 && p.on < 0;
    };
    if (find_word(words, {"extra", "spare", "stray", "loose", "leftover"}) < next_place(words) &&
        std::any_of(found.begin(), found.end(), is_apart))
        std::erase_if(found, [&](int i) { return !is_apart(i); });
    static constexpr std::array<std::string_view, 5> kOrdinals{"first", "second", "third", "fourth", "fifth"};
    // "the first two chairs", "the last two chairs": the last ones are taken anyhow
    const auto several = static_cast<std::size_t>(said.counted ? std::max(1, said.count) : 1);
    if (several > 1 && several < found.size() && has_word(words, {"first"})) found.resize(several);
    if (several > 1 && has_word(words, {"first", "last"})) return;
    for (std::size_t k = 0; k < kOrdinals.size() && found.size() > 1 && !has_word(words, {"every", "each"}); ++k)
        if (has_word(words, {kOrdinals[k]}) && k < found.size()) found = {found[k]};
    every_second(words, found);
    if (found.size() < 2) return;
    if (has_word(words, {"last"})) found = {found.back()};
    const auto extreme = [&](const auto& measure, bool most) {
        const auto less = [&](int a, int b) { return measure(a) < measure(b); };
        found = {most ? *std::max_element(found.begin(), found.end(), less)
                      : *std::min_element(found.begin(), found.end(), less)};
    };
    const bool left = has_word(words, {"left", "leftmost"}), right = has_word(words, {"right", "rightmost"});
    const auto all = [&](int i) -> const DocumentThing& {
        return editor.document().things[static_cast<std::size_t>(i)];
    };
    if (left != right && several > 1 && several < found.size()) {  // "the two shelves on the right"
        std::stable_sort(found.begin(), found.end(), [&](int a, int b) {
            const float by = to_the_right(editor.room(), all(a)) - to_the_right(editor.room(), all(b));
            return right ? by > 0 : by < 0;
        });
        found.resize(several);
        std::sort(found.begin(), found.end());
    } else if (find_word(words, {"middle"}) < next_place(words) && found.size() % 2 != 0) {
        std::stable_sort(found.begin(), found.end(), [&](int a, int b) {
            return to_the_right(editor.room(), all(a)) < to_the_right(editor.room(), all(b));
        });
        found = {found[found.size() / 2]};
    } else if (has_word(words, {"biggest", "largest", "smallest", "tiniest"}))
        extreme([&](int i) { return volume_of(editor.placed(all(i).id)); }, has_word(words, {"biggest", "largest"}));
    else if (has_word(words, {"tallest", "shortest"}))
        extreme([&](int i) { return editor.placed(all(i).id).piece.size_m.y; }, has_word(words, {"tallest"}));
    else if (left != right && says_several(words, said) && !has_word(words, {"leftmost", "rightmost"})) {
        // "The chairs on the left side": of the middle between the outermost.
        const auto [low, high] = std::minmax_element(found.begin(), found.end(), [&](int a, int b) {
            return to_the_right(editor.room(), all(a)) < to_the_right(editor.room(), all(b));
        });
        const float middle = (to_the_right(editor.room(), all(*low)) + to_the_right(editor.room(), all(*high))) / 2;
        constexpr float kMiddle = 0.15f;  // metres: on neither side
        std::erase_if(found, [&](int i) {
            const float off = to_the_right(editor.room(), all(i)) - middle;
            return right ? off < kMiddle : off > -kMiddle;
        });
    } else if (left != right) extreme([&](int i) { return to_the_right(editor.room(), all(i)); }, right);
    else if (said.size == "large" && says_several(words, said) && !has_word(words, {"biggest", "largest"})) {
        float most = 0;
        for (const int i : found) most = std::max(most, volume_of(editor.placed(all(i).id)));
        std::erase_if(found, [&](int i) { return volume_of(editor.placed(all(i).id)) < 0.5f * most; });
    } else if (said.size == "small" && says_several(words, said) && !has_word(words, {"smallest", "tiniest"})) {
        float most = 0;
        for (const int i : found) most = std::max(most, volume_of(editor.placed(all(i).id)));
        std::erase_if(found, [&](int i) { return volume_of(editor.placed(all(i).id)) > 0.7f * most; });
    } else if (said.size == "large" || said.size == "small")
        extreme([&](int i) { return volume_of(editor.placed(all(i).id)); }, said.size == "large");
}

namespace {

bool has_looks(const DocumentThing& t, const PromptObject& said) {
    const auto is = [](const std::string& one, const std::string& other) {
        return plain_name(one) == plain_name(other);
    };
    return (said.color.empty() || is(t.color, said.color) || (t.asked && is(t.asked->color, said.color))) &&
           (said.material.empty() || is(t.material, said.material) ||
            (t.asked && is(t.asked->material, said.material)));
}

// The color of a thing that was made in the style's.
float difference(const Placed& p, const std::string& color) {
    const auto named = color_named(plain_name(color));
    const auto main = static_cast<std::size_t>(p.piece.main_material);
    return named && main < p.piece.materials.size() ? length(p.piece.materials[main].color_a - *named) : 0.f;
}

}  // namespace

void with_looks(const PromptObject& said, const Editor& editor, std::vector<int>& found) {
    std::vector<int> out;
    for (const int i : found)
        if (has_looks(editor.document().things[static_cast<std::size_t>(i)], said)) out.push_back(i);
    if (!out.empty() || found.size() < 2) {
        if (!out.empty()) found = out;
        return;
    }
    constexpr float kLike = 0.25f;  // of linear albedos
    const auto& all = editor.room().furnished.placed;
    const auto off = [&](int i) { return difference(all[static_cast<std::size_t>(i)], said.color); };
    std::erase_if(found, [&](int i) { return !said.color.empty() && off(i) > kLike; });
}

}  // namespace fastscene::editing
