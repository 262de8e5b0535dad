// A user's texture set as a material of floors, walls and ceilings.
#pragma once

#include "fastscene/rooms/user_assets.h"

namespace fastscene {

// A material that shows the user's texture of that name: its pictures are added when the room is built.
Material texture_called(const std::string& name);
// Whether a material still waits for its pictures.
bool lacks_pictures(const Material& material);

// Color, normals (from the height, if there are none), roughness and metal. Material::scale_m is the texture's width.
// Throws Error naming the file for what cannot be read.
Material load_user_texture(const std::filesystem::path& folder, const UserTexture& texture);

// Normals, as glTF stores them, of a relief: `depth_m` from black to white, of a picture that spans `width_m`.
ImageRgb8 normals_of_height(const ImageRgb8& height, float depth_m, float width_m);

}  // namespace fastscene
