// Environment variables that libraries read when they are loaded, or once at their first use: too late for a program to
// set them for itself, so it starts anew with them.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/isa.h"

namespace fastscene {

struct Setting {
    std::string name, value;
};

// What keeps libtorch, oneDNN, OpenBLAS and the C library to `limit`. They win over what the environment says:
// FASTSCENE_ISA=avx2 must mean avx2 everywhere. Nothing for the widest set, where libraries choose (OPENBLAS_CORETYPE,
// for one, is then the user's).
std::vector<Setting> library_settings(Isa limit);

// For main(), before anything else: unless the environment has all of `settings` already, this program begins again
// with them. Returns where that is not possible (no /proc).
void begin_with(const std::vector<Setting>& settings, char** argv);

// begin_with(library_settings(isa())): for test programs and tools.
void begin_within_isa(char** argv);

}  // namespace fastscene
