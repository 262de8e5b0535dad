#include "fastscene/export/room_glb.h"

#include <map>

#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/room_model.h"

namespace fastscene {
namespace {

constexpr const char* kLightsExtension = "KHR_lights_punctual";

class Writer {
  public:
    Writer(const Room& room, const RoomModel& model) : room_(room), model_(model), meshes_(model.meshes.size(), -1) {}

    std::string bytes() {
        Json roots = Json::array();
        for (const ModelNode& node : model_.nodes) roots.push_back(add_node(node));
        if (model_.sun) add_sun(roots);
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
    int add_node(const ModelNode& of) {
        Json node{{"name", of.id}};
        set_pose(node, of.pose);
        if (of.mesh >= 0) node["mesh"] = mesh(of.mesh);
        if (of.lamp) node["children"] = {add_lamp(*of.lamp, of.id)};
        if (of.object < 0) {
            node["extras"] = {{"id", of.id}, {"class", of.id}, {"shell", true}};
        } else {
            const RoomObject& object = room_.objects[at(of.object)];
            node["extras"] = {{"id", of.id},
                              {"class", object.kind},
                              {"label", object.name},
                              {"color", object.color},
                              {"requested", object.requested},
                              {"source", object.source},
                              {"size_m", json_list(object.size_m)}};
        }
        return gltf_.add("nodes", std::move(node));
    }

    // Added where first used; so are materials.
    int mesh(int index) {
        int& known = meshes_[at(index)];
        if (known < 0) known = add_mesh(model_.meshes[at(index)]);
        return known;
    }
    int add_mesh(const ModelMesh& mesh) {
        Json primitives = Json::array();
        for (const ModelPart& part : mesh.parts) {
            Json attributes{{"POSITION", gltf_.add_positions(part.positions)},
                            {"NORMAL", gltf_.add_vectors(part.normals)}};
            if (!part.uv.empty()) attributes["TEXCOORD_0"] = gltf_.add_uv(part.uv);
            primitives.push_back({{"attributes", attributes},
                                  {"indices", gltf_.add_indices(part.triangles)},
                                  {"material", material(part.material)}});
        }
        return gltf_.add("meshes", {{"name", mesh.name}, {"primitives", primitives}});
    }
    int material(int index) {
        const auto found = materials_.find(index);
        if (found != materials_.end()) return found->second;
        return materials_[index] = gltf_.add("materials", describe(model_.materials[at(index)]));
    }

    Json describe(const ModelMaterial& of) {
        Json surface{{"baseColorFactor", {of.color.x, of.color.y, of.color.z, of.opacity}},
                     {"metallicFactor", of.metal},
                     {"roughnessFactor", of.roughness}};
        if (of.texture >= 0) surface["baseColorTexture"] = {{"index", texture(of.texture, of.name)}};
        Json out{{"name", of.name}, {"pbrMetallicRoughness", surface}, {"doubleSided", true}};
        if (of.opacity < 1) out["alphaMode"] = "BLEND";
        if (of.unlit) {
            gltf_.use("KHR_materials_unlit");
            out["extensions"]["KHR_materials_unlit"] = Json::object();
        }
        if (of.ior != kUsualIor) {
            gltf_.use("KHR_materials_ior");
            out["extensions"]["KHR_materials_ior"]["ior"] = of.ior;
        }
        if (const float most = max_component(of.emission); most > 0) {
            out["emissiveFactor"] = json_list(of.emission / most);
            if (of.shown >= 0) out["emissiveTexture"] = {{"index", texture(of.shown, of.name + " picture")}};
            gltf_.use("KHR_materials_emissive_strength");
            out["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = most;
        }
        return out;
    }
    // Its image has the name of the first material that shows it: importers list images by name.
    int texture(int index, const std::string& name) {
        const auto found = textures_.find(index);
        if (found != textures_.end()) return found->second;
        const std::string jpeg = texture_jpeg(model_.textures[at(index)]);
        return textures_[index] = gltf_.add("textures", {{"source", gltf_.add_image(jpeg, "image/jpeg", name)}});
    }

    Json light_node(const std::string& name, const char* type, const std::string& light_name, const ModelLight& light) {
        lights_.push_back(
            {{"type", type}, {"name", light_name}, {"color", json_list(light.color)}, {"intensity", light.intensity}});
        return {{"name", name}, {"extensions", {{kLightsExtension, {{"light", lights_.size() - 1}}}}}};
    }
    int add_lamp(const ModelLight& lamp, const std::string& id) {
        Json node = light_node(id + " light", "point", id, lamp);
        node["translation"] = json_list(lamp.position);
        return gltf_.add("nodes", std::move(node));
    }
    void add_sun(Json& roots) {
        Json node = light_node("sun", "directional", "sun", *model_.sun);
        set_pose(node, model_.sun_pose);
        roots.push_back(gltf_.add("nodes", std::move(node)));
    }
    // At panorama 0, looking to its middle.
    void add_camera(Json& roots) {
        const int camera = gltf_.add(
            "cameras", {{"name", "panorama"},
                        {"type", "perspective"},
                        {"perspective", {{"yfov", kCameraFov_deg * kPi / 180}, {"znear", kCameraNear_m}}}});
        // A camera looks along its -z.
        roots.push_back(
            gltf_.add("nodes", {{"name", "camera"}, {"camera", camera}, {"rotation", {0.f, 1.f, 0.f, 0.f}}}));
    }

    const Room& room_;
    const RoomModel& model_;
    Gltf gltf_;
    Json lights_ = Json::array();
    std::vector<int> meshes_;
    std::map<int, int> materials_, textures_;
};

}  // namespace

std::string room_glb_bytes(const Room& room, const RoomModel& model) { return Writer(room, model).bytes(); }

std::string room_glb_bytes(const Room& room, const BakeParams& params, const Run& run) {
    return room_glb_bytes(room, room_model(room, params, run));
}

}  // namespace fastscene
