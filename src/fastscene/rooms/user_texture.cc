#include "fastscene/rooms/user_texture.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/io/image_io.h"
#include "fastscene/rooms/model_materials.h"
#include "fastscene/rooms/texture_image.h"

namespace fastscene {
namespace {

constexpr int kSurfaceTexels = 4096;    // of a side: a square metre seen from half a metre away
constexpr int kLargestPicture = 16384;  // pixels of a file's side
constexpr float kReliefDepth = 0.01f;   // of height maps from black to white, in widths of the picture

ImageRgb8 read_map(const std::filesystem::path& file) {
    const PictureInfo info = picture_info(file);
    if (std::max(info.width, info.height) > kLargestPicture)
        throw Error("{}: expected at most {} pixels a side, found {} x {}", file.string(), kLargestPicture, info.width,
                    info.height);
    return load_rgb8(file);
}

std::uint8_t byte_of(float v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.f, 1.f) * 255)); }

// Roughness in green, metal in blue, at the size of the first.
ImageRgb8 packed(const ImageRgb8& roughness, const ImageRgb8& metal) {
    const ImageRgb8& size = roughness.empty() ? metal : roughness;
    ImageRgb8 out(size.width, size.height, Rgb8{0, 255, 255});
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            if (!roughness.empty()) out.at(x, y).g = roughness.at(x, y).g;
            if (!metal.empty()) out.at(x, y).b = metal.at(x * metal.width / out.width, y * metal.height / out.height).g;
        }
    return out;
}

}  // namespace

Material texture_called(const std::string& name) {
    Material m;
    m.name = name;
    m.pattern = Pattern::image;
    m.color_a = m.color_b = m.color_c = {1, 1, 1};
    m.scale_m = 1;
    return m;
}

bool lacks_pictures(const Material& m) { return m.pattern == Pattern::image && !m.image; }

ImageRgb8 normals_of_height(const ImageRgb8& height, float depth_m, float width_m) {
    ImageRgb8 out(height.width, height.height);
    const float steep = depth_m / 255 * static_cast<float>(height.width) / (2 * width_m);
    const auto at = [&](int x, int y) {
        return static_cast<float>(height.at((x + height.width) % height.width, (y + height.height) % height.height).g);
    };
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            // Rows grow downward, v upward.
            const Vec3f n = normalize(
                Vec3f{-steep * (at(x + 1, y) - at(x - 1, y)), -steep * (at(x, y - 1) - at(x, y + 1)), 1});
            out.at(x, y) = {byte_of(n.x * 0.5f + 0.5f), byte_of(n.y * 0.5f + 0.5f), byte_of(n.z * 0.5f + 0.5f)};
        }
    return out;
}

Material load_user_texture(const std::filesystem::path& folder, const UserTexture& t) {
    Material m = texture_called(t.names.front());
    m.scale_m = t.width_m;
    m.image = texture_at_most(read_map(folder / t.color), kSurfaceTexels);
    if (!t.normals.empty()) {
        ImageRgb8 normals = read_map(folder / t.normals);
        if (t.normals_down)
            for (Rgb8& c : normals.pixels) c.g = static_cast<std::uint8_t>(255 - c.g);
        m.normals = data_texture_at_most(std::move(normals), kSurfaceTexels);
    } else if (!t.height.empty()) {
        m.normals = data_texture_at_most(
            normals_of_height(read_map(folder / t.height), kReliefDepth * t.width_m, t.width_m), kSurfaceTexels);
    }
    if (!t.roughness.empty() || !t.metal.empty()) {
        m.roughness = t.roughness.empty() ? m.roughness : 1.f;
        m.metal = t.metal.empty() ? 0.f : 1.f;
        m.metallic_roughness = data_texture_at_most(
            packed(t.roughness.empty() ? ImageRgb8() : read_map(folder / t.roughness),
                   t.metal.empty() ? ImageRgb8() : read_map(folder / t.metal)),
            kSurfaceTexels);
    }
    return m;
}

}  // namespace fastscene
