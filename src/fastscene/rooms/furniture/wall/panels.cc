#include "fastscene/rooms/furniture/wall/panels.h"

#include <fmt/format.h>

namespace fastscene::furniture {

std::string pattern_of(Panel panel) { return fmt::format("panel {} of {}", panel.number + 1, panel.of); }

std::optional<Panel> panel_of(std::string_view pattern) {
    constexpr int kMost = 5;
    for (int of = 2; of <= kMost; ++of)
        for (int number = 0; number < of; ++number)
            if (pattern == pattern_of({number, of})) return Panel{number, of};
    return {};
}

}  // namespace fastscene::furniture
