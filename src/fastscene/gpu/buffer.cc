#include <algorithm>
#include <utility>

#include "fastscene/gpu/device.h"
#include "fastscene/gpu/handles.h"

namespace fastscene::gpu {
namespace {

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

}  // namespace fastscene::gpu
