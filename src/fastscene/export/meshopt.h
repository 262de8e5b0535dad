// Compression of meshes in glTF files: EXT_meshopt_compression.
#pragma once

#include <string>

namespace fastscene {

// The same .glb with its vertices and indices compressed; textures stay. Readers must know the extension (three.js,
// Babylon.js, PlayCanvas, glTFast for Unity, glTFRuntime for Unreal do). Positions and texture coordinates are rounded
// to 2^-16 of a vertex's largest, or of 1 if that is smaller (0.1 mm at 4 m), normals to 2^-12. Triangles are kept, in
// an order that cards like. Throws Error if `glb` is not one of ours.
std::string with_meshopt(const std::string& glb);

}  // namespace fastscene
