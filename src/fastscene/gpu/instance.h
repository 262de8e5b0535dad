// The process's connection to Vulkan's drivers, and what they tell of devices. For this module only.
#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/gpu/vulkan.h"

namespace fastscene::gpu {

// Vulkan's structures begin with their type and a pointer to more.
template <class T>
T tagged(VkStructureType type, void* next = nullptr) {
    T out{};
    out.sType = type, out.pNext = next;
    return out;
}

std::string name_of(VkResult result);

// The process's connection to the drivers. Layers on top of other interfaces, such as MoltenVK, have to be asked for
// (VK_KHR_portability_enumeration).
struct Instance {
    VkInstance handle = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    std::mutex mutex;
    std::vector<std::string> messages;
    std::string why_not;  // if there is no instance

    Instance();
    ~Instance();
    std::vector<VkPhysicalDevice> devices() const;
};
Instance& instance();

struct Features {
    VkPhysicalDeviceFeatures2 base = tagged<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    VkPhysicalDeviceVulkan12Features v12 = tagged<VkPhysicalDeviceVulkan12Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    VkPhysicalDeviceSubgroupSizeControlFeatures size = tagged<VkPhysicalDeviceSubgroupSizeControlFeatures>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_SIZE_CONTROL_FEATURES);
    Features() { base.pNext = &v12, v12.pNext = &size; }
};

struct Properties {
    VkPhysicalDeviceProperties2 base = tagged<VkPhysicalDeviceProperties2>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    VkPhysicalDeviceSubgroupProperties subgroup = tagged<VkPhysicalDeviceSubgroupProperties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES);
    VkPhysicalDeviceDriverProperties driver = tagged<VkPhysicalDeviceDriverProperties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    Properties() { base.pNext = &subgroup, subgroup.pNext = &driver; }
};

bool has_extension(VkPhysicalDevice device, std::string_view name);
// The first queue family that computes; -1: none.
int compute_family(VkPhysicalDevice device);

}  // namespace fastscene::gpu
