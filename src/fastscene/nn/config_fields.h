// Reads a model folder's config.json with validation: errors name file and key. Private to nn/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"

namespace fastscene::nn {

// A JSON value that must be present or, with a default, may be absent or null.
class ConfigFields {
  public:
    ConfigFields(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
        if (!json.is_object()) throw Error("{}: expected an object, found {}", where_, json.type_name());
    }
    const Json* find(const char* key) const {
        const auto found = json_.find(key);
        return found == json_.end() || found->is_null() ? nullptr : &*found;
    }
    std::int64_t whole(const char* key, std::int64_t fallback) const {
        const Json* v = find(key);
        if (!v) return fallback;
        if (!v->is_number_integer()) throw wrong(key, "a whole number", *v);
        const auto value = v->get<std::int64_t>();
        if (value < 0 || value > 1 << 20) throw wrong(key, "a number from 0 to 1048576", *v);
        return value;
    }
    double number(const char* key, double fallback) const {
        const Json* v = find(key);
        if (v && !v->is_number()) throw wrong(key, "a number", *v);
        return v ? v->get<double>() : fallback;
    }
    std::string text(const char* key, const std::string& fallback) const {
        const Json* v = find(key);
        if (v && !v->is_string()) throw wrong(key, "a text", *v);
        return v ? v->get<std::string>() : fallback;
    }
    bool flag(const char* key, bool fallback) const {
        const Json* v = find(key);
        if (v && !v->is_boolean()) throw wrong(key, "true or false", *v);
        return v ? v->get<bool>() : fallback;
    }
    std::vector<std::int64_t> list(const char* key, std::int64_t least = 1) const {
        const Json* v = find(key);
        if (!v || !v->is_array() || v->empty()) throw wrong(key, "a list of whole numbers", v ? *v : Json());
        std::vector<std::int64_t> out;
        for (const Json& item : *v) {
            if (!item.is_number_integer() || item.get<std::int64_t>() < least || item.get<std::int64_t>() > 1 << 16)
                throw wrong(key, "whole numbers from " + std::to_string(least), item);
            out.push_back(item.get<std::int64_t>());
        }
        return out;
    }
    // Each entry must be one of two names; true = the first.
    std::vector<bool> kinds(const char* key, const std::string& yes, const std::string& no) const {
        const Json* v = find(key);
        if (!v || !v->is_array()) throw wrong(key, "a list of block names", v ? *v : Json());
        std::vector<bool> out;
        for (const Json& item : *v) {
            if (item != yes && item != no) throw wrong(key, yes + " or " + no, item);
            out.push_back(item == yes);
        }
        return out;
    }
    Error wrong(const char* key, const std::string& expected, const Json& found) const {
        return Error("{}: expected \"{}\" to be {}, found {}", where_, key, expected,
                     found.is_null() ? "none" : found.dump());
    }

  private:
    const Json& json_;
    std::string where_;
};

}  // namespace fastscene::nn
