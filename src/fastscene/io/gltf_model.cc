#include "fastscene/io/gltf_model.h"

#include <algorithm>
#include <array>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/gltf_document.h"
#include "fastscene/io/gltf_materials.h"
#include "fastscene/io/gltf_shape.h"

namespace fastscene {
namespace {

constexpr int kDeepestGltfNode = 100;

// What is read.
constexpr std::array kReadExtensions{"KHR_mesh_quantization",
                                     "KHR_texture_transform",
                                     "KHR_materials_pbrSpecularGlossiness",
                                     "KHR_materials_emissive_strength",
                                     "KHR_materials_ior",
                                     "KHR_materials_transmission",
                                     "KHR_materials_clearcoat",
                                     "KHR_materials_sheen",
                                     "KHR_materials_unlit",
                                     "EXT_meshopt_compression",
                                     "KHR_meshopt_compression",
                                     "EXT_texture_webp",
                                     "EXT_texture_avif"};
// What may be left out unnoticed: other forms of what the file has anyway, and what is not seen.
constexpr std::array kUnseenExtensions{
    "KHR_draco_mesh_compression", "KHR_texture_basisu", "MSFT_texture_dds", "MSFT_lod", "KHR_xmp", "KHR_xmp_json_ld",
    "KHR_animation_pointer"};

bool is_among(const auto& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

class ModelReader {
  public:
    ModelReader(GltfDocument& document, const GltfLimits& limits)
        : document_(document), limits_(limits), images_(document, limits, notes_) {}

    GltfModel read() {
        check_version();
        check_extensions();
        read_asset();
        place_meshes();
        count_triangles();
        note_motion();
        read_meshes();
        finish();
        return std::move(model_);
    }

  private:
    struct Placed {
        const Json* mesh;
        GltfJson::Transform world_from_node;
    };
    struct Group {
        GltfSurface surface;
        GltfGroup group;
        std::optional<GltfColor> color;  // that its vertices have
        bool colors_differ = false, some_without_uvs = false, uvs_beyond = false;
    };
    using MaterialIndex = std::optional<std::size_t>;  // nothing: the default material

    void check_version() const {
        const Json* asset = GltfJson::object(document_.root(), "asset");
        const std::string version = asset ? GltfJson::text(*asset, "version") : "";
        if (!version.starts_with("2."))
            document_.refuse(
                fmt::format("expected glTF 2.0, found {}", version.empty() ? "no version" : GltfJson::brief(version)));
    }

    void check_extensions() {
        for (const Json& name : GltfJson::list(document_.root(), "extensionsRequired"))
            if (name.is_string() && !is_among(kReadExtensions, name.get<std::string>())) refuse_extension(name);
        for (const Json& name : GltfJson::list(document_.root(), "extensionsUsed"))
            if (name.is_string() && !is_among(kReadExtensions, name.get<std::string>()) &&
                !is_among(kUnseenExtensions, name.get<std::string>()))
                notes_.add(fmt::format("What {} adds is left out.", GltfJson::brief(name.get<std::string>())));
    }
    [[noreturn]] void refuse_extension(const std::string& name) const {
        const char* advice = name == "KHR_draco_mesh_compression" ? ": save it without Draco compression"
                             : name == "KHR_texture_basisu"       ? ": save it with PNG or JPEG textures"
                                                                  : "";
        document_.refuse(fmt::format("expected a model that can be read without {0}, found that it requires {0}{1}",
                                     GltfJson::brief(name), advice));
    }

    void read_asset() {
        const Json& asset = *GltfJson::object(document_.root(), "asset");
        model_.generator = GltfJson::text(asset, "generator");
        model_.copyright = GltfJson::text(asset, "copyright");
        const Json* extras = GltfJson::object(asset, "extras");
        if (!extras) return;
        model_.author = GltfJson::text(*extras, "author"), model_.license = GltfJson::text(*extras, "license");
        model_.source = GltfJson::text(*extras, "source"), model_.title = GltfJson::text(*extras, "title");
    }

    // The default scene's nodes, or all without a parent, or, without nodes, all meshes.
    void place_meshes() {
        const Json& nodes = GltfJson::list(document_.root(), "nodes");
        seen_.assign(nodes.size(), Seen::not_yet);
        std::vector<std::size_t> roots;
        const Json& scenes = GltfJson::list(document_.root(), "scenes");
        if (const std::size_t scene = document_.whole(document_.root(), "scene", 0); scene < scenes.size()) {
            roots = children(scenes[scene], "nodes");
        } else {
            std::vector<bool> is_child(nodes.size());
            for (const Json& node : nodes)
                for (const std::size_t child : children(node, "children"))
                    if (child < nodes.size()) is_child[child] = true;
            for (std::size_t i = 0; i < nodes.size(); ++i)
                if (!is_child[i]) roots.push_back(i);
        }
        for (const std::size_t root : roots) visit(root, {}, 0);
        if (nodes.empty())
            for (std::size_t i = 0; i < GltfJson::list(document_.root(), "meshes").size(); ++i)
                placed_.push_back({&document_.item("meshes", i), {}});
    }
    std::vector<std::size_t> children(const Json& owner, const char* name) const {
        std::vector<std::size_t> out;
        for (const Json& child : GltfJson::list(owner, name)) {
            if (!child.is_number_unsigned())
                document_.refuse(
                    fmt::format("expected numbers of nodes in \"{}\", found {}", name, GltfJson::brief(child.dump())));
            out.push_back(child.get<std::size_t>());
        }
        return out;
    }
    void visit(std::size_t index, const GltfJson::Transform& world_from_parent, int depth) {
        const Json& node = document_.item("nodes", index);
        if (depth > kDeepestGltfNode)
            document_.refuse(fmt::format("expected nodes at most {} deep, found more", kDeepestGltfNode));
        if (seen_[index] == Seen::above)
            document_.refuse(fmt::format("expected a tree of nodes, found that nodes[{}] is its own ancestor", index));
        if (seen_[index] == Seen::done)
            document_.refuse(fmt::format("expected a tree of nodes, found nodes[{}] twice", index));
        seen_[index] = Seen::above;
        const auto [linear, move] = document_.transform_of(node);
        const GltfJson::Transform world_from_node{world_from_parent.linear * linear,
                                                  world_from_parent.linear * move + world_from_parent.move};
        if (node.contains("mesh"))
            placed_.push_back({&document_.item("meshes", document_.whole(node, "mesh")), world_from_node});
        if (node.contains("skin")) notes_.add("Skins are left out: meshes stand as they were modelled.");
        for (const std::size_t child : children(node, "children")) visit(child, world_from_node, depth + 1);
        seen_[index] = Seen::done;
    }

    // By the accessors' counts, before any is read.
    void count_triangles() {
        std::map<const Json*, std::size_t> in_mesh;
        std::size_t triangles = 0, work = 0;
        for (const Placed& placed : placed_) {
            const auto [known, is_new] = in_mesh.try_emplace(placed.mesh, 0);
            const Json& primitives = GltfJson::list(*placed.mesh, "primitives");
            if (is_new)
                for (const Json& primitive : primitives)
                    if (check(primitive))
                        known->second += std::min(gltf_triangle_count(document_, primitive), limits_.triangles + 1);
            triangles += known->second;
            work += primitives.size();
            if (std::max(triangles, work) > limits_.triangles)
                document_.refuse(fmt::format("expected at most {} triangles, found more", limits_.triangles));
        }
        if (triangles == 0) document_.refuse("expected triangles, found none");
    }
    // Whether it has triangles that can be read.
    bool check(const Json& primitive) {
        if (!has_gltf_triangles(document_, primitive)) {
            notes_.add("Points and lines are left out.");
            return false;
        }
        const Json* attributes = GltfJson::object(primitive, "attributes");
        if (!attributes || !attributes->contains("POSITION")) return false;
        // Compressed data may stand beside plain ones, or instead of them.
        const Json& positions = document_.item("accessors", document_.whole(*attributes, "POSITION"));
        if (GltfJson::extension(primitive, "KHR_draco_mesh_compression") && !positions.contains("bufferView"))
            refuse_extension("KHR_draco_mesh_compression");
        if (!GltfJson::list(primitive, "targets").empty()) notes_.add("Morph targets are left out.");
        return true;
    }
    void note_motion() {
        if (!GltfJson::list(document_.root(), "animations").empty())
            notes_.add("Animations are left out: the model is in its rest pose.");
    }

    Group& group_of(const Json& primitive) {
        MaterialIndex index;
        if (primitive.contains("material")) index = document_.whole(primitive, "material");
        const auto found = groups_.find(index);
        if (found != groups_.end()) return found->second;
        Group& made = groups_[index];
        made.surface = gltf_surface(document_, index, notes_);
        return made;
    }

    void read_meshes() {
        for (const Placed& placed : placed_)
            for (const Json& primitive : GltfJson::list(*placed.mesh, "primitives")) {
                if (!check(primitive)) continue;
                Group& group = group_of(primitive);
                GltfShape shape = gltf_shape(document_, primitive, placed.world_from_node, group.surface.uv);
                if (!shape.triangles.empty()) append(group, shape);
            }
    }

    void append(Group& to, const GltfShape& shape) {
        GltfGroup& group = to.group;
        const std::size_t first = group.positions.size();
        for (const std::uint32_t i : shape.triangles) group.triangles.push_back(static_cast<std::uint32_t>(first) + i);
        group.positions.insert(group.positions.end(), shape.positions.begin(), shape.positions.end());
        group.normals.insert(group.normals.end(), shape.normals.begin(), shape.normals.end());
        if (!shape.uvs.empty()) {
            group.uvs.resize(first);
            group.uvs.insert(group.uvs.end(), shape.uvs.begin(), shape.uvs.end());
        } else if (!group.uvs.empty()) {
            group.uvs.resize(group.positions.size());
        }
        to.some_without_uvs = to.some_without_uvs || shape.uvs.empty();
        to.uvs_beyond = to.uvs_beyond || shape.uvs_beyond;
        to.colors_differ = to.colors_differ || shape.has_colors || (to.color && *to.color != shape.color);
        to.color = shape.color;
        turned_ += shape.turned;
        if (shape.odd_uvs) notes_.add("Texture coordinates that are no numbers, or huge, are set to 0.");
    }

    void finish() {
        for (auto& [index, made] : groups_) {
            if (made.group.triangles.empty()) continue;
            const std::string name = GltfJson::brief(made.surface.material.name);
            if (made.some_without_uvs && made.surface.has_textures())
                notes_.add(fmt::format(
                    "Material \"{}\" has pictures, but not all its triangles have texture coordinates.", name));
            if (made.uvs_beyond && !made.surface.repeats)
                notes_.add(
                    fmt::format("Material \"{}\": its picture is repeated where it should be mirrored or end.", name));
            GltfMaterial material = images_.with_images(made.surface);
            if (made.colors_differ) {
                notes_.add(fmt::format("Material \"{}\": colors of vertices are left out.", name));
            } else {
                const GltfColor& c = *made.color;
                material.base_color = material.base_color * Vec3f{c[0], c[1], c[2]};
                if (material.alpha_mode != GltfAlpha::opaque) material.alpha *= c[3];
            }
            made.group.material = model_.materials.size();
            model_.triangle_count += made.group.triangles.size() / 3;
            model_.materials.push_back(std::move(material));
            model_.groups.push_back(std::move(made.group));
        }
        if (model_.groups.empty()) document_.refuse("expected triangles with an area, found none");
        if (turned_ > 0)
            notes_.add(fmt::format("Triangles that faced away from their normals are turned around: {}.", turned_));
        model_.images = images_.take();
        model_.notes = notes_.take();
    }

    enum class Seen : char { not_yet, above, done };
    GltfDocument& document_;
    const GltfLimits& limits_;
    GltfNotes notes_;
    GltfImages images_;
    GltfModel model_;
    std::vector<Seen> seen_;  // per node
    std::vector<Placed> placed_;
    std::map<MaterialIndex, Group> groups_;
    std::size_t turned_ = 0;
};

}  // namespace

GltfModel read_gltf_bytes(std::string_view bytes, const std::string& where,
                          const std::function<std::optional<std::string>(const std::string& name)>& read_sibling,
                          const GltfLimits& limits) {
    GltfDocument document(where, bytes, read_sibling);
    return ModelReader(document, limits).read();
}

GltfModel read_gltf(const std::filesystem::path& file, const GltfLimits& limits) {
    const std::string bytes = read_file(file);
    const auto read_sibling = [&](const std::string& name) -> std::optional<std::string> {
        const std::filesystem::path path = file.parent_path() / name;
        std::error_code error;
        if (!std::filesystem::is_regular_file(path, error)) return {};
        return read_file(path);
    };
    return read_gltf_bytes(bytes, file.string(), read_sibling, limits);
}

}  // namespace fastscene
