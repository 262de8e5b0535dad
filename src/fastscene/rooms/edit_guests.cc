// For how many people: "set the table for six", "so that eight people can sit".
#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene::editing {
namespace {

bool is_people(const std::string& word) {
    return is_one_of(word, {"people", "persons", "guests", "diners", "seats", "friends", "visitors", "of", "us"});
}

// The table that is meant, or the room's main one.
std::string table_meant(Talk& talk, const Words& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (!is_definite(words[i])) continue;
        std::size_t end = i + 1;
        while (end < words.size() && !is_joint(words[end]) && next_place(words, end) != end &&
               !is_one_of(words[end], {"so", "for", "to", "can"}))
            ++end;
        for (const int k : all_named(talk.editor, text_of(words, i, end)))
            if (const Placed& p = talk.editor.room().furnished.placed[static_cast<std::size_t>(k)];
                is_sat_at(p.piece.kind))
                return p.id;
    }
    for (const std::string& id : talk.last)
        if (is_sat_at(talk.editor.placed(id).piece.kind)) return id;
    std::string best;
    float most = 0;
    for (const Placed& p : talk.editor.room().furnished.placed) {
        const std::vector<int> seats = talk.editor.seats_at(talk.editor.index_of(p.id));
        const float size = p.piece.size_m.x * p.piece.size_m.z + static_cast<float>(seats.size());
        if (is_sat_at(p.piece.kind) && !has_role(p.piece.kind, Role::work_place) && size > most)
            most = size, best = p.id;
    }
    if (best.empty()) throw UsageError("there is no table in the room at which people could sit");
    return best;
}

}  // namespace

bool set_for_guests(Talk& talk, const Words& words) {
    const std::size_t at = find_word(words, {"for"}, 1);
    if (talk.said != "set" || at + 1 >= words.size() || !is_definite(words.front())) return false;
    const auto guests = number_said(words[at + 1]);
    if (!guests || *guests < 1) return false;
    const std::string table = talk.things(part_of(words, 0, at)).front();
    int missing = static_cast<int>(*guests);
    for (const DocumentThing& t : talk.editor.document().things)
        if (t.on == table && in_words(t.kind) == "place setting") --missing;
    if (missing < 1) throw Error("{}: it is set for as many already", table);
    add(talk, {std::to_string(missing), "place", missing > 1 ? "settings" : "setting", "on", table});
    return true;
}

int guests_said(const Words& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const auto number = is_one_of(words[i], {"a", "an", "one", "half", "quarter"}) ? std::nullopt
                                                                                       : number_said(words[i]);
        if (!number || *number < 2) continue;
        const bool sit = find_word(words, {"sit", "seat", "seated", "seats", "eat", "dine", "fit", "room", "space"}) <
                         words.size();
        // "So that eight people can sit", "so eight can eat there", "seating for eight"
        const bool people = is_people(words[i + 1]) || is_one_of(words[i + 1], {"can", "could", "may", "fit", "sit"});
        if (sit && people) return static_cast<int>(*number);
    }
    const std::size_t n = words.size();
    // "The table seat six"
    if (n > 2 && is_one_of(words[n - 2], {"seat", "seats", "fit", "fits", "sit"}))
        if (const auto number = number_said(words[n - 1]); number && *number >= 2) return static_cast<int>(*number);
    const std::size_t last = n > 0 && is_people(words[n - 1]) ? n - 1 : n;
    if (last < 2 || words[last - 2] != "for") return 0;
    const auto number = number_said(words[last - 1]);
    const bool seats = has_word(words, {"seating", "seats", "room", "space", "chairs"});
    return seats && number && *number >= 2 ? static_cast<int>(*number) : 0;
}

void seat_guests(Talk& talk, const Words& words, int guests) {
    const std::string table = table_meant(talk, words);
    const std::vector<int> seats = talk.editor.seats_at(talk.editor.index_of(table));
    const int there = static_cast<int>(seats.size());
    const std::string kind = seats.empty()
                                 ? ""
                                 : asked_kind(
                                       talk.editor.room().furnished.placed[static_cast<std::size_t>(seats.back())]);
    if (there >= guests) throw AlreadySo(fmt::format("{}: {} people can sit there already", table, there));
    EditStep step;
    step.kind = EditStep::Kind::add;
    const auto chair = look_up("dining chair");
    step.wish.kind = !kind.empty() ? kind : chair ? chair->meaning : "";
    step.wish.words = in_words(step.wish.kind);
    step.wish.count = guests - there, step.wish.counted = true;
    step.wish.relation = "around", step.wish.relation_to = asked_kind(talk.editor.placed(table));
    step.at = {table};
    talk.editor.apply(step);
    talk.last = {table};
}

}  // namespace fastscene::editing
