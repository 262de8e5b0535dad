#include "fastscene/inpaint/inpaint.h"

namespace fastscene {

std::unique_ptr<Inpainter> make_inpainter(std::string_view name, const std::filesystem::path& weights,
                                          const std::string& device) {
    return registered_entry<InpaintBackend>("--walk-inpainter", name).make(weights, device);
}

}  // namespace fastscene
