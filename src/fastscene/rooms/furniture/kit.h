// The workbench that builders share: collects parts into a Piece.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "fastscene/base/random.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/shapes.h"

namespace fastscene::furniture {

using shapes::Limb;
using shapes::Soft;

// Depth of creases in metres: of tight upholstery, of pillows, of hides that lie loose, of cloth whose folds are its
// shape already.
inline constexpr float kUpholsteryCrease = 0.003f, kPillowCrease = 0.005f, kHideCrease = 0.008f, kDrapedCrease = 0.002f;

// What a builder may use: its request, its style, its rng and the piece under construction.
struct Kit {
    const PieceRequest& request;
    const Style& style;
    Random rng;
    Piece piece;
    bool sized = false;  // the builder has heeded the wished size itself

    // Registers a material and returns its index.
    int material(Material m) {
        piece.materials.push_back(std::move(m));
        return static_cast<int>(piece.materials.size()) - 1;
    }
    // The material that wishes of color, material and pattern change: registered once, first.
    int main(Material m, bool printed = true);
    // The pattern that was asked for, on this ground; `said`: the color that was said of it.
    void print(Material& m, std::optional<Vec3f> said) const;
    std::uint32_t seed() { return rng.next_u32(); }

    Mesh& add(Mesh mesh, int material_index, Vec3f at = {}) {
        shapes::move(mesh, at);
        mesh.material = material_index;
        piece.meshes.push_back(std::move(mesh));
        return piece.meshes.back();
    }
    // A hard box by its center's x, z and its lower edge; the grain is shifted so that no two boards are alike.
    void board(int material_index, Vec3f base_center, Vec3f size, float bevel = 0.004f) {
        Mesh m = shapes::box(size, bevel);
        shapes::lay_grain(m, {rng.uniform(0, 3), rng.uniform(0, 3), rng.uniform(0, 3)});
        add(std::move(m), material_index, base_center + Vec3f{0, 0.5f * size.y, 0});
    }
    // A mesh whose cloth gives way: its material gets creases this deep, in metres.
    void add_soft(Mesh mesh, int material_index, float crease_m, Vec3f at = {}) {
        float& crease = piece.materials[static_cast<std::size_t>(material_index)].crease_m;
        crease = std::max(crease, crease_m);
        add(std::move(mesh), material_index, at);
    }
    void soft(int material_index, Vec3f base_center, Vec3f size, Soft how) {
        how.seed = seed();
        add_soft(shapes::soft_box(size, how), material_index, kUpholsteryCrease,
                 base_center + Vec3f{0, 0.5f * size.y, 0});
    }
    void rod(int material_index, Vec3f a, Vec3f b, float ra, float rb = -1.f, int sides = 10) {
        add(shapes::rod(a, b, ra, rb < 0 ? ra : rb, sides), material_index);
    }
    void top(float y, float cx, float cz, float half_x, float half_z) {
        piece.surfaces.push_back({{cx, y, cz}, {half_x, half_z}});
    }
    // Small things of the style on a top.
    Vec3f accent() {
        return style.palette[static_cast<std::size_t>(rng.index(static_cast<int>(style.palette.size())))];
    }
    void merge(const Piece& other, Vec3f at, float turn_deg = 0.f);
    Piece small(std::string kind);
    // Wished extents in place of the usual ones.
    Vec3f wanted(Vec3f usual) {
        sized = true;
        Vec3f s = usual * request.size_factor;
        for (std::size_t k = 0; k < 3; ++k)
            if (request.size_m[k] > 0.f) s[k] = request.size_m[k];
        return s;
    }
};

Material plain(std::string name, Vec3f color, float roughness);
Material glow(std::string name, Vec3f radiance);
Material lit(std::string name, Vec3f radiance);    // shines at any hour, as screens do
Material flame(std::string name, Vec3f radiance);  // burns at any hour
Material tinted(Material m, Vec3f color);          // recolored, keeping the ratio of its second color
Material glass();
Material porcelain();
// "velvet chairs", "leather stools": what was asked for covers a seat, and never its legs.
bool is_upholstery(const std::string& material);
Material steel();
// The unit vector at this angle about y.
Vec3f around(float angle);
inline void on_surface(Kit& k) { k.piece.mount = Mount::surface; }
// A flat bar from a to b in a plane of constant x: `wide` along x, `thick` across.
void strut(Kit& k, int material, Vec3f a, Vec3f b, float wide, float thick);
// The same in a plane of constant z: `wide` in it, `thick` along z.
void slat(Kit& k, int material, Vec3f a, Vec3f b, float wide, float thick);
// The outline of a star with five points, one of them up.
std::vector<Vec2f> star(float outer, float inner);

// Four legs of the style under a top: half extents to the legs' middles, from the floor to y.
void legs(Kit& k, int material_index, float half_x, float half_z, float y, float thickness = 0.05f);
// A row of books along +x from `at` (front face at z = at.z + depth), `length` wide; heights below max_height.
void books(Kit& k, Vec3f at, float length, float max_height, float depth);
// Fronts of doors or drawers on the plane z, over x0..x1, y0..y1, in the style's manner.
void fronts(Kit& k, int material_index, int metal, float x0, float x1, float y0, float y1, float z, int columns,
            int rows);

inline constexpr float kTau = 2 * kPi;

}  // namespace fastscene::furniture
