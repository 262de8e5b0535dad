// What goes: "the rug and two plants", "everything but the sofa", "all but one chair", what stands on a table.
#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene::editing {
namespace {

// "everything on the table": what stands on it.
std::vector<std::string> riders_of(const Editor& editor, const std::vector<std::string>& ids) {
    std::vector<std::string> out;
    for (const DocumentThing& t : editor.document().things)
        if (std::find(ids.begin(), ids.end(), t.on) != ids.end()) out.push_back(t.id);
    return out;
}

}  // namespace

void remove_all(Talk& talk, const std::vector<std::string>& ids) {
    if (!ids.empty()) {
        const Placed& first = talk.editor.placed(ids.front());
        talk.last_gone = flat(first.position), talk.last_gone_yaw = first.yaw;
        talk.last_gone_from = first.on < 0 ? ""
                                           : talk.editor.room().furnished.placed[static_cast<std::size_t>(first.on)].id;
        if (std::find(ids.begin(), ids.end(), talk.last_gone_from) != ids.end()) talk.last_gone_from.clear();
    }
    EditStep step;
    step.ids = ids;
    talk.editor.apply(step);
    std::erase_if(talk.last, [&](const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); });
}

bool says_all_but_some(const Words& words) {
    const std::size_t but = find_word(words, {"except", "but"});
    return but == 1 && words.front() == "all" && words.size() > 3 && !is_one_of(words[2], {"a", "an"}) &&
           number_said(words[2]) && next_place(part_of(words, 2)) == words.size() - 2;
}

void clear(Talk& talk, const Words& words) {
    // "The island except for the vase"
    if (const std::size_t but = find_word(words, {"except", "but", "besides", "excluding"}, 1);
        but + 1 < words.size()) {
        Words all = joined_words({"everything", "on"}, words);
        all[but + 2] = "except";
        remove_everything(talk, all);
        return;
    }
    const auto tops = talk.things_of_parts(words);
    const auto riders = riders_of(talk.editor, tops);
    if (riders.empty()) throw UsageError("nothing stands on {}", tops.front());
    remove_all(talk, riders);
    talk.last = tops;  // "clear the table and make it white"
}

bool is_among(const std::string& id, const std::vector<std::string>& ids) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

std::optional<std::vector<std::string>> all_that_stands_on(Talk& talk, const Words& words) {
    if (words.size() < 3 || !is_one_of(words.front(), {"whatever", "what", "what's", "everything", "anything", "all"}))
        return {};
    std::size_t next = 1;
    while (next + 1 < words.size() && is_one_of(words[next], {"that", "that's", "which", "is", "are", "stands", "stand",
                                                              "lies", "sits", "s", "the", "things", "stuff"}))
        ++next;
    if (!is_one_of(words[next], {"on", "off", "from"}) || next + 1 == words.size()) return {};
    const auto tops = talk.things(part_of(words, next + 1));
    auto riders = riders_of(talk.editor, tops);
    if (riders.empty()) throw UsageError("nothing stands on {}", tops.front());
    return riders;
}

