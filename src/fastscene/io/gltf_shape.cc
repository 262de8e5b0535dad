#include "fastscene/io/gltf_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fastscene/base/error.h"
#include "fastscene/io/smooth_normals.h"

namespace fastscene {
namespace {

constexpr std::size_t kTriangleList = 4, kTriangleStrip = 5, kTriangleFan = 6;

std::size_t mode_of(const GltfDocument& document, const Json& primitive) {
    return document.whole(primitive, "mode", kTriangleList);
}

bool all_are_finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Vec3d wide(Vec3f v) { return {v.x, v.y, v.z}; }
Vec3f narrow(Vec3d v) {
    // Beyond what floats hold the conversion is undefined.
    const auto one = [](double x) {
        return std::fabs(x) <= 3e38 ? static_cast<float>(x) : std::numeric_limits<float>::infinity();
    };
    return {one(v.x), one(v.y), one(v.z)};
}

class ShapeReader {
  public:
    ShapeReader(GltfDocument& document, const Json& primitive, const GltfJson::Transform& world_from_node)
        : document_(document),
          attributes_(*attributes_of(primitive)),
          primitive_(primitive),
          world_(world_from_node),
          positions_(document.accessor(document.whole(attributes_, "POSITION"), "POSITION", {3})) {
        const Mat3d& m = world_.linear;
        determinant_ = dot(m.row0, cross(m.row1, m.row2));
    }

    GltfShape read(const GltfUvUse& uv) {
        read_triangles();
        keep_used_vertices();
        read_positions();
        leave_flat_triangles();
        read_uvs(uv);
        read_colors();
        if (const GltfAccessor* normals = attribute("NORMAL", {3})) read_normals(*normals);
        else make_normals();
        return std::move(shape_);
    }

  private:
    const Json* attributes_of(const Json& primitive) const {
        const Json* found = GltfJson::object(primitive, "attributes");
        if (!found) document_.refuse("expected a primitive with attributes, found one without");
        return found;
    }
    const GltfAccessor* attribute(const char* name, const std::vector<std::size_t>& widths) {
        if (!attributes_.contains(name)) return nullptr;
        const GltfAccessor& found = document_.accessor(document_.whole(attributes_, name), name, widths);
        if (found.count() < positions_.count())
            document_.refuse(
                fmt::format("{}: expected {} rows as POSITION has, found {}", name, positions_.count(), found.count()));
        return &found;
    }

    void read_triangles() {
        const GltfAccessor* indices = nullptr;
        if (primitive_.contains("indices"))
            indices = &document_.accessor(document_.whole(primitive_, "indices"), "indices", {1});
        const std::size_t count = indices ? indices->count() : positions_.count();
        const auto vertex = [&](std::size_t i) {
            const std::size_t at = indices ? indices->whole(i) : i;
            if (at >= positions_.count())
                document_.refuse(fmt::format("indices: expected less than {}, found {}", positions_.count(), at));
            return static_cast<std::uint32_t>(at);
        };
        // A mirror turns triangles around.
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
            if (determinant_ < 0) std::swap(b, c);
            for (const std::size_t i : {a, b, c}) shape_.triangles.push_back(vertex(i));
        };
        const std::size_t mode = mode_of(document_, primitive_);
        if (mode == kTriangleList)
            for (std::size_t i = 0; i + 2 < count; i += 3) add(i, i + 1, i + 2);
        else if (mode == kTriangleStrip)
            for (std::size_t i = 0; i + 2 < count; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
        else
            for (std::size_t i = 1; i + 1 < count; ++i) add(i, i + 1, 0);
    }

    // Primitives may share long accessors.
    void keep_used_vertices() {
        constexpr std::uint32_t kUnused = 0xffffffffu;
        std::vector<std::uint32_t> place(positions_.count(), kUnused);
        for (std::uint32_t& i : shape_.triangles) {
            if (place[i] == kUnused) place[i] = static_cast<std::uint32_t>(rows_.size()), rows_.push_back(i);
            i = place[i];
        }
    }

