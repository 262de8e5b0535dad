#include "fastscene/trace/vulkan/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "fastscene/base/check.h"
#include "fastscene/base/parallel.h"
#include "fastscene/trace/response.h"

namespace fastscene::vulkan {
namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kLeafTriangles = 3;  // three bits of a slot
constexpr int kEvenDepth = 26;               // from here on nodes are halved by count, which bounds the depth
constexpr float kCostOfNode = 1.f;           // of a box, against a triangle's 1
// Boxes are this much larger (metres), since the slab test rounds: walls are flat.
constexpr float kPad_m = 1e-5f;

struct Box {
    Vec3f low{1e30f, 1e30f, 1e30f}, high{-1e30f, -1e30f, -1e30f};
    void add(Vec3f p) {
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    }
    void add(const Box& b) { add(b.low), add(b.high); }
    float area() const {
        const Vec3f d = high - low;
        return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

// A node of the binary tree that the wide one is made of.
struct Binary {
    Box box;
    std::int32_t first = -1, second = -1;  // children; none: a leaf
    std::uint32_t begin = 0, end = 0;      // of a leaf: its triangles
};

struct Part {
    Box box;
    Vec3f middle;
    std::uint32_t triangle;
};

class Builder {
  public:
    Builder(std::vector<Part>& parts, std::vector<Binary>& nodes) : parts_(parts), nodes_(nodes) {}

    // Splits [begin, end) once; the middle, or begin: a leaf.
    std::uint32_t split(std::uint32_t begin, std::uint32_t end, const Box& box, int depth) const {
        const std::uint32_t count = end - begin;
        if (count <= 1) return begin;
        Box middles;
        for (std::uint32_t i = begin; i < end; ++i) middles.add(parts_[i].middle);
        const auto first = parts_.begin() + begin, last = parts_.begin() + end;
        float best = std::numeric_limits<float>::infinity();
        std::size_t best_axis = 0;
        int best_bin = -1;
        for (std::size_t axis = 0; axis < 3 && depth < kEvenDepth; ++axis) {
            const float low = middles.low[axis], extent = middles.high[axis] - low;
            if (!(extent > 1e-7f)) continue;
            std::array<Box, kBins> bins{}, after{};
            std::array<std::uint32_t, kBins> counts{};
            for (std::uint32_t i = begin; i < end; ++i) {
                const auto k = static_cast<std::size_t>(bin_of(parts_[i].middle[axis], low, extent));
                bins[k].add(parts_[i].box), ++counts[k];
            }
            for (std::size_t k = kBins - 1; k > 0; --k) {
                after[k - 1] = after[k];
                if (counts[k]) after[k - 1].add(bins[k]);
            }
            Box before;
            std::uint32_t passed = 0;
            for (std::size_t k = 0; k + 1 < kBins; ++k) {
                if (counts[k]) before.add(bins[k]);
                passed += counts[k];
                if (passed == 0 || passed == count) continue;
                const float cost = before.area() * static_cast<float>(passed) +
                                   after[k].area() * static_cast<float>(count - passed);
                if (cost < best) best = cost, best_axis = axis, best_bin = static_cast<int>(k);
            }
        }
        if (count <= kLeafTriangles && !(best + kCostOfNode * box.area() < static_cast<float>(count) * box.area()))
            return begin;
        if (best_bin >= 0) {
            const float low = middles.low[best_axis], extent = middles.high[best_axis] - low;
            return static_cast<std::uint32_t>(
                std::partition(first, last,
                               [&](const Part& p) { return bin_of(p.middle[best_axis], low, extent) <= best_bin; }) -
                parts_.begin());
        }
        const Vec3f d = middles.high - middles.low;
        const std::size_t axis = d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
        const std::uint32_t middle = begin + count / 2;
        std::nth_element(first, parts_.begin() + middle, last,
                         [axis](const Part& a, const Part& b) { return a.middle[axis] < b.middle[axis]; });
        return middle;
    }
    Box box_of(std::uint32_t begin, std::uint32_t end) const {
        Box box;
        for (std::uint32_t i = begin; i < end; ++i) box.add(parts_[i].box);
        return box;
    }
    // A whole subtree; returns its root.
    std::int32_t build(std::uint32_t begin, std::uint32_t end, int depth) {
        const auto index = static_cast<std::int32_t>(nodes_.size());
        nodes_.push_back({box_of(begin, end), -1, -1, begin, end});
        const std::uint32_t middle = split(begin, end, nodes_.back().box, depth);
        if (middle == begin) return index;
        const std::int32_t first = build(begin, middle, depth + 1), second = build(middle, end, depth + 1);
        nodes_[static_cast<std::size_t>(index)].first = first, nodes_[static_cast<std::size_t>(index)].second = second;
        return index;
    }

  private:
    static int bin_of(float v, float low, float extent) {
        return std::clamp(static_cast<int>(kBins * (v - low) / extent), 0, kBins - 1);
    }
    std::vector<Part>& parts_;
    std::vector<Binary>& nodes_;
};

// The binary tree: its top is split one node after the other, the rest in parallel.
std::vector<Binary> build_binary(std::vector<Part>& parts) {
    constexpr std::uint32_t kJob = 4096;  // triangles
    std::vector<Binary> nodes;
    Builder top(parts, nodes);
    struct Job {
        std::int32_t node;
        int depth;
    };
    std::vector<Job> open{{0, 0}}, jobs;
    nodes.push_back(
        {top.box_of(0, static_cast<std::uint32_t>(parts.size())), -1, -1, 0, static_cast<std::uint32_t>(parts.size())});
    while (!open.empty()) {
        const Job job = open.back();
        open.pop_back();
        const Binary node = nodes[static_cast<std::size_t>(job.node)];
        if (node.end - node.begin <= kJob) {
            jobs.push_back(job);
            continue;
        }
        const std::uint32_t middle = top.split(node.begin, node.end, node.box, job.depth);
        const auto first = static_cast<std::int32_t>(nodes.size());
        nodes.push_back({top.box_of(node.begin, middle), -1, -1, node.begin, middle});
        nodes.push_back({top.box_of(middle, node.end), -1, -1, middle, node.end});
        nodes[static_cast<std::size_t>(job.node)].first = first;
        nodes[static_cast<std::size_t>(job.node)].second = first + 1;
        open.push_back({first, job.depth + 1}), open.push_back({first + 1, job.depth + 1});
    }
    std::vector<std::vector<Binary>> trees(jobs.size());
    parallel_for(static_cast<std::int64_t>(jobs.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (auto j = static_cast<std::size_t>(begin); j < static_cast<std::size_t>(end); ++j) {
            const Binary& node = nodes[static_cast<std::size_t>(jobs[j].node)];
            Builder(parts, trees[j]).build(node.begin, node.end, jobs[j].depth);
        }
    });
    for (std::size_t j = 0; j < jobs.size(); ++j) {
        // The root takes the place that is there, the others follow.
        const auto shift = static_cast<std::int32_t>(nodes.size()) - 1;
        const auto moved = [shift](Binary b) {
            if (b.first >= 0) b.first += shift, b.second += shift;
            return b;
        };
        nodes[static_cast<std::size_t>(jobs[j].node)] = moved(trees[j].front());
        for (std::size_t i = 1; i < trees[j].size(); ++i) nodes.push_back(moved(trees[j][i]));
    }
    return nodes;
}

// Which slot each child takes: the one whose octant looks most towards it from the node's middle, greedily.
std::array<int, 8> slots_of(const std::array<Vec3f, 8>& ways, int count) {
    std::array<int, 8> slot{};
    slot.fill(-1);
    std::array<bool, 8> taken{};
    for (int round = 0; round < count; ++round) {
        float best = -std::numeric_limits<float>::infinity();
        int child = 0, place = 0;
        for (int c = 0; c < count; ++c) {
            if (slot[static_cast<std::size_t>(c)] >= 0) continue;
            for (int s = 0; s < 8; ++s) {
                if (taken[static_cast<std::size_t>(s)]) continue;
                const Vec3f octant{s & 4 ? 1.f : -1.f, s & 2 ? 1.f : -1.f, s & 1 ? 1.f : -1.f};
                const float gain = dot(ways[static_cast<std::size_t>(c)], octant);
                if (gain > best) best = gain, child = c, place = s;
            }
        }
        slot[static_cast<std::size_t>(child)] = place;
        taken[static_cast<std::size_t>(place)] = true;
    }
    return slot;
}

class Widener {
  public:
    Widener(const std::vector<Binary>& from, const std::vector<Part>& parts, const std::vector<BvhTriangle>& all,
            Bvh& out)
        : from_(from), parts_(parts), all_(all), out_(out) {}

    void run() {
        out_.nodes.emplace_back();
        write(0, 0, 1);
    }

  private:
    bool is_leaf(std::int32_t node) const { return from_[static_cast<std::size_t>(node)].first < 0; }
    const Box& box(std::int32_t node) const { return from_[static_cast<std::size_t>(node)].box; }

    // Writes the wide node `place` for the binary node `node`, and all below.
    void write(std::int32_t node, std::size_t place, int depth) {
        FASTSCENE_CHECK(depth <= kMostBvhLevels);
        out_.depth = std::max(out_.depth, depth);
        std::vector<std::int32_t> children;
        if (is_leaf(node)) children = {node};
        else children = {from_[static_cast<std::size_t>(node)].first, from_[static_cast<std::size_t>(node)].second};
        while (children.size() < 8) {  // opens the largest
            std::size_t largest = children.size();
            for (std::size_t i = 0; i < children.size(); ++i)
                if (!is_leaf(children[i]) &&
                    (largest == children.size() || box(children[i]).area() > box(children[largest]).area()))
                    largest = i;
            if (largest == children.size()) break;
            const Binary& opened = from_[static_cast<std::size_t>(children[largest])];
            children[largest] = opened.first;
            children.push_back(opened.second);
        }
        const int count = static_cast<int>(children.size());
        Box whole;
        for (const std::int32_t c : children) whole.add(box(c));
        for (std::size_t a = 0; a < 3; ++a) whole.low[a] -= 2 * kPad_m, whole.high[a] += 2 * kPad_m;
        std::array<Vec3f, 8> ways{};
        for (int c = 0; c < count; ++c) {
            const Box& b = box(children[static_cast<std::size_t>(c)]);
            ways[static_cast<std::size_t>(c)] = b.low + b.high - whole.low - whole.high;
        }
        const std::array<int, 8> slot = slots_of(ways, count);
        std::array<std::int32_t, 8> child_of{};
        child_of.fill(-1);
        for (int c = 0; c < count; ++c)
            child_of[static_cast<std::size_t>(slot[static_cast<std::size_t>(c)])] =
                children[static_cast<std::size_t>(c)];

        BvhNode n{};
        std::array<float, 3> step{};
        for (std::size_t a = 0; a < 3; ++a) {
            n[a] = std::bit_cast<std::uint32_t>(whole.low[a]);
            int exponent = static_cast<int>(std::ceil(std::log2((whole.high[a] - whole.low[a]) / 254.f)));
            exponent = std::clamp(exponent, -100, 100);
            step[a] = std::exp2(static_cast<float>(exponent));
            n[3] |= static_cast<std::uint32_t>(exponent + 127) << (8 * a);
        }
        const auto set_byte = [&n](std::size_t word, std::size_t s, std::uint32_t value) {
            n[word + s / 4] |= value << (8 * (s % 4));
        };
        std::uint32_t inner = 0, triangles = 0;
        n[4] = static_cast<std::uint32_t>(out_.nodes.size()), n[5] = static_cast<std::uint32_t>(out_.triangles.size());
        for (std::size_t s = 0; s < 8; ++s) {
            const std::int32_t c = child_of[s];
            if (c < 0) continue;
            const Binary& child = from_[static_cast<std::size_t>(c)];
            for (std::size_t a = 0; a < 3; ++a) {
                const float low = std::floor((child.box.low[a] - kPad_m - whole.low[a]) / step[a]),
                            high = std::ceil((child.box.high[a] + kPad_m - whole.low[a]) / step[a]);
                set_byte(8 + 2 * a, s, static_cast<std::uint32_t>(std::clamp(low, 0.f, 255.f)));
                set_byte(14 + 2 * a, s, static_cast<std::uint32_t>(std::clamp(high, 0.f, 255.f)));
            }
            if (child.first >= 0) {
                n[3] |= 1u << (24 + s);
                set_byte(6, s, 0x20u | (24u + static_cast<std::uint32_t>(s)));
                ++inner;
            } else {
                const std::uint32_t held = child.end - child.begin;
                set_byte(6, s, ((1u << held) - 1) << 5 | triangles);
                for (std::uint32_t i = child.begin; i < child.end; ++i)
                    out_.triangles.push_back(all_[parts_[i].triangle]);
                triangles += held;
            }
        }
        const std::size_t first = out_.nodes.size();
        out_.nodes[place] = n;
        out_.nodes.resize(first + inner);
        std::size_t next = first;
        for (std::size_t s = 0; s < 8; ++s)
            if (child_of[s] >= 0 && !is_leaf(child_of[s])) write(child_of[s], next++, depth + 1);
    }

    const std::vector<Binary>& from_;
    const std::vector<Part>& parts_;
    const std::vector<BvhTriangle>& all_;
    Bvh& out_;
};

}  // namespace

Bvh build_bvh(const Room& room) {
    std::vector<BvhTriangle> all;
    std::vector<Part> parts;
    std::uint32_t id = 0;
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const Mesh& mesh = room.meshes[m];
        const std::uint32_t clear = lets_light_pass(room.materials[static_cast<std::size_t>(mesh.material)]) ? 1 : 0;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3, ++id) {
            const auto corner = [&](std::size_t k) { return mesh.positions[mesh.triangles[t + k]]; };
            Part part{{}, {}, static_cast<std::uint32_t>(all.size())};
            all.push_back({{corner(0), corner(1), corner(2)}, id, static_cast<std::uint32_t>(m), clear});
            for (const Vec3f p : all.back().corners) part.box.add(p);
            part.middle = (part.box.low + part.box.high) * 0.5f;
            parts.push_back(part);
        }
    }
    Bvh out;
    if (parts.empty()) {
        out.nodes.emplace_back();
        return out;
    }
    out.triangles.reserve(all.size()), out.nodes.reserve(all.size() / 4 + 1);
    const std::vector<Binary> binary = build_binary(parts);
    Widener(binary, parts, all, out).run();
    return out;
}

}  // namespace fastscene::vulkan
