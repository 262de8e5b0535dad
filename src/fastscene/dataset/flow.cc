#include "fastscene/dataset/flow.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"

namespace fastscene::dataset {
namespace {

constexpr float kFlowZero = 32768;  // the count of no move

std::uint16_t flow_count(float px, float unit_px) {
    return static_cast<std::uint16_t>(std::clamp(std::round(kFlowZero + px / unit_px), 0.f, 65535.f));
}

}  // namespace

FlowMap flow_between(const Camera& from, const Camera& to, const ImageF& range,
                     const std::function<bool(Vec3f)>& sees) {
    FlowMap out(range.width, range.height);
    const auto width = static_cast<float>(range.width);
    parallel_for(range.height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < range.width; ++x) {
                const float r = range.at(x, y);
                if (!std::isfinite(r)) continue;
                const Vec3f point = from.world_from_camera * (from.ray(x, y) * r);
                const std::optional<Vec2f> there = to.seen_at(point);
                if (!there || !sees(point)) continue;
                FlowPixel& flow = out.at(x, y);
                flow = {there->x - (static_cast<float>(x) + 0.5f), there->y - (static_cast<float>(y) + 0.5f), true};
                if (!to.panorama) continue;
                if (flow.u >= width / 2) flow.u -= width;
                if (flow.u < -width / 2) flow.u += width;
            }
    });
    return out;
}

float flow_unit_px(int width, int height, bool panorama) {
    const auto farthest = static_cast<float>(std::max(panorama ? width / 2 : width, height));
    float unit = 1.f / 64;
    while (farthest / unit > kFlowZero) unit *= 2;
    return unit;
}

Image3x16 encoded_flow(const FlowMap& flow, float unit_px) {
    Image3x16 out(flow.width, flow.height);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (const FlowPixel& f = flow.pixels[i]; f.valid)
            out.pixels[i] = {flow_count(f.u, unit_px), flow_count(f.v, unit_px), 1};
    return out;
}

FlowMap decoded_flow(const Image3x16& counts, float unit_px) {
    FlowMap out(counts.width, counts.height);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (const auto& [u, v, valid] = counts.pixels[i]; valid)
            out.pixels[i] = {(static_cast<float>(u) - kFlowZero) * unit_px,
                             (static_cast<float>(v) - kFlowZero) * unit_px, true};
    return out;
}

}  // namespace fastscene::dataset
