// HTML character entities: "eacute" is U+00E9.
#pragma once

#include <optional>
#include <string_view>

namespace fastscene {

// The character behind &name; (name without & and ;), if HTML 4 has one.
std::optional<char32_t> html_entity(std::string_view name);

}  // namespace fastscene
