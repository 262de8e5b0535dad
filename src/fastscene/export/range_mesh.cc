#include "fastscene/export/range_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/export/collision.h"
#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/room_model.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr int kFinestColumns = 1024;  // of the grid: 0.35 degrees
constexpr int kCoarsestColumns = 64;
constexpr int kLargestCell = 16;  // of the grid: textures, which are not linear on a plane, would bend in larger ones
constexpr float kFinestBend = 0.004f;  // how far a surface may lie beside its triangles, as a share of its range
constexpr float kCoarsestBend = 0.06f;
constexpr float kFarthest_m = 60;  // what is farther is scenery

// The range map on a grid of pixels, and which of its squares are surface.
class RangeGrid {
  public:
    RangeGrid(const Panorama& panorama, int columns, bool only_own)
        : columns_(columns), rows_(columns / 2), full_{panorama.range.width, panorama.range.height} {
        range_ = ImageF(columns_, rows_);
        ImageMask own(columns_, rows_);
        for (int y = 0; y < rows_; ++y)
            for (int x = 0; x < columns_; ++x) {
                const auto [px, py] = pixel(x, y);
                range_.at(x, y) = panorama.range.at(px, py);
                own.at(x, y) = !only_own || panorama.known.empty() || panorama.known.at(px, py) == Known::invented;
            }
        for (float& r : range_.pixels)
            if (!(r > 0)) r = std::numeric_limits<float>::infinity();
        const ImageMask cuts = range_edges(range_);
        surface_ = cut_ = ImageMask(columns_, rows_ - 1);
        for (int y = 0; y + 1 < rows_; ++y)
            for (int x = 0; x < columns_; ++x) {
                const int next = (x + 1) % columns_;
                const bool cut = (cuts.at(x, y) & (kCutRight | kCutDown)) || (cuts.at(x, y + 1) & kCutRight) ||
                                 (cuts.at(next, y) & kCutDown);
                bool near = true, mine = false;
                for (const auto& [i, j] : {std::pair{x, y}, {next, y}, {x, y + 1}, {next, y + 1}}) {
                    near = near && range_.at(i, j) < kFarthest_m;
                    mine = mine || own.at(i, j);
                }
                surface_.at(x, y) = near && mine && !cut;
                cut_.at(x, y) = near && mine && cut;
            }
    }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool is_surface(int x, int y) const { return y + 1 < rows_ && surface_.at(x % columns_, y) != 0; }
    // A silhouette runs through it.
    bool is_cut(int x, int y) const { return cut_.at(x, y) != 0; }
    float range(int x, int y) const { return range_.at(x % columns_, y); }
    // In the panorama's frame.
    Vec3f place(int x, int y) const { return place_at(x, y, range(x, y)); }
    Vec3f place_at(int x, int y, float range) const {
        const auto [px, py] = pixel(x, y);
        return direction_of_pixel(px, py, full_) * range;
    }
    // In its picture; beyond 1 past the last column.
    Vec2f uv(int x, int y) const {
        const auto [px, py] = pixel(x, y);
        return {(static_cast<float>(px) + 0.5f) / static_cast<float>(full_.width) + (x >= columns_ ? 1.f : 0.f),
                (static_cast<float>(py) + 0.5f) / static_cast<float>(full_.height)};
    }

  private:
    // The pixel of the range map at a grid point.
    std::pair<int, int> pixel(int x, int y) const {
        return {(2 * (x % columns_) + 1) * full_.width / (2 * columns_), (2 * y + 1) * full_.height / (2 * rows_)};
    }
    int columns_, rows_;
    EquirectSize full_;
    ImageF range_;
    ImageMask surface_, cut_;
};

struct Cell {
    int x, y, size;
};

// Whether the square of that size is surface, and two triangles are near enough to all of it.
bool is_flat(const RangeGrid& grid, Cell c, float bend) {
    for (int j = 0; j < c.size; ++j)
        for (int i = 0; i < c.size; ++i)
            if (!grid.is_surface(c.x + i, c.y + j)) return false;
    const Vec3f a = grid.place(c.x, c.y), b = grid.place(c.x + c.size, c.y), d = grid.place(c.x, c.y + c.size),
                e = grid.place(c.x + c.size, c.y + c.size);
    // The ray through a grid point meets the plane of its triangle; compared is how far out.
    const std::array<Vec3f, 2> normal{cross(b - a, d - a), cross(d - e, b - e)};
    const std::array<Vec3f, 2> on{a, e};
    for (int j = 0; j <= c.size; ++j)
        for (int i = 0; i <= c.size; ++i) {
            const Vec3f p = grid.place(c.x + i, c.y + j);
            const std::size_t t = i + j <= c.size ? 0 : 1;
            const float meets = dot(normal[t], p), wanted = dot(normal[t], on[t]);
            if (!(std::fabs(meets - wanted) <= bend * std::fabs(meets))) return false;
        }
    return true;
}

