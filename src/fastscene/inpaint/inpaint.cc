#include "fastscene/inpaint/inpaint.h"

#include "fastscene/inpaint/harmonic.h"

namespace fastscene {

std::vector<std::string> inpainters() { return {"harmonic"}; }

std::unique_ptr<Inpainter> make_inpainter(std::string_view name) {
    if (name == "harmonic") return std::make_unique<HarmonicInpainter>();
    throw UsageError("unknown inpainter '{}': expected harmonic", name);
}

}  // namespace fastscene
