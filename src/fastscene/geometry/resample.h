// Resample: any picture of the sphere (equirectangular, cubemap, perspective) from any other, at any size and
// orientation. A plan is worked out once for a pair of pictures and then applied to as many as there are: it is a
// sparse matrix whose rows are mostly four neighbouring pixels. Where target pixels are larger than the source's,
// samples over the whole pixel are averaged: shrinking does not skip, but with the filter that says so. Columns wrap,
// rows go on over the poles, and cube faces go on in their neighbours.
#pragma once

#include <array>
#include <vector>

#include "fastscene/geometry/cubemap.h"

namespace fastscene {

// A picture of directions. Frame of the picture: x right, y down, z forward (conventions.md).
struct SpherePicture {
    enum class Kind : std::uint8_t { equirect, cube, perspective } kind = Kind::equirect;
    int width = 0, height = 0;  // of the whole picture; a cube is its six faces (kCubeFaces) below each other
    Pinhole camera;             // of a face, or of the perspective picture
    Mat3f world_from_picture{};
};
SpherePicture equirect_picture(EquirectSize size, const Mat3f& world_from_picture = {});
// Faces that look farther than 90 degrees overlap. Square.
SpherePicture cube_picture(int face_size, float fov_deg = 90.f, const Mat3f& world_from_picture = {});
SpherePicture perspective_picture(const Pinhole& camera, const Mat3f& world_from_camera = {});

enum class Filter : std::uint8_t {
    bilinear,
    bicubic,  // Catmull-Rom: sharper, may overshoot
    point,  // bilinear at the pixel's center, whatever its size: for pictures of like scale, and to compare with other
            // programs
    area,   // the mean of the source over the target's pixel; bilinear where the target is finer
};

class ResamplePlan {
  public:
    // feather_deg (cube sources that overlap): width of the band along a face's border in which faces are blended;
    // 0 = each pixel from the face it looks through. Pictures of one pixel and more; cameras that look less than 180
    // degrees far, and a cube's at least 90.
    ResamplePlan(const SpherePicture& source, const SpherePicture& target, Filter filter, float feather_deg = 0);

    // Pixels that the source does not show (perspective sources only) become T{}. The source must have the planned
    // size.
    ImageColor apply(const ImageColor& source) const;
    // Of a range map: where something infinite (the sky) or NaN takes part, the pixel that has the most part in it.
    ImageF apply(const ImageF& source) const;
    void apply_to(const ImageColor& source,
                  ImageColor& out) const;  // `out` of the planned size: no memory is asked for
    // Nonzero where the source shows the pixel.
    ImageMask covered() const;
    // Fixed point view for those who compare with other libraries: where pixel (x, y) samples the source, pixel centers
    // at +0.5; NaN for rows that are more than one place.
    Vec2f place(int x, int y) const;

  private:
    // Four (bicubic: sixteen) neighbouring pixels about a place, in 1/65536 of a pixel; or row -1 - first of `begin_`.
    struct Quad {
        std::int32_t first;  // upper left of the middle four
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
