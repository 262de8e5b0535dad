#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/json.h"
#include "fastscene/image/color.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/glb.h"
#include "fastscene/io/glb_container.h"
#include "fastscene/io/gltf_json.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/spz.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/scene/splat_edit.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = "KHR_gaussian_splatting";
constexpr int kDeepestNode = 100;
// SPZ inside: the names that drafts of the extension have had. Their numbers are in the node's axes.
constexpr const char* kSpzExtensions[] = {"KHR_gaussian_splatting_compression_spz_2",
                                          "KHR_gaussian_splatting_compression_spz",
                                          "KHR_spz_gaussian_splats_compression", "KHR_spz_compression"};
// Nodes may share a mesh; gzip packs at most about this many splats into a byte.
constexpr std::size_t kMostSplatsPerByte = 64;
constexpr const char* kDisplayColors = "srgb_rec709_display";
constexpr const char* kLinearColors = "lin_rec709_display";

// Colors of splats are sRGB-encoded values here. Harmonics change with the encoding's slope at the color's middle.
void encode_linear_colors(Splats& s) {
    const auto k = static_cast<std::size_t>(s.rest_coefficients());
    constexpr float kStep = 1e-3f;
    for (std::size_t i = 0; i < s.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float linear = std::clamp(s.sh0[i][c] * kSh0 + 0.5f, 0.f, 1.f);
            const float low = std::min(linear, 1 - kStep);
            const float slope = (srgb_from_linear(low + kStep) - srgb_from_linear(low)) / kStep;
            s.sh0[i][c] = (srgb_from_linear(linear) - 0.5f) / kSh0;
            for (std::size_t n = 0; n < k; ++n) s.sh_rest[(3 * i + c) * k + n] *= slope;
        }
}

class Glb : private GltfJson {
  public:
    Glb(const fs::path& path, std::string_view bytes) : Glb(path, glb_chunks(path, bytes)) {}

    // A required extension that splats do not need (a material's, a light's) is no reason to refuse: what they do need
    // is asked for where their data are read.
    ReadSplats splats() {
        std::vector<Placed> parts = placed_primitives();
        if (parts.empty()) refuse(fmt::format("expected a mesh primitive with {}, found none", kExtension));
        const Similarity world_from_file{kGltfFromWorld, 1, {}};
        offset_ = offset_for(compose(world_from_file, parts.front().world_from_node).translation);
        std::vector<Splats> pieces;
        for (const Placed& part : parts) {
            pieces.push_back(splats_of(*part.primitive));
            read_ += pieces.back().size();
            Similarity world = compose(world_from_file, part.world_from_node);
            world.translation = world.translation - offset_;
            transform(pieces.back(), world);
        }
        Splats all;
        for (const Splats& piece : pieces) {
            all.sh_degree = std::max(all.sh_degree, piece.sh_degree);
            all.filter.antialias |= piece.filter.antialias;
        }
        for (const Splats& piece : pieces) append(all, piece);
        // A file has a single rendering mode: that of its first primitive.
        const Json& first = *parts.front().primitive;
        if (first.contains("extras") && first.at("extras").is_object()) {
            const Json& extras = first.at("extras");
            all.filter.antialias |= extras.value("antialiased", Json()) == Json(true);
            if (const Json low_pass = extras.value(kLowPassKey, Json()); low_pass.is_number())
                all.filter.low_pass_px2 = low_pass_px2_from(low_pass.get<double>());
        }
        ReadSplats read(std::move(all));
        read.warnings = std::move(warnings_);
        read.offset_m = offset_;
        return read;
    }

  private:
    struct Placed {
        const Json* primitive;
        Similarity world_from_node;
    };

    Glb(const fs::path& path, const GlbChunks& chunks)
        : GltfJson(path.string(), chunks.json, chunks.json_at), path_(path), binary_(chunks.binary) {}

