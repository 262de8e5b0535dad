#include "fastscene/export/room_usda.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/instances.h"
#include "fastscene/export/room_model.h"
#include "fastscene/io/usda.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene {
namespace {

constexpr int kPointDecimals = 5, kNormalDecimals = 3, kUvDecimals = 6;
constexpr float kLampRadius_m = 0.05f;   // of the sphere that a lamp's light comes from
constexpr float kSunAngle_deg = 0.53f;   // as wide as the sun is seen
constexpr float kApertureHeight = 24.f;  // of the camera, in tenths of a unit as USD has it; only ratios matter
constexpr float kApertureWidth = 36.f;
constexpr float kFarthestShown_m = 1000.f;  // that the camera shows

// "oak", "oak_2", "oak_3" …
std::string unique_name(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = usda_name(wanted);
    for (int k = 2; !taken.insert(name).second; ++k) name = usda_name(fmt::format("{}_{}", wanted, k));
    return name;
}

class UsdaRoomWriter {
  public:
    UsdaRoomWriter(const Room& room, const RoomModel& model, std::string texture_folder)
        : room_(room),
          model_(model),
          folder_(std::move(texture_folder)),
          instances_(instances_of(room)),
          shown_first_(model.meshes.size()),
          out_("Room", "A furnished room by fastscene. Metres; x left, y up, z forward.") {}

    UsdaRoom write() {
        out_.begin("def Xform", "Room",
                   {"kind = \"assembly\"", "customData = {", "    string room = " + usda_quoted(room_.type),
                    "    string style = " + usda_quoted(room_.style), "}"});
        for (const ModelNode& node : model_.nodes) add_node(node);
        add_lights();
        add_camera();
        add_materials();
        out_.end();
        return {out_.text(), std::move(textures_)};
    }

  private:
    // Names are unique among the children of the room.
    std::string child_name(const std::string& wanted) { return unique_name(wanted, taken_); }

    std::size_t number_of(const ModelNode& node) const {
        if (node.object >= 0) return at(node.object) + 1;
        std::size_t number = 0;
        while (instances_[number].id != node.id) ++number;
        return number;
    }

    std::vector<std::string> metadata_of(const ModelNode& node, const Instance& instance) const {
        std::vector<std::string> lines{
            "kind = \"component\"", "prepend apiSchemas = [\"SemanticsLabelsAPI:class\", \"SemanticsLabelsAPI:nyu40\"]",
            "customData = {", "    string id = " + usda_quoted(node.id),
            "    string class = " + usda_quoted(instance.kind)};
        if (node.object >= 0) {
            const RoomObject& object = room_.objects[at(node.object)];
            lines.push_back("    string label = " + usda_quoted(object.name));
            lines.push_back("    string color = " + usda_quoted(object.color));
            lines.push_back(fmt::format("    bool requested = {}", object.requested ? 1 : 0));
            lines.push_back("    string source = " + usda_quoted(object.source));
            lines.push_back("    float3 size_m = " + usda_tuple(object.size_m, kPointDecimals));
        }
        lines.emplace_back("}");
        return lines;
    }

    void add_node(const ModelNode& node) {
        const std::size_t number = number_of(node);
        const Instance& instance = instances_[number];
        const std::string name = child_name(node.id);
        out_.begin("def Xform", name, metadata_of(node, instance));
        for (const std::string& line : usda_pose(node.pose)) out_.line(line);
        out_.line(fmt::format("int primvars:instance = {}", number));
        out_.line("string primvars:class = " + usda_quoted(instance.kind));
        out_.line(fmt::format("token[] semantics:labels:class = [{}]", usda_quoted(instance.kind)));
        out_.line(
            fmt::format("token[] semantics:labels:nyu40 = [{}]", usda_quoted(nyu40_labels()[at(instance.nyu40)])));
        if (node.mesh >= 0) add_geometry(node.mesh, "/Room/" + name + "/geometry");
        if (node.lamp) add_lamp(*node.lamp);
        out_.end();
    }

    // The first thing with a mesh has it; things that look the same refer to that one.
    void add_geometry(int index, const std::string& path) {
        std::string& first = shown_first_[at(index)];
        if (!first.empty()) {
            out_.begin("def Xform", "geometry",
                       {"instanceable = true", fmt::format("prepend references = <{}>", first)});
            return out_.end();
        }
        first = path;
        out_.begin("def Xform", "geometry");
        std::set<std::string> names;
        for (const ModelPart& part : model_.meshes[at(index)].parts)
            add_mesh(unique_name(model_.materials[at(part.material)].name, names), part);
        out_.end();
    }

