// Copies between host and device. For this module only.
#pragma once

#include "fastscene/gpu/device.h"

namespace fastscene::gpu {

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
    const Buffer& reserved(Buffer& buffer, std::int64_t bytes, Memory memory);

    Device& device_;
    Commands commands_;
    Buffer up_, down_;
};

}  // namespace fastscene::gpu
