#include "fastscene/geometry/published_cube.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "fastscene/base/parallel.h"

namespace fastscene {
namespace {

Vec3d in_double(Vec3f v) { return {v.x, v.y, v.z}; }
Mat3d rotation_of(CubeFace face) {
    const Mat3f m = pano_from_face(face);
    return {in_double(m.row0), in_double(m.row1), in_double(m.row2)};
}

// For picture -> faces, rotations are built from single-precision angles, 4e-8 off; near a pole that is visible.
Mat3d published_rotation(CubeFace face) {
    const double quarter = static_cast<float>(std::numbers::pi / 2), half = static_cast<float>(std::numbers::pi);
    const auto in_single = [](double v) { return static_cast<double>(static_cast<float>(v)); };
    const auto about_y = [&](double angle) -> Mat3d {
        const double c = in_single(std::cos(angle)), s = in_single(std::sin(angle));
        return {{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
    };
    const auto about_x = [&](double angle) -> Mat3d {
        const double c = in_single(std::cos(angle)), s = in_single(std::sin(angle));
        return {{1, 0, 0}, {0, c, -s}, {0, s, c}};
    };
    switch (face) {
        case CubeFace::front: return {};
        case CubeFace::right: return about_y(quarter);
        case CubeFace::back: return about_y(half);
        case CubeFace::left: return about_y(-quarter);
        case CubeFace::up: return about_x(quarter);
        case CubeFace::down: return about_x(-quarter);
    }
    return {};
}

// A coordinate in [-1, 1] as a pixel position, where the centers of the first and last of n pixels are at -1 and 1.
float position_of(float place, int n) { return (place + 1.f) * (static_cast<float>(n - 1) / 2.f); }

float multiply_add(float a, float w, float sum) { return std::fma(a, w, sum); }
Vec3f multiply_add(Vec3f a, float w, Vec3f sum) {
    return {std::fma(a.x, w, sum.x), std::fma(a.y, w, sum.y), std::fma(a.z, w, sum.z)};
}

// Zero outside the picture. The four products are rounded as in the official program's library (sequential, fused): the
// last bit decides how a value is later truncated to a byte.
template <class T>
T bilinear(const Image<T>& image, Vec2f place) {
    const float px = position_of(place.x, image.width), py = position_of(place.y, image.height);
    const float left = std::floor(px), top = std::floor(py), u = px - left, v = py - top;
    const int x = static_cast<int>(left), y = static_cast<int>(top);
    const auto at = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < image.width && j < image.height ? image.at(i, j) : T{};
    };
    T sum = at(x, y) * ((1 - u) * (1 - v));
    sum = multiply_add(at(x + 1, y), u * (1 - v), sum);
    sum = multiply_add(at(x, y + 1), (1 - u) * v, sum);
    return multiply_add(at(x + 1, y + 1), u * v, sum);
}
// Ties round to even.
template <class T>
T nearest(const Image<T>& image, Vec2f place) {
    const int x = static_cast<int>(std::nearbyint(position_of(place.x, image.width)));
    const int y = static_cast<int>(std::nearbyint(position_of(place.y, image.height)));
    return image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
}

template <class T>
Image<T> face_of(const Image<T>& equirect, CubeFace face, int size, PublishedSampling sampling) {
    const Image<Vec2f> grid = published_face_grid(face, size);
    Image<T> out(size, size);
    std::transform(grid.pixels.begin(), grid.pixels.end(), out.pixels.begin(), [&](Vec2f place) {
        return sampling == PublishedSampling::bilinear ? bilinear(equirect, place) : nearest(equirect, place);
    });
    return out;
}

struct FaceHit {
    int face = 0;
    double t = 0;  // distance along the direction to the face's plane at distance 1
    Vec3d in_face;
};
// The first of the nearest planes in front.
FaceHit hit_of(Vec3d direction) {
    static const std::array<Mat3d, 6> face_from_pano = [] {
        std::array<Mat3d, 6> m;
        for (std::size_t i = 0; i < m.size(); ++i) m[i] = transpose(rotation_of(kPublishedFaces[i]));
        return m;
    }();
    FaceHit best{0, std::numeric_limits<double>::infinity(), {}};
    for (int i = 0; i < 6; ++i) {
        const Vec3d d = face_from_pano[static_cast<std::size_t>(i)] * direction;
        const double t = 1.0 / d.z;
        if (d.z > 0 && t < best.t) best = {i, t, d};
    }
    return best;
}
FaceHit hit_of_pixel(int x, int y, int width, int height) {
    const double theta = (static_cast<double>(x) / (width - 1) - 0.5) * 2 * std::numbers::pi;
    const double phi = (static_cast<double>(y) / (height - 1) - 0.5) * std::numbers::pi;
    return hit_of({std::cos(phi) * std::sin(theta), std::sin(phi), std::cos(phi) * std::cos(theta)});
}

}  // namespace

Image<Vec2f> published_face_grid(CubeFace face, int size) {
    FASTSCENE_CHECK(size >= 2);
    const Mat3d pano_from_camera = published_rotation(face);
    const double half = size / 2.0, center = (size - 1) / 2.0;
    Image<Vec2f> grid(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3d d = pano_from_camera * normalize(Vec3d{(x - center) / half, (y - center) / half, 1.0});
            grid.at(x, y) = {static_cast<float>(std::atan2(d.x, d.z) / std::numbers::pi),
                             static_cast<float>(std::asin(std::clamp(d.y, -1.0, 1.0)) / (std::numbers::pi / 2))};
        }
    return grid;
}

ImageColor published_face(const ImageColor& equirect, CubeFace face, int size, PublishedSampling sampling) {
    return face_of(equirect, face, size, sampling);
}
ImageF published_face(const ImageF& equirect, CubeFace face, int size, PublishedSampling sampling) {
    return face_of(equirect, face, size, sampling);
}

ImageMask published_face_index(int height) {
    ImageMask index(2 * height, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x)
            index.at(x, y) = static_cast<std::uint8_t>(hit_of_pixel(x, y, 2 * height, height).face);
    return index;
}

ImageColor published_equirect(const std::array<ImageColor, 6>& faces, int cube_length, int height) {
    FASTSCENE_CHECK(cube_length >= 2 && height >= 2);
    ImageColor out(2 * height, height);
    parallel_for(height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < out.width; ++x) {
                const FaceHit hit = hit_of_pixel(x, y, out.width, height);
                const double half = cube_length / 2.0, last = cube_length - 1;
                const auto place = [&](double along) {  // in single precision from the pixel on, as published
                    const auto pixel = static_cast<float>(std::clamp(half * hit.t * along + last / 2, 0.0, last));
                    return (pixel / static_cast<float>(last) - 0.5f) * 2.f;
                };
                out.at(x, y) = bilinear(faces[static_cast<std::size_t>(hit.face)],
                                        {place(hit.in_face.x), place(hit.in_face.y)});
            }
    });
    return out;
}

}  // namespace fastscene
