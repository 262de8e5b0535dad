#include "fastscene/io/gltf_document.h"

#include <algorithm>
#include <cctype>

#include "fastscene/base/base64.h"
#include "fastscene/base/bytes.h"
#include "fastscene/base/error.h"
#include "fastscene/io/gltf_meshopt.h"

namespace fastscene {
namespace {

constexpr std::size_t kByteComponent = 5121, kShortComponent = 5123, kLongComponent = 5125, kFloatComponent = 5126;

std::size_t component_bytes(std::size_t component) {
    return component == kFloatComponent || component == kLongComponent ? 4 : component >= 5122 ? 2 : 1;
}

std::uint32_t index_at(std::string_view data, std::size_t at, std::size_t component) {
    switch (component) {
        case kByteComponent: return number_at<std::uint8_t>(data, at);
        case kShortComponent: return number_at<std::uint16_t>(data, at);
        default: return number_at<std::uint32_t>(data, at);
    }
}

// A .gltf is JSON without chunks around it.
GlbChunks chunks_of(const std::string& where, std::string_view bytes) {
    if (bytes.starts_with("glTF")) return glb_chunks(where, bytes);
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    const std::size_t mark = bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n", mark);
    if (begin == std::string_view::npos || bytes[begin] != '{')
        throw Error("{}: expected a glTF model (.glb, or .gltf: JSON), found something else", where);
    return {bytes.substr(begin), {}, begin};
}

std::string percent_decoded(const std::string& text) {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int high = text[i] == '%' && i + 2 < text.size() ? digit(text[i + 1]) : -1;
        const int low = high >= 0 ? digit(text[i + 2]) : -1;
        if (low >= 0) out += static_cast<char>(high * 16 + low), i += 2;
        else out += text[i];
    }
    return out;
}

// Whether a name stays in the folder that it is relative to.
bool stays_inside(const std::string& name) {
    if (name.empty() || name.front() == '/' || name.find_first_of(std::string_view(":\0", 2)) != std::string::npos)
        return false;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        if (name.substr(begin, end - begin) == "..") return false;
        begin = end + 1;
    }
    return true;
}

}  // namespace

std::optional<std::pair<std::string_view, std::size_t>> GltfAccessor::row(std::size_t i) const {
    if (replaced_ > 0) {
        std::size_t low = 0, high = replaced_;
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            const std::size_t at = index_at(indices_.data, indices_.first + middle * indices_.stride, index_component_);
            if (at == i) return std::pair(values_.data, values_.first + middle * values_.stride);
            if (at < i) low = middle + 1;
            else high = middle;
        }
    }
    if (rows_.none) return {};
    return std::pair(rows_.data, rows_.first + i * rows_.stride);
}

float GltfAccessor::at(std::size_t i, std::size_t c) const {
    const auto found = row(i);
    return found
               ? gltf_component(found->first, found->second + c * component_bytes(component_), component_, normalized_)
               : 0.f;
}

std::uint32_t GltfAccessor::whole(std::size_t i) const {
    const auto found = row(i);
    return found ? index_at(found->first, found->second, component_) : 0;
}

GltfDocument::GltfDocument(const std::string& where, std::string_view bytes, const ReadGltfSibling& read_sibling)
    : GltfDocument(where, chunks_of(where, bytes), bytes.size(), read_sibling) {}

GltfDocument::GltfDocument(const std::string& where, const GlbChunks& chunks, std::size_t size,
                           const ReadGltfSibling& read_sibling)
    : GltfJson(where, chunks.json, chunks.json_at), binary_(chunks.binary), bytes_(size), read_sibling_(read_sibling) {}

