// EXIF orientation. Private to io/; image_io.h exposes it in PictureInfo.
#pragma once

#include <string_view>

namespace fastscene {

// The orientation tag (EXIF 2.3, 0x0112), 1 to 8, of a JPEG (segment APP1) or a PNG (chunk eXIf). 1 = upright, also if
// the tag is absent or the block is damaged, since the picture itself is still usable.
int exif_orientation(std::string_view file);

}  // namespace fastscene
