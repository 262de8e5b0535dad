// Room: a furnished interior as plain triangles, materials and lights, in the world frame (x right,
// y DOWN, z forward, metres; the camera of panorama 0 is the origin). rooms/ makes it, trace/ looks at it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"
#include "fastscene/math/vec.h"

namespace fastscene {

// Procedural patterns (trace/texture.cc draws them), evaluated on Mesh::coords in metres.
enum class Pattern : std::uint8_t {
    plain,
    plaster,
    wood,
    planks,
    herringbone,
    parquet,
    tile,
    checker,
    subway,
    brick,
    concrete,
    marble,
    terrazzo,
    fabric,
    knit,
    carpet,
    leather,
    rug,
    stripes,
    damask,
    floral,
    wicker,
    metal,
    art,
    book,
    leaf,
    grass,
    bark,
    screen,
    dots,
    zigzag,
    twill,
    geometric,
    diamonds,
    lattice,
    stars,
    gingham,
    plaid,
    houndstooth,
    patchwork,
    leopard,
    zebra,
    camouflage,
    paisley,
    encaustic,
    laid_tiles,
    peeling,
    image,  // Material::image by coords.x, coords.y in [0, 1), repeated; tinted by color_a
};

// A picture on a surface, with its halvings down to one pixel.
struct TextureImage {
    std::vector<ImageRgb8> levels;  // levels[0] is the picture; row 0 is its upper edge (v = 1)
};

struct Material {
    std::string name;  // "oak planks", for room.json and debugging
    Pattern pattern = Pattern::plain;
    Vec3f color_a{0.5f, 0.5f, 0.5f};  // linear albedo; the pattern's main color
    Vec3f color_b{0.5f, 0.5f, 0.5f};  // its second color (grout, veins, other stripe …)
    Vec3f color_c{0.5f, 0.5f, 0.5f};  // its third color
    float scale_m = 0.1f;             // size of the pattern's unit (tile edge, plank width, stripe …)
    float bump_m = 0.f;               // height of the relief, for shading only
    float roughness = 0.6f;           // GGX alpha = roughness^2
    float specular = 0.04f;           // reflectance at normal incidence of the dielectric coat
    float metal = 0.f;                // 1: the albedo is the mirror's color
    float transmission = 0.f;         // thin sheets (curtains, leaves, shades): share of diffuse light let through
    float mirror = 0.f;               // 1: perfect mirror (glass of mirrors)
    Vec3f emission{};                 // radiance of lamps, screens and flames
    bool burns = false;               // a flame: it gives its light by day too, and without it nothing is there
    std::uint32_t seed = 0;           // variation of the pattern
    std::shared_ptr<const TextureImage> image{};  // Pattern::image: never null there; scale_m = metres that u = 1 spans
};

// A piece of surface with one material. Closed or open; both sides are seen; normals point outward.
struct Mesh {
    std::vector<Vec3f> positions;  // metres
    std::vector<Vec3f> normals;    // unit, per vertex
    std::vector<Vec3f>
        coords;  // per vertex, metres: where the pattern is evaluated (z is the depth axis of flat patterns)
    std::vector<std::uint32_t> triangles;  // 3 indices each
    int material = 0;                      // index into Room::materials
    int object = -1;                       // index into Room::objects, -1 = the shell of the room
};

struct RoomObject {
    std::string klass;        // "sofa", "window", "wall" …
    std::string name;         // "brown leather sofa"
    std::string color;        // the color's name as asked for or chosen, "" = as the style has it
    Rigid world_from_object;  // object frame: x right, y up, z towards its front, origin on its base's center
    Vec3f size_m;             // along the object's axes
    std::string source;       // "built-in", or the furniture pack and author
    bool requested = false;   // the prompt asked for it
};

// A rectangular hole in a wall through which the sky shines.
struct Portal {
    Vec3f corner, edge_u, edge_v;  // world; edge_u x edge_v points into the room
};

// What is outside, by time and weather.
struct Sky {
    enum class Time : std::uint8_t { morning, day, evening, dusk, night } time = Time::day;
    float clouds = 0.3f;                  // 0 clear … 1 overcast
    Vec3f sun_dir{0, -1, 0};              // world, unit, towards the sun (or the moon)
    Vec3f sun_irradiance{};               // on a surface that faces it; zero = hidden
    Vec3f zenith{}, horizon{}, ground{};  // radiances
    enum class View : std::uint8_t { garden, city, sea, mountains, forest } view = View::garden;
    bool snow = false;  // lies on all of it
    float seen =
        1.f;  // share of its radiance that a camera sees: windows burn out less, as behind a photographer's filter
    float sun_limit = 0.f;  // as bright as this a camera sees white in full sun, 1 = white by the room's light; what is
                            // more it sees with restraint (Look::sun_seen); 0: the sun is seen as it is
    float ground_least = 0.f;  // as bright as this, at least, a camera sees the ground, 1 = white by the room's light
                               // (Look::outside_seen); 0: as it is
    std::uint32_t seed = 0;    // of what stands outside
};

// How radiance becomes a picture; fixed once a room so that all its views agree.
struct Look {
    float exposure_ev = 0.f;  // color * 2^ev; chosen by trace/ when `automatic`
    bool automatic = true;
    Vec3f white{1, 1, 1};  // divides the color
    float contrast = 1.f, saturation = 1.f;
    float outside_seen = 1.f;  // times Sky::seen: what a camera sees of the outside, when the room is so bright that it
                               // would look like dusk
    float sun_seen =
        1.f;  // share of the sun's own light that a camera sees on what it falls on; all of it lights the room
};

struct Room {
    std::string type, style;  // "bedroom", "japandi"; for room.json
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<RoomObject> objects;
    std::vector<Portal> portals;
    Sky sky;
    Look look;
    Vec3f min_corner, max_corner;  // world: the room's inside box (or that of its plan)
    std::uint64_t seed = 0;
};

}  // namespace fastscene