std::optional<std::string> GltfDocument::content(const std::string& uri) const {
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(',');
        if (comma == std::string::npos) refuse("expected data after \"data:\" in a URI, found none");
        const std::string_view rest = std::string_view(uri).substr(comma + 1);
        if (!std::string_view(uri).substr(0, comma).ends_with(";base64")) return percent_decoded(std::string(rest));
        std::optional<std::string> data = from_base64(rest);
        if (!data) refuse("expected base64 in a data URI, found other characters");
        return data;
    }
    std::string name = percent_decoded(uri);
    std::replace(name.begin(), name.end(), '\\', '/');
    if (!stays_inside(name))
        refuse(fmt::format("expected a URI of data or of a file in the model's folder, found \"{}\"", brief(uri)));
    return read_sibling_(name);
}

std::string_view GltfDocument::buffer(std::size_t index) {
    const Json& owner = item("buffers", index);
    const std::size_t length = whole(owner, "byteLength");
    std::string_view bytes = binary_;
    if (const std::string uri = text(owner, "uri"); !uri.empty()) {
        auto file = files_.find(uri);
        if (file == files_.end()) {
            std::optional<std::string> content = this->content(uri);
            if (!content) refuse(fmt::format("buffers[{}]: expected a file {}, found none", index, brief(uri)));
            file = files_.emplace(uri, std::move(*content)).first;
            bytes_ += file->second.size();
        }
        bytes = file->second;
    } else if (index > 0) {
        refuse(fmt::format("buffers[{}]: expected a \"uri\", found none", index));
    }
    if (length > bytes.size())
        refuse(fmt::format("buffers[{}]: expected {} bytes, found {}", index, length, bytes.size()));
    return bytes.substr(0, length);
}

std::string_view GltfDocument::part(const Json& owner, std::size_t index, std::size_t otherwise_begin) {
    const std::string_view bytes = buffer(index);
    const std::size_t begin = whole(owner, "byteOffset", otherwise_begin), length = whole(owner, "byteLength");
    if (begin > bytes.size() || length > bytes.size() - begin)
        refuse(fmt::format("expected {} bytes from byte {} of buffers[{}], found {} in all", length, begin, index,
                           bytes.size()));
    return bytes.substr(begin, length);
}

