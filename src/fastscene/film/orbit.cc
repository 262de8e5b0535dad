#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/film/plan_parts.h"

namespace fastscene {
namespace {

constexpr std::size_t kBins = 72;  // of 5 degrees around the subject
constexpr float kBinRad = 2 * kPi / kBins;
// What a bend of the distance costs: the camera keeps its distance rather than follow every corner of the floor.
constexpr float kSteadiness = 6;

// A place in one of the directions from the subject.
struct RingPlace {
    std::size_t place;
    float radius_m, cost;
};
using Ring = std::vector<std::vector<RingPlace>>;

// Places that see the subject, neither at its feet nor far off.
Ring ring_around(const FilmSet& set, const FilmSubject& subject, float wanted_m) {
    Ring ring(kBins);
    const Vec2f center{subject.center_m.x, subject.center_m.z};
    for (std::size_t i = 0; i < set.grid.places().size(); ++i) {
        const Vec2f way = set.grid.places()[i] - center;
        const float far = std::hypot(way.x, way.y);
        constexpr float kNearest_m = 0.6f, kFarthest = 1.8f, kNarrow_m = 0.15f;
        if (far < kNearest_m || far > kFarthest * wanted_m) continue;
        if (!is_seen(set, set.eye(set.grid.places()[i]), subject)) continue;
        const float angle = std::atan2(way.x, way.y);
        const auto bin = static_cast<std::size_t>(std::clamp((angle + kPi) / kBinRad, 0.f, kBins - 1.f));
        const float off = far - wanted_m;
        ring[bin].push_back({i, far, off * off + (set.grid.clearance_at(i) < kNarrow_m ? 0.5f : 0.f)});
    }
    // The best few are enough to choose from.
    constexpr std::size_t kPlaces = 16;
    for (std::vector<RingPlace>& bin : ring) {
        std::sort(bin.begin(), bin.end(), [](const RingPlace& a, const RingPlace& b) { return a.cost < b.cost; });
        bin.resize(std::min(bin.size(), kPlaces));
    }
    return ring;
}

// Whether a straight step stays on the floor.
bool is_open(const FilmSet& set, std::size_t a, std::size_t b) {
    const Vec2f from = set.grid.places()[a], gap = set.grid.places()[b] - from;
    const int checks = std::max(1, static_cast<int>(std::hypot(gap.x, gap.y) / 0.04f));
    for (int k = 0; k <= checks; ++k)
        if (!contains(set.area, from + gap * (static_cast<float>(k) / static_cast<float>(checks)))) return false;
    return true;
}

// The steadiest chain of places through directions first, first + 1 …, as far as the floor leads, at most all the way
// round.
std::vector<std::size_t> chain_from(const FilmSet& set, const Ring& ring, std::size_t first) {
    struct Link {
        float cost;
        std::size_t before;
    };
    std::vector<std::vector<Link>> links;
    for (std::size_t k = 0; k <= kBins; ++k) {
        std::vector<Link> here;
        bool reached = false;
        for (const RingPlace& to : ring[(first + k) % kBins]) {
            Link best{k == 0 ? to.cost : 1e9f, 0};
            for (std::size_t i = 0; k > 0 && i < links[k - 1].size(); ++i) {
                const RingPlace& from = ring[(first + k - 1) % kBins][i];
                const float bend = to.radius_m - from.radius_m;
                const float cost = links[k - 1][i].cost + to.cost + kSteadiness * bend * bend;
                if (cost < best.cost && is_open(set, from.place, to.place)) best = {cost, i};
            }
            reached = reached || best.cost < 1e9f;
            here.push_back(best);
        }
        if (!reached) break;
        links.push_back(std::move(here));
    }
    std::vector<std::size_t> chain(links.size());
    if (links.empty()) return chain;
    const auto cheapest = [](const std::vector<Link>& row) {
        return static_cast<std::size_t>(
            std::min_element(row.begin(), row.end(), [](Link a, Link b) { return a.cost < b.cost; }) - row.begin());
    };
    std::size_t at = cheapest(links.back());
    for (std::size_t k = links.size(); k-- > 0; at = links[k][at].before)
        chain[k] = ring[(first + k) % kBins][at].place;
    return chain;
}

// The longest chain; beginnings are where the floor begins.
std::vector<std::size_t> longest_chain(const FilmSet& set, const Ring& ring) {
    std::vector<std::size_t> best;
    for (std::size_t first = 0; first < kBins && best.size() <= kBins; ++first) {
        const std::vector<std::size_t> chain = chain_from(set, ring, first);
        if (chain.size() > best.size()) best = chain;
        // What this chain has covered, later beginnings cannot make longer.
        if (chain.size() > 1) first += chain.size() - 1;
    }
    return best;
}

struct Orbit {
    Vec3f target;
    std::vector<std::size_t> chain;
};

Orbit orbit_around(const FilmSet& set, const FilmSubject& subject, float distance_m) {
    return {subject.center_m, longest_chain(set, ring_around(set, subject, distance_m))};
}

// Around the main subject, unless the floor leads much farther around another.
Orbit best_orbit(const FilmSet& set) {
    const auto distance_to = [&](std::size_t place, Vec3f target) {
        const Vec2f gap = set.grid.places()[place] - Vec2f{target.x, target.z};
        return std::hypot(gap.x, gap.y);
    };
    if (set.subjects.empty()) {
        const Orbit around = orbit_around(set, {"", set.middle, 0.5f, {}, false}, 1.5f);
        return around.chain.empty() ? Orbit{set.middle, {widest_place(set)}} : around;
    }
    Orbit best;
    float most = -1, trust = 1;
    for (const FilmSubject& subject : set.subjects) {
        const std::size_t place = lookouts_for(set, subject, 1).front().place;
        Orbit one = orbit_around(set, subject, distance_to(place, subject.center_m));
        if (one.chain.empty()) one.chain.push_back(place);
        const float worth = trust * static_cast<float>(one.chain.size());
        if (worth > most) most = worth, best = std::move(one);
        trust *= 0.8f;
    }
    return best;
}

}  // namespace

std::vector<FilmStep> orbit_steps(const FilmSet& set) {
    const Orbit orbit = best_orbit(set);
    std::vector<Vec2f> way;
    for (const std::size_t place : orbit.chain) way.push_back(set.grid.places()[place]);
    std::vector<FilmStep> steps;
    for (const Vec2f place : smooth_curve(set.area, way)) {
        const Aim aim = aim_at(set.eye(place), orbit.target);
        steps.push_back({place, aim.yaw_deg, aim.pitch_deg, 0});
    }
    return steps;
}

}  // namespace fastscene
