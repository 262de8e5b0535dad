#include "fastscene/base/process_name.h"

#include <unistd.h>

#include <array>

#include "fastscene/base/error.h"

namespace fastscene {

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string process_name() { return fmt::format("{}-{}", host_name(), ::getpid()); }

}  // namespace fastscene
