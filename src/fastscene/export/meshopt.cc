#include "fastscene/export/meshopt.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/io/glb_container.h"

namespace fastscene {
namespace {

constexpr const char* kExtension = "EXT_meshopt_compression";
constexpr int kShortIndex = 5123;  // component type
// Bits of a number with its sign, by what an attribute means; a vector has one exponent. Other attributes
// are compressed without loss.
const std::map<std::string, int, std::less<>> kBits{{"POSITION", 17}, {"NORMAL", 13}, {"TEXCOORD_0", 17}};

struct Glb {
    Json json;
    std::string binary;
};

Glb parts_of(const std::string& glb) {
    constexpr std::size_t kHeader = 12, kChunk = 8;
    std::uint32_t length = 0;
    if (glb.size() > kHeader + kChunk) std::memcpy(&length, glb.data() + kHeader, sizeof length);
    const std::size_t end = kHeader + kChunk + length;
    if (length == 0 || glb.size() < end + kChunk) throw Error("meshopt: expected a .glb with a binary chunk");
    return {Json::parse(glb.substr(kHeader + kChunk, length)), glb.substr(end + kChunk)};
}

// Which attribute an accessor is ("POSITION"), or "indices".
std::map<std::size_t, std::string> uses_of(const Json& json) {
    std::map<std::size_t, std::string> uses;
    for (const Json& mesh : json.value("meshes", Json::array()))
        for (const Json& primitive : mesh.at("primitives")) {
            for (const auto& [name, accessor] : primitive.at("attributes").items()) uses[accessor] = name;
            if (primitive.contains("indices")) uses[primitive["indices"]] = "indices";
        }
    return uses;
}

std::string encoded_indices(const std::string& raw, std::size_t count, bool shorts) {
    std::vector<unsigned int> indices(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint16_t small = 0;
        if (shorts) std::memcpy(&small, raw.data() + 2 * i, 2), indices[i] = small;
        else std::memcpy(&indices[i], raw.data() + 4 * i, 4);
    }
    const std::size_t vertices = 1 + *std::max_element(indices.begin(), indices.end());
    meshopt_optimizeVertexCache(indices.data(), indices.data(), count, vertices);
    std::string out(meshopt_encodeIndexBufferBound(count, vertices), '\0');
    meshopt_encodeIndexVersion(1);
    out.resize(
        meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), indices.data(), count));
    return out;
}

std::string encoded_vertices(const std::string& raw, std::size_t count, std::size_t stride) {
    std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
    meshopt_encodeVertexVersion(0);  // the one that the extension has
    out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), raw.data(), count,
                                          stride));
    return out;
}

// Rounds to `bits`; the rounded values come back in `decoded`.
std::string filtered(const std::string& raw, std::size_t count, std::size_t stride, int bits,
                     std::vector<float>& decoded) {
    std::vector<float> values(raw.size() / sizeof(float));
    std::memcpy(values.data(), raw.data(), raw.size());
    std::string out(raw.size(), '\0');
    meshopt_encodeFilterExp(out.data(), count, stride, bits, values.data());
    decoded.resize(values.size());
    std::memcpy(decoded.data(), out.data(), out.size());
    meshopt_decodeFilterExp(decoded.data(), count, stride);
    return out;
}

// The format wants the bounds of the values that a reader sees.
void set_bounds(Json& accessor, const std::vector<float>& values, std::size_t components) {
    if (!accessor.contains("min")) return;
    for (std::size_t c = 0; c < components; ++c) {
        float low = values[c], high = values[c];
        for (std::size_t i = c; i < values.size(); i += components)
            low = std::min(low, values[i]), high = std::max(high, values[i]);
        accessor["min"][c] = low, accessor["max"][c] = high;
    }
}

std::size_t components_of(const Json& accessor) {
    const std::string type = accessor.at("type");
    return type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');  // VEC3
}

void append_aligned(std::string& to, const std::string& bytes) {
    to += bytes;
    to.append((4 - to.size() % 4) % 4, '\0');
}

}  // namespace

std::string with_meshopt(const std::string& glb) {
    auto [json, binary] = parts_of(glb);
    std::string packed;
    std::size_t plain_bytes = 0;  // of the buffer that readers decode to
    std::vector<bool> done(json.at("bufferViews").size());
    for (const auto& [index, use] : uses_of(json)) {
        Json& accessor = json.at("accessors").at(index);
        const std::size_t at = accessor.at("bufferView"), count = accessor.at("count");
        Json& view = json["bufferViews"][at];
        if (done[at] || accessor.value("byteOffset", 0) != 0) throw Error("meshopt: expected a view for each accessor");
        done[at] = true;
        const std::string raw = binary.substr(view.at("byteOffset"), view.at("byteLength"));
        const std::size_t stride = raw.size() / count;
        Json how{{"buffer", 0}, {"byteOffset", packed.size()}};
        std::string bytes;
        if (use == "indices") {
            bytes = encoded_indices(raw, count, accessor.at("componentType") == kShortIndex);
            how["mode"] = "TRIANGLES";
        } else {
            std::string values = raw;
            if (const auto bits = kBits.find(use); bits != kBits.end()) {
                std::vector<float> decoded;
                values = filtered(raw, count, stride, bits->second, decoded);
                set_bounds(accessor, decoded, components_of(accessor));
                how["filter"] = "EXPONENTIAL";
            }
            bytes = encoded_vertices(values, count, stride);
            how["mode"] = "ATTRIBUTES";
            view["byteStride"] = stride;
        }
        how.update({{"byteLength", bytes.size()}, {"byteStride", stride}, {"count", count}});
        append_aligned(packed, bytes);
        view["buffer"] = 1, view["byteOffset"] = plain_bytes;
        plain_bytes += (raw.size() + 3) / 4 * 4;
        view["extensions"][kExtension] = std::move(how);
    }
    for (std::size_t at = 0; at < done.size(); ++at) {
        if (done[at]) continue;
        Json& view = json["bufferViews"][at];
        const std::string raw = binary.substr(view.at("byteOffset"), view.at("byteLength"));
        view["byteOffset"] = packed.size();
        append_aligned(packed, raw);
    }
    json["buffers"] = {{{"byteLength", packed.size()}},
                       {{"byteLength", plain_bytes}, {"extensions", {{kExtension, {{"fallback", true}}}}}}};
    for (const char* const list : {"extensionsUsed", "extensionsRequired"}) json[list].push_back(kExtension);
    return glb_bytes(json, packed);
}

}  // namespace fastscene
