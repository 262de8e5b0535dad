// "the armchair to the window", "the sofa towards the tv", "put it there": things moved and turned.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// A thing's words and the words of its place.
struct Split {
    Words thing, place;
};
// Where a place may begin: at the last "to" first, then from the left.
std::vector<Split> splits_of(const Words& words) {
    std::vector<std::size_t> ends;
    // "50 cm to the left", "a bit to the left"
    const std::size_t much = next_place(words);
    if (much < words.size() && (number_said(words[much]) || words[much] == "slightly")) ends.push_back(much);
    for (std::size_t i = words.size(); i-- > 1;)
        if (is_one_of(words[i], {"to", "into", "onto"}) &&
            !is_one_of(words[i - 1],
                       {"next", "close", "over", "closer", "up", "nearer", "near", "back", "adjacent", "opposite"})) {
            ends.push_back(i);
            break;
        }
    for (std::size_t i = next_place(words); i < words.size(); i = next_place(words, i + 1)) ends.push_back(i);
    std::vector<Split> out;
    for (const std::size_t end : ends) out.push_back({part_of(words, 0, end), part_of(words, end)});
    return out;
}

// The second next to the first, or as near as they come from where they stand.
bool put_together(Talk& talk, const std::vector<std::string>& ids) {
    constexpr float kTogether = 0.35f;  // metres
    const auto off = [&] {
        const Footprint a = footprint_of(talk.editor.placed(ids[0])), b = footprint_of(talk.editor.placed(ids[1]));
        const Vec2f way = (b.center - a.center) * (1 / std::max(0.01f, length(b.center - a.center)));
        return length(b.center - a.center) - extent(a, way) - extent(b, way);
    };
    if (off() < 0.02f) throw AlreadySo(ids[1] + ": it stands there already");
    // Straight up to it, where nothing stands between them; else beside it.
    const Vec3f to = talk.editor.placed(ids[0]).position - talk.editor.placed(ids[1]).position;
    EditStep step;
    step.kind = EditStep::Kind::shift;
    step.ids = {ids[1]};
    step.by = Vec3f{to.x, 0, to.z} * ((off() - 0.01f) / std::max(0.01f, length(Vec3f{to.x, 0, to.z})));
    step.exactly = true;
    try {
        talk.editor.apply(step);
        return true;
    } catch (const Error&) {
    }
    step = {};
    step.kind = EditStep::Kind::place;
    step.wish.relation = "next to", step.wish.relation_to = talk.editor.placed(ids[0]).piece.kind;
    step.ids = {ids[1]}, step.at = {ids[0]};
    talk.editor.together([&] {
        try {
            talk.editor.apply(step);
        } catch (const AlreadySo&) {
            throw Error("{}: something stands between it and {}", ids[1], ids[0]);
        }
        if (off() > kTogether) throw Error("{}: there is no free place for it close to {}", ids[1], ids[0]);
    });
    return true;
}

// "to the left of the bed": as far as there is room, when that is not a place.
bool shifted(Talk& talk, const std::vector<std::string>& ids, const Words& place) {
    std::vector<EditStep> steps;
    if (ids.size() > 1 && is_one_of(place.back(), {"together", "apart"})) {
        Vec3f middle{};
        for (const std::string& id : ids) middle += talk.editor.placed(id).position;
        middle = middle * (1.f / static_cast<float>(ids.size()));
        constexpr float kStep = 0.4f;  // metres
        for (const std::string& id : ids) {
            Vec3f way = middle - talk.editor.placed(id).position;
            way.y = 0;
            if (!(length(way) > 0)) continue;
            EditStep step;
            step.kind = EditStep::Kind::shift;
            step.ids = {id};
            step.by = way * ((place.back() == "apart" ? -kStep : std::min(kStep, length(way) / 2)) / length(way));
            steps.push_back(step);
        }
    }
    if (text_of(place) == "together" && ids.size() == 2 && !steps.empty()) return put_together(talk, ids);
    for (const std::string& id : steps.empty() ? ids : std::vector<std::string>{})
        if (const auto step = shift_of(talk.editor, place, id)) steps.push_back(*step);
    if (steps.size() < ids.size() || steps.empty()) return false;
    do_each(talk.editor, steps.size(), [&](std::size_t k) { talk.editor.apply(steps[k]); });
    return true;
}

