// The room as a document: all that is needed to build it again, byte for byte. Written to room.json, read back, edited
// by hand or by edit_document (edit.h). docs/room-document.md shows one. Room frame of plan.h: x left, y up, metres,
// the floor is y = 0 and the middle of the plan's box the origin.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/rooms/layout.h"

namespace fastscene {

inline constexpr const char* kRoomFormat = "fastscene-room";
inline constexpr int kRoomVersion = 1;

// A thing of the room: what make_piece is asked for, and where it stands.
struct DocumentThing {
    std::string id;    // "armchair-1": unique, and the same after an edit
    std::string kind;  // of piece_classes(), or of the furniture pack with `model`
    Vec3f position;  // of its base; hung on a wall: of the middle of its back's lower edge; from a ceiling: of its top
    float yaw = 0;   // its front looks along (sin yaw, 0, cos yaw)
    std::string on, below, with;  // ids: what carries it; the table above it; what it was placed by
    int window = -1;              // index of the opening on whose sill it stands, or in which it hangs
    Vec3f size_m{};               // width, height, depth; 0: as it is usual
    // How it is made. Empty: as the room's style has it.
    std::uint64_t seed = 0;
    std::string style, color, color2, material, pattern;
    std::string holder_color, holder_material, back_color, back_material;  // PieceRequest tells what they are of
    bool cooks = true;
    int screens = 0;
    float size_factor = 1;
    Vec3f asked_size_m{};                // the extents asked of its builder; 0: as usual. `size_m` is what came of them
    std::string model;                   // path within the furniture pack
    std::optional<Mount> mount;          // where it differs from what such things are: a picture that leans on a top
    std::optional<bool> flat, overhead;  // rugs, and what hangs from the ceiling: one may stand there
    std::optional<float> lit;            // 0 … 1: the share of its light that it gives; nothing: as the room's lamps
    std::optional<PromptObject> asked;   // what of a prompt or an edit it is
};

// Overrides of the style's materials.
struct DocumentSurfaces {
    std::optional<Material> floor, wall, accent_wall, ceiling, trim, wood, wood2, metal, fabric, fabric2, leather,
        curtain, rug, tap, wet_wall, wet_floor;
    std::array<std::optional<Material>, 4> walls;  // by number: of those that are not like the others
    std::optional<std::vector<Vec3f>> palette;
    std::optional<Shelves> shelves;
};

struct DocumentPlan {
    float width = 0, depth = 0, height = 0;  // inside; 0: as rooms of the type have it
    std::vector<Vec2f> polygon;              // in place of width, depth and blocks; right angles only
    std::vector<Block> blocks;
    std::vector<Platform> platforms;
    std::optional<std::vector<Opening>> openings;  // nothing: as rooms of the type have them
    std::vector<Skylight> skylights;
    float knee = 0, slope_run = 0;
    bool measured = false, beams = false, tray = false, neon = false, recessed_lights = false, coffers = false,
         bay = false, panelling = false;
    WallRelief wall_relief = WallRelief::flat;
    bool cabin = false, tunnel = false;
    float cove = 0;
    Mezzanine mezzanine;
    Vault vault = Vault::flat;
    float spring = 0, oculus = 0;
    std::optional<int> accent_wall;  // the wall that has the accent material
    std::optional<Vec3f> neon_color;
    std::vector<PromptObject> asked;  // what was said of windows, doors and other parts of the shell
};

struct DocumentLight {
    std::string hour, weather, outlook, light, mood;
    std::optional<float> lamps;        // 0 … 1
    std::optional<Vec3f> towards_sun;  // unit
};

struct DocumentCamera {
    Vec3f position;
    std::optional<Vec3f> looks;
};

struct DocumentNextRoom {
    std::string type;
    Rigid room_from_next;
    DocumentPlan plan;
    DocumentSurfaces surfaces;
    std::vector<DocumentThing> things;  // in the frame of the first room
};

struct RoomDocument {
    std::string type, style;            // "bedroom", "japandi"; no style: one that rooms of the type have
    std::string prompt;                 // the words it came from
    std::optional<std::uint64_t> seed;  // of what is drawn: clouds, scenery, whatever the document leaves open
    bool furnish = false;               // complete it as a room of its type has it; all that it says stays
    DocumentLight light;
    std::optional<DocumentCamera> camera;
    DocumentPlan plan;
    DocumentSurfaces surfaces;
    std::vector<DocumentThing> things;
    std::optional<DocumentNextRoom> next_room;
};

// Throws Error naming file, line and place (a JSON pointer) for bad JSON, unknown keys (with the nearest one), wrong
// types, and values out of bounds. What the room is made of is checked by check_document.
RoomDocument read_document(std::string_view text, const std::string& file);
RoomDocument load_document(const std::filesystem::path& file);
// Deterministic; defaults are left out.
Json document_json(const RoomDocument& document);
// The published schema: docs/reference/room.schema.json.
Json document_schema();

// Throws Error for what no room can be: unknown types, styles, kinds and references, ids that stand twice, a plan that
// crosses itself, openings outside of their walls. Called by both below.
void check_document(const RoomDocument& document, const std::string& file, const FurniturePack* pack);

// The document of a furnished room.
RoomDocument document_of(const PromptSpec& spec, const FurnishedRoom& furnished, std::uint64_t seed);
// The room that a prompt asks for.
RoomDocument plan_document(PromptSpec& spec, const Run& run);

// A document's room before it becomes triangles, and what room_of needs to know besides. What the document leaves open
// is chosen as for a prompt. Throws Error for things through walls and a camera inside a thing.
struct DocumentRoom {
    PromptSpec spec;
    FurnishedRoom furnished;
    std::uint64_t seed = 0;
};
DocumentRoom furnish_document(const RoomDocument& document, const std::string& file,
                              std::shared_ptr<const FurniturePack> pack, const Run& run);
// The same as a document that leaves nothing open.
RoomDocument completed(const RoomDocument& document, const std::string& file, std::shared_ptr<const FurniturePack> pack,
                       const Run& run);

// … as triangles, and as the document that tells all of it.
Room room_of(DocumentRoom& room);
RoomDocument document_of(const DocumentRoom& room);
// The contents of panorama/room.json: the document, and of each of its things how much the panorama shows.
Json room_file_json(const RoomDocument& document, const Room& room, const Image<std::int32_t>& object_of_pixel);

// Ids of the things of a room, then of those of the next one: their own, or by kind and number ("chair-2"), as in all
// files about the room (export/identities.h).
std::vector<std::string> thing_ids(const FurnishedRoom& room);

}  // namespace fastscene
