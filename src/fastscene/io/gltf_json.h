// The JSON of a glTF file: lists, indices and numbers are checked, and errors name the file. Private to io/.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

class GltfJson {
  public:
    // `begin`: the byte of the file at which `text` begins, for errors.
    GltfJson(const std::string& where, std::string_view text, std::size_t begin);

    const Json& root() const { return json_; }
    const std::string& where() const { return where_; }
    [[noreturn]] void refuse(const std::string& what) const;

    // Empty if there is none.
    static const Json& list(const Json& owner, const char* name);
    // Null if there is none.
    static const Json* object(const Json& owner, const char* name);
    static const Json* extension(const Json& owner, const char* name);
    static std::string text(const Json& owner, const char* name, const std::string& otherwise = {});
    // The beginning of a text of the file, fit to be shown: whole characters, none that controls a terminal.
    static std::string brief(std::string_view text);
    // A nonnegative integer.
    std::size_t whole(const Json& owner, const char* name, std::optional<std::size_t> otherwise = {}) const;
    // An object of one of the document's lists.
    const Json& item(const char* name, std::size_t index) const;
    // As many as `otherwise` has; `of` names the owner in errors.
    std::vector<double> numbers(const Json& owner, const char* name, std::vector<double> otherwise,
                                const char* of = "node") const;

    struct Transform {
        Mat3d linear{};
        Vec3d move{};
    };
    // Of a node to its parent.
    Transform transform_of(const Json& node) const;

  private:
    std::string where_;
    std::size_t begin_;
    Json json_;
};

// A number of an accessor. `component` is glTF's number of its type; normalized integers are shares of their type's
// largest number.
float gltf_component(std::string_view data, std::size_t at, std::size_t component, bool normalized);

}  // namespace fastscene
