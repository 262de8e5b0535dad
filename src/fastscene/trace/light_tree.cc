#include "fastscene/trace/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fastscene {
namespace {

constexpr float kHalfTurn = 3.14159265f;
constexpr int kMostCuts = 30;      // below this depth nodes are split by count, since a path has 64 bits
constexpr float kCompact = 0.25f;  // metres

float angle_between(Vec3f a, Vec3f b) { return std::acos(std::clamp(dot(a, b), -1.f, 1.f)); }

// The cosine and sine of the difference of two angles, clamped at 0; all within [0, pi].
struct Angle {
    float cosine, sine;
    Angle less(Angle other) const {
        if (cosine >= other.cosine) return {1, 0};
        return {cosine * other.cosine + sine * other.sine, sine * other.cosine - cosine * other.sine};
    }
};

}  // namespace

// Build-time data of a node.
struct LightTree::Shape {
    Vec3f low, high, axis, gravity;
    float spread = 0, power = 0;  // spread: the cone's half angle
    bool two_sided = false;
    std::int32_t emitter = -1;

    Vec3f center() const { return (low + high) * 0.5f; }
    Vec3f half() const { return (high - low) * 0.5f; }
    float radius() const { return length(half()); }

    void add(const Shape& other) {
        if (!(other.power > 0)) return;
        if (!(power > 0)) {
            *this = other;
            return;
        }
        for (std::size_t a = 0; a < 3; ++a)
            low[a] = std::min(low[a], other.low[a]), high[a] = std::max(high[a], other.high[a]);
        power += other.power;
        // A two-sided sheet has no preferred front: flip its axis towards the other cone's.
        Vec3f towards = other.axis;
        if (two_sided != other.two_sided) spread = kHalfTurn;
        else if (two_sided && dot(axis, towards) < 0) towards = -towards;
        two_sided = two_sided && other.two_sided;
        // The smallest cone around both (Conty Estevez and Kulla, algorithm 1).
        const float apart = angle_between(axis, towards);
        if (std::min(apart + other.spread, kHalfTurn) <= spread) return;
        if (std::min(apart + spread, kHalfTurn) <= other.spread) {
            axis = towards;
            spread = other.spread;
            return;
        }
        const float wide = 0.5f * (spread + apart + other.spread);
        const Vec3f aside = towards - axis * dot(axis, towards);
        if (wide >= kHalfTurn || !(length(aside) > 1e-6f)) {
            spread = kHalfTurn;
            return;
        }
        const float turn = wide - spread;
        axis = normalize(axis * std::cos(turn) + normalize(aside) * std::sin(turn));
        spread = wide;
    }

    // The cost measure for splits: power in a large ball with a wide cone is hard to sample well.
    float cost() const {
        if (!(power > 0)) return 0;
        const float r = radius(), reach = std::min(spread + 0.5f * kHalfTurn, kHalfTurn);
        const float solid = 1 - std::cos(spread) +
                            0.25f * (2 * reach * std::sin(spread) - std::cos(spread - 2 * reach) -
                                     2 * spread * std::sin(spread) + std::cos(spread));
        return power * (r * r + 1e-8f) * (solid + 1e-3f);
    }
};

LightTree::Shape LightTree::shape_of(const Emitter& e) {
    Shape shape;
    shape.low = e.low, shape.high = e.high, shape.gravity = e.center, shape.axis = e.normal, shape.power = e.power,
    shape.two_sided = e.two_sided;
    return shape;
}

LightTree::LightTree(const std::vector<Emitter>& emitters) : places_(emitters.size()) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < emitters.size(); ++i) {
        if (!(emitters[i].power > 0)) continue;
        shapes.push_back(shape_of(emitters[i]));
        shapes.back().emitter = static_cast<std::int32_t>(i);
    }
    nodes_.reserve(2 * shapes.size());
    if (shapes.empty()) return;
    build(shapes, 0, shapes.size(), 0);
    choose_heads();
}

