#include "fastscene/rooms/texture_image.h"

#include <algorithm>
#include <utility>

#include "fastscene/image/color.h"

namespace fastscene {
namespace {

ImageRgb8 halved_data(const ImageRgb8& image) {
    ImageRgb8 out(std::max(1, image.width / 2), std::max(1, image.height / 2));
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            int r = 2, g = 2, b = 2;  // rounds
            for (const int j : {0, 1})
                for (const int i : {0, 1}) {
                    const Rgb8 c = image.at(std::min(2 * x + i, image.width - 1),
                                            std::min(2 * y + j, image.height - 1));
                    r += c.r, g += c.g, b += c.b;
                }
            out.at(x, y) = {static_cast<std::uint8_t>(r / 4), static_cast<std::uint8_t>(g / 4),
                            static_cast<std::uint8_t>(b / 4)};
        }
    return out;
}

}  // namespace

ImageRgb8 halved(const ImageRgb8& image) {
    ImageRgb8 out(std::max(1, image.width / 2), std::max(1, image.height / 2));
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            Vec3f sum{};
            for (const int j : {0, 1})
                for (const int i : {0, 1})
                    sum += linear_from_srgb8(
                        image.at(std::min(2 * x + i, image.width - 1), std::min(2 * y + j, image.height - 1)));
            out.at(x, y) = srgb8_from_linear(sum / 4.f);
        }
    return out;
}

std::shared_ptr<const TextureImage> data_texture_at_most(ImageRgb8 image, int texels) {
    while (std::max(image.width, image.height) > texels) image = halved_data(image);
    TextureImage texture;
    texture.levels.push_back(std::move(image));
    while (texture.levels.back().width > 1 || texture.levels.back().height > 1)
        texture.levels.push_back(halved_data(texture.levels.back()));
    return std::make_shared<const TextureImage>(std::move(texture));
}

std::shared_ptr<const TextureImage> texture_image(ImageRgb8 image) {
    TextureImage texture;
    texture.levels.push_back(std::move(image));
    while (texture.levels.back().width > 1 || texture.levels.back().height > 1)
        texture.levels.push_back(halved(texture.levels.back()));
    return std::make_shared<const TextureImage>(std::move(texture));
}

}  // namespace fastscene
