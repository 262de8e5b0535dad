// The colors by which NYU40 classes are usually shown, and by which Structured3D's semantic maps are coded.
#pragma once

#include <array>

#include "fastscene/image/image.h"

namespace fastscene::dataset {

inline constexpr std::array<Rgb8, 41> kNyu40Colors{
    Rgb8{0, 0, 0},       Rgb8{174, 199, 232}, Rgb8{152, 223, 138}, Rgb8{31, 119, 180},  Rgb8{255, 187, 120},
    Rgb8{188, 189, 34},  Rgb8{140, 86, 75},   Rgb8{255, 152, 150}, Rgb8{214, 39, 40},   Rgb8{197, 176, 213},
    Rgb8{148, 103, 189}, Rgb8{196, 156, 148}, Rgb8{23, 190, 207},  Rgb8{178, 76, 76},   Rgb8{247, 182, 210},
    Rgb8{66, 188, 102},  Rgb8{219, 219, 141}, Rgb8{140, 57, 197},  Rgb8{202, 185, 52},  Rgb8{51, 176, 203},
    Rgb8{200, 54, 131},  Rgb8{92, 193, 61},   Rgb8{78, 71, 183},   Rgb8{172, 114, 82},  Rgb8{255, 127, 14},
    Rgb8{91, 163, 138},  Rgb8{153, 98, 156},  Rgb8{140, 153, 101}, Rgb8{158, 218, 229}, Rgb8{100, 125, 154},
    Rgb8{178, 127, 135}, Rgb8{120, 185, 128}, Rgb8{146, 111, 194}, Rgb8{44, 160, 44},   Rgb8{112, 128, 144},
    Rgb8{96, 207, 209},  Rgb8{227, 119, 194}, Rgb8{213, 92, 176},  Rgb8{94, 106, 211},  Rgb8{82, 84, 163},
    Rgb8{100, 85, 144}};

// Parts of the room rather than things in it: wall, floor, ceiling.
constexpr bool is_shell_class(int nyu40) { return nyu40 == 1 || nyu40 == 2 || nyu40 == 22; }

}  // namespace fastscene::dataset
