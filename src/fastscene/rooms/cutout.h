// Leaves, lace and grilles that a picture's alpha channel cuts out of flat triangles, as triangles of their own: the
// tracer, collisions and exports then need to know nothing of it.
#pragma once

#include "fastscene/scene/room.h"

namespace fastscene {

// The parts of `mesh` where `alpha`, looked up by coords.x and coords.y (v upward, repeated), is at least `cutoff`
// (0..255). Triangles at its outline are halved until they are a few texels wide; `most` limits their number.
Mesh cut_out(const Mesh& mesh, const ImageMask& alpha, int cutoff, std::size_t most);

}  // namespace fastscene
