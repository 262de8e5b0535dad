#include "fastscene/io/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

// Reads one material.
class Surface {
  public:
    Surface(const GltfDocument& document, const Json& of, std::string name, GltfNotes& notes)
        : document_(document), of_(of), name_(std::move(name)), notes_(notes) {}

    GltfSurface read() {
        GltfMaterial& m = out_.material;
        m.name = GltfJson::text(of_, "name", name_);
        m.double_sided = flag("doubleSided");
        const std::string mode = GltfJson::text(of_, "alphaMode", "OPAQUE");
        m.alpha_mode = mode == "MASK" ? GltfAlpha::mask : mode == "BLEND" ? GltfAlpha::blend : GltfAlpha::opaque;
        m.alpha_cutoff = share(of_, "alphaCutoff", 0.5f);
        if (const Json* glossy = extension("KHR_materials_pbrSpecularGlossiness")) read_specular_glossiness(*glossy);
        else if (const Json* pbr = GltfJson::object(of_, "pbrMetallicRoughness")) read_metallic_roughness(*pbr);
        m.emission = color(of_, "emissiveFactor", {});
        if (const Json* more = extension("KHR_materials_emissive_strength"))
            m.emission *= number(*more, "emissiveStrength", 1.f, 0.f, 1e6f);
        if (const Json* normal = GltfJson::object(of_, "normalTexture"))
            m.normal_scale = number(*normal, "scale", 1.f, -100.f, 100.f);
        out_.normal = texture(of_, "normalTexture", "normal");
        out_.emission = texture(of_, "emissiveTexture", "emission");
        read_extensions();
        if (m.alpha_mode == GltfAlpha::opaque) m.alpha = 1;
        return std::move(out_);
    }

  private:
    const Json* extension(const char* name) const {
        const Json* found = GltfJson::extension(of_, name);
        return found && found->is_object() ? found : nullptr;
    }
    bool flag(const char* name) const {
        const auto found = of_.find(name);
        return found != of_.end() && *found == true;
    }
    static float number(const Json& owner, const char* name, float otherwise, float low, float high) {
        const auto found = owner.find(name);
        if (found == owner.end() || !found->is_number()) return otherwise;
        return static_cast<float>(std::clamp(found->get<double>(), double{low}, double{high}));
    }
    static float share(const Json& owner, const char* name, float otherwise) {
        return number(owner, name, otherwise, 0.f, 1.f);
    }
    Vec3f color(const Json& owner, const char* name, Vec3d otherwise) const {
        const auto c = document_.numbers(owner, name, {otherwise.x, otherwise.y, otherwise.z}, "material");
        const auto bounded = [](double v) { return static_cast<float>(std::clamp(v, 0., 1e6)); };
        return {bounded(c[0]), bounded(c[1]), bounded(c[2])};
    }
    void read_base_color(const Json& owner, const char* factor, const char* texture_name) {
        const auto c = document_.numbers(owner, factor, {1, 1, 1, 1}, "material");
        const auto bounded = [](double v) { return static_cast<float>(std::clamp(v, 0., 1.)); };
        out_.material.base_color = {bounded(c[0]), bounded(c[1]), bounded(c[2])};
        out_.material.alpha = bounded(c[3]);
        out_.base_color = texture(owner, texture_name, "base color");
        if (out_.base_color >= 0) out_.repeats = repeats(static_cast<std::size_t>(out_.base_color));
    }
    void read_metallic_roughness(const Json& pbr) {
        read_base_color(pbr, "baseColorFactor", "baseColorTexture");
        out_.material.metallic = share(pbr, "metallicFactor", 1);
        out_.material.roughness = share(pbr, "roughnessFactor", 1);
        out_.metallic_roughness = texture(pbr, "metallicRoughnessTexture", "metallic and roughness");
    }
    void read_specular_glossiness(const Json& pbr) {
        GltfMaterial& m = out_.material;
        read_base_color(pbr, "diffuseFactor", "diffuseTexture");
        m.metallic = 0;
        out_.glossiness_factor = share(pbr, "glossinessFactor", 1);
        m.roughness = 1 - out_.glossiness_factor;
        out_.glossiness = texture(pbr, "specularGlossinessTexture", "specular and glossiness");
        // A metal's color is in its highlights.
        const Vec3f specular = color(pbr, "specularFactor", {1, 1, 1});
        constexpr float kMetalSpecular = 0.25f;  // that of other things is below 0.1
        if (pbr.contains("specularFactor") && out_.base_color < 0 && out_.glossiness < 0 &&
            luminance(specular) > kMetalSpecular && luminance(specular) > luminance(m.base_color))
            m.base_color = specular, m.metallic = 1;
    }
    void read_extensions() {
        GltfMaterial& m = out_.material;
        if (const Json* more = extension("KHR_materials_ior"))
            if (const float ior = number(*more, "ior", 1.5f, 0.f, 10.f); ior >= 1) m.ior = ior;
        if (const Json* more = extension("KHR_materials_transmission")) {
            m.transmission = share(*more, "transmissionFactor", 0);
            leave_textures(*more);
        }
        if (const Json* more = extension("KHR_materials_clearcoat")) {
            m.clearcoat = share(*more, "clearcoatFactor", 0);
            leave_textures(*more);
        }
        if (const Json* more = extension("KHR_materials_sheen")) {
            m.sheen = luminance(color(*more, "sheenColorFactor", {}));
            leave_textures(*more);
        }
        if (extension("KHR_materials_unlit")) m.metallic = 0, m.roughness = 1, out_.metallic_roughness = -1;
    }
    void leave_textures(const Json& owner) {
        for (const auto& [name, value] : owner.items())
            if (value.is_object() && name.ends_with("Texture"))
                notes_.add(
                    fmt::format("Material {}: {} is left out; its factor is used.", label(), GltfJson::brief(name)));
    }

