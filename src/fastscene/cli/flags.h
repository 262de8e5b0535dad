// Flags derived from fields: each field of visit_fields becomes --<section>-<field> with its description, default and
// type. The given texts are stored and applied to the params later, because their defaults depend on another flag
// (--quality).
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "fastscene/base/fields.h"

namespace fastscene::cli {

// Given flags: full name -> text.
using Given = std::map<std::string, std::string>;

// The field "kind" is the stage's main setting: --walk paper.
inline std::string flag_name(std::string_view section, std::string_view field) {
    if (field == "kind" && !section.empty()) return fmt::format("--{}", section);
    return section.empty() ? fmt::format("--{}", field) : fmt::format("--{}-{}", section, field);
}

// Throws UsageError unless the whole text is a number of this type.
template <class T>
T number_from(const std::string& flag, const std::string& text) {
    T value{};
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (code != std::errc() || stop != end)
        throw UsageError("{}: expected {}, found \"{}\"", flag, std::is_integral_v<T> ? "a whole number" : "a number",
                         text);
    return value;
}

// Adds a flag for each field.
struct AddFlags {
    CLI::App& app;
    std::string section;
    std::shared_ptr<Given> given;
    std::string group;

    template <class T>
    void operator()(std::string_view field, T& value, const Bounds& bounds, std::string_view sentence) {
        add(field, fmt::format("{} ({} to {})", sentence, bounds.low, bounds.high), std::is_integral_v<T> ? "N" : "X")
            ->default_str(fmt::format("{}", value));
    }
    void operator()(std::string_view field, std::string& value, const Choices& choices, std::string_view sentence) {
        add(field, std::string(sentence), fmt::format("{}", fmt::join(choices.names, "|")))->default_str(value);
    }
    void operator()(std::string_view field, std::string& value, std::string_view sentence) {
        add(field, std::string(sentence), "TEXT")->default_str(value);
    }
    void operator()(std::string_view field, bool&, std::string_view sentence) {
        const std::string flag = flag_name(section, field);
        app.add_flag_callback(
               flag, [given = given, flag] { (*given)[flag] = "true"; }, std::string(sentence))
            ->group(group);
    }

  private:
    CLI::Option* add(std::string_view field, const std::string& sentence, const std::string& kind) {
        const std::string flag = flag_name(section, field);
        return app
            .add_option_function<std::string>(
                flag, [given = given, flag](const std::string& text) { (*given)[flag] = text; }, sentence)
            ->type_name(kind)
            ->group(group);
    }
};

// Writes the given texts into the fields. Bounds are checked later (check_fields), all at once.
struct ApplyFlags {
    const Given& given;
    std::string section;

    template <class T, class... Rest>
    void operator()(std::string_view field, T& value, const Rest&...) {
        const std::string flag = flag_name(section, field);
        const auto found = given.find(flag);
        if (found == given.end()) return;
        if constexpr (std::is_same_v<T, bool>) value = true;
        else if constexpr (std::is_same_v<T, std::string>) value = found->second;
        else value = number_from<T>(flag, found->second);
    }
};

template <class Params>
void add_fields(CLI::App& app, const std::string& section, Params defaults, std::shared_ptr<Given> given,
                const std::string& group) {
    visit_fields(defaults, AddFlags{app, section, std::move(given), group});
}
template <class Params>
void apply_fields(const std::string& section, Params& params, const Given& given) {
    visit_fields(params, ApplyFlags{given, section});
}

}  // namespace fastscene::cli
