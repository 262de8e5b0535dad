// What an open device is to Vulkan. For this module only.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "fastscene/gpu/device.h"
#include "fastscene/gpu/instance.h"

namespace fastscene::gpu {

struct DeviceHandles {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkSemaphore timeline = VK_NULL_HANDLE;
    std::uint64_t submitted = 0;  // value of the timeline after all submissions
    VkPhysicalDeviceMemoryProperties memory{};
    bool has_budget = false, has_push = false;
    VolkDeviceTable f{};
    std::string name;
    bool is_timing = false;
    double tick_ms = 0;
    std::map<std::string, double> times_ms;

    void check(VkResult r, const char* what) const {
        if (r == VK_SUCCESS) return;
        if (r == VK_ERROR_DEVICE_LOST) throw DeviceLost("{}: the device stopped answering ({})", name, what);
        throw Error("{}: {}: {}", name, what, name_of(r));
    }
    // The memory type with all `wanted` flags; the first listed is the fastest. -1: none.
    int type_of(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
            if (allowed >> i & 1 && (memory.memoryTypes[i].propertyFlags & wanted) == wanted)
                return static_cast<int>(i);
        return -1;
    }
};

// device.h, which is free of Vulkan, keeps handles as void*.
template <class Handle>
Handle as(void* p) {
    return reinterpret_cast<Handle>(p);
}

}  // namespace fastscene::gpu
