#pragma once

#include <string>

namespace fastscene {

// "unknown" if the system does not say.
std::string host_name();

// "HOST-PID": a name that no two running processes share, on machines that share a file system either.
std::string process_name();

}  // namespace fastscene
