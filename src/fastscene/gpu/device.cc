#include "fastscene/gpu/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <utility>

#include "fastscene/base/check.h"
#include "fastscene/gpu/vulkan.h"

namespace fastscene::gpu {
namespace {

// Vulkan's structures begin with their type and a pointer to more.
template <class T>
T tagged(VkStructureType type, void* next = nullptr) {
    T out{};
    out.sType = type, out.pNext = next;
    return out;
}

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

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

bool has_instance_extension(std::string_view name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> all(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, all.data());
    return std::any_of(all.begin(), all.end(), [&](const auto& e) { return name == e.extensionName; });
}

// The process's connection to the drivers. Layers on top of other interfaces, such as MoltenVK, have to be asked for
// (VK_KHR_portability_enumeration).
struct Instance {
    VkInstance handle = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    std::mutex mutex;
    std::vector<std::string> messages;
    std::string why_not;  // if there is no instance

    Instance() {
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
        auto debug = tagged<VkDebugUtilsMessengerCreateInfoEXT>(
            VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
        debug.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                                VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
        debug.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                            VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
        debug.pfnUserCallback = &Instance::told, debug.pUserData = this;
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
    ~Instance() {
        if (messenger) vkDestroyDebugUtilsMessengerEXT(handle, messenger, nullptr);
        if (handle) vkDestroyInstance(handle, nullptr);
    }
    static VkBool32 told(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* self) {
        auto& instance = *static_cast<Instance*>(self);
        const std::lock_guard lock(instance.mutex);
        instance.messages.emplace_back(data->pMessage);
        return VK_FALSE;
    }
    std::vector<VkPhysicalDevice> devices() const {
        std::uint32_t count = 0;
        if (!handle || vkEnumeratePhysicalDevices(handle, &count, nullptr) != VK_SUCCESS) return {};
        std::vector<VkPhysicalDevice> out(count);
        vkEnumeratePhysicalDevices(handle, &count, out.data());
        out.resize(count);
        return out;
    }
};
Instance& instance() {
    static Instance one;
    return one;
}

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

bool has_extension(VkPhysicalDevice device, std::string_view name) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> all(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, all.data());
    return std::any_of(all.begin(), all.end(), [&](const auto& e) { return name == e.extensionName; });
}

// -1: none.
int compute_family(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    for (std::uint32_t i = 0; i < count; ++i)
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return static_cast<int>(i);
    return -1;
}

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

// Mapped memory on the way between host and device, a piece a direction. It is kept, and grows up to kMostBytes: to
// allocate it takes longer than most copies.
class Transfers {
  public:
    static constexpr std::int64_t kMostBytes = 64 << 20;

    explicit Transfers(Device& device) : device_(device), commands_(device) {}
    const Buffer& up(std::int64_t bytes) { return reserved(up_, bytes, Memory::upload); }
    const Buffer& down(std::int64_t bytes) { return reserved(down_, bytes, Memory::readback); }
    void copy(const Buffer& from, std::int64_t from_byte, const Buffer& to, std::int64_t to_byte, std::int64_t bytes) {
        commands_.begin();
        commands_.copy(from, from_byte, to, to_byte, bytes);
        commands_.submit();
        commands_.wait();
    }

