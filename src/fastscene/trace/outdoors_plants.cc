#include "fastscene/trace/outdoors_plants.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/trace/noise.h"

namespace fastscene::outdoors {
namespace {

Vec3f random_direction(Random& random) {
    const float z = random.uniform(-1, 1), turn = random.uniform(0, 2 * kPi), r = std::sqrt(std::max(0.f, 1 - z * z));
    return {r * std::cos(turn), z, r * std::sin(turn)};
}

// A kite-shaped leaf from its stalk along `along`, facing `normal`, folded a little along its midrib.
void add_leaf(QuadMesh& mesh, Vec3f at, Vec3f along, Vec3f normal, float long_m, float wide_m, std::uint16_t paint) {
    along = normalize(along);
    const Vec3f across = normalize(cross(normal, along)), face = cross(along, across);
    const Vec3f middle = at + along * (0.45f * long_m) + face * (0.12f * wide_m);
    mesh.quad(at, middle + across * (0.5f * wide_m), at + along * long_m, middle - across * (0.5f * wide_m), paint);
}

// Half width of the crown at relative height t in 0..1.
float crown_profile(Crown crown, float t) {
    switch (crown) {
        case Crown::round: return std::sqrt(std::max(0.f, 1 - (2 * t - 1) * (2 * t - 1)));
        case Crown::ovate: return 1.75f * std::pow(t, 0.45f) * std::pow(std::max(0.f, 1 - t), 0.75f);
        case Crown::columnar: return std::pow(std::max(0.f, 4 * t * (1 - t)), 0.35f);
        case Crown::umbrella: return std::sqrt(std::max(0.f, 1 - t)) * smooth_step(0.f, 0.45f, t) * 1.3f;
    }
    return 0;
}

// Space colonization (Runions et al. 2007): buds compete for points that fill the crown.
struct Skeleton {
    struct Node {
        Vec3f at;
        int parent;
        int children = 0;
        float radius = 0;
    };
    std::vector<Node> nodes;
    float step = 0.25f;
};

std::vector<Vec3f> crown_points(const TreeKind& kind, std::uint32_t seed, Random& random) {
    constexpr int kPoints = 760;
    std::vector<Vec3f> points;
    const float tall = kind.height_m - kind.bare_m;
    for (int tries = 0; tries < 40 * kPoints && static_cast<int>(points.size()) < kPoints; ++tries) {
        const Vec3f q{random.uniform(-1, 1), random.uniform(), random.uniform(-1, 1)};
        const float turn = std::atan2(q.x, q.z);
        // Lobes make the outline uneven; gaps let the sky through.
        const float lobe = 0.62f +
                           0.76f * noise3({1.6f * std::cos(turn) + 5, 2.4f * q.y, 1.6f * std::sin(turn) + 5}, seed);
        const float r = std::hypot(q.x, q.z), limit = crown_profile(kind.crown, q.y) * std::min(1.f, lobe);
        if (r > limit) continue;
        if (noise3(q * 4.2f + Vec3f{9, 9, 9}, seed + 1) < 0.38f) continue;
        if (random.uniform() > 0.35f + 0.65f * r / std::max(0.1f, limit)) continue;
        points.push_back({q.x * kind.radius_m, kind.bare_m + q.y * tall, q.z * kind.radius_m});
    }
    return points;
}

void add_trunk(Skeleton& tree, const TreeKind& kind, Random& random) {
    Vec3f at{}, heading{0, 1, 0};
    tree.nodes.push_back({at, -1});
    while (at.y < kind.bare_m + 0.12f * (kind.height_m - kind.bare_m)) {
        heading = normalize(heading + random_direction(random) * (kind.lean * 0.3f) + Vec3f{0, 0.25f, 0});
        at += heading * tree.step;
        tree.nodes.push_back({at, static_cast<int>(tree.nodes.size()) - 1});
    }
}

Skeleton grow_skeleton(const TreeKind& kind, std::uint32_t seed) {
    constexpr int kMostNodes = 3200, kMostRounds = 140, kMostChildren = 3;
    Random random(seed, "outdoors.tree");
    Skeleton tree;
    tree.step = kind.height_m / 42.f;
    add_trunk(tree, kind, random);
    struct Point {
        Vec3f at;
        int nearest = 0;
        float far = 1e9f;
    };
    std::vector<Point> points;
    for (const Vec3f p : crown_points(kind, seed, random)) points.push_back({p});
    const float reached = 1.7f * tree.step;
    std::size_t known = 0;
    for (int round = 0; round < kMostRounds && !points.empty(); ++round) {
        for (Point& p : points)
            for (std::size_t n = known; n < tree.nodes.size(); ++n)
                if (const float far = length(p.at - tree.nodes[n].at);
                    far < p.far && tree.nodes[n].children < kMostChildren)
                    p.far = far, p.nearest = static_cast<int>(n);
        known = tree.nodes.size();
        std::erase_if(points, [&](const Point& p) { return p.far < reached; });
        std::vector<Vec3f> pull(known);
        for (const Point& p : points)
            pull[static_cast<std::size_t>(p.nearest)] += normalize(p.at -
                                                                   tree.nodes[static_cast<std::size_t>(p.nearest)].at);
        for (std::size_t n = 0; n < known; ++n) {
            if (!(dot(pull[n], pull[n]) > 0) || tree.nodes.size() >= kMostNodes) continue;
            if (tree.nodes[n].children >= kMostChildren) {
                // Full: its points stay empty.
                for (Point& p : points)
                    if (p.nearest == static_cast<int>(n)) p.far = 0;
                continue;
            }
            const Vec3f to = normalize(normalize(pull[n]) + random_direction(random) * 0.28f + Vec3f{0, 0.12f, 0});
            ++tree.nodes[n].children;
            tree.nodes.push_back({tree.nodes[n].at + to * tree.step, static_cast<int>(n)});
        }
        if (tree.nodes.size() == known) break;
    }
    // The pipe model: a branch is as thick as all that it feeds.
    constexpr float kTwig = 0.006f, kPipe = 2.35f;
    for (Skeleton::Node& n : tree.nodes) n.radius = 0;
    for (std::size_t n = tree.nodes.size(); n-- > 0;) {
        Skeleton::Node& node = tree.nodes[n];
        node.radius = node.radius > 0 ? std::pow(node.radius, 1 / kPipe) : kTwig;
        if (node.parent >= 0) tree.nodes[static_cast<std::size_t>(node.parent)].radius += std::pow(node.radius, kPipe);
    }
    return tree;
}

void add_branches(QuadMesh& mesh, const Skeleton& tree, std::uint16_t bark) {
    for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
        const Skeleton::Node& node = tree.nodes[n];
        const Skeleton::Node& parent = tree.nodes[static_cast<std::size_t>(node.parent)];
        const float flare = node.parent == 0 ? 1.45f : 1.f;
        const float from = std::min(parent.radius, 1.35f * node.radius) * flare;
        add_tube(mesh, parent.at, node.at, node.parent < 3 ? parent.radius * flare : from, node.radius,
                 node.radius > 0.06f   ? 8
                 : node.radius > 0.02f ? 5
                                       : 3,
                 bark);
    }
}

void add_foliage(QuadMesh& mesh, const Skeleton& tree, const TreeKind& kind, Random& random) {
    constexpr float kBearing = 0.02f;  // branches thinner than this bear leaves
    std::vector<std::size_t> bearing;
    for (std::size_t n = 1; n < tree.nodes.size(); ++n)
        if (tree.nodes[n].radius < kBearing) bearing.push_back(n);
    if (bearing.empty()) return;
    const float spread = tree.step;  // wider, and crowns lose the shape of their branches
    for (int k = 0; k < kind.leaves; ++k) {
        const Skeleton::Node& node =
            tree.nodes[bearing[static_cast<std::size_t>(random.index(static_cast<int>(bearing.size())))]];
        const Vec3f off = random_direction(random) * (spread * std::cbrt(random.uniform()));
        const Vec3f at = node.at + Vec3f{off.x, 0.7f * off.y, off.z};
        const Vec3f outward = normalize(Vec3f{node.at.x, 0, node.at.z});
        if (kind.needles) {
            const Vec3f axis = normalize(off + Vec3f{0, 0.5f * spread, 0});
            for (int i = 0; i < 4; ++i) {
                const Vec3f way = normalize(axis + random_direction(random) * 0.8f);
                add_leaf(mesh, at, way, random_direction(random), kind.leaf_m, 0.16f * kind.leaf_m, kNeedle);
            }
            continue;
        }
        const Vec3f normal = normalize(random_direction(random) + Vec3f{0, 0.7f, 0} + outward * 0.5f);
        const Vec3f along = cross(normal, random_direction(random)) + outward * 0.3f + Vec3f{0, -0.35f, 0};
        const float size = kind.leaf_m * random.uniform(0.7f, 1.2f);
        add_leaf(mesh, at, along - normal * dot(normal, along), normal, size, 0.62f * size, kLeaf);
    }
}

// Fine twigs, seen in winter only.
void add_twigs(QuadMesh& mesh, const Skeleton& tree, std::uint16_t bark, Random& random) {
    for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
        const Skeleton::Node& node = tree.nodes[n];
        if (node.radius > 0.02f) continue;
        const Vec3f along = normalize(node.at - tree.nodes[static_cast<std::size_t>(node.parent)].at);
        for (int k = 0; k < 3; ++k) {
            const Vec3f way = normalize(along + random_direction(random) * 0.9f + Vec3f{0, 0.3f, 0});
            const Vec3f tip = node.at + way * (tree.step * random.uniform(0.9f, 2.f));
            add_tube(mesh, node.at, tip, 0.006f, 0.003f, 3, bark);
        }
    }
}

}  // namespace

