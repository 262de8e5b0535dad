#include "fastscene/rooms/furniture/painting.h"

#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/lettering.h"

namespace fastscene::furniture {

template <class Coverage>
void Patch::blend(Vec2f low, Vec2f high, Vec3f color, float opacity, const Coverage& coverage) {
    const int x0 = std::max(0, static_cast<int>(std::floor(low.x - 1))),
              x1 = std::min(static_cast<int>(w), static_cast<int>(std::ceil(high.x + 1))),
              y0 = std::max(0, static_cast<int>(std::floor(low.y - 1))),
              y1 = std::min(static_cast<int>(h), static_cast<int>(std::ceil(high.y + 1)));
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const float share = opacity *
                                std::clamp(coverage(Vec2f{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}),
                                           0.f, 1.f);
            Vec3f& p = image_->at(left_ + x, top_ + static_cast<int>(h) - 1 - y);
            p = lerp(p, color, share);
        }
}

void Patch::fill(Vec2f low, Vec2f high, Vec3f color, float opacity) {
    blend(low, high, color, opacity, [&](Vec2f p) {
        return std::min({0.5f + p.x - low.x, 0.5f + high.x - p.x, 1.f}) *
               std::clamp(std::min(0.5f + p.y - low.y, 0.5f + high.y - p.y), 0.f, 1.f);
    });
}

void Patch::disc(Vec2f center, Vec2f radii, Vec3f color, float opacity) {
    blend(center - radii, center + radii, color, opacity, [&](Vec2f p) {
        const Vec2f d = p - center;
        const float r = std::hypot(d.x / radii.x, d.y / radii.y);
        return 0.5f + (1.f - r) * std::min(radii.x, radii.y);
    });
}

void Patch::line(Vec2f a, Vec2f b, float width, Vec3f color) {
    const Vec2f low{std::min(a.x, b.x) - width, std::min(a.y, b.y) - width},
        high{std::max(a.x, b.x) + width, std::max(a.y, b.y) + width}, along = b - a;
    const float square = along.x * along.x + along.y * along.y;
    blend(low, high, color, std::min(1.f, width), [&](Vec2f p) {
        const Vec2f d = p - a;
        const float t = square > 0 ? std::clamp((d.x * along.x + d.y * along.y) / square, 0.f, 1.f) : 0.f;
        return 0.5f + 0.5f * std::max(width, 1.f) - std::hypot(d.x - t * along.x, d.y - t * along.y);
    });
}

void Patch::letters(std::string_view text, Vec2f at, Vec2f right, float height, float weight, Vec3f color) {
    const auto place = [&](Vec2f p) { return at + right * p.x + Vec2f{-right.y, right.x} * p.y; };
    for (const auto& stroke : letter_strokes(text, height))
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) line(place(stroke[i]), place(stroke[i + 1]), weight, color);
}

float Patch::title(std::string_view text, float x, float y, float widest, float height, Vec3f color) {
    const float fits = std::min(height, height * widest / std::max(1.f, letters_width(text, height)));
    letters(text, {x - 0.5f * letters_width(text, fits), y}, {1, 0}, fits, 0.17f * fits, color);
    return fits;
}

}  // namespace fastscene::furniture
