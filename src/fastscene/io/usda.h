// OpenUSD's text format (.usda), as much of it as we write: prims with metadata and attributes, one after the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/math/rigid.h"

namespace fastscene {

class UsdaWriter {
  public:
    // Layer metadata: metres, y up, and what shows when another file refers to this one.
    UsdaWriter(std::string_view default_prim, std::string_view about);

    // `head`: "def Xform", `name`: an identifier (usda_name). `metadata`: lines between the prim's parentheses.
    void begin(std::string_view head, std::string_view name, const std::vector<std::string>& metadata = {});
    void line(std::string_view text);
    void end();
    // Long arrays are appended here, between two lines.
    void array(std::string_view declaration, const std::string& values, std::string_view metadata = "");
    // Ends without a line break: a file that lacks its last byte is one that lacks its last brace.
    std::string text() const { return text_; }

  private:
    std::string text_;
    int depth_ = 0;
};

// A name that USD allows: letters, digits and underscores, not beginning with a digit.
std::string usda_name(std::string_view name);
std::string usda_quoted(std::string_view text);
// Pose as xformOps: a translation and a quaternion.
std::vector<std::string> usda_pose(const Rigid& parent_from_prim);

// Numbers of an array, without brackets. `decimals`: after the point; trailing zeros are left out.
std::string usda_list(std::span<const Vec3f> values, int decimals);
std::string usda_list(std::span<const Vec2f> values, int decimals);
std::string usda_list(std::span<const std::uint32_t> values);
std::string usda_tuple(Vec3f value, int decimals = 6);
void append_decimals(std::string& out, float value, int decimals);
void append_significant(std::string& out, float value, int digits);

}  // namespace fastscene
