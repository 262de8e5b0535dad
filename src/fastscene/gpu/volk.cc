// The loader of Vulkan's functions.
#include "fastscene/gpu/vulkan.h"
// Its one source file.
#include <volk.c>
