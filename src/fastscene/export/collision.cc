#include "fastscene/export/collision.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/object_boxes.h"
#include "fastscene/export/shell.h"
#include "fastscene/scene/raised_floor.h"

namespace fastscene {
namespace {

constexpr float kStep_m = 0.05f;          // lower things do not stop a foot; as Body::step_over_m
constexpr float kSlab_m = 0.2f;           // thickness of the floor
constexpr float kThinnest_m = 0.02f;      // of a box: thinner ones let fast bodies through
constexpr float kFinestCell_m = 0.1f;     // of the grid that a thing is divided by
constexpr float kCoarsestShell_m = 0.3f;  // larger cells would close doorways
constexpr float kCellGrowth = 1.4f;       // until the boxes are few enough
constexpr int kMostCells = 160;           // along an axis
constexpr int kTrianglesOfBox = 12;

struct Triangle {
    Vec3f a, b, c;
};
using Triangles = std::vector<Triangle>;

void widen(Box& box, Vec3f p) {
    for (std::size_t i = 0; i < 3; ++i)
        box.low[i] = std::min(box.low[i], p[i]), box.high[i] = std::max(box.high[i], p[i]);
}
Box nothing() { return {{1e9f, 1e9f, 1e9f}, {-1e9f, -1e9f, -1e9f}}; }

// A grid over a thing's bounds. A cell that holds surface knows the bounds of that surface; one that cannot be reached
// from outside is solid.
class Grid {
  public:
    Grid(const Triangles& triangles, float cell) {
        bounds_ = nothing();
        for (const Triangle& t : triangles) widen(bounds_, t.a), widen(bounds_, t.b), widen(bounds_, t.c);
        for (std::size_t a = 0; a < 3; ++a) {
            const float extent = bounds_.high[a] - bounds_.low[a];
            count_[a] = std::clamp(static_cast<int>(std::ceil(extent / cell)), 1, kMostCells);
            size_[a] = std::max(extent / static_cast<float>(count_[a]), 1e-4f);
        }
        cells_.assign(at(count_[0] * count_[1] * count_[2]), nothing());
        full_.assign(cells_.size(), false);
        for (const Triangle& t : triangles) sample(t, 0.25f * cell);
        fill();
    }

    // Greedy: the longest run along x, grown along z, then along y.
    std::vector<Box> boxes() {
        std::vector<Box> out;
        for (int y = 0; y < count_[1]; ++y)
            for (int z = 0; z < count_[2]; ++z)
                for (int x = 0; x < count_[0]; ++x)
                    if (full_[index(x, y, z)]) out.push_back(take(x, y, z));
        return out;
    }

