#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "fastscene/gpu/device.h"
#include "fastscene/gpu/instance.h"

namespace fastscene::gpu {
namespace {

DeviceInfo describe(VkPhysicalDevice device, int index) {
    DeviceInfo out;
    Properties p;
    vkGetPhysicalDeviceProperties2(device, &p.base);
    const VkPhysicalDeviceProperties& base = p.base.properties;
    out.index = index, out.name = base.deviceName;
    out.driver = fmt::format("{} {}", p.driver.driverName, p.driver.driverInfo);
    out.is_card = base.deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU;
    out.subgroup_size = static_cast<int>(p.subgroup.subgroupSize);
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            out.memory = std::max(out.memory, static_cast<std::int64_t>(memory.memoryHeaps[i].size));
    const auto need = [&](bool there, const char* what) {
        if (!there) out.missing.emplace_back(what);
    };
    need(base.apiVersion >= VK_API_VERSION_1_2, "Vulkan 1.2");
    if (!out.missing.empty()) return out;
    Features f;
    if (!has_extension(device, VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME)) f.v12.pNext = nullptr;
    vkGetPhysicalDeviceFeatures2(device, &f.base);
    need(compute_family(device) >= 0, "a compute queue");
    need(f.v12.bufferDeviceAddress, "bufferDeviceAddress");
    need(f.v12.timelineSemaphore, "timelineSemaphore");
    need(f.size.subgroupSizeControl && f.size.computeFullSubgroups, "VK_EXT_subgroup_size_control");
    constexpr VkSubgroupFeatureFlags kSubgroup = VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_VOTE_BIT |
                                                 VK_SUBGROUP_FEATURE_BALLOT_BIT | VK_SUBGROUP_FEATURE_SHUFFLE_BIT |
                                                 VK_SUBGROUP_FEATURE_ARITHMETIC_BIT;
    need((p.subgroup.supportedOperations & kSubgroup) == kSubgroup, "subgroup arithmetic, ballot and shuffle");
    need(out.subgroup_size >= 8 && out.subgroup_size <= 64, "subgroups of 8 to 64");
    need(base.limits.maxComputeWorkGroupInvocations >= 256, "workgroups of 256");
    need(base.limits.maxComputeSharedMemorySize >= 32768, "32 KiB of shared memory");
    return out;
}

std::string listing(const std::vector<DeviceInfo>& all) {
    if (all.empty()) return instance().handle ? "no device" : fmt::format("no device ({})", instance().why_not);
    std::string out;
    for (const DeviceInfo& d : all)
        out += fmt::format("{}{} \"{}\"{}{}", out.empty() ? "" : ", ", d.index, d.name,
                           d.is_card ? "" : " (a processor)",
                           d.missing.empty() ? "" : fmt::format(" (lacks {})", fmt::join(d.missing, ", ")));
    return out;
}

std::string lower(std::string s) {
    std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return s;
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
    std::vector<DeviceInfo> out;
    int index = 0;
    for (const VkPhysicalDevice d : instance().devices()) out.push_back(describe(d, index++));
    return out;
}

DeviceInfo choose_device(const std::string& wanted, const std::string& flag) {
    const std::vector<DeviceInfo> all = list_devices();
    const DeviceInfo* found = nullptr;
    if (wanted == "list") throw UsageError("{} list: found {}", flag, listing(all));
    if (wanted == "auto") {
        for (const DeviceInfo& d : all)
            if (d.is_card && d.missing.empty() && (!found || d.memory > found->memory)) found = &d;
        if (!found)
            throw UsageError("{} auto: expected a graphics card with a Vulkan driver, found {}", flag, listing(all));
        return *found;
    }
    const bool number = !wanted.empty() && wanted.find_first_not_of("0123456789") == std::string::npos;
    for (const DeviceInfo& d : all)
        if (number ? std::to_string(d.index) == wanted : lower(d.name).find(lower(wanted)) != std::string::npos) {
            found = &d;
            break;
        }
    if (!found)
        throw UsageError("{} {}: expected auto, a number or part of a name, found {}", flag, wanted, listing(all));
    if (!found->missing.empty())
        throw UsageError("{} {}: expected a driver with {}; \"{}\" ({}) lacks it", flag, wanted,
                         fmt::join(found->missing, ", "), found->name, found->driver);
    return *found;
}

bool has_card() {
    const std::vector<DeviceInfo> all = list_devices();
    return std::any_of(all.begin(), all.end(), [](const DeviceInfo& d) { return d.is_card && d.missing.empty(); });
}

}  // namespace fastscene::gpu
