// What of a clause cannot be seen in the room that it left: looks that nothing has, things that nothing was done to,
// places where nothing stands, words that were not understood.
#include "fastscene/rooms/edit_audit_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/materials.h"

namespace fastscene::editing {

const Shown* Snapshot::find(const std::string& id) const {
    const auto found = std::find_if(things.begin(), things.end(), [&](const Shown& s) { return s.thing.id == id; });
    return found == things.end() ? nullptr : &*found;
}

Snapshot snapshot_of(const Talk& talk) {
    const Editor& editor = talk.editor;
    Snapshot out;
    out.surfaces = editor.document().surfaces, out.light = editor.document().light;
    out.style = editor.document().style;
    out.changes = editor.result().changes.size(), out.spoken = talk.last;
    const std::vector<Placed>& placed = editor.room().furnished.placed;
    for (std::size_t i = 0; i < editor.document().things.size(); ++i)
        out.things.push_back(
            {editor.document().things[i], footprint_of(placed[i]), placed[i].piece.mount, placed[i].flat});
    return out;
}

void audit(Talk& talk, const Clause& clause, const Snapshot& before) {
    constexpr Verb kUnseen[] = {Verb::remark, Verb::keep, Verb::refuse, Verb::tidy};
    if (std::find(std::begin(kUnseen), std::end(kUnseen), clause.verb) != std::end(kUnseen)) return;
    if (std::exchange(talk.vague, false)) return;
    const auto& changes = talk.editor.result().changes;
    const bool told = std::any_of(changes.begin() + static_cast<std::ptrdiff_t>(before.changes), changes.end(),
                                  [](const EditChange& c) { return c.id == kNotDone; });
    if (!told) Audit(talk, clause, before).tell();
}

}  // namespace fastscene::editing