bool put_at(Talk& talk, const std::vector<std::string>& ids, const Words& words,
            const std::vector<std::string>& spoken) {
    // "together in the middle": the first there, the others at it
    if (ids.size() > 1 && words.size() > 1 && words.front() == "together") {
        talk.editor.together([&] {
            if (!put_at(talk, {ids.front()}, part_of(words, 1), spoken))
                throw UsageError("expected a place in the room, found \"{}\"", text_of(words, 1));
            for (std::size_t k = 1; k < ids.size(); ++k) put_together(talk, {ids[k - 1], ids[k]});
        });
        return true;
    }
    std::string why_not;
    // "closer to it"
    Words way = words;
    if (is_one_of(way.back(), {"it", "them"}) && !spoken.empty()) way.back() = spoken.front();
    try {
        if (shifted(talk, ids, way)) {
            // "Closer to the fireplace" is at it.
            try {
                const std::string kind = asked_kind(talk.editor.placed(ids.front()));
                if (const auto at = place_of(talk.editor, words, kind, ids.front(), spoken)) talk.last_place = at->step;
            } catch (const UsageError&) {
            }
            return true;
        }
    } catch (const UsageError&) {
        throw;
    } catch (const Error& e) {  // "closer to the window", with no free way there: a place at the window
        const std::size_t to = find_word(words, {"to", "window", "door"});
        if (!room_part(words, words[std::min(to, words.size() - 1)] == "to" ? to + 1 : to)) throw;
        why_not = e.what();
    }
    std::optional<Place> place;
    try {
        place = place_of(talk.editor, words, asked_kind(talk.editor.placed(ids.front())), ids.front(), spoken);
    } catch (const UsageError&) {
        if (why_not.empty()) throw;
    }
    if (!place && !why_not.empty()) throw Error("{}", why_not);
    if (!place) return false;
    const auto put_all = [&] {
        place->step.kind = EditStep::Kind::place;
        do_each(talk.editor, ids.size(), [&](std::size_t k) {
            place->step.ids = {ids[k]};
            if (!place->each_at.empty()) place->step.at = place->each_at[k % place->each_at.size()];
            EditStep step = place->step;
            // Several on both sides: one here, one there.
            if (ids.size() > 1 && step.wish.relation == "on both sides of")
                step.wish.relation = k % 2 == 0 ? "left of" : "right of";
            talk.editor.apply(step);
            // All of them at that window, where there are several.
            if (k == 0 && ids.size() > 1 && step.wish.relation == "next to" && !step.position &&
                !noun_of(step.wish.relation_to).empty())
                place->step.position = flat(talk.editor.placed(ids[k]).position);
        });
    };
    // "Move the chair to the fire and hang the mirror above it": what it was put at may be "it" as well.
    const std::vector<std::string> others = talk.last_place.wish.relation_to.empty()
                                                ? std::vector<std::string>{}
                                                : things_at(talk.editor, talk.last_place);
    try {
        put_all();
    } catch (const UsageError&) {
        throw;
    } catch (const AlreadySo&) {
        throw;
    } catch (const Error&) {
        if (!is_one_of(words.back(), {"it", "them"}) || others.empty() || others == spoken) throw;
        place = place_of(talk.editor, words, asked_kind(talk.editor.placed(ids.front())), ids.front(), others);
        if (!place) throw;
        put_all();
    }
    talk.last_place = place->step;
    return true;
}

// "Push the chairs in": up to the table at which they stand; false: they stand at none.
bool push_in(Talk& talk, const std::vector<std::string>& ids) {
    for (const std::string& id : ids) {
        const int at = talk.editor.placed(id).with;
        if (at < 0) return false;
        put_at(talk, {id}, {"to", talk.editor.document().things[static_cast<std::size_t>(at)].id}, {});
    }
    return true;
}

void move_one(Talk& talk, const std::vector<Words>& before, const Words& words) {
    std::string wrong;
    const std::vector<std::string> spoken = talk.last;
    // "the vase from the wardrobe to the desk" stands on it.
    Words all = words;
    const std::size_t from = find_word(words, {"from"}, 1);
    const bool source = from + 1 < words.size() && !is_one_of(words[from - 1], {"away", "further", "farther", "out"}) &&
                        next_place(words, from + 1) < words.size();
    if (source) all[from] = "on";
    for (const Split& split : splits_of(all)) {
        if (source && split.thing.size() <= from) continue;
        std::vector<std::string> ids;
        try {
            for (const Words& part : before) add_new(ids, talk.things(part));
            add_new(ids, talk.things(split.thing));
        } catch (const UsageError& e) {  // "the lamp" of several; "the lamp on the desk" may be one
            if (wrong.empty()) wrong = e.what();
            continue;
        }
        talk.last = ids;
        if (split.place == Words{"in"} && push_in(talk, ids)) return;
        if (put_at(talk, ids, split.place, spoken)) return;
        if (wrong.empty()) wrong = fmt::format("expected a place in the room, found \"{}\"", text_of(split.place));
    }
    if (wrong.empty())
        wrong = fmt::format("expected where to move \"{}\", for example \"to the window\"", text_of(words));
    throw UsageError("{}", wrong);
}

