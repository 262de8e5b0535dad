// Constant tables of EGformer (Yun et al. 2023, section 3): sampling positions of the deformable attention, and
// spherical distances between the tokens of a window. They depend only on the resolution and are not in checkpoints.
#pragma once

#include <vector>

namespace fastscene {

// PanoFormer's sampling pattern: for each pixel of a height x width equirectangular grid, the 3 x 3 taps of a small
// patch tangent to the sphere, as (row, column) in pixel indices; [height][width][9][2]. Columns lie in [0, width]: a
// few round up to width itself, which the sampler treats as outside, like the official code.
std::vector<float> tangent_patch_table(int height, int width);

// ERPE: signed chord length between tokens i and j of a vertical window (`count` tokens over 180 degrees) or of a
// horizontal one on the equator (360 degrees), positive if j comes after i; [count][count]. For the horizontal window
// in row r of h, multiply by sin(pi r / h).
std::vector<float> vertical_chord_table(int count);
std::vector<float> horizontal_chord_table(int count);

}  // namespace fastscene
