#include "fastscene/studio/planner.h"

#include <chrono>

#include "fastscene/panorama/panorama.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/studio/plan_view.h"

namespace fastscene::studio {
namespace {

constexpr std::array<const char*, 3> kFates{"understood", "approximated", "not_understood"};
// What a sentence and `edit --time` call the hours (rooms/edit_words.cc).
constexpr std::array<const char*, 5> kHours{"morning", "day", "evening", "dusk", "night"};

Json words_json(const PromptSpec& spec) {
    Json words = Json::array();
    for (const PromptWord& w : spec.words)
        words.push_back(
            {{"words", w.words}, {"fate", kFates[static_cast<std::size_t>(w.fate)]}, {"meaning", w.meaning}});
    return words;
}

}  // namespace

std::shared_ptr<const FurniturePack> Planner::pack(const std::string& assets) {
    const std::lock_guard lock(mutex_);
    const auto [found, is_new] = packs_.try_emplace(assets);
    if (is_new) {
        PanoramaParams params;
        params.assets = assets;
        found->second = furniture_pack(params);
    }
    return found->second;
}

Json Planner::plan(const std::string& prompt, std::uint64_t seed) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    DocumentRoom room{understand_prompt(prompt, false, pack(PanoramaParams{}.assets)), {}, seed};
    room.furnished = furnish_room(room.spec, Run{seed, nullptr, {}});
    Json out{{"words", words_json(room.spec)},
             {"not_placed", room.spec.not_placed},
             {"assumed", room.spec.assumed},
             {"room", room.spec.room},
             {"style", room.furnished.plan.style.name},
             {"time", room.spec.time},
             {"language", room.spec.language},
             {"view", plan_view(room)}};
    out["ms"] = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    return out;
}

Json Planner::choices() {
    Json kinds = Json::array();
    for (const Thing& thing : things())
        if (thing.built && !thing.has(Role::shell) && !thing.has(Role::opening)) kinds.push_back(thing.kind);
    return {{"styles", styles()}, {"hours", kHours}, {"kinds", kinds}};
}

}  // namespace fastscene::studio