// "left", "by 45 degrees", "a bit", "around": radians; nothing: none of those. `end`: where the words of that begin.
std::optional<float> angle_said(const Words& words, std::size_t& end) {
    constexpr float kDegree = kPi / 180, kABit = 20;
    std::optional<float> degrees;
    float sign = 1;
    end = words.size();
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string& w = words[i];
        // "to the right a little", but "the right chair"
        const bool ends = i + 1 == words.size() || number_said(words[i + 1]) ||
                          is_one_of(words[i + 1], {"by", "slightly", "little"});
        const bool side = is_one_of(w, {"left", "right"}) && (ends || !is_definite(words[i - 1]));
        const auto number = number_said(w);
        if (is_one_of(w, {"around", "round", "backwards", "about"})) degrees = 180.f;
        else if (is_one_of(w, {"slightly", "bit", "little"})) degrees = kABit;
        else if (is_one_of(w, {"quarter"})) degrees = 90.f;
        else if (w == "half" && i + 1 < words.size() && words[i + 1] == "turn") degrees = 180.f;
        else if (is_one_of(w, {"clockwise", "right"}) && (side || w == "clockwise")) sign = -1;
        else if (is_one_of(w, {"counterclockwise", "anticlockwise"}) || side) sign = 1;
        else if (number && w != "a" && w != "an" && i + 1 < words.size() &&
                 is_one_of(words[i + 1], {"degrees", "degree", "deg"}))
            degrees = *number;
        else if (is_one_of(w, {"by", "to", "a"}) && i + 1 < words.size()) {
            // "by 45 degrees", "to the left", "a bit"
            if (!(w == "by" || is_one_of(words.back(), {"left", "right", "bit", "little", "turn"}))) continue;
        } else continue;
        end = std::min(end, i);
        if (!degrees && (side || w.ends_with("clockwise"))) degrees = 90.f;
    }
    if (!degrees) return {};
    return *degrees * sign * kDegree;
}

}  // namespace

std::vector<std::string> things_at(const Editor& editor, const EditStep& place) {
    if (!place.at.empty()) return place.at;
    std::vector<std::string> out;
    for (const DocumentThing& t : editor.document().things)
        if (t.kind == place.wish.relation_to || (t.asked && t.asked->kind == place.wish.relation_to))
            out.push_back(t.id);
    return out;
}

namespace {

void stand_at(Talk& talk, const std::vector<std::string>& ids, Vec2f at) {
    EditStep step;
    step.kind = EditStep::Kind::place;
    step.ids = ids, step.position = at;
    constexpr float kThere = 0.8f;  // metres from its middle
    talk.editor.together([&] {
        talk.editor.apply(step);
        for (const std::string& id : ids)
            if (length(flat(talk.editor.placed(id).position) - at) > kThere)
                throw Error("{}: there is no free place for it there", id);
    });
    talk.last = ids;
}

}  // namespace

std::optional<Vec2f> left_by(const Talk& talk, const std::string& id) {
    constexpr float kMoved = 0.05f;  // metres
    const auto in = [&](const RoomDocument& document) {
        return std::find_if(document.things.begin(), document.things.end(),
                            [&](const DocumentThing& t) { return t.id == id; });
    };
    const auto before = in(talk.was), now = in(talk.editor.document());
    if (before == talk.was.things.end() || now == talk.editor.document().things.end() ||
        length(now->position - before->position) < kMoved)
        return {};
    return flat(before->position);
}

