// What a style's file chooses from, by name: the silhouettes that builders of furniture know, and moods.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "fastscene/scene/room.h"

namespace fastscene {

// The names of an enumeration's values, in their order; files of styles and room types use them.
template <class Choice>
inline constexpr std::array<std::string_view, 0> kNamesOf{};

// The shade of floor, table and hanging lamps.
enum class LampFamily : std::uint8_t { drum, globe, paper, cage, dome, candelabra };
template <>
inline constexpr std::array<std::string_view, 6> kNamesOf<LampFamily>{"drum", "globe", "paper",
                                                                      "cage", "dome",  "candelabra"};

enum class LegType : std::uint8_t { square, tapered, splayed, turned, metal_frame, hairpin };
template <>
inline constexpr std::array<std::string_view, 6> kNamesOf<LegType>{"square", "tapered",     "splayed",
                                                                   "turned", "metal frame", "hairpin"};

enum class SofaType : std::uint8_t { block, slim, rolled };  // boxes; thin ones, on legs; rolled
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<SofaType>{"block", "slim", "rolled"};

enum class Shelves : std::uint8_t { books, bath, kitchen, toys };  // what stands on them
template <>
inline constexpr std::array<std::string_view, 4> kNamesOf<Shelves>{"books", "bath", "kitchen", "toys"};

enum class Mouldings : std::uint8_t { none, plain, rich };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<Mouldings>{"none", "plain", "rich"};

enum class PostForm : std::uint8_t { metal, turned, square };  // of four-poster beds
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<PostForm>{"metal", "turned", "square"};

enum class FanForm : std::uint8_t { slim, boards, leaves };  // three slim blades; five of board; five leaves
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<FanForm>{"slim", "boards", "leaves"};

enum class TapestryForm : std::uint8_t { medallions, landscape };  // with a border; a sun over hills
template <>
inline constexpr std::array<std::string_view, 2> kNamesOf<TapestryForm>{"medallions", "landscape"};

enum class RugWeave : std::uint8_t { any, medallions, zigzag };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<RugWeave>{"any", "medallions", "zigzag"};

enum class SofaForm : std::uint8_t { padded, framed, buttoned, channelled };
template <>
inline constexpr std::array<std::string_view, 4> kNamesOf<SofaForm>{"padded", "framed", "buttoned", "channelled"};

enum class ArmchairForm : std::uint8_t { shell, padded, wing, tub, sling, rattan };
template <>
inline constexpr std::array<std::string_view, 6> kNamesOf<ArmchairForm>{"shell", "padded", "wing",
                                                                        "tub",   "sling",  "rattan"};

enum class ChaiseForm : std::uint8_t { swept, scrolled };
template <>
inline constexpr std::array<std::string_view, 2> kNamesOf<ChaiseForm>{"swept", "scrolled"};

enum class BedForm : std::uint8_t { panels, tufted, slats, board, low, iron, posts };
template <>
inline constexpr std::array<std::string_view, 7> kNamesOf<BedForm>{"panels", "tufted", "slats", "board",
                                                                   "low",    "iron",   "posts"};

enum class DaybedForm : std::uint8_t { boards, iron, padded };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<DaybedForm>{"boards", "iron", "padded"};

enum class FloorBedForm : std::uint8_t { bare, mats, pallets };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<FloorBedForm>{"bare", "mats", "pallets"};

enum class BunkForm : std::uint8_t { boards, bars, pipes };  // flat boards; turned posts, upright bars; steel tube
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<BunkForm>{"boards", "bars", "pipes"};

enum class CoffeeTableForm : std::uint8_t { four_legs, round, drum, slab, twin };
template <>
inline constexpr std::array<std::string_view, 5> kNamesOf<CoffeeTableForm>{"four legs", "round", "drum", "slab",
                                                                           "twin"};

enum class DiningTableForm : std::uint8_t { four_legs, trestle, pedestal };
template <>
inline constexpr std::array<std::string_view, 3> kNamesOf<DiningTableForm>{"four legs", "trestle", "pedestal"};

enum class ChestForm : std::uint8_t { plain, slatted };  // of sideboards and their like
template <>
inline constexpr std::array<std::string_view, 2> kNamesOf<ChestForm>{"plain", "slatted"};

enum class FloorLampForm : std::uint8_t { straight, arc };
template <>
inline constexpr std::array<std::string_view, 2> kNamesOf<FloorLampForm>{"straight", "arc"};

template <>
inline constexpr std::array<std::string_view, 8> kNamesOf<Sky::View>{"garden", "city",   "sea",      "mountains",
                                                                     "forest", "street", "airfield", "court"};

// The procedural patterns of materials.
template <>
inline constexpr std::array<std::string_view, 48> kNamesOf<Pattern>{
    "plain",     "plaster",  "wood",       "planks",  "herringbone", "parquet",    "tile",        "checker",
    "subway",    "brick",    "concrete",   "marble",  "terrazzo",    "fabric",     "knit",        "carpet",
    "leather",   "rug",      "stripes",    "damask",  "floral",      "wicker",     "metal",       "art",
    "book",      "leaf",     "grass",      "bark",    "screen",      "dots",       "zigzag",      "twill",
    "geometric", "diamonds", "lattice",    "stars",   "gingham",     "plaid",      "houndstooth", "patchwork",
    "leopard",   "zebra",    "camouflage", "paisley", "encaustic",   "laid tiles", "peeling",     "image"};
static_assert(kNamesOf<Pattern>.size() == static_cast<std::size_t>(Pattern::image) + 1);

// What a room whose style is not said is like: any; cozy; for children or colorful; with neon light; in a color that is
// said; bright; left to decay, and so a loft.
enum class StyleMood : std::uint8_t { usual, cozy, children, neon, colored, bright, abandoned, abandoned_loft };
template <>
inline constexpr std::array<std::string_view, 8> kNamesOf<StyleMood>{
    "usual", "cozy", "children", "neon", "colored", "bright", "abandoned", "abandoned_loft"};

}  // namespace fastscene
