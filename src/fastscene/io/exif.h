// EXIF: how a camera says that a picture lies on its side. Private to io/; image_io.h tells the number in PictureInfo.
#pragma once

#include <string_view>

namespace fastscene {

// The orientation tag (EXIF 2.3, 0x0112), 1 to 8, of a JPEG (segment APP1) or a PNG (chunk eXIf). 1 = as it is; so too
// where the tag is absent or the block is damaged: a picture without it is still a picture.
int exif_orientation(std::string_view file);

}  // namespace fastscene
