// Which things of a room words mean, and which looks.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/materials.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene {
namespace editing {
namespace {

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

bool has_word(const std::vector<std::string>& words, std::initializer_list<std::string_view> any) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& w) { return std::find(any.begin(), any.end(), w) != any.end(); });
}

// "coffee_table" is a table: one of the words of its kind is that.
bool is_a(const std::string& kind, const std::string& word) {
    const std::string all = "_" + kind + "_";
    return all.find("_" + word + "_") != std::string::npos;
}

std::string singular(const std::string& word) {
    for (const std::string& form : base_forms(word))
        if (form != word && look_up(form)) return form;
    return word;
}

// Where a thing stands, in words that tell it from its like.
std::string whereabouts(const RoomDocument& document, const DocumentRoom& room, std::size_t index) {
    const DocumentThing& t = document.things[index];
    if (!t.on.empty()) return "on " + t.on;
    const std::vector<Placed>& placed = room.furnished.placed;
    const Footprint box = footprint_of(placed[index]);
    PromptObject at;
    at.relation = "next to";
    for (const char* opening : {"window", "door", "doorway"}) {
        at.relation_to = opening;
        if (stands_as_asked(room.furnished.plan, placed, placed[index], at).value_or(false))
            return std::string("at the ") + opening;
    }
    constexpr float kNear = 0.8f;  // metres
    float nearest = kNear;
    std::string other;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (i == index || placed[i].flat || placed[i].on >= 0 || placed[i].piece.kind == placed[index].piece.kind)
            continue;
        if (const float far = distance_to(footprint_of(placed[i]), box.center); far < nearest)
            nearest = far, other = document.things[i].id;
    }
    if (!other.empty()) return "by " + other;
    return fmt::format("at x {:.1f}, z {:.1f}", t.position.x, t.position.z);
}

// Things of the kind that words name: of that very kind, else of one that the word is a part of.
std::vector<std::size_t> alike(const RoomDocument& document, const PromptObject& said) {
    std::vector<std::size_t> exact, near;
    std::string last = said.words.substr(said.words.rfind(' ') + 1);
    last = singular(last);
    for (std::size_t i = 0; i < document.things.size(); ++i) {
        const DocumentThing& t = document.things[i];
        const std::string asked = t.asked ? t.asked->kind : "";
        if (t.kind == said.kind || asked == said.kind) exact.push_back(i);
        if (is_a(t.kind, last) || (!asked.empty() && is_a(asked, last)) || t.kind == said.kind || asked == said.kind)
            near.push_back(i);
    }
    // "A table" is any, "a chair" first of all a chair.
    const bool by_name = plain_name(said.kind) == plain_name(singular(said.words));
    return by_name && !exact.empty() ? exact : near;
}

float to_the_right(const DocumentRoom& room, const DocumentThing& t) {
    const Vec3f looks = room.furnished.looks, d = t.position - room.furnished.camera;
    return dot(d, cross(Vec3f{0, 1, 0}, looks));
}

// "the second chair", "the left nightstand".
void pick(const std::vector<std::string>& words, const RoomDocument& document, const DocumentRoom& room,
          std::vector<std::size_t>& found) {
    static constexpr std::array<std::string_view, 5> kOrdinals{"first", "second", "third", "fourth", "fifth"};
    for (std::size_t k = 0; k < kOrdinals.size() && found.size() > 1; ++k)
        if (has_word(words, {kOrdinals[k]}) && k < found.size()) found = {found[k]};
    const bool left = has_word(words, {"left"}), right = has_word(words, {"right"});
    if (found.size() < 2 || left == right) return;
    const auto by_side = [&](std::size_t a, std::size_t b) {
        return to_the_right(room, document.things[a]) < to_the_right(room, document.things[b]);
    };
    found = {left ? *std::min_element(found.begin(), found.end(), by_side)
                  : *std::max_element(found.begin(), found.end(), by_side)};
}

bool has_looks(const DocumentThing& t, const PromptObject& said) {
    const auto is = [](const std::string& one, const std::string& other) {
        return plain_name(one) == plain_name(other);
    };
    return (said.color.empty() || is(t.color, said.color) || (t.asked && is(t.asked->color, said.color))) &&
           (said.material.empty() || is(t.material, said.material) ||
            (t.asked && is(t.asked->material, said.material)));
}

