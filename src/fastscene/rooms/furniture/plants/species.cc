#include "fastscene/rooms/furniture/plants/species.h"

#include <array>

namespace fastscene::furniture {
namespace {

using enum Habit;
using enum LeafShape;

// name, habit, leaf, green, gloss, stems, leaves, leaf length and width, stalk, low, high, droop, flowers
constexpr Species kSnakePlant{
    "snake plant", clump, sword, {0.06f, 0.13f, 0.055f}, 0.4f, 0, 15, 0.66f, 0.075f, 0.f, 1.32f, 1.55f, 0.12f, false};
constexpr Species kMonstera{"monstera", clump, split, {0.045f, 0.12f, 0.035f}, 0.35f, 0, 13, 0.32f, 0.32f, 0.46f, 0.95f,
                            1.5f,       0.95f, false};
constexpr Species kStrelitzia{"bird of paradise",
                              clump,
                              ovate,
                              {0.06f, 0.13f, 0.05f},
                              0.4f,
                              0,
                              10,
                              0.42f,
                              0.18f,
                              0.58f,
                              1.25f,
                              1.53f,
                              0.6f,
                              false};
constexpr Species kPeaceLily{"peace lily", clump, lance, {0.04f, 0.11f, 0.035f}, 0.38f, 0, 26, 0.32f, 0.1f, 0.24f, 0.7f,
                             1.45f,        1.1f,  true};
constexpr Species kSpiderPlant{"spider plant", clump, sword, {0.16f, 0.27f, 0.1f}, 0.5f, 0, 44, 0.5f, 0.018f, 0.f, 0.6f,
                               1.45f,          2.1f,  false};
constexpr Species kAloe{"aloe", clump,  sword, {0.13f, 0.2f, 0.11f}, 0.5f, 0, 20, 0.5f, 0.075f, 0.f, 0.45f,
                        1.4f,   -0.35f, false};
constexpr Species kFiddleLeaf{"fiddle leaf fig",
                              canes,
                              violin,
                              {0.055f, 0.14f, 0.04f},
                              0.35f,
                              1,
                              30,
                              0.25f,
                              0.165f,
                              0.9f,
                              0.25f,
                              1.25f,
                              1.1f,
                              false};
constexpr Species kRubberPlant{
    "rubber plant", canes, ovate, {0.028f, 0.06f, 0.028f}, 0.22f, 3, 12, 0.23f, 0.105f, 0.8f, 0.3f, 1.1f, 0.5f, false};
constexpr Species kDracaena{"dracaena", rosette, sword, {0.06f, 0.14f, 0.06f}, 0.4f, 3, 30, 0.36f, 0.022f, 0.72f, -0.3f,
                            1.4f,       1.1f,    false};
constexpr Species kArecaPalm{"palm", fronds, lance, {0.08f, 0.18f, 0.055f}, 0.45f, 12, 24, 0.25f, 0.024f, 0.92f, 1.18f,
                             1.53f,  1.05f,  false};
constexpr Species kZzPlant{
    "zz plant", fronds, ovate, {0.045f, 0.13f, 0.035f}, 0.25f, 10, 11, 0.085f, 0.042f, 0.62f, 1.1f, 1.5f, 0.5f, false};
constexpr Species kFern{"fern", fronds, lance, {0.09f, 0.21f, 0.06f}, 0.6f, 30, 17, 0.055f, 0.014f, 0.52f, 0.55f,
                        1.4f,   1.9f,   false};
constexpr Species kOlive{"olive tree", tree, lance, {0.13f, 0.16f, 0.1f}, 0.5f, 1, 13, 0.068f, 0.017f, 1.f, -0.3f,
                         0.9f,         0.5f, false};
constexpr Species kWeepingFig{"ficus", tree, ovate, {0.05f, 0.125f, 0.035f}, 0.35f, 1, 6, 0.078f, 0.038f, 1.f, -0.5f,
                              0.6f,    0.8f, false};

constexpr std::array kFloor{&kMonstera, &kSnakePlant, &kStrelitzia, &kPeaceLily,  &kRubberPlant,
                            &kDracaena, &kArecaPalm,  &kZzPlant,    &kFiddleLeaf, &kFern};
constexpr std::array kTrees{&kFiddleLeaf, &kOlive, &kWeepingFig, &kArecaPalm, &kStrelitzia, &kRubberPlant, &kDracaena};
constexpr std::array kSmall{&kSnakePlant, &kAloe, &kSpiderPlant, &kZzPlant, &kPeaceLily, &kFern};

}  // namespace

std::span<const Species* const> species_for(PlantSize size) {
    return size == PlantSize::tree    ? std::span<const Species* const>(kTrees)
           : size == PlantSize::small ? std::span<const Species* const>(kSmall)
                                      : std::span<const Species* const>(kFloor);
}

const Species* species_named(std::string_view name) {
    for (const PlantSize size : {PlantSize::floor, PlantSize::tree, PlantSize::small})
        for (const Species* s : species_for(size))
            if (s->name == name) return s;
    return nullptr;
}

}  // namespace fastscene::furniture
