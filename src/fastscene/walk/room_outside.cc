#include "fastscene/walk/room_outside.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

constexpr EquirectSize kDirections{256,
                                   128};  // 1.4 degrees apart; directions in between are assumed to be visible, too
constexpr int kEyes = 160;                // random viewpoints over the floor
constexpr float kLowest_m = 0.7f, kTop_m = 1.85f;  // viewpoint heights above the floor: crouching, and a tall adult

std::vector<Vec3f> viewpoints_over(const StandableFloor& floor, const Run& run) {
    const std::vector<FloorCell> cells = standable_cells(floor);
    Random random(run.seed, "walk.outside");
    std::vector<Vec3f> viewpoints;
    for (int i = 0; i < kEyes && !cells.empty(); ++i) {
        const FloorCell cell = cells[static_cast<std::size_t>(random.index(static_cast<int>(cells.size())))];
        const Vec2f at = floor.center(cell.column, cell.row);
        viewpoints.push_back({at.x, floor.level_at(cell.column, cell.row) - random.uniform(kLowest_m, kTop_m), at.y});
    }
    return viewpoints;
}

// The share of viewpoints that see the outside, in 255ths, by direction; at least 1 where any does. Dilated by one.
ImageMask directions_out(const TracedRoom& room, const std::vector<Vec3f>& viewpoints, const Mat3f& pano,
                         const Run& run) {
    const int w = kDirections.width, h = kDirections.height;
    ImageMask out(w, h);
    parallel_for(h, 2, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < w; ++x) {
                const Vec3f d = pano * direction_of_pixel(x, y, kDirections);
                const auto see = std::count_if(viewpoints.begin(), viewpoints.end(), [&](Vec3f viewpoint) {
                    return !std::isfinite(room.surface(viewpoint, d).distance);
                });
                const auto all = static_cast<std::int64_t>(viewpoints.size());
                out.at(x, y) = static_cast<std::uint8_t>(all ? (255 * see + all - 1) / all : 0);
            }
    });
    ImageMask wide = out;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            for (int k = 0; k < 9; ++k)
                wide.at(x, y) = std::max(wide.at(x, y),
                                         out.at(wrap_column(x + k % 3 - 1, w), std::clamp(y + k / 3 - 1, 0, h - 1)));
    return wide;
}

}  // namespace

Outside outside_of_room(const TracedRoom& room, const StandableFloor& floor, const Mat3f& pano, EquirectSize size,
                        const Run& run) {
    const std::vector<Vec3f> viewpoints = viewpoints_over(floor, run);
    const ImageMask seen = directions_out(room, viewpoints, pano, run);
    if (std::none_of(seen.pixels.begin(), seen.pixels.end(), [](std::uint8_t s) { return s != 0; })) return {};
    Outside outside{room.outside(pano, size), ImageMask(size.width, size.height)};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            outside.seen.at(x, y) = seen.at(x * seen.width / size.width, y * seen.height / size.height);
    return outside;
}

}  // namespace fastscene
