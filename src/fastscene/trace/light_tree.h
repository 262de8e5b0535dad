// Light tree: which of many small lights to ask from a place, drawn with a probability near what each gives there.
//
// A binary tree over all that shines, its nodes bounded by a box and a cone of directions (Conty Estevez and Kulla
// 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting"). On the way down a child is taken by power,
// distance and what the two cosines are within its bounds; what may shine on a place always has a chance, and what
// faces away from it has none. Lamps that stand apart are not known by a box about them all, so the way down begins at
// a few dozen nodes that are compact and are weighed one by one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

class LightTree {
  public:
    // A flat bit of something that shines.
    struct Emitter {
        Vec3f low, high;         // its box, metres
        Vec3f center;            // of gravity
        Vec3f normal;            // unit; it shines into the half space before it …
        bool two_sided = false;  // … or into both
        float power = 0;         // in any unit; 0: never drawn
    };
    explicit LightTree(const std::vector<Emitter>& emitters);

    struct SampledEmitter {
        int emitter = -1;  // -1: nothing shines here
        float probability = 0;
    };
    // `normal` of length 1: of the surface that is lit. `u`: uniform in [0, 1); emitters that lie together get numbers
    // that lie together.
    SampledEmitter draw(Vec3f position, Vec3f normal, float u) const;
    // With what chance draw() finds an emitter.
    float probability(int emitter, Vec3f position, Vec3f normal) const;

  private:
    struct Node {
        Vec3f center, half;                      // of the box and the ball about it; of a leaf: of gravity
        Vec3f axis;                              // of the cone
        float radius = 0, cosine = 1, sine = 0;  // cosine, sine: of the cone's half angle
        float power = 0;
        bool two_sided = false;
        std::int32_t emitter = -1;  // of a leaf
        std::int32_t second = -1;   // child; the first one is the next node
    };
    struct Shape;
    static Shape shape_of(const Emitter& emitter);
    std::int32_t build(std::vector<Shape>& shapes, std::size_t begin, std::size_t end, int depth);
    // About what a node gives to a place; 0 only where it gives nothing.
    static float importance(const Node& node, Vec3f position, Vec3f normal);
    // Of the first child.
    float first_share(std::int32_t node, Vec3f position, Vec3f normal) const;
    void choose_heads();

    static constexpr std::size_t kMostHeads = 32;
    using Shares = std::array<float, kMostHeads>;  // rising sums of the heads' importances
    Shares shares_of_heads(Vec3f position, Vec3f normal) const;

    // Where an emitter is found.
    struct Place {
        std::int32_t head = -1;  // of heads_; -1: not in the tree
        std::int32_t depth = 0;  // how many levels below it
        std::uint64_t path = 0;  // a bit a level, 1 = the second child
    };
    void find(std::int32_t node, Place place);

    std::vector<Node> nodes_;
    std::vector<std::int32_t> heads_;  // nodes, which together hold everything
    std::vector<Place> places_;        // by emitter
};

}  // namespace fastscene
