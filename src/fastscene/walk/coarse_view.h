// Coarse view (the paper's coarse view synthesis, CVS): panoramas with range, rendered from another position. The paper
// splats single pixels; here the pixels are vertices of a mesh, so there are no cracks, and each target pixel casts its
// own ray, so that seam and poles need no special treatment.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/geometry/range_edges.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

inline constexpr std::int16_t kNoPlane = -1;

// A panorama prepared for warping.
struct WarpSource {
    ImageColor color;      // free of the other surface's color at silhouettes
    ImageF inverse_range;  // 1/metres
    ImageMask cuts;        // range_edges
    ImageMask share;       // Silhouettes::share; empty where not all pixels are used
    // cells (indexed by their top left pixel) whose surrounding sixteen pixels lie on one surface; empty if not all
    // pixels are used
    ImageMask inside;
    Image<std::int16_t> plane;  // index of the scene plane that a pixel lies on, or kNoPlane
    ImageMask used;             // pixels to draw; empty = all
    Vec3f position;             // in panorama 0's frame; all panoramas share its orientation
};
WarpSource make_warp_source(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& plane,
                            const ImageMask& used, Vec3f position);

enum class Cover : std::uint8_t {
    hole,
    front,
    back,    // the back of a surface: hides what is beyond
    bridge,  // a step between two surfaces across a shallow jump
    guess,   // a bridge across a deeper jump, drawn only over the outside and where nothing else is
};

struct CoarseView {
    ImageColor color;
    ImageF range;  // from the new position; +inf: nothing
    Image<std::int16_t> plane;
    Image<Cover> cover;
};
// Renders the sources from `position`, nearest surface first. Deterministic for any number of threads.
CoarseView coarse_view(const std::vector<WarpSource>& sources, EquirectSize size, Vec3f position);

// Stores only the used pixels of a source. What a viewpoint inpainted is a small part of its panorama, but every later
// viewpoint draws all earlier ones: packed, twenty of 4096 columns fit into the memory of one or two.
class PackedSource {
  public:
    explicit PackedSource(const WarpSource& source);  // `used` must not be empty
    // Restores the source in `into`; pixels outside `used` keep whatever `into` held before.
    void unpack(WarpSource& into) const;
    std::size_t pixels() const { return color_.size(); }

  private:
    struct Stretch {
        std::uint32_t begin, count;  // range of pixels in row-major order
    };
    int width_, height_;
    Vec3f position_;
    std::vector<Stretch> stretches_;
    std::vector<Vec3f> color_;
    std::vector<float> inverse_range_;
    std::vector<std::uint8_t> cuts_;
    std::vector<std::int16_t> plane_;
};
CoarseView coarse_view(const std::vector<PackedSource>& sources, EquirectSize size, Vec3f position);

// The same sampled at the centers of the four quarters of the marked pixels (top left, top right, bottom left, bottom
// right). Returns a single row of 4 x (marked pixels) samples in row-major order.
CoarseView quarters_view(const std::vector<WarpSource>& sources, const ImageMask& marked, Vec3f position);
CoarseView quarters_view(const std::vector<PackedSource>& sources, const ImageMask& marked, Vec3f position);

}  // namespace fastscene
