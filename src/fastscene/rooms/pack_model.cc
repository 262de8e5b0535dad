// A model of the pack as a Piece: axes, size, materials.
#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/obj.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/model_materials.h"
#include "fastscene/rooms/pack_parts.h"
#include "fastscene/rooms/user_model.h"

namespace fastscene {
namespace {

// "Some folder/texture%20a.jpg" beside the model.
std::string sibling(const std::string& path, std::string name) {
    for (auto at = name.find("%20"); at != std::string::npos; at = name.find("%20")) name.replace(at, 3, " ");
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.starts_with("./")) name.erase(0, 2);
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? name : path.substr(0, slash + 1) + name;
}

// Nothing in these rooms is seen so close that more than 512 texels across a model's picture would show.
constexpr int kPackTexels = 512;

bool is_table_like(const PackModel& model) {
    for (const char* word : {"table", "desk", "cabinet", "shelves", "bookcase", "cupboard", "chest", "crate", "barrel",
                             "oven", "drawers", "dresser", "workbench", "trunck", "trunk", "fridge", "box"})
        if (model.kind.find(word) != std::string::npos && model.kind.find("lamp") == std::string::npos &&
            model.kind.find("pool") == std::string::npos && model.kind.find("football") == std::string::npos &&
            model.kind.find("tennis") == std::string::npos)
            return true;
    return false;
}

}  // namespace

namespace packs {

Piece load_model(const ZipFile& zip, const PackModel& model) {
    const auto read_sibling = [&](const std::string& name) -> std::optional<std::string> {
        const std::string path = sibling(model.path, name);
        return zip.contains(path) ? std::optional(zip.read(path)) : std::nullopt;
    };
    ObjModel obj = parse_obj(zip.read(model.path), zip.path().string() + ": " + model.path, read_sibling);
    // Models look along +z with y up, like our pieces; their own size is arbitrary.
    const Mat3f turn = model.rotation.value_or(Mat3f{});
    Vec3f low{1e9f, 1e9f, 1e9f}, high = -low;
    for (ObjGroup& g : obj.groups)
        for (Vec3f& p : g.positions) {
            p = turn * p;
            for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
        }
    Vec3f scale;
    for (std::size_t k = 0; k < 3; ++k) scale[k] = model.size_m[k] / std::max(high[k] - low[k], 1e-6f);

    Piece piece;
    piece.kind = model.kind;
    piece.source = model.credit;
    piece.size_m = model.size_m;
    piece.mount = mount_of(model);
    piece.against_wall = piece.mount == Mount::floor && model.size_m.y > 0.5f;
    if (piece.mount == Mount::wall) piece.hang_height_m = model.elevation_m;
    const Vec3f center = (low + high) * 0.5f;
    // The origin: center of the base; on the wall, of the back's lower edge; at the ceiling, of the top.
    const Vec3f origin{center.x, piece.mount == Mount::ceiling ? high.y : low.y,
                       piece.mount == Mount::wall ? low.z : center.z};
    float largest = -1;
    for (ObjGroup& g : obj.groups) {
        Mesh mesh;
        mesh.triangles = std::move(g.triangles);
        for (std::size_t i = 0; i < g.positions.size(); ++i) {
            const Vec3f p = (g.positions[i] - origin) * scale, n = turn * g.normals[i];
            mesh.positions.push_back(p);
            mesh.normals.push_back(normalize(Vec3f{n.x / scale.x, n.y / scale.y, n.z / scale.z}));
            mesh.coords.push_back(p);
        }
        Material material = material_from(obj.materials[g.material]);
        if (const std::string& map = obj.materials[g.material].diffuse_map; !map.empty())
            if (const auto bytes = read_sibling(map)) {
                for (std::size_t i = 0; i < mesh.coords.size(); ++i) mesh.coords[i] = {g.uvs[i].x, g.uvs[i].y, 0};
                material.pattern = Pattern::image;
                material.image = texture_at_most(decode_rgb8(*bytes, zip.path().string() + ": " + map), kPackTexels);
                material.scale_m = metres_per_uv(mesh);
                material.color_a = {1, 1, 1};
            }
        mesh.material = static_cast<int>(piece.materials.size());
        if (const float area = area_of(mesh); area > largest) largest = area, piece.main_material = mesh.material;
        piece.materials.push_back(std::move(material));
        piece.meshes.push_back(std::move(mesh));
    }
    if (model.top_m && is_table_like(model) && piece.mount == Mount::floor)
        piece.surfaces.push_back(
            {{0, std::min(*model.top_m, model.size_m.y), 0}, {0.42f * model.size_m.x, 0.4f * model.size_m.z}});
    return piece;
}

}  // namespace packs

