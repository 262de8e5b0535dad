// Image<T>: a row-major 2D array, top row first. The center of pixel (x, y) lies at (x + 0.5, y + 0.5); the top left
// corner of the image is (0, 0).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/math/vec.h"

namespace fastscene {

struct Rgb8 {
    std::uint8_t r = 0, g = 0, b = 0;
    friend constexpr bool operator==(const Rgb8&, const Rgb8&) = default;
};

template <class T>
struct Image {
    int width = 0, height = 0;
    std::vector<T> pixels;  // row-major, width * height

    Image() = default;
    Image(int w, int h, T value = T{})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {
        FASTSCENE_CHECK(w >= 0 && h >= 0);
    }
    bool empty() const { return pixels.empty(); }
    std::size_t size() const { return pixels.size(); }
    T& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    const T& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    T* row(int y) { return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
    const T* row(int y) const { return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
    template <class U>
    bool same_size(const Image<U>& other) const {
        return width == other.width && height == other.height;
    }
    friend bool operator==(const Image&, const Image&) = default;
};

using ImageF = Image<float>;      // range in metres, weights …
using ImageColor = Image<Vec3f>;  // linear color, 1 = white
using ImageRgb8 = Image<Rgb8>;    // sRGB, as in files
using ImageMask = Image<std::uint8_t>;

}  // namespace fastscene
