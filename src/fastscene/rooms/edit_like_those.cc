// What comes new as those that stand there: "three more tables", "stools on the other side of the island".
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {

// "Three more tables" are tables as there are, where those are of one kind.
void as_those_there(const Editor& editor, const Words& words, PromptObject& wish) {
    const bool more = find_word(words, {"more", "another", "second", "third", "additional", "extra"}) <
                      next_place(words);
    if (wish.words.find(' ') != std::string::npos) return;
    std::set<std::string> kinds;
    // In a gym "a mat" is one of its mats.
    bool there = false;
    const std::string noun = "_" + singular(wish.words);
    for (const DocumentThing& t : editor.document().things) {
        there = there || t.kind == wish.kind;
        if (t.kind.ends_with(noun)) kinds.insert(t.kind);
    }
    if (!there && kinds.size() == 1 && ("_" + wish.kind).find(noun) == std::string::npos &&
        !has_role(wish.kind, Role::seat)) {
        wish.kind = *kinds.begin();
        return;
    }
    kinds.clear();
    const std::vector<int> found = all_named(editor, "all " + wish.words);
    for (const int i : found) kinds.insert(asked_kind(editor.room().furnished.placed[static_cast<std::size_t>(i)]));
    // Chairs where many stand are of theirs, too.
    constexpr std::size_t kMany = 4;
    const bool many = has_role(wish.kind, Role::seat) && found.size() >= kMany;
    if (kinds.size() != 1 || !(more || many)) return;
    wish.kind = *kinds.begin();
    if (!more || !is_table(wish.kind) || !wish.size.empty() || !(wish.size_m == Vec3f{})) return;
    // As large as those, where they are alike.
    constexpr float kAlike_m = 0.03f;
    const auto size_of = [&](int i) {
        return editor.room().furnished.placed[static_cast<std::size_t>(i)].piece.size_m;
    };
    if (std::all_of(found.begin(), found.end(),
                    [&](int i) { return length(size_of(i) - size_of(found.front())) < kAlike_m; }))
        wish.size_m = size_of(found.front());
}

// "Three stools on the other side of the island", where bar stools stand at it: bar stools.
void as_those_at(const Editor& editor, Addition& addition) {
    PromptObject& wish = addition.wishes.front();
    if (!addition.place || !has_role(wish.kind, Role::seat)) return;
    const std::vector<std::string> anchors = things_at(editor, addition.place->step);
    const std::string noun = "_" + singular(wish.words.substr(wish.words.rfind(' ') + 1));
    std::set<std::string> kinds;
    for (const Placed& p : editor.room().furnished.placed)
        if (p.with >= 0 && p.piece.kind.ends_with(noun) &&
            is_among(editor.room().furnished.placed[static_cast<std::size_t>(p.with)].id, anchors))
            kinds.insert(p.piece.kind);
    if (wish.words.find(' ') != std::string::npos) return;
    if (kinds.size() == 1) wish.kind = *kinds.begin();
    // Nobody sits at a bar on a low stool.
    constexpr float kBar = 0.85f, kLow = 0.55f;  // metres
    const bool high = !anchors.empty() && std::all_of(anchors.begin(), anchors.end(), [&](const std::string& id) {
        const Placed& p = editor.placed(id);
        return !p.piece.surfaces.empty() && p.piece.surfaces.front().center.y > kBar;
    });
    if (!kinds.empty() || !high || editor.usual_size(wish).y > kLow) return;
    for (const std::string& kind : kinds_with(Role::sits_before)) {
        PromptObject other = wish;
        other.kind = kind;
        if (kind.ends_with(noun) && editor.usual_size(other).y > kLow) {
            wish.kind = kind;
            return;
        }
    }
}

}  // namespace fastscene::editing
