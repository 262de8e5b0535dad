// What a file is recognized by: its size and a hash of its content.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "fastscene/base/json.h"

namespace fastscene::dataset {

struct Checksum {
    std::uint64_t bytes = 0;
    std::string hash;  // 32 hexadecimal digits
    friend bool operator==(const Checksum&, const Checksum&) = default;
};
// Throws Error if the file cannot be read.
Checksum checksum_of(const std::filesystem::path& file);
Checksum checksum_of_bytes(std::string_view bytes);

Json to_json(const Checksum& sum);
// Throws Json::exception if something is missing.
Checksum checksum_from_json(const Json& json);

// What is wrong with a file: "missing", "truncated: expected 812 bytes, found 400", "damaged: …"; empty: nothing.
// `quick`: by its size alone.
std::string fault_of(const std::filesystem::path& file, const Checksum& expected, bool quick);

}  // namespace fastscene::dataset