// Squares of the grid, as large as they are flat.
void divide(const RangeGrid& grid, Cell cell, float bend, std::vector<Cell>& out) {
    if (cell.y + cell.size < grid.rows() && is_flat(grid, cell, bend)) return out.push_back(cell);
    if (cell.size == 1) return;
    const int half = cell.size / 2;
    for (const auto& [i, j] : {std::pair{0, 0}, {half, 0}, {0, half}, {half, half}})
        divide(grid, {cell.x + i, cell.y + j, half}, bend, out);
}

// Triangles of the squares. A square beside smaller ones has their corners on its own edges too, so that no gap opens.
class CellMesh {
  public:
    CellMesh(const RangeGrid& grid, const std::vector<Cell>& cells, const Rigid& world_from_pano)
        : grid_(grid), world_from_pano_(world_from_pano), corner_(grid.columns() + 1, grid.rows()) {
        for (const Cell& c : cells)
            for (const auto& [x, y] :
                 {std::pair{c.x, c.y}, {c.x + c.size, c.y}, {c.x, c.y + c.size}, {c.x + c.size, c.y + c.size}}) {
                corner_.at(x, y) = 1;
                if (x == 0) corner_.at(grid.columns(), y) = 1;
                if (x == grid.columns()) corner_.at(0, y) = 1;
            }
        for (const Cell& c : cells) add(c);
    }
    RangeSurface surface() { return std::move(surface_); }

  private:
    // Clockwise as seen from the viewpoint, whose rows go down: triangles that face it wind the other way in space.
    void add(const Cell& c) {
        std::vector<std::uint32_t> ring;
        const auto along = [&](int x, int y, int dx, int dy) {
            for (int k = 0; k < c.size; ++k)
                if (corner_.at(x + k * dx, y + k * dy)) ring.push_back(vertex(x + k * dx, y + k * dy));
        };
        along(c.x, c.y, 0, 1);
        along(c.x, c.y + c.size, 1, 0);
        along(c.x + c.size, c.y + c.size, 0, -1);
        along(c.x + c.size, c.y, -1, 0);
        if (ring.size() == 4) {
            for (const std::size_t k : {0u, 1u, 3u, 1u, 2u, 3u}) surface_.triangles.push_back(ring[k]);
            return;
        }
        const std::uint32_t middle = vertex(c.x + c.size / 2, c.y + c.size / 2);
        for (std::size_t k = 0; k < ring.size(); ++k)
            for (const std::uint32_t v : {middle, ring[k], ring[(k + 1) % ring.size()]})
                surface_.triangles.push_back(v);
    }
    std::uint32_t vertex(int x, int y) {
        const auto [entry, is_new] = known_.try_emplace({x, y}, static_cast<std::uint32_t>(known_.size()));
        if (is_new) {
            surface_.positions.push_back(world_from_pano_ * grid_.place(x, y));
            surface_.uv.push_back(grid_.uv(x, y));
        }
        return entry->second;
    }

    const RangeGrid& grid_;
    Rigid world_from_pano_;
    ImageMask corner_;  // of a square of any size
    std::map<std::pair<int, int>, std::uint32_t> known_;
    RangeSurface surface_;
};

// What is behind a silhouette goes on behind it for a square: seen from the viewpoint no gap shows, and from elsewhere
// nothing hangs between the two. Its color is that beside the silhouette.
void add_behind_silhouettes(const RangeGrid& grid, const Rigid& world_from_pano, RangeSurface& to) {
    constexpr float kBeside = 0.97f;  // of the farthest corner's range: on the same surface as it
    for (int y = 0; y + 1 < grid.rows(); ++y)
        for (int x = 0; x < grid.columns(); ++x) {
            if (!grid.is_cut(x, y)) continue;
            const std::array<std::pair<int, int>, 4> corners{{{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}}};
            const auto far = *std::max_element(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
                return grid.range(a.first, a.second) < grid.range(b.first, b.second);
            });
            const float range = grid.range(far.first, far.second);
            const auto first = static_cast<std::uint32_t>(to.positions.size());
            for (const auto& [i, j] : corners) {
                const bool beside = grid.range(i, j) > kBeside * range;
                to.positions.push_back(world_from_pano * grid.place_at(i, j, beside ? grid.range(i, j) : range));
                to.uv.push_back(beside ? grid.uv(i, j) : grid.uv(far.first, far.second));
            }
            for (const std::uint32_t k : {0u, 1u, 3u, 1u, 2u, 3u}) to.triangles.push_back(first + k);
        }
}

std::size_t triangles_of(const std::vector<RangeSurface>& surfaces) {
    std::size_t sum = 0;
    for (const RangeSurface& s : surfaces) sum += s.triangles.size() / 3;
    return sum;
}

