// How plants grow: leaves, stems, fronds and crowns of a species.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/plants/foliage.h"
#include "fastscene/rooms/furniture/plants/species.h"

namespace fastscene::furniture {
namespace {

constexpr float kGolden = 2.39996f;  // golden angle: how leaves follow each other around a stem

// Half the width of a leaf at v along it, as a share of its whole width.
float outline(LeafShape shape, float v) {
    const auto through = [&](std::span<const Vec2f> points) {
        for (std::size_t i = 1; i < points.size(); ++i)
            if (v <= points[i].x) {
                const float t = (v - points[i - 1].x) / (points[i].x - points[i - 1].x), s = t * t * (3 - 2 * t);
                return points[i - 1].y + (points[i].y - points[i - 1].y) * s;
            }
        return 0.f;
    };
    static constexpr std::array<Vec2f, 7> kViolin{Vec2f{0, 0.06f}, {0.14f, 0.31f}, {0.34f, 0.27f}, {0.62f, 0.5f},
                                                  {0.82f, 0.44f},  {0.95f, 0.2f},  {1, 0}},
        kHeart{Vec2f{0, 0.2f}, {0.1f, 0.44f}, {0.24f, 0.5f}, {0.5f, 0.41f}, {0.75f, 0.25f}, {0.93f, 0.07f}, {1, 0}};
    switch (shape) {
        case LeafShape::sword: return 0.5f * std::min({1.f, 0.55f + 2.f * v, std::sqrt(3.f * (1 - v))});
        case LeafShape::lance: return 0.5f * std::pow(std::max(0.f, std::sin(kPi * std::pow(v, 0.8f))), 1.1f);
        case LeafShape::ovate: return 0.5f * std::pow(std::max(0.f, std::sin(kPi * std::pow(v, 0.66f))), 0.85f);
        case LeafShape::violin: return through(kViolin);
        case LeafShape::heart: return through(kHeart);
        case LeafShape::split: {
            // Deep cuts between the side veins.
            const float along = 5.f * std::clamp((v - 0.16f) / 0.74f, 0.f, 1.f), cut = along - std::floor(along);
            const float gap = v > 0.2f && v < 0.88f ? std::max(0.f, 1 - std::fabs(cut - 0.5f) / 0.17f) : 0.f;
            return through(kHeart) * (1 - 0.62f * std::min(1.f, 1.8f * gap));
        }
    }
    return 0;
}

// Where a leaf begins, which way it goes (horizontal, unit), and its rise there.
struct Bud {
    Vec3f at, out;
    float rise;
};

// Along an arc that begins with `rise` and has bent down by `droop` at its end.
struct Arc {
    Bud from;
    float length, droop;
    Vec3f point(float v) const {
        constexpr int kSteps = 6;
        Vec3f p = from.at;
        for (int i = 0; i < kSteps; ++i) {
            const float t = v * (static_cast<float>(i) + 0.5f) / kSteps;
            p += along(t) * (length * v / kSteps);
        }
        return p;
    }
    Vec3f along(float v) const {
        const float a = from.rise - droop * v;
        return from.out * std::cos(a) + Vec3f{0, std::sin(a), 0};
    }
};

struct Foliage {
    Kit& k;
    const Species& s;
    float size;
    int green, stem, bark;
    Mesh leaves{};  // all of one material in one mesh
    Mesh stems{};

    bool coarse() const { return size < 0.5f; }  // on shelves; nobody comes as close to them

