// How libtorch runs here. The start scripts, or else cli/main.cc, set OMP_WAIT_POLICY=passive before it loads: threads
// that wait at a barrier sleep, where spinning ones take the core from those that work.
#pragma once

#include <exception>
#include <string>

namespace fastscene {

// What went wrong, in one line: libtorch's errors without their stack.
std::string short_message(const std::exception& error);
// Memory that was asked for and not given, by libtorch or by anybody.
bool is_lack_of_memory(const std::exception& error);

// Gives libtorch as many threads as everything else has (base/parallel.h), and room to multiply in. Every network calls
// it before it runs. Throws Error where a limit of address space leaves no such room.
void use_our_threads();

}  // namespace fastscene
