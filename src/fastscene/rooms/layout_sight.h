// Sight: how much of a piece is seen from a point, by a few rays to its triangles past those of all others. What boxes
// say of that (Layout::likely_hidden) is cheap and kind: a lamp's box is mostly air, and a book behind the edge of a
// shelf is in no box.
#pragma once

#include <vector>

#include "fastscene/rooms/layout.h"

namespace fastscene {

class Sight {
  public:
    // Of these pieces in these poses: both are referred to. Poses may change, pieces not.
    Sight(const Plan& plan, const std::vector<Placed>& placed);

    struct View {
        float pixels = 0;         // of a panorama of 512 x 256, about; what is large is counted no further than kMany
        float share = 0;          // of what faces the eye, how much is seen: 0 … 1
        std::vector<int> hiders;  // the pieces before it, what hides most first
    };
    static constexpr float kMany = 60.f;
    View look(int piece, Vec3f eye) const;

  private:
    struct Box {
        Vec3f low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
    };
    // A piece in its own frame.
    struct Body {
        Box box;
        std::vector<Box> meshes;
    };
    int hider(int own, Vec3f eye,
              Vec3f target) const;  // a piece before a point of `own`, itself first; -1: none; -2: a wall
    bool stops(std::size_t piece, Vec3f eye, Vec3f target) const;

    const Plan& plan_;
    const std::vector<Placed>& placed_;
    std::vector<Body> bodies_;
    std::vector<Footprint> blocks_;
};

}  // namespace fastscene