std::int32_t LightTree::build(std::vector<Shape>& shapes, std::size_t begin, std::size_t end, int depth) {
    const auto index = static_cast<std::int32_t>(nodes_.size());
    Shape all;
    for (std::size_t i = begin; i < end; ++i) all.add(shapes[i]);
    Node node;
    node.center = all.center();
    node.half = all.half();
    node.radius = all.radius();
    node.axis = all.axis;
    // Slightly enlarged to cover rounding.
    const float spread = std::min(kHalfTurn, all.spread + 1e-3f);
    node.cosine = std::cos(spread), node.sine = std::sin(spread);
    node.power = all.power;
    node.two_sided = all.two_sided;
    nodes_.push_back(node);
    if (end - begin == 1) {
        nodes_.back().emitter = shapes[begin].emitter;
        // A flat leaf with a known plane. A corner may lie up to two thirds of a triangle's height above its centroid.
        nodes_.back().center = shapes[begin].gravity;
        nodes_.back().half = all.half() * (4.f / 3);
        return index;
    }
    // The cheapest of a dozen splits along each axis (binned SAH).
    constexpr int kBins = 12;
    Vec3f low = shapes[begin].center(), high = low;
    for (std::size_t i = begin; i < end; ++i)
        for (std::size_t a = 0; a < 3; ++a)
            low[a] = std::min(low[a], shapes[i].center()[a]), high[a] = std::max(high[a], shapes[i].center()[a]);
    const auto bin_of = [&](const Shape& s, std::size_t axis) {
        return std::min(kBins - 1, static_cast<int>(kBins * (s.center()[axis] - low[axis]) / (high[axis] - low[axis])));
    };
    float best = std::numeric_limits<float>::infinity();
    std::size_t best_axis = 0;
    int best_bin = -1;
    for (std::size_t axis = 0; axis < 3 && depth < kMostCuts; ++axis) {
        if (!(high[axis] - low[axis] > 1e-6f)) continue;
        std::array<Shape, kBins> bins{}, after{};
        for (std::size_t i = begin; i < end; ++i)
            bins[static_cast<std::size_t>(bin_of(shapes[i], axis))].add(shapes[i]);
        for (std::size_t k = kBins - 1; k > 0; --k) {
            after[k - 1] = after[k];
            after[k - 1].add(bins[k]);
        }
        Shape before;
        for (std::size_t k = 0; k + 1 < kBins; ++k) {
            before.add(bins[k]);
            if (!(before.power > 0) || !(after[k].power > 0)) continue;
            const float cost = before.cost() + after[k].cost();
            if (cost < best) best = cost, best_axis = axis, best_bin = static_cast<int>(k);
        }
    }
    std::size_t middle = begin + (end - begin) / 2;
    if (best_bin >= 0) {
        const auto first = shapes.begin() + static_cast<std::ptrdiff_t>(begin),
                   last = shapes.begin() + static_cast<std::ptrdiff_t>(end);
        middle = static_cast<std::size_t>(
            std::stable_partition(first, last, [&](const Shape& s) { return bin_of(s, best_axis) <= best_bin; }) -
            shapes.begin());
    }
    build(shapes, begin, middle, depth + 1);
    const std::int32_t second = build(shapes, middle, end, depth + 1);
    nodes_[static_cast<std::size_t>(index)].second = second;
    return index;
}

float LightTree::importance(const Node& node, Vec3f position, Vec3f normal) {
    const Vec3f to = node.center - position;
    // Mean cosine at the receiver over the box's extent, with the part below the horizon clamped to 0; heights within
    // the box are treated as uniformly distributed.
    const float middle = dot(normal, to);
    const float reach = std::abs(normal.x) * node.half.x + std::abs(normal.y) * node.half.y +
                        std::abs(normal.z) * node.half.z;
    if (!(middle + reach > 0)) return 0;
    const float height = middle >= reach ? middle : (middle + reach) * (middle + reach) / (4 * reach);
    const float d2 = dot(to, to), r2 = node.radius * node.radius;
    if (node.emitter >= 0) {
        const float away = -dot(node.axis, to), there = node.two_sided ? std::abs(away) : away,
                    far2 = std::max({d2, 0.25f * r2, 1e-10f});
        return there > 0 ? node.power * there * height / (far2 * far2) : 0;
    }
    // Within a row of lights the nearest dominate: the mean of 1/d2 along a row is 1 / (length * distance).
    float near2 = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const float out = std::max(0.f, std::abs(to[a]) - node.half[a]);
        near2 += out * out;
    }
    const float d = std::sqrt(d2),
                far2 = std::max(std::sqrt(near2), 0.1f * node.radius) * std::max(d, node.radius) + 1e-10f;
    const float here = std::min(1.f, height / std::sqrt(far2));
    if (!(d2 > r2)) return node.power * here / far2;  // inside the bounding ball any orientation is possible
    const float sine = node.radius / d, away = std::clamp(-dot(node.axis, to) / d, -1.f, 1.f),
                cosine = node.two_sided ? std::abs(away) : away;
    // The smallest angle between an emitter normal and the direction to the receiver, over the node's ball.
    const Angle least = Angle{cosine, std::sqrt(1 - cosine * cosine)}.less({node.cosine, node.sine});
    const float best = least.less({std::sqrt(std::max(0.f, 1 - sine * sine)), sine}).cosine;
    if (!(best > 0)) return 0;
    return node.power * 0.5f * (best + std::max(0.f, least.cosine)) * here / far2;
}

