#include "fastscene/io/gltf_meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

namespace fastscene {
namespace {

// The library only asserts what it needs of these numbers.
bool decodable(const MeshoptStream& s) {
    if (s.mode == "ATTRIBUTES") return s.stride > 0 && s.stride <= 256 && s.stride % 4 == 0;
    if (s.mode == "TRIANGLES") return (s.stride == 2 || s.stride == 4) && s.count % 3 == 0;
    return s.mode == "INDICES" && (s.stride == 2 || s.stride == 4);
}

bool filterable(const MeshoptStream& s) {
    if (s.filter == "NONE") return true;
    if (s.mode != "ATTRIBUTES") return false;
    if (s.filter == "OCTAHEDRAL") return s.stride == 4 || s.stride == 8;
    if (s.filter == "QUATERNION") return s.stride == 8;
    return s.filter == "EXPONENTIAL";
}

}  // namespace

std::optional<std::string> meshopt_unpacked(std::string_view packed, const MeshoptStream& s, std::string& reason) {
    if (!decodable(s) || !filterable(s)) {
        reason = fmt::format(
            "expected a mode and a filter of EXT_meshopt_compression, found {} and {} for {} rows of "
            "{} bytes",
            s.mode, s.filter, s.count, s.stride);
        return {};
    }
    std::string out(s.count * s.stride, '\0');
    const auto* bytes = reinterpret_cast<const unsigned char*>(packed.data());
    const int failure = s.mode == "ATTRIBUTES"
                            ? meshopt_decodeVertexBuffer(out.data(), s.count, s.stride, bytes, packed.size())
                        : s.mode == "TRIANGLES"
                            ? meshopt_decodeIndexBuffer(out.data(), s.count, s.stride, bytes, packed.size())
                            : meshopt_decodeIndexSequence(out.data(), s.count, s.stride, bytes, packed.size());
    if (failure != 0) {
        reason = fmt::format(
            "expected {} compressed by meshopt (version 0), found other bytes: save it without "
            "compression",
            s.mode);
        return {};
    }
    if (s.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), s.count, s.stride);
    if (s.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), s.count, s.stride);
    if (s.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), s.count, s.stride);
    return out;
}

}  // namespace fastscene
