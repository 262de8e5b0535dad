#include "fastscene/io/toml_table.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "fastscene/base/suggest.h"

namespace fastscene {
namespace {

unsigned line_of(const toml::node& node) { return static_cast<unsigned>(node.source().begin.line); }

}  // namespace

std::string meant(const std::string& word, const std::vector<std::string>& known) {
    const std::string guess = nearest_word(word, known);
    return guess.empty() ? fmt::format("; known: {}", fmt::join(known, ", "))
                         : fmt::format("; did you mean {}?", guess);
}

toml::table parse_toml(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& e) {
        throw Error("{}:{}: expected TOML: {}", file, static_cast<unsigned>(e.source().begin.line), e.description());
    }
}

std::string shown(const toml::node& node) {
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    return text.str();
}

TomlTable::TomlTable(const toml::table& table, std::string file, std::string where,
                     const std::vector<std::string>& keys)
    : table_(table), file_(std::move(file)), where_(std::move(where)) {
    for (const auto& [key, value] : table_) {
        const std::string name(key.str());
        if (std::find(keys.begin(), keys.end(), name) == keys.end())
            throw Error("{}:{}: unknown key \"{}\"{}{}", file_, static_cast<unsigned>(key.source().begin.line), name,
                        where_.empty() ? "" : " in " + where_, meant(name, keys));
    }
}

std::string TomlTable::place(std::string_view key) const {
    const toml::node* found = node(key);
    return fmt::format("{}:{}: {}{}", file_, line_of(found ? *found : static_cast<const toml::node&>(table_)),
                       where_.empty() ? "" : where_ + ": ", key);
}
void TomlTable::fail(std::string_view key, const std::string& text) const { throw Error("{}: {}", place(key), text); }
void TomlTable::fail_item(std::string_view key, std::size_t index, const std::string& text) const {
    const toml::array* list = node(key) ? node(key)->as_array() : nullptr;
    if (!list || index >= list->size()) fail(key, text);
    throw Error("{}:{}: {}{}: {}", file_, line_of((*list)[index]), where_.empty() ? "" : where_ + ": ", key, text);
}
void TomlTable::fail_missing(std::string_view key, const std::string& expected) const {
    fail(key, "expected " + expected + ", found none");
}

std::string TomlTable::text(std::string_view key, const std::string& otherwise) const {
    const toml::node* found = node(key);
    if (!found) return otherwise;
    const auto value = found->value_exact<std::string>();
    if (!value) fail(key, "expected a text in quotes, found " + shown(*found));
    return *value;
}

double TomlTable::number(std::string_view key, double otherwise, double low, double high) const {
    const toml::node* found = node(key);
    if (!found) return otherwise;
    if (!found->is_number()) fail(key, "expected a number, found " + shown(*found));
    const auto value = found->value<double>();
    if (!value || !(*value >= low && *value <= high))
        fail(key, fmt::format("expected a number from {} to {}, found {}", low, high, shown(*found)));
    return *value;
}

int TomlTable::whole(std::string_view key, int otherwise, int low, int high) const {
    const double value = number(key, otherwise, low, high);
    if (value != static_cast<int>(value)) fail(key, fmt::format("expected a whole number, found {}", value));
    return static_cast<int>(value);
}

bool TomlTable::flag(std::string_view key, bool otherwise) const {
    const toml::node* found = node(key);
    if (!found) return otherwise;
    const auto value = found->value_exact<bool>();
    if (!value) fail(key, "expected true or false, found " + shown(*found));
    return *value;
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
    std::vector<std::string> out;
    const toml::node* found = node(key);
    if (!found) return out;
    const toml::array* list = found->as_array();
    if (!list) fail(key, "expected a list of texts, found " + shown(*found));
    for (const toml::node& item : *list) {
        const auto value = item.value_exact<std::string>();
        if (!value)
            throw Error("{}:{}: {}: expected a text in quotes, found {}", file_, line_of(item), key, shown(item));
        out.push_back(*value);
    }
    return out;
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
    std::vector<double> out;
    const toml::node* found = node(key);
    if (!found) return out;
    const toml::array* list = found->as_array();
    if (!list) fail(key, "expected a list of numbers, found " + shown(*found));
    for (const toml::node& item : *list) {
        if (!item.is_number())
            throw Error("{}:{}: {}: expected a number, found {}", file_, line_of(item), key, shown(item));
        out.push_back(*item.value<double>());
    }
    return out;
}

std::vector<const toml::table*> TomlTable::tables(std::string_view key) const {
    std::vector<const toml::table*> out;
    const toml::node* found = node(key);
    if (!found) return out;
    const toml::array* list = found->as_array();
    if (!list)
        fail(key, fmt::format("expected [[{}]], found {}", key,
                              found->is_table() ? fmt::format("[{}]", key) : shown(*found)));
    for (const toml::node& item : *list) {
        if (!item.is_table()) fail(key, fmt::format("expected [[{}]], found {}", key, shown(item)));
        out.push_back(item.as_table());
    }
    return out;
}

const toml::table* TomlTable::table(std::string_view key) const {
    const toml::node* found = node(key);
    if (!found) return nullptr;
    if (!found->is_table()) fail(key, fmt::format("expected [{}], found {}", key, shown(*found)));
    return found->as_table();
}

std::string TomlTable::needed_text(std::string_view key, const std::string& expected) const {
    if (!has(key)) fail_missing(key, expected);
    return text(key);
}

double TomlTable::needed_number(std::string_view key, double low, double high) const {
    if (!has(key)) fail_missing(key, fmt::format("a number from {} to {}", low, high));
    return number(key, low, low, high);
}

int TomlTable::needed_whole(std::string_view key, int low, int high) const {
    if (!has(key)) fail_missing(key, fmt::format("a whole number from {} to {}", low, high));
    return whole(key, low, low, high);
}

bool TomlTable::needed_flag(std::string_view key) const {
    if (!has(key)) fail_missing(key, "true or false");
    return flag(key, false);
}

const toml::table& TomlTable::needed_table(std::string_view key) const {
    if (!has(key)) fail_missing(key, fmt::format("[{}]", key));
    return *table(key);
}

std::size_t TomlTable::needed_choice(std::string_view key, std::span<const std::string_view> names) const {
    return choice_of(key, needed_text(key, fmt::format("one of {}", fmt::join(names, ", "))), names);
}

std::size_t TomlTable::choice_of(std::string_view key, const std::string& word,
                                 std::span<const std::string_view> names) const {
    const auto at = std::find(names.begin(), names.end(), word);
    if (at == names.end()) fail(key, fmt::format("expected one of {}, found \"{}\"", fmt::join(names, ", "), word));
    return static_cast<std::size_t>(at - names.begin());
}

}  // namespace fastscene