  private:
    const Buffer& reserved(Buffer& buffer, std::int64_t bytes, Memory memory) {
        const std::int64_t wanted = std::min(bytes, kMostBytes);
        if (buffer.bytes() < wanted) {
            const auto grown = static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(wanted)));
            buffer = {};  // before the next is allocated
            buffer = Buffer(device_, grown, memory, "a transfer");
        }
        return buffer;
    }
    Device& device_;
    Commands commands_;
    Buffer up_, down_;
};

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

namespace {

template <class Handle>
Handle as(void* p) {
    return reinterpret_cast<Handle>(p);
}

VkMemoryPropertyFlags flags_of(Memory memory) {
    constexpr VkMemoryPropertyFlags kMapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                              VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    if (memory == Memory::device) return VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    return memory == Memory::upload ? kMapped : kMapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
}

}  // namespace

Buffer::Buffer(Device& device, std::int64_t bytes, Memory memory, const char* purpose)
    : device_(&device), bytes_(std::max<std::int64_t>(bytes, 16)) {
    DeviceHandles& h = device.handles();
    auto info = tagged<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = static_cast<VkDeviceSize>(bytes_);
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT |
                 VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    h.check(h.f.vkCreateBuffer(h.device, &info, nullptr, &buffer), "creating a buffer");
    buffer_ = buffer;
    VkMemoryRequirements needs;
    h.f.vkGetBufferMemoryRequirements(h.device, buffer, &needs);
    int type = h.type_of(needs.memoryTypeBits, flags_of(memory));
    if (type < 0 && memory == Memory::readback) type = h.type_of(needs.memoryTypeBits, flags_of(Memory::upload));
    auto flags = tagged<VkMemoryAllocateFlagsInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO);
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    auto allocate = tagged<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &flags);
    allocate.allocationSize = needs.size, allocate.memoryTypeIndex = static_cast<std::uint32_t>(std::max(type, 0));
    VkDeviceMemory allocated = VK_NULL_HANDLE;
    const VkResult r = type < 0 ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                                : h.f.vkAllocateMemory(h.device, &allocate, nullptr, &allocated);
    if (r != VK_SUCCESS) {
        h.f.vkDestroyBuffer(h.device, buffer, nullptr);
        buffer_ = nullptr;
        if (r == VK_ERROR_DEVICE_LOST) h.check(r, "allocating memory");
        throw Error("{}: expected {:.2f} GiB of memory for {}, found {:.2f} GiB free ({})", h.name,
                    static_cast<double>(bytes_) / (1 << 30), purpose,
                    static_cast<double>(device.free_memory()) / (1 << 30), name_of(r));
    }
    memory_ = allocated;
    h.check(h.f.vkBindBufferMemory(h.device, buffer, allocated, 0), "binding memory");
    if (memory != Memory::device)
        h.check(h.f.vkMapMemory(h.device, allocated, 0, VK_WHOLE_SIZE, 0, &mapped_), "mapping memory");
    auto address = tagged<VkBufferDeviceAddressInfo>(VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO);
    address.buffer = buffer;
    address_ = h.f.vkGetBufferDeviceAddress(h.device, &address);
}

Buffer::~Buffer() {
    if (!buffer_) return;
    DeviceHandles& h = device_->handles();
    h.f.vkDestroyBuffer(h.device, as<VkBuffer>(buffer_), nullptr);
    h.f.vkFreeMemory(h.device, as<VkDeviceMemory>(memory_), nullptr);
}

Buffer::Buffer(Buffer&& other) noexcept { *this = std::move(other); }
Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(device_, other.device_), std::swap(bytes_, other.bytes_), std::swap(address_, other.address_);
    std::swap(buffer_, other.buffer_), std::swap(memory_, other.memory_), std::swap(mapped_, other.mapped_);
    return *this;
}

Kernel::Kernel(Device& device, std::string name, std::span<const std::uint32_t> spirv,
               std::span<const std::uint32_t> constants)
    : device_(&device), name_(std::move(name)) {
    DeviceHandles& h = device.handles();
    auto code = tagged<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    code.codeSize = spirv.size_bytes(), code.pCode = spirv.data();
    VkShaderModule module = VK_NULL_HANDLE;
    h.check(h.f.vkCreateShaderModule(h.device, &code, nullptr, &module), "loading a kernel");
    VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, kMostPushBytes};
    auto layout_info = tagged<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    layout_info.pushConstantRangeCount = 1, layout_info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    h.check(h.f.vkCreatePipelineLayout(h.device, &layout_info, nullptr, &layout), "creating a kernel's layout");
    layout_ = layout;
    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < constants.size(); ++i) entries.push_back({i, i * 4, 4});
    const VkSpecializationInfo specialization{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                              constants.size_bytes(), constants.data()};
    auto size = tagged<VkPipelineShaderStageRequiredSubgroupSizeCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO);
    size.requiredSubgroupSize = device.subgroup_size();
    auto info = tagged<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = tagged<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage.pNext = &size;
    info.stage.flags = VK_PIPELINE_SHADER_STAGE_CREATE_REQUIRE_FULL_SUBGROUPS_BIT;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT, info.stage.module = module, info.stage.pName = "main";
    info.stage.pSpecializationInfo = &specialization;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult r = h.f.vkCreateComputePipelines(h.device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    h.f.vkDestroyShaderModule(h.device, module, nullptr);
    h.check(r, fmt::format("compiling kernel {}", name_).c_str());
    pipeline_ = pipeline;
}

Kernel::~Kernel() {
    if (!layout_) return;
    DeviceHandles& h = device_->handles();
    h.f.vkDestroyPipeline(h.device, as<VkPipeline>(pipeline_), nullptr);
    h.f.vkDestroyPipelineLayout(h.device, as<VkPipelineLayout>(layout_), nullptr);
}
Kernel::Kernel(Kernel&& other) noexcept { *this = std::move(other); }
Kernel& Kernel::operator=(Kernel&& other) noexcept {
    std::swap(name_, other.name_), std::swap(device_, other.device_), std::swap(pipeline_, other.pipeline_),
        std::swap(layout_, other.layout_);
    return *this;
}

