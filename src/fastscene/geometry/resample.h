// Resampling between any pictures of the sphere (equirectangular, cubemap, perspective), at any size and orientation. A
// plan is computed once per pair of geometries and applied to any number of pictures: a sparse matrix, most rows of
// which are four neighbouring pixels. Where target pixels are larger than the source's, the area filter averages over
// the whole pixel. Columns wrap, rows continue across the poles, and cube faces continue in their neighbours.
#pragma once

#include <array>
#include <vector>

#include "fastscene/geometry/cubemap.h"

namespace fastscene {

// The geometry of a spherical picture. Its frame: x right, y down, z forward (conventions.md).
struct SpherePicture {
    enum class Kind : std::uint8_t { equirect, cube, perspective } kind = Kind::equirect;
    int width = 0, height = 0;  // of the whole picture; a cubemap stacks its six faces (kCubeFaces) vertically
    Pinhole camera;             // of a face, or of the perspective picture
    Mat3f world_from_picture{};
};
SpherePicture equirect_picture(EquirectSize size, const Mat3f& world_from_picture = {});
// Square faces; with a field of view above 90 degrees they overlap.
SpherePicture cube_picture(int face_size, float fov_deg = 90.f, const Mat3f& world_from_picture = {});
SpherePicture perspective_picture(const Pinhole& camera, const Mat3f& world_from_camera = {});

enum class Filter : std::uint8_t {
    bilinear,
    bicubic,  // Catmull-Rom: sharper, may overshoot
    // bilinear at the pixel's center, whatever its size: for pictures of similar scale, and for comparison with other
    // programs
    point,
    area,  // mean over the target pixel's area; bilinear where the target is finer
};

class ResamplePlan {
  public:
    // feather_deg (overlapping cube sources): width of the band along face borders in which faces are blended; 0 = each
    // pixel from the face that contains it. Pictures must not be empty; cameras need a field of view below 180 degrees,
    // and a cube's at least 90.
    ResamplePlan(const SpherePicture& source, const SpherePicture& target, Filter filter, float feather_deg = 0);

    // Pixels that the source does not show (perspective sources only) become T{}. The source must have the planned
    // size.
    ImageColor apply(const ImageColor& source) const;
    // For range maps: if an infinite (sky) or NaN value contributes, takes the pixel with the largest weight.
    ImageF apply(const ImageF& source) const;
    void apply_to(const ImageColor& source,
                  ImageColor& out) const;  // `out` must have the planned size: nothing is allocated
    // Nonzero where the source shows the pixel.
    ImageMask covered() const;
    // For comparison with other libraries: where pixel (x, y) samples the source, pixel centers at +0.5; NaN for rows
    // with more than one sample.
    Vec2f place(int x, int y) const;

  private:
    // Four (bicubic: sixteen) neighbouring pixels around a position, in 1/65536 of a pixel; or row -1 - first of
    // `begin_`.
    struct Quad {
        std::int32_t first;  // top left of the middle four
        std::uint16_t u, v;
    };
    struct Tap {
        std::int32_t pixel;
        float weight;
    };
    struct Build;
    template <class T>
    T general(const Image<T>& source, const Quad& quad) const;
    float heaviest(const ImageF& source, const Quad& quad) const;

    int source_width_, source_height_, width_, height_;
    bool cubic_;
    std::vector<Quad> quads_;
    std::vector<std::uint32_t> begin_;
    std::vector<Tap> taps_;
};

}  // namespace fastscene
