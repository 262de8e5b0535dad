#include "fastscene/inpaint/inpaint.h"

#include "fastscene/inpaint/aotgan.h"
#include "fastscene/inpaint/harmonic.h"
#include "fastscene/nn/shipped.h"

namespace fastscene {
namespace {

constexpr std::string_view kShippedAotgan = "aotgan-rooms";  // models/aotgan-rooms.md

}  // namespace

std::vector<std::string> inpainters() { return {"harmonic", "aotgan"}; }

std::unique_ptr<Inpainter> make_inpainter(std::string_view name, const std::filesystem::path& weights) {
    if (name == "harmonic") return std::make_unique<HarmonicInpainter>();
    if (name != "aotgan") throw UsageError("unknown inpainter '{}': expected harmonic or aotgan", name);
    if (weights.empty() && is_shipped(kShippedAotgan))
        return std::make_unique<AotganInpainter>(Aotgan::of(shipped_weights(kShippedAotgan)));
    if (weights.empty())
        throw UsageError(
            "inpainter aotgan: expected a file of weights (--walk-inpaint-weights; fastscene models pull "
            "aotgan-places2 says where the official one "
            "is), found none");
    return std::make_unique<AotganInpainter>(Aotgan::load(weights));
}

}  // namespace fastscene
