#include "fastscene/rooms/model_materials.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/rooms/cutout.h"
#include "fastscene/rooms/prompt_text.h"
#include "fastscene/rooms/texture_image.h"

namespace fastscene {
namespace {

constexpr int kModelTexels = 2048;            // of a side: a piece two metres wide, seen from one metre away
constexpr std::size_t kCutTriangles = 40000;  // of a material with holes
constexpr float kLampShare = 0.3f;            // of the style's lamp light, as our own shades have it
// parts of the names by which a lamp's glowing material is known
constexpr std::string_view kLightNames[] = {"bulb", "shade", "light", "glow", "emis", "led", "neon"};
constexpr float kClear = 0.6f;  // below this opacity, even surfaces are glass

void make_glass(Material& m) {
    m.color_a = m.color_b = m.color_c = {0.6f, 0.68f, 0.66f};
    m.roughness = 0.05f;
    m.specular = 0.08f;
    m.transmission = 0.8f;
}

// The pictures of a model, each made once however many materials show it.
class ModelPictures {
  public:
    explicit ModelPictures(std::vector<GltfImage>& images)
        : images_(images), color_(images.size()), data_(images.size()) {}

    std::shared_ptr<const TextureImage> color(int i) {
        if (!has(i)) return nullptr;
        auto& made = color_[static_cast<std::size_t>(i)];
        const GltfImage& image = images_[static_cast<std::size_t>(i)];
        if (!made) made = texture_at_most(image.color, kModelTexels);
        return made;
    }
    // Numbers, not colors: their means are those of the bytes.
    std::shared_ptr<const TextureImage> data(int i) {
        if (!has(i)) return nullptr;
        auto& made = data_[static_cast<std::size_t>(i)];
        if (!made) made = data_texture_at_most(images_[static_cast<std::size_t>(i)].color, kModelTexels);
        return made;
    }
    const GltfImage* image(int i) const { return has(i) ? &images_[static_cast<std::size_t>(i)] : nullptr; }

  private:
    bool has(int i) const {
        return i >= 0 && static_cast<std::size_t>(i) < images_.size() &&
               !images_[static_cast<std::size_t>(i)].color.empty();
    }
    std::vector<GltfImage>& images_;
    std::vector<std::shared_ptr<const TextureImage>> color_, data_;
};

Material material_from(const GltfMaterial& g, ModelPictures& pictures) {
    Material m;
    m.name = g.name;
    m.color_a = g.base_color;
    for (std::size_t k = 0; k < 3; ++k) m.color_a[k] = std::clamp(m.color_a[k], 0.f, 1.f);
    m.roughness = std::clamp(g.roughness, 0.02f, 1.f);
    m.metal = std::clamp(g.metallic, 0.f, 1.f);
    const float r = (g.ior - 1) / (g.ior + 1);
    m.specular = std::clamp(r * r, 0.f, 0.2f);
    m.sheen = std::clamp(g.sheen, 0.f, 1.f);
    m.emission = g.emission;
    m.image = pictures.color(g.base_color_image);
    m.normals = pictures.data(g.normal_image);
    m.metallic_roughness = pictures.data(g.metallic_roughness_image);
    if (!m.image && (m.normals || m.metallic_roughness)) m.image = texture_image(ImageRgb8(1, 1, Rgb8{255, 255, 255}));
    if (m.image) m.pattern = Pattern::image;
    const bool even = !m.image && g.alpha_mode == GltfAlpha::blend && g.alpha < kClear;
    if (g.transmission >= 0.5f || even) {
        m.image = m.normals = m.metallic_roughness = nullptr, m.pattern = Pattern::plain, m.metal = 0;
        make_glass(m);
    } else {
        m.color_b = m.color_c = m.color_a;
    }
    return m;
}

float brightness_at(const ImageRgb8& image, Vec2f uv) {
    const auto at = [](float t, int n) {
        return std::clamp(static_cast<int>((t - std::floor(t)) * static_cast<float>(n)), 0, n - 1);
    };
    return luminance(linear_from_srgb8(image.at(at(uv.x, image.width), at(1 - uv.y, image.height))));
}

// Splits off the triangles on which the picture of its emission is bright.
ModelMesh glowing_part(ModelMesh& m) {
    constexpr float kBright = 0.12f;
    ModelMesh lit = m;
    lit.mesh.triangles.clear();
    std::vector<std::uint32_t> dark;
    double sum = 0;
    for (std::size_t t = 0; t + 2 < m.mesh.triangles.size(); t += 3) {
        Vec2f center{};
        float bright = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f c = m.mesh.coords[m.mesh.triangles[t + k]];
            center = center + Vec2f{c.x, c.y} * (1.f / 3);
            bright += brightness_at(m.glow, {c.x, c.y}) * 0.2f;
        }
        bright += brightness_at(m.glow, center) * 0.4f;
        auto& to = bright > kBright ? lit.mesh.triangles : dark;
        to.insert(to.end(), m.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t),
                  m.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t) + 3);
        if (bright > kBright) sum += static_cast<double>(bright);
    }
    if (!lit.mesh.triangles.empty())
        lit.material.emission = lit.material.emission *
                                static_cast<float>(3 * sum / static_cast<double>(lit.mesh.triangles.size()));
    m.mesh.triangles = std::move(dark);
    m.material.emission = {};
    m.glow = lit.glow = {};
    return lit;
}

