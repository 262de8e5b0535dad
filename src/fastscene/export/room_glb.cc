#include "fastscene/export/room_glb.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/shell.h"
#include "fastscene/io/image_io.h"
#include "fastscene/trace/response.h"

namespace fastscene {
namespace {

constexpr int kTextureQuality = 85;      // of JPEG: grain of plaster and fabric is not worth more bytes
constexpr float kClearAlpha = 0.2f;      // opacity of panes and drinking glasses
constexpr float kUsualSpecular = 0.04f;  // glTF's own reflectance of a dielectric
constexpr float kCameraFov_deg = 60;     // vertical: as an engine's usual camera
// Meshes whose vertices differ by less than rounding are one.
constexpr float kSamePlace_m = 2e-4f, kSameUv = 1e-5f;
constexpr const char* kLightsExtension = "KHR_lights_punctual";

// Triangles with one material.
struct Part {
    int material = 0;
    std::vector<Vec3f> positions, normals;
    std::vector<Vec2f> uv;
    std::vector<std::uint32_t> triangles;
};
using Parts = std::vector<Part>;

// Appends a mesh to the part with its material.
void append(Parts& parts, int material, const Mesh& mesh, const BakedMesh& baked, const Rigid& node_from_world) {
    if (baked.triangles.empty()) return;
    auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.material == material; });
    if (part == parts.end()) part = parts.insert(parts.end(), Part{material, {}, {}, {}, {}});
    const auto first = static_cast<std::uint32_t>(part->positions.size());
    for (const std::uint32_t v : baked.vertices) {
        part->positions.push_back(node_from_world * mesh.positions[v]);
        const Vec3f normal = normalize(node_from_world.rotation * mesh.normals[v]);
        part->normals.push_back(normal == Vec3f{} ? Vec3f{0, 1, 0} : normal);
    }
    part->uv.insert(part->uv.end(), baked.uv.begin(), baked.uv.end());
    for (const std::uint32_t v : baked.triangles) part->triangles.push_back(first + v);
}

bool same(const Part& a, const Part& b) {
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
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same(a[i], b[i])) return false;
    return true;
}

class Writer {
  public:
    Writer(const Room& room, const BakeParams& params, const Run& run)
        : room_(room),
          same_(same_materials(room.materials)),
          baked_(bake(room, same_, params, run)),
          ids_(object_ids(room)) {}

    std::string bytes() {
        Json roots = Json::array();
        add_shell(roots);
        for (std::size_t i = 0; i < room_.objects.size(); ++i) roots.push_back(add_object(i));
        add_sun(roots);
        add_camera(roots);
        if (!lights_.empty()) {
            gltf_.use(kLightsExtension);
            gltf_["extensions"][kLightsExtension]["lights"] = lights_;
        }
        const Sky& sky = room_.sky;
        return gltf_.bytes({{"name", room_.type},
                            {"nodes", roots},
                            {"extras",
                             {{"room", room_.type},
                              {"style", room_.style},
                              {"sky", {{"zenith", json_list(sky.zenith)}, {"horizon", json_list(sky.horizon)}}}}}});
    }

  private:
    void add_shell(Json& roots) {
        std::map<Shell, Parts> shell;
        const Rigid gltf_from_world{kGltfAxes, {}};
        for (std::size_t m = 0; m < room_.meshes.size(); ++m)
            if (const Mesh& mesh = room_.meshes[m]; mesh.object < 0)
                append(shell[shell_of(room_, mesh)], same_[at(mesh.material)], mesh, baked_.meshes[m], gltf_from_world);
        for (const auto& [kind, parts] : shell) {
            if (parts.empty()) continue;
            const char* name = kShellNames[static_cast<std::size_t>(kind)];
            roots.push_back(gltf_.add("nodes", {{"name", name},
                                                {"mesh", add_mesh(parts, name)},
                                                {"extras", {{"id", name}, {"class", name}, {"shell", true}}}}));
        }
    }

    int add_object(std::size_t index) {
        const RoomObject& object = room_.objects[index];
        const Rigid node_from_world = inverse(object.world_from_object);
        Parts parts;
        for (std::size_t m = 0; m < room_.meshes.size(); ++m)
            if (const Mesh& mesh = room_.meshes[m]; mesh.object == static_cast<int>(index))
                append(parts, same_[at(mesh.material)], mesh, baked_.meshes[m], node_from_world);
        Json node{{"name", ids_[index]}};
        set_pose(node, Rigid{kGltfAxes, {}} * object.world_from_object);
        if (!parts.empty()) node["mesh"] = mesh_like(parts, object.kind);
        if (const auto light = add_lamp(parts, ids_[index])) node["children"] = {*light};
        node["extras"] = {{"id", ids_[index]},
                          {"class", object.kind},
                          {"label", object.name},
                          {"color", object.color},
                          {"requested", object.requested},
                          {"source", object.source},
                          {"size_m", json_list(object.size_m)}};
        return gltf_.add("nodes", std::move(node));
    }

    // Equal things share one mesh.
    int mesh_like(const Parts& parts, const std::string& name) {
        for (const auto& [known, mesh] : known_[name])
            if (same(known, parts)) return mesh;
        const int mesh = add_mesh(parts, name);
        known_[name].push_back({parts, mesh});
        return mesh;
    }

