// A room on a graphics card: all that kernels read of it (tables.glsl).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fastscene/gpu/device.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/vulkan/tables.h"

namespace fastscene::vulkan {

class CardScene {
  public:
    // Geometry, materials and lights. Throws Error if the card has too little memory.
    CardScene(gpu::Device& device, const Room& room, const Lights& lights);

    // The look may change when the light is known.
    void set_look(const Look& look, const Sky& sky);
    std::uint64_t world() const { return world_buffer_.address(); }
    World& tables() { return world_; }
    // Copies tables() to the card.
    void write();
    // Keeps a copy of `bytes` bytes on the card; returns its address. 16 bytes at least.
    std::uint64_t keep(const void* from, std::int64_t bytes, const char* purpose);
    template <class T>
    std::uint64_t keep(const std::vector<T>& from, const char* purpose) {
        return keep(from.data(), static_cast<std::int64_t>(from.size() * sizeof(T)), purpose);
    }
    // Tables of the irradiance cache, which change while it is gathered.
    enum CacheTable { kCells, kSlots, kCoats, kSunPatches, kSunPlaces, kSunPowers, kCacheTables };
    template <class T>
    void set_cache(CacheTable which, const std::vector<T>& from) {
        set_cache(which, from.data(), static_cast<std::int64_t>(from.size() * sizeof(T)));
    }

  private:
    void set_cache(CacheTable which, const void* from, std::int64_t bytes);
    void add_geometry(const Room& room, const Lights& lights);
    void add_lights(const Room& room, const Lights& lights);
    void add_outside(const Room& room, const Outdoors& outdoors);

    gpu::Device& device_;
    std::vector<gpu::Buffer> buffers_;
    World world_{};
    gpu::Buffer world_buffer_;
    std::array<gpu::Buffer, kCacheTables> cache_;
};

}  // namespace fastscene::vulkan
