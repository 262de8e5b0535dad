// Graphics cards through Vulkan 1.2: what is there, memory that kernels address by pointers, and compute kernels run in
// order. The only module that uses Vulkan.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fastscene/base/error.h"

namespace fastscene::gpu {

struct DeviceInfo {
    int index = 0;                     // as in `--device N`
    std::string name;                  // as the driver tells it
    std::string driver;                // name and version
    bool is_card = false;              // false: a processor pretending to be one, such as Mesa's lavapipe
    std::int64_t memory = 0;           // bytes of the largest device-local heap
    int subgroup_size = 0;             // invocations that run in lockstep
    std::vector<std::string> missing;  // features we need and the driver lacks; empty: usable
};
// All devices of all installed drivers; empty without a Vulkan loader or driver.
std::vector<DeviceInfo> list_devices();
// The device that `wanted` names: "auto" (the usable card with the most memory; never a processor), an index, or a part
// of a name in any case. Throws UsageError naming `flag`, with the devices found.
DeviceInfo choose_device(const std::string& wanted, const std::string& flag);
// Whether "auto" would find a card.
bool has_card();

// The device stopped answering (driver reset, card removed): nothing on it can be recovered.
struct DeviceLost : Error {
    using Error::Error;
};

struct DeviceHandles;  // handles.h
class Transfers;       // transfers.h

class Device {
  public:
    explicit Device(const DeviceInfo& info);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const DeviceInfo& info() const { return info_; }
    // Bytes that can still be allocated without displacing others, as the driver estimates.
    std::int64_t free_memory() const;
    std::uint32_t subgroup_size() const { return static_cast<std::uint32_t>(info_.subgroup_size); }
    // Milliseconds that each kernel took on the device since the last call, summed by name; measured from now on. Slows
    // the device down a little.
    std::map<std::string, double> kernel_times();
    // Messages of the validation layer since the start; empty unless FASTSCENE_VULKAN_VALIDATION is set (and not 0).
    std::vector<std::string> validation_messages() const;

    DeviceHandles& handles() const { return *handles_; }
    Transfers& transfers();

  private:
    DeviceInfo info_;
    std::unique_ptr<DeviceHandles> handles_;
    std::unique_ptr<Transfers> transfers_;  // of upload() and download()
};

enum class Memory {
    device,   // fast for kernels
    upload,   // mapped; written by the host, read by kernels across the bus
    readback  // mapped; written by kernels, read by the host
};

// A piece of memory. Throws Error naming what it is for if the device has no more.
class Buffer {
  public:
    Buffer() = default;
    Buffer(Device& device, std::int64_t bytes, Memory memory, const char* purpose);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    std::uint64_t address() const { return address_; }  // for kernels; 0: none
    std::int64_t bytes() const { return bytes_; }
    void* mapped() const { return mapped_; }  // null for Memory::device
    explicit operator bool() const { return bytes_ > 0; }

  private:
    friend class Commands;
    Device* device_ = nullptr;
    std::int64_t bytes_ = 0;
    std::uint64_t address_ = 0;
    void *buffer_ = nullptr, *memory_ = nullptr;
    void* mapped_ = nullptr;
};

// A compiled compute shader. Specialization constants are numbered from 0.
class Kernel {
  public:
    static constexpr std::uint32_t kMostPushBytes = 128;  // what every device offers
    Kernel() = default;
    Kernel(Device& device, std::string name, std::span<const std::uint32_t> spirv,
           std::span<const std::uint32_t> constants);
    ~Kernel();
    Kernel(Kernel&& other) noexcept;
    Kernel& operator=(Kernel&& other) noexcept;

  private:
    friend class Commands;
    Device* device_ = nullptr;
    std::string name_;
    void *pipeline_ = nullptr, *layout_ = nullptr;
};

struct Groups {
    std::uint32_t x = 1, y = 1, z = 1;
};

// A list of commands. Each one sees the results of all before it.
class Commands {
  public:
    explicit Commands(Device& device);
    ~Commands();
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    // Waits until the last submission is done, and starts an empty list.
    void begin();
    void run(const Kernel& kernel, Groups groups, const void* push, std::uint32_t push_bytes);
    template <class Push>
    void run(const Kernel& kernel, Groups groups, const Push& push) {
        run(kernel, groups, &push, sizeof push);
    }
    void copy(const Buffer& from, std::int64_t from_byte, const Buffer& to, std::int64_t to_byte, std::int64_t bytes);
    void fill(const Buffer& buffer, std::uint32_t word);
    // Starts the device on the list; returns at once. Lists run in the order of their submission.
    void submit();
    // Waits until the last submission is done. Throws DeviceLost.
    void wait();

  private:
    void barrier();
    void read_times();
    Device& device_;
    void *commands_ = nullptr, *queries_ = nullptr;
    std::vector<std::string> timed_;  // kernels whose times are measured
    std::uint64_t ticket_ = 0;
    bool empty_ = true;
};

// Copies between host and device memory, through a mapped buffer of limited size. They wait for the device.
void upload(Device& device, const Buffer& to, std::int64_t to_byte, const void* from, std::int64_t bytes);
void download(Device& device, const Buffer& from, std::int64_t from_byte, void* to, std::int64_t bytes);
// The first `bytes` of a buffer, without a copy of them on the host: `take(piece, from_byte, bytes)` sees piece after
// piece, each of whole items of `item_bytes`.
using TakePiece = std::function<void(const void* piece, std::int64_t from_byte, std::int64_t bytes)>;
void download_in_pieces(Device& device, const Buffer& from, std::int64_t bytes, std::int64_t item_bytes,
                        const TakePiece& take);

}  // namespace fastscene::gpu