std::string_view GltfDocument::view(std::size_t index) {
    const Json& owner = item("bufferViews", index);
    for (const char* packed : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (const Json* how = extension(owner, packed)) return unpacked(index, *how);
    return part(owner, whole(owner, "buffer"), 0);
}

std::string_view GltfDocument::unpacked(std::size_t index, const Json& how) {
    if (const auto known = unpacked_.find(index); known != unpacked_.end()) return known->second;
    const std::string_view packed = part(how, whole(how, "buffer"), 0);
    const MeshoptStream stream{brief(text(how, "mode")), brief(text(how, "filter", "NONE")), whole(how, "count"),
                               whole(how, "byteStride")};
    // A byte holds 64 at most; views may share bytes.
    constexpr std::size_t kMostBytesPerByte = 64;
    const std::size_t most = kMostBytesPerByte * bytes_ - std::min(unpacked_bytes_, kMostBytesPerByte * bytes_);
    if (stream.stride > 0 && stream.count > most / stream.stride)
        refuse(fmt::format("bufferViews[{}]: expected at most {} bytes once unpacked, found {} rows of {}", index, most,
                           stream.count, stream.stride));
    std::string reason;
    std::optional<std::string> bytes = meshopt_unpacked(packed, stream, reason);
    if (!bytes) refuse(fmt::format("bufferViews[{}]: {}", index, reason));
    unpacked_bytes_ += bytes->size();
    return unpacked_.emplace(index, std::move(*bytes)).first->second;
}

const GltfAccessor& GltfDocument::accessor(std::size_t index, const char* use, const std::vector<std::size_t>& widths) {
    auto found = accessors_.find(index);
    if (found == accessors_.end())
        found = accessors_.emplace(index, made(item("accessors", index), fmt::format("accessors[{}]", index))).first;
    const GltfAccessor& accessor = found->second;
    if (std::find(widths.begin(), widths.end(), accessor.width_) == widths.end())
        refuse(fmt::format("{}: expected {} numbers in a row, found {} in accessors[{}]", use,
                           fmt::join(widths, " or "), accessor.width_, index));
    const bool is_index = std::string_view(use) == "indices";
    const std::size_t component = accessor.component_;
    const bool fits = is_index
                          ? component == kByteComponent || component == kShortComponent || component == kLongComponent
                          : component != kLongComponent;
    if (!fits)
        refuse(fmt::format("{}: expected {}, found component type {} in accessors[{}]", use,
                           is_index ? "whole numbers without a sign" : "floats, bytes or shorts", component, index));
    return accessor;
}

GltfAccessor GltfDocument::made(const Json& of, const std::string& use) {
    GltfAccessor accessor;
    const std::string type = text(of, "type");
    accessor.width_ = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
    if (accessor.width_ == 0) refuse(fmt::format("{}: expected a scalar or vector, found \"{}\"", use, brief(type)));
    accessor.component_ = whole(of, "componentType");
    if (accessor.component_ < 5120 || accessor.component_ > kFloatComponent || accessor.component_ == 5124)
        refuse(fmt::format("{}: expected a component type of glTF, found {}", use, accessor.component_));
    accessor.count_ = whole(of, "count");
    const auto normalized = of.find("normalized");
    accessor.normalized_ = accessor.component_ < kLongComponent && normalized != of.end() && *normalized == true;
    const std::size_t row = component_bytes(accessor.component_) * accessor.width_;
    if (of.contains("bufferView")) accessor.rows_ = rows(of, accessor.count_, row, use);
    else if (accessor.count_ > bytes_)  // zeros cost nothing in the file
        refuse(fmt::format("{}: expected a buffer view for {} rows, found none", use, accessor.count_));
    if (const Json* sparse = object(of, "sparse")) add_sparse(accessor, *sparse, use);
    return accessor;
}

GltfAccessor::Rows GltfDocument::rows(const Json& owner, std::size_t count, std::size_t row, const std::string& use) {
    const std::size_t at = whole(owner, "bufferView");
    GltfAccessor::Rows out;
    out.none = false;
    out.data = view(at);
    out.first = whole(owner, "byteOffset", 0);
    out.stride = whole(item("bufferViews", at), "byteStride", row);
    const std::size_t length = out.data.size();
    if (count > 0 && (out.stride < row || out.first > length || length - out.first < row ||
                      count - 1 > (length - out.first - row) / out.stride))
        refuse(
            fmt::format("{}: expected {} rows of {} bytes, {} bytes apart from byte {}, found {} bytes in "
                        "bufferViews[{}]",
                        use, count, row, out.stride, out.first, length, at));
    return out;
}

void GltfDocument::add_sparse(GltfAccessor& accessor, const Json& sparse, const std::string& use) {
    const Json *indices = object(sparse, "indices"), *values = object(sparse, "values");
    if (!indices || !values) refuse(fmt::format("{}: expected sparse indices and values, found none", use));
    accessor.replaced_ = whole(sparse, "count");
    const std::size_t component = accessor.index_component_ = whole(*indices, "componentType");
    if (component != kByteComponent && component != kShortComponent && component != kLongComponent)
        refuse(fmt::format("{}: expected sparse indices without a sign, found component type {}", use, component));
    accessor.indices_ = rows(*indices, accessor.replaced_, component_bytes(component), use + " (sparse indices)");
    accessor.values_ = rows(*values, accessor.replaced_, component_bytes(accessor.component_) * accessor.width_,
                            use + " (sparse values)");
    std::size_t least = 0;
    for (std::size_t i = 0; i < accessor.replaced_; ++i) {
        const std::size_t at = index_at(accessor.indices_.data, accessor.indices_.first + i * accessor.indices_.stride,
                                        component);
        if (at < least || at >= accessor.count_)
            refuse(fmt::format("{}: expected growing sparse indices below {}, found {}", use, accessor.count_, at));
        least = at + 1;
    }
}

}  // namespace fastscene
