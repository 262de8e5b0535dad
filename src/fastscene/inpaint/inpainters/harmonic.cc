#include "fastscene/inpaint/harmonic.h"

namespace fastscene::inpainters {

InpaintBackend harmonic() {
    return {.name = "harmonic",
            .about = "the smoothest fill there is",
            .make = [](const std::filesystem::path&, const std::string&, const std::vector<std::string>&)
                -> std::unique_ptr<Inpainter> { return std::make_unique<HarmonicInpainter>(); }};
}

}  // namespace fastscene::inpainters
