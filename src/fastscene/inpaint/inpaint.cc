#include "fastscene/inpaint/inpaint.h"

namespace fastscene {

std::unique_ptr<Inpainter> make_inpainter(std::string_view name, const std::filesystem::path& weights,
                                          const std::string& device, const std::vector<std::string>& trusted) {
    return registered_entry<InpaintBackend>("--walk-inpainter", name).make(weights, device, trusted);
}

}  // namespace fastscene