    std::string label() const { return fmt::format("\"{}\"", GltfJson::brief(GltfJson::text(of_, "name", name_))); }

    GltfUvUse uv_use(const Json& info) const {
        GltfUvUse use;
        use.set = document_.whole(info, "texCoord", 0);
        const Json* moved = GltfJson::extension(info, "KHR_texture_transform");
        if (!moved || !moved->is_object()) return use;
        const auto offset = document_.numbers(*moved, "offset", {0, 0}, "texture"),
                   scale = document_.numbers(*moved, "scale", {1, 1}, "texture");
        use.set = document_.whole(*moved, "texCoord", use.set);
        use.offset = {offset[0], offset[1]}, use.scale = {scale[0], scale[1]};
        use.rotation = number(*moved, "rotation", 0.f, -1e4f, 1e4f);
        return use;
    }
    // The first texture's coordinates are the material's: that of the base color if it has one.
    int texture(const Json& owner, const char* name, const char* meaning) {
        const Json* info = GltfJson::object(owner, name);
        if (!info) return -1;
        const std::size_t index = document_.whole(*info, "index");
        document_.item("textures", index);
        const GltfUvUse use = uv_use(*info);
        if (!used_) used_ = out_.uv = use;
        if (use == *used_) return static_cast<int>(index);
        notes_.add(fmt::format("Material {}: its picture of {} is left out: it has texture coordinates of its own.",
                               label(), meaning));
        return -1;
    }

    bool repeats(std::size_t texture) const {
        const Json& of = document_.item("textures", texture);
        if (!of.contains("sampler")) return true;
        const Json& sampler = document_.item("samplers", document_.whole(of, "sampler"));
        constexpr std::size_t kRepeat = 10497;
        return document_.whole(sampler, "wrapS", kRepeat) == kRepeat &&
               document_.whole(sampler, "wrapT", kRepeat) == kRepeat;
    }

    const GltfDocument& document_;
    const Json& of_;
    std::string name_;
    GltfNotes& notes_;
    GltfSurface out_;
    std::optional<GltfUvUse> used_;
};

}  // namespace

void GltfNotes::add(const std::string& note) {
    constexpr std::size_t kMostNotes = 50;
    if (known_.size() > kMostNotes || !known_.insert(note).second) return;
    notes_.push_back(known_.size() <= kMostNotes ? note : "There is more that was left out.");
}

Vec2d GltfUvUse::operator()(Vec2d uv) const {
    const double x = uv.x * scale.x, y = uv.y * scale.y, c = std::cos(rotation), s = std::sin(rotation);
    return {c * x + s * y + offset.x, c * y - s * x + offset.y};
}

GltfSurface gltf_surface(const GltfDocument& document, std::optional<std::size_t> index, GltfNotes& notes) {
    if (!index) {
        GltfSurface plain;
        plain.material.name = "default";
        return plain;
    }
    return Surface(document, document.item("materials", *index), fmt::format("material {}", *index), notes).read();
}

}  // namespace fastscene
