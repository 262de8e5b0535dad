#include "fastscene/depth/room_lines.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/geometry/reproject.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr EquirectSize kLook{512, 256};  // resolution for line detection; finer lines are furniture

// Normalizes by the strongest tenth of the picture, since dim rooms have edges too. The square root makes the faint
// line between two white walls count nearly as much as a window frame.
void normalize(ImageF& lines) {
    std::vector<float> sorted = lines.pixels;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
    std::nth_element(sorted.begin(), at, sorted.end());
    const float strong = std::max(*at, 1e-4f);
    for (float& v : lines.pixels) v = std::sqrt(std::min(1.f, v / strong));
}

}  // namespace

RoomLines find_lines(const ImageColor& panorama) {
    const ImageColor small = equirect_from_equirect(panorama, kLook);
    Image<Vec3f> seen(kLook.width, kLook.height);  // in perceptual (sRGB) values
    for (std::size_t i = 0; i < small.size(); ++i)
        seen.pixels[i] = {srgb_from_linear(small.pixels[i].x), srgb_from_linear(small.pixels[i].y),
                          srgb_from_linear(small.pixels[i].z)};
    RoomLines lines{ImageF(kLook.width, kLook.height), ImageF(kLook.width, kLook.height)};
    const auto change = [](Vec3f a, Vec3f b) {
        return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
    };
    for (int y = 2; y < kLook.height - 2; ++y)
        for (int x = 0; x < kLook.width; ++x) {
            const auto at = [&](int dx, int dy) { return seen.at(wrap_column(x + dx, kLook.width), y + dy); };
            // Long lines are consistent along their direction: averages three positions.
            const auto mean3 = [&](int dx, int dy, bool along_x) {
                return (along_x ? at(dx - 2, dy) + at(dx, dy) + at(dx + 2, dy)
                                : at(dx, dy - 2) + at(dx, dy) + at(dx, dy + 2)) *
                       (1.f / 3.f);
            };
            lines.level.at(x, y) = change(mean3(0, -1, true), mean3(0, 1, true));
            lines.upright.at(x, y) = change(mean3(-1, 0, false), mean3(1, 0, false));
        }
    normalize(lines.level);
    normalize(lines.upright);
    return lines;
}

float strength_at(const ImageF& lines, float lon, float lat, bool level) {
    const int x = static_cast<int>(std::floor((lon / (2 * kPi) + 0.5f) * static_cast<float>(kLook.width)));
    const int y = std::clamp(static_cast<int>((0.5f - lat / kPi) * static_cast<float>(kLook.height)), 1,
                             kLook.height - 2);
    float best = 0;
    for (int d = -1; d <= 1; ++d)
        best = std::max(
            best, level ? lines.at(wrap_column(x, kLook.width), y + d) : lines.at(wrap_column(x + d, kLook.width), y));
    return best;
}

}  // namespace fastscene
