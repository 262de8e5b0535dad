// The reader and the writer of room documents, derived from document_fields.h.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "fastscene/base/file.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/base/shortest.h"
#include "fastscene/base/suggest.h"
#include "fastscene/image/color.h"
#include "fastscene/rooms/document_fields.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene {
namespace document_fields {
namespace {

// ---- where a value stands in the text

// Walks through JSON that is known to be sound, and tells the line of a value.
class LineFinder {
  public:
    LineFinder(std::string_view text, std::string wanted) : text_(text), wanted_(std::move(wanted)) {}
    // 0: there is no such value.
    int line() {
        value("");
        return found_;
    }

  private:
    void spaces() {
        for (; at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos; ++at_)
            line_ += text_[at_] == '\n';
    }
    std::string string() {
        const std::size_t begin = ++at_;
        for (; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\';
        std::string out(text_.substr(begin, at_ - begin));
        ++at_;
        return out;
    }
    void value(const std::string& pointer) {
        spaces();
        if (pointer == wanted_ && found_ == 0) found_ = line_;
        if (at_ >= text_.size() || found_ != 0) return;
        if (text_[at_] == '"') {
            string();
        } else if (text_[at_] == '{' || text_[at_] == '[') {
            members(pointer, text_[at_] == '{');
        } else {
            while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == std::string_view::npos)
                ++at_;
        }
    }
    void members(const std::string& pointer, bool object) {
        ++at_;
        for (std::size_t i = 0; found_ == 0; ++i) {
            spaces();
            if (at_ >= text_.size() || text_[at_] == '}' || text_[at_] == ']') break;
            std::string key = std::to_string(i);
            if (object) {
                key = string();
                if (pointer + "/" + key == wanted_) found_ = line_;
                spaces();
                ++at_;  // the colon
            }
            value(pointer + "/" + key);
            spaces();
            if (at_ < text_.size() && text_[at_] == ',') ++at_;
        }
        ++at_;
    }

    std::string_view text_;
    std::string wanted_;
    std::size_t at_ = 0;
    int line_ = 1, found_ = 0;
};

// ---- the writer

Json written(float value, const Rule& rule) {
    if (!rule.degrees) return shortest(value);
    // The fewest digits that give the same radians again.
    const double exact = static_cast<double>(value) * 180 / static_cast<double>(kPi);
    for (int digits = 1; digits <= 17; ++digits) {
        const double degrees = *number_in(fmt::format("{:.{}g}", exact, digits));
        if (radians_of(degrees) == value) return degrees;
    }
    return exact;
}
Json written(bool value, const Rule&) { return value; }
Json written(int value, const Rule&) { return value; }
Json written(std::uint32_t value, const Rule&) { return value; }
// Larger numbers than a double holds are texts: JavaScript would round them.
Json written(std::uint64_t value, const Rule&) {
    constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
    return value < kExact ? Json(value) : Json(fmt::format("0x{:016x}", value));
}
Json written(const std::string& value, const Rule&) { return value; }
Json written(Vec2f v, const Rule& rule) { return {written(v.x, rule), written(v.y, rule)}; }
Json written(Vec3f v, const Rule& rule) { return {written(v.x, rule), written(v.y, rule), written(v.z, rule)}; }
Json written(const Rigid& pose, const Rule&) { return json_from_pose(pose); }
template <class T>
requires std::is_enum_v<T> Json written(T value, const Rule&) { return kNamesOf<T>[static_cast<std::size_t>(value)]; }
template <class T>
requires std::is_class_v<T> Json written(const T& value, const Rule& rule);
template <class T>
Json written(const std::vector<T>& values, const Rule& rule) {
    Json out = Json::array();
    for (const T& value : values) out.push_back(written(value, rule));
    return out;
}
template <class T>
Json written(const std::optional<T>& value, const Rule& rule) {
    return value ? written(*value, rule) : Json(nullptr);
}

struct Write {
    Json& out;
    template <class T>
    void operator()(std::string_view key, T& value, const Rule& rule, std::string_view) const {
        out[std::string(key)] = written(value, rule);
    }
};
struct DropUsual {
    Json& out;
    const Json& usual;
    template <class T>
    void operator()(std::string_view key, T&, const Rule& rule, std::string_view) const {
        const std::string name(key);
        if (!rule.always && out[name] == usual.at(name)) out.erase(name);
    }
};
template <class T>
requires std::is_class_v<T> Json written(const T& given, const Rule&) {
    T value = given, usual{};
    Json out = Json::object(), nothing = Json::object();
    visit_fields(value, Write{out});
    visit_fields(usual, Write{nothing});
    visit_fields(value, DropUsual{out, nothing});
    return out;
}

// ---- the reader

struct Source {
    std::string_view text;
    std::string file;
};

class Read {
  public:
    Read(const Source& source, const Json& object, std::string pointer)
        : source_(source), object_(object), pointer_(std::move(pointer)) {
        if (!object.is_object()) fail(pointer_, "an object", object);
    }

