// Environment variables that libraries read when loaded or at first use, which is too early for the program to set
// them: it restarts itself with them.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/isa.h"

namespace fastscene {

struct Setting {
    std::string name, value;
};

// Variables that limit libtorch, oneDNN, OpenBLAS and the C library to `limit`. They override the environment:
// FASTSCENE_ISA=avx2 must mean avx2 everywhere. None for the widest set, where libraries choose for themselves
// (OPENBLAS_CORETYPE, for example, is then the user's).
std::vector<Setting> library_settings(Isa limit);

// For the start of main(): restarts the program with `settings`, unless the environment already has all of them.
// Returns if that is not possible (no /proc).
void begin_with(const std::vector<Setting>& settings, char** argv);

// begin_with(library_settings(isa())), for test programs and tools.
void begin_within_isa(char** argv);

}  // namespace fastscene