void add_tube(QuadMesh& mesh, Vec3f from, Vec3f to, float from_radius, float to_radius, int sides,
              std::uint16_t paint) {
    Vec3f s, t;
    const Vec3f axis = normalize(to - from);
    make_frame(axis, s, t);
    const auto rim = [&](Vec3f center, float radius, int k) {
        const float turn = 2 * kPi * static_cast<float>(k % sides) / static_cast<float>(sides);
        return center + s * (radius * std::cos(turn)) + t * (radius * std::sin(turn));
    };
    const Vec3f over = axis * (0.5f * to_radius);  // overlaps the next piece, so that bends do not gape
    for (int k = 0; k < sides; ++k)
        mesh.quad(rim(from, from_radius, k), rim(from, from_radius, k + 1), rim(to + over, to_radius, k + 1),
                  rim(to + over, to_radius, k), paint);
}

QuadMesh grow_tree(const TreeKind& kind, std::uint32_t seed, bool bare) {
    const Skeleton tree = grow_skeleton(kind, seed);
    QuadMesh mesh;
    Random random(seed, "outdoors.leaves");
    add_branches(mesh, tree, kind.bark);
    if (bare && !kind.needles) add_twigs(mesh, tree, kind.bark, random);
    else add_foliage(mesh, tree, kind, random);
    return mesh;
}

