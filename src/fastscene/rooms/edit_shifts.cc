// "50 cm to the left", "a bit closer to the window", "away from the wall": by how much things are moved.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene::editing {
namespace {

constexpr float kUsual = 0.5f, kABit = 0.25f;  // metres

struct Unit {
    std::string_view word;
    float metres;
};
constexpr std::array<Unit, 13> kUnits{{{"cm", 0.01f},
                                       {"centimeter", 0.01f},
                                       {"centimeters", 0.01f},
                                       {"centimetre", 0.01f},
                                       {"centimetres", 0.01f},
                                       {"m", 1},
                                       {"meter", 1},
                                       {"meters", 1},
                                       {"metre", 1},
                                       {"metres", 1},
                                       {"foot", 0.305f},
                                       {"feet", 0.305f},
                                       {"inches", 0.0254f}}};

// Towards a thing or an opening from where something stands; nothing: there is none.
std::optional<Vec3f> way_to(const Editor& editor, const Words& words, const Placed& from) {
    const Vec2f here = footprint_of(from).center;
    std::optional<Vec2f> there;
    const auto take = [&](Vec2f at) {
        if (!there || length(at - here) < length(*there - here)) there = at;
    };
    Words bare = words;
    std::erase_if(bare, [](const std::string& w) { return is_definite(w) || w == "a"; });
    const auto word = look_up(text_of(bare));
    const bool part = word && word->kind == WordKind::structure;
    const Plan& plan = editor.plan();
    if (part && word->meaning == "wall")
        for (int w = 0; w < 4; ++w) {
            const WallFace face = plan.wall(w);
            take(here - flat(face.inward) * dot(here - flat(face.origin), flat(face.inward)));
        }
    for (const Opening& o : plan.openings)
        if (part && is_opening_of(o, word->meaning)) take(flat(plan.wall(o.wall).point((o.u0 + o.u1) / 2, 0)));
    if (!part)
        for (const int i : all_named(editor, text_of(words)))
            take(footprint_of(editor.room().furnished.placed[static_cast<std::size_t>(i)]).center);
    if (!there || !(length(*there - here) > 0.05f)) return {};
    const Vec2f way = *there - here;
    return Vec3f{way.x, 0, way.y} / length(way);
}

// The direction that words say, seen from the camera, or of a thing's own front.
std::optional<Vec3f> direction_of(const Editor& editor, Words words, const Placed& from) {
    std::erase_if(words, [](const std::string& w) { return w == "by"; });
    const Vec3f ahead = editor.room().furnished.looks, right = cross(ahead, Vec3f{0, 1, 0});
    const std::string text = text_of(words);
    if (is_one_of(text, {"left", "to the left", "to left", "leftwards"})) return right * -1.f;
    if (is_one_of(text, {"right", "to the right", "to right", "rightwards"})) return right;
    if (is_one_of(text, {"forward", "forwards", "to the front", "out"})) return front_of(from.yaw);
    if (is_one_of(text, {"back", "backward", "backwards", "to the back"})) return front_of(from.yaw) * -1.f;
    if (is_one_of(text, {"up", "higher", "upwards", "higher up"})) return Vec3f{0, 1, 0};
    if (is_one_of(text, {"down", "lower", "downwards", "lower down"})) return Vec3f{0, -1, 0};
    struct Way {
        std::string_view words;
        float sign;
    };
    static constexpr std::array<Way, 14> kWays{{{"closer to ", 1},
                                                {"nearer to ", 1},
                                                {"nearer ", 1},
                                                {"towards ", 1},
                                                {"toward ", 1},
                                                {"to ", 1},
                                                {"away from ", -1},
                                                {"further away from ", -1},
                                                {"farther away from ", -1},
                                                {"further from ", -1},
                                                {"farther from ", -1},
                                                {"off ", -1},
                                                {"from ", -1},
                                                {"out from ", -1}}};
    for (const Way& way : kWays)
        if (text.starts_with(way.words)) {
            const std::size_t skip = static_cast<std::size_t>(std::count(way.words.begin(), way.words.end(), ' '));
            const auto to = way_to(editor, part_of(words, skip), from);
            return to ? std::optional(*to * way.sign) : std::nullopt;
        }
    return {};
}

}  // namespace

std::optional<float> take_length(Words& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const auto number = number_said(words[i]);
        if (!number) continue;
        std::size_t at = i + 1;
        if (is_one_of(words[at], {"a", "of"}) && at + 1 < words.size()) ++at;
        const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                       [&](const Unit& u) { return u.word == words[at]; });
        if (unit == kUnits.end()) continue;
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                    words.begin() + static_cast<std::ptrdiff_t>(at) + 1);
        return *number * unit->metres;
    }
    return {};
}

std::optional<EditStep> shift_of(const Editor& editor, const Words& words, const std::string& id) {
    Words rest = words;
    const auto metres = take_length(rest);
    bool a_bit = false;
    std::erase_if(rest, [&](const std::string& w) {
        const bool little = is_one_of(w, {"bit", "little", "slightly", "somewhat"});
        a_bit = a_bit || little;
        return little || w == "a" || w == "much";
    });
    // "to the window" is a place, unless it was said how far.
    if (!metres && !a_bit && !rest.empty() && rest.front() == "to" && rest.back() != "left" && rest.back() != "right" &&
        rest.back() != "front" && rest.back() != "back")
        return {};
    const auto direction = direction_of(editor, rest, editor.placed(id));
    if (!direction) return {};
    EditStep step;
    step.kind = EditStep::Kind::shift;
    step.ids = {id};
    step.by = *direction * metres.value_or(a_bit ? kABit : kUsual);
    step.exactly = metres.has_value();
    step.about = !metres && find_word(rest, {"away", "further", "farther", "off", "from"}) < rest.size();
    return step;
}

}  // namespace fastscene::editing