namespace {

// Extents that are asked for; the others go along.
Vec3f scale_asked(Vec3f size, const PieceRequest& request) {
    const float even = request.size_factor;
    Vec3f scale{even, even, even};
    float sum = 0, count = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (request.size_m[k] > 0) scale[k] = request.size_m[k] / std::max(size[k], 1e-3f), sum += scale[k], ++count;
    for (std::size_t k = 0; k < 3; ++k)
        if (count > 0 && request.size_m[k] == 0) scale[k] = sum / count;
    return scale;
}

void resize(Piece& piece, Vec3f scale) {
    piece.size_m = piece.size_m * scale;
    for (Mesh& mesh : piece.meshes) {
        for (Vec3f& p : mesh.positions) p = p * scale;
        for (Vec3f& n : mesh.normals) n = normalize(Vec3f{n.x / scale.x, n.y / scale.y, n.z / scale.z});
    }
    for (Surface& s : piece.surfaces) s.center = s.center * scale, s.half = {s.half.x * scale.x, s.half.y * scale.z};
}

}  // namespace

std::shared_ptr<const Piece> FurniturePack::loaded(const PackModel& model) const {
    const std::lock_guard lock(mutex_);
    auto& entry = loaded_[&model];
    if (!entry) entry = std::make_shared<const Piece>(load(model));
    return entry;
}

Piece FurniturePack::load(const PackModel& model) const {
    if (model.user < 0) return packs::load_model(archives_[model.archive], model);
    return load_user_model(users_folder_, users_.models[static_cast<std::size_t>(model.user)]).piece;
}

// One damaged file among eight hundred must not cost a room.
bool FurniturePack::is_sound(const PackModel& model) const {
    try {
        return loaded(model) != nullptr;
    } catch (const Error& error) {
        const std::lock_guard lock(mutex_);
        damaged_.emplace(&model, error.what());
        return false;
    }
}

std::vector<std::string> FurniturePack::damage() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> reasons;
    for (const auto& [model, reason] : damaged_)
        reasons.push_back((model->user < 0 ? "furniture pack: " : "") + reason + "; it goes on without this model");
    for (const std::string& reason : damaged_files_) reasons.push_back(reason + "; it goes on without it");
    std::sort(reasons.begin(), reasons.end());
    return reasons;
}

Piece FurniturePack::piece(const PackModel& model, const PieceRequest& request) const {
    Piece piece = *loaded(model);
    piece.kind = request.kind;
    Material& main = piece.materials[static_cast<std::size_t>(piece.main_material)];
    if (request.color) {
        if (main.image) {
            // The picture keeps its drawing and takes the color on the mean.
            const Vec3f mean = linear_from_srgb8(main.image->levels.back().pixels.front());
            for (std::size_t k = 0; k < 3; ++k)
                main.color_a[k] = std::clamp((*request.color)[k] / std::max(mean[k], 0.02f), 0.02f, 6.f);
        } else {
            main.color_a = main.color_b = main.color_c = *request.color;
            main.metal = 0;
        }
    } else if (!request.material.empty() && !main.image) {
        if (const auto material = material_named(request.material)) main = *material;
    }
    if (model.user >= 0 && has_role(model.kind, Role::light))  // as load_user_model leaves them
        for (Material& m : piece.materials) m.emission = m.emission * request.style->lamp_light;
    if (const Vec3f scale = scale_asked(piece.size_m, request); scale != Vec3f{1, 1, 1}) resize(piece, scale);
    return piece;
}

}  // namespace fastscene