// "the armchair and the plant to the window", "the vase to the desk and the lamp to the shelf"
void move(Talk& talk, const Words& words) {
    std::vector<Words> before, parts;
    for (const Words& part : parts_of(words)) {
        // "the sideboard to the left and the mirror along with it"
        const std::size_t with = find_word(part, {"with"}, 1);
        if (with + 2 != part.size() || !is_one_of(part.back(), {"it", "them"})) parts.push_back(part);
        else before.push_back(part_of(part, 0, is_one_of(part[with - 1], {"along", "together"}) ? with - 1 : with));
    }
    const auto move_part = [&](const Words& part) {
        // "in front of the fireplace, facing it"
        if (part.front() == "facing" && !talk.last.empty()) {
            Words all{"them"};
            all.insert(all.end(), part.begin(), part.end());
            return face(talk, all);
        }
        if (next_place(part) == part.size()) {
            before.push_back(part);
            return;
        }
        const std::vector<Words> first = std::exchange(before, {});
        // "in the middle of the room facing the door"
        if (const std::size_t facing = find_word(part, {"facing"}, 2);
            facing + 1 < part.size() && next_place(part) < facing) {
            move_one(talk, first, part_of(part, 0, facing));
            Words all{"them"};
            all.insert(all.end(), part.begin() + static_cast<std::ptrdiff_t>(facing), part.end());
            return face(talk, all);
        }
        move_one(talk, first, part);
    };
    do_each(
        talk.editor, parts.size(), [&](std::size_t k) { move_part(parts[k]); },
        [&](std::size_t k) { return text_of(parts[k]); });
    // "The desk to the window and the armchair in its place"
    if (const auto left = !before.empty() && talk.its_place && !talk.last.empty() ? left_by(talk, talk.last.front())
                                                                                  : std::nullopt) {
        std::vector<std::string> ids;
        for (const Words& part : before) add_new(ids, talk.things(part));
        return stand_at(talk, ids, *left);
    }
    if (!before.empty() && talk.there && (talk.last_gone || !talk.last_place.wish.relation.empty())) {
        // "remove the shelf and move the plant there"
        EditStep step = talk.last_gone ? EditStep{} : talk.last_place;
        step.kind = EditStep::Kind::place;
        step.position = talk.last_gone;
        for (const Words& part : before) {
            step.ids = talk.things(part);
            talk.editor.apply(step);
        }
        return;
    }
    if (!before.empty())
        throw UsageError("expected where to move \"{}\", for example \"to the window\"", text_of(before.front()));
}

// "the armchair around", "the sofa towards the tv", "the walls green", "the armchair into a sofa"
void turn(Talk& talk, const Words& words) {
    // "so that it stands against the wall"
    if (const std::size_t so = find_word(words, {"so"}, 1), stands = find_word(words, {"stands", "is", "hangs"}, so);
        stands + 1 < words.size()) {
        Words all = part_of(words, 0, so);
        const Words to = part_of(words, stands + 1);
        all.insert(all.end(), to.begin(), to.end());
        return move(talk, all);
    }
    // "so that it faces the door"
    const std::size_t purpose = find_word(words, {"so"}, 1);
    if (const std::size_t so = std::min(find_word(words, {"faces", "looks"}, 1),
                                        find_word(words, {"face", "look", "point"}, purpose));
        so < words.size()) {
        Words all = part_of(words, 0, so);
        // "so that the chair faces the door" is no turn of the desk.
        if (const std::size_t that = find_word(words, {"so"}, 1);
            that < so && so - that > 2 && !is_one_of(words[so - 1], {"it", "they", "that"}))
            throw UsageError("expected what is turned to face something itself, found \"{}\"", text_of(words));
        while (all.size() > 1 && is_one_of(all.back(), {"so", "that", "it", "they", "and"})) all.pop_back();
        all.push_back("facing");
        const Words to = part_of(words, so + 1);
        all.insert(all.end(), to.begin(), to.end());
        return face(talk, all);
    }
    const std::size_t towards = find_word(words, {"towards", "toward", "facing", "face"}, 1);
    std::size_t end = words.size();
    const auto angle = angle_said(words, end);
    if (towards < words.size()) return face(talk, words);
    if (find_word(words, {"upside", "over"}) < words.size())
        throw UsageError("things are turned about the vertical only, found \"{}\"", text_of(words));
    if (shine_said(talk, words)) return;
    EditStep step;
    step.kind = EditStep::Kind::turn;
    if (!angle) {
        for (std::size_t i = 1; i < words.size(); ++i)
            if (value_of(part_of(words, i))) return make(talk, words);
        if (find_word(words, {"into"}, 1) < words.size()) return make(talk, words);
        if (find_word(words, {"to"}, 1) < words.size()) return face(talk, words);
    }
    step.yaw = angle.value_or(kPi / 2);
    step.ids = talk.things_of_parts(part_of(words, 0, end));
    talk.editor.apply(step);
}

