// How much memory a program may still take here: what the machine has free, or what the limit of a container or of the
// shell leaves, whichever is less.
#pragma once

#include <cstdint>
#include <filesystem>

namespace fastscene {

// Bytes; 0: not known. `system`: where proc/ and sys/ are found (tests have their own).
std::int64_t available_memory(const std::filesystem::path& system = "/");

}  // namespace fastscene
