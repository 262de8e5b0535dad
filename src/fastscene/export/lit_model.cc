// The room with its light in its textures.
#include <algorithm>
#include <array>
#include <map>

#include "fastscene/export/charts.h"
#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/room_model.h"
#include "fastscene/export/shell.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/trace/response.h"

namespace fastscene {
namespace {

constexpr int kLightSamples = 2;     // rays a texel: only the edges of shadows need several
constexpr Rgb8 kUnseen{90, 88, 85};  // between the pieces; shows only in far mip levels

// One picture: of the shell, or of the things.
struct LitGroup {
    std::vector<int> meshes;
    ChartAtlas atlas;
    std::map<int, std::vector<std::size_t>> charts_of;  // by mesh
};

LitGroup group_of(const Room& room, bool shell, const BakeParams& params) {
    LitGroup group;
    for (std::size_t m = 0; m < room.meshes.size(); ++m)
        if (const Mesh& mesh = room.meshes[m];
            (mesh.object < 0) == shell && !mesh.triangles.empty() && !is_clear(room.materials[at(mesh.material)]))
            group.meshes.push_back(static_cast<int>(m));
    group.atlas = chart_atlas(room, group.meshes, params);
    for (std::size_t c = 0; c < group.atlas.charts.size(); ++c)
        group.charts_of[group.atlas.charts[c].mesh].push_back(c);
    return group;
}

ImageRgb8 light_picture(const TracedRoom& room, const ChartAtlas& atlas, const Run& run) {
    ImageRgb8 out(atlas.width, atlas.height, kUnseen);
    std::vector<ChartTexel> texels;
    for (const Chart& chart : atlas.charts) {
        const std::vector<ChartTexel> own = texels_of(room.room(), atlas, chart);
        texels.insert(texels.end(), own.begin(), own.end());
    }
    std::vector<TracedRoom::FacedPoint> points;
    for (const ChartTexel& t : texels) points.push_back({t.position, t.normal, 1 / atlas.texels_per_metre});
    const std::vector<Vec3f> colors = room.colors_faced(points, kLightSamples, run);
    for (std::size_t i = 0; i < texels.size(); ++i) out.at(texels[i].x, texels[i].y) = srgb8_from_linear(colors[i]);
    return out;
}

class LitBuilder {
  public:
    LitBuilder(const TracedRoom& room, const BakeParams& params, const Run& run) : room_(room.room()) {
        model_.lit = true;
        for (const bool shell : {true, false}) {
            const LitGroup& group = groups_.emplace_back(group_of(room_, shell, params));
            model_.materials.push_back({shell ? "walls, floor and ceiling, lit" : "things, lit",
                                        {1, 1, 1},
                                        static_cast<int>(model_.textures.size())});
            model_.materials.back().unlit = true;
            model_.textures.push_back(light_picture(room, group.atlas, run));
            run.note(fmt::format("{}: {} x {} pixels, {:.0f} per metre", model_.materials.back().name,
                                 group.atlas.width, group.atlas.height, group.atlas.texels_per_metre));
        }
    }
    RoomModel model() {
        const std::vector<std::string> ids = object_ids(room_);
        for (const Shell kind : {Shell::floor, Shell::ceiling, Shell::walls})
            add_node(kShellNames[static_cast<std::size_t>(kind)], -1, {},
                     [&](const Mesh& mesh) { return mesh.object < 0 && shell_of(room_, mesh) == kind; });
        for (std::size_t i = 0; i < ids.size(); ++i)
            add_node(ids[i], static_cast<int>(i), room_.objects[i].world_from_object,
                     [&](const Mesh& mesh) { return mesh.object == static_cast<int>(i); });
        return std::move(model_);
    }
    // What is seen through the windows: a sphere far outside, seen from within.
    void add_outside(const TracedRoom& room) {
        constexpr EquirectSize kPicture{2048, 1024};
        constexpr float kRadius_m = 60;  // of the sphere; views of engines reach that far
        constexpr int kColumns = 48, kRows = 24;
        ModelPart part{static_cast<int>(model_.materials.size()), {}, {}, {}, {}};
        model_.materials.push_back({"outside", {1, 1, 1}, static_cast<int>(model_.textures.size())});
        model_.materials.back().unlit = true;
        model_.textures.push_back(srgb8_from_linear(room.outside({}, kPicture)));
        for (int j = 0; j <= kRows; ++j)
            for (int i = 0; i <= kColumns; ++i) {
                const Vec2f uv{static_cast<float>(i) / kColumns, static_cast<float>(j) / kRows};
                const Vec3f out = kGltfAxes *
                                  direction_at(Vec2f{uv.x * kPicture.width, uv.y * kPicture.height}, kPicture);
                part.positions.push_back(out * kRadius_m);
                part.normals.push_back(-out);
                part.uv.push_back(uv);
                if (i == kColumns || j == kRows) continue;
                const auto a = static_cast<std::uint32_t>(j * (kColumns + 1) + i), b = a + kColumns + 1;
                for (const std::uint32_t v : {a, b, a + 1, b, b + 1, a + 1}) part.triangles.push_back(v);
            }
        model_.nodes.push_back({"outside", -1, {}, static_cast<int>(model_.meshes.size()), std::nullopt});
        model_.meshes.push_back({"outside", {std::move(part)}});
    }