    int add_mesh(const Parts& parts, const std::string& name) {
        Json primitives = Json::array();
        for (const Part& part : parts) {
            Json attributes{{"POSITION", gltf_.add_positions(part.positions)},
                            {"NORMAL", gltf_.add_vectors(part.normals)}};
            if (!part.uv.empty()) attributes["TEXCOORD_0"] = gltf_.add_uv(part.uv);
            primitives.push_back({{"attributes", attributes},
                                  {"indices", gltf_.add_indices(part.triangles)},
                                  {"material", material(part.material)}});
        }
        return gltf_.add("meshes", {{"name", name}, {"primitives", primitives}});
    }

    // Added where first used.
    int material(int index) {
        const auto found = materials_.find(index);
        if (found != materials_.end()) return found->second;
        return materials_[index] = gltf_.add("materials",
                                             describe(room_.materials[at(index)], baked_.materials[at(index)]));
    }

    Json describe(const Material& m, const BakedMaterial& baked) {
        const bool mirror = m.mirror > 0.5f;
        const Vec3f color = baked.texture.empty() ? baked.color : Vec3f{1, 1, 1};
        const auto share = [](float v) { return std::clamp(v, 0.f, 1.f); };
        Json surface{{"baseColorFactor", {share(color.x), share(color.y), share(color.z), 1.f}},
                     {"metallicFactor", mirror ? 1.f : share(m.metal)},
                     {"roughnessFactor", mirror ? 0.f : share(baked.roughness)}};
        if (!baked.texture.empty()) surface["baseColorTexture"] = {{"index", texture(baked.texture)}};
        Json out{{"name", m.name}, {"pbrMetallicRoughness", surface}, {"doubleSided", true}};
        if (is_clear(m)) {
            out["alphaMode"] = "BLEND";
            out["pbrMetallicRoughness"]["baseColorFactor"][3] = kClearAlpha;
        }
        if (!mirror && m.metal < 1 && std::fabs(m.specular - kUsualSpecular) > 0.005f) {
            gltf_.use("KHR_materials_ior");
            const float r = std::sqrt(std::clamp(m.specular, 0.f, 0.9f));
            out["extensions"]["KHR_materials_ior"]["ior"] = (1 + r) / (1 - r);
        }
        if (const float most = max_component(m.emission); most > 0) {
            out["emissiveFactor"] = json_list(m.emission / most);
            gltf_.use("KHR_materials_emissive_strength");
            out["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = most;
        }
        return out;
    }

    int texture(const ImageRgb8& image) {
        return gltf_.add("textures", {{"source", gltf_.add_image(encode_jpeg(image, kTextureQuality), "image/jpeg")}});
    }

    int add_light(Json light) {
        lights_.push_back(std::move(light));
        return static_cast<int>(lights_.size()) - 1;
    }
    Json light_node(const std::string& name, int light) {
        return {{"name", name}, {"extensions", {{kLightsExtension, {{"light", light}}}}}};
    }

    // A point light amid the glowing surfaces of a thing, with the intensity that they have on average over all
    // directions: radiance times a quarter of their area.
    std::optional<int> add_lamp(const Parts& parts, const std::string& name) {
        Vec3f intensity{}, center{};
        float weight = 0;
        for (const Part& part : parts) {
            const Material& m = room_.materials[at(part.material)];
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
        const float most = max_component(intensity);
        if (!(most > 0) || !(weight > 0)) return std::nullopt;
        Json node = light_node(
            name + " light",
            add_light(
                {{"type", "point"}, {"name", name}, {"color", json_list(intensity / most)}, {"intensity", most}}));
        node["translation"] = json_list(center / weight);
        return gltf_.add("nodes", std::move(node));
    }

    void add_sun(Json& roots) {
        const float most = max_component(room_.sky.sun_irradiance);
        if (!(most > 0)) return;
        Json node = light_node("sun", add_light({{"type", "directional"},
                                                 {"name", "sun"},
                                                 {"color", json_list(room_.sky.sun_irradiance / most)},
                                                 {"intensity", most}}));
        // It shines along the node's -z.
        const Vec3f back = normalize(kGltfAxes * room_.sky.sun_dir);
        Vec3f right, up;
        make_frame(back, right, up);
        set_pose(node, {Mat3f::from_columns(right, up, back), {}});
        roots.push_back(gltf_.add("nodes", std::move(node)));
    }

    // At panorama 0, looking to its middle.
    void add_camera(Json& roots) {
        const int camera = gltf_.add("cameras",
                                     {{"name", "panorama"},
                                      {"type", "perspective"},
                                      {"perspective", {{"yfov", kCameraFov_deg * kPi / 180}, {"znear", 0.05f}}}});
        // A camera looks along its -z.
        roots.push_back(
            gltf_.add("nodes", {{"name", "camera"}, {"camera", camera}, {"rotation", {0.f, 1.f, 0.f, 0.f}}}));
    }

    const Room& room_;
    std::vector<int> same_;
    BakedRoom baked_;
    std::vector<std::string> ids_;
    Gltf gltf_;
    Json lights_ = Json::array();
    std::map<int, int> materials_;
    std::map<std::string, std::vector<std::pair<Parts, int>>> known_;
};

}  // namespace

std::string room_glb_bytes(const Room& room, const BakeParams& params, const Run& run) {
    return Writer(room, params, run).bytes();
}

}  // namespace fastscene
