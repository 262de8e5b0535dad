// How many: "fewer than five chairs", "two or three plants", "between two and four stools", "a table for eight".
#include <algorithm>
#include <array>

#include "fastscene/rooms/prompt_parts.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene::reading {
namespace {

constexpr int kMost = 99;

// A number that was said; not an article.
bool is_number(const Match& m) { return m.is(WordKind::count) && m.words != "a" && m.words != "an"; }
int number_of(const Match& m) { return std::stoi(m.word->meaning); }

// The matches from `begin` on, `count` of them, become one count.
void merge(Matches& m, std::size_t begin, std::size_t count, int number, std::string adds = {}) {
    Match whole{.words = m[begin].words,
                .word = Word{WordKind::count, std::to_string(std::clamp(number, 1, kMost)), true, std::move(adds)}};
    for (std::size_t k = begin + 1; k < begin + count; ++k) whole.words += " " + m[k].words;
    m.erase(m.begin() + static_cast<std::ptrdiff_t>(begin), m.begin() + static_cast<std::ptrdiff_t>(begin + count));
    m.insert(m.begin() + static_cast<std::ptrdiff_t>(begin), std::move(whole));
}

// "two or three", "3-4", "four to six", "between two and four": as many as one may expect, the latter.
void merge_ranges(Matches& m) {
    for (std::size_t i = 0; i + 1 < m.size(); ++i) {
        if (!is_number(m[i])) continue;
        const bool joined = i + 2 < m.size() && is_number(m[i + 2]) &&
                            (m[i + 1].is_function("or") || m[i + 1].is_function("to"));
        const bool between = i > 0 && m[i - 1].words == "between" && i + 2 < m.size() && is_number(m[i + 2]) &&
                             m[i + 1].is_function("and");
        const bool hyphen = is_number(m[i + 1]) && number_of(m[i + 1]) == number_of(m[i]) + 1;
        if (between) merge(m, i - 1, 4, number_of(m[i + 2]));
        else if (joined && number_of(m[i + 2]) > number_of(m[i])) merge(m, i, 3, number_of(m[i + 2]));
        else if (hyphen) merge(m, i, 2, number_of(m[i + 1]));
    }
}

// "a row of five chairs", "a set of four": so many, whatever a row is else.
void merge_groups(Matches& m) {
    for (std::size_t i = 0; i + 1 < m.size(); ++i)
        if (m[i].is(WordKind::count) && m[i].words.ends_with(" of") && is_number(m[i + 1]))
            merge(m, i, 2, number_of(m[i + 1]));
}

// "fewer than five", "at most one", "up to six".
void merge_bounds(Matches& m) {
    for (std::size_t i = 0; i + 1 < m.size(); ++i)
        if (m[i].is(WordKind::bound) && is_number(m[i + 1]))
            merge(m, i, 2, number_of(m[i + 1]) + std::stoi(m[i].word->meaning));
}

bool is_people(const Match& m) { return m.is(WordKind::object) && has_role(m.word->meaning, Role::person); }
bool is_seater(const Match& m) {
    return m.words == "seater" || m.words == "seat" || m.words == "person" || m.words == "people";
}

// "for ten people", "for eight", "that seats six", "eight-seater": how many are to sit or to sleep.
void merge_seats(Matches& m) {
    constexpr auto kSeats = "seats";
    for (std::size_t i = 0; i + 1 < m.size(); ++i) {
        const bool led = m[i].is_function("for") || m[i].is_function("seats") || m[i].is_function("seating for") ||
                         m[i].words == "sleeps";
        if (led && is_number(m[i + 1])) {
            const bool people = i + 2 < m.size() && is_people(m[i + 2]);
            const bool ends = i + 2 == m.size() || m[i + 2].comma || m[i + 2].is(WordKind::function) ||
                              m[i + 2].is(WordKind::relation) || m[i + 2].is(WordKind::count);
            if (people || ends) merge(m, i, people ? 3 : 2, number_of(m[i + 1]), kSeats);
        } else if (is_number(m[i]) && is_seater(m[i + 1]) && i + 2 < m.size() && is_noun(m[i + 2])) {
            merge(m, i, 2, number_of(m[i]), kSeats);
        }
    }
}

bool is_table(std::string_view kind) {
    return kind == "dining_table" || kind == "dining_table_round" || kind == "side_table" || kind == "coffee_table";
}
bool is_seat(std::string_view kind) {
    return kind == "chair" || kind == "bench" || kind == "stool" || kind == "armchair" || kind == "pouf";
}

// So many seats of a kind that was named without a number, or so many new ones.
int want(Reading& r, std::size_t at, const char* kind, int count) {
    for (PromptObject& o : r.spec.objects)
        if (!o.forbidden && o.kind == "bench" && is_seat(kind) && !o.counted && o.count == 1) {
            count = std::max(1, count - 2);  // two sit on the bench that was named
        } else if (!o.forbidden && (o.kind == kind || (is_seat(kind) && is_seat(o.kind)))) {
            if (!o.counted) o.count = o.kind == "bench" ? (count + 1) / 2 : count, o.counted = true;
            return o.id;
        }
    PromptObject& added = r.add_object(kind, r.m[at].words);
    added.count = count;
    added.counted = true;
    return added.id;
}
void tell_count(Reading& r, std::size_t at, int object) {
    const PromptObject& o = r.spec.objects[static_cast<std::size_t>(object)];
    r.tell(at, "count " + std::to_string(o.count) + " of " + o.kind, object);
}

constexpr float kPlace = 0.64f;  // metres of a table's side for one; two sit at the heads
constexpr int kMany = 7;         // more than a usual table seats

void seat_at(Reading& r, std::size_t at, int owner) {
    const int people = number_of(r.m[at]);
    PromptObject& o = r.spec.objects[static_cast<std::size_t>(owner)];
    const std::string kind = o.kind;
    const std::string said = "for " + std::to_string(people) + ": ";
    if (is_table(kind)) {
        if (kind != "dining_table_round") o.kind = "dining_table";
        if (o.size.empty() && people >= kMany) o.size = "large";
        return tell_count(r, at, want(r, at, "chair", people));
    }
    if (kind == "sofa" || kind == "loveseat") {
        o.kind = people <= 2 ? "loveseat" : "sofa";
        if (people >= 4) o.size = "large";
        return r.tell(at,
                      said + (people <= 2   ? "a sofa with two seats"
                              : people >= 4 ? "a large sofa"
                                            : "a sofa with three seats"),
                      owner);
    }
    if (kind == "bed" || kind == "bed_single") {
        if (people == 2) o.kind = "bed";
        if (people <= 2) return r.tell(at, said + (people == 2 ? "a double bed" : "a bed"), owner);
    }
    r.tell_near(at, "for how many: the " + o.words + " is as such pieces are", owner);
}

// Who named no piece speaks of the room.
void seat_in_room(Reading& r, std::size_t at) {
    const int people = number_of(r.m[at]);
    std::string room;
    for (const Match& m : r.m)
        if (m.is(WordKind::room) && !m.negated && room.empty()) room = m.word->meaning;
    const auto so_many = [&](const char* kind) { tell_count(r, at, want(r, at, kind, people)); };
    const RoomType* type = find_room_type(room);
    if (type && !type->per_person.empty() && people <= type->most_people)
        for (const std::string& thing : type->per_person) so_many(thing.c_str());
    else r.tell_near(at, "for how many: nothing in the room shows it");
}

}  // namespace

