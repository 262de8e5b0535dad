// What renders a TracedRoom: Embree, or another processor that takes over gathering and pictures.
#pragma once

#include <memory>
#include <string>

#include "fastscene/base/registry.h"
#include "fastscene/trace/gatherer.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/picture.h"

namespace fastscene {

// A room on another processor. Its pictures are Embree's up to rounding: the random numbers are the same. Not for
// several threads at once.
class RoomTracer {
  public:
    virtual ~RoomTracer() = default;
    virtual std::string device() const = 0;
    // Fills the irradiance cache, which the pictures then read.
    virtual Gatherer& gatherer() = 0;
    virtual void set_look(const Look& look, const Sky& sky) = 0;
    // For cached_picture.
    virtual MakePixelTracer pixels(const ShotParts& parts) = 0;
    // The sums of path_traced_picture: `samples` paths a pixel.
    virtual ImageColor path_sums(const RayCamera& camera, const ShotParts& parts, int samples, const Run& run) = 0;
};

// In a source file of its own under trace/trace_backends/. Flags, --help and errors take their lists from the registry.
struct TraceBackendEntry {
    std::string name = {};   // as its source file
    std::string about = {};  // half a sentence, for --help
    // Throws UsageError naming `flag` for a device that there is not, and with all of them for "list". Null: there is
    // no choice.
    void (*check_device)(const std::string& device, const std::string& flag) = nullptr;
    // `device`: TraceBackend::device. Throws UsageError for a device that there is not. `room` and `lights` must live
    // as long. Null: Embree.
    std::unique_ptr<RoomTracer> (*make)(const std::string& device, const Room& room, const Lights& lights) = nullptr;
};

// Throws UsageError naming `flag` for a device that the backend has not, and with all devices for "list".
void check_device(const TraceBackend& backend, const std::string& flag);

}  // namespace fastscene
