// Drawing of what is printed: spines, covers, labels, signs.
#pragma once

#include <string_view>

#include "fastscene/image/image.h"
#include "fastscene/math/vec.h"

namespace fastscene::furniture {

// A part of an image, in pixels from its lower left corner, y up. What lies outside is not drawn.
class Patch {
    ImageColor* image_;
    int left_, top_;

  public:
    const float w, h;

    Patch(ImageColor& image, int left, int top, int width, int height)
        : image_(&image), left_(left), top_(top), w(static_cast<float>(width)), h(static_cast<float>(height)) {}

    void fill(Vec2f low, Vec2f high, Vec3f color, float opacity = 1.f);
    void fill(Vec3f color) { fill({0, 0}, {w, h}, color); }
    void disc(Vec2f center, Vec2f radii, Vec3f color, float opacity = 1.f);
    void line(Vec2f a, Vec2f b, float width, Vec3f color);
    // From `at` along the unit vector `right`, lines of `weight` pixels.
    void letters(std::string_view text, Vec2f at, Vec2f right, float height, float weight, Vec3f color);
    // Upright, about x, as high as fits into `widest`, at most `height`; returns the height.
    float title(std::string_view text, float x, float y, float widest, float height, Vec3f color);

  private:
    template <class Coverage>
    void blend(Vec2f low, Vec2f high, Vec3f color, float opacity, const Coverage& coverage);
};

}  // namespace fastscene::furniture
