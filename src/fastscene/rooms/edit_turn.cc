// "the armchair around", "the sofa towards the tv": things turned where they stand.
#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// "left", "by 45 degrees", "a bit", "around": radians; nothing: none of those. `end`: where the words of that begin.
std::optional<float> angle_said(const Words& words, std::size_t& end) {
    constexpr float kDegree = kPi / 180;
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
        else if (is_one_of(w, {"slightly", "bit", "little"})) degrees = kSlightTurn / kDegree;
        else if (is_one_of(w, {"quarter"})) degrees = 90.f;
        else if (w == "half" && i + 1 < words.size() && words[i + 1] == "turn") degrees = 180.f;
        else if (is_one_of(w, {"clockwise", "right"}) && (side || w == "clockwise")) sign = -1;
        else if (is_one_of(w, {"counterclockwise", "anticlockwise"}) || side) sign = 1;
        else if (number && w != "a" && w != "an" && i + 1 < words.size() &&
                 is_one_of(words[i + 1], {"degrees", "degree", "deg"}))
            degrees = *number;
        else if (is_one_of(w, {"by", "to", "a"}) && i + 1 < words.size()) {
            // "by 45 degrees", "to the left", "a bit"; "by the window" is a place
            if (!((w == "by" && !is_definite(words[i + 1])) ||
                  is_one_of(words.back(), {"left", "right", "bit", "little", "turn"})))
                continue;
        } else continue;
        end = std::min(end, i);
        if (!degrees && (side || w.ends_with("clockwise"))) degrees = 90.f;
    }
    if (!degrees) return {};
    return *degrees * sign * kDegree;
}

void remember_turn(Talk& talk, const EditStep& step) {
    std::erase_if(talk.turns, [&](const EditStep& earlier) { return earlier.ids == step.ids; });
    talk.turns.push_back(step);
}

}  // namespace

// "the armchair around", "the sofa towards the tv", "the walls green", "the armchair into a sofa"
void turn(Talk& talk, const Words& words) {
    // "The table into a round one with four chairs"
    if (const std::size_t into = find_word(words, {"into"}, 1); into + 2 < words.size()) return make(talk, words);
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
            that < so && so - that > 2 && !is_one_of(words[so - 1], {"it", "they", "that", "i", "we", "you", "one"}))
            throw UsageError("expected what is turned to face something itself, found \"{}\"", text_of(words));
        while (all.size() > 1 && is_one_of(all.back(), {"so", "that", "it", "they", "and", "i", "we", "you", "one"}))
            all.pop_back();
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
    for (const std::string& id : step.ids) {
        EditStep turned;
        turned.kind = EditStep::Kind::move;
        turned.ids = {id}, turned.yaw = talk.editor.placed(id).yaw;
        remember_turn(talk, turned);
    }
}

// What this sentence turned before it is moved is turned so where it came to.
void turn_as_said(Talk& talk, const std::vector<std::string>& ids) {
    for (const EditStep& step : talk.turns) {
        const std::string& id = step.ids.front();
        if (!is_among(id, ids)) continue;
        const bool so = step.yaw && std::abs(std::remainder(*step.yaw - talk.editor.placed(id).yaw, 2 * kPi)) < 0.02f;
        if (so) continue;
        try {
            talk.editor.apply(step);
        } catch (const AlreadySo&) {
        } catch (const Error& e) {
            talk.editor.note(kNotDone, fmt::format("{}: it is not turned so where it came to: {}", id, e.what()));
        }
    }
}

