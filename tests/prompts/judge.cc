#include "judge.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/math/vec.h"

namespace judge {
namespace {

using fastscene::Json;
using fastscene::Vec2f;

// An object as an upright box, seen from above; heights grow upward.
struct Thing {
    std::string kind;
    bool asked = false;
    Vec2f at, right, front;                       // x, z of the world; unit axes
    float wide = 0, deep = 0, low = 0, high = 0;  // half extents; heights

    Vec2f in_its_frame(Vec2f p) const { return {dot(p - at, right), dot(p - at, front)}; }
    bool covers(Vec2f p, float margin) const {
        const Vec2f q = in_its_frame(p);
        return std::abs(q.x) <= wide + margin && std::abs(q.y) <= deep + margin;
    }
    // Half extent along a direction.
    float reach(Vec2f d) const { return wide * std::abs(dot(right, d)) + deep * std::abs(dot(front, d)); }
};

Thing thing_of(const Json& o) {
    const Json& m = o["world_from_object"];
    const auto at = [&](std::size_t r, std::size_t c) { return m[r][c].get<float>(); };
    Thing t;
    t.kind = o["class"].get<std::string>();
    t.asked = o["requested"].get<bool>();
    t.at = {at(0, 3), at(2, 3)};
    t.right = {at(0, 0), at(2, 0)};
    t.front = {at(0, 2), at(2, 2)};
    t.wide = o["size_m"][0].get<float>() / 2, t.deep = o["size_m"][2].get<float>() / 2;
    const float base = -at(1, 3), height = o["size_m"][1].get<float>();
    const bool hangs = t.kind == "chandelier" || t.kind == "pendant_lamp" || t.kind == "ceiling_lamp";
    t.low = hangs ? base - height : base, t.high = hangs ? base : base + height;
    return t;
}

// Distance between two boxes on the floor, along the axes of both.
float gap(const Thing& a, const Thing& b) {
    float far = 0;
    for (const Vec2f axis : {a.right, a.front, b.right, b.front})
        far = std::max(far, std::abs(dot(b.at - a.at, axis)) - a.reach(axis) - b.reach(axis));
    return far;
}

bool is_opening(const Thing& t) { return t.kind == "window" || t.kind == "door" || t.kind == "doorway"; }
bool is_flat(const Thing& t) { return t.high - t.low < 0.08f; }

bool stands_on(const Thing& s, const Thing& t) {
    if (is_flat(t)) return s.low - t.low < 0.06f && t.covers(s.at, 0.1f);
    return t.covers(s.at, 0.03f) && s.low > t.low + 0.25f * (t.high - t.low) && s.low < t.high + 0.03f;
}
bool is_above(const Thing& s, const Thing& t) {
    const Vec2f q = t.in_its_frame(s.at);
    return s.low > t.high - 0.03f && std::abs(q.x) < t.wide + 0.1f && gap(s, t) < 0.35f;
}
bool is_under(const Thing& s, const Thing& t) {
    const Vec2f q = t.in_its_frame(s.at);
    if (is_opening(t))
        return std::abs(q.x) < t.wide + 0.25f && q.y - s.reach(t.front) < 0.5f && s.low < t.low &&
               s.high < t.low + 0.5f;
    return s.low < t.high - 0.1f && s.high < t.high + 0.01f && (t.covers(s.at, 0.f) || s.covers(t.at, 0.f));
}
bool is_before(const Thing& s, const Thing& t) {
    const Vec2f q = t.in_its_frame(s.at);
    if (is_flat(s)) return q.y > t.deep - 0.5f && std::abs(q.x) < t.wide + 0.4f && gap(s, t) < 1.f;
    return q.y > (is_opening(t) ? 0.f : t.deep) && std::abs(q.x) < t.wide + 0.3f && gap(s, t) < 1.6f;
}
bool is_behind(const Thing& s, const Thing& t) {
    const Vec2f q = t.in_its_frame(s.at);
    return q.y < -t.deep + 0.05f && std::abs(q.x) < t.wide + 0.4f && gap(s, t) < 1.f;
}
bool is_next(const Thing& s, const Thing& t) { return gap(s, t) < (is_opening(t) ? 0.9f : 0.7f) && !stands_on(s, t); }
bool faces(const Thing& s, const Thing& t) {
    const Vec2f to = t.at - s.at;
    return dot(s.front, to) > 0.82f * length(to) && length(to) < 5.f;
}
bool is_opposite(const Thing& s, const Thing& t) {
    const Vec2f q = t.in_its_frame(s.at);
    return q.y > t.deep + 0.4f && dot(s.front, t.front) < -0.7f && std::abs(q.x) < t.wide + s.reach(t.right) + 0.3f;
}
bool is_between(const Thing& s, const Thing& a, const Thing& b) {
    const Vec2f along = b.at - a.at;
    const float l = length(along);
    if (l < 0.3f) return false;
    const float t = dot(s.at - a.at, along) / (l * l), off = std::abs(dot(s.at - a.at, Vec2f{-along.y, along.x})) / l;
    // Two openings in different walls have no wall between them.
    return t > 0.12f && t < 0.88f && off < 0.75f;
}

using Things = std::vector<const Thing*>;
int holding(const Things& subjects, const Things& places,
            const std::function<bool(const Thing&, const Thing&)>& relation) {
    return static_cast<int>(std::count_if(subjects.begin(), subjects.end(), [&](const Thing* s) {
        return std::any_of(places.begin(), places.end(), [&](const Thing* t) { return s != t && relation(*s, *t); });
    }));
}

// One on each side of a place, as seen from its front.
int on_both_sides(const Things& subjects, const Things& places) {
    int best = 0;
    for (const Thing* t : places) {
        int left = 0, right = 0;
        for (const Thing* s : subjects) {
            const float side = t->in_its_frame(s->at).x;
            if (s == t || gap(*s, *t) > 0.8f || std::abs(side) < 0.8f * t->wide) continue;
            (side < 0 ? left : right) += 1;
        }
        best = std::max(best, std::min(left, right) > 0 ? left + right : std::min(1, left + right));
    }
    return best;
}

// The longest chain of neighbours in one line at one height, each close to the next.
int in_row(const Things& subjects) {
    int best = 0;
    for (const Thing* first : subjects) {
        std::vector<float> along;
        for (const Thing* s : subjects) {
            const Vec2f q = first->in_its_frame(s->at);
            if (std::abs(q.y) < 0.25f && std::abs(s->low - first->low) < 0.15f && dot(s->front, first->front) > 0.9f)
                along.push_back(q.x);
        }
        std::sort(along.begin(), along.end());
        int chain = 1;
        for (std::size_t i = 1; i < along.size(); ++i)
            chain = along[i] - along[i - 1] < 2 * first->wide + 0.6f ? chain + 1 : 1, best = std::max(best, chain);
    }
    return best;
}

// All near one place, and not all on one side of it if there are three or more.
int around(const Things& subjects, const Things& places) {
    int best = 0;
    for (const Thing* t : places) {
        int near = 0;
        std::vector<int> sides(4, 0);
        for (const Thing* s : subjects) {
            if (s == t || gap(*s, *t) > 0.7f) continue;
            const Vec2f q = t->in_its_frame(s->at);
            const bool across = std::abs(q.x) / t->wide > std::abs(q.y) / t->deep;
            ++sides[across ? (q.x < 0 ? 0u : 1u) : q.y < 0 ? 2u : 3u];
            ++near;
        }
        const bool one_side = std::count(sides.begin(), sides.end(), 0) == 3;
        best = std::max(best, near >= 3 && one_side ? 1 : near);
    }
    return best;
}

// The room's walls: bounds_m is the bounding box of the rotated room, and doors and windows give the rotation.
struct Walls {
    Vec2f middle, x, z, half;
};
Walls walls_of(const Json& room, const std::vector<Thing>& things) {
    const auto corner = [&](const char* name) {
        return Vec2f{room["bounds_m"][name][0].get<float>(), room["bounds_m"][name][2].get<float>()};
    };
    const Vec2f low = corner("min"), high = corner("max"), size = high - low;
    Walls w{(low + high) * 0.5f, {1, 0}, {0, 1}, size * 0.5f};
    for (const Thing& t : things)
        if (is_opening(t)) w.x = t.right, w.z = t.front;
    const float c = std::abs(w.x.x), s = std::abs(w.x.y), det = c * c - s * s;
    if (std::abs(det) > 1e-3f) w.half = {(c * size.x - s * size.y) / det / 2, (c * size.y - s * size.x) / det / 2};
    return w;
}
// Index of the corner it stands in, or -1.
int corner_of(const Walls& w, const Thing& t) {
    const Vec2f q{dot(t.at - w.middle, w.x), dot(t.at - w.middle, w.z)};
    const bool near = w.half.x - std::abs(q.x) - t.reach(w.x) < 0.6f && w.half.y - std::abs(q.y) - t.reach(w.z) < 0.6f;
    return near ? (q.x > 0 ? 1 : 0) + (q.y > 0 ? 2 : 0) : -1;
}

int met(const Demand& d, const Things& subjects, const std::vector<Things>& places, const Walls& walls) {
    if (d.relation == "corner") {
        std::vector<int> taken;
        for (const Thing* s : subjects)
            if (const int k = corner_of(walls, *s); k >= 0 && std::find(taken.begin(), taken.end(), k) == taken.end())
                taken.push_back(k);
        return static_cast<int>(taken.size());
    }
    if (d.relation == "middle")
        return static_cast<int>(std::count_if(subjects.begin(), subjects.end(), [&](const Thing* s) {
            const Vec2f q = s->at - walls.middle;
            return std::abs(dot(q, walls.x)) < 0.5f * walls.half.x && std::abs(dot(q, walls.z)) < 0.5f * walls.half.y;
        }));
    if (d.relation == "wall")
        return static_cast<int>(std::count_if(subjects.begin(), subjects.end(), [&](const Thing* s) {
            const Vec2f q = s->at - walls.middle;
            return std::min(walls.half.x - std::abs(dot(q, walls.x)) - s->reach(walls.x),
                            walls.half.y - std::abs(dot(q, walls.z)) - s->reach(walls.z)) < 0.25f;
        }));
    if (d.relation == "row") return in_row(subjects);
    const Things& at = places.front();
    if (d.relation == "sides") return on_both_sides(subjects, at);
    if (d.relation == "around") return around(subjects, at);
    if (d.relation == "between") {
        return static_cast<int>(std::count_if(subjects.begin(), subjects.end(), [&](const Thing* s) {
            for (const Thing* a : places[0])
                for (const Thing* b : places[1])
                    if (a != b && a != s && b != s && is_between(*s, *a, *b)) return true;
            return false;
        }));
    }
    if (d.relation == "on") return holding(subjects, at, stands_on);
    if (d.relation == "above") return holding(subjects, at, is_above);
    if (d.relation == "under") return holding(subjects, at, is_under);
    if (d.relation == "before") return holding(subjects, at, is_before);
    if (d.relation == "behind") return holding(subjects, at, is_behind);
    if (d.relation == "next") return holding(subjects, at, is_next);
    if (d.relation == "facing") return holding(subjects, at, faces);
    if (d.relation == "opposite") return holding(subjects, at, is_opposite);
    // For a viewer facing its front: x, y up and z towards the viewer are right-handed, so the viewer's right is +x.
    if (d.relation == "left")
        return holding(subjects, at, [](const Thing& s, const Thing& t) {
            return t.in_its_frame(s.at).x < -0.8f * t.wide && gap(s, t) < 1.5f;
        });
    if (d.relation == "right")
        return holding(subjects, at, [](const Thing& s, const Thing& t) {
            return t.in_its_frame(s.at).x > 0.8f * t.wide && gap(s, t) < 1.5f;
        });
    if (d.relation == "foot")
        return holding(subjects, at, [](const Thing& s, const Thing& t) {
            return is_before(s, t) && gap(s, t) < 0.6f && std::abs(t.in_its_frame(s.at).x) < 0.6f * t.wide;
        });
    throw fastscene::Error(
        "relation '{}': expected on, above, under, before, behind, next, left, right, opposite, facing, around, sides, "
        "foot, "
        "between, corner, middle, wall or row",
        d.relation);
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> out;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);) out.push_back(part);
    return out;
}
std::string trimmed(const std::string& s) {
    const auto a = s.find_first_not_of(" \t"), b = s.find_last_not_of(" \t");
    return a == std::string::npos ? "" : s.substr(a, b - a + 1);
}