float LightTree::first_share(std::int32_t node, Vec3f position, Vec3f normal) const {
    const float first = importance(nodes_[static_cast<std::size_t>(node + 1)], position, normal);
    const float second = importance(nodes_[static_cast<std::size_t>(nodes_[static_cast<std::size_t>(node)].second)],
                                    position, normal);
    return first + second > 0 ? first / (first + second) : -1;
}

// Splits the widest node repeatedly until all are compact.
void LightTree::choose_heads() {
    heads_ = {0};
    while (heads_.size() < kMostHeads) {
        const auto radius = [&](std::int32_t i) {
            const Node& node = nodes_[static_cast<std::size_t>(i)];
            return node.emitter >= 0 ? 0.f : node.radius;
        };
        const auto widest = std::max_element(heads_.begin(), heads_.end(),
                                             [&](std::int32_t a, std::int32_t b) { return radius(a) < radius(b); });
        if (!(radius(*widest) > kCompact)) break;
        const std::int32_t second = nodes_[static_cast<std::size_t>(*widest)].second;
        ++*widest;
        heads_.insert(widest + 1, second);
    }
    for (std::size_t h = 0; h < heads_.size(); ++h) find(heads_[h], {static_cast<std::int32_t>(h), 0, 0});
}

void LightTree::find(std::int32_t node, Place place) {
    const Node& here = nodes_[static_cast<std::size_t>(node)];
    if (here.emitter >= 0) {
        places_[static_cast<std::size_t>(here.emitter)] = place;
        return;
    }
    const std::uint64_t bit = std::uint64_t{1} << place.depth++;
    find(node + 1, place);
    place.path |= bit;
    find(here.second, place);
}

LightTree::Shares LightTree::shares_of_heads(Vec3f position, Vec3f normal) const {
    Shares shares;
    float sum = 0;
    for (std::size_t h = 0; h < heads_.size(); ++h)
        shares[h] = sum += importance(nodes_[static_cast<std::size_t>(heads_[h])], position, normal);
    return shares;
}

LightTree::SampledEmitter LightTree::draw(Vec3f position, Vec3f normal, float u) const {
    if (heads_.empty()) return {};
    const Shares shares = shares_of_heads(position, normal);
    const float all = shares[heads_.size() - 1];
    if (!(all > 0)) return {};
    std::size_t head = 0;
    while (head + 1 < heads_.size() && !(u * all < shares[head])) ++head;
    const float below = head ? shares[head - 1] : 0.f;
    if (!(shares[head] > below)) return {};  // only by rounding
    SampledEmitter out{-1, (shares[head] - below) / all};
    u = (u * all - below) / (shares[head] - below);
    for (std::int32_t at = heads_[head];;) {
        u = std::clamp(u, 0.f, 0.999999f);
        const Node& node = nodes_[static_cast<std::size_t>(at)];
        if (node.emitter >= 0) {
            out.emitter = node.emitter;
            return out;
        }
        const float first = first_share(at, position, normal);
        if (first < 0) return {};
        const bool takes_first = u < first;
        out.probability *= takes_first ? first : 1 - first;
        u = takes_first ? u / first : (u - first) / (1 - first);
        at = takes_first ? at + 1 : node.second;
    }
}

float LightTree::probability(int emitter, Vec3f position, Vec3f normal) const {
    const Place& place = places_[static_cast<std::size_t>(emitter)];
    if (place.head < 0) return 0;
    const auto head = static_cast<std::size_t>(place.head);
    const Shares shares = shares_of_heads(position, normal);
    const float all = shares[heads_.size() - 1];
    if (!(all > 0)) return 0;
    float probability = (shares[head] - (head ? shares[head - 1] : 0.f)) / all;
    std::int32_t at = heads_[head];
    for (int level = 0; level < place.depth && probability > 0; ++level) {
        const float first = first_share(at, position, normal);
        if (first < 0) return 0;
        const bool second = place.path >> level & 1u;
        probability *= second ? 1 - first : first;
        at = second ? nodes_[static_cast<std::size_t>(at)].second : at + 1;
    }
    return probability;
}

}  // namespace fastscene
