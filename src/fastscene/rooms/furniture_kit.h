// The workbench the furniture_*.cc files share: collects parts into a Piece.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "fastscene/base/random.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/shapes.h"

namespace fastscene::furniture {

using shapes::Soft;

// What a builder may use: its request, its style, its dice and the piece under construction.
struct Kit {
    const PieceRequest& request;
    const Style& style;
    Random dice;
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
    std::uint32_t seed() { return dice.next_u32(); }

    Mesh& add(Mesh mesh, int material_index, Vec3f at = {}) {
        shapes::move(mesh, at);
        mesh.material = material_index;
        piece.meshes.push_back(std::move(mesh));
        return piece.meshes.back();
    }
    // A hard box by its center's x, z and its lower edge; the grain is shifted so that no two boards are alike.
    void board(int material_index, Vec3f base_center, Vec3f size, float bevel = 0.004f) {
        Mesh m = shapes::box(size, bevel);
        shapes::lay_grain(m, {dice.uniform(0, 3), dice.uniform(0, 3), dice.uniform(0, 3)});
        add(std::move(m), material_index, base_center + Vec3f{0, 0.5f * size.y, 0});
    }
    void soft(int material_index, Vec3f base_center, Vec3f size, Soft how) {
        how.seed = seed();
        add(shapes::soft_box(size, how), material_index, base_center + Vec3f{0, 0.5f * size.y, 0});
    }
    void rod(int material_index, Vec3f a, Vec3f b, float ra, float rb = -1.f, int sides = 10) {
        add(shapes::rod(a, b, ra, rb < 0 ? ra : rb, sides), material_index);
    }
    void top(float y, float cx, float cz, float half_x, float half_z) {
        piece.surfaces.push_back({{cx, y, cz}, {half_x, half_z}});
    }
    // Small things of the style on a top.
    Vec3f accent() {
        return style.palette[static_cast<std::size_t>(dice.index(static_cast<int>(style.palette.size())))];
    }
    void merge(const Piece& other, Vec3f at, float turn_deg = 0.f);
    Piece small(std::string klass);
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
Material flame(std::string name, Vec3f radiance);  // glows at any hour
Material tinted(Material m, Vec3f color);          // recolored, keeping the ratio of its second color
Material glass();
Material porcelain();
// "velvet chairs", "leather stools": what was asked for covers a seat, and never its legs.
bool is_upholstery(const std::string& material);
Material steel();
// What grows (furniture_decor.cc): a leaf's green, a little other each time; a leaf from `base` in direction `out`
// (unit, horizontal), rising by `lift`, bending down by `droop`; the unit vector at this angle about y.
Material foliage(Kit& k, Vec3f tone, float scale);
Mesh blade(Vec3f base, Vec3f out, float length, float width, float lift, float droop, float point);
Vec3f around(float angle);
// What a cat is when it sleeps (furniture_keepsakes.cc).
void cat_asleep(Kit& k);

// Four legs of the style under a top: half extents to the legs' middles, from the floor to y.
void legs(Kit& k, int material_index, float half_x, float half_z, float y, float thickness = 0.05f);
// A row of books along +x from `at` (front face at z = at.z + depth), `length` wide; heights below max_height.
void books(Kit& k, Vec3f at, float length, float max_height, float depth);
// Fronts of doors or drawers on the plane z, over x0..x1, y0..y1, in the style's manner.
void fronts(Kit& k, int material_index, int metal, float x0, float x1, float y0, float y1, float z, int columns,
            int rows);

using Builder = void (*)(Kit&);
struct Entry {
    std::string_view klass;
    Builder build;
};
std::span<const Entry> seats();     // sofas, chairs, cushions
std::span<const Entry> beds();      // beds that stand at the wall with their heads, day beds, cots
std::span<const Entry> bunks();     // beds one climbs into, a table to play at
std::span<const Entry> lounges();   // seats of one form: chaise longue, bean bag, hanging chair
std::span<const Entry> tables();    // tables, desks, shelves, cabinets
std::span<const Entry> fixtures();  // kitchen, bathroom
std::span<const Entry> lamps();
std::span<const Entry> decor();          // plants, vases, pictures, textiles, the rest
std::span<const Entry> clutter();        // cups, trays, frames, toys, kitchen things: what stands about
std::span<const Entry> themed();         // what a theme of the prompt brings: a sea chest, a ship, a player's computer
std::span<const Entry> on_walls();       // boards, hangings, trophies, maps, signs
std::span<const Entry> window_covers();  // blinds, shutters
std::span<const Entry>
extras();  // hanging plants, cacti, lanterns, tall clocks, play tents: stands or hangs only when asked for
std::span<const Entry> upheaval();  // decay, renovation, untidiness: what lies about on floors
std::span<const Entry>
keepsakes();  // a dog, a typewriter, bunting, garlands, hooks with coats: what people love and hang up
std::span<const Entry>
wished();  // what nobody has who does not ask for it: a Christmas tree, a hammock, pipes, cobwebs

inline constexpr float kTau = 2 * kPi;

}  // namespace fastscene::furniture
