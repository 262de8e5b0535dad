#include "fastscene/io/gpano.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <pugixml.hpp>

namespace fastscene {
namespace {

constexpr std::string_view kNamespace = "http://ns.google.com/photos/1.0/panorama/";
constexpr std::size_t kLongestPacket = 1 << 20;
constexpr int kDeepest = 32;

// XMP is plain XML, wherever a format keeps it.
std::string_view packet_in(std::string_view file) {
    for (const auto& [begin, end] :
         {std::pair<std::string_view, std::string_view>{"<x:xmpmeta", "</x:xmpmeta>"}, {"<rdf:RDF", "</rdf:RDF>"}}) {
        const std::size_t from = file.find(begin);
        if (from == std::string_view::npos) continue;
        const std::size_t to = file.substr(from, kLongestPacket).find(end);
        if (to != std::string_view::npos) return file.substr(from, to + end.size());
    }
    return {};
}

using Values = std::map<std::string, std::string, std::less<>>;

// All values in the namespace, whatever its prefix; nodes know the prefixes of those around them.
void collect(const pugi::xml_node& node, std::string prefix, int depth, Values& out) {
    if (depth > kDeepest) return;
    for (const pugi::xml_attribute a : node.attributes())
        if (kNamespace == a.value() && std::string_view(a.name()).starts_with("xmlns:"))
            prefix = std::string(a.name()).substr(6) + ":";
    const auto own = [&](std::string_view name) {
        return !prefix.empty() && name.starts_with(prefix) ? std::string(name.substr(prefix.size())) : std::string();
    };
    for (const pugi::xml_attribute a : node.attributes())
        if (const std::string name = own(a.name()); !name.empty()) out.emplace(name, a.value());
    if (const std::string name = own(node.name()); !name.empty()) out.emplace(name, node.child_value());
    for (const pugi::xml_node child : node.children()) collect(child, prefix, depth + 1, out);
}

std::optional<double> number_in(const Values& values, std::string_view name) {
    const auto found = values.find(name);
    if (found == values.end()) return {};
    char* end = nullptr;
    const double value = std::strtod(found->second.c_str(), &end);
    return end != found->second.c_str() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<GPano> gpano_of(std::string_view file) {
    const std::string_view packet = packet_in(file);
    pugi::xml_document document;
    if (packet.empty() || !document.load_buffer(packet.data(), packet.size())) return {};
    Values values;
    collect(document, "", 0, values);
    if (values.empty()) return {};
    GPano out;
    if (const auto found = values.find("ProjectionType"); found != values.end()) out.projection = found->second;
    out.full_width = number_in(values, "FullPanoWidthPixels");
    out.full_height = number_in(values, "FullPanoHeightPixels");
    out.left = number_in(values, "CroppedAreaLeftPixels");
    out.top = number_in(values, "CroppedAreaTopPixels");
    out.cropped_width = number_in(values, "CroppedAreaImageWidthPixels");
    out.cropped_height = number_in(values, "CroppedAreaImageHeightPixels");
    out.pitch_deg = number_in(values, "PosePitchDegrees").value_or(0);
    out.roll_deg = number_in(values, "PoseRollDegrees").value_or(0);
    return out;
}

}  // namespace fastscene