    void leaf(const Bud& bud, float long_m, float wide_m) {
        const bool split = s.leaf == LeafShape::split, leaflet = s.habit == Habit::fronds || s.habit == Habit::tree;
        const int rows = split      ? (coarse() ? 24 : 40)
                         : leaflet  ? (coarse() ? 2 : 3)
                         : coarse() ? 5
                                    : 9,
                  columns = coarse() || leaflet || wide_m < 0.05f ? 2 : 4;
        const Arc rib{bud, long_m, s.droop * k.rng.uniform(0.8f, 1.2f)};
        const Vec3f side = cross(Vec3f{0, 1, 0}, bud.out);
        const float fold = k.rng.uniform(0.12f, 0.3f), twist = k.rng.uniform(-0.25f, 0.25f),
                    ripple = k.rng.uniform(0, kTau);
        Mesh m = shapes::sheet(columns, rows, [&](float u, float v) {
            const float a = 2 * u - 1, w = wide_m * std::max(0.012f, outline(s.leaf, v));
            const Vec3f along = rib.along(v), up = cross(along, side), across = side + up * (twist * v);
            const float wave = s.leaf == LeafShape::violin ? 0.06f * std::sin(14 * v + ripple) * a * a : 0.f;
            return rib.point(v) + across * (w * a) + up * (w * (fold * a * a + wave));
        });
        for (std::size_t i = 0; i < m.coords.size(); ++i) {
            const auto n = static_cast<std::size_t>(columns + 1);
            m.coords[i] = {(static_cast<float>(i % n) / static_cast<float>(columns) - 0.5f) * wide_m,
                           static_cast<float>(i / n) / static_cast<float>(rows) * long_m, 0};
        }
        shapes::append(leaves, m);
    }
    void stalk(const Arc& arc, float radius_m) {
        constexpr int kPieces = 6;
        std::vector<Vec3f> path;
        for (int i = 0; i <= kPieces; ++i) path.push_back(arc.point(static_cast<float>(i) / kPieces));
        shapes::append(stems, shapes::tube(path, radius_m, coarse() ? 4 : 6));
    }
    float each(float of) { return of * size * k.rng.uniform(0.85f, 1.12f); }

