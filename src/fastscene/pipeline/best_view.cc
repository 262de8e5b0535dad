#include "fastscene/pipeline/best_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/json.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr int kYaws = 24;
// A requested object must be this close to the center to be well inside the picture.
constexpr float kInsideDeg = 0.38f * kPreviewFovDeg;
// Weight of a requested object, relative to a mean view's detail and depth.
constexpr double kWorthOfAPiece = 0.35;

// Per column, over the rows visible to a level camera: amount of detail, and distance (in doublings of a metre).
std::vector<double> interest_by_column(const Panorama& first) {
    const EquirectSize size = first.size();
    std::vector<double> column(static_cast<std::size_t>(size.width));
    for (int x = 0; x < size.width; ++x)
        for (int y = size.height / 3; y < size.height * 3 / 4; ++y) {
            const Vec3f here = first.color.at(x, y), right = first.color.at(wrap_column(x + 1, size.width), y);
            const double detail = std::abs(srgb_from_linear(luminance(here)) - srgb_from_linear(luminance(right)));
            const float range = first.range.at(x, y);
            const double far = std::isfinite(range) ? std::log2(1.0 + std::min(range, 8.f)) : 1.0;
            column[static_cast<std::size_t>(x)] += std::min(detail, 0.1) * 20 + far;
        }
    return column;
}

float yaw_of(Vec3f direction) { return std::atan2(direction.x, direction.z) * 180.f / std::numbers::pi_v<float>; }

}  // namespace

std::vector<Vec3f> requested_directions(const RunFolder& folder) {
    std::vector<Vec3f> directions;
    for (const Json& object : read_json(folder.room_json()).value("objects", Json::array())) {
        if (!object.value("requested", false) || object.value("visible_pixels", 0) == 0) continue;
        const Json& pose = object.at("world_from_object");
        directions.push_back({pose.at(0).at(3), pose.at(1).at(3), pose.at(2).at(3)});
    }
    return directions;
}

float best_yaw_deg(const Panorama& first, const std::vector<Vec3f>& requested) {
    const int width = first.color.width;
    const std::vector<double> column = interest_by_column(first);
    double mean = 0;
    for (const double v : column) mean += v / static_cast<double>(width);

    const int half_field = static_cast<int>(static_cast<float>(width) * kPreviewFovDeg / 720.f);
    double best = -1;
    float best_yaw = 0;
    for (int i = 0; i < kYaws; ++i) {
        const float yaw = 360.f * static_cast<float>(i) / kYaws;
        double sum = 0;
        for (int d = -half_field; d <= half_field; ++d)
            sum += column[static_cast<std::size_t>(wrap_column(width / 2 + i * width / kYaws + d, width))];
        double score = mean > 0 ? sum / (mean * (2 * half_field + 1)) : 0;
        for (const Vec3f direction : requested)
            if (std::abs(std::remainder(yaw_of(direction) - yaw, 360.f)) < kInsideDeg) score += kWorthOfAPiece;
        if (score > best) {
            best = score;
            best_yaw = yaw;
        }
    }
    return best_yaw;
}

}  // namespace fastscene
