// Base64 (RFC 4648): bytes inside a page that must stand alone.
#pragma once

#include <string>
#include <string_view>

namespace fastscene {

std::string base64(std::string_view bytes);

}  // namespace fastscene
