// A user's model as a Piece: read, turned, scaled to metres, set on its base, with materials for the tracer.
#pragma once

#include "fastscene/rooms/user_assets.h"

namespace fastscene {

struct UserPiece {
    Piece piece;  // of a lamp, emissions are shares of the light of the style's lamps
    std::size_t triangles = 0;
    Attribution attribution;         // of the row, else of the file
    std::vector<std::string> notes;  // what was guessed or left out
};

// `folder`: where UserModel::file is. `textures`: false leaves all pictures out, for what only needs the size.
// Throws Error naming the file for what cannot be read or is of no size that fits into a room.
UserPiece load_user_model(const std::filesystem::path& folder, const UserModel& model, bool textures = true);

// "Eames chair by Jane Doe (CC BY 4.0), models/eames.glb": for credits.txt.
std::string credit_of(const Attribution& attribution, const std::filesystem::path& file);

}  // namespace fastscene
