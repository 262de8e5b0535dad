// Fields: every setting of a stage is defined once. A params struct has a companion
//
// template <class V> void visit_fields(WalkParams& p, V&& v) {
// v("viewpoints", p.viewpoints, Bounds{0, 64}, "New viewpoints around the first one.");
// }
//
// from which the command-line flag, --help, the settings file, the docs and the cache key are derived.
#pragma once

#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/base/shortest.h"

namespace fastscene {

// A number must lie in [low, high].
struct Bounds {
    double low, high;
};
// A text must be one of these.
struct Choices {
    std::vector<std::string> names;
};

namespace detail {

struct ToJson {
    Json out = Json::object();
    template <class T>
    void operator()(std::string_view name, T& value, const Bounds&, std::string_view) {
        if constexpr (std::is_same_v<T, float>) out[std::string(name)] = shortest(value);
        else out[std::string(name)] = value;
    }
    void operator()(std::string_view name, bool& value, std::string_view) { out[std::string(name)] = value; }
    void operator()(std::string_view name, std::string& value, const Choices&, std::string_view) {
        out[std::string(name)] = value;
    }
    void operator()(std::string_view name, std::string& value, std::string_view) { out[std::string(name)] = value; }
};

struct FromJson {
    const Json& section;
    template <class T, class... Rest>
    void operator()(std::string_view name, T& value, const Rest&...) {
        const auto found = section.find(std::string(name));
        if (found == section.end()) return;
        try {
            value = found->template get<T>();
        } catch (const Json::exception&) {
            throw Error("run.json: params: {}: expected another kind of value, found {}", name, found->dump());
        }
    }
};

struct Check {
    std::string_view section;  // empty: the flag is --<field>
    std::string flag(std::string_view name) const {
        // the stage's main setting: --walk paper
        if (name == "kind" && !section.empty()) return fmt::format("--{}", section);
        return section.empty() ? fmt::format("--{}", name) : fmt::format("--{}-{}", section, name);
    }
    template <class T>
    void operator()(std::string_view name, T& value, const Bounds& bounds, std::string_view) {
        // Written so that NaN fails.
        if (!(static_cast<double>(value) >= bounds.low && static_cast<double>(value) <= bounds.high))
            throw UsageError("{}: expected a number from {} to {}, found {}", flag(name), bounds.low, bounds.high,
                             value);
    }
    void operator()(std::string_view, bool&, std::string_view) {}
    void operator()(std::string_view name, std::string& value, const Choices& choices, std::string_view) {
        for (const std::string& choice : choices.names)
            if (choice == value) return;
        throw UsageError("{}: expected one of {}, found \"{}\"", flag(name), fmt::join(choices.names, ", "), value);
    }
    void operator()(std::string_view, std::string&, std::string_view) {}
};

}  // namespace detail

// All fields by name, in order: stored in run.json and, hashed, in the cache key.
template <class Params>
Json fields_json(Params params) {
    detail::ToJson visitor;
    visit_fields(params, visitor);
    return visitor.out;
}

// Reads the fields present in the JSON; others keep their values. Throws Error for a value of another type.
template <class Params>
void fields_from_json(const Json& json, Params& params) {
    visit_fields(params, detail::FromJson{json});
}

// Throws UsageError naming the flag --<section>-<field> if a value is out of bounds.
template <class Params>
void check_fields(std::string_view section, Params params) {
    visit_fields(params, detail::Check{section});
}

}  // namespace fastscene