    template <class T>
    void operator()(std::string_view key, T& value, const Rule& rule, std::string_view) {
        known_.emplace_back(key);
        const auto found = object_.find(std::string(key));
        if (found != object_.end()) return take(*found, pointer_ + "/" + std::string(key), value, rule);
        if (rule.needed) throw Error("{}: expected \"{}\", found none", place(pointer_), key);
    }
    // Every key must have been asked for.
    void check_keys() const {
        for (const auto& [key, value] : object_.items()) {
            if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
            const std::string near = nearest_word(key, known_);
            throw Error("{}: unknown key \"{}\"{}", place(pointer_ + "/" + key), key,
                        near.empty() ? fmt::format("; known are {}", fmt::join(known_, ", "))
                                     : fmt::format("; did you mean \"{}\"?", near));
        }
    }
    void know(std::string_view key) { known_.emplace_back(key); }

  private:
    std::string place(const std::string& pointer) const { return place_in(source_.text, source_.file, pointer); }
    [[noreturn]] void fail(const std::string& pointer, const std::string& expected, const Json& found) const {
        std::string text = found.dump();
        constexpr std::size_t kShown = 60;
        if (text.size() > kShown) text = text.substr(0, kShown) + "…";
        throw Error("{}: expected {}, found {}", place(pointer), expected, text);
    }
    double number(const Json& json, const std::string& pointer, double low, double high) const {
        if (json.is_number())
            if (const double x = json.get<double>(); x >= low && x <= high) return x;
        fail(pointer, fmt::format("a number from {} to {}", low, high), json);
    }

    void take(const Json& json, const std::string& at, float& value, const Rule& rule) const {
        const double x = number(json, at, rule.low, rule.high);
        value = rule.degrees ? radians_of(x) : static_cast<float>(x);
    }
    void take(const Json& json, const std::string& at, bool& value, const Rule&) const {
        if (!json.is_boolean()) fail(at, "true or false", json);
        value = json.get<bool>();
    }
    template <class T>
    requires(std::is_same_v<T, int> || std::is_same_v<T, std::uint32_t>) void take(const Json& json,
                                                                                   const std::string& at, T& value,
                                                                                   const Rule& rule) const {
        const double x = number(json, at, rule.low, rule.high);
        if (std::floor(x) != x) fail(at, "a whole number", json);
        value = static_cast<T>(x);
    }
    void take(const Json& json, const std::string& at, std::uint64_t& value, const Rule&) const {
        if (json.is_number_unsigned()) {
            value = json.get<std::uint64_t>();
            return;
        }
        const std::string text = json.is_string() ? json.get<std::string>() : std::string();
        const char* end = text.data() + text.size();
        if (text.starts_with("0x") && text.size() > 2)
            if (const auto [stop, code] = std::from_chars(text.data() + 2, end, value, 16);
                code == std::errc() && stop == end)
                return;
        fail(at, "a whole number, or a text such as \"0x1f\"", json);
    }
    void take(const Json& json, const std::string& at, std::string& value, const Rule& rule) const {
        if (!json.is_string()) fail(at, "a text", json);
        value = json.get<std::string>();
        if (rule.names.empty() || value.empty()) return;
        choose(json, at, rule.names);
    }
    template <class T>
    requires std::is_enum_v<T>
    void take(const Json& json, const std::string& at, T& value, const Rule&) const {
        const auto& names = kNamesOf<T>;
        value = static_cast<T>(choose(json, at, {names.begin(), names.end()}));
    }
    std::size_t choose(const Json& json, const std::string& at, const std::vector<std::string_view>& names) const {
        const auto found = json.is_string() ? std::find(names.begin(), names.end(), json.get<std::string>())
                                            : names.end();
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
        fail(at, fmt::format("one of {}", fmt::join(names, ", ")), json);
    }
    void numbers(const Json& json, const std::string& at, float* out, std::size_t count, const Rule& rule) const {
        if (!json.is_array() || json.size() != count) fail(at, fmt::format("{} numbers", count), json);
        for (std::size_t i = 0; i < count; ++i) take(json[i], at + "/" + std::to_string(i), out[i], rule);
    }
    void take(const Json& json, const std::string& at, Vec2f& v, const Rule& rule) const {
        float x[2];
        numbers(json, at, x, 2, rule);
        v = {x[0], x[1]};
    }
    void take(const Json& json, const std::string& at, Vec3f& v, const Rule& rule) const {
        if (rule.color && json.is_string()) {
            const auto color = color_said(json.get<std::string>());
            if (!color) fail(at, "a known color, #rrggbb or three numbers", json);
            v = *color;
            return;
        }
        float x[3];
        numbers(json, at, x, 3, rule);
        v = {x[0], x[1], x[2]};
    }
    void take(const Json& json, const std::string& at, Rigid& pose, const Rule&) const {
        try {
            pose = pose_from_json(json);
        } catch (const Json::exception&) {
            fail(at, "four rows of four numbers", json);
        }
    }
    // Also by name: "oak", "sage".
    void take(const Json& json, const std::string& at, Material& m, const Rule&) const {
        if (!json.is_string()) return fields(json, at, m);
        const auto named = surface_named(json.get<std::string>());
        if (!named) fail(at, "a material's fields, or a material or a color by name", json);
        m = *named;
        // Wood comes as boards; bare grain is for furniture.
        constexpr float kBoard = 0.12f;  // metres
        if (m.pattern == Pattern::wood && (at.ends_with("/floor") || at.ends_with("wall")))
            m.pattern = Pattern::planks, m.scale_m = kBoard;
    }
    template <class T>
    requires std::is_class_v<T>
    void take(const Json& json, const std::string& at, T& value, const Rule&) const { fields(json, at, value); }
    template <class T>
    void take(const Json& json, const std::string& at, std::vector<T>& values, const Rule& rule) const {
        if (!json.is_array()) fail(at, "a list", json);
        values.assign(json.size(), T{});
        for (std::size_t i = 0; i < json.size(); ++i) take(json[i], at + "/" + std::to_string(i), values[i], rule);
    }
    template <class T>
    void take(const Json& json, const std::string& at, std::optional<T>& value, const Rule& rule) const {
        value.emplace();
        take(json, at, *value, rule);
    }
    template <class T>
    void fields(const Json& json, const std::string& at, T& value) const {
        Read inner(source_, json, at);
        visit_fields(value, inner);
        inner.check_keys();
    }