namespace {
constexpr std::uint32_t kMostQueries = 2048;  // two a kernel
}

Commands::Commands(Device& device) : device_(device) {
    DeviceHandles& h = device.handles();
    auto info = tagged<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    info.commandPool = h.pool, info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY, info.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    h.check(h.f.vkAllocateCommandBuffers(h.device, &info, &commands), "allocating commands");
    commands_ = commands;
}
Commands::~Commands() {
    DeviceHandles& h = device_.handles();
    if (ticket_) h.f.vkDeviceWaitIdle(h.device);
    const auto commands = as<VkCommandBuffer>(commands_);
    if (queries_) h.f.vkDestroyQueryPool(h.device, as<VkQueryPool>(queries_), nullptr);
    h.f.vkFreeCommandBuffers(h.device, h.pool, 1, &commands);
}

void Commands::begin() {
    wait();
    DeviceHandles& h = device_.handles();
    auto info = tagged<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    h.check(h.f.vkBeginCommandBuffer(as<VkCommandBuffer>(commands_), &info), "recording commands");
    empty_ = true;
    barrier();  // after the lists submitted before
    timed_.clear();
    if (!h.is_timing) return;
    if (!queries_) {
        auto queries = tagged<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
        queries.queryType = VK_QUERY_TYPE_TIMESTAMP, queries.queryCount = kMostQueries;
        VkQueryPool pool = VK_NULL_HANDLE;
        h.check(h.f.vkCreateQueryPool(h.device, &queries, nullptr, &pool), "creating timers");
        queries_ = pool;
    }
    h.f.vkCmdResetQueryPool(as<VkCommandBuffer>(commands_), as<VkQueryPool>(queries_), 0, kMostQueries);
}

void Commands::read_times() {
    if (timed_.empty()) return;
    DeviceHandles& h = device_.handles();
    std::vector<std::uint64_t> ticks(2 * timed_.size());
    h.check(
        h.f.vkGetQueryPoolResults(h.device, as<VkQueryPool>(queries_), 0, static_cast<std::uint32_t>(ticks.size()),
                                  ticks.size() * 8, ticks.data(), 8, VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "reading timers");
    for (std::size_t i = 0; i < timed_.size(); ++i)
        h.times_ms[timed_[i]] += static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * h.tick_ms;
    timed_.clear();
}

void Commands::barrier() {
    DeviceHandles& h = device_.handles();
    constexpr VkPipelineStageFlags kStages = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
    auto memory = tagged<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    memory.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
    memory.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_READ_BIT |
                           VK_ACCESS_TRANSFER_WRITE_BIT;
    h.f.vkCmdPipelineBarrier(as<VkCommandBuffer>(commands_), kStages, kStages, 0, 1, &memory, 0, nullptr, 0, nullptr);
}

void Commands::run(const Kernel& kernel, Groups groups, const void* push, std::uint32_t push_bytes) {
    FASTSCENE_CHECK(push_bytes <= Kernel::kMostPushBytes && groups.x > 0 && groups.y > 0 && groups.z > 0);
    DeviceHandles& h = device_.handles();
    const auto commands = as<VkCommandBuffer>(commands_);
    if (!std::exchange(empty_, false)) barrier();
    h.f.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, as<VkPipeline>(kernel.pipeline_));
    h.f.vkCmdPushConstants(commands, as<VkPipelineLayout>(kernel.layout_), VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes,
                           push);
    const bool timed = h.is_timing && queries_ && 2 * timed_.size() < kMostQueries;
    const auto stamp = [&](VkPipelineStageFlagBits stage, std::size_t query) {
        if (timed)
            h.f.vkCmdWriteTimestamp(commands, stage, as<VkQueryPool>(queries_), static_cast<std::uint32_t>(query));
    };
    stamp(VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 2 * timed_.size());
    h.f.vkCmdDispatch(commands, groups.x, groups.y, groups.z);
    stamp(VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 2 * timed_.size() + 1);
    if (timed) timed_.push_back(kernel.name_);
}