Demand demand_of(const std::string& text) {
    std::istringstream in(text);
    Demand d;
    d.text = trimmed(text);
    std::string word;
    in >> word;
    d.what = split(word, '/');
    in >> word;
    if (!word.empty() && std::isdigit(static_cast<unsigned char>(word[0]))) d.count = std::stoi(word), in >> word;
    d.relation = word;
    while (in >> word) d.places.push_back(split(word, '/'));
    return d;
}

}  // namespace

std::vector<Sentence> read_sentences(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw fastscene::Error("{}: cannot be opened", path.string());
    std::vector<Sentence> out;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> halves = split(line, '|');
        if (halves.size() != 2)
            throw fastscene::Error("{}, line {}: expected 'prompt | demands', found '{}'", path.string(), number, line);
        Sentence s{trimmed(halves[0]), {}};
        for (const std::string& part : split(halves[1], ';')) {
            s.demands.push_back(demand_of(part));
            const Demand& d = s.demands.back();
            const std::size_t wanted = d.relation == "between" ? 2
                                       : d.relation == "corner" || d.relation == "middle" || d.relation == "wall" ||
                                               d.relation == "row"
                                           ? 0
                                           : 1;
            if (d.what.empty() || d.places.size() != wanted)
                throw fastscene::Error("{}, line {}: expected {} place(s) for '{}', found {}", path.string(), number,
                                       wanted, d.relation, d.places.size());
        }
        out.push_back(std::move(s));
    }
    return out;
}

std::string complaint(const Json& room, const Demand& demand) {
    std::vector<Thing> things;
    for (const Json& o : room["objects"]) things.push_back(thing_of(o));
    const auto of_classes = [&](const std::vector<std::string>& classes, bool asked) {
        Things out;
        for (const Thing& t : things)
            if ((t.asked || !asked) && std::find(classes.begin(), classes.end(), t.kind) != classes.end())
                out.push_back(&t);
        return out;
    };
    const Things subjects = of_classes(demand.what, true);
    if (static_cast<int>(subjects.size()) < demand.count)
        return demand.text + ": " + std::to_string(subjects.size()) + " of " + std::to_string(demand.count) +
               " are there";
    std::vector<Things> places;
    for (const auto& classes : demand.places) {
        places.push_back(of_classes(classes, false));
        if (places.back().empty()) return demand.text + ": there is no " + classes.front();
    }
    const int count = met(demand, subjects, places, walls_of(room, things));
    return count >= demand.count
               ? ""
               : demand.text + ": holds for " + std::to_string(count) + " of " + std::to_string(demand.count);
}

}  // namespace judge