QuadMesh grow_spruce(float height, float radius, std::uint32_t seed) {
    Random random(seed, "outdoors.spruce");
    QuadMesh mesh;
    add_tube(mesh, {}, {0, 0.55f * height, 0}, 0.017f * height, 0.011f * height, 8, kBark);
    add_tube(mesh, {0, 0.55f * height, 0}, {0, height, 0}, 0.011f * height, 0.005f, 6, kBark);
    const float bare = random.uniform(0.03f, 0.09f) * height, between = height / 60;
    float turn = random.uniform(0, 2 * kPi);
    for (float y = bare; y < height - 0.1f; y += between * random.uniform(0.7f, 1.25f)) {
        const float t = (y - bare) / (height - bare);
        const float reach = radius * std::pow(1 - t, 0.85f) * smooth_step(-0.12f, 0.06f, t) *
                            random.uniform(0.78f, 1.1f);
        const int branches = 4 + random.index(3);
        for (int b = 0; b < branches; ++b) {
            turn += 2.4f + random.uniform(-0.4f, 0.4f);
            const float far = reach * random.uniform(0.7f, 1.12f) + 0.08f, droop = 0.5f * (1 - t);
            const Vec3f out{std::cos(turn), 0, std::sin(turn)}, side{-out.z, 0, out.x};
            // Sags, then turns up at the tip.
            const auto along = [&](float u) {
                return Vec3f{0, y, 0} + out * (u * far) +
                       Vec3f{0, far * (0.18f * u - droop * u * (1.25f - 0.75f * u)), 0};
            };
            add_tube(mesh, along(0), along(0.8f), 0.004f * far + 0.006f, 0.004f, 3, kBark);
            const int sprays = std::max(4, static_cast<int>(far * 22));
            for (int k = 0; k < sprays; ++k) {
                const float u = 0.12f + 0.88f * (static_cast<float>(k) + random.uniform()) / static_cast<float>(sprays);
                const float wide = (0.14f + 0.3f * (1 - u)) * std::min(1.f, far) * random.uniform(0.7f, 1.3f);
                for (const float hand : {-1.f, 1.f}) {
                    const Vec3f way = out * 0.75f + side * (hand * random.uniform(0.5f, 1.1f)) +
                                      Vec3f{0, random.uniform(-0.55f, 0.1f), 0};
                    add_leaf(mesh, along(u), way, Vec3f{random.uniform(-0.4f, 0.4f), 1, random.uniform(-0.4f, 0.4f)},
                             wide + 0.12f, 0.07f + 0.16f * wide, kNeedle);
                }
            }
        }
    }
    add_leaf(mesh, {0, height - 0.3f, 0}, {0, 1, 0}, {1, 0, 0}, 0.45f, 0.06f, kNeedle);
    return mesh;
}