void Commands::copy(const Buffer& from, std::int64_t from_byte, const Buffer& to, std::int64_t to_byte,
                    std::int64_t bytes) {
    FASTSCENE_CHECK(from_byte + bytes <= from.bytes() && to_byte + bytes <= to.bytes());
    if (bytes == 0) return;
    DeviceHandles& h = device_.handles();
    if (!std::exchange(empty_, false)) barrier();
    const VkBufferCopy region{static_cast<VkDeviceSize>(from_byte), static_cast<VkDeviceSize>(to_byte),
                              static_cast<VkDeviceSize>(bytes)};
    h.f.vkCmdCopyBuffer(as<VkCommandBuffer>(commands_), as<VkBuffer>(from.buffer_), as<VkBuffer>(to.buffer_), 1,
                        &region);
}

void Commands::fill(const Buffer& buffer, std::uint32_t word) {
    DeviceHandles& h = device_.handles();
    if (!std::exchange(empty_, false)) barrier();
    h.f.vkCmdFillBuffer(as<VkCommandBuffer>(commands_), as<VkBuffer>(buffer.buffer_), 0, VK_WHOLE_SIZE, word);
}

void Commands::submit() {
    DeviceHandles& h = device_.handles();
    const auto commands = as<VkCommandBuffer>(commands_);
    // The host reads mapped memory after wait().
    auto memory = tagged<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    memory.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
    memory.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    h.f.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                             VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &memory, 0, nullptr, 0, nullptr);
    h.check(h.f.vkEndCommandBuffer(commands), "recording commands");
    const std::uint64_t after = ++h.submitted;
    auto values = tagged<VkTimelineSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO);
    values.signalSemaphoreValueCount = 1, values.pSignalSemaphoreValues = &after;
    auto info = tagged<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO, &values);
    info.commandBufferCount = 1, info.pCommandBuffers = &commands;
    info.signalSemaphoreCount = 1, info.pSignalSemaphores = &h.timeline;
    h.check(h.f.vkQueueSubmit(h.queue, 1, &info, VK_NULL_HANDLE), "submitting work");
    ticket_ = after;
}

void Commands::wait() {
    if (!ticket_) return;
    DeviceHandles& h = device_.handles();
    auto info = tagged<VkSemaphoreWaitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO);
    info.semaphoreCount = 1, info.pSemaphores = &h.timeline, info.pValues = &ticket_;
    h.check(h.f.vkWaitSemaphores(h.device, &info, ~std::uint64_t{0}), "waiting for work");
    ticket_ = 0;
    read_times();
}

Transfers& Device::transfers() {
    if (!transfers_) transfers_ = std::make_unique<Transfers>(*this);
    return *transfers_;
}

void upload(Device& device, const Buffer& to, std::int64_t to_byte, const void* from, std::int64_t bytes) {
    if (bytes == 0) return;
    if (to.mapped()) {
        std::memcpy(static_cast<char*>(to.mapped()) + to_byte, from, static_cast<std::size_t>(bytes));
        return;
    }
    Transfers& transfers = device.transfers();
    const Buffer& staging = transfers.up(bytes);
    for (std::int64_t done = 0; done < bytes; done += Transfers::kMostBytes) {
        const std::int64_t now = std::min(Transfers::kMostBytes, bytes - done);
        std::memcpy(staging.mapped(), static_cast<const char*>(from) + done, static_cast<std::size_t>(now));
        transfers.copy(staging, 0, to, to_byte + done, now);
    }
}

namespace {

void take_pieces(Device& device, const Buffer& from, std::int64_t from_byte, std::int64_t bytes,
                 std::int64_t item_bytes, const TakePiece& take) {
    if (bytes == 0) return;
    if (from.mapped()) {
        take(static_cast<const char*>(from.mapped()) + from_byte, 0, bytes);
        return;
    }
    Transfers& transfers = device.transfers();
    const Buffer& staging = transfers.down(bytes);
    const std::int64_t piece = Transfers::kMostBytes / item_bytes * item_bytes;
    for (std::int64_t done = 0; done < bytes; done += piece) {
        const std::int64_t now = std::min(piece, bytes - done);
        transfers.copy(from, from_byte + done, staging, 0, now);
        take(staging.mapped(), done, now);
    }
}

}  // namespace

void download(Device& device, const Buffer& from, std::int64_t from_byte, void* to, std::int64_t bytes) {
    take_pieces(device, from, from_byte, bytes, 1, [&](const void* piece, std::int64_t at, std::int64_t size) {
        std::memcpy(static_cast<char*>(to) + at, piece, static_cast<std::size_t>(size));
    });
}

void download_in_pieces(Device& device, const Buffer& from, std::int64_t bytes, std::int64_t item_bytes,
                        const TakePiece& take) {
    take_pieces(device, from, 0, bytes, item_bytes, take);
}

}  // namespace fastscene::gpu
