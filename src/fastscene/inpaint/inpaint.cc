#include "fastscene/inpaint/inpaint.h"

namespace fastscene {
namespace {

constexpr int kSeamPart = 8;  // of the columns, repeated beyond the seam on each side: one in so many

template <class Pixel>
Image<Pixel> continued(const Image<Pixel>& picture, int beyond) {
    Image<Pixel> out(picture.width + 2 * beyond, picture.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) out.at(x, y) = picture.at((x - beyond + picture.width) % picture.width, y);
    return out;
}

}  // namespace

ImageColor fill_panorama(const Inpainter& inpainter, const ImageColor& panorama, const ImageMask& hole,
                         const Run& run) {
    if (!inpainter.invents()) return inpainter.fill(panorama, hole, run);
    const int beyond = panorama.width / kSeamPart;
    const ImageColor painted = inpainter.fill(continued(panorama, beyond), continued(hole, beyond), run);
    ImageColor out = panorama;
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            if (hole.at(x, y)) out.at(x, y) = painted.at(x + beyond, y);
    return out;
}

std::unique_ptr<Inpainter> make_inpainter(std::string_view name, const std::filesystem::path& weights,
                                          const std::string& device, const std::vector<std::string>& trusted) {
    return registered_entry<InpaintBackend>("--walk-inpainter", name).make(weights, device, trusted);
}

}  // namespace fastscene
