// Sentences made up for sets of many scenes: every type of room, every style, things that stand in such rooms.
#include <array>
#include <set>

#include "fastscene/base/random.h"
#include "fastscene/batch/scene_list.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/style.h"

namespace fastscene {
namespace {

constexpr std::array kMoods{"cozy", "bright", "small", "spacious", "quiet", "elegant", "simple", "tidy", "old"};
constexpr std::array kColors{"red",   "green", "navy blue", "yellow", "white",  "black",
                             "beige", "teal",  "orange",    "gray",   "purple", "brown"};
constexpr std::array kHours{"in the morning", "at noon", "in the evening", "at dusk", "at night", "on a cloudy day"};
constexpr std::array kExtras{"a large window",    "a rug",         "many plants",      "pictures on the walls",
                             "a fireplace",       "wooden floors", "tall bookshelves", "a view of the sea",
                             "a view of the city"};
// Things that people name in rooms of a type; the others get those that fit anywhere.
struct Pieces {
    const char* type;
    std::array<const char*, 4> things;
};
constexpr std::array kPieces{
    Pieces{"bedroom", {"bed", "armchair", "wardrobe", "dresser"}},
    Pieces{"living", {"sofa", "armchair", "coffee table", "bookcase"}},
    Pieces{"kitchen", {"dining table", "fridge", "kitchen island", "bar stool"}},
    Pieces{"dining", {"dining table", "sideboard", "chandelier", "chair"}},
    Pieces{"study", {"desk", "office chair", "bookcase", "sofa"}},
    Pieces{"kids", {"bunk bed", "toy chest", "desk", "rug"}},
    Pieces{"bathroom", {"bathtub", "washbasin", "mirror", "towel rack"}},
};
constexpr std::array<const char*, 4> kAnywhere{"chair", "lamp", "cabinet", "bench"};

template <std::size_t N>
const char* one_of(const std::array<const char*, N>& list, Random& rng) {
    return list[static_cast<std::size_t>(rng.index(static_cast<int>(N)))];
}

std::string with_article(const std::string& words) {
    return (std::string("aeiou").find(words.front()) == std::string::npos ? "a " : "an ") + words;
}

std::string sentence(std::size_t nth, Random rng) {
    // All types in turn, so that a small set has them all.
    const RoomType& type = all_room_types()[nth % all_room_types().size()];
    const Style& style = all_styles()[static_cast<std::size_t>(rng.index(static_cast<int>(all_styles().size())))];
    const auto* things = &kAnywhere;
    for (const Pieces& p : kPieces)
        if (type.name == p.type) things = &p.things;
    std::string text = with_article(std::string(one_of(kMoods, rng)) + " " + style.name + " " + type.title);
    text += " with " + with_article(std::string(one_of(kColors, rng)) + " " + one_of(*things, rng));
    if (rng.uniform() < 0.6f) text += std::string(" and ") + one_of(kExtras, rng);
    if (rng.uniform() < 0.4f) text += std::string(" ") + one_of(kHours, rng);
    return text;
}

}  // namespace

SceneList varied_scenes(int count, std::uint64_t seed) {
    SceneList out;
    std::set<std::string> seen;
    for (std::size_t nth = 0; out.scenes.size() < static_cast<std::size_t>(count); ++nth) {
        const std::size_t place = out.scenes.size();
        std::string text = sentence(nth, Random(seed, "batch.prompts", nth));
        if (!seen.insert(text).second) continue;
        out.scenes.push_back({fmt::format("{:05}-{}", place, slug_of(text)), text, seed + place, {}, {}});
    }
    return out;
}

}  // namespace fastscene