  private:
    std::size_t index(int x, int y, int z) const { return at((y * count_[2] + z) * count_[0] + x); }
    int cell_of(float v, std::size_t a) const {
        return std::clamp(static_cast<int>((v - bounds_.low[a]) / size_[a]), 0, count_[a] - 1);
    }
    void sample(const Triangle& t, float spacing) {
        const float longest = std::max({length(t.b - t.a), length(t.c - t.a), length(t.c - t.b)});
        const int n = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, 4 * kMostCells);
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                const Vec3f p = t.a + (t.b - t.a) * (static_cast<float>(i) / static_cast<float>(n)) +
                                (t.c - t.a) * (static_cast<float>(j) / static_cast<float>(n));
                const std::size_t k = index(cell_of(p.x, 0), cell_of(p.y, 1), cell_of(p.z, 2));
                widen(cells_[k], p);
                full_[k] = true;
            }
    }
    // Marks as solid what the outside does not reach.
    void fill() {
        std::vector<bool> outside(full_.size(), false);
        std::deque<std::array<int, 3>> open;
        const auto visit = [&](int x, int y, int z) {
            if (x < 0 || y < 0 || z < 0 || x >= count_[0] || y >= count_[1] || z >= count_[2]) return;
            const std::size_t k = index(x, y, z);
            if (full_[k] || outside[k]) return;
            outside[k] = true;
            open.push_back({x, y, z});
        };
        for (int y = 0; y < count_[1]; ++y)
            for (int z = 0; z < count_[2]; ++z)
                for (int x = 0; x < count_[0]; ++x)
                    if (x == 0 || y == 0 || z == 0 || x == count_[0] - 1 || y == count_[1] - 1 || z == count_[2] - 1)
                        visit(x, y, z);
        for (; !open.empty(); open.pop_front()) {
            const auto [x, y, z] = open.front();
            visit(x - 1, y, z), visit(x + 1, y, z), visit(x, y - 1, z);
            visit(x, y + 1, z), visit(x, y, z - 1), visit(x, y, z + 1);
        }
        for (int y = 0; y < count_[1]; ++y)
            for (int z = 0; z < count_[2]; ++z)
                for (int x = 0; x < count_[0]; ++x) {
                    const std::size_t k = index(x, y, z);
                    if (full_[k] || outside[k]) continue;
                    full_[k] = true;
                    const Vec3f low = bounds_.low +
                                      Vec3f{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)} *
                                          Vec3f{size_[0], size_[1], size_[2]};
                    cells_[k] = {low, low + Vec3f{size_[0], size_[1], size_[2]}};
                }
    }
    // The bounds of a block of cells; none if one of them is empty.
    std::optional<Box> bounds_of(int x0, int x1, int y0, int y1, int z0, int z1) const {
        Box box = nothing();
        for (int y = y0; y < y1; ++y)
            for (int z = z0; z < z1; ++z)
                for (int x = x0; x < x1; ++x) {
                    if (!full_[index(x, y, z)]) return std::nullopt;
                    widen(box, cells_[index(x, y, z)].low), widen(box, cells_[index(x, y, z)].high);
                }
        return box;
    }
    // Whether one box for both juts out beyond neither, along the other axes: a jamb and the sill between two of them
    // would else close the doorway.
    static bool fits(const Box& a, const Box& b, std::size_t along) {
        constexpr float kJut_m = 0.03f;
        for (std::size_t i = 0; i < 3; ++i)
            if (i != along && (std::fabs(a.low[i] - b.low[i]) > kJut_m || std::fabs(a.high[i] - b.high[i]) > kJut_m))
                return false;
        return true;
    }
    Box take(int x, int y, int z) {
        int x1 = x + 1, y1 = y + 1, z1 = z + 1;
        Box box = *bounds_of(x, x1, y, y1, z, z1);
        const auto grow = [&](const std::optional<Box>& more, std::size_t along) {
            if (!more || !fits(box, *more, along)) return false;
            widen(box, more->low), widen(box, more->high);
            return true;
        };
        while (x1 < count_[0] && grow(bounds_of(x1, x1 + 1, y, y1, z, z1), 0)) ++x1;
        while (z1 < count_[2] && grow(bounds_of(x, x1, y, y1, z1, z1 + 1), 2)) ++z1;
        while (y1 < count_[1] && grow(bounds_of(x, x1, y1, y1 + 1, z, z1), 1)) ++y1;
        for (int j = y; j < y1; ++j)
            for (int k = z; k < z1; ++k)
                for (int i = x; i < x1; ++i) full_[index(i, j, k)] = false;
        for (std::size_t a = 0; a < 3; ++a) {
            const float lack = 0.5f * (kThinnest_m - (box.high[a] - box.low[a]));
            if (lack > 0) box.low[a] -= lack, box.high[a] += lack;
        }
        return box;
    }

    Box bounds_;
    std::array<int, 3> count_{};
    std::array<float, 3> size_{};
    std::vector<Box> cells_;
    std::vector<bool> full_;
};

void append(Triangles& out, const Mesh& mesh, const Rigid& boxes_from_world) {
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3)
        out.push_back({boxes_from_world * mesh.positions[mesh.triangles[t]],
                       boxes_from_world * mesh.positions[mesh.triangles[t + 1]],
                       boxes_from_world * mesh.positions[mesh.triangles[t + 2]]});
}

struct Source {
    Collider collider;
    Triangles triangles;
    bool whole = false;    // one box
    bool exact = false;    // … known already
    bool passage = false;  // one walks through it: its cells stay small
};