void settle_quantities(Matches& m) {
    merge_bounds(m);
    merge_ranges(m);
    merge_groups(m);
    merge_seats(m);
}

void seat_people(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (!r.m[i].is(WordKind::count) || r.m[i].word->adds != "seats") continue;
        int owner = -1;
        // "an eight-seater table": what it stands before; else what it stands behind.
        for (std::size_t k = i + 1; k < r.m.size() && owner < 0 && (modifies(r.m[k]) || has_object(r.m[k])); ++k)
            owner = r.m[k].object;
        for (std::size_t k = i; k-- > 0 && owner < 0 && !r.m[k].comma;)
            owner = r.m[k].is(WordKind::object) ? r.m[k].object : -1;
        if (owner >= 0) seat_at(r, i, owner);
        else seat_in_room(r, i);
        r.m[i].settled = true;
    }
    // "a table with ten chairs": as long as those need, unless its length was said.
    int chairs = 0;
    for (const PromptObject& o : r.spec.objects) chairs += o.kind == "chair" && !o.forbidden ? o.count : 0;
    for (PromptObject& o : r.spec.objects) {
        const bool measured = std::any_of(r.m.begin(), r.m.end(),
                                          [&](const Match& m) { return m.measure && m.about == o.id; });
        if (chairs >= kMany && o.kind == "dining_table" && o.count == 1 && !measured)
            o.size_m.x = std::max(o.size_m.x, kPlace * static_cast<float>((chairs - 1) / 2));
    }
}

}  // namespace fastscene::reading
