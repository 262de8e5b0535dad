#include <fmt/format.h>

#include <utility>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/gpu/device.h"
#include "fastscene/gpu/handles.h"

namespace fastscene::gpu {

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

}  // namespace fastscene::gpu
