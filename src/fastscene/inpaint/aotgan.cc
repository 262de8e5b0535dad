#include "fastscene/inpaint/aotgan.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fastscene/image/color.h"
#include "fastscene/inpaint/crops.h"
#include "fastscene/inpaint/harmonic.h"

namespace fastscene {
namespace {

// The receptive field: a branch of dilation 8 at a quarter of the resolution extends 32 pixels to each side.
constexpr int kContext = 48;
// The network was trained on faces of 512.
constexpr int kLargestCrop = 512;
// Maximum pixels per network batch: two faces' worth bounds memory to about 1.3 GB for the full network.
constexpr std::int64_t kMostPixels = 2 * 512 * 512;
// How far the correction at a hole's rim extends inward.
constexpr float kFeather_px = 24;
// A network that adds to the harmonic fill is reliable near the rim, where it continues known structures; farther in it
// only guesses, and the harmonic fill in linear light, which matches smooth shading on walls, is no worse.
constexpr float kSure_px = 4, kUnsure_px = 6;

// Distance of each hole pixel to the nearest known one, in pixels (two-pass chamfer, at most 8 % too long); 0 for known
// pixels.
ImageF distance_to_known(const ImageMask& hole) {
    constexpr float kFar = 1e9f, kDiagonal = 1.41421356f;
    const int w = hole.width, h = hole.height;
    ImageF d(w, h, kFar);
    const auto relax = [&](int x, int y, int dx, int dy, float length) {
        const int nx = x + dx, ny = y + dy;
        if (nx >= 0 && ny >= 0 && nx < w && ny < h) d.at(x, y) = std::min(d.at(x, y), d.at(nx, ny) + length);
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (!hole.at(x, y)) d.at(x, y) = 0;
            relax(x, y, -1, 0, 1), relax(x, y, 0, -1, 1), relax(x, y, -1, -1, kDiagonal), relax(x, y, 1, -1, kDiagonal);
        }
    for (int y = h; y-- > 0;)
        for (int x = w; x-- > 0;)
            relax(x, y, 1, 0, 1), relax(x, y, 0, 1, 1), relax(x, y, 1, 1, kDiagonal), relax(x, y, -1, 1, kDiagonal);
    return d;
}

// The crop; beyond the picture its border pixels are replicated, as known ones.
Aotgan::Picture cut(const ImageColor& srgb, const ImageMask& hole, const Crop& crop) {
    Aotgan::Picture out{ImageColor(crop.width, crop.height), ImageMask(crop.width, crop.height)};
    for (int y = 0; y < crop.height; ++y)
        for (int x = 0; x < crop.width; ++x) {
            const int px = std::min(crop.x + x, srgb.width - 1), py = std::min(crop.y + y, srgb.height - 1);
            out.color.at(x, y) = srgb.at(px, py);
            out.hole.at(x, y) = hole.at(px, py);
        }
    return out;
}

// Accumulates overlapping crops, each weighted down towards its edges.
struct Canvas {
    ImageColor sum;
    ImageF weight;
    void lay(const ImageColor& painted, const Crop& crop) {
        for (int y = 0; y < crop.height && crop.y + y < sum.height; ++y)
            for (int x = 0; x < crop.width && crop.x + x < sum.width; ++x) {
                const int edge = 1 + std::min({x, y, crop.width - 1 - x, crop.height - 1 - y, kContext});
                sum.at(crop.x + x, crop.y + y) += painted.at(x, y) * static_cast<float>(edge);
                weight.at(crop.x + x, crop.y + y) += static_cast<float>(edge);
            }
    }
};

// Runs the network on the surroundings of all holes; crops of equal size are batched.
Canvas painted_crops(const Aotgan& network, const ImageColor& srgb, const ImageMask& hole,
                     const std::vector<Crop>& crops, const Run& run) {
    std::map<std::pair<int, int>, std::vector<Crop>> by_size;
    for (const Crop& crop : crops) by_size[{crop.width, crop.height}].push_back(crop);
    Canvas canvas{ImageColor(srgb.width, srgb.height), ImageF(srgb.width, srgb.height)};
    for (const auto& [size, group] : by_size) {
        const auto together = static_cast<std::size_t>(
            std::max<std::int64_t>(1, kMostPixels / (std::int64_t{size.first} * size.second)));
        for (std::size_t begin = 0; begin < group.size(); begin += together) {
            const std::vector<Crop> some(
                group.begin() + static_cast<std::ptrdiff_t>(begin),
                group.begin() + static_cast<std::ptrdiff_t>(std::min(group.size(), begin + together)));
            std::vector<Aotgan::Picture> pictures;
            for (const Crop& crop : some) pictures.push_back(cut(srgb, hole, crop));
            const std::vector<ImageColor> painted = network.paint(pictures, run);
            for (std::size_t i = 0; i < some.size(); ++i) canvas.lay(painted[i], some[i]);
        }
    }
    for (std::size_t i = 0; i < canvas.sum.size(); ++i)
        if (canvas.weight.pixels[i] > 0) canvas.sum.pixels[i] = canvas.sum.pixels[i] * (1 / canvas.weight.pixels[i]);
    return canvas;
}

// Propagates the network's color error on known pixels smoothly into the hole, so that no seam shows.
void meet_the_known(Canvas& canvas, const ImageColor& srgb, const ImageMask& hole, const Run& run) {
    ImageColor error(srgb.width, srgb.height);
    for (std::size_t i = 0; i < error.size(); ++i)
        if (!hole.pixels[i] && canvas.weight.pixels[i] > 0) error.pixels[i] = srgb.pixels[i] - canvas.sum.pixels[i];
    const ImageColor correction = HarmonicInpainter{}.fill(error, hole, run);
    const ImageF distance = distance_to_known(hole);
    for (std::size_t i = 0; i < error.size(); ++i)
        if (hole.pixels[i]) canvas.sum.pixels[i] += correction.pixels[i] * std::exp(-distance.pixels[i] / kFeather_px);
}

// Fades the network's contribution inward; at the rim itself the fill matches the known pixels.
void trust_near_the_rim(Canvas& canvas, const ImageColor& fill, const ImageMask& hole) {
    const ImageF distance = distance_to_known(hole);
    for (std::size_t i = 0; i < fill.size(); ++i) {
        if (!hole.pixels[i]) continue;
        const float trust = std::exp(-std::max(0.f, distance.pixels[i] - kSure_px) / kUnsure_px);
        canvas.sum.pixels[i] = lerp(fill.pixels[i], canvas.sum.pixels[i], trust);
    }
}

}  // namespace

ImageColor AotganInpainter::fill(const ImageColor& color, const ImageMask& hole, const Run& run) const {
    FASTSCENE_CHECK(color.same_size(hole));
    const std::vector<Crop> crops = crops_around(hole, kContext, Aotgan::kMultiple, Aotgan::kSmallest, kLargestCrop);
    if (crops.empty()) return color;
    ImageColor srgb = unit_from_linear(color);
    if (network_.adds_to_fill()) srgb = HarmonicInpainter{}.fill(srgb, hole, run);
    Canvas canvas = painted_crops(network_, srgb, hole, crops, run);
    if (network_.adds_to_fill())
        trust_near_the_rim(canvas, unit_from_linear(HarmonicInpainter{}.fill(color, hole, run)), hole);
    else meet_the_known(canvas, srgb, hole, run);
    ImageColor out = color;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (hole.pixels[i])
            for (std::size_t c = 0; c < 3; ++c)
                out.pixels[i][c] = linear_from_srgb(std::clamp(canvas.sum.pixels[i][c], 0.f, 1.f));
    return out;
}

}  // namespace fastscene
