#include "fastscene/export/gltf.h"

#include <algorithm>
#include <cstring>

#include "fastscene/base/shortest.h"
#include "fastscene/io/glb_container.h"

namespace fastscene {
namespace {

constexpr int kShort = 5123, kInt = 5125, kFloat = 5126;  // component types
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963, kNoTarget = 0;

template <class T>
void put(std::string& out, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
}

}  // namespace

Json json_list(Vec3f v) { return Json{shortest(v.x), shortest(v.y), shortest(v.z)}; }

int Gltf::add(const std::string& array, Json entry) {
    Json& list = json_[array];
    if (list.is_null()) list = Json::array();
    list.push_back(std::move(entry));
    return static_cast<int>(list.size()) - 1;
}

int Gltf::view(std::size_t begin, int target) {
    Json view{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary_.size() - begin}};
    if (target != kNoTarget) view["target"] = target;
    binary_.append((4 - binary_.size() % 4) % 4, '\0');
    return add("bufferViews", std::move(view));
}

int Gltf::add_vectors(const std::vector<Vec3f>& values) {
    const std::size_t begin = binary_.size();
    for (const Vec3f v : values) put(binary_, v.x), put(binary_, v.y), put(binary_, v.z);
    return add("accessors", {{"bufferView", view(begin, kArrayBuffer)},
                             {"componentType", kFloat},
                             {"count", values.size()},
                             {"type", "VEC3"}});
}

int Gltf::add_positions(const std::vector<Vec3f>& values) {
    Vec3f low = values.at(0), high = low;
    for (const Vec3f p : values)
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    const int index = add_vectors(values);
    json_["accessors"].back()["min"] = {low.x, low.y, low.z};
    json_["accessors"].back()["max"] = {high.x, high.y, high.z};
    return index;
}

int Gltf::add_uv(const std::vector<Vec2f>& values) {
    const std::size_t begin = binary_.size();
    for (const Vec2f v : values) put(binary_, v.x), put(binary_, v.y);
    return add("accessors", {{"bufferView", view(begin, kArrayBuffer)},
                             {"componentType", kFloat},
                             {"count", values.size()},
                             {"type", "VEC2"}});
}

int Gltf::add_indices(const std::vector<std::uint32_t>& values) {
    const std::size_t begin = binary_.size();
    // 65535 restarts primitives and is not allowed as an index.
    const bool small = *std::max_element(values.begin(), values.end()) < 0xffffu;
    for (const std::uint32_t v : values)
        if (small) put(binary_, static_cast<std::uint16_t>(v));
        else put(binary_, v);
    return add("accessors", {{"bufferView", view(begin, kElementBuffer)},
                             {"componentType", small ? kShort : kInt},
                             {"count", values.size()},
                             {"type", "SCALAR"}});
}

int Gltf::add_image(const std::string& encoded, const char* mime, const std::string& name) {
    const std::size_t begin = binary_.size();
    binary_ += encoded;
    return add("images", {{"name", name}, {"bufferView", view(begin, kNoTarget)}, {"mimeType", mime}});
}

void Gltf::use(const std::string& extension) {
    Json& used = json_["extensionsUsed"];
    if (used.is_null()) used = Json::array();
    if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

std::string Gltf::bytes(Json scene) const {
    Json json{{"asset", {{"version", "2.0"}, {"generator", "fastscene"}}}};
    json.update(json_);
    json["scene"] = 0;
    json["scenes"] = Json::array({std::move(scene)});
    json["buffers"] = {{{"byteLength", binary_.size()}}};
    return glb_bytes(json, binary_);
}

void set_pose(Json& node, const Rigid& pose) {
    const auto [w, x, y, z] = quaternion_of(pose.rotation);
    const float norm = 1.f / std::sqrt(w * w + x * x + y * y + z * z);
    if (pose.translation != Vec3f{}) node["translation"] = json_list(pose.translation);
    if (pose.rotation != Mat3f{})
        node["rotation"] = {shortest(x * norm), shortest(y * norm), shortest(z * norm), shortest(w * norm)};
}

}  // namespace fastscene