    const Source& source_;
    const Json& object_;
    std::string pointer_;
    std::vector<std::string> known_;
};

}  // namespace

std::string place_in(std::string_view text, const std::string& file, const std::string& pointer) {
    const int line = text.empty() ? 0 : LineFinder(text, pointer).line();
    const std::string where = pointer.empty() ? "" : ": " + pointer;
    return line > 0 ? fmt::format("{}:{}{}", file, line, where) : file + where;
}

Json material_json(const Material& material) { return written(material, Rule{}); }

float radians_of(double degrees) { return static_cast<float>(degrees * static_cast<double>(kPi) / 180); }

std::optional<Vec3f> color_said(const std::string& text) {
    if (text.size() == 7 && text[0] == '#') {
        std::uint32_t rgb = 0;
        const auto [end, code] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
        if (code != std::errc() || end != text.data() + 7) return {};
        return linear_from_srgb8({static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
                                  static_cast<std::uint8_t>(rgb)});
    }
    return color_named(plain_name(text));
}

}  // namespace document_fields

Json document_json(const RoomDocument& document) {
    Json out{{"format", kRoomFormat}, {"version", kRoomVersion}};
    out.update(document_fields::written(document, document_fields::Rule{}));
    return out;
}

RoomDocument read_document(std::string_view text, const std::string& file) {
    using namespace document_fields;
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& e) {
        const std::string_view before = text.substr(0, std::min(text.size(), e.byte));
        throw Error("{}:{}: expected JSON: {}", file, 1 + std::count(before.begin(), before.end(), '\n'), e.what());
    } catch (const Json::out_of_range&) {
        throw Error("{}: expected numbers that a computer can hold, found one far too large (1e400)", file);
    }
    const Source source{text, file};
    Read read(source, json, "");
    std::string format;
    int version = 0;
    read("format", format, Rule{.needed = true}, "");
    if (format != kRoomFormat)
        throw Error("{}: expected \"{}\", found \"{}\"", place_in(text, file, "/format"), kRoomFormat, format);
    read("version", version, Rule{.low = 1, .high = 1e6, .needed = true}, "");
    if (version > kRoomVersion)
        throw Error("{}: expected version {}, found {}: a newer fastscene wrote it", place_in(text, file, "/version"),
                    kRoomVersion, version);
    RoomDocument document;
    visit_fields(document, read);
    for (const Derived& derived : kDerived) read.know(derived.key);
    read.check_keys();
    return document;
}

RoomDocument load_document(const std::filesystem::path& file) { return read_document(read_file(file), file.string()); }

}  // namespace fastscene
