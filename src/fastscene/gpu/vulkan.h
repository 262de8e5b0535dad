// Vulkan's types and functions, loaded at run time: the program starts without a driver too. For this module only.
#pragma once

#ifndef VK_NO_PROTOTYPES
#define VK_NO_PROTOTYPES
#endif
#include <volk.h>