void face(Talk& talk, const Words& words) {
    // "The sofa to face the fire, and a table on either side of it": that comes as well.
    const std::vector<Words> all = parts_of(words);
    if (all.size() > 1 && begins_anew(all.back()) && number_said(all.back().front()) &&
        next_place(all.back()) < all.back().size()) {
        const std::size_t end = words.size() - all.back().size();
        Words first = part_of(words, 0, end);
        while (is_joint(first.back())) first.pop_back();
        return do_each(
            talk.editor, 2, [&](std::size_t k) { k == 0 ? face(talk, first) : add(talk, all.back()); },
            [&](std::size_t k) { return text_of(k == 0 ? first : all.back()); });
    }
    std::size_t end = find_word(words, {"towards", "toward", "facing", "face"}, 1);
    if (end == words.size()) end = find_word(words, {"to", "at", "into"}, 1);
    std::size_t next = end;
    while (next < words.size() && is_one_of(words[next], {"towards", "toward", "facing", "face", "to", "at", "into"}))
        ++next;
    Words thing = part_of(words, 0, end);
    // "The armchair slightly towards the window"
    bool slightly = thing.size() > 1 && thing.back() == "slightly";
    if (slightly) thing.pop_back();
    if (const std::size_t n = thing.size(); n > 3 && thing[n - 2] == "a" && is_one_of(thing[n - 1], {"bit", "little"}))
        thing.resize(n - 2), slightly = true;
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
    // "Each other across the coffee table": at both sides of that.
    if (target.size() > 3 && is_one_of(text_of(target, 0, 2), {"each other", "one another"})) {
        std::size_t across = 2;
        while (across + 1 < target.size() && !is_definite(target[across])) ++across;
        Words there = thing;
        for (const char* word : {"on", "both", "sides", "of"}) there.emplace_back(word);
        try {
            move(talk, joined_words(there, part_of(target, across)));
        } catch (const AlreadySo&) {
        }
        target.resize(2);
    }
    const std::string text = text_of(target);
    if (text == "each other" || text == "one another") {
        if (step.ids.size() != 2)
            throw UsageError("expected two things that face each other, found {}", step.ids.size());
        // Square to each other, and not far off: that is what people mean.
        const Placed a = talk.editor.placed(step.ids[0]), b = talk.editor.placed(step.ids[1]);
        const Vec3f to = b.position - a.position;
        constexpr float kOpposite = 0.98f, kAhead = 0.85f;  // cosines
        const bool opposite = dot(front_of(a.yaw), front_of(b.yaw)) < -kOpposite;
        if (opposite && dot(front_of(a.yaw), Vec3f{to.x, 0, to.z}) > kAhead * length(Vec3f{to.x, 0, to.z}))
            throw AlreadySo(fmt::format("{} and {}: they face each other already", a.id, b.id));
        talk.editor.together([&] {
            for (const std::size_t k : {0u, 1u}) {
                EditStep one = step;
                one.ids = {step.ids[k]}, one.at = {step.ids[1 - k]};
                one.wish.relation_to = talk.editor.placed(step.ids[1 - k]).piece.kind;
                try {
                    talk.editor.apply(one);
                } catch (const AlreadySo&) {  // the other one turns
                }
            }
            constexpr float kTurnedTo = -0.4f;  // cosine
            if (dot(front_of(talk.editor.placed(a.id).yaw), front_of(talk.editor.placed(b.id).yaw)) > kTurnedTo)
                throw Error("{} and {}: there is no room to turn them to each other", a.id, b.id);
        });
        return;
    }
    // "The garden", "the view" are before the window.
    if (is_one_of(target.back(), {"garden", "yard", "view", "outside", "outdoors", "sea", "ocean", "street", "sunset",
                                  "mountains", "forest", "lake", "city"}) &&
        all_named(talk.editor, text_of(target)).empty())
        target = {"the", "window"};
    const std::string noun = target.back();
    // "move it before the fire, facing it"; "move the tv to the window and turn the sofa towards it"
    const bool placed_there = spoken.empty() || spoken == step.ids;
    if (noun == "it" && placed_there && !talk.last_place.wish.relation_to.empty()) {
        step.wish.relation_to = talk.last_place.wish.relation_to;
        step.at = things_at(talk.editor, talk.last_place);
    } else if (is_one_of(noun, {"me", "us"}) || is_viewpoint(noun)) step.wish.relation_to = "viewer";
    else if (is_one_of(noun, {"room", "middle", "center", "centre", "inside"})) step.wish.relation_to = "room";
    else {
        Words at{"opposite"};
        at.insert(at.end(), target.begin(), target.end());
        const auto place = place_of(talk.editor, at, asked_kind(talk.editor.placed(step.ids.front())), step.ids.front(),
                                    spoken);
        if (!place) throw UsageError("expected a thing or an opening to face, found \"{}\"", text);
        step.wish.relation_to = place->step.wish.relation_to;
        step.at = things_at(talk.editor, place->step);
        if (step.at.size() == 1) talk.mention(step.at);
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
    step.slightly = slightly;
    talk.editor.apply(step);
    for (const std::string& id : step.ids) {
        EditStep again = step;
        again.ids = {id};
        if (!slightly) remember_turn(talk, again);
    }
}

}  // namespace fastscene::editing
