#include "fastscene/export/bake.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "fastscene/base/parallel.h"
#include "fastscene/export/identities.h"
#include "fastscene/image/color.h"
#include "fastscene/trace/texture.h"

namespace fastscene {
namespace {

// Texels around each piece of an atlas, so that neither bilinear filtering nor the first mip levels mix it with its
// neighbors.
constexpr int kGutter = 4;
// Pieces of a pattern whose depths differ by less share texels: fine grain changes over less than what is noticed.
constexpr float kSameDepth_m = 0.05f;
constexpr float kDensityStep = 0.85f;  // how the density shrinks until the atlas fits

// A rectangle of a pattern's plane.
struct Piece {
    int axis = 2;
    Vec2f low, high;
    float depth_low = 0, depth_high = 0;
    int x = 0, y = 0, width = 0, height = 0;  // texels, without the gutter
    float texels_per_unit = 1;

    float depth() const { return 0.5f * (depth_low + depth_high); }
    float area() const { return (high.x - low.x) * (high.y - low.y); }
    Vec3f coords_at(Vec2f flat) const {
        return axis == 2   ? Vec3f{flat.x, flat.y, depth()}
               : axis == 1 ? Vec3f{flat.x, depth(), flat.y}
                           : Vec3f{depth(), flat.y, flat.x};
    }
};
float depth_of(Vec3f coords, int axis) { return axis == 2 ? coords.z : axis == 1 ? coords.y : coords.x; }

int axis_of_triangle(const Mesh& mesh, std::size_t first) {
    const Vec3f a = mesh.coords[mesh.triangles[first]], b = mesh.coords[mesh.triangles[first + 1]],
                c = mesh.coords[mesh.triangles[first + 2]];
    return dominant_axis(cross(b - a, c - a));
}

void widen(Piece& piece, Vec3f coords) {
    const Vec2f flat = flat_coords(coords, piece.axis);
    const float depth = depth_of(coords, piece.axis);
    piece.low = {std::min(piece.low.x, flat.x), std::min(piece.low.y, flat.y)};
    piece.high = {std::max(piece.high.x, flat.x), std::max(piece.high.y, flat.y)};
    piece.depth_low = std::min(piece.depth_low, depth);
    piece.depth_high = std::max(piece.depth_high, depth);
}

Piece united(const Piece& a, const Piece& b) {
    Piece u = a;
    u.low = {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)};
    u.high = {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)};
    u.depth_low = std::min(a.depth_low, b.depth_low);
    u.depth_high = std::max(a.depth_high, b.depth_high);
    return u;
}
// Whether one rectangle for both costs no more texels than two.
bool share(const Piece& a, const Piece& b) {
    return a.axis == b.axis && std::fabs(a.depth() - b.depth()) < kSameDepth_m &&
           united(a, b).area() <= a.area() + b.area();
}

// The pieces of one material, and which of them each (mesh, axis) uses.
struct Atlas {
    std::vector<Piece> pieces;
    std::map<std::pair<int, int>, std::size_t> piece_of;
    int width = 0, height = 0;
};

void add_mesh(Atlas& atlas, const Mesh& mesh, int index) {
    for (int axis = 0; axis < 3; ++axis) {
        Piece piece{axis, {1e9f, 1e9f}, {-1e9f, -1e9f}, 1e9f, -1e9f};
        bool any = false;
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
            if (axis_of_triangle(mesh, t) != axis) continue;
            any = true;
            for (std::size_t k = 0; k < 3; ++k) widen(piece, mesh.coords[mesh.triangles[t + k]]);
        }
        if (!any) continue;
        const auto found = std::find_if(atlas.pieces.begin(), atlas.pieces.end(),
                                        [&](const Piece& other) { return share(other, piece); });
        atlas.piece_of[{index, axis}] = static_cast<std::size_t>(found - atlas.pieces.begin());
        if (found == atlas.pieces.end()) atlas.pieces.push_back(piece);
        else *found = united(*found, piece);
    }
}