    // A node may rotate, translate and scale uniformly; other transforms do not preserve Gaussians' parameters.
    Similarity placement(const Json& node) const {
        const auto [linear, move] = transform_of(node);
        const double scale = length(linear.column(0));
        const Mat3d turn = Mat3d::from_columns(linear.column(0) * (1 / scale), linear.column(1) * (1 / scale),
                                               linear.column(2) * (1 / scale));
        const Mat3d square = transpose(turn) * turn;
        double error = 0;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                error = std::max(error, std::fabs(square.column(b)[a] - (a == b ? 1 : 0)));
        if (!(scale > 0 && error < 1e-3 && std::isfinite(move.x + move.y + move.z)))
            refuse("expected a node that turns, moves or scales evenly, found another matrix");
        return {turn, scale, move};
    }

    // The extension that says that the splats are packed as SPZ: on the primitive, or on its extension.
    static const Json* spz_of(const Json& primitive) {
        for (const char* name : kSpzExtensions) {
            if (const Json* found = extension(primitive, name)) return found;
            if (const Json* base = extension(primitive, kExtension))
                if (const Json* found = extension(*base, name)) return found;
        }
        return nullptr;
    }
    static bool holds_splats(const Json& primitive) { return extension(primitive, kExtension) || spz_of(primitive); }

    void visit(const Json& node, const Similarity& world_from_parent, int depth, std::vector<Placed>& out) {
        if (depth > kDeepestNode) refuse(fmt::format("expected nodes at most {} deep, found more", kDeepestNode));
        if (++visited_ > list(root(), "nodes").size()) refuse("expected each node once in the tree, found more");
        const Similarity world_from_node = compose(world_from_parent, placement(node));
        if (node.contains("mesh"))
            for (const Json& primitive : list(item("meshes", whole(node, "mesh")), "primitives"))
                if (holds_splats(primitive)) out.push_back({&primitive, world_from_node});
        for (const Json& child : list(node, "children"))
            if (child.is_number_unsigned())
                visit(item("nodes", child.get<std::size_t>()), world_from_node, depth + 1, out);
    }

    std::vector<Placed> placed_primitives() {
        std::vector<Placed> out;
        const Json& scenes = list(root(), "scenes");
        if (const std::size_t scene = whole(root(), "scene", 0); scene < scenes.size()) {
            for (const Json& node : list(scenes[scene], "nodes"))
                if (node.is_number_unsigned()) visit(item("nodes", node.get<std::size_t>()), {}, 0, out);
        } else {  // no scene: uses all nodes
            for (const Json& mesh : list(root(), "meshes"))
                for (const Json& primitive : list(mesh, "primitives"))
                    if (holds_splats(primitive)) out.push_back({&primitive, {}});
        }
        return out;
    }

    static std::string harmonic(int degree, int n) {
        return fmt::format("{}:SH_DEGREE_{}_COEF_{}", kExtension, degree, n);
    }
    static bool has(const Json& primitive, const std::string& name) {
        return primitive.contains("attributes") && primitive.at("attributes").contains(name);
    }
    static int degree_of(const Json& primitive) {
        int degree = 0;
        while (degree < 3 && has(primitive, harmonic(degree + 1, 0))) ++degree;
        return degree;
    }