    void clump(float y) {
        for (int i = 0; i < s.leaves; ++i) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(s.leaves),
                        a = kGolden * static_cast<float>(i) + k.rng.uniform(-0.2f, 0.2f);
            const Vec3f out = around(a);
            const float r = 0.045f * size * (1 - t);
            Bud bud{Vec3f{0, y - 0.01f, 0} + out * r, out, std::lerp(s.low, s.high, t) + k.rng.uniform(-0.08f, 0.08f)};
            if (s.stalk_m > 0) {
                const Arc arc{bud, each(s.stalk_m) * (0.75f + 0.25f * t), 0.35f};
                stalk(arc, 0.0065f * size);
                // The blade hangs from its stalk.
                const float end = bud.rise - 0.35f;
                bud = {arc.point(1), out, s.leaf == LeafShape::split ? 0.15f + 0.3f * t : end - 0.1f};
            }
            leaf(bud, each(s.leaf_m), each(s.leaf_wide_m));
        }
        if (s.flowers) spathes(y);
    }
    void spathes(float y) {
        Material white = plain("spathe", {0.72f, 0.72f, 0.66f}, 0.5f);
        white.transmission = 0.3f;
        const int petal = k.material(white), spadix = k.material(plain("spadix", {0.62f, 0.55f, 0.25f}, 0.8f));
        for (int i = 0; i < 3; ++i) {
            const Vec3f out = around(2.1f * static_cast<float>(i) + 0.5f);
            const Arc arc{{Vec3f{0, y, 0}, out, 1.42f}, each(0.58f), 0.15f};
            stalk(arc, 0.0045f * size);
            k.add(blade(arc.point(1), out, 0.13f * size, 0.07f * size, 1.1f, 0.4f, 0.62f), petal);
            k.rod(spadix, arc.point(1), arc.point(1) + Vec3f{0, 0.06f * size, 0} + out * (0.012f * size), 0.007f * size,
                  0.005f * size, 8);
        }
    }
    void canes(float y, bool tufts) {
        for (int c = 0; c < s.stems; ++c) {
            const float turn = kGolden * static_cast<float>(c) + k.rng.uniform(0, 1),
                        high = each(s.stalk_m) * (1 - (tufts ? 0.24f : 0.13f) * static_cast<float>(c));
            const Vec3f out = around(turn);
            const Arc cane{
                {Vec3f{0, y - 0.03f, 0} + out * (s.stems > 1 ? 0.05f * size : 0.f), out, k.rng.uniform(1.38f, 1.5f)},
                high,
                -0.1f};
            const int wood = tufts || s.stems == 1 ? bark : stem;
            std::vector<Vec3f> path;
            for (int i = 0; i <= 8; ++i) path.push_back(cane.point(static_cast<float>(i) / 8.f));
            k.add(shapes::tube(path, size * (wood == stem ? 0.009f : 0.014f), 9), wood);
            for (int i = 0; i < s.leaves; ++i) {
                const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(s.leaves),
                            at = tufts ? 0.96f + 0.04f * t : std::lerp(0.32f, 1.f, t),
                            a = turn + kGolden * static_cast<float>(i);
                const Bud bud{cane.point(at), around(a), std::lerp(s.low, s.high, t) + k.rng.uniform(-0.12f, 0.12f)};
                // Young leaves at the top are smaller.
                const float young = tufts ? 1.f : 1.f - 0.45f * std::max(0.f, t - 0.8f) / 0.2f;
                leaf(bud, each(s.leaf_m) * young, each(s.leaf_wide_m) * young);
            }
        }
    }
    void fronds(float y) {
        const int ribs = coarse() && s.stems > 15 ? s.stems / 2 : s.stems;
        for (int i = 0; i < ribs; ++i) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(ribs);
            const Vec3f out = around(kGolden * static_cast<float>(i) + k.rng.uniform(-0.2f, 0.2f)),
                        side = cross(Vec3f{0, 1, 0}, out);
            const Arc rib{{Vec3f{0, y - 0.01f, 0} + out * (0.03f * size), out, std::lerp(s.low, s.high, t)},
                          each(s.stalk_m) * (0.8f + 0.2f * t),
                          s.droop * (1.1f - 0.4f * t)};
            stalk(rib, 0.004f * size);
            const float bare = s.leaf == LeafShape::ovate ? 0.3f : s.stalk_m > 0.8f ? 0.35f : 0.12f;
            const int pairs = coarse() ? (2 * s.leaves) / 3 : s.leaves;
            for (int j = 0; j < pairs; ++j) {
                const float v = bare + (1 - bare) * (static_cast<float>(j) + 0.5f) / static_cast<float>(pairs),
                            within = (v - bare) / (1 - bare),
                            taper = 0.45f + 0.55f * std::sin(kPi * (0.2f + 0.75f * within));
                const Vec3f along = rib.along(v);
                for (const float way : {-1.f, 1.f}) {
                    const Vec3f to = normalize(side * way + along * 0.8f), flat = normalize(Vec3f{to.x, 0, to.z});
                    leaf({rib.point(v), flat, std::asin(std::clamp(to.y, -1.f, 1.f)) + 0.12f},
                         each(s.leaf_m) * taper * (coarse() ? 1.3f : 1.f),
                         each(s.leaf_wide_m) * (coarse() ? 1.3f : 1.f));
                }
            }
        }
    }
    void crown(float y);
};

// A branch point of a crown.
struct Node {
    Vec3f at;
    int parent;
    float radius = 0;
    int children = 0;
};

// Space colonization (Runions, Lane and Prusinkiewicz 2007): branches grow towards free points of the crown until they
// have reached them all.
std::vector<Node> colonize(std::vector<Vec3f> free, Vec3f root, Vec3f top, float step) {
    std::vector<Node> nodes{{root, -1}};
    while (length(nodes.back().at - top) > step)
        nodes.push_back(
            {nodes.back().at + normalize(top - nodes.back().at) * step, static_cast<int>(nodes.size()) - 1});
    const float reach = 6 * step, reached = 1.7f * step;
    for (int round = 0; round < 60 && !free.empty(); ++round) {
        std::vector<Vec3f> pull(nodes.size());
        for (const Vec3f p : free) {
            std::size_t best = nodes.size();
            float least = reach;
            for (std::size_t i = 0; i < nodes.size(); ++i)
                if (const float far = length(nodes[i].at - p); far < least) least = far, best = i;
            if (best < nodes.size()) pull[best] += normalize(p - nodes[best].at);
        }
        const std::size_t before = nodes.size();
        for (std::size_t i = 0; i < before; ++i)
            if (length(pull[i]) > 1e-3f)
                nodes.push_back({nodes[i].at + normalize(pull[i]) * step, static_cast<int>(i)});
        if (nodes.size() == before) break;
        std::erase_if(free, [&](Vec3f p) {
            return std::any_of(nodes.begin() + static_cast<std::ptrdiff_t>(before), nodes.end(),
                               [&](const Node& n) { return length(n.at - p) < reached; });
        });
    }
    return nodes;
}