// What gets boxes, besides the floor.
std::vector<Source> sources(const Room& room, float floor_y) {
    std::vector<Source> out;
    const std::vector<std::string> ids = object_ids(room);
    const std::vector<ObjectBox> boxes = object_boxes(room);
    for (std::size_t i = 0; i < room.objects.size(); ++i) {
        const Rigid& pose = room.objects[i].world_from_object;
        if (boxes[i].empty) continue;
        float top_y = 1e9f;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3f p{corner & 1 ? boxes[i].high.x : boxes[i].low.x, corner & 2 ? boxes[i].high.y : boxes[i].low.y,
                          corner & 4 ? boxes[i].high.z : boxes[i].low.z};
            top_y = std::min(top_y, (pose * p).y);
        }
        Source source{{ids[i], pose, {}}, {}};
        if (is_raised_floor(room.objects[i])) {  // without the noses of steps
            const Vec3f size = room.objects[i].size_m;
            source.collider.boxes = {{{-size.x / 2, 0, -size.z / 2}, {size.x / 2, size.y, size.z / 2}}};
            source.exact = true;
            out.push_back(std::move(source));
            continue;
        }
        const Vec3f foot = pose.translation;
        if (std::min(floor_y, floor_at(room, {foot.x, foot.z})) - top_y < kStep_m) continue;
        for (const Mesh& mesh : room.meshes)
            if (mesh.object == static_cast<int>(i)) append(source.triangles, mesh, inverse(pose));
        // Panes are not modelled, but nobody can walk through them.
        source.whole = room.objects[i].kind.find("window") != std::string::npos;
        source.passage = room.objects[i].kind.find("door") != std::string::npos;
        out.push_back(std::move(source));
    }
    const Rigid plan{plan_from_world(room), {}};
    for (const Shell kind : {Shell::ceiling, Shell::walls}) {
        Source source{{kShellNames[static_cast<std::size_t>(kind)], inverse(plan), {}}, {}};
        for (const Mesh& mesh : room.meshes)
            if (mesh.object < 0 && shell_of(room, mesh) == kind) append(source.triangles, mesh, plan);
        if (!source.triangles.empty()) out.push_back(std::move(source));
    }
    return out;
}

// Eight corners that the faces share, so that the surface is closed; faces wind counterclockwise seen from outside.
void append_box(const Box& box, std::vector<Vec3f>& corners, std::vector<std::uint32_t>& triangles) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (int i = 0; i < 8; ++i)
        corners.push_back(
            {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z});
    constexpr std::uint32_t kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : kFaces)
        for (const std::uint32_t k : {f[0], f[1], f[2], f[0], f[2], f[3]}) triangles.push_back(first + k);
}

Collider floor_slab(const Room& room, float floor_y) {
    const Rigid plan{plan_from_world(room), {}};
    Box slab = nothing();
    for (const Mesh& mesh : room.meshes)
        if (mesh.object < 0 && shell_of(room, mesh) == Shell::floor)
            for (const Vec3f p : mesh.positions) widen(slab, plan * p);
    slab.low.y = floor_y;
    slab.high.y = floor_y + kSlab_m;
    return {"floor", inverse(plan), {slab}};
}

}  // namespace

std::vector<Collider> colliders(const Room& room, float floor_y) {
    const std::vector<Source> from = sources(room, floor_y);
    for (float cell = kFinestCell_m;; cell *= kCellGrowth) {
        std::vector<Collider> out{floor_slab(room, floor_y)};
        std::size_t boxes = 1;
        for (const Source& source : from) {
            Collider collider = source.collider;
            const bool shell = collider.id == "walls" || collider.id == "ceiling";
            constexpr float kOneCell_m = 1e6f;
            const float size = source.whole     ? kOneCell_m
                               : source.passage ? kFinestCell_m
                               : shell          ? std::min(cell, kCoarsestShell_m)
                                                : cell;
            if (!source.exact) collider.boxes = Grid(source.triangles, size).boxes();
            boxes += collider.boxes.size();
            out.push_back(std::move(collider));
        }
        if (boxes * kTrianglesOfBox <= kMostColliderTriangles || cell > 10) return out;
    }
}

std::string collision_glb_bytes(const Room& room, float floor_y) {
    Gltf gltf;
    Json roots = Json::array();
    for (const Collider& collider : colliders(room, floor_y)) {
        std::vector<Vec3f> corners;
        std::vector<std::uint32_t> triangles;
        for (const Box& box : collider.boxes) append_box(box, corners, triangles);
        if (corners.empty()) continue;
        const Json primitive{{"attributes", {{"POSITION", gltf.add_positions(corners)}}},
                             {"indices", gltf.add_indices(triangles)}};
        Json node{{"name", collider.id},
                  {"mesh", gltf.add("meshes", {{"name", collider.id}, {"primitives", Json::array({primitive})}})}};
        set_pose(node, Rigid{kGltfAxes, {}} * collider.world_from_boxes);
        node["extras"] = {{"id", collider.id}, {"boxes", collider.boxes.size()}};
        roots.push_back(gltf.add("nodes", std::move(node)));
    }
    return gltf.bytes({{"name", "collision"}, {"nodes", roots}});
}

}  // namespace fastscene
