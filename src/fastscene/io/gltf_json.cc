#include "fastscene/io/gltf_json.h"

#include <algorithm>
#include <cstdint>

#include "fastscene/base/bytes.h"
#include "fastscene/base/error.h"

namespace fastscene {

GltfJson::GltfJson(const std::string& where, std::string_view text, std::size_t begin) : where_(where), begin_(begin) {
    try {
        json_ = Json::parse(text);
    } catch (const Json::exception& e) {
        throw Error("{}: byte {}: expected JSON, found: {}", where_, begin_, e.what());
    }
}

void GltfJson::refuse(const std::string& what) const { throw Error("{}: JSON at byte {}: {}", where_, begin_, what); }

const Json& GltfJson::list(const Json& owner, const char* name) {
    static const Json none = Json::array();
    const auto found = owner.is_object() ? owner.find(name) : owner.end();
    return found != owner.end() && found->is_array() ? *found : none;
}

const Json* GltfJson::object(const Json& owner, const char* name) {
    if (!owner.is_object()) return nullptr;
    const auto found = owner.find(name);
    return found != owner.end() && found->is_object() ? &*found : nullptr;
}

const Json* GltfJson::extension(const Json& owner, const char* name) {
    const Json* all = object(owner, "extensions");
    if (!all) return nullptr;
    const auto found = all->find(name);
    return found == all->end() ? nullptr : &*found;
}

std::string GltfJson::text(const Json& owner, const char* name, const std::string& otherwise) {
    if (!owner.is_object()) return otherwise;
    const auto found = owner.find(name);
    return found != owner.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

std::string GltfJson::brief(std::string_view text) {
    constexpr std::size_t kMostBytes = 80;
    std::size_t size = std::min(text.size(), kMostBytes);
    const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80; };
    while (size > 0 && size < text.size() && continues(size)) --size;
    std::string out(text.substr(0, size));
    std::replace_if(
        out.begin(), out.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
    return out;
}

std::size_t GltfJson::whole(const Json& owner, const char* name, std::optional<std::size_t> otherwise) const {
    if (!owner.is_object() || !owner.contains(name)) {
        if (otherwise) return *otherwise;
        refuse(fmt::format("expected \"{}\", found none", name));
    }
    const Json& value = owner.at(name);
    if (!value.is_number_unsigned())
        refuse(fmt::format("expected a whole number as \"{}\", found {}", name, value.dump().substr(0, 40)));
    return value.get<std::size_t>();
}

const Json& GltfJson::item(const char* name, std::size_t index) const {
    const Json& items = list(json_, name);
    if (index >= items.size() || !items[index].is_object())
        refuse(fmt::format("expected an object {}[{}], found {} of them", name, index, items.size()));
    return items[index];
}

std::vector<double> GltfJson::numbers(const Json& owner, const char* name, std::vector<double> otherwise,
                                      const char* of) const {
    if (!owner.is_object() || !owner.contains(name)) return otherwise;
    std::vector<double> out;
    for (const Json& v : list(owner, name))
        if (v.is_number()) out.push_back(v.get<double>());
    if (out.size() != otherwise.size())
        refuse(fmt::format("expected {} numbers as \"{}\" of a {}, found {}", otherwise.size(), name, of, out.size()));
    return out;
}

GltfJson::Transform GltfJson::transform_of(const Json& node) const {
    const auto m = numbers(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    const auto r = numbers(node, "rotation", {0, 0, 0, 1}), t = numbers(node, "translation", {0, 0, 0}),
               s = numbers(node, "scale", {1, 1, 1});
    if (node.contains("matrix"))
        return {Mat3d::from_columns({m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}),
                {m[12], m[13], m[14]}};
    const Quatd q{r[3], r[0], r[1], r[2]};
    if (!(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z > 1e-6))
        refuse("expected a unit quaternion as a node's rotation, found zero");
    const Mat3d turn = matrix_of(q);
    return {Mat3d::from_columns(turn.column(0) * s[0], turn.column(1) * s[1], turn.column(2) * s[2]),
            {t[0], t[1], t[2]}};
}

float gltf_component(std::string_view data, std::size_t at, std::size_t component, bool normalized) {
    const auto scaled = [&](auto v, float largest) {
        return normalized ? std::max(static_cast<float>(v) / largest, -1.f) : static_cast<float>(v);
    };
    switch (component) {
        case 5120: return scaled(number_at<std::int8_t>(data, at), 127.f);
        case 5121: return scaled(number_at<std::uint8_t>(data, at), 255.f);
        case 5122: return scaled(number_at<std::int16_t>(data, at), 32767.f);
        case 5123: return scaled(number_at<std::uint16_t>(data, at), 65535.f);
        default: return number_at<float>(data, at);
    }
}

}  // namespace fastscene