    // The bytes of a buffer view; `name` is for errors.
    std::string_view bytes_of(const Json& view, const std::string& name) const {
        for (const char* packed : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
            if (extension(view, packed)) refuse(fmt::format("{}: expected plain data, found {}", name, packed));
        const Json& buffer = item("buffers", whole(view, "buffer"));
        if (buffer.contains("uri"))
            refuse(fmt::format("{}: expected data inside the file, found a buffer elsewhere", name));
        const std::size_t begin = whole(view, "byteOffset", 0), length = whole(view, "byteLength");
        if (begin > binary_.size() || length > binary_.size() - begin)
            refuse(fmt::format("{}: expected bytes {} to {} of the data, found {}", name, begin, begin + length,
                               binary_.size()));
        return binary_.substr(begin, length);
    }

    // All numbers of an attribute, `width` per splat. Integers are shares of their type's largest number if the
    // accessor is normalized, and plain numbers otherwise.
    std::vector<float> read(const Json& primitive, const std::string& name, std::size_t width) const {
        if (!has(primitive, name)) refuse(fmt::format("expected an attribute {}, found none", name));
        const Json& accessor = item("accessors", whole(primitive.at("attributes"), name.c_str()));
        const Json& view = item("bufferViews", whole(accessor, "bufferView"));
        const char* type = width == 1 ? "SCALAR" : width == 3 ? "VEC3" : "VEC4";
        if (accessor.value("type", Json()) != type)
            refuse(fmt::format("{}: expected {}, found {}", name, type, accessor.value("type", Json()).dump()));
        if (accessor.contains("sparse")) refuse(fmt::format("{}: expected a plain accessor, found a sparse one", name));
        const std::size_t component = whole(accessor, "componentType"), bytes = component == 5126 ? 4
                                                                                : component == 5122 || component == 5123
                                                                                    ? 2
                                                                                    : 1;
        if (component != 5126 && !(component >= 5120 && component <= 5123))
            refuse(fmt::format("{}: expected floats, bytes or shorts, found component type {}", name, component));
        const bool normalized = component != 5126 && accessor.value("normalized", Json()) == true;
        const std::string_view data = bytes_of(view, name);
        const std::size_t count = whole(accessor, "count"), row = bytes * width,
                          stride = whole(view, "byteStride", row);
        const std::size_t length = data.size(), first = whole(accessor, "byteOffset", 0);
        if (stride < row || first > length ||
            (count > 0 && (length - first < row || count - 1 > (length - first - row) / stride)))
            refuse(fmt::format("{}: expected {} rows of {} bytes, found {} bytes", name, count, stride, length));
        std::vector<float> out;
        out.reserve(count * width);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < width; ++c)
                out.push_back(gltf_component(data, first + i * stride + c * bytes, component, normalized));
        return out;
    }
    Splats splats_of(const Json& primitive) {
        const Json none, *given = extension(primitive, kExtension), &base = given ? *given : none;
        const Json space = base.is_object() ? base.value("colorSpace", Json(kDisplayColors)) : Json(kDisplayColors);
        if (space != kDisplayColors && space != kLinearColors)
            refuse(fmt::format("expected colors in {} or {}, found {}", kDisplayColors, kLinearColors, space.dump()));
        if (const Json kernel = base.is_object() ? base.value("kernel", Json("ellipse")) : Json("ellipse");
            kernel != "ellipse")
            refuse(fmt::format("expected the kernel \"ellipse\", found {}", kernel.dump()));
        Splats splats = unpacked_or_plain(primitive, base);
        if (space == kLinearColors) {
            encode_linear_colors(splats);
            warn("its colors are linear; they were converted, and blend slightly differently");
        }
        return splats;
    }
    Splats unpacked_or_plain(const Json& primitive, const Json& base) {
        const bool plain = has(primitive, std::string(kExtension) + ":SCALE");
        if (const Json* spz = spz_of(primitive)) {
            const std::string_view bytes = bytes_of(item("bufferViews", whole(*spz, "bufferView")), "SPZ");
            if (is_spz(bytes)) {
                ReadSplats read = stored_splats_of_spz(path_, bytes);
                if (read_ + read.splats.size() > kMostSplatsPerByte * binary_.size())
                    refuse("expected the packed splats once, found them in too many nodes");
                for (const std::string& text : read.warnings) warn("SPZ inside: " + text);
                return std::move(read.splats);
            }
            if (!plain) refuse("expected SPZ in the buffer view that the extension names, found something else");
            warn("the buffer view that should hold SPZ holds something else; the plain splats beside it are used");
        } else if (const Json& others = base.is_object() ? base.value("extensions", Json::object()) : Json::object();
                   !others.empty() && !plain) {
            refuse(fmt::format("expected plain splats or SPZ, found them compressed with {}", others.begin().key()));
        }
        return plain_splats(primitive);
    }
    void warn(const std::string& text) {
        if (std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) warnings_.push_back(text);
    }

