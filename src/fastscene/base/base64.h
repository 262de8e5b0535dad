// Base64 (RFC 4648), for binary data in self-contained pages and documents.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fastscene {

std::string base64(std::string_view bytes);
// The bytes; nothing if `text` is not base64. Padding at its end may be missing.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace fastscene
