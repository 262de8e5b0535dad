#include "fastscene/gpu/device.h"

#include <algorithm>
#include <utility>

#include "fastscene/base/check.h"
#include "fastscene/gpu/handles.h"
#include "fastscene/gpu/transfers.h"

namespace fastscene::gpu {

Device::Device(const DeviceInfo& info) : info_(info), handles_(std::make_unique<DeviceHandles>()) {
    const std::vector<VkPhysicalDevice> all = instance().devices();
    FASTSCENE_CHECK(info.index >= 0 && static_cast<std::size_t>(info.index) < all.size() && info.missing.empty());
    DeviceHandles& h = *handles_;
    h.name = info.name;
    h.physical = all[static_cast<std::size_t>(info.index)];
    vkGetPhysicalDeviceMemoryProperties(h.physical, &h.memory);
    Properties properties;
    vkGetPhysicalDeviceProperties2(h.physical, &properties.base);
    h.tick_ms = 1e-6 * static_cast<double>(properties.base.properties.limits.timestampPeriod);
    const float priority = 1;
    auto queue = tagged<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = static_cast<std::uint32_t>(compute_family(h.physical));
    queue.queueCount = 1, queue.pQueuePriorities = &priority;
    Features f;
    f.v12.bufferDeviceAddress = f.v12.timelineSemaphore = VK_TRUE;
    f.size.subgroupSizeControl = f.size.computeFullSubgroups = VK_TRUE;
    std::vector<const char*> extensions{VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME};
    h.has_budget = has_extension(h.physical, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
    if (h.has_budget) extensions.push_back(VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
    // Must be enabled where it is offered.
    if (has_extension(h.physical, "VK_KHR_portability_subset")) extensions.push_back("VK_KHR_portability_subset");
    auto create = tagged<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    create.pNext = &f.base;
    create.queueCreateInfoCount = 1, create.pQueueCreateInfos = &queue;
    create.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    create.ppEnabledExtensionNames = extensions.data();
    h.check(vkCreateDevice(h.physical, &create, nullptr, &h.device), "opening the device");
    volkLoadDeviceTable(&h.f, h.device);
    h.f.vkGetDeviceQueue(h.device, queue.queueFamilyIndex, 0, &h.queue);
    auto pool = tagged<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, pool.queueFamilyIndex = queue.queueFamilyIndex;
    h.check(h.f.vkCreateCommandPool(h.device, &pool, nullptr, &h.pool), "creating a command pool");
    auto type = tagged<VkSemaphoreTypeCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO);
    type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    auto semaphore = tagged<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &type);
    h.check(h.f.vkCreateSemaphore(h.device, &semaphore, nullptr, &h.timeline), "creating a semaphore");
}

Device::~Device() {
    DeviceHandles& h = *handles_;
    if (!h.device) return;
    h.f.vkDeviceWaitIdle(h.device);
    transfers_ = {};
    h.f.vkDestroySemaphore(h.device, h.timeline, nullptr);
    h.f.vkDestroyCommandPool(h.device, h.pool, nullptr);
    h.f.vkDestroyDevice(h.device, nullptr);
}

std::int64_t Device::free_memory() const {
    const DeviceHandles& h = *handles_;
    if (!h.has_budget) return info_.memory / 10 * 9;  // drivers and displays keep some for themselves
    auto budget = tagged<VkPhysicalDeviceMemoryBudgetPropertiesEXT>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT);
    auto memory = tagged<VkPhysicalDeviceMemoryProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2,
                                                            &budget);
    vkGetPhysicalDeviceMemoryProperties2(h.physical, &memory);
    std::int64_t most = 0;
    for (std::uint32_t i = 0; i < memory.memoryProperties.memoryHeapCount; ++i)
        if (memory.memoryProperties.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            most = std::max(
                most, static_cast<std::int64_t>(budget.heapBudget[i]) - static_cast<std::int64_t>(budget.heapUsage[i]));
    return most;
}

std::map<std::string, double> Device::kernel_times() {
    handles_->is_timing = true;
    return std::exchange(handles_->times_ms, {});
}

std::vector<std::string> Device::validation_messages() const {
    const std::lock_guard lock(instance().mutex);
    return instance().messages;
}

Transfers& Device::transfers() {
    if (!transfers_) transfers_ = std::make_unique<Transfers>(*this);
    return *transfers_;
}

}  // namespace fastscene::gpu
