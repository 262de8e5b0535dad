#include "fastscene/inpaint/harmonic_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/parallel.h"

namespace fastscene {
namespace {

constexpr int kSphereSweeps = 30;   // a level: the coarser one's solution is near
constexpr int kSmallestSphere = 8;  // columns of the coarsest level

struct SphereLevel {
    ImageColor color;
    ImageMask hole;
};

// Halves both sides: a pixel is the mean of its known children, and a hole only if it has none.
SphereLevel halved(const SphereLevel& fine) {
    SphereLevel out{ImageColor((fine.color.width + 1) / 2, (fine.color.height + 1) / 2), {}};
    out.hole = ImageMask(out.color.width, out.color.height);
    for (int y = 0; y < out.color.height; ++y)
        for (int x = 0; x < out.color.width; ++x) {
            Vec3f sum;
            int known = 0;
            for (int j = 2 * y; j < std::min(2 * y + 2, fine.color.height); ++j)
                for (int i = 2 * x; i < std::min(2 * x + 2, fine.color.width); ++i)
                    if (!fine.hole.at(i, j)) sum += fine.color.at(i, j), ++known;
            out.hole.at(x, y) = known == 0;
            if (known) out.color.at(x, y) = sum / static_cast<float>(known);
        }
    return out;
}

// Gauss-Seidel, even and odd columns in turn.
void relax_on_sphere(SphereLevel& level) {
    const int w = level.color.width, h = level.color.height;
    const auto wrapped = [&](int x) { return x < 0 ? x + w : x >= w ? x - w : x; };
    const auto above = [&](int x, int y) {  // also beyond a pole
        if (y >= 0 && y < h) return level.color.at(x, y);
        return level.color.at(wrapped(x + w / 2), y < 0 ? 0 : h - 1);
    };
    for (int sweep = 0; sweep < kSphereSweeps; ++sweep)
        for (int parity = 0; parity < 2; ++parity)
            for (int y = 0; y < h; ++y) {
                const double lat = (0.5 - (y + 0.5) / h) * std::numbers::pi;
                // A step along the row is shorter by the latitude's cosine; differences count by its square.
                const auto along = static_cast<float>(1 / (std::cos(lat) * std::cos(lat)));
                for (int x = (y + parity) & 1; x < w; x += 2) {
                    if (!level.hole.at(x, y)) continue;
                    const Vec3f beside = level.color.at(wrapped(x - 1), y) + level.color.at(wrapped(x + 1), y);
                    level.color.at(x, y) = (beside * along + above(x, y - 1) + above(x, y + 1)) / (2 * along + 2);
                }
            }
}

void solve_on_sphere(SphereLevel& level, const Run& run) {
    run.check_stop();
    if (level.color.width > kSmallestSphere) {
        SphereLevel coarse = halved(level);
        solve_on_sphere(coarse, run);
        for (int y = 0; y < level.color.height; ++y)
            for (int x = 0; x < level.color.width; ++x)
                if (level.hole.at(x, y)) level.color.at(x, y) = coarse.color.at(x / 2, y / 2);
    } else {  // starts from the mean
        Vec3f sum;
        int known = 0;
        for (std::size_t i = 0; i < level.color.size(); ++i)
            if (!level.hole.pixels[i]) sum += level.color.pixels[i], ++known;
        for (std::size_t i = 0; i < level.color.size(); ++i)
            if (level.hole.pixels[i]) level.color.pixels[i] = known ? sum / static_cast<float>(known) : Vec3f{};
    }
    relax_on_sphere(level);
}

}  // namespace

ImageColor filled_on_sphere(const ImageColor& color, const ImageMask& hole, const Run& run) {
    FASTSCENE_CHECK(color.same_size(hole));
    const auto is_known = [](std::uint8_t v) { return v == 0; };
    if (std::all_of(hole.pixels.begin(), hole.pixels.end(), is_known)) return color;
    if (std::none_of(hole.pixels.begin(), hole.pixels.end(), is_known)) return ImageColor(color.width, color.height);
    SphereLevel level{color, hole};
    solve_on_sphere(level, run);
    return level.color;
}

}  // namespace fastscene