    void read_positions() {
        for (const std::uint32_t row : rows_) {
            const Vec3f p{positions_.at(row, 0), positions_.at(row, 1), positions_.at(row, 2)};
            const Vec3f placed = narrow(world_.linear * wide(p) + world_.move);
            if (!all_are_finite(p) || !all_are_finite(placed))
                document_.refuse(fmt::format("POSITION: expected finite numbers, found ({}, {}, {}) in row {}{}", p.x,
                                             p.y, p.z, row,
                                             all_are_finite(p) ? ", which its node moves out of range" : ""));
            shape_.positions.push_back(placed);
        }
    }

    Vec3f face_normal(std::size_t triangle) const {
        const auto corner = [&](std::size_t i) { return shape_.positions[shape_.triangles[3 * triangle + i]]; };
        return cross(corner(1) - corner(0), corner(2) - corner(0));
    }
    std::size_t triangle_count() const { return shape_.triangles.size() / 3; }

    void leave_flat_triangles() {
        std::vector<std::uint32_t> kept;
        kept.reserve(shape_.triangles.size());
        for (std::size_t t = 0; t < triangle_count(); ++t) {
            const float area = length(face_normal(t));
            if (!(area > 0 && std::isfinite(area))) continue;
            const auto begin = shape_.triangles.begin() + static_cast<std::ptrdiff_t>(3 * t);
            kept.insert(kept.end(), begin, begin + 3);
        }
        shape_.triangles = std::move(kept);
    }

    void read_uvs(const GltfUvUse& use) {
        const GltfAccessor* uvs = attribute(fmt::format("TEXCOORD_{}", use.set).c_str(), {2});
        if (!uvs) return;
        for (const std::uint32_t row : rows_) {
            const Vec2d uv = use(Vec2d{uvs->at(row, 0), uvs->at(row, 1)});
            const bool fine = std::fabs(uv.x) < 1e6 && std::fabs(uv.y) < 1e6;
            shape_.odd_uvs = shape_.odd_uvs || !fine;
            shape_.uvs_beyond = shape_.uvs_beyond || std::max(std::fabs(uv.x - 0.5), std::fabs(uv.y - 0.5)) > 0.501;
            shape_.uvs.push_back(fine ? Vec2f{static_cast<float>(uv.x), static_cast<float>(1 - uv.y)} : Vec2f{});
        }
    }

    void read_colors() {
        const GltfAccessor* colors = attribute("COLOR_0", {3, 4});
        if (!colors || rows_.empty()) return;
        constexpr float kSame = 1.f / 255;
        const auto color = [&](std::size_t row) {
            GltfColor out{1, 1, 1, 1};
            for (std::size_t c = 0; c < colors->width(); ++c) {
                const float v = colors->at(row, c);
                out[c] = v > 0 ? std::min(v, 1.f) : 0.f;
            }
            return out;
        };
        shape_.color = color(rows_.front());
        for (const std::uint32_t row : rows_) {
            const GltfColor other = color(row);
            for (std::size_t c = 0; c < 4; ++c)
                if (std::fabs(other[c] - shape_.color[c]) > kSame) shape_.has_colors = true;
        }
    }

    // Zero where a normal is useless.
    Vec3f placed_normal(const GltfAccessor& normals, std::uint32_t row) const {
        const Vec3d n{normals.at(row, 0), normals.at(row, 1), normals.at(row, 2)};
        const Mat3d& m = world_.linear;
        // The inverse's transpose, up to a positive factor.
        const Mat3d cofactors{cross(m.row1, m.row2), cross(m.row2, m.row0), cross(m.row0, m.row1)};
        const Vec3d turned = cofactors * n * (determinant_ < 0 ? -1. : 1.);
        const double l = length(turned);
        return l > 0 && std::isfinite(l) ? narrow(turned / l) : Vec3f{};
    }

