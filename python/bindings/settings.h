// Keyword arguments as the fields of a params struct (base/fields.h): cell_samples=64 is --panorama-cell-samples.
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/suggest.h"

namespace fastscene::python {

namespace py = pybind11;

class Settings {
  public:
    explicit Settings(const py::kwargs& given) : left_(py::dict(given)) {}

    // Takes those that are fields of `params`; names begin with `section` and an underscore, if there is one.
    template <class Params>
    void take(Params& params, const std::string& section = "") {
        visit_fields(params, Taker{*this, section});
    }
    // Throws UsageError for one that was no field of any.
    void finish() const {
        for (const auto& [key, value] : left_) {
            const auto name = key.cast<std::string>();
            const std::string guess = nearest_word(name, names_);
            throw UsageError("unknown setting {}{}", name, guess.empty() ? "" : "; did you mean " + guess + "?");
        }
    }

  private:
    struct Taker {
        Settings& settings;
        const std::string& section;

        template <class T, class... Rest>
        void operator()(std::string_view field, T& value, const Rest&...) {
            std::string name = section.empty() ? std::string(field) : section + "_" + std::string(field);
            if (field == "kind" && !section.empty()) name = section;
            std::replace(name.begin(), name.end(), '-', '_');
            settings.names_.push_back(name);
            if (!settings.left_.contains(name)) return;
            const py::object given = settings.left_[name.c_str()];
            try {
                value = given.cast<T>();
            } catch (const py::cast_error&) {
                throw UsageError("{}: expected {}, found {}", name, kind_of(value),
                                 py::repr(given).cast<std::string>());
            }
            settings.left_.attr("pop")(name);
        }
        static const char* kind_of(bool) { return "True or False"; }
        static const char* kind_of(int) { return "a whole number"; }
        static const char* kind_of(float) { return "a number"; }
        static const char* kind_of(double) { return "a number"; }
        static const char* kind_of(const std::string&) { return "a text"; }
    };
    py::dict left_;
    std::vector<std::string> names_;
};

}  // namespace fastscene::python