  private:
    void add_node(const std::string& id, int object, const Rigid& world_from_node, const auto& is_wanted) {
        // The shell's axes are the file's.
        const Rigid node_from_world = object < 0 ? Rigid{kGltfAxes, {}} : inverse(world_from_node);
        ModelMesh mesh{id, {}};
        for (std::size_t m = 0; m < room_.meshes.size(); ++m) {
            const Mesh& of = room_.meshes[m];
            if (!is_wanted(of) || of.triangles.empty()) continue;
            const LitGroup& group = groups_[object < 0 ? 0 : 1];
            const auto charts = group.charts_of.find(static_cast<int>(m));
            if (charts != group.charts_of.end())
                append_lit(mesh, object < 0 ? 0 : 1, of, mapped(of, group.atlas, charts->second), node_from_world);
            else append_lit(mesh, glass(of.material), of, plain(of), node_from_world);
        }
        ModelNode node{id, object, Rigid{kGltfAxes, {}} * inverse(node_from_world), -1, std::nullopt};
        if (!mesh.parts.empty()) {
            node.mesh = static_cast<int>(model_.meshes.size());
            model_.meshes.push_back(std::move(mesh));
        } else if (object < 0) {
            return;
        }
        model_.nodes.push_back(std::move(node));
    }
    static BakedMesh plain(const Mesh& mesh) {
        BakedMesh out;
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) out.vertices.push_back(v);
        out.triangles = mesh.triangles;
        return out;
    }
    static void append_lit(ModelMesh& to, int material, const Mesh& mesh, const BakedMesh& baked,
                           const Rigid& node_from_world) {
        auto part = std::find_if(to.parts.begin(), to.parts.end(),
                                 [&](const ModelPart& p) { return p.material == material; });
        if (part == to.parts.end()) part = to.parts.insert(to.parts.end(), ModelPart{material, {}, {}, {}, {}});
        const auto first = static_cast<std::uint32_t>(part->positions.size());
        for (const std::uint32_t v : baked.vertices) {
            part->positions.push_back(node_from_world * mesh.positions[v]);
            const Vec3f normal = normalize(node_from_world.rotation * mesh.normals[v]);
            part->normals.push_back(normal == Vec3f{} ? Vec3f{0, 1, 0} : normal);
        }
        part->uv.insert(part->uv.end(), baked.uv.begin(), baked.uv.end());
        for (const std::uint32_t v : baked.triangles) part->triangles.push_back(first + v);
    }
    // Clear glass has no texels: what is behind it is seen through it.
    int glass(int material) {
        const auto found = glass_.find(material);
        if (found != glass_.end()) return found->second;
        const Material& m = room_.materials[at(material)];
        ModelMaterial out{m.name, m.color_a};
        for (std::size_t a = 0; a < 3; ++a) out.color[a] = std::clamp(out.color[a], 0.f, 1.f);
        out.opacity = kClearOpacity;
        out.unlit = true;
        model_.materials.push_back(out);
        return glass_[material] = static_cast<int>(model_.materials.size()) - 1;
    }

    const Room& room_;
    std::vector<LitGroup> groups_;
    RoomModel model_;
    std::map<int, int> glass_;
};

}  // namespace

RoomModel lit_room_model(const TracedRoom& room, const BakeParams& params, const Run& run) {
    LitBuilder builder(room, params, run);
    builder.add_outside(room);
    return builder.model();
}

}  // namespace fastscene