// Rows of pieces, high ones first. Returns the height.
int pack_rows(std::vector<Piece>& pieces, int width) {
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return pieces[a].height > pieces[b].height; });
    int x = 0, y = 0, row = 0;
    for (const std::size_t i : order) {
        Piece& p = pieces[i];
        const int w = p.width + 2 * kGutter, h = p.height + 2 * kGutter;
        if (x > 0 && x + w > width) x = 0, y += row, row = 0;
        p.x = x + kGutter, p.y = y + kGutter;
        x += w, row = std::max(row, h);
    }
    return y + row;
}

bool shows_picture(const Material& m) { return m.pattern == Pattern::screen && m.image; }
// Coordinates of a picture are shares of its width.
float metres_per_unit(const Material& m) { return m.pattern == Pattern::image || shows_picture(m) ? m.scale_m : 1.f; }

// Places the pieces within texture_size, as densely as asked for or as fits. Throws UsageError if not even a texel for
// each does.
void lay_out(Atlas& atlas, const Material& material, const BakeParams& params) {
    const int most = params.texture_size;
    for (float density = params.texels_per_metre * metres_per_unit(material);; density *= kDensityStep) {
        double area = 0;
        int widest = 0;
        bool can_shrink = false;
        for (Piece& p : atlas.pieces) {
            p.texels_per_unit = density;
            p.width = std::max(1, static_cast<int>(std::ceil(std::min((p.high.x - p.low.x) * density, 1e6f))));
            p.height = std::max(1, static_cast<int>(std::ceil(std::min((p.high.y - p.low.y) * density, 1e6f))));
            can_shrink = can_shrink || p.width > 1 || p.height > 1;
            widest = std::max(widest, p.width + 2 * kGutter);
            area += static_cast<double>(p.width + 2 * kGutter) * (p.height + 2 * kGutter);
        }
        if (widest > most && can_shrink) continue;
        const int width = std::clamp(static_cast<int>(1.1 * std::sqrt(area)), widest, most);
        for (const int w : {width, most}) {
            const int height = pack_rows(atlas.pieces, w);
            if (height > most) continue;
            atlas.width = 0;
            for (const Piece& p : atlas.pieces) atlas.width = std::max(atlas.width, p.x + p.width + kGutter);
            atlas.height = height;
            return;
        }
        if (!can_shrink)
            throw UsageError("--texture-size: expected room for the {} pieces of \"{}\", found {} pixels",
                             atlas.pieces.size(), material.name, most);
    }
}

BakedMaterial bake_texture(const Atlas& atlas, const Material& material) {
    BakedMaterial baked;
    baked.texture = ImageRgb8(atlas.width, atlas.height, srgb8_from_linear(mean_albedo(material)));
    if (shows_picture(material)) {
        Material white = material;
        white.emission = {1, 1, 1};
        baked.shown = ImageRgb8(atlas.width, atlas.height, srgb8_from_linear(mean_emission(white)));
    }
    Vec3<double> sum{};
    double roughness = 0, count = 0;
    for (const Piece& p : atlas.pieces) {
        const float footprint = 1.f / p.texels_per_unit * metres_per_unit(material);
        const int rows = p.height + 2 * kGutter;
        std::vector<Vec3<double>> row_sum(at(rows));
        std::vector<double> row_roughness(at(rows));
        parallel_for(rows, 8, [&](std::int64_t begin, std::int64_t end) {
            for (int j = static_cast<int>(begin) - kGutter; j < static_cast<int>(end) - kGutter; ++j)
                for (int i = -kGutter; i < p.width + kGutter; ++i) {
                    const Vec2f flat = p.low + Vec2f{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f} *
                                                   (1.f / p.texels_per_unit);
                    const TextureValue v = sample_texture(material, {p.coords_at(flat), flat, footprint});
                    baked.texture.at(p.x + i, p.y + j) = srgb8_from_linear(v.albedo);
                    if (!baked.shown.empty()) baked.shown.at(p.x + i, p.y + j) = srgb8_from_linear(v.shown);
                    row_sum[at(j + kGutter)] += Vec3<double>{v.albedo.x, v.albedo.y, v.albedo.z};
                    row_roughness[at(j + kGutter)] += static_cast<double>(v.roughness);
                }
        });
        for (int j = 0; j < rows; ++j) sum += row_sum[at(j)], roughness += row_roughness[at(j)];
        count += static_cast<double>(rows) * (p.width + 2 * kGutter);
    }
    baked.color = {static_cast<float>(sum.x / count), static_cast<float>(sum.y / count),
                   static_cast<float>(sum.z / count)};
    baked.roughness = static_cast<float>(roughness / count);
    return baked;
}