void face(Talk& talk, const Words& words) {
    std::size_t end = find_word(words, {"towards", "toward", "facing", "face"}, 1);
    if (end == words.size()) end = find_word(words, {"to", "at", "into"}, 1);
    std::size_t next = end;
    while (next < words.size() && is_one_of(words[next], {"towards", "toward", "facing", "face", "to", "at", "into"}))
        ++next;
    Words thing = part_of(words, 0, end);
    while (thing.size() > 1 && is_one_of(thing.back(), {"to", "so", "it", "around", "that", "should"}))
        thing.pop_back();
    Words target = part_of(words, next);
    if (target.empty())
        throw UsageError("expected what \"{}\" is to face, for example \"to the window\"", text_of(words));
    EditStep step;
    step.kind = EditStep::Kind::face;
    const std::vector<std::string> spoken = talk.last;
    step.ids = talk.things_of_parts(thing);
    // "The second desk to face the first"
    if (is_one_of(target.back(), {"first", "second", "third", "last"}) && !talk.noun.empty())
        target.push_back(talk.noun);
    const std::string text = text_of(target);
    if (text == "each other" || text == "one another") {
        if (step.ids.size() != 2)
            throw UsageError("expected two things that face each other, found {}", step.ids.size());
        for (const std::size_t k : {0u, 1u}) {
            EditStep one = step;
            one.ids = {step.ids[k]}, one.at = {step.ids[1 - k]};
            one.wish.relation_to = talk.editor.placed(step.ids[1 - k]).piece.kind;
            talk.editor.apply(one);
        }
        return;
    }
    const std::string noun = target.back();
    // "move it before the fire, facing it"; "move the tv to the window and turn the sofa towards it"
    const bool placed_there = spoken.empty() || spoken == step.ids;
    if (noun == "it" && placed_there && !talk.last_place.wish.relation_to.empty()) {
        step.wish.relation_to = talk.last_place.wish.relation_to;
        step.at = things_at(talk.editor, talk.last_place);
    } else if (is_one_of(noun, {"me", "us", "camera", "viewer"})) step.wish.relation_to = "viewer";
    else if (is_one_of(noun, {"room", "middle", "center", "centre", "inside"})) step.wish.relation_to = "room";
    else {
        Words at{"opposite"};
        at.insert(at.end(), target.begin(), target.end());
        const auto place = place_of(talk.editor, at, asked_kind(talk.editor.placed(step.ids.front())), step.ids.front(),
                                    spoken);
        if (!place) throw UsageError("expected a thing or an opening to face, found \"{}\"", text);
        step.wish.relation_to = place->step.wish.relation_to;
        step.at = things_at(talk.editor, place->step);
        // "The windows" of one wall are faced as that wall is.
        const bool openings = noun_of(noun) == place->step.wish.relation_to && noun.ends_with("s");
        if (const auto wall = openings ? wall_with(talk.editor.plan(), noun_of(noun)) : std::nullopt) step.wall = *wall;
        // "To the wall": that at its back, unless another one was said.
        if (noun_of(noun) == "wall") {
            step.wish.relation_to = "wall", step.wall = place->step.wall;
            if (step.wall < 0) step.wall = wall_behind(talk.editor.plan(), talk.editor.placed(step.ids.front()));
            if (step.wall < 0) throw UsageError("which wall? found \"{}\"", text);
        }
    }
    talk.editor.apply(step);
}

namespace {

// "Set the table for six": as many places as are missing; false: no such words.
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

// "the armchair by the window and a side table beside it": one stands there, the other comes new. False: all of them
// stand there, or all come new.
bool put_one_by_one(Talk& talk, const Words& words) {
    std::vector<Words> each;  // with all before it that have no place of their own
    bool open = false;
    for (const Words& part : parts_of(words)) {
        if (part.front() == "facing") return false;
        if (!open) each.emplace_back();
        else each.back().push_back("and");
        each.back().insert(each.back().end(), part.begin(), part.end());
        open = next_place(part) == part.size();
    }
    if (open && each.size() > 1) return false;
    if (std::none_of(each.begin(), each.end(), [&](const Words& w) { return begins_anew(w) != begins_anew(each[0]); }))
        return false;
    do_each(
        talk.editor, each.size(), [&](std::size_t k) { put(talk, each[k]); },
        [&](std::size_t k) { return text_of(each[k]); });
    return true;
}

}  // namespace

