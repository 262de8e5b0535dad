// Furniture: parametric pieces, built from a class, a style and a few wishes.
//
// Object frame: x right, y UP, z towards the piece's front, metres.
//   Mount::floor and surface: the origin is the center of the base (y = 0 is the floor, or the top it stands on).
//   Mount::wall: the origin is on the wall, at the center of the back and the lower edge: z in [0, size z], y in [0,
//   size y]. Mount::ceiling: the origin is on the ceiling; the piece hangs down: y in [-size y, 0].
// Floor pieces span z in [-size z / 2, size z / 2]; those with against_wall have their back at -size z / 2.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/rooms/style.h"
#include "fastscene/scene/room.h"

namespace fastscene {

class FurniturePack;
struct PackModel;
struct PieceRequest;

enum class Mount : std::uint8_t { floor, wall, ceiling, surface };

// A top where small things may stand: the rectangle |x - center.x| <= half.x, |z - center.z| <= half.y at y = center.y.
struct Surface {
    Vec3f center;
    Vec2f half;
};

struct Piece {
    std::string kind;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;       // Mesh::material = index into materials
    Vec3f size_m;                   // of the bounding box
    float clearance_front_m = 0.f;  // free floor wanted in front (+z)
    float clearance_side_m = 0.f;   // … at each side
    std::vector<Surface> surfaces;  // free tops, largest first
    Mount mount = Mount::floor;
    bool against_wall = false;
    float hang_height_m = 0.f;        // Mount::wall: usual height of the lower edge above the floor
    int main_material = 0;            // the one that color and material wishes change
    std::string form;                 // where a room should have each only once: "monstera", "eucalyptus"; else empty
    std::string source = "built-in";  // or the model of the furniture pack, with author and license
    // What make_piece was asked for; its style is one of styles(), or null for the room's own.
    std::shared_ptr<const PieceRequest> made_from{};
    Mount made_mount = Mount::floor;  // as it was made; a layout may stand up what hangs
};

struct PieceRequest {
    std::string kind;
    const Style* style = nullptr;  // must not be null
    std::optional<Vec3f> color{};  // linear albedo of the main surface
    std::string color_name{}, color2_name{}, material{},
        pattern{};                                  // names, "" = as the style has it; color wins over color_name
    std::string holder_color{}, holder_material{};  // of what a bouquet stands in; of a bunk's bedding; of a worktop
    std::string back_color{}, back_material{};      // of the wall behind a worktop
    bool cooks = true;                              // kitchen_counter: with oven, hob and hood
    int screens = 0;                                // desks: how many monitors will stand on it
    float size_factor = 1.f;                        // of the usual size, in [0.5, 2]
    std::uint64_t seed = 0;
    Vec3f size_m{};  // components > 0 ask for that extent; kept by rugs, curtains, kitchen_counter,
                     // pictures, mirrors, shelves, tables, single candles (see furniture/), others scale to it

    // A model of the furniture pack to be used in place of our own builder (pack.h); both null: none.
    std::shared_ptr<const FurniturePack> pack{};
    const PackModel* model = nullptr;
};

inline constexpr const char* kTableCloth =
    "cloth";  // the holder's material of a table with a cloth on it: then pattern and holder's color are the cloth's
inline constexpr const char* kAsleep = "asleep";    // the pattern of a cat that sleeps
inline constexpr const char* kHungScreen = "hung";  // the pattern of a TV that hangs on a wall: without feet
inline constexpr float kMonitorStep = 0.59f;        // from one monitor to the next, metres

// Throws Error for an unknown class. Deterministic in the request.
Piece make_piece(const PieceRequest& request);

// Every class make_piece knows, sorted: "armchair", "bed", "bed_single", …
const std::vector<std::string>& piece_classes();

}  // namespace fastscene
