#include "fastscene/rooms/user_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/gltf_model.h"
#include "fastscene/io/obj.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/model_materials.h"
#include "fastscene/rooms/tops.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr float kSmallestPiece_m = 0.02f, kLargestPiece_m = 4.f;  // of a model that no row gives a size
constexpr float kSame = 2.f;  // of the usual size: a model up to so much larger or smaller is left as it is

struct LengthUnit {
    const char* name;
    float metres;
};
constexpr std::array<LengthUnit, 3> kLengthUnits{
    {{"centimetres", 0.01f}, {"millimetres", 0.001f}, {"inches", 0.0254f}}};

struct ModelBounds {
    Vec3f low{1e30f, 1e30f, 1e30f}, high = -low;
    Vec3f size() const { return high - low; }
};
ModelBounds bounds_of(const std::vector<ModelMesh>& meshes) {
    ModelBounds b;
    for (const ModelMesh& m : meshes)
        for (const Vec3f p : m.mesh.positions)
            for (std::size_t k = 0; k < 3; ++k)
                b.low[k] = std::min(b.low[k], p[k]), b.high[k] = std::max(b.high[k], p[k]);
    return b;
}

// How such a thing is as we build it: its size, and how it is placed.
std::optional<Piece> usual_piece(const std::string& kind) {
    const auto& built = piece_classes();
    if (!std::binary_search(built.begin(), built.end(), kind)) return {};
    PieceRequest request;
    request.kind = kind;
    request.style = &all_styles().front();
    return make_piece(request);
}

class Loader {
  public:
    Loader(const fs::path& folder, const UserModel& model, bool textures)
        : model_(model), file_(folder / model.file), textures_(textures), usual_(usual_piece(model.kind)) {}

