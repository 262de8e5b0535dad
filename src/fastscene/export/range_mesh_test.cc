// Meshes of range maps whose surfaces are known.
#include "fastscene/export/range_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace fastscene {
namespace {

constexpr Vec3f kHalf{2.5f, 1.4f, 3.f};                          // of the room
constexpr Vec3f kLow{0.8f, 0.2f, 1.2f}, kHigh{1.6f, 1.4f, 2.f};  // of a box in it

float range_along(Vec3f from, Vec3f ray, bool with_box) {
    float wall = 1e9f, enter = 0, leave = 1e9f;
    for (std::size_t a = 0; a < 3; ++a) {
        if (std::fabs(ray[a]) < 1e-9f) continue;
        wall = std::min(wall, ((ray[a] > 0 ? kHalf[a] : -kHalf[a]) - from[a]) / ray[a]);
        const float p = (kLow[a] - from[a]) / ray[a], q = (kHigh[a] - from[a]) / ray[a];
        enter = std::max(enter, std::min(p, q)), leave = std::min(leave, std::max(p, q));
    }
    return with_box && enter < leave && enter > 0 ? std::min(wall, enter) : wall;
}

Panorama seen_from(Vec3f from, bool with_box) {
    Panorama out;
    out.world_from_pano.translation = from;
    out.color = ImageColor(512, 256, Vec3f{0.5f, 0.5f, 0.5f});
    out.range = ImageF(512, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            out.range.at(x, y) = range_along(from, direction_of_pixel(x, y, {512, 256}), with_box);
    return out;
}

TEST(RangeMesh, LiesOnTheSurfacesAndFacesTheViewpoint) {
    const Panorama panorama = seen_from({0.2f, 0, -0.3f}, false);
    const auto surfaces = range_surfaces({panorama}, kMostRangeTriangles, false, {});
    ASSERT_EQ(surfaces.size(), 1u);
    const RangeSurface& s = surfaces[0];
    double area = 0;
    for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
        const Vec3f a = s.positions[s.triangles[t]], b = s.positions[s.triangles[t + 1]],
                    c = s.positions[s.triangles[t + 2]], n = cross(b - a, c - a);
        area += 0.5 * static_cast<double>(length(n));
        // kGltfAxes turns the world by half a turn: the winding stays.
        EXPECT_GE(dot(n, panorama.world_from_pano.translation - a), -1e-4f);
        const Vec3f middle = (a + b + c) / 3.f;
        float off = 1e9f;
        for (std::size_t k = 0; k < 3; ++k) off = std::min(off, std::fabs(std::fabs(middle[k]) - kHalf[k]));
        EXPECT_LT(off, 0.08f);
    }
    const double whole = 8. * static_cast<double>(kHalf.x * kHalf.y + kHalf.y * kHalf.z + kHalf.z * kHalf.x);
    EXPECT_NEAR(area, whole, 0.03 * whole);
    EXPECT_LT(s.triangles.size() / 3, 60000u) << "walls are flat";
}

// An edge that only one triangle has is a border: where the surface ends. Inside flat areas there is none, whatever
// the sizes of neighbouring squares.
TEST(RangeMesh, HasNoGapsAndNoCurtains) {
    const Panorama panorama = seen_from({}, true);
    const RangeSurface s = range_surfaces({panorama}, kMostRangeTriangles, false, {})[0];
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t t = 0; t < s.triangles.size(); t += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = s.triangles[t + k], b = s.triangles[t + (k + 1) % 3];
            ++edges[{std::min(a, b), std::max(a, b)}];
            // The middle of an edge lies on a surface: a curtain's would hang in the air.
            const Vec3f middle = (s.positions[a] + s.positions[b]) * 0.5f;
            const float box = range_along({}, normalize(middle), true),
                        wall = range_along({}, normalize(middle), false);
            EXPECT_LT(std::min(std::fabs(length(middle) - box), std::fabs(length(middle) - wall)), 0.1f);
        }
    for (const auto& [edge, count] : edges) {
        EXPECT_LE(count, 2);
        if (count == 2) continue;
        const Vec3f middle = (s.positions[edge.first] + s.positions[edge.second]) * 0.5f;
        const Vec3f ray = normalize(middle);
        // Borders: the poles, the seam of columns, and silhouettes of the box.
        const bool pole = std::fabs(ray.y) > 0.98f, seam = ray.z < 0 && std::fabs(ray.x) < 0.03f;
        bool silhouette = false;
        for (const float dx : {-0.05f, 0.f, 0.05f})
            for (const float dy : {-0.05f, 0.f, 0.05f})
                silhouette = silhouette ||
                             std::fabs(range_along({}, normalize(ray + Vec3f{dx, dy, -dx}), true) -
                                       range_along({}, normalize(ray - Vec3f{dx, dy, -dx}), true)) > 0.25f;
        EXPECT_TRUE(pole || seam || silhouette) << middle.x << " " << middle.y << " " << middle.z;
    }
}