    void add_mesh(const std::string& name, const ModelPart& part) {
        out_.begin("def Mesh", name, {"prepend apiSchemas = [\"MaterialBindingAPI\"]"});
        Vec3f low = part.positions.at(0), high = low;
        for (const Vec3f p : part.positions)
            for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
        out_.line("uniform bool doubleSided = 1");
        out_.array("float3[] extent", usda_tuple(low, kPointDecimals) + ", " + usda_tuple(high, kPointDecimals));
        const std::vector<std::uint32_t> corners(part.triangles.size() / 3, 3);
        out_.array("int[] faceVertexCounts", usda_list(corners));
        out_.array("int[] faceVertexIndices", usda_list(part.triangles));
        out_.line(fmt::format("rel material:binding = </Room/Materials/{}>", material(part.material)));
        constexpr const char* kPerVertex = "interpolation = \"vertex\"";
        out_.array("normal3f[] normals", usda_list(std::span<const Vec3f>(part.normals), kNormalDecimals), kPerVertex);
        out_.array("point3f[] points", usda_list(std::span<const Vec3f>(part.positions), kPointDecimals));
        if (!part.uv.empty()) {
            std::vector<Vec2f> st;  // USD's origin is the picture's lower left corner
            for (const Vec2f uv : part.uv) st.push_back({uv.x, 1 - uv.y});
            out_.array("texCoord2f[] primvars:st", usda_list(std::span<const Vec2f>(st), kUvDecimals), kPerVertex);
        }
        out_.line("uniform token subdivisionScheme = \"none\"");
        out_.end();
    }

    // Named when first bound, defined at the end.
    const std::string& material(int index) {
        std::string& name = materials_[index];
        if (name.empty()) name = unique_name(model_.materials[at(index)].name, material_names_);
        return name;
    }

    void add_materials() {
        out_.begin("def Scope", "Materials");
        for (const auto& [index, name] : materials_) add_material(name, model_.materials[at(index)]);
        out_.end();
    }
    void add_material(const std::string& name, const ModelMaterial& surface) {
        const std::string path = "/Room/Materials/" + name;
        out_.begin("def Material", name);
        out_.line(fmt::format("token outputs:surface.connect = <{}/surface.outputs:surface>", path));
        out_.begin("def Shader", "surface");
        out_.line("uniform token info:id = \"UsdPreviewSurface\"");
        // What is lit already glows, and reflects nothing.
        const char* color = surface.unlit ? "emissiveColor" : "diffuseColor";
        if (surface.unlit) out_.line("color3f inputs:diffuseColor = (0, 0, 0)");
        if (surface.texture >= 0)
            out_.line(fmt::format("color3f inputs:{}.connect = <{}/texture.outputs:rgb>", color, path));
        else out_.line(fmt::format("color3f inputs:{} = {}", color, usda_tuple(surface.color)));
        out_.line(fmt::format("float inputs:metallic = {:.4g}", surface.metal));
        out_.line(fmt::format("float inputs:roughness = {:.4g}", surface.roughness));
        out_.line(fmt::format("float inputs:ior = {:.4g}", surface.ior));
        if (surface.opacity < 1) out_.line(fmt::format("float inputs:opacity = {:.4g}", surface.opacity));
        if (surface.shown >= 0)
            out_.line(fmt::format("color3f inputs:emissiveColor.connect = <{}/picture.outputs:rgb>", path));
        else if (max_component(surface.emission) > 0)
            out_.line("color3f inputs:emissiveColor = " + usda_tuple(surface.emission));
        out_.line("token outputs:surface");
        out_.end();
        if (surface.texture >= 0) add_texture(path, "texture", surface.texture);
        if (surface.shown >= 0) add_texture(path, "picture", surface.shown, surface.emission);
        if (surface.texture >= 0 || surface.shown >= 0) add_coordinates();
        out_.end();
    }
    // `scale`: factors of its colors, {} for none.
    void add_texture(const std::string& material_path, const char* role, int index, Vec3f scale = {}) {
        std::string& file = texture_files_[index];
        if (file.empty()) {
            file = material_path.substr(material_path.rfind('/') + 1) +
                   (scale == Vec3f{} ? std::string{} : fmt::format("_{}", role)) + ".jpg";
            textures_.push_back({file, texture_jpeg(model_.textures[at(index)])});
        }
        out_.begin("def Shader", role);
        out_.line("uniform token info:id = \"UsdUVTexture\"");
        out_.line(fmt::format("asset inputs:file = @./{}/{}@", folder_, file));
        out_.line("token inputs:sourceColorSpace = \"sRGB\"");
        out_.line(fmt::format("float2 inputs:st.connect = <{}/coordinates.outputs:result>", material_path));
        for (const char* wrap : {"wrapS", "wrapT"}) out_.line(fmt::format("token inputs:{} = \"clamp\"", wrap));
        if (!(scale == Vec3f{}))
            out_.line(fmt::format("float4 inputs:scale = ({:.6g}, {:.6g}, {:.6g}, 1)", scale.x, scale.y, scale.z));
        out_.line("float3 outputs:rgb");
        out_.end();
    }
    void add_coordinates() {
        out_.begin("def Shader", "coordinates");
        out_.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
        out_.line("string inputs:varname = \"st\"");
        out_.line("float2 outputs:result");
        out_.end();
    }

