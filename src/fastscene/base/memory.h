// Available memory: what the machine has free, or what the limit of a container or the shell leaves, whichever is less.
#pragma once

#include <cstdint>
#include <filesystem>

namespace fastscene {

// Bytes; 0: unknown. `system`: root of proc/ and sys/ (replaceable for tests).
std::int64_t available_memory(const std::filesystem::path& system = "/");

}  // namespace fastscene
