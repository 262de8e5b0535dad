// Base64 (RFC 4648), for binary data in self-contained pages.
#pragma once

#include <string>
#include <string_view>

namespace fastscene {

std::string base64(std::string_view bytes);

}  // namespace fastscene
