#include "fastscene/trace/changed_pixels.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/grown.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr int kGrid = 4;     // pixels between samples
constexpr int kAround = 2;   // pixels around a changed surface: filters and antialiasing reach so far
constexpr int kVisible = 2;  // of 255, in any channel of the sRGB color

bool differs(Rgb8 a, Rgb8 b) {
    return std::abs(a.r - b.r) > kVisible || std::abs(a.g - b.g) > kVisible || std::abs(a.b - b.b) > kVisible;
}

}  // namespace

ChangedPixels::ChangedPixels(const TracedRoom& before, const TracedRoom& now, const ShotParts& parts)
    : before_(before),
      now_(now),
      parts_(parts),
      change_(change_between(before.room(), now.room())),
      surfaces_(change_.surfaces) {
    parts_.range = parts_.object = parts_.mirrored_range = false;
    parts_.pixel_samples = 1;
    parts_.contacts = parts_.denoise = parts_.denoise_reflections = false;
    parts_.noise = 0;
}

ImageMask ChangedPixels::in_panorama(const Rigid& world_from_pano, EquirectSize size, const Run& run) const {
    constexpr float kSurface_m = 2e-3f;  // tolerance for rounding
    ImageMask out(size.width, size.height);
    // Shown in either room: not farther than what is seen in one of them.
    parallel_for(size.height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Vec3f from = world_from_pano.translation;
                const Vec3f towards = normalize(world_from_pano.rotation * direction_of_pixel(x, y, size));
                const RayHit hit = surfaces_.first_hit(from, towards);
                if (!hit) continue;
                const float seen = std::max(before_.distance(from, towards), now_.distance(from, towards));
                if (hit.distance <= seen + kSurface_m) out.at(x, y) = 255;
            }
    });
    out = grown(out, kAround, true);

    ImageMask grid(size.width, size.height);
    for (int y = kGrid / 2; y < size.height; y += kGrid)
        for (int x = kGrid / 2; x < size.width; x += kGrid) grid.at(x, y) = out.at(x, y) != 0 ? 0 : 255;
    ShotParts parts = parts_;
    parts.only = &grid;
    const Run quiet{run.seed, nullptr, run.stop};
    const ImageRgb8 a = srgb8_from_linear(before_.panorama(world_from_pano, size, parts, quiet).color),
                    b = srgb8_from_linear(now_.panorama(world_from_pano, size, parts, quiet).color);
    ImageMask changed(size.width, size.height);
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (grid.pixels[i] != 0 && differs(a.pixels[i], b.pixels[i])) changed.pixels[i] = 255;
    changed = grown(changed, kGrid, true);  // over the next samples, which may have missed it
    for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] = std::max(out.pixels[i], changed.pixels[i]);
    return out;
}

}  // namespace fastscene
