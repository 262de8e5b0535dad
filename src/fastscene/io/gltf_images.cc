#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/io/gltf_materials.h"
#include "fastscene/io/image_io.h"

namespace fastscene {

GltfMaterial GltfImages::with_images(const GltfSurface& surface) {
    GltfMaterial material = surface.material;
    if (!limits_.images) return material;
    material.base_color_image = image(surface.base_color, true);
    material.metallic_roughness_image = image(surface.metallic_roughness, false);
    material.normal_image = image(surface.normal, false);
    material.emission_image = image(surface.emission, false);
    if (const int gloss = roughness_image(surface.glossiness, surface.glossiness_factor); gloss >= 0)
        material.metallic_roughness_image = gloss, material.roughness = 1;
    return material;
}

std::vector<GltfImage> GltfImages::take() {
    for (std::size_t i = 0; i < images_.size(); ++i)
        if (!base_colors_.contains(static_cast<int>(i))) images_[i].alpha = {};
    return std::move(images_);
}

int GltfImages::image(int texture, bool is_base_color) {
    if (texture < 0) return -1;
    const auto source = source_of(static_cast<std::size_t>(texture));
    if (!source) return -1;
    const auto known = of_source_.find(*source);
    const int found = known != of_source_.end() ? known->second : of_source_[*source] = loaded(*source);
    if (found >= 0 && is_base_color) base_colors_.insert(found);
    return found;
}

int GltfImages::loaded(std::size_t source) {
    std::optional<GltfImage> image = load(source);
    if (!image) return -1;
    images_.push_back(std::move(*image));
    return static_cast<int>(images_.size()) - 1;
}

// Roughness is what glossiness, in the picture's alpha, leaves.
int GltfImages::roughness_image(int texture, float factor) {
    const auto source = texture < 0 ? std::nullopt : source_of(static_cast<std::size_t>(texture));
    if (!source) return -1;
    const auto [known, is_new] = of_glossiness_.try_emplace({*source, factor}, -1);
    if (!is_new) return known->second;
    std::optional<GltfImage> image = load(*source);
    if (!image || image->alpha.empty()) return -1;
    for (std::size_t i = 0; i < image->color.size(); ++i) {
        const float gloss = factor * static_cast<float>(image->alpha.pixels[i]);
        image->color.pixels[i] = {0, static_cast<std::uint8_t>(std::lround(255 - gloss)), 0};
    }
    image->alpha = {};
    image->name += " (roughness)";
    images_.push_back(std::move(*image));
    return known->second = static_cast<int>(images_.size()) - 1;
}

// A picture in a format of glTF itself goes before one in a format of an extension.
std::optional<std::size_t> GltfImages::source_of(std::size_t texture) {
    const Json& of = document_.item("textures", texture);
    if (of.contains("source")) return document_.whole(of, "source");
    for (const char* name : {"EXT_texture_webp", "EXT_texture_avif"})
        if (const Json* other = GltfJson::extension(of, name)) return document_.whole(*other, "source");
    notes_.add(GltfJson::extension(of, "KHR_texture_basisu")
                   ? fmt::format("Texture {} is left out: it is KTX 2 (Basis); save it as PNG or JPEG.", texture)
                   : fmt::format("Texture {} is left out: it has no picture.", texture));
    return {};
}

std::optional<GltfImage> GltfImages::load(std::size_t source) {
    const Json& of = document_.item("images", source);
    const std::string uri = GltfJson::text(of, "uri");
    GltfImage image;
    image.name = GltfJson::text(of, "name", uri.starts_with("data:") ? "" : uri);
    if (image.name.empty()) image.name = fmt::format("image {}", source);
    const std::string label = GltfJson::brief(image.name);
    const auto leave = [&](const std::string& why) {
        notes_.add(fmt::format("Picture \"{}\" is left out: {}.", label, why));
        return std::nullopt;
    };
    try {
        std::optional<std::string> own;
        if (!uri.empty()) {
            own = document_.content(uri);
            if (!own) return leave("there is no such file");
        }
        const std::string_view bytes = own ? std::string_view(*own) : document_.view(document_.whole(of, "bufferView"));
        const PictureInfo info = picture_info(bytes, label);
        if (std::max(info.width, info.height) > limits_.image_side)
            return leave(fmt::format("expected at most {} pixels a side, found {} x {}", limits_.image_side, info.width,
                                     info.height));
        const auto pixels = static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height);
        if (pixels > limits_.image_pixels - pixels_)
            return leave(fmt::format("expected at most {} pixels in all pictures, found more", limits_.image_pixels));
        pixels_ += pixels;
        ColorAndAlpha decoded = decode_color_and_alpha(bytes, label);
        image.color = std::move(decoded.color), image.alpha = std::move(decoded.alpha);
        return image;
    } catch (const Error& e) {
        return leave(e.what());
    }
}

}  // namespace fastscene