bool is_named_like_a_light(const std::string& name) {
    const std::string words = folded(name);
    return std::any_of(std::begin(kLightNames), std::end(kLightNames),
                       [&](std::string_view part) { return words.find(part) != std::string::npos; });
}

}  // namespace

std::shared_ptr<const TextureImage> texture_at_most(ImageRgb8 image, int texels) {
    while (std::max(image.width, image.height) > texels) image = halved(image);
    return texture_image(std::move(image));
}

Material material_from(const ObjMaterial& m) {
    Material out;
    out.name = m.name;
    for (std::size_t k = 0; k < 3; ++k)
        out.color_a[k] = std::clamp(linear_from_srgb(std::clamp(m.diffuse[k], 0.f, 1.f)), 0.02f, 0.82f);
    const float shine = std::max({m.specular.x, m.specular.y, m.specular.z}),
                bright = std::max({m.diffuse.x, m.diffuse.y, m.diffuse.z});
    out.roughness = std::clamp(std::sqrt(2.f / (std::max(m.shininess, 0.f) + 2.f)), 0.12f, 0.8f);
    if (shine < 0.05f) out.roughness = std::max(out.roughness, 0.55f);
    if (shine > 0.6f && bright < 0.35f && bright > 0.02f && m.diffuse_map.empty() && m.opacity > 0.9f &&
        m.shininess > 90.f) {
        out.metal = 1.f;
        out.color_a = out.color_a + Vec3f{0.25f, 0.25f, 0.25f};
    }
    if (m.opacity < kClear && m.diffuse_map.empty()) make_glass(out);
    out.color_b = out.color_c = out.color_a;
    return out;
}

float metres_per_uv(const Mesh& m) {
    double space = 0, picture = 0;
    for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3) {
        const std::size_t a = m.triangles[t], b = m.triangles[t + 1], c = m.triangles[t + 2];
        space += length(cross(m.positions[b] - m.positions[a], m.positions[c] - m.positions[a]));
        const Vec3f p = m.coords[b] - m.coords[a], q = m.coords[c] - m.coords[a];
        picture += std::abs(p.x * q.y - p.y * q.x);
    }
    return picture > 1e-9 ? std::clamp(static_cast<float>(std::sqrt(space / picture)), 0.005f, 20.f) : 1.f;
}

float area_of(const Mesh& m) {
    double sum = 0;
    for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3)
        sum += length(cross(m.positions[m.triangles[t + 1]] - m.positions[m.triangles[t]],
                            m.positions[m.triangles[t + 2]] - m.positions[m.triangles[t]]));
    return static_cast<float>(sum / 2);
}

