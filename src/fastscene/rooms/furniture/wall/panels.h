// One picture across several frames that hang side by side: a triptych.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fastscene::furniture {

inline constexpr float kPanelGap_m = 0.07f;  // between two frames

struct Panel {
    int number = 0, of = 1;  // from the left, 0 first
};

// The pattern of a picture that is this part of a larger one: "panel 2 of 3"; and back, nothing for other patterns.
std::string pattern_of(Panel panel);
std::optional<Panel> panel_of(std::string_view pattern);

}  // namespace fastscene::furniture
