#include "fastscene/inpaint/aotgan.h"

#include "fastscene/weights/shipped.h"

namespace fastscene::inpainters {
namespace {

constexpr std::string_view kShippedAotgan = "aotgan-rooms";  // models/aotgan-rooms.md

std::unique_ptr<Inpainter> make_aotgan(const std::filesystem::path& weights, const std::string& device,
                                       const std::vector<std::string>&) {
    const DeviceChoice where{device, "--walk-device"};
    if (!weights.empty()) return std::make_unique<AotganInpainter>(Aotgan::load(weights, where));
    if (is_shipped(kShippedAotgan))
        return std::make_unique<AotganInpainter>(Aotgan::of(shipped_weights(kShippedAotgan), where));
    throw UsageError(
        "inpainter aotgan: expected a file of weights (--walk-inpaint-weights; fastscene models pull aotgan-places2 "
        "says where the official one is), found none");
}

}  // namespace

InpaintBackend aotgan() {
    return {.name = "aotgan",
            .about = "the paper's network, with its shipped weights or --walk-inpaint-weights",
            .model = "aotgan-places2",
            .make = make_aotgan};
}

}  // namespace fastscene::inpainters
