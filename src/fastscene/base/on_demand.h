// Parts of the program, or of Python's module, that are loaded at their first call (cmake/on_demand.cmake):
// fastscene-<part>.so in the module's folder, or in lib/fastscene/ beside the program's bin/.
#pragma once

// The address of a function of a part, by its mangled name; loads the part first. Throws Error naming the file if it
// cannot be loaded or has no such function. Called by the functions that stand in for the part's.
extern "C" void* fastscene_function_on_demand(const char* part, const char* function);