std::vector<ModelMesh> meshes_of(GltfModel model, std::vector<std::string>& notes) {
    ModelPictures pictures(model.images);
    std::vector<ModelMesh> out;
    for (GltfGroup& g : model.groups) {
        const GltfMaterial& material = model.materials[g.material];
        ModelMesh m;
        m.material = material_from(material, pictures);
        m.mesh.positions = std::move(g.positions), m.mesh.normals = std::move(g.normals);
        m.mesh.triangles = std::move(g.triangles);
        if (!g.uvs.empty())
            for (const Vec2f uv : g.uvs) m.mesh.coords.push_back({uv.x, uv.y, 0});
        else if (m.material.pattern == Pattern::image) {
            notes.push_back(
                fmt::format("material \"{}\" has a picture and its surface no texture coordinates: it is of "
                            "the picture's mean color",
                            material.name));
            m.material.color_a = m.material.color_a * linear_from_srgb8(m.material.image->levels.back().pixels.front());
            m.material.color_b = m.material.color_c = m.material.color_a;
            m.material.pattern = Pattern::plain;
            m.material.image = m.material.normals = m.material.metallic_roughness = nullptr;
        }
        const bool cut = material.alpha_mode != GltfAlpha::opaque;
        if (const GltfImage* image = pictures.image(material.base_color_image); image && cut && !g.uvs.empty()) {
            m.alpha = image->alpha;
            if (material.alpha_mode == GltfAlpha::mask)
                m.alpha_cutoff = std::clamp(static_cast<int>(255 * material.alpha_cutoff), 1, 255);
        }
        if (const GltfImage* glow = pictures.image(material.emission_image); glow && !g.uvs.empty())
            m.glow = glow->color;
        out.push_back(std::move(m));
    }
    return out;
}

std::vector<ModelMesh> meshes_of(ObjModel model, const std::string& file,
                                 const std::function<std::optional<std::string>(const std::string&)>& read_sibling,
                                 bool textures, std::vector<std::string>& notes) {
    std::vector<ModelMesh> out;
    for (ObjGroup& g : model.groups) {
        const ObjMaterial& material = model.materials[g.material];
        ModelMesh m;
        m.material = material_from(material);
        for (std::size_t k = 0; k < 3; ++k)
            m.material.emission[k] = linear_from_srgb(std::clamp(material.emission[k], 0.f, 1.f));
        m.mesh.positions = std::move(g.positions), m.mesh.normals = std::move(g.normals);
        m.mesh.triangles = std::move(g.triangles);
        for (const Vec2f uv : g.uvs) m.mesh.coords.push_back({uv.x, uv.y, 0});
        if (!material.diffuse_map.empty() && textures) try {
                const auto bytes = read_sibling(material.diffuse_map);
                if (!bytes) throw Error("{}: {}: not there", file, material.diffuse_map);
                m.material.image = texture_at_most(decode_rgb8(*bytes, file + ": " + material.diffuse_map),
                                                   kModelTexels);
                m.material.pattern = Pattern::image, m.material.color_a = {1, 1, 1};
            } catch (const Error& error) {
                notes.push_back(fmt::format("{}: the plain color is used", error.what()));
            }
        out.push_back(std::move(m));
    }
    return out;
}

void finish(ModelMesh m, std::vector<ModelMesh>& out) {
    if (m.mesh.coords.empty()) m.mesh.coords = m.mesh.positions;
    if (m.material.pattern == Pattern::image) m.material.scale_m = metres_per_uv(m.mesh);
    if (!m.alpha.empty()) m.mesh = cut_out(m.mesh, m.alpha, m.alpha_cutoff, kCutTriangles);
    if (!m.glow.empty() && max_component(m.material.emission) > 0) {
        ModelMesh lit = glowing_part(m);
        if (!lit.mesh.triangles.empty()) out.push_back(std::move(lit));
    }
    if (!m.mesh.triangles.empty()) out.push_back(std::move(m));
}

void light_up(std::vector<ModelMesh>& meshes, std::vector<std::string>& notes) {
    const auto glows = [](const ModelMesh& m) { return max_component(m.material.emission) > 0; };
    if (std::none_of(meshes.begin(), meshes.end(), glows))
        for (ModelMesh& m : meshes)
            if (is_named_like_a_light(m.material.name)) m.material.emission = {1, 1, 1};
    if (std::none_of(meshes.begin(), meshes.end(), glows))
        notes.push_back("gives no light: none of its materials emits any, and none is named bulb or shade");
    for (ModelMesh& m : meshes)
        if (glows(m)) m.material.emission = m.material.emission * (kLampShare / max_component(m.material.emission));
}

}  // namespace fastscene