BakedMesh map_mesh(const Mesh& mesh, int index, const Atlas* atlas) {
    BakedMesh out;
    std::map<std::pair<std::uint32_t, int>, std::uint32_t> split;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const int axis = atlas ? axis_of_triangle(mesh, t) : 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.triangles[t + k];
            const auto [entry, is_new] = split.try_emplace({vertex, axis},
                                                           static_cast<std::uint32_t>(out.vertices.size()));
            out.triangles.push_back(entry->second);
            if (!is_new) continue;
            out.vertices.push_back(vertex);
            if (!atlas) continue;
            const Piece& p = atlas->pieces[atlas->piece_of.at({index, axis})];
            const Vec2f texel = (flat_coords(mesh.coords[vertex], axis) - p.low) * p.texels_per_unit;
            out.uv.push_back({(static_cast<float>(p.x) + texel.x) / static_cast<float>(atlas->width),
                              (static_cast<float>(p.y) + texel.y) / static_cast<float>(atlas->height)});
        }
    }
    return out;
}

auto key_of(const Material& m) {
    const auto v = [](Vec3f c) { return std::tuple(c.x, c.y, c.z); };
    return std::tuple(m.name, m.pattern, v(m.color_a), v(m.color_b), v(m.color_c), v(m.emission),
                      std::tuple(m.scale_m, m.bump_m, m.roughness, m.specular, m.metal, m.transmission, m.mirror,
                                 m.crease_m, m.sheen),
                      m.burns, m.seed, m.variant, m.image.get(), m.normals.get(), m.metallic_roughness.get());
}

}  // namespace

std::vector<int> same_materials(const std::vector<Material>& materials) {
    std::map<decltype(key_of(materials.front())), int> first;
    std::vector<int> same;
    for (const Material& m : materials)
        same.push_back(first.try_emplace(key_of(m), static_cast<int>(same.size())).first->second);
    return same;
}

BakedRoom bake(const Room& room, const std::vector<int>& same, const BakeParams& params, const Run& run) {
    BakedRoom baked;
    baked.materials.resize(room.materials.size());
    std::map<int, Atlas> atlases;
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const int material = same[at(room.meshes[m].material)];
        if (room.materials[at(material)].pattern != Pattern::plain && !room.meshes[m].triangles.empty())
            add_mesh(atlases[material], room.meshes[m], static_cast<int>(m));
    }
    Progress progress(run, "textures", static_cast<std::int64_t>(atlases.size()));
    for (auto& [material, atlas] : atlases) {
        run.check_stop();
        lay_out(atlas, room.materials[at(material)], params);
        baked.materials[at(material)] = bake_texture(atlas, room.materials[at(material)]);
        progress.advance();
    }
    for (std::size_t m = 0; m < room.materials.size(); ++m)
        if (room.materials[m].pattern == Pattern::plain)
            baked.materials[m] = {{}, {}, room.materials[m].color_a, room.materials[m].roughness};
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const auto found = atlases.find(same[at(room.meshes[m].material)]);
        baked.meshes.push_back(
            map_mesh(room.meshes[m], static_cast<int>(m), found == atlases.end() ? nullptr : &found->second));
    }
    return baked;
}

}  // namespace fastscene
