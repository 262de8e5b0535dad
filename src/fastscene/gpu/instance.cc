#include "fastscene/gpu/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace fastscene::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool has_instance_extension(std::string_view name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> all(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, all.data());
    return std::any_of(all.begin(), all.end(), [&](const auto& e) { return name == e.extensionName; });
}

VkBool32 keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                      const VkDebugUtilsMessengerCallbackDataEXT* data, void* self) {
    auto& instance = *static_cast<Instance*>(self);
    const std::lock_guard lock(instance.mutex);
    instance.messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

}  // namespace

std::string name_of(VkResult r) {
    switch (r) {
        case VK_ERROR_OUT_OF_HOST_MEMORY: return "out of host memory";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "out of device memory";
        case VK_ERROR_DEVICE_LOST: return "device lost";
        case VK_ERROR_INITIALIZATION_FAILED: return "initialization failed";
        case VK_ERROR_FEATURE_NOT_PRESENT: return "feature not present";
        case VK_ERROR_INCOMPATIBLE_DRIVER: return "incompatible driver";
        case VK_ERROR_TOO_MANY_OBJECTS: return "too many objects";
        default: return fmt::format("Vulkan error {}", static_cast<int>(r));
    }
}

Instance::Instance() {
    if (volkInitialize() != VK_SUCCESS) {
        why_not = "no Vulkan loader (libvulkan.so.1)";
        return;
    }
    const char* const wanted = std::getenv("FASTSCENE_VULKAN_VALIDATION");
    const bool validate = wanted && std::string_view(wanted) != "0";
    auto app = tagged<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    app.pApplicationName = "fastscene", app.apiVersion = VK_API_VERSION_1_2;
    auto info = tagged<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &app;
    auto debug = tagged<VkDebugUtilsMessengerCreateInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    debug.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                            VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    debug.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                        VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    debug.pfnUserCallback = &keep_message, debug.pUserData = this;
    std::vector<const char*> extensions;
    if (validate) {
        info.enabledLayerCount = 1, info.ppEnabledLayerNames = &kValidationLayer;
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }
    if (has_instance_extension(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME)) {
        extensions.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
        info.flags |= VK_INSTANCE_CREATE_ENUMERATE_PORTABILITY_BIT_KHR;
    }
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (const VkResult r = vkCreateInstance(&info, nullptr, &handle); r != VK_SUCCESS) {
        handle = VK_NULL_HANDLE;
        why_not = r == VK_ERROR_LAYER_NOT_PRESENT ? fmt::format("no layer {}", kValidationLayer) : name_of(r);
        return;
    }
    volkLoadInstanceOnly(handle);
    if (validate) vkCreateDebugUtilsMessengerEXT(handle, &debug, nullptr, &messenger);
}

Instance::~Instance() {
    if (messenger) vkDestroyDebugUtilsMessengerEXT(handle, messenger, nullptr);
    if (handle) vkDestroyInstance(handle, nullptr);
}

std::vector<VkPhysicalDevice> Instance::devices() const {
    std::uint32_t count = 0;
    if (!handle || vkEnumeratePhysicalDevices(handle, &count, nullptr) != VK_SUCCESS) return {};
    std::vector<VkPhysicalDevice> out(count);
    vkEnumeratePhysicalDevices(handle, &count, out.data());
    out.resize(count);
    return out;
}

Instance& instance() {
    static Instance one;
    return one;
}

bool has_extension(VkPhysicalDevice device, std::string_view name) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> all(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, all.data());
    return std::any_of(all.begin(), all.end(), [&](const auto& e) { return name == e.extensionName; });
}

int compute_family(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    for (std::uint32_t i = 0; i < count; ++i)
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return static_cast<int>(i);
    return -1;
}

}  // namespace fastscene::gpu
