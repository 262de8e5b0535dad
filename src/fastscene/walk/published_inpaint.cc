#include "fastscene/walk/published_inpaint.h"

#include <algorithm>

namespace fastscene {
namespace {

constexpr int kMeantForTwice = 2;  // the official inverse mapping assumes super-resolved faces of twice the size

ImageColor unit_of(const ImageRgb8& image) {
    ImageColor out(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), out.pixels.begin(), [](Rgb8 c) {
        return Vec3f{static_cast<float>(c.r) / 255.f, static_cast<float>(c.g) / 255.f, static_cast<float>(c.b) / 255.f};
    });
    return out;
}
std::uint8_t cut_to_byte(float v) { return static_cast<std::uint8_t>(std::clamp(v * 255.f, 0.f, 255.f)); }
Rgb8 cut_to_bytes(Vec3f c) { return {cut_to_byte(c.x), cut_to_byte(c.y), cut_to_byte(c.z)}; }

}  // namespace

std::array<ImageMask, 6> published_hole_faces(const ImageMask& hole, int face_size) {
    ImageF mask(hole.width, hole.height);
    std::transform(hole.pixels.begin(), hole.pixels.end(), mask.pixels.begin(),
                   [](std::uint8_t v) { return v ? 1.f : 0.f; });
    std::array<ImageMask, 6> faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const ImageF touched = published_face(mask, kPublishedFaces[f], face_size);
        faces[f] = ImageMask(face_size, face_size);
        std::transform(touched.pixels.begin(), touched.pixels.end(), faces[f].pixels.begin(),
                       [](float v) { return v > 0.f ? std::uint8_t{255} : std::uint8_t{0}; });
    }
    return faces;
}

std::array<PublishedFace, 6> published_faces(const ImageRgb8& color, const ImageMask& hole, int face_size) {
    FASTSCENE_CHECK(color.same_size(hole));
    const ImageColor unit = unit_of(color);
    std::array<ImageMask, 6> holes = published_hole_faces(hole, face_size);
    std::array<PublishedFace, 6> faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const ImageColor face = published_face(unit, kPublishedFaces[f], face_size);
        faces[f] = {ImageRgb8(face_size, face_size), std::move(holes[f])};
        for (std::size_t i = 0; i < face.size(); ++i)
            faces[f].color.pixels[i] = faces[f].hole.pixels[i] ? Rgb8{255, 255, 255} : cut_to_bytes(face.pixels[i]);
    }
    return faces;
}

ImageRgb8 published_merge(const ImageRgb8& color, const ImageMask& hole, const std::array<ImageRgb8, 6>& painted) {
    std::array<ImageColor, 6> faces;
    std::transform(painted.begin(), painted.end(), faces.begin(), unit_of);
    const ImageColor all = published_equirect(faces, kMeantForTwice * painted[0].width, color.height);
    ImageRgb8 out = color;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (hole.pixels[i]) out.pixels[i] = cut_to_bytes(all.pixels[i]);
    return out;
}

ImageRgb8 published_inpaint(const ImageRgb8& color, const ImageMask& hole, int face_size, const Painter& paint) {
    std::array<ImageRgb8, 6> painted;
    const auto faces = published_faces(color, hole, face_size);
    for (std::size_t f = 0; f < faces.size(); ++f) painted[f] = paint(faces[f].color, faces[f].hole);
    return published_merge(color, hole, painted);
}

}  // namespace fastscene
