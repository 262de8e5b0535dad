#include "fastscene/export/room_model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/shell.h"
#include "fastscene/io/image_io.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/texture.h"

namespace fastscene {
namespace {

constexpr int kTextureQuality = 85;      // of JPEG
constexpr float kUsualSpecular = 0.04f;  // the reflectance of a dielectric with the usual ior
// Meshes whose vertices differ by less than rounding are one.
constexpr float kSamePlace_m = 2e-4f, kSameUv = 1e-5f;

using Parts = std::vector<ModelPart>;

// Appends a mesh to the part with its material.
void append(Parts& parts, int material, const Mesh& mesh, const BakedMesh& baked, const Rigid& node_from_world) {
    if (baked.triangles.empty()) return;
    auto part = std::find_if(parts.begin(), parts.end(), [&](const ModelPart& p) { return p.material == material; });
    if (part == parts.end()) part = parts.insert(parts.end(), ModelPart{material, {}, {}, {}, {}});
    const auto first = static_cast<std::uint32_t>(part->positions.size());
    for (const std::uint32_t v : baked.vertices) {
        part->positions.push_back(node_from_world * mesh.positions[v]);
        const Vec3f normal = normalize(node_from_world.rotation * mesh.normals[v]);
        part->normals.push_back(normal == Vec3f{} ? Vec3f{0, 1, 0} : normal);
    }
    part->uv.insert(part->uv.end(), baked.uv.begin(), baked.uv.end());
    for (const std::uint32_t v : baked.triangles) part->triangles.push_back(first + v);
}

bool same(const ModelPart& a, const ModelPart& b) {
    if (a.material != b.material || a.triangles != b.triangles || a.positions.size() != b.positions.size() ||
        a.uv.size() != b.uv.size())
        return false;
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        if (length(a.positions[i] - b.positions[i]) > kSamePlace_m) return false;
    for (std::size_t i = 0; i < a.uv.size(); ++i)
        if (length(a.uv[i] - b.uv[i]) > kSameUv) return false;
    return true;
}
bool same(const Parts& a, const Parts& b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](const ModelPart& p, const ModelPart& q) { return same(p, q); });
}

ModelLight light_of(Vec3f intensity, Vec3f position = {}) {
    const float most = max_component(intensity);
    return {intensity / most, most, position};
}

// A point light amid the glowing surfaces of a thing, with the intensity that they have on average over all directions:
// radiance times a quarter of their area.
std::optional<ModelLight> lamp_of(const Room& room, const Parts& parts) {
    Vec3f intensity{}, center{};
    float weight = 0;
    for (const ModelPart& part : parts) {  // of materials of the room
        const Material& m = room.materials[at(part.material)];
        if (m.pattern == Pattern::screen || !(max_component(m.emission) > 0)) continue;
        for (std::size_t t = 0; t < part.triangles.size(); t += 3) {
            const Vec3f a = part.positions[part.triangles[t]], b = part.positions[part.triangles[t + 1]],
                        c = part.positions[part.triangles[t + 2]];
            const float area = 0.5f * length(cross(b - a, c - a)), w = area * luminance(m.emission);
            intensity += m.emission * (area / 4);
            center += (a + b + c) * (w / 3);
            weight += w;
        }
    }
    if (!(max_component(intensity) > 0) || !(weight > 0)) return std::nullopt;
    return light_of(intensity, center / weight);
}

class Builder {
  public:
    Builder(const Room& room, const BakeParams& params, const Run& run)
        : room_(room), same_(same_materials(room.materials)), baked_(bake(room, same_, params, run)) {}

    RoomModel model() {
        add_shell();
        const std::vector<std::string> ids = object_ids(room_);
        for (std::size_t i = 0; i < room_.objects.size(); ++i) add_object(i, ids[i]);
        add_sun();
        add_materials();
        return std::move(model_);
    }