// With the squares behind silhouettes a ray from the viewpoint finds a surface everywhere but at the poles.
TEST(RangeMesh, ShowsTheViewpointNoGaps) {
    const Panorama panorama = seen_from({}, true);
    const RangeSurface open = range_surfaces({panorama}, kMostRangeTriangles, false, {})[0],
                       closed = range_surfaces({panorama}, kMostRangeTriangles, true, {})[0];
    EXPECT_GT(closed.triangles.size(), open.triangles.size());
    const auto solid_angle = [](const RangeSurface& s) {  // of triangles seen from the origin (Van Oosterom, Strackee)
        double sum = 0;
        for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
            const Vec3f a = normalize(s.positions[s.triangles[t]]), b = normalize(s.positions[s.triangles[t + 1]]),
                        c = normalize(s.positions[s.triangles[t + 2]]);
            sum += std::fabs(2 * std::atan2(static_cast<double>(dot(a, cross(b, c))),
                                            1 + static_cast<double>(dot(a, b) + dot(b, c) + dot(c, a))));
        }
        return sum;
    };
    const double sphere = 4 * std::numbers::pi;
    EXPECT_NEAR(solid_angle(closed), sphere, 0.001 * sphere);
    EXPECT_LT(solid_angle(open), 0.999 * sphere);
    std::size_t off = 0;
    for (const Vec3f p : closed.positions) {
        const float seen = range_along({}, normalize(p), true), behind = range_along({}, normalize(p), false);
        off += std::min(std::fabs(length(p) - seen), std::fabs(length(p) - behind)) > 0.1f;
    }
    EXPECT_LT(off, closed.positions.size() / 50) << "where a silhouette crosses a slanted wall";
}

TEST(RangeMesh, FurtherPanoramasAddOnlyWhatTheyInvented) {
    std::vector<Panorama> two{seen_from({}, true), seen_from({0.5f, 0, 0}, true)};
    two[1].known = Image<Known>(512, 256, Known::original);
    EXPECT_TRUE(range_surfaces(two, kMostRangeTriangles, false, {})[1].triangles.empty());
    for (int x = 300; x < 330; ++x) two[1].known.at(x, 130) = Known::invented;
    const RangeSurface more = range_surfaces(two, kMostRangeTriangles, false, {})[1];
    EXPECT_GT(more.triangles.size(), 0u);
    EXPECT_LT(more.triangles.size() / 3, 1000u);
}

TEST(RangeMesh, ColliderIsSmall) {
    std::size_t triangles = 0;
    for (const RangeSurface& s : range_surfaces({seen_from({}, true)}, 5000, false, {}))
        triangles += s.triangles.size() / 3;
    EXPECT_GT(triangles, 100u);
    EXPECT_LE(triangles, 5000u);
}

}  // namespace
}  // namespace fastscene