QuadMesh grow_hedge(float long_m, float high, float thick, std::uint32_t seed) {
    Random random(seed, "outdoors.hedge");
    QuadMesh mesh;
    const float a = 0.5f * long_m, b = 0.5f * thick - 0.1f, top = high - 0.1f;
    const auto box = [&](Vec3f u, Vec3f v, Vec3f n) {
        mesh.quad(n - u - v, n + u - v, n + u + v, n - u + v, kDarkCore);
    };
    const Vec3f middle{0, 0.5f * top, 0};
    for (const float hand : {-1.f, 1.f}) {
        box({a, 0, 0}, {0, 0.5f * top, 0}, middle + Vec3f{0, 0, hand * b});
        box({0, 0, b}, {0, 0.5f * top, 0}, middle + Vec3f{hand * a, 0, 0});
    }
    box({a, 0, 0}, {0, 0, b}, {0, top, 0});
    constexpr float kLeaf_m = 0.055f, kPerSquareMetre = 2300;
    const float front = long_m * high, roof = long_m * thick, ends = thick * high, all = 2 * front + roof + 2 * ends;
    for (int k = 0; k < static_cast<int>(all * kPerSquareMetre * 0.62f); ++k) {
        const float which = random.uniform() * all, u = random.uniform(-a, a), w = random.uniform(-0.5f, 0.5f) * thick;
        Vec3f at, normal;
        if (which < 2 * front) {
            const float hand = which < front ? -1.f : 1.f;
            at = {u, random.uniform() * high, 0.5f * thick * hand}, normal = {0, 0.15f, hand};
        } else if (which < 2 * front + roof) {
            at = {u, high, w}, normal = {0, 1, 0};
        } else {
            const float hand = which < 2 * front + roof + ends ? -1.f : 1.f;
            at = {a * hand, random.uniform() * high, w}, normal = {hand, 0.15f, 0};
        }
        const float grown = 0.12f * (noise3(at * 2.1f, seed) - 0.5f) + 0.05f * random.normal();
        at += normalize(normal) * (grown - 0.02f);
        const Vec3f face = normalize(normal + random_direction(random) * 0.85f);
        add_leaf(mesh, at, cross(face, random_direction(random)), face, kLeaf_m * random.uniform(0.7f, 1.4f),
                 0.6f * kLeaf_m, kLeaf);
    }
    return mesh;
}

QuadMesh grow_shrub(float radius, float high, float leaf, float bloom, std::uint32_t seed) {
    Random random(seed, "outdoors.shrub");
    QuadMesh mesh;
    // A dark inside, so that one does not see through.
    constexpr int kAround = 10, kUp = 5;
    const auto on_core = [&](int i, int j) {
        const float turn = 2 * kPi * static_cast<float>(i % kAround) / kAround,
                    rise = 0.5f * kPi * static_cast<float>(j) / kUp;
        return Vec3f{0.66f * radius * std::cos(rise) * std::cos(turn), 0.66f * high * std::sin(rise),
                     0.66f * radius * std::cos(rise) * std::sin(turn)};
    };
    for (int j = 0; j < kUp; ++j)
        for (int i = 0; i < kAround; ++i)
            mesh.quad(on_core(i, j), on_core(i + 1, j), on_core(i + 1, j + 1), on_core(i, j + 1), kDarkCore);
    const int leaves = static_cast<int>(4.2f * kPi * radius * (radius + high) / (leaf * leaf));
    for (int k = 0; k < leaves; ++k) {
        Vec3f way = random_direction(random);
        way.y = std::abs(way.y);
        const float lobe = 0.7f + 0.6f * noise3(way * 2.4f + Vec3f{3, 3, 3}, seed);
        const float out = lobe * (0.74f + 0.3f * std::sqrt(random.uniform()));
        const Vec3f at{way.x * radius * out, way.y * high * out, way.z * radius * out};
        const Vec3f face = normalize(way + Vec3f{0, 0.3f, 0} + random_direction(random) * 0.7f);
        // Flowers come in bunches, at the outside.
        const bool flower = out > 0.86f * lobe && random.uniform() < 2 * bloom &&
                            noise3(way * 6.f + Vec3f{1, 5, 2}, seed + 3) > 0.5f;
        add_leaf(mesh, at, cross(face, random_direction(random)), face, leaf * random.uniform(0.7f, 1.25f),
                 (flower ? 0.9f : 0.55f) * leaf, flower ? kPetal : kPlainLeaf);
    }
    return mesh;
}