  private:
    Parts parts_of(const auto& is_wanted, const Rigid& node_from_world) const {
        Parts parts;
        for (std::size_t m = 0; m < room_.meshes.size(); ++m)
            if (const Mesh& mesh = room_.meshes[m]; is_wanted(mesh))
                append(parts, same_[at(mesh.material)], mesh, baked_.meshes[m], node_from_world);
        return parts;
    }
    void add_shell() {
        for (const Shell kind : {Shell::floor, Shell::ceiling, Shell::walls}) {
            Parts parts = parts_of([&](const Mesh& mesh) { return mesh.object < 0 && shell_of(room_, mesh) == kind; },
                                   Rigid{kGltfAxes, {}});
            if (parts.empty()) continue;
            const char* name = kShellNames[static_cast<std::size_t>(kind)];
            model_.nodes.push_back({name, -1, {}, add_mesh(std::move(parts), name), std::nullopt});
        }
    }
    void add_object(std::size_t index, const std::string& id) {
        const RoomObject& object = room_.objects[index];
        Parts parts = parts_of([&](const Mesh& mesh) { return mesh.object == static_cast<int>(index); },
                               inverse(object.world_from_object));
        ModelNode node{id, static_cast<int>(index), Rigid{kGltfAxes, {}} * object.world_from_object, -1,
                       lamp_of(room_, parts)};
        if (!parts.empty()) node.mesh = mesh_like(std::move(parts), object.kind);
        model_.nodes.push_back(std::move(node));
    }
    // Equal things share one mesh.
    int mesh_like(Parts parts, const std::string& name) {
        for (const int known : known_[name])
            if (same(model_.meshes[at(known)].parts, parts)) return known;
        known_[name].push_back(add_mesh(std::move(parts), name));
        return known_[name].back();
    }
    int add_mesh(Parts parts, const std::string& name) {
        model_.meshes.push_back({name, std::move(parts)});
        return static_cast<int>(model_.meshes.size()) - 1;
    }
    // Those of the room, each by its own index; some are used by no part.
    void add_materials() {
        const auto share = [](float v) { return std::clamp(v, 0.f, 1.f); };
        for (std::size_t i = 0; i < room_.materials.size(); ++i) {
            const Material& m = room_.materials[i];
            BakedMaterial& baked = baked_.materials[i];
            const bool mirror = m.mirror > 0.5f;
            ModelMaterial out{m.name, {1, 1, 1}};
            if (baked.texture.empty()) {
                out.color = {share(baked.color.x), share(baked.color.y), share(baked.color.z)};
            } else {
                out.texture = static_cast<int>(model_.textures.size());
                model_.textures.push_back(std::move(baked.texture));
            }
            out.metal = mirror ? 1.f : share(mean_metal(m));
            out.roughness = mirror ? 0.f : share(baked.roughness);
            if (is_clear(m)) out.opacity = kClearOpacity;
            if (!mirror && m.metal < 1 && std::fabs(m.specular - kUsualSpecular) > 0.005f) {
                const float r = std::sqrt(std::clamp(m.specular, 0.f, 0.9f));
                out.ior = (1 + r) / (1 - r);
            }
            out.emission = m.emission;
            if (!baked.shown.empty()) {
                out.shown = static_cast<int>(model_.textures.size());
                model_.textures.push_back(std::move(baked.shown));
            }
            model_.materials.push_back(std::move(out));
        }
    }
    void add_sun() {
        if (!(max_component(room_.sky.sun_irradiance) > 0)) return;
        model_.sun = light_of(room_.sky.sun_irradiance);
        const Vec3f back = normalize(kGltfAxes * room_.sky.sun_dir);
        Vec3f right, up;
        make_frame(back, right, up);
        model_.sun_pose = {Mat3f::from_columns(right, up, back), {}};
    }

    const Room& room_;
    std::vector<int> same_;
    BakedRoom baked_;
    RoomModel model_;
    std::map<std::string, std::vector<int>> known_;
};

}  // namespace

RoomModel room_model(const Room& room, const BakeParams& params, const Run& run) {
    return Builder(room, params, run).model();
}

std::string texture_jpeg(const ImageRgb8& texture) { return encode_jpeg(texture, kTextureQuality); }

}  // namespace fastscene
