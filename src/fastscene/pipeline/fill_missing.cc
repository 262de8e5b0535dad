#include "fastscene/pipeline/fill_missing.h"

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/cubemap.h"
#include "fastscene/image/color.h"
#include "fastscene/inpaint/harmonic_sphere.h"

namespace fastscene {
namespace {

constexpr float kFillFov_deg = 100;  // faces overlap, so that their borders do not show
constexpr float kRim_deg = 12;       // what the inpainter continues; beyond, only the smooth fill

// A side of the panorama that is missing shows the rest mirrored at its edge: walls, floor and ceiling continue, as in
// a room, where a smooth fill would be fog. In the middle of the gap the mirrored pictures of both edges fade into each
// other. Returns what is still missing.
ImageMask mirror_sides(ImageColor& color, const ImageMask& missing) {
    constexpr int kLeastGap = 18;                        // a share of the width: 20 degrees; smaller ones are painted
    constexpr float kFadeFrom = 0.42f, kFadeTo = 0.58f;  // of the gap
    const int w = color.width;
    ImageMask rest = missing;
    for (int y = 0; y < color.height; ++y) {
        const std::uint8_t* row = missing.row(y);
        const auto is_missing = [&](int x) { return row[wrap_column(x, w)] != 0; };
        for (int begin = 0; begin < w; ++begin) {
            if (!is_missing(begin) || is_missing(begin - 1)) continue;
            int gap = 1;
            while (gap < w && is_missing(begin + gap)) ++gap;
            if (gap < w / kLeastGap) continue;
            for (int k = 0; k < gap; ++k) {
                const int left = begin - 1 - k, right = begin + gap + (gap - 1 - k);
                const bool has_left = k < w - gap && !is_missing(left),
                           has_right = gap - 1 - k < w - gap && !is_missing(right);
                if (!has_left && !has_right) continue;
                const float t = (static_cast<float>(k) + 0.5f) / static_cast<float>(gap),
                            s = std::clamp((t - kFadeFrom) / (kFadeTo - kFadeFrom), 0.f, 1.f);
                const float share = !has_right ? 0 : !has_left ? 1 : s * s * (3 - 2 * s);
                const int x = wrap_column(begin + k, w);
                color.at(x, y) = lerp(color.at(wrap_column(has_left ? left : right, w), y),
                                      color.at(wrap_column(has_right ? right : left, w), y), share);
                rest.at(x, y) = 0;
            }
        }
    }
    return rest;
}

// Smooth in what eyes see, not in light.
ImageColor smooth_fill(const ImageColor& color, const ImageMask& missing, const Run& run) {
    const ImageColor filled = filled_on_sphere(unit_from_linear(color), missing, run);
    ImageColor out = color;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (missing.pixels[i])
            for (std::size_t c = 0; c < 3; ++c) out.pixels[i][c] = linear_from_srgb(filled.pixels[i][c]);
    return out;
}

// The missing pixels within so many pixels of known ones, along rows and columns.
ImageMask rim_of(const ImageMask& missing, int reach) {
    ImageMask near(missing.width, missing.height), out = near;
    const auto any_known = [&](const ImageMask& known, int x, int y, int dx, int dy) {
        for (int k = -reach; k <= reach; ++k) {
            const int i = x + k * dx, j = y + k * dy;
            if (i >= 0 && j >= 0 && i < known.width && j < known.height && !known.at(i, j)) return true;
        }
        return false;
    };
    for (int y = 0; y < missing.height; ++y)
        for (int x = 0; x < missing.width; ++x) near.at(x, y) = !any_known(missing, x, y, 1, 0);
    for (int y = 0; y < missing.height; ++y)
        for (int x = 0; x < missing.width; ++x)
            out.at(x, y) = missing.at(x, y) && any_known(near, x, y, 0, 1) ? 255 : 0;
    return out;
}

// Continues structures across the rim, one cube face at a time.
ImageColor rim_painted(const ImageColor& smooth, const ImageMask& missing, const Inpainter& inpainter, const Run& run) {
    const EquirectSize size{smooth.width, smooth.height};
    const int side = std::max(16, static_cast<int>(static_cast<float>(smooth.width) * kFillFov_deg / 360));
    const Pinhole camera = Pinhole::with_fov(side, side, kFillFov_deg);
    const int reach = std::max(2, static_cast<int>(static_cast<float>(side) * kRim_deg / kFillFov_deg));
    ImageColor out = smooth;
    for (const CubeFace face : kCubeFaces) {
        run.check_stop();
        const Mat3f pano_from_camera = pano_from_face(face);
        ImageMask hole(side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Vec2f at = pixel_of_direction(
                    pano_from_camera *
                        camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}),
                    size);
                hole.at(x, y) = missing.at(wrap_column(static_cast<int>(at.x), size.width),
                                           std::min(static_cast<int>(at.y), size.height - 1));
            }
        const ImageMask rim = rim_of(hole, reach);
        if (std::none_of(rim.pixels.begin(), rim.pixels.end(), [](std::uint8_t v) { return v != 0; })) continue;
        const ImageColor painted = inpainter.fill(face_from_equirect(smooth, face, camera), rim, run);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                if (!missing.at(x, y)) continue;
                const Vec3f d = direction_of_pixel(x, y, size);
                if (face_of_direction(d) != face) continue;
                const Vec2f at = *camera.project(transpose(pano_from_camera) * d);
                if (rim.at(std::clamp(static_cast<int>(at.x), 0, side - 1),
                           std::clamp(static_cast<int>(at.y), 0, side - 1)))
                    out.at(x, y) = sample_flat(painted, at);
            }
    }
    return out;
}

}  // namespace

ImageColor with_missing_filled(const ImageColor& color, const ImageMask& missing, const Inpainter& inpainter,
                               const Run& run) {
    if (inpainter.invents()) return fill_panorama(inpainter, smooth_fill(color, missing, run), missing, run);
    ImageColor sides = color;
    const ImageMask rest = mirror_sides(sides, missing);
    return rim_painted(smooth_fill(sides, rest, run), rest, inpainter, run);
}

}  // namespace fastscene