QuadMesh grow_perennial(float high, int stems, bool flowers, std::uint32_t seed) {
    Random random(seed, "outdoors.perennial");
    QuadMesh mesh;
    for (int k = 0; k < stems * 5; ++k) {
        const float turn = random.uniform(0, 2 * kPi), far = random.uniform(0.05f, 0.5f) * high;
        const Vec3f out{std::cos(turn), 0, std::sin(turn)}, foot = out * (0.3f * far);
        const Vec3f bend = foot + out * (0.5f * far) + Vec3f{0, high * random.uniform(0.3f, 0.6f), 0},
                    tip = bend + out * far + Vec3f{0, high * random.uniform(-0.1f, 0.2f), 0};
        const Vec3f across = Vec3f{-out.z, 0, out.x} * (0.012f + 0.012f * random.uniform());
        mesh.quad(foot - across * 0.5f, foot + across * 0.5f, bend + across, bend - across, kPlainLeaf);
        mesh.quad(bend - across, bend + across, tip, tip, kPlainLeaf);
    }
    for (int k = 0; flowers && k < stems; ++k) {
        const float turn = random.uniform(0, 2 * kPi), far = 0.45f * high * std::sqrt(random.uniform());
        const Vec3f head{far * std::cos(turn), high * random.uniform(0.75f, 1.15f), far * std::sin(turn)};
        add_tube(mesh, head * 0.25f - Vec3f{0, 0.25f * head.y, 0}, head, 0.003f, 0.002f, 3, kPlainLeaf);
        const Vec3f face = normalize(Vec3f{0, 1, 0} + random_direction(random) * 0.7f);
        Vec3f s, t;
        make_frame(face, s, t);
        const int petals = 6;
        for (int i = 0; i < petals; ++i) {
            const float at = 2 * kPi * static_cast<float>(i) / petals;
            const Vec3f way = s * std::cos(at) + t * std::sin(at) + face * random.uniform(-0.1f, 0.5f);
            add_leaf(mesh, head, way, face, random.uniform(0.03f, 0.045f), 0.03f, kPetal);
        }
    }
    return mesh;
}

QuadMesh grow_fern(std::uint32_t seed) {
    Random random(seed, "outdoors.fern");
    QuadMesh mesh;
    const int fronds = 9;
    for (int f = 0; f < fronds; ++f) {
        const float turn = 2 * kPi * (static_cast<float>(f) + random.uniform(-0.3f, 0.3f)) / fronds,
                    far = random.uniform(0.45f, 0.75f);
        const Vec3f out{std::cos(turn), 0, std::sin(turn)}, side{-out.z, 0, out.x};
        constexpr int kPairs = 15;
        for (int k = 1; k <= kPairs; ++k) {
            const float u = static_cast<float>(k) / kPairs,
                        wide = 0.22f * far * std::sin(kPi * (0.12f + 0.88f * u)) + 0.01f;
            const Vec3f at = out * (far * u) + Vec3f{0, far * (1.3f * u - 1.05f * u * u), 0};
            for (const float hand : {-1.f, 1.f})
                add_leaf(mesh, at, side * hand + out * 0.45f + Vec3f{0, -0.15f, 0}, {0, 1, 0}, wide, 0.035f,
                         kPlainLeaf);
        }
    }
    return mesh;
}

void add_blade(QuadMesh& mesh, Vec3f foot, float high, float width, Random& random) {
    const float turn = random.uniform(0, 2 * kPi), lean = random.uniform(0.05f, 0.75f) * high,
                tall = high * random.uniform(0.55f, 1.15f);
    const Vec3f out{std::cos(turn), 0, std::sin(turn)}, across = Vec3f{-out.z, 0, out.x} * (0.5f * width);
    const Vec3f bend = foot + out * (0.3f * lean) + Vec3f{0, 0.65f * tall, 0},
                tip = foot + out * lean + Vec3f{0, tall, 0};
    mesh.quad(foot - across, foot + across, bend + across * 0.8f, bend - across * 0.8f, kGrass);
    mesh.quad(bend - across * 0.8f, bend + across * 0.8f, tip, tip, kGrass);
}

QuadMesh grow_grass(float side_m, int blades, float high, float width, std::uint32_t seed) {
    Random random(seed, "outdoors.grass");
    QuadMesh mesh;
    for (int k = 0; k < blades; ++k)
        add_blade(mesh, {random.uniform(-0.5f, 0.5f) * side_m, 0, random.uniform(-0.5f, 0.5f) * side_m}, high, width,
                  random);
    return mesh;
}

}  // namespace fastscene::outdoors
