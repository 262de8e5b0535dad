// The constant tables of EGformer (Yun et al. 2023, section 3): where the deformable attention looks, and how far
// apart two tokens of a window lie on the sphere. They depend on the resolution only and are in no checkpoint.
#pragma once

#include <vector>

namespace fastscene {

// PanoFormer's sampling pattern: for each pixel of a height x width equirectangular grid the 3 x 3 taps of a small
// patch tangent to the sphere, as (row, column) in pixel indices; [height][width][9][2]. Columns lie in [0, width]:
// a few taps round up to width itself, which the sampler takes for outside, as the official code does.
std::vector<float> tangent_patch_table(int height, int width);

// ERPE: the chord between tokens i and j of a vertical window (`count` tokens over half a turn) or, on the equator, of
// a horizontal one (a whole turn), positive where j lies after i; [count][count]. A horizontal window at row r of h is
// nearer to a pole: multiply by sin(pi r / h).
std::vector<float> vertical_chord_table(int count);
std::vector<float> horizontal_chord_table(int count);

}  // namespace fastscene
