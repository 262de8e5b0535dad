// The user's own things: a folder of models (glTF, OBJ), texture sets and photographed skies, and what its assets.toml
// says of them. docs/assets.md has the format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/math/rigid.h"
#include "fastscene/rooms/furniture.h"

namespace fastscene {

inline constexpr const char* kAssetsFile = "assets.toml";

// What prompt.json's "assumed" calls the user's skies and textures that a room shows; their values are credits.
inline constexpr const char *kSkyUsed = "sky", *kTextureUsed = "texture";

// Who made something and under which terms; empty: not said.
struct Attribution {
    std::string title, author, license, source;
};

// A [[model]] of assets.toml, or a file that no row names.
struct UserModel {
    std::filesystem::path file;      // relative to the folder
    std::string kind;                // "armchair"; or of its own: "space_jukebox"
    std::vector<std::string> names;  // folded: what prompts call it
    Vec3f size_m{};                  // width, height, depth that the row says; 0: as the file has it
    Mat3f ours_from_file;            // x right, y up, z towards the front
    std::optional<Mount> mount;
    std::optional<float> hang_height_m;  // of the lower edge, on a wall
    Attribution attribution;             // what the row says; the file may say more
};

// A [[texture]]: pictures of color, normals, roughness, metal and height that show the same surface.
struct UserTexture {
    std::filesystem::path folder;                                    // relative to the folder
    std::filesystem::path color, normals, roughness, metal, height;  // relative to the folder; empty: none
    bool normals_down = false;                                       // green points down (DirectX)
    std::vector<std::string> names;                                  // folded
    float width_m = 0;                                               // that the pictures span
    Attribution attribution;
};

// A [[sky]]: an equirectangular picture of radiance (.hdr, .exr).
struct UserSky {
    std::filesystem::path file;      // relative to the folder
    std::vector<std::string> names;  // folded
    std::string time;                // the hour it shows; empty: any
    float turn_deg = 0;              // to the right, of the picture's center from the main window's outlook
    float brightness = 1;            // relative to what such an hour has
    Attribution attribution;
};

struct UserAssets {
    std::vector<UserModel> models;
    std::vector<UserTexture> textures;
    std::vector<UserSky> skies;
    std::vector<std::string> complaints;  // rows and files that cannot be used, each by name
};

// What a folder holds, sorted by path: the rows of assets.toml, then files that no row names, known by their file
// names. Nothing is opened but assets.toml. Throws UsageError if there is no such folder, and Error naming file, line
// and key if assets.toml is no TOML.
UserAssets read_user_assets(const std::filesystem::path& folder);

// A model's file and those beside it that it names, by their full paths; those that are not there are left out.
std::vector<std::filesystem::path> files_of_model(const std::filesystem::path& file);

// "Vintage_Armchair-02 (1)" -> "vintage armchair"
std::string spoken_name(std::string_view file_stem);
// "space jukebox" -> "space_jukebox"
std::string kind_of_name(std::string_view name);

}  // namespace fastscene