void put(Talk& talk, const Words& words) {
    if (const std::string lamps = lamps_said(words); !lamps.empty()) return make(talk, words);
    if (is_one_of(words.front(), {"the", "a"}) && words.size() > 1 &&
        is_one_of(words[1], {"time", "style", "weather", "hour", "light", "lighting", "color"}))
        return make(talk, words);
    // "the walls to white"
    const std::size_t to = find_word(words, {"to"}, 1);
    if (to < words.size() && value_of(part_of(words, to + 1))) return make(talk, words);
    if (const auto laid = laid_with(talk, words)) return add(talk, *laid);
    if (set_for_guests(talk, words) || put_one_by_one(talk, words)) return;
    const std::size_t end = next_place(words);
    if (is_one_of(text_of(words, end), {"on top of each other", "on each other", "on top of one another"}))
        throw UsageError("things that stand on the floor stay there: \"{}\" cannot be stacked", text_of(words, 0, end));
    const std::string thing = text_of(words, 0, end);
    const bool id = end > 1 && words[end - 1].find_first_not_of("0123456789") == std::string::npos;
    // "sofa at the window": that which is there.
    const bool bare = begins_anew(words) && !number_said(words.front()) && !thing.ends_with("s") && end < words.size();
    if (!begins_anew(words) || id || (bare && all_named(talk.editor, thing).size() == 1)) return move(talk, words);
    add(talk, words);
}

// "three lamps over the table instead of the one": of those.
Words instead_of(const Words& old, const Words& by) {
    if (!is_one_of(old.back(), {"one", "ones", "it"}) || old.size() > 3) return old;
    Words out{"the"};
    for (std::size_t i = 0; i < next_place(by) && by[i] != "instead"; ++i)
        if (!number_said(by[i]) && !is_definite(by[i])) out.push_back(by[i]);
    if (old.back() != "ones" && out.back().size() > 2 && out.back().ends_with("s")) out.back().pop_back();
    return out;
}

namespace {

// "The fridge to the counter and the plant where it was": where this sentence took it from; false: it took nothing.
bool put_where_it_was(Talk& talk, const Words& other, const Words& thing) {
    std::optional<Vec2f> at;
    try {
        at = left_by(talk, talk.things(other).front());
    } catch (const UsageError&) {  // it is gone
        at = talk.last_gone;
    }
    if (!at) return false;
    if (!begins_anew(thing)) return stand_at(talk, talk.things_of_parts(thing), *at), true;
    talk.there = true, talk.last_gone = at, talk.last_gone_from.clear();
    return add(talk, thing), true;
}

}  // namespace

// "a plant where the pouf is": in its place; "the lamp to where the plant stands": they change places.
bool put_where(Talk& talk, const Clause& clause) {
    const Words& words = clause.words;
    const std::size_t where = find_word(words, {"where"}, 1);
    if (where + 2 >= words.size() || (clause.verb != Verb::put && clause.verb != Verb::add &&
                                      clause.verb != Verb::want && clause.verb != Verb::move))
        return false;
    Words there = part_of(words, where + 1), thing = part_of(words, 0, where);
    if (there.size() > 3 && text_of(there, there.size() - 3, there.size() - 1) == "used to") {
        there.resize(there.size() - 3);
        there.push_back("was");
    }
    if (!is_one_of(there.back(),
                   {"is", "are", "stands", "stand", "hangs", "hang", "sits", "lies", "was", "were", "stood"}))
        return false;
    const bool was = is_one_of(there.back(), {"was", "were", "stood"});
    there.pop_back();
    if (thing.size() > 1 && is_one_of(thing.back(), {"to", "at"})) thing.pop_back();
    if (was && put_where_it_was(talk, there, thing)) return true;
    if (begins_anew(thing)) return replace(talk, there, thing), true;
    thing.push_back("and");
    thing.insert(thing.end(), there.begin(), there.end());
    return swap(talk, thing), true;
}

// "the desk so that it faces the window": a turn, where no place was said.
bool says_so_that(const Words& words) {
    const std::size_t so = find_word(words, {"so"}, 1);
    return so < words.size() && find_word(words, {"faces", "looks", "face", "look", "point"}, so) < words.size() &&
           next_place(part_of(words, 0, so)) == so;
}

}  // namespace fastscene::editing