void Foliage::crown(float y) {
    const float high = each(s.stalk_m), r = 0.3f * size;
    const Vec3f middle{0.03f * size, y + 0.72f * high, 0.02f * size};
    std::vector<Vec3f> free;
    while (free.size() < 170) {
        const Vec3f q{k.rng.uniform(-1, 1), k.rng.uniform(-1, 1), k.rng.uniform(-1, 1)};
        if (dot(q, q) < 1 && dot(q, q) > 0.12f) free.push_back(middle + Vec3f{q.x * r, q.y * 0.34f * high, q.z * r});
    }
    std::vector<Node> nodes = colonize(std::move(free), {0, y - 0.03f, 0}, middle - Vec3f{0, 0.3f * high, 0},
                                       0.055f * size);
    // Pipe model: the cross section of a branch is that of all it carries.
    for (std::size_t i = nodes.size(); i-- > 1;) {
        Node& n = nodes[i];
        if (n.children == 0) n.radius = 0.0016f * size;
        Node& p = nodes[static_cast<std::size_t>(n.parent)];
        p.radius = std::pow(std::pow(p.radius, 2.3f) + std::pow(n.radius, 2.3f), 1 / 2.3f);
        ++p.children;
    }
    Mesh wood;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Node &n = nodes[i], &p = nodes[static_cast<std::size_t>(n.parent)];
        shapes::append(wood, shapes::rod(p.at, n.at, std::min(p.radius, 1.15f * n.radius), n.radius,
                                         n.radius > 0.006f * size ? 9 : 5));
        if (n.radius > 0.005f * size) continue;
        const Vec3f way = normalize(n.at - p.at);
        for (int j = 0; j < s.leaves; ++j) {
            const float a = kGolden * static_cast<float>(j) + k.rng.uniform(0, kTau);
            Vec3f out = around(a) + way * 0.6f;
            out = normalize(Vec3f{out.x, 0, out.z});
            leaf({lerp(p.at, n.at, k.rng.uniform()), out, k.rng.uniform(s.low, s.high)}, each(s.leaf_m),
                 each(s.leaf_wide_m));
        }
    }
    k.add(std::move(wood), bark);
}

}  // namespace

void grow(Kit& k, const Species& species, float y, float size) {
    Material leaf = foliage(k, species.green, std::max(0.04f, species.leaf_m * size));
    leaf.roughness = species.gloss;
    Material bark = plain("bark", {0.2f, 0.15f, 0.11f}, 0.9f);
    bark.pattern = Pattern::bark;
    bark.scale_m = 0.03f;
    bark.color_b = {0.09f, 0.065f, 0.05f};
    const int green = k.main(leaf);
    Foliage plant{k, species, size, green, k.material(plain("stem", species.green * 1.3f, 0.6f)), k.material(bark)};
    switch (species.habit) {
        case Habit::clump: plant.clump(y); break;
        case Habit::canes: plant.canes(y, false); break;
        case Habit::rosette: plant.canes(y, true); break;
        case Habit::fronds: plant.fronds(y); break;
        case Habit::tree: plant.crown(y); break;
    }
    k.add(std::move(plant.leaves), green);
    if (!plant.stems.positions.empty()) k.add(std::move(plant.stems), plant.stem);
}

}  // namespace fastscene::furniture