bool remove_everything(Talk& talk, const Words& words) {
    std::size_t next = 1;
    if (words.size() > 2 && words[0] == "all" && words[1] == "the" && is_one_of(words[2], {"things", "stuff"}))
        next = 3;
    else if (words.size() > 1 && is_one_of(words[0], {"all", "the"}) && is_one_of(words[1], {"things", "stuff"}))
        next = 2;
    else if (words.size() > 1 && words[0] == "the" &&
             is_one_of(words[1], {"clutter", "mess", "objects", "items", "decoration", "decorations"}))
        next = 2;
    else if (!is_one_of(words.front(), {"everything", "anything", "all"})) return false;
    if (words.size() > next + 1 && words[next] == "else") ++next;
    while (words.size() > next + 1 && is_one_of(words[next], {"that", "which", "stands", "stand", "is", "are", "lies"}))
        ++next;
    // "… and the candles on the shelf" go by themselves.
    if (const std::vector<Words> parts = parts_of(words);
        parts.size() > 1 && is_one_of(words[next], {"on", "from", "off"}) && next_place(parts[1]) < parts[1].size())
        return false;
    const Words rest = part_of(words, next);
    if (rest.empty()) {
        std::vector<std::string> ids;
        for (const DocumentThing& t : talk.editor.document().things) ids.push_back(t.id);
        remove_all(talk, ids);
        return true;
    }
    // "everything off the table except the vase"
    if (const std::size_t but = find_word(rest, {"except", "but", "besides"}, 2);
        is_one_of(rest.front(), {"on", "from", "off"}) && but + 1 < rest.size()) {
        const auto tops = talk.things_of_parts(part_of(rest, 1, but));
        std::vector<std::string> riders = riders_of(talk.editor, tops);
        // Of several vases, the one that stands there.
        std::vector<std::string> kept;
        for (const Words& part : parts_of(part_of(rest, but + (rest[but + 1] == "for" ? 2 : 1)))) {
            std::vector<std::string> there;
            for (const int i : all_named(talk.editor, text_of(part)))
                if (const std::string& id = talk.editor.document().things[static_cast<std::size_t>(i)].id;
                    is_among(id, riders))
                    there.push_back(id);
            add_new(kept, there.empty() ? talk.things(part) : there);
        }
        std::erase_if(riders,
                      [&](const std::string& id) { return std::find(kept.begin(), kept.end(), id) != kept.end(); });
        if (riders.empty()) throw UsageError("nothing else stands on {}", tops.front());
        remove_all(talk, riders);
        talk.last = tops;
        return true;
    }
    if (is_one_of(rest.front(), {"on", "from", "off"})) return clear(talk, part_of(rest, 1)), true;
    const std::size_t than = rest.size() > 1 && rest[1] == "than" ? 2 : rest.size() > 1 && rest[1] == "for" ? 2 : 1;
    if (!is_one_of(rest.front(), {"but", "except", "besides", "excluding", "other", "apart"})) return false;
    if (says_all_but_some(words)) return false;
    std::vector<std::string> kept = talk.things_of_parts(part_of(rest, than));
    // What carries it stays as well, and what stands on it.
    for (std::size_t k = 0; k < kept.size(); ++k)
        for (const DocumentThing& t : talk.editor.document().things)
            if (t.id == kept[k] && !t.on.empty()) add_new(kept, {t.on});
    add_new(kept, riders_of(talk.editor, kept));
    std::vector<std::string> ids;
    for (const DocumentThing& t : talk.editor.document().things)
        if (std::find(kept.begin(), kept.end(), t.id) == kept.end()) ids.push_back(t.id);
    remove_all(talk, ids);
    return true;
}

Words with_its(const Words& words) {
    Words out;
    const auto is_seats = [](const std::string& word) {
        const auto known = look_up(word);
        return known && known->kind == WordKind::object && has_role(known->meaning, Role::seat);
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool joint = words[i] == "with" && i + 1 < words.size() && i > 0;
        // "with all its chairs", "with all of the chairs"
        std::size_t next = i + 1;
        while (joint && next + 1 < words.size() && is_one_of(words[next], {"all", "both", "of"})) ++next;
        const bool its = joint && is_one_of(words[next], {"its", "their"});
        const bool seats = joint && next + 1 < words.size() && words[next] == "the" && words[next + 1].ends_with("s") &&
                           is_seats(words[next + 1]);
        if (its || seats) {
            if (is_one_of(out.back(), {"together", "along"})) out.pop_back();
            out.push_back(","), out.push_back("its");
            i = next;
            continue;
        }
        // "The back row of tables and chairs"
        if (words[i] == "and" && i + 2 == words.size() && is_seats(words[i + 1]) && has_word(out, {"row", "rows"})) {
            out.push_back(","), out.push_back("its");
            continue;
        }
        const bool together = i > 0 && is_one_of(words[i - 1], {"together", "along"});
        if (joint && together) out.back() = ",";
        else out.push_back(words[i]);
    }
    return out;
}

// "the rug and the two plants", "the vase off the table"
void remove(Talk& talk, Words words) {
    while (!words.empty() && is_one_of(words.back(), {"away", "out", "off"})) words.pop_back();
    while (!words.empty() && is_one_of(words.front(), {"away", "out", "rid", "of"})) words.erase(words.begin());
    if (words.empty()) throw UsageError("expected what to remove, found the end of the sentence");
    if (remove_everything(talk, words)) return;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (is_one_of(words[i], {"off", "from"}) && !is_one_of(words[i - 1], {"farthest", "furthest", "away"}))
            words[i] = "on";
    // Of "the rug and the piano" the rug, where there is no piano.
    const std::vector<Words> parts = parts_of(with_its(words));
    std::vector<std::string> ids;
    do_each(talk.editor, parts.size() + 1, [&](std::size_t k) {
        if (k < parts.size()) {
            if (k > 0) talk.last = ids;  // "its chairs" are those of what goes
            return add_new(ids, talk.things(parts[k]));
        }
        talk.last = ids;
        if (!ids.empty()) remove_all(talk, ids);
    });
}

}  // namespace fastscene::editing