    Splats plain_splats(const Json& primitive) const {
        const std::string prefix = std::string(kExtension) + ":";
        const auto mean = read(primitive, "POSITION", 3), rotation = read(primitive, prefix + "ROTATION", 4),
                   scale = read(primitive, prefix + "SCALE", 3);
        const auto opacity = read(primitive, prefix + "OPACITY", 1), sh0 = read(primitive, harmonic(0, 0), 3);
        const std::size_t count = opacity.size();
        // Limits the expansion of meshes shared by nodes.
        if (read_ + count > binary_.size())
            refuse(fmt::format("expected at most {} splats in all, found more", binary_.size()));
        const auto same = [&](const std::vector<float>& values, std::size_t width) {
            if (values.size() != count * width)
                refuse(fmt::format("expected {} rows in every attribute, found {}", count, values.size() / width));
        };
        same(mean, 3), same(rotation, 4), same(scale, 3), same(sh0, 3);
        Splats s;
        s.sh_degree = degree_of(primitive);
        s.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto three = [&](const std::vector<float>& v) { return Vec3f{v[3 * i], v[3 * i + 1], v[3 * i + 2]}; };
            const Vec3f size = three(scale);
            s.mean_m[i] = three(mean);
            s.log_scale[i] = {std::log(std::fabs(size.x)), std::log(std::fabs(size.y)), std::log(std::fabs(size.z))};
            s.rotation[i] = {rotation[4 * i + 3], rotation[4 * i], rotation[4 * i + 1], rotation[4 * i + 2]};
            s.opacity_logit[i] = std::isnan(opacity[i]) ? opacity[i] : logit_of(opacity[i], 4e6f);
            s.sh0[i] = three(sh0);
        }
        const auto k = static_cast<std::size_t>(s.rest_coefficients());
        std::size_t coefficient = 0;
        for (int degree = 1; degree <= degree_of(primitive); ++degree)
            for (int n = 0; n <= 2 * degree; ++n, ++coefficient) {
                const auto f = read(primitive, harmonic(degree, n), 3);
                same(f, 3);
                for (std::size_t i = 0; i < count; ++i)
                    for (std::size_t channel = 0; channel < 3; ++channel)
                        s.sh_rest[(i * 3 + channel) * k + coefficient] = f[3 * i + channel];
            }
        return s;
    }
    static void append(Splats& all, const Splats& more) {
        const auto add = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
        add(all.mean_m, more.mean_m), add(all.log_scale, more.log_scale), add(all.rotation, more.rotation);
        add(all.opacity_logit, more.opacity_logit), add(all.sh0, more.sh0);
        const auto k = static_cast<std::size_t>(all.rest_coefficients()),
                   has = static_cast<std::size_t>(more.rest_coefficients());
        for (std::size_t row = 0; row < 3 * more.size(); ++row) {
            const auto begin = more.sh_rest.begin() + static_cast<std::ptrdiff_t>(row * has);
            all.sh_rest.insert(all.sh_rest.end(), begin, begin + static_cast<std::ptrdiff_t>(has));
            all.sh_rest.resize(all.sh_rest.size() + k - has);
        }
    }

    fs::path path_;
    std::string_view binary_;
    std::size_t visited_ = 0, read_ = 0;
    Vec3d offset_;
    std::vector<std::string> warnings_;
};

}  // namespace

bool is_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }

ReadSplats splats_of_glb(const fs::path& path, std::string_view bytes) { return Glb(path, bytes).splats(); }

}  // namespace fastscene
