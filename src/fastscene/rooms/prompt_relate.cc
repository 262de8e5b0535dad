// Where things stand to each other: "a desk under the window", "on the table, a vase", "a bed between two nightstands".
#include <algorithm>

#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

constexpr std::size_t kReach = 8;  // matches between a relation and its noun

bool ends_clause(const Match& m) { return m.comma; }

std::optional<std::size_t> noun_before(const Reading& r, std::size_t at) {
    for (std::size_t k = at; k-- > 0;) {
        if (ends_clause(r.m[k])) return {};
        if (has_object(r.m[k]) && !r.m[k].is(WordKind::material)) return k;
    }
    return {};
}

std::optional<std::size_t> noun_after(const Reading& r, std::size_t at) {
    for (std::size_t k = at + 1; k < r.m.size() && k <= at + kReach; ++k) {
        if (has_object(r.m[k]) && !r.m[k].is(WordKind::material)) return k;
        if (r.m[k].is(WordKind::relation) || r.m[k].is(WordKind::room) ||
            (ends_clause(r.m[k]) && !(k > at + 1 && k + 1 < r.m.size() && is_adjective(r.m[k + 1]))))
            return {};
    }
    return {};
}

bool takes_no_target(const std::string& relation) { return relation == "in the corner" || relation == "in the middle" || relation == "far wall"; }

// "flanked by two chairs", "surrounded by plants": the chairs stand where the words say, not what is flanked.
bool is_passive(const Match& m) { return m.words.ends_with(" by") && m.words != "close by" && m.words != "right by"; }

// "In the corner a piano", "on the table, a vase": the relation opens its clause, the subject comes after it.
bool opens_clause(const Reading& r, std::size_t at) {
    std::size_t k = at;
    while (k > 0 && (r.m[k - 1].is_function("and") || r.m[k - 1].is_function("the") || r.m[k - 1].is_function("there is"))) --k;
    return k == 0 || r.m[k - 1].comma;
}

// What "it" or "them" stands for before `subject`: the last piece that is not itself the place of another.
std::optional<std::size_t> meant_by(const Reading& r, std::size_t subject, bool several) {
    std::optional<std::size_t> last;
    for (std::size_t k = subject; k-- > 0;) {
        if (!has_object(r.m[k]) || r.m[k].object == r.m[subject].object) continue;
        const bool place = std::any_of(r.m.begin(), r.m.begin() + static_cast<std::ptrdiff_t>(k),
                                       [&](const Match& m) { return m.relation && m.target == static_cast<int>(k); });
        if (place && !several) continue;
        if (several && r.spec.objects[static_cast<std::size_t>(r.m[k].object)].count > 1) return k;
        if (!last) last = k;
        if (!several) break;
    }
    return last;
}

void attach(Reading& r, std::size_t at, std::size_t subject, std::optional<std::size_t> where, std::string relation) {
    PromptObject& object = r.object_of(subject);
    const bool placed = where.has_value() && r.m[*where].object != r.m[subject].object;
    const std::size_t target = placed ? *where : subject;
    if (!placed && !takes_no_target(relation) && relation != "against" && relation != "left of" && relation != "right of")
        return r.tell_near(at, "where: stands at no piece that was named");
    if (!object.relation.empty()) return r.tell_near(at, "where: the " + object.words + " already has its place", object.id);
    object.relation = relation;
    std::string to;
    if (placed && !takes_no_target(relation)) {
        object.relation_to = r.object_of(target).klass;
        to = " the " + r.m[target].words;
        r.m[at].target = static_cast<int>(target);
        if (relation == "between") {
            // "between the bed and the door"; "between two windows" has one class twice.
            const auto second = noun_after(r, target);
            const auto pronoun = at + 1 < r.m.size() && r.m[at + 1].is_function("them") ? meant_by(r, target, false) : std::nullopt;
            const bool joined = second && *second <= target + 5 &&
                                std::any_of(r.m.begin() + static_cast<std::ptrdiff_t>(target), r.m.begin() + static_cast<std::ptrdiff_t>(*second),
                                            [](const Match& m) { return m.is_function("and"); });
            object.relation_and = pronoun && r.object_of(target).count == 1 ? r.object_of(*pronoun).klass
                                  : joined && *second != subject            ? r.object_of(*second).klass
                                                                            : object.relation_to;
        }
    }
    r.tell(at, object.klass + " " + relation + to, object.id);
    r.m[at].relation = true;
}

// "a bed between two nightstands, opposite a wardrobe": the bed.
std::optional<std::size_t> head_of_last_clause(const Reading& r, std::size_t at) {
    std::size_t k = at;
    while (k > 0 && r.m[k - 1].comma) --k;
    std::optional<std::size_t> head;
    for (; k-- > 0 && !ends_clause(r.m[k]);)
        if (has_object(r.m[k])) head = k;
    return head;
}

void relate_one(Reading& r, std::size_t at) {
    const std::string relation = r.m[at].word->meaning;
    std::optional<std::size_t> subject = noun_before(r, at), target = noun_after(r, at);
    if (takes_no_target(relation)) {
        const bool inverted = opens_clause(r, at) || !subject;
        if (inverted) subject = noun_after(r, at);
        if (!subject) return r.tell_near(at, "where: of nothing that was named");
        return attach(r, at, *subject, {}, relation);
    }
    // "a lamp on it": the piece named before the lamp.
    const bool it = at + 1 < r.m.size() && r.m[at + 1].is_function("it"), them = at + 1 < r.m.size() && r.m[at + 1].is_function("them");
    if (it || them || (!target && r.m[at].words == "on top")) {
        if (!subject) return r.tell_near(at, "where: of nothing that was named");
        return attach(r, at, *subject, meant_by(r, *subject, them), relation);
    }
    if ((opens_clause(r, at) || !subject) && target) {
        subject = noun_after(r, *target);
        if (!subject && *target + 1 < r.m.size() && r.m[*target + 1].comma) subject = noun_after(r, *target + 1);
        if (!subject) subject = head_of_last_clause(r, at);
    }
    if (!subject) return r.tell_near(at, "where: of nothing that was named");
    if (is_passive(r.m[at]) && target) {
        const std::string turned = relation == "between" ? "next to" : relation;
        return attach(r, at, *target, subject, turned);
    }
    attach(r, at, *subject, target, relation);
}

}  // namespace

void relate(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i)
        if (r.m[i].is(WordKind::relation)) relate_one(r, i);
}

}  // namespace fastscene::reading