std::vector<RangeSurface> surfaces_with(const std::vector<Panorama>& panoramas, int columns, float bend, bool closed) {
    std::vector<RangeSurface> out;
    for (std::size_t p = 0; p < panoramas.size(); ++p) {
        const RangeGrid grid(panoramas[p], columns, p > 0);
        std::vector<Cell> cells;
        for (int y = 0; y < grid.rows(); y += kLargestCell)
            for (int x = 0; x < grid.columns(); x += kLargestCell) divide(grid, {x, y, kLargestCell}, bend, cells);
        out.push_back(CellMesh(grid, cells, panoramas[p].world_from_pano).surface());
        if (closed) add_behind_silhouettes(grid, panoramas[p].world_from_pano, out.back());
    }
    return out;
}

std::string texture_of(const Panorama& panorama, int texture_size) {
    ImageColor color = panorama.color;
    while (color.width > texture_size && color.width % 2 == 0 && color.height % 2 == 0) {
        ImageColor half(color.width / 2, color.height / 2);
        for (int y = 0; y < half.height; ++y)
            for (int x = 0; x < half.width; ++x)
                half.at(x, y) = (color.at(2 * x, 2 * y) + color.at(2 * x + 1, 2 * y) + color.at(2 * x, 2 * y + 1) +
                                 color.at(2 * x + 1, 2 * y + 1)) *
                                0.25f;
        color = std::move(half);
    }
    return texture_jpeg(srgb8_from_linear(color));
}

Json primitive_of(Gltf& gltf, const RangeSurface& surface) {
    std::vector<Vec3f> positions;
    for (const Vec3f p : surface.positions) positions.push_back(kGltfAxes * p);
    return {{"attributes", {{"POSITION", gltf.add_positions(positions)}}},
            {"indices", gltf.add_indices(surface.triangles)}};
}

void check_not_empty(const std::vector<RangeSurface>& surfaces) {
    if (triangles_of(surfaces) == 0) throw Error("mesh: expected surfaces within {} m, found none", kFarthest_m);
}

}  // namespace

std::vector<RangeSurface> range_surfaces(const std::vector<Panorama>& panoramas, int most_triangles, bool closed,
                                         const Run& run) {
    for (const Panorama& p : panoramas)
        if (p.range.empty()) throw Error("mesh: expected panoramas with range, found one without");
    int finest = kFinestColumns;  // not finer than the pixels
    for (const Panorama& p : panoramas)
        while (finest > p.range.width && finest > kCoarsestColumns) finest /= 2;
    for (int columns = finest;; columns /= 2)
        for (float bend = kFinestBend; bend < kCoarsestBend; bend *= 1.5f) {
            run.check_stop();
            std::vector<RangeSurface> out = surfaces_with(panoramas, columns, bend, closed);
            if (triangles_of(out) <= at(most_triangles) || columns == kCoarsestColumns) return out;
        }
}

std::string range_mesh_glb_bytes(const std::vector<Panorama>& panoramas, int texture_size, const Run& run) {
    const std::vector<RangeSurface> surfaces = range_surfaces(panoramas, kMostRangeTriangles, true, run);
    check_not_empty(surfaces);
    Gltf gltf;
    gltf.use("KHR_materials_unlit");
    Json roots = Json::array();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces[i].triangles.empty()) continue;
        const std::string name = fmt::format("panorama-{:03}", i);
        Json primitive = primitive_of(gltf, surfaces[i]);
        primitive["attributes"]["TEXCOORD_0"] = gltf.add_uv(surfaces[i].uv);
        const int image = gltf.add_image(texture_of(panoramas[i], texture_size), "image/jpeg", name);
        primitive["material"] = gltf.add(
            "materials",
            {{"name", name},
             {"pbrMetallicRoughness",
              {{"baseColorTexture", {{"index", gltf.add("textures", {{"source", image}})}}}, {"metallicFactor", 0}}},
             {"doubleSided", true},
             {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
        const int mesh = gltf.add("meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
        roots.push_back(gltf.add("nodes", {{"name", name}, {"mesh", mesh}}));
    }
    return gltf.bytes({{"name", "mesh"}, {"nodes", roots}});
}

std::string range_collision_glb_bytes(const std::vector<Panorama>& panoramas, const Run& run) {
    const std::vector<RangeSurface> surfaces = range_surfaces(panoramas, kMostColliderTriangles, false, run);
    check_not_empty(surfaces);
    Gltf gltf;
    Json roots = Json::array();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces[i].triangles.empty()) continue;
        const std::string name = fmt::format("panorama-{:03}", i);
        const int mesh = gltf.add("meshes",
                                  {{"name", name}, {"primitives", Json::array({primitive_of(gltf, surfaces[i])})}});
        roots.push_back(gltf.add("nodes", {{"name", name}, {"mesh", mesh}}));
    }
    return gltf.bytes({{"name", "collision"}, {"nodes", roots}});
}

}  // namespace fastscene
