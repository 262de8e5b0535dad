// A TOML table with strict keys: every requested key is checked, and unknown keys are errors. Errors name file, line
// and key.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <vector>

#include "fastscene/base/error.h"

namespace fastscene {

// Throws Error with file and line if the text is not valid TOML.
toml::table parse_toml(std::string_view text, const std::string& file);

class TomlTable {
  public:
    // `where` names the table in errors ("[[scene]]"; empty: the top level); `keys`: all allowed keys.
    TomlTable(const toml::table& table, std::string file, std::string where, const std::vector<std::string>& keys);

    bool has(std::string_view key) const { return table_.contains(key); }
    std::string text(std::string_view key, const std::string& otherwise = "") const;
    // Throws unless it lies in [low, high].
    double number(std::string_view key, double otherwise, double low, double high) const;
    int whole(std::string_view key, int otherwise, int low, int high) const;
    bool flag(std::string_view key, bool otherwise) const;
    std::vector<std::string> texts(std::string_view key) const;
    std::vector<double> numbers(std::string_view key) const;
    std::vector<const toml::table*> tables(std::string_view key) const;  // [[key]]
    const toml::table* table(std::string_view key) const;                // [key], or null

    // The same for required keys; `expected` describes the value in the error.
    std::string needed_text(std::string_view key, const std::string& expected = "a text in quotes") const;
    double needed_number(std::string_view key, double low, double high) const;
    int needed_whole(std::string_view key, int low, int high) const;
    bool needed_flag(std::string_view key) const;
    const toml::table& needed_table(std::string_view key) const;
    // The index among these names.
    std::size_t needed_choice(std::string_view key, std::span<const std::string_view> names) const;
    std::size_t choice_of(std::string_view key, const std::string& word, std::span<const std::string_view> names) const;

    const toml::table& raw() const { return table_; }
    const std::string& file() const { return file_; }

    // "file:line: [[scene]]: key: …"
    [[noreturn]] void fail(std::string_view key, const std::string& text) const;
    // The same, at the line of a list item.
    [[noreturn]] void fail_item(std::string_view key, std::size_t index, const std::string& text) const;
    [[noreturn]] void fail_missing(std::string_view key, const std::string& expected) const;
    std::string place(std::string_view key) const;

  private:
    const toml::node* node(std::string_view key) const { return table_.get(key); }
    const toml::table& table_;
    std::string file_, where_;
};

// A suggestion to end an error message: "; did you mean X?", or the list of all.
std::string meant(const std::string& word, const std::vector<std::string>& known);
// A value formatted as in TOML.
std::string shown(const toml::node& node);

}  // namespace fastscene
