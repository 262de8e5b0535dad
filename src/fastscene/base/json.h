// The project's JSON type (nlohmann). Include it only in .cc files and in headers that hold Json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace fastscene {

using Json = nlohmann::ordered_json;

// Parses a JSON file; throws Error naming the file and the byte of a syntax error.
Json read_json(const std::filesystem::path& path);
// Writes two-space indented JSON under a temporary name, then renames.
void write_json(const std::filesystem::path& path, const Json& value);

}  // namespace fastscene
