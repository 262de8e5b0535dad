// The JSON Schema of room documents, derived from document_fields.h.
#include "fastscene/rooms/document_fields.h"

namespace fastscene {
namespace document_fields {
namespace {

// Named parts of the schema, in the order of their first use.
struct Definitions {
    Json all = Json::object();
};

template <class T>
inline constexpr const char* kDefinition = nullptr;
template <>
inline constexpr const char* kDefinition<Opening> = "opening";
template <>
inline constexpr const char* kDefinition<Block> = "block";
template <>
inline constexpr const char* kDefinition<Platform> = "platform";
template <>
inline constexpr const char* kDefinition<Skylight> = "skylight";
template <>
inline constexpr const char* kDefinition<Material> = "material";
template <>
inline constexpr const char* kDefinition<PromptObject> = "wish";
template <>
inline constexpr const char* kDefinition<DocumentThing> = "thing";
template <>
inline constexpr const char* kDefinition<DocumentPlan> = "plan";
template <>
inline constexpr const char* kDefinition<DocumentSurfaces> = "surfaces";
template <>
inline constexpr const char* kDefinition<DocumentLight> = "light";
template <>
inline constexpr const char* kDefinition<DocumentCamera> = "camera";
template <>
inline constexpr const char* kDefinition<DocumentNextRoom> = "next_room";

Json number_schema(const Rule& rule) { return {{"type", "number"}, {"minimum", rule.low}, {"maximum", rule.high}}; }
Json list_schema(Json items, std::size_t count) {
    return {{"type", "array"}, {"items", std::move(items)}, {"minItems", count}, {"maxItems", count}};
}

Json schema_of(const float&, const Rule& rule, Definitions&) { return number_schema(rule); }
Json schema_of(const bool&, const Rule&, Definitions&) { return {{"type", "boolean"}}; }
template <class T>
requires(std::is_same_v<T, int> || std::is_same_v<T, std::uint32_t>) Json
    schema_of(const T&, const Rule& rule, Definitions&) {
    Json out = number_schema(rule);
    out["type"] = "integer";
    return out;
}
Json schema_of(const std::uint64_t&, const Rule&, Definitions&) {
    return {{"anyOf", Json::array({Json{{"type", "integer"}, {"minimum", 0}},
                                   Json{{"type", "string"}, {"pattern", "^0x[0-9a-f]{1,16}$"}}})}};
}
Json schema_of(const std::string&, const Rule& rule, Definitions&) {
    Json out{{"type", "string"}};
    if (rule.names.empty()) return out;
    out["enum"] = rule.names;
    out["enum"].push_back("");
    return out;
}
template <class T>
requires std::is_enum_v<T> Json schema_of(const T&, const Rule&, Definitions&) { return {{"enum", kNamesOf<T>}}; }
Json schema_of(const Vec2f&, const Rule& rule, Definitions&) { return list_schema(number_schema(rule), 2); }
Json schema_of(const Vec3f&, const Rule& rule, Definitions&) {
    Json three = list_schema(number_schema(rule), 3);
    if (!rule.color) return three;
    return {{"anyOf", Json::array({three, Json{{"type", "string"}}})}};
}
Json schema_of(const Rigid&, const Rule&, Definitions&) { return list_schema(list_schema({{"type", "number"}}, 4), 4); }
template <class T>
requires std::is_class_v<T> Json schema_of(const T&, const Rule&, Definitions& definitions);
template <class T>
Json schema_of(const std::vector<T>&, const Rule& rule, Definitions& definitions) {
    return {{"type", "array"}, {"items", schema_of(T{}, rule, definitions)}};
}
template <class T>
Json schema_of(const std::optional<T>&, const Rule& rule, Definitions& definitions) {
    return schema_of(T{}, rule, definitions);
}

struct Describe {
    Json &properties, &needed;
    Definitions& definitions;
    template <class T>
    void operator()(std::string_view key, T& value, const Rule& rule, std::string_view sentence) const {
        Json schema = schema_of(value, rule, definitions);
        schema["description"] = sentence;
        properties[std::string(key)] = std::move(schema);
        if (rule.needed) needed.push_back(key);
    }
};

template <class T>
Json object_schema(T value, Definitions& definitions) {
    Json properties = Json::object(), needed = Json::array();
    visit_fields(value, Describe{properties, needed, definitions});
    Json out{{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
    if (!needed.empty()) out["required"] = std::move(needed);
    return out;
}

template <class T>
requires std::is_class_v<T> Json schema_of(const T&, const Rule&, Definitions& definitions) {
    const char* name = kDefinition<T>;
    if (!definitions.all.contains(name)) {
        definitions.all[name] = nullptr;  // keeps its place
        definitions.all[name] = object_schema(T{}, definitions);
    }
    const Json reference{{"$ref", std::string("#/$defs/") + name}};
    if constexpr (std::is_same_v<T, Material>) return {{"anyOf", Json::array({reference, Json{{"type", "string"}}})}};
    return reference;
}

}  // namespace
}  // namespace document_fields

Json document_schema() {
    using namespace document_fields;
    Definitions definitions;
    Json room = object_schema(RoomDocument{}, definitions);
    Json properties{{"format", {{"const", kRoomFormat}}}, {"version", {{"const", kRoomVersion}}}};
    properties.update(room["properties"]);
    for (const Derived& derived : kDerived)
        properties[std::string(derived.key)] = {{"description", std::string(derived.sentence) + " Not read."}};
    Json needed = Json::array({"format", "version"});
    for (const Json& key : room["required"]) needed.push_back(key);
    return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "A room of fastscene"},
            {"description", "Format fastscene-room, version 1: all that is needed to build a furnished room again."},
            {"type", "object"},
            {"additionalProperties", false},
            {"required", std::move(needed)},
            {"properties", std::move(properties)},
            {"$defs", std::move(definitions.all)}};
}

}  // namespace fastscene
