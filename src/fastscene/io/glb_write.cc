#include <algorithm>
#include <cmath>
#include <functional>

#include "fastscene/base/json.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/glb_container.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {
namespace {

constexpr int kByte = 5121, kFloat = 5126, kArrayBuffer = 34962, kPoints = 0;

// Collects attributes, each with a buffer view, an accessor and a name.
class Attributes {
  public:
    explicit Attributes(std::size_t splats) : splats_(splats) {}
    // `floats(i, put)` emits the numbers of splat i.
    void add(const std::string& name, const char* type,
             const std::function<void(std::size_t, const std::function<void(float)>&)>& floats) {
        const std::size_t begin = binary.size();
        for (std::size_t i = 0; i < splats_; ++i) floats(i, [&](float v) { append(binary, v); });
        describe(name, type, kFloat, begin);
    }
    void add_bytes(const std::string& name, const char* type,
                   const std::function<void(std::size_t, std::string&)>& bytes) {
        const std::size_t begin = binary.size();
        for (std::size_t i = 0; i < splats_; ++i) bytes(i, binary);
        describe(name, type, kByte, begin);
        accessors.back()["normalized"] = true;
    }
    std::string binary;
    Json views = Json::array(), accessors = Json::array(), names = Json::object();

  private:
    void describe(const std::string& name, const char* type, int component, std::size_t begin) {
        names[name] = accessors.size();
        accessors.push_back(
            {{"bufferView", views.size()}, {"componentType", component}, {"count", splats_}, {"type", type}});
        views.push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary.size() - begin}, {"target", kArrayBuffer}});
    }
    std::size_t splats_;
};

void add_harmonics(Attributes& attributes, const Splats& s) {
    const auto k = static_cast<std::size_t>(s.rest_coefficients());
    std::size_t coefficient = 0;
    for (int degree = 1; degree <= s.sh_degree; ++degree)
        for (int n = 0; n <= 2 * degree; ++n, ++coefficient)
            attributes.add(fmt::format("KHR_gaussian_splatting:SH_DEGREE_{}_COEF_{}", degree, n), "VEC3",
                           [&](std::size_t i, const auto& put) {
                               for (std::size_t channel = 0; channel < 3; ++channel)
                                   put(s.sh_rest[(i * 3 + channel) * k + coefficient]);
                           });
}

Attributes attributes_of(const Splats& s) {
    Attributes out(s.size());
    const auto three = [](Vec3f v, const auto& put) { put(v.x), put(v.y), put(v.z); };
    out.add("POSITION", "VEC3", [&](std::size_t i, const auto& put) { three(s.mean_m[i], put); });
    Vec3f low = s.mean_m[0], high = low;
    for (const Vec3f p : s.mean_m)
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    out.accessors.back()["min"] = {low.x, low.y, low.z};
    out.accessors.back()["max"] = {high.x, high.y, high.z};
    // Fallback for readers without the extension: colored points.
    out.add_bytes("COLOR_0", "VEC4", [&](std::size_t i, std::string& bytes) {
        for (std::size_t a = 0; a < 3; ++a) bytes += static_cast<char>(byte_near((s.sh0[i][a] * kSh0 + 0.5f) * 255.f));
        bytes += static_cast<char>(byte_near(sigmoid(s.opacity_logit[i]) * 255.f));
    });
    out.add("KHR_gaussian_splatting:ROTATION", "VEC4", [&](std::size_t i, const auto& put) {
        const auto [w, x, y, z] = unit_quaternion(s.rotation[i]);
        put(x), put(y), put(z), put(w);
    });
    out.add("KHR_gaussian_splatting:SCALE", "VEC3", [&](std::size_t i, const auto& put) {
        three({std::exp(s.log_scale[i].x), std::exp(s.log_scale[i].y), std::exp(s.log_scale[i].z)}, put);
    });
    out.add("KHR_gaussian_splatting:OPACITY", "SCALAR",
            [&](std::size_t i, const auto& put) { put(sigmoid(s.opacity_logit[i])); });
    out.add("KHR_gaussian_splatting:SH_DEGREE_0_COEF_0", "VEC3",
            [&](std::size_t i, const auto& put) { three(s.sh0[i], put); });
    add_harmonics(out, s);
    return out;
}

}  // namespace

std::string splat_glb_bytes(const Splats& world, Vec3d offset_m) {
    if (world.size() == 0) throw Error("glTF cannot hold zero splats");
    Splats splats = world;
    transform(splats, {kGltfFromWorld, 1, {}});
    const Attributes attributes = attributes_of(splats);
    const Json extension{{"kernel", "ellipse"},
                         {"colorSpace", "srgb_rec709_display"},
                         {"sortingMethod", "cameraDistance"},
                         {"projection", "perspective"}};
    Json primitive{
        {"attributes", attributes.names}, {"mode", kPoints}, {"extensions", {{"KHR_gaussian_splatting", extension}}}};
    // The extension has no such properties.
    if (splats.filter.antialias) primitive["extras"]["antialiased"] = true;
    if (splats.filter.low_pass_px2 != FootprintFilter{}.low_pass_px2)
        primitive["extras"][kLowPassKey] = splats.filter.low_pass_px2;
    Json node{{"mesh", 0}};
    if (const Vec3d move = kGltfFromWorld * offset_m; move != Vec3d{}) node["translation"] = {move.x, move.y, move.z};
    const Json json{{"asset", {{"version", "2.0"}, {"generator", "fastscene"}}},
                    {"extensionsUsed", {"KHR_gaussian_splatting"}},
                    {"scene", 0},
                    {"scenes", {{{"nodes", {0}}}}},
                    {"nodes", Json::array({node})},
                    {"meshes", {{{"primitives", Json::array({primitive})}}}},
                    {"accessors", attributes.accessors},
                    {"bufferViews", attributes.views},
                    {"buffers", {{{"byteLength", attributes.binary.size()}}}}};
    return glb_bytes(json, attributes.binary);
}

}  // namespace fastscene
