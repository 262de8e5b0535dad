// Coarse view (the paper's CVS): panoramas with range, seen from another position. The paper throws single
// pixels; here the pixels are the corners of a mesh, so there are no cracks, and every target pixel asks
// with its own ray, so seam and poles are places like any other.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/geometry/range_edges.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

inline constexpr std::int16_t kNoPlane = -1;

// A panorama made ready to be warped.
struct WarpSource {
    ImageColor color;      // at silhouettes cleaned of the other side's color
    ImageF inverse_range;  // 1/metres
    ImageMask cuts;        // range_edges
    ImageMask share;       // Silhouettes::share; empty where not all pixels are used
    ImageMask inside;  // cells (by their left top pixel) about which sixteen pixels lie on one surface; empty where not
                       // all are used
    Image<std::int16_t> plane;  // which plane of the scene a pixel lies on, or kNoPlane
    ImageMask used;             // pixels that take part; empty = all
    Vec3f position;             // in the frame of panorama 0; all panoramas have its orientation
};
WarpSource make_warp_source(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& plane,
                            const ImageMask& used, Vec3f position);

enum class Cover : std::uint8_t {
    hole,
    front,
    back,    // a surface seen from behind hides what lies beyond
    bridge,  // the step between two surfaces, stretched across a shallow jump
    guess,   // a bridge across a deeper jump, drawn only over the outside and where nothing is
};

struct CoarseView {
    ImageColor color;
    ImageF range;  // from the new position; +inf where nothing is
    Image<std::int16_t> plane;
    Image<Cover> cover;
};
// The sources as seen from `position`, the nearest surface winning. Deterministic for any number of threads.
CoarseView coarse_view(const std::vector<WarpSource>& sources, EquirectSize size, Vec3f position);

// The used pixels of a source and nothing else. What a viewpoint painted is a small part of its panorama, and all
// viewpoints before it are asked by each new one: packed, twenty of 4096 columns fit into the memory of one or two.
class PackedSource {
  public:
    explicit PackedSource(const WarpSource& source);  // `used` must not be empty
    // `into` becomes a source that warps as the packed one does; outside `used` it holds whatever it held before.
    void unpack(WarpSource& into) const;
    std::size_t pixels() const { return color_.size(); }

  private:
    struct Stretch {
        std::uint32_t begin, count;  // of pixels in the order of rows
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

// The same through the four quarters of the marked pixels (left top, right top, left bottom, right bottom), whose
// middles are looked at: a view of 4 x (marked pixels) columns in the order of rows, and one row.
CoarseView quarters_view(const std::vector<WarpSource>& sources, const ImageMask& marked, Vec3f position);
CoarseView quarters_view(const std::vector<PackedSource>& sources, const ImageMask& marked, Vec3f position);

}  // namespace fastscene
