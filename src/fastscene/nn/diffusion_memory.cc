#include "fastscene/nn/diffusion_memory.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/memory.h"

namespace fastscene {
namespace {

constexpr double kGiB = 1 << 30;
// Measured at 1024 x 512: one step with guidance; decoding in bands of 64 x 160 latents. Both scale with the area.
constexpr double kDenoise = 1.6 * kGiB, kDecode = 3.2 * kGiB, kBase = 0.3 * kGiB;
constexpr double kDecodeTile = kDecode * (64.0 * 64) / (64 * 160);

// Stable Diffusion 1.5: parameter counts of its parts, and of its largest kernel (2560 to 1280 channels, 3 x 3).
constexpr std::int64_t kDenoiserNumbers = 859520964, kPictureNumbers = 83653863, kTextNumbers = 123060480,
                       kLargestNumbers = 2560LL * 1280 * 9;

}  // namespace

std::int64_t diffusion_memory(const DiffusionMemory& run) {
    const double share = 0.5 * run.width * run.width / (1024.0 * 512);
    // With streaming, only the current parameter is in memory: as stored in the file and as converted.
    const auto held = [&](std::int64_t bytes) {
        return run.low_memory ? std::min<double>(static_cast<double>(bytes), 2.0 * static_cast<double>(run.largest))
                              : static_cast<double>(bytes);
    };
    const double others = run.low_memory ? 0 : static_cast<double>(run.text + run.pictures);
    const double denoise = held(run.denoiser) + held(run.control) + others + kDenoise * share;
    const double decode = held(run.pictures) +
                          (run.low_memory ? 0 : static_cast<double>(run.denoiser + run.control + run.text)) +
                          (run.tiled ? kDecodeTile : kDecode * share);
    return static_cast<std::int64_t>(std::max(denoise, decode) + kBase);
}

std::int64_t standard_diffusion_memory(int width, const std::string& precision, bool low_memory) {
    const std::int64_t bytes = precision == "bf16" ? 2 : 4;
    return diffusion_memory({width, low_memory, kDenoiserNumbers * bytes, kPictureNumbers * 4, kTextNumbers * 4, 0,
                             kLargestNumbers * bytes, low_memory || width > 1024});
}

void check_memory(const std::string& what, std::int64_t need, const std::string& remedies) {
    const std::int64_t have = available_memory();
    if (have > 0 && need > have)
        throw Error("{}: expected {} of free memory, found {}; close programs{}", what, gib_text(need), gib_text(have),
                    remedies);
}

std::string gib_text(std::int64_t bytes) { return fmt::format("{:.1f} GiB", static_cast<double>(bytes) / kGiB); }

}  // namespace fastscene