    // A sphere that radiates L on all sides has the intensity L times its cross section.
    void add_lamp(const ModelLight& lamp) {
        out_.begin("def SphereLight", "light");
        out_.line("color3f inputs:color = " + usda_tuple(lamp.color));
        out_.line(
            fmt::format("float inputs:intensity = {:.6g}", lamp.intensity / (kPi * kLampRadius_m * kLampRadius_m)));
        out_.line(fmt::format("float inputs:radius = {:.3g}", kLampRadius_m));
        out_.line("bool treatAsPoint = 1");
        for (const std::string& line : usda_pose({{}, lamp.position})) out_.line(line);
        out_.end();
    }
    // With `normalize` the intensity is what arrives on a surface that faces the sun, however wide the sun is.
    void add_lights() {
        if (model_.sun) {
            out_.begin("def DistantLight", child_name("sun"));
            out_.line(fmt::format("float inputs:angle = {:.3g}", kSunAngle_deg));
            out_.line("color3f inputs:color = " + usda_tuple(model_.sun->color));
            out_.line(fmt::format("float inputs:intensity = {:.6g}", model_.sun->intensity));
            out_.line("bool inputs:normalize = 1");
            for (const std::string& line : usda_pose(model_.sun_pose)) out_.line(line);
            out_.end();
        }
        const Vec3f sky = (room_.sky.zenith + room_.sky.horizon) * 0.5f;
        const float most = max_component(sky);
        if (!(most > 0) || model_.lit) return;
        out_.begin("def DomeLight", child_name("sky"));
        out_.line("color3f inputs:color = " + usda_tuple(sky / most));
        out_.line(fmt::format("float inputs:intensity = {:.6g}", most));
        out_.end();
    }
    // At panorama 0, looking to its middle; a camera looks along its -z.
    void add_camera() {
        out_.begin("def Camera", child_name("camera"));
        out_.line(fmt::format("float2 clippingRange = ({:.3g}, {:.5g})", kCameraNear_m, kFarthestShown_m));
        const float focal = 0.5f * kApertureHeight / std::tan(0.5f * kCameraFov_deg * kPi / 180);
        out_.line(fmt::format("float focalLength = {:.6g}", focal));
        out_.line(fmt::format("float horizontalAperture = {:.5g}", kApertureWidth));
        out_.line(fmt::format("float verticalAperture = {:.5g}", kApertureHeight));
        for (const std::string& line : usda_pose({Mat3f{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {}})) out_.line(line);
        out_.end();
    }

    const Room& room_;
    const RoomModel& model_;
    std::string folder_;
    std::vector<Instance> instances_;
    std::vector<std::string> shown_first_;  // by mesh: the path of the prim that has it
    std::set<std::string> taken_{"Materials"}, material_names_;
    std::map<int, std::string> materials_, texture_files_;
    std::vector<NamedBytes> textures_;
    UsdaWriter out_;
};

}  // namespace

UsdaRoom room_usda(const Room& room, const RoomModel& model, const std::string& texture_folder) {
    return UsdaRoomWriter(room, model, texture_folder).write();
}

UsdaRoom room_usda(const Room& room, const std::string& texture_folder, const BakeParams& params, const Run& run) {
    return room_usda(room, room_model(room, params, run), texture_folder);
}

}  // namespace fastscene
