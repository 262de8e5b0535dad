// What a sentence would become, while it is typed: how its words are understood, and the plan of the room.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/rooms/document.h"

namespace fastscene::studio {

class Planner {
  public:
    // {words: [{words, fate, meaning}], not_placed, assumed, view, room, style, time, ms}. Throws UsageError for a
    // prompt that cannot be read.
    Json plan(const std::string& prompt, std::uint64_t seed);
    // Opened once for each of "none", "cc0" and "all".
    std::shared_ptr<const FurniturePack> pack(const std::string& assets);
    // Styles, hours, and what can be added to a room.
    static Json choices();

  private:
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const FurniturePack>> packs_;
};

}  // namespace fastscene::studio
