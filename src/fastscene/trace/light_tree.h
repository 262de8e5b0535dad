// Light tree: samples one of many small lights with a probability roughly proportional to its contribution at a point.
//
// A binary tree over all emitters whose nodes are bounded by a box and a cone of normals (Conty Estevez and Kulla 2018,
// "Importance Sampling of Many Lights with Adaptive Tree Splitting"). Traversal picks a child by power, distance and
// bounds of the two cosines; every light that can reach the point has a nonzero probability, and lights that face away
// have none. A bounding box around distant lamps says little, so traversal starts from a few dozen compact nodes that
// are weighted one by one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

class LightTree {
  public:
    // A flat emitter: a lamp's triangle or a window.
    struct Emitter {
        Vec3f low, high;         // bounding box, metres
        Vec3f center;            // centroid
        Vec3f normal;            // unit; it emits into the half space in front of it …
        bool two_sided = false;  // … or into both
        float power = 0;         // in any unit; 0: never sampled
    };
    explicit LightTree(const std::vector<Emitter>& emitters);

    struct SampledEmitter {
        int emitter = -1;  // -1: no light reaches this point
        float probability = 0;
    };
    // Samples an emitter for a point on a surface with the unit normal `normal`. `u`: uniform in [0, 1); neighbouring
    // emitters map to neighbouring values.
    SampledEmitter draw(Vec3f position, Vec3f normal, float u) const;
    // The probability with which draw() returns `emitter`.
    float probability(int emitter, Vec3f position, Vec3f normal) const;

    struct Node {
        Vec3f center, half;                      // of the bounding box and the ball around it; of a leaf: the centroid
        Vec3f axis;                              // cone of normals
        float radius = 0, cosine = 1, sine = 0;  // cosine, sine: of the cone's half angle
        float power = 0;
        bool two_sided = false;
        std::int32_t emitter = -1;  // leaves only
        std::int32_t second = -1;   // index of the second child; the first child is the next node
    };
    // Where an emitter is stored.
    struct Place {
        std::int32_t head = -1;  // index into heads(); -1: not in the tree
        std::int32_t depth = 0;  // levels below the head
        std::uint64_t path = 0;  // one bit per level, 1 = second child
    };
    static constexpr std::size_t kMostHeads = 32;
    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<std::int32_t>& heads() const { return heads_; }  // traversal starts at these nodes
    const std::vector<Place>& places() const { return places_; }       // by emitter

  private:
    struct Shape;
    static Shape shape_of(const Emitter& emitter);
    std::int32_t build(std::vector<Shape>& shapes, std::size_t begin, std::size_t end, int depth);
    // Estimated contribution of a node at a point; 0 only where it cannot contribute.
    static float importance(const Node& node, Vec3f position, Vec3f normal);
    // The probability of the first child.
    float first_share(std::int32_t node, Vec3f position, Vec3f normal) const;
    void choose_heads();

    using Shares = std::array<float, kMostHeads>;  // cumulative importances of the heads
    Shares shares_of_heads(Vec3f position, Vec3f normal) const;

    void find(std::int32_t node, Place place);

    std::vector<Node> nodes_;
    std::vector<std::int32_t> heads_;  // together these nodes cover the tree
    std::vector<Place> places_;
};

}  // namespace fastscene
