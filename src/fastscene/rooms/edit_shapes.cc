// "Make the table round": another form of a thing, with its chairs about it and what stands on it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

float turn_of(Vec2f a, Vec2f b, Vec2f c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// The area that a piece covers, without its hollows: of its convex hull, seen from above or, of what hangs on a wall,
// from before it.
float hull_area(const Piece& piece) {
    std::vector<Vec2f> points;
    for (const Mesh& m : piece.meshes)
        for (const Vec3f& p : m.positions) points.push_back({p.x, piece.mount == Mount::wall ? p.y : p.z});
    std::sort(points.begin(), points.end(), [](Vec2f a, Vec2f b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Vec2f> hull;
    for (const bool upper : {false, true}) {
        const std::size_t base = hull.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2f p = upper ? points[points.size() - 1 - i] : points[i];
            while (hull.size() >= base + 2 && turn_of(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
    }
    float twice = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2f a = hull[i], b = hull[(i + 1) % hull.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

}  // namespace

std::string shape_of(const Piece& piece) {
    constexpr float kRoundLow = 0.72f, kRoundHigh = 0.82f;  // of its box: a circle has 0.785 of it
    constexpr float kFull = 0.94f, kEven = 1.1f;
    const float x = piece.size_m.x, z = piece.mount == Mount::wall ? piece.size_m.y : piece.size_m.z;
    if (!(x > 0 && z > 0)) return {};
    const float share = hull_area(piece) / (x * z);
    const bool even = std::max(x, z) < kEven * std::min(x, z);
    if (share > kRoundLow && share < kRoundHigh) return even ? "round" : "oval";
    if (share > kFull) return even ? "square" : "rectangular";
    return {};
}

std::vector<bool> round_ones(const std::vector<Placed>& all) {
    std::vector<bool> out(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        out[i] = all[i].piece.mount == Mount::floor && is_table(all[i].piece.kind) && shape_of(all[i].piece) == "round";
    return out;
}

namespace {

bool is_curved(const std::string& shape) { return shape == "round" || shape == "oval"; }

// Requests that may give a piece that shape, the likeliest first: as asked, another kind of that name, another seed.
std::vector<PieceRequest> requests_for(PieceRequest r, const std::string& shape, Vec3f size) {
    constexpr int kSeeds = 24;
    const std::string ending = "_round";
    const auto& classes = piece_classes();
    r.size_m = {};
    r.size_factor = 1;
    std::vector<PieceRequest> out;
    if (is_one_of(r.pattern, {"round", "oval"})) r.pattern.clear();
    if (is_curved(shape) && has_role(r.kind, Role::may_be_round)) {
        out.push_back(r);
        out.back().pattern = shape;
    }
    const std::string plain = r.kind.ends_with(ending) ? r.kind.substr(0, r.kind.size() - ending.size()) : r.kind;
    std::vector<std::string> kinds{r.kind, is_curved(shape) ? plain + ending : plain};
    std::swap(kinds[0], kinds[1]);
    for (const std::string& kind : kinds) {
        if (!std::binary_search(classes.begin(), classes.end(), kind)) continue;
        PieceRequest one = r;
        one.kind = kind;
        for (int k = 0; k < kSeeds; ++k) {
            one.seed = r.seed + static_cast<std::uint64_t>(k);
            out.push_back(one);
            const float side = std::sqrt(size.x * size.z);
            if (shape == "square" && side > 0) out.back().size_m = {side, 0, side};
        }
    }
    return out;
}

// The same shape in about the same size.
std::optional<PieceRequest> request_of_shape(const Placed& p, const std::string& shape, const Style& style) {
    const auto floor = [](const Piece& piece) {
        return piece.size_m.x * (piece.mount == Mount::wall ? piece.size_m.y : piece.size_m.z);
    };
    for (PieceRequest& r : requests_for(*p.piece.made_from, shape, p.piece.size_m)) {
        if (!r.style) r.style = &style;
        const Piece piece = make_piece(r);
        if (shape_of(piece) != shape) continue;
        if (r.size_m != Vec3f{}) return r;
        const float factor = std::clamp(std::sqrt(floor(p.piece) / floor(piece)), 0.6f, 1.6f);
        // As high as it was, where its builder knows that.
        PieceRequest sized = r;
        sized.size_m = {piece.size_m.x * factor, 0, piece.size_m.z * factor};
        if (p.piece.mount == Mount::floor && shape_of(make_piece(sized)) == shape) return sized;
        r.size_factor = factor;
        return r;
    }
    return {};
}

// Which way from the middle of a table of these half extents something lies, as if the table were round.
float way_from(Vec2f at, Vec2f half) { return std::atan2(at.x / half.x, at.y / half.y); }

// Around, in the order that they have, as near as may be to where they are: up to four at the sides, more of them
// evenly.
std::vector<float> evenly(const std::vector<float>& ways) {
    constexpr std::size_t kSides = 4;
    std::vector<std::size_t> order(ways.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ways[a] < ways[b]; });
    const std::size_t places = std::max(kSides, ways.size());
    const float step = 2 * kPi / static_cast<float>(places);
    // The first of them stands at a side.
    std::vector<float> out(ways.size()), best;
    float least = 1e9f;
    for (std::size_t side = 0; side < kSides; ++side)
        for (std::size_t skip = 0; skip <= places - ways.size(); ++skip) {
            float far = 0;
            for (std::size_t k = 0; k < order.size(); ++k) {
                // With places to spare, those after the first half lie further on.
                const std::size_t place = k + (2 * k >= order.size() ? skip : 0);
                out[order[k]] = static_cast<float>(side) * kPi / 2 + step * static_cast<float>(place);
                far += std::abs(std::remainder(out[order[k]] - ways[order[k]], 2 * kPi));
            }
            if (far < least) least = far, best = out;
        }
    return best;
}

}  // namespace

// Chairs and what stands before them go around a round table; the rest keeps its way from the middle.
void Editor::gather_about(int index, const Placed& before, const std::vector<int>& seats, float further) {
    const Placed& after = placed(index);
    const Vec2f half{before.piece.size_m.x / 2, before.piece.size_m.z / 2};
    const Vec3f right = right_of(before.yaw), front = front_of(before.yaw);
    const float radius = std::min(after.piece.size_m.x, after.piece.size_m.z) / 2;
    const auto local = [&](int i) {
        const Vec3f d = placed(i).position - before.position;
        return Vec2f{dot(d, right), dot(d, front)};
    };
    const auto outwards = [&](float way) { return right * std::sin(way) + front * std::cos(way); };
    std::vector<float> ways;
    for (const int i : seats) ways.push_back(way_from(local(i), half));
    const std::vector<float> now = evenly(ways);
    for (std::size_t k = 0; k < seats.size(); ++k) {
        const Vec2f at = local(seats[k]);
        // As far from the edge as it was.
        const float gap = std::max(std::abs(at.x) - half.x, std::abs(at.y) - half.y);
        DocumentThing& t = thing(seats[k]);
        const Vec3f to = after.position + outwards(now[k]) * (radius + gap + further);
        t.position.x = to.x, t.position.z = to.z;
        const Vec3f in = outwards(now[k]) * -1.f;
        t.yaw = std::atan2(in.x, in.z);
        tell(t.id, "moved with " + thing(index).id);
    }
    // What stands before the chairs first: the rest has the place that is left.
    struct Rider {
        int index;
        float reach, way, to_way, turn;
    };
    std::vector<Rider> riders;
    for (const int i : with_riders({index})) {
        if (placed(i).on != index) continue;
        const Vec2f at = local(i);
        Rider r{i, std::max(std::abs(at.x) / half.x, std::abs(at.y) / half.y), way_from(at, half), 0, 0};
        r.to_way = r.way;
        constexpr float kSame = 0.45f, kAtEdge = 0.45f;  // radians; of the way to the edge
        for (std::size_t k = 0; k < seats.size(); ++k)
            if (r.reach > kAtEdge && std::abs(std::remainder(r.way - ways[k], 2 * kPi)) < kSame)
                r.to_way = now[k], r.turn = thing(seats[k]).yaw - placed(seats[k]).yaw;
        riders.push_back(r);
    }
    std::stable_sort(riders.begin(), riders.end(), [](const Rider& a, const Rider& b) { return a.reach > b.reach; });
    std::vector<Footprint> taken;
    for (const Rider& r : riders) {
        Footprint box = footprint_of(placed(r.index));
        const float most = std::max(0.f, radius - std::max(box.half.x, box.half.y) - 0.01f);
        box.yaw = std::remainder(box.yaw + r.turn, 2 * kPi);
        const auto at = [&](float out, float way) { return after.position + outwards(way) * out; };
        const float out = std::min(r.reach * radius, most);
        Vec3f to = at(out, r.to_way);
        // The nearest free place, round and round.
        constexpr int kRings = 12, kWays = 24;
        float nearest = 1e9f;
        for (int ring = 0; ring <= kRings; ++ring)
            for (int k = 0; k < kWays; ++k) {
                const Vec3f there = ring == 0 ? to
                                              : at(most * static_cast<float>(ring) / kRings,
                                                   r.to_way + 2 * kPi * static_cast<float>(k) / kWays);
                const float far = length(there - at(out, r.to_way));
                box.center = flat(there);
                if (far < nearest && std::none_of(taken.begin(), taken.end(), [&](const Footprint& t) {
                        return overlap(t, Footprint{box.center, box.half, box.yaw, t.y0, t.y1});
                    }))
                    nearest = far, to = there;
            }
        box.center = flat(to);
        taken.push_back(box);
        to.y = after.position.y + after.piece.surfaces.front().center.y;
        const Vec3f step = to - placed(r.index).position;
        for (const int k : with_riders({r.index})) thing(k).position += step;
        thing(r.index).yaw = std::remainder(thing(r.index).yaw + r.turn, 2 * kPi);
    }
}

// In the first size in which it has room.
void Editor::reshape_one(int index, const std::string& shape) {
    const Placed before = placed(index);
    const std::string id = thing(index).id;
    const auto request = request_of_shape(before, shape, plan().style);
    if (!request) throw Error("{}: there is no {} {}", id, shape, in_words(before.piece.kind));
    const std::vector<int> seats = seats_at(index);
    std::string fault;
    // Its size, and how far its chairs move off.
    std::vector<std::pair<float, float>> tries;
    for (const float further : {0.f, 0.12f, 0.22f, 0.3f})
        for (const float scale : {1.f, 0.9f, 1.1f, 0.8f, 1.2f, 0.7f}) tries.emplace_back(scale, further);
    for (const auto& [scale, further] : tries) {
        if (further > 0 && seats.empty()) continue;
        PieceRequest r = *request;
        if (r.size_m == Vec3f{}) r.size_factor *= scale;
        r.size_m = r.size_m * scale;
        const Piece piece = make_piece(r);
        try {
            checked([&] {
                DocumentThing& t = thing(index);
                if (t.asked && t.asked->kind == t.kind) t.asked->kind = r.kind;
                t.kind = r.kind, t.seed = r.seed, t.pattern = r.pattern;
                t.size_factor = r.size_factor, t.asked_size_m = r.size_m, t.size_m = piece.size_m;
                const Vec3f more = piece.size_m - before.piece.size_m;
                if (piece.mount == Mount::wall) t.position.y -= more.y / 2;
                else if (piece.against_wall) t.position += front_of(before.yaw) * (more.z / 2);
                build();
                if (is_curved(shape) && !placed(index).piece.surfaces.empty())
                    gather_about(index, before, seats, further);
                else if (!before.piece.surfaces.empty()) {
                    carry_riders(index, before,
                                 {piece.size_m.x / before.piece.size_m.x, 1, piece.size_m.z / before.piece.size_m.z});
                    keep_seats(index, before);
                }
                tell(id, fmt::format("shape: {}, {:.2f} x {:.2f} m", shape, piece.size_m.x,
                                     piece.mount == Mount::wall ? piece.size_m.y : piece.size_m.z));
            });
            return;
        } catch (const Error& e) {
            if (fault.empty()) fault = e.what();
        }
    }
    throw Error("{}: there is no room for a {} one: {}", id, shape, fault);
}

void Editor::reshape(const EditStep& step) {
    do_each(*this, step.ids.size(), [&](std::size_t k) {
        const int index = index_of(step.ids[k]);
        if (shape_of(placed(index).piece) == step.value)
            throw AlreadySo(fmt::format("{}: it is {} already", step.ids[k], step.value));
        reshape_one(index, step.value);
    });
}

}  // namespace fastscene::editing
