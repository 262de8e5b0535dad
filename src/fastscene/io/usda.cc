#include "fastscene/io/usda.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace fastscene {
namespace {

constexpr int kIndent = 4;
constexpr int kAngleDecimals = 7, kPlaceDecimals = 5;

float part_of(Vec3f v, std::size_t i) { return v[i]; }
float part_of(Vec2f v, std::size_t i) { return i == 0 ? v.x : v.y; }

template <class V>
void append_tuples(std::string& out, std::span<const V> values, int decimals, std::size_t width) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        out += i ? ", (" : "(";
        for (std::size_t a = 0; a < width; ++a) {
            if (a) out += ", ";
            append_decimals(out, part_of(values[i], a), decimals);
        }
        out += ')';
    }
}

}  // namespace

UsdaWriter::UsdaWriter(std::string_view default_prim, std::string_view about)
    : text_(fmt::format("#usda 1.0\n(\n    defaultPrim = \"{}\"\n    doc = {}\n    metersPerUnit = 1\n"
                        "    upAxis = \"Y\"\n)",
                        default_prim, usda_quoted(about))) {}

void UsdaWriter::begin(std::string_view head, std::string_view name, const std::vector<std::string>& metadata) {
    if (depth_ == 0) text_ += '\n';
    std::string first = fmt::format("{} \"{}\"", head, name);
    if (!metadata.empty()) first += " (";
    line(first);
    ++depth_;
    for (const std::string& entry : metadata) line(entry);
    --depth_;
    if (!metadata.empty()) line(")");
    line("{");
    ++depth_;
}

void UsdaWriter::line(std::string_view text) {
    text_ += '\n';
    text_.append(static_cast<std::size_t>(kIndent * depth_), ' ');
    text_ += text;
}

void UsdaWriter::array(std::string_view declaration, const std::string& values, std::string_view metadata) {
    line(declaration);
    text_ += " = [";
    text_ += values;
    text_ += ']';
    if (!metadata.empty())
        text_ += fmt::format(" (\n{0:{2}}{1}\n{0:{3}})", "", metadata, kIndent * (depth_ + 1), kIndent * depth_);
}

void UsdaWriter::end() {
    --depth_;
    line("}");
}

std::string usda_name(std::string_view name) {
    std::string out;
    for (const char c : name) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        const bool digit = c >= '0' && c <= '9';
        if (digit && out.empty()) out += '_';
        out += letter || digit ? c : '_';
    }
    return out.empty() ? "_" : out;
}

std::string usda_quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c == '\n' || c == '\r' ? ' ' : c;
    }
    return out + '"';
}

std::vector<std::string> usda_pose(const Rigid& pose) {
    const Quatf q = quaternion_of(pose.rotation);
    std::string turn;
    for (const float part : {q.w, q.x, q.y, q.z}) {
        if (!turn.empty()) turn += ", ";
        append_decimals(turn, part, kAngleDecimals);
    }
    return {fmt::format("double3 xformOp:translate = {}", usda_tuple(pose.translation, kPlaceDecimals)),
            fmt::format("quatf xformOp:orient = ({})", turn),
            "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]"};
}

void append_decimals(std::string& out, float value, int decimals) {
    char text[64];
    char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
    if (decimals > 0) {
        while (end[-1] == '0') --end;
        if (end[-1] == '.') --end;
    }
    const std::string_view found(text, static_cast<std::size_t>(end - text));
    out += found == "-0" ? "0" : found;
}

void append_significant(std::string& out, float value, int digits) {
    char text[64];
    const char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
    out.append(text, static_cast<std::size_t>(end - text));
}

std::string usda_list(std::span<const Vec3f> values, int decimals) {
    std::string out;
    append_tuples(out, values, decimals, 3);
    return out;
}
std::string usda_list(std::span<const Vec2f> values, int decimals) {
    std::string out;
    append_tuples(out, values, decimals, 2);
    return out;
}
std::string usda_list(std::span<const std::uint32_t> values) {
    std::string out;
    for (const std::uint32_t v : values) {
        if (!out.empty()) out += ", ";
        out += std::to_string(v);
    }
    return out;
}
std::string usda_tuple(Vec3f value, int decimals) { return usda_list(std::span(&value, 1), decimals); }

}  // namespace fastscene