[[noreturn]] void refuse_many(const std::string& words, const RoomDocument& document, const DocumentRoom& room,
                              const std::vector<std::size_t>& found) {
    std::vector<std::string> list;
    for (const std::size_t i : found) list.push_back(document.things[i].id + " " + whereabouts(document, room, i));
    throw UsageError("which {}? {}", words, fmt::join(list, ", "));
}

[[noreturn]] void refuse_none(const std::string& words, const RoomDocument& document) {
    std::vector<std::string> ids;
    for (const DocumentThing& t : document.things) ids.push_back(t.id);
    throw UsageError("there is no \"{}\" in the room; there are {}", words, fmt::join(ids, ", "));
}

}  // namespace

std::vector<std::string> named(const RoomDocument& document, const DocumentRoom& room, const std::string& words,
                               const std::shared_ptr<const FurniturePack>& pack) {
    const std::vector<std::string> tokens = tokens_of(words);
    const std::string text = joined(tokens);
    for (const DocumentThing& t : document.things) {
        const std::string id = joined(tokens_of(t.id));
        if (t.id == words || text == id || text == "the " + id) return {t.id};
    }
    const PromptSpec spec = understand_prompt(words, false, pack);
    if (spec.objects.empty()) refuse_none(words, document);
    const PromptObject& said = spec.objects.front();
    std::vector<std::size_t> found = alike(document, said);
    std::erase_if(found, [&](std::size_t i) { return !has_looks(document.things[i], said); });
    PromptObject where = said;
    where.count = static_cast<int>(found.size());
    // "at", "by", "near" a window, where the reader takes no place from it.
    if (where.relation.empty() && spec.objects.size() > 1)
        where.relation = "next to", where.relation_to = spec.objects[1].kind;
    if (!where.relation.empty() && found.size() > 1) {
        std::vector<std::size_t> there;
        const FurnishedRoom& furnished = room.furnished;
        for (const std::size_t i : found)
            if (stands_as_asked(furnished.plan, furnished.placed, furnished.placed[i], where).value_or(false))
                there.push_back(i);
        if (!there.empty()) found = there;
    }
    pick(tokens, document, room, found);
    if (found.empty()) refuse_none(words, document);
    const bool all = said.count > 1 || has_word(tokens, {"all", "both", "every", "each"});
    // "Two chairs" of four are not told apart.
    if (found.size() > 1 && (!all || (said.counted && static_cast<std::size_t>(said.count) < found.size())))
        refuse_many(said.words, document, room, found);
    std::vector<std::string> ids;
    for (const std::size_t i : found) ids.push_back(document.things[i].id);
    return ids;
}

}  // namespace editing

std::vector<std::string> things_named(const RoomDocument& document, const std::string& words,
                                      std::shared_ptr<const FurniturePack> pack) {
    const DocumentRoom room = furnish_document(document, "room", pack, Run{});
    return editing::named(document, room, words, pack);
}

PromptObject looks_named(const std::string& words) {
    PromptObject out;
    std::vector<std::string> tokens = tokens_of(words);
    std::erase_if(tokens, [](const std::string& w) {
        return is_one_of(w, {"a", "an", "the", "in", "of", "and", ",", "out"});
    });
    if (words.size() == 7 && words[0] == '#' && document_fields::color_said(words)) {
        out.color = words;
        return out;
    }
    constexpr std::size_t kLongest = 3;  // words of a color: "dark olive green"
    for (std::size_t i = 0; i < tokens.size();) {
        std::size_t length = std::min(kLongest, tokens.size() - i);
        for (; length > 0; --length) {
            const auto first = tokens.begin() + static_cast<std::ptrdiff_t>(i);
            const std::string term = fmt::format("{}",
                                                 fmt::join(first, first + static_cast<std::ptrdiff_t>(length), " "));
            const auto word = look_up(term);
            std::string* to = word && word->kind == WordKind::pattern ? &out.pattern
                              : word && word->kind == WordKind::material && material_named(word->meaning)
                                  ? &out.material
                              : color_named(plain_name(term))    ? &out.color
                              : material_named(plain_name(term)) ? &out.material
                                                                 : nullptr;
            if (!to) continue;
            const bool look = word && (word->kind == WordKind::pattern || word->kind == WordKind::material ||
                                       word->kind == WordKind::color);
            *to = look ? word->meaning : plain_name(term);
            break;
        }
        if (length == 0) throw UsageError("expected a color, a material or a pattern, found \"{}\"", tokens[i]);
        i += length;
    }
    if (tokens.empty()) throw UsageError("expected a color, a material or a pattern, found nothing");
    return out;
}

}  // namespace fastscene