    void read_normals(const GltfAccessor& normals) {
        for (const std::uint32_t row : rows_) shape_.normals.push_back(placed_normal(normals, row));
        std::vector<Vec3f> instead(rows_.size());
        for (std::size_t t = 0; t < triangle_count(); ++t) {
            std::uint32_t* corners = &shape_.triangles[3 * t];
            const Vec3f own = face_normal(t);
            const Vec3f told = shape_.normals[corners[0]] + shape_.normals[corners[1]] + shape_.normals[corners[2]];
            const bool turned = dot(told, own) < 0;
            if (turned) std::swap(corners[1], corners[2]), ++shape_.turned;
            for (std::size_t i = 0; i < 3; ++i) instead[corners[i]] += turned ? -own : own;
        }
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (!(length(shape_.normals[i]) > 0)) {
                const Vec3f unit = normalize(instead[i]);
                shape_.normals[i] = length(unit) > 0 ? unit : Vec3f{0, 1, 0};
            }
    }

    // Vertices at one place count as one, whatever their texture coordinates.
    std::vector<std::size_t> places() const {
        std::vector<std::size_t> order(rows_.size()), place(rows_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto less = [&](std::size_t a, std::size_t b) {
            const Vec3f &p = shape_.positions[a], &q = shape_.positions[b];
            return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
        };
        std::sort(order.begin(), order.end(), less);
        for (std::size_t i = 0; i < order.size(); ++i)
            place[order[i]] = i > 0 && !less(order[i - 1], order[i]) ? place[order[i - 1]] : i;
        return place;
    }

    // Each corner becomes a vertex, since sharp edges part them.
    void make_normals() {
        const std::vector<std::size_t> place = places();
        SmoothNormals smooth(rows_.size());
        for (std::size_t t = 0; t < triangle_count(); ++t) {
            const std::uint32_t* corners = &shape_.triangles[3 * t];
            smooth.add({place[corners[0]], place[corners[1]], place[corners[2]]}, face_normal(t));
        }
        GltfShape parted = shape_;
        parted.positions.clear(), parted.uvs.clear();
        for (std::size_t i = 0; i < shape_.triangles.size(); ++i) {
            const std::uint32_t from = shape_.triangles[i];
            parted.triangles[i] = static_cast<std::uint32_t>(i);
            parted.positions.push_back(shape_.positions[from]);
            if (!shape_.uvs.empty()) parted.uvs.push_back(shape_.uvs[from]);
            parted.normals.push_back(smooth.at(place[from], face_normal(i / 3)));
        }
        shape_ = std::move(parted);
    }

    GltfDocument& document_;
    const Json& attributes_;
    const Json& primitive_;
    const GltfJson::Transform& world_;
    const GltfAccessor& positions_;
    double determinant_ = 1;
    std::vector<std::uint32_t> rows_;  // of the accessors, per vertex
    GltfShape shape_;
};

}  // namespace

bool has_gltf_triangles(const GltfDocument& document, const Json& primitive) {
    const std::size_t mode = mode_of(document, primitive);
    return mode >= kTriangleList && mode <= kTriangleFan;
}

std::size_t gltf_triangle_count(GltfDocument& document, const Json& primitive) {
    const Json* attributes = GltfJson::object(primitive, "attributes");
    const bool indexed = primitive.contains("indices");
    if (!indexed && (!attributes || !attributes->contains("POSITION"))) return 0;
    const std::size_t accessor = indexed ? document.whole(primitive, "indices")
                                         : document.whole(*attributes, "POSITION");
    const std::size_t count = document.whole(document.item("accessors", accessor), "count");
    return mode_of(document, primitive) == kTriangleList ? count / 3 : count - std::min<std::size_t>(count, 2);
}

GltfShape gltf_shape(GltfDocument& document, const Json& primitive, const GltfJson::Transform& world_from_node,
                     const GltfUvUse& uv) {
    return ShapeReader(document, primitive, world_from_node).read(uv);
}

}  // namespace fastscene