    UserPiece load() {
        std::string ending = file_.extension().string();
        for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        std::vector<ModelMesh> meshes = ending == ".obj" ? from_obj() : from_gltf();
        for (ModelMesh& m : meshes) {
            for (Vec3f& p : m.mesh.positions) p = model_.ours_from_file * p;
            for (Vec3f& n : m.mesh.normals) n = model_.ours_from_file * n;
        }
        meshes = placed(std::move(meshes));
        if (has_role(model_.kind, Role::light)) light_up(meshes, out_.notes);
        add(std::move(meshes));
        describe();
        return std::move(out_);
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const { throw Error("{}: {}", file_.string(), what); }

    std::vector<ModelMesh> from_gltf() {
        GltfLimits limits;
        limits.images = textures_;
        GltfModel gltf = read_gltf(file_, limits);
        out_.notes = gltf.notes;
        const auto say = [](std::string& to, const std::string& found) {
            if (to.empty()) to = found;
        };
        out_.attribution = model_.attribution;
        say(out_.attribution.title, gltf.title), say(out_.attribution.author, gltf.author);
        say(out_.attribution.author, gltf.copyright);
        say(out_.attribution.license, gltf.license), say(out_.attribution.source, gltf.source);
        return meshes_of(std::move(gltf), out_.notes);
    }
    std::vector<ModelMesh> from_obj() {
        out_.attribution = model_.attribution;
        const fs::path folder = file_.parent_path();
        const auto read_sibling = [&](const std::string& name) -> std::optional<std::string> {
            const fs::path path = fs::path(name).lexically_normal();
            if (path.is_absolute() || path.empty() || *path.begin() == ".." || !fs::exists(folder / path)) return {};
            return read_file(folder / path);
        };
        return meshes_of(parse_obj(read_file(file_), file_.string(), read_sibling), file_.string(), read_sibling,
                         textures_, out_.notes);
    }

    // Metres a unit of the file is; each axis its own if the row says so.
    Vec3f scale_for(Vec3f size) {
        if (model_.size_m != Vec3f{}) {
            Vec3f scale{};
            float sum = 0, count = 0;
            for (std::size_t k = 0; k < 3; ++k)
                if (model_.size_m[k] > 0)
                    scale[k] = model_.size_m[k] / std::max(size[k], 1e-6f), sum += scale[k], ++count;
            for (std::size_t k = 0; k < 3; ++k)
                if (model_.size_m[k] == 0) scale[k] = sum / count;
            return scale;
        }
        const float unit = unit_for(size);
        return {unit, unit, unit};
    }
    float unit_for(Vec3f size) {
        const auto said = [](Vec3f s) { return fmt::format("{:.3g} x {:.3g} x {:.3g} m", s.x, s.y, s.z); };
        const float extent = length(size);
        const auto fits = [&](float e) {
            if (usual_) return e <= kSame * length(usual_->size_m) && e * kSame >= length(usual_->size_m);
            return e >= kSmallestPiece_m && e <= kLargestPiece_m;
        };
        if (fits(extent)) return 1;
        for (const LengthUnit& unit : kLengthUnits)
            if (fits(extent * unit.metres)) {
                out_.notes.push_back(
                    fmt::format("{} does not fit the class \"{}\": read as {}", said(size), spoken(), unit.name));
                return unit.metres;
            }
        // Models out of networks and scanners fill a cube of side 1 or 2.
        if (usual_) {
            const float unit = length(usual_->size_m) / extent;
            out_.notes.push_back(
                fmt::format("{} does not fit the class \"{}\": scaled to {} (height_m in {} overrides this)",
                            said(size), spoken(), said(size * unit), kAssetsFile));
            return unit;
        }
        refuse(fmt::format("expected a size between {} and {} m, found {}: say height_m, width_m or depth_m in {}",
                           kSmallestPiece_m, kLargestPiece_m, said(size), kAssetsFile));
    }
    std::string spoken() const {
        std::string name = model_.kind;
        std::replace(name.begin(), name.end(), '_', ' ');
        return name;
    }

    Mount mount_for(Vec3f size) const {
        if (model_.mount) return *model_.mount;
        if (usual_) return usual_->mount;
        if (model_.hang_height_m) return Mount::wall;
        constexpr float kSmallWidth_m = 0.52f, kSmallHeight_m = 0.6f;
        return std::max(size.x, size.z) < kSmallWidth_m && size.y < kSmallHeight_m ? Mount::surface : Mount::floor;
    }

    // Scaled, and moved to the origin that pieces of its mount have (furniture.h).
    std::vector<ModelMesh> placed(std::vector<ModelMesh> meshes) {
        const ModelBounds b = bounds_of(meshes);
        const Vec3f scale = scale_for(b.size());
        Piece& piece = out_.piece;
        for (std::size_t k = 0; k < 3; ++k) piece.size_m[k] = std::max(b.size()[k] * scale[k], 1e-4f);
        piece.mount = mount_for(piece.size_m);
        const Vec3f center = (b.low + b.high) * 0.5f;
        const Vec3f origin{center.x, piece.mount == Mount::ceiling ? b.high.y : b.low.y,
                           piece.mount == Mount::wall ? b.low.z : center.z};
        for (ModelMesh& m : meshes) {
            for (Vec3f& p : m.mesh.positions) p = (p - origin) * scale;
            for (Vec3f& n : m.mesh.normals) n = normalize(Vec3f{n.x / scale.x, n.y / scale.y, n.z / scale.z});
        }
        std::vector<ModelMesh> out;
        for (ModelMesh& m : meshes) finish(std::move(m), out);
        return out;
    }

    void add(std::vector<ModelMesh> meshes) {
        Piece& piece = out_.piece;
        float largest = -1;
        for (ModelMesh& m : meshes) {
            if (m.mesh.triangles.empty()) continue;
            out_.triangles += m.mesh.triangles.size() / 3;
            m.mesh.material = static_cast<int>(piece.materials.size());
            if (const float area = area_of(m.mesh); area > largest)
                largest = area, piece.main_material = m.mesh.material;
            piece.materials.push_back(std::move(m.material));
            piece.meshes.push_back(std::move(m.mesh));
        }
        if (piece.meshes.empty()) refuse("expected triangles, found none that can be seen");
    }

    void describe() {
        Piece& piece = out_.piece;
        piece.kind = model_.kind;
        piece.source = credit_of(out_.attribution, model_.file);
        piece.against_wall = piece.mount == Mount::floor && piece.size_m.y > 0.5f;
        if (usual_) {
            piece.clearance_front_m = usual_->clearance_front_m, piece.clearance_side_m = usual_->clearance_side_m;
            if (usual_->mount == piece.mount) piece.against_wall = usual_->against_wall;
            piece.hang_height_m = usual_->hang_height_m;
        }
        if (model_.hang_height_m) piece.hang_height_m = *model_.hang_height_m;
        const bool carries = !has_role(model_.kind, Role::no_top) && !has_role(model_.kind, Role::seat) &&
                             !has_role(model_.kind, Role::bed) && (!usual_ || !usual_->surfaces.empty());
        if (piece.mount == Mount::floor && carries) add_flat_top(piece);
    }

    const UserModel& model_;
    fs::path file_;
    bool textures_;
    std::optional<Piece> usual_;
    UserPiece out_;
};

}  // namespace

UserPiece load_user_model(const fs::path& folder, const UserModel& model, bool textures) {
    return Loader(folder, model, textures).load();
}

std::string credit_of(const Attribution& a, const fs::path& file) {
    std::string text = a.title.empty() ? file.stem().string() : a.title;
    if (!a.author.empty()) text += " by " + a.author;
    text += a.license.empty() ? " (licence not stated)" : " (" + a.license + ")";
    if (!a.source.empty()) text += ", " + a.source;
    return text + ", " + file.generic_string();
}

}  // namespace fastscene
