// Which models of the catalogue serve for which of our words.
#include <algorithm>
#include <array>
#include <cctype>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/pack_parts.h"

namespace fastscene {
namespace packs {
namespace {

struct Choice {
    std::string_view klass;
    std::vector<std::string_view> models;  // classes of the catalogue, best first
    std::string_view stand_in = {};        // our builder when the pack has none
};

// Only where the names differ, or where another model does as well. Looked at one by one.
const std::vector<Choice>& choices() {
    static const std::vector<Choice> all{
        {"grand_piano", {"grand_piano"}, "piano"},
        {"electric_guitar", {"electric_guitar"}, "guitar"},
        {"teddy_bear", {"teddy_bear"}, "toy_box"},
        {"crate", {"crate", "box"}, "basket"},
        {"suitcase", {"suitcase", "briefcase"}},
        {"dog", {"dog", "bulldog"}},
        {"football_table", {"football_table"}},
        {"table_tennis", {"table_tennis"}},
        {"exercise_bike", {"indoor_bike"}},
        {"bicycle", {"bike", "bicycle"}},
        {"motorbike", {"motorbike", "yamaha_yzr_r6"}},
        {"punching_bag", {"punching_ball"}},
        {"folded_clothes", {"folded_clothes"}, "basket"},
        {"toy_train", {"toy_train"}, "toy_box"},
        {"toy_car", {"car_model"}, "toy_box"},
        {"doll_house", {"doll_house"}, "toy_box"},
        {"puzzle", {"puzzle"}, "toy_box"},
        {"laptop", {"laptop", "apple_ibook"}},
        {"computer", {"apple_imac_2004", "apple_imac_1998"}, "monitor"},
        {"phone", {"phone", "apple_iphone", "mobile_phone", "wireless_phone"}},
        {"printer", {"inkjet_printer_and_scanner"}},
        {"keyboard_pc", {"keyboard"}},
        {"stereo", {"mini_stereo", "mp3_station", "radio"}},
        {"record_player", {"radio", "mini_stereo"}},
        {"camera", {"camera", "reflex_camera"}},
        {"projector", {"video_projector"}},
        {"game_console", {"playstation"}},
        {"pinball", {"flipper"}},
        {"toaster", {"toaster"}},
        {"coffee_machine", {"coffee_brewer", "coffee_machine", "coffee_maker", "coffee_press"}},
        {"kettle", {"espresso_kettle", "teapot"}},
        {"blender", {"mixer", "blender"}},
        {"knife_block", {"knife_stand", "kitchen_knife"}},
        {"cutting_board", {"chopping_board"}},
        {"pan", {"large_pan"}, "pot"},
        {"wine_rack", {"wine_rack"}, "bookshelf"},
        {"glass_cup", {"glass", "beer_glass", "plastic_cup"}, "vase_small"},
        {"hamburger", {"hamburger", "hot_dog"}, "bowl"},
        {"statue", {"deer", "statue"}},
        {"chess", {"chessboard"}},
        {"swing", {"child_swing"}},
        {"see_saw", {"seesaw"}},
        {"baby_high_chair", {"baby_high_chair"}, "chair"},
        {"ladder", {"step_ladder", "small_step_ladder"}, "ladder_shelf"},
        {"toilet_paper", {"toilet_paper_dispenser"}},
        {"soap", {"soap", "flacon", "cosmetics_pot"}, "vase_small"},
        {"detergent", {"spray_bottle", "milk"}, "vase_small"},
        {"scale", {"electronic_scale"}},
        {"water_heater", {"boiler", "electric_water_heater", "gaz_water_heater"}},
        {"fire_extinguisher", {"extinguisher"}},
        {"tool_box", {"tool", "drill", "hammer", "saw"}, "basket"},
        {"airplane", {"biplane"}, "toy_box"},
        {"boat", {"rowboat"}},
        {"tent", {"camping_tent"}},
        {"stocking", {"gift"}},
        {"man", {"male", "sitting_male"}},
        {"woman", {"female", "sitting_female"}},
        {"person", {"female", "male", "girl", "boy"}},
        {"fence", {"fence", "iron_railing"}},
        {"staircase", {"spiral_staircase"}},
        {"mailbox", {"mailbox", "letters_box"}},
        {"trash", {"dustbin"}, "basket"},
        {"spices", {"spice_tower"}, "vase_small"},
        {"stone_lantern", {"stone_lantern", "japanese_lantern"}, "table_lamp"},
        {"deck_chair", {"deck_chair", "beach_chair", "pool_lounge"}, "armchair"},
        {"filing", {"filing_cabinet"}, "dresser"},
        {"white_board", {"white_board"}, "picture"},
        {"fan", {"table_fan", "rigged_fan"}},
        {"cup_cake", {"cup_cake"}, "bowl"},
        {"surveillance", {"surveillance_camera", "cctv"}},
        {"pen", {"text_marker", "pencil", "penbox"}, "vase_small"},
        {"kennel", {"dog_house"}, "basket"},
        {"wine_bottle", {"wine_bottle", "bottle"}, "bottles"},
        {"beer_bottle", {"beer_bottle", "beer_glass"}, "bottles"},
        {"tennis_racket", {"tennis_racket", "table_tennis_bat"}},
        {"mannequin", {"mannequin_female", "mannequin_male"}},
        {"music_stand", {}, "ladder_shelf"},
        {"folding_screen", {}, "ladder_shelf"},
        {"globe", {}, "vase"},
        {"teapot", {"teapot"}, "kettle"},
        {"birthday_cake", {"birthday_cake"}, "bowl"},
        {"gift", {"gift"}, "basket"},
        {"handbag", {"handbag"}, "basket"},
        {"backpack", {"backpack"}, "basket"},
        {"water_cooler", {"water_cooler"}},
        {"hat", {"hat", "cap"}},
        {"ring", {"ring"}},
        {"rock", {"rock"}},
        {"car", {"car_model", "volkswagen"}},
    };
    return all;
}

const Choice* choice_of(std::string_view klass) {
    const auto at = std::find_if(choices().begin(), choices().end(), [&](const Choice& c) { return c.klass == klass; });
    return at == choices().end() ? nullptr : &*at;
}

bool has_word(std::string_view klass, std::string_view word) { return klass.find(word) != std::string_view::npos; }

}  // namespace

bool keeps_builder(const std::string& klass) {
    // Extras that the pack shows better than our builders do; every other class with a builder of ours keeps it.
    if (is_one_of(klass, {"rocking_horse", "aquarium", "dog"})) return false;
    return std::binary_search(piece_classes().begin(), piece_classes().end(), klass);
}

std::vector<std::string> catalogue_classes(const std::string& klass) {
    std::vector<std::string> out;
    if (const Choice* choice = choice_of(klass))
        for (const std::string_view name : choice->models) out.emplace_back(name);
    if (std::find(out.begin(), out.end(), klass) == out.end()) out.push_back(klass);
    return out;
}

bool fits_a_room(const PackModel& model) {
    constexpr float kLargest = 2.7f, kTallest = 2.35f;
    return !model.opening && model.size_m.x <= kLargest && model.size_m.z <= kLargest &&
           (model.size_m.y <= kTallest || has_word(model.klass, "staircase"));
}

Mount mount_of(const PackModel& m) {
    const float top = m.elevation_m + m.size_m.y;
    if (m.elevation_m > 1.4f &&
        (m.category == "Lights" || has_word(m.klass, "ceiling") || has_word(m.klass, "hanging") ||
         has_word(m.klass, "chandelier")) &&
        top > 2.1f && !has_word(m.klass, "wall"))
        return Mount::ceiling;
    if (m.elevation_m > 0.09f && !is_one_of(m.klass, {"towel", "toilet_brush"})) return Mount::wall;
    // Small, but it stands on the floor.
    if (m.category == "Characters" ||
        is_one_of(m.klass,
                  {"dustbin",   "slippers",    "bootie",       "sneakers",     "basketball", "soccer_ball",
                   "briefcase", "potty",       "extinguisher", "umbrella",     "cat",        "dog",
                   "bulldog",   "siamese_cat", "suitcase",     "toilet_brush", "doormat",    "woman_shoes",
                   "mocassin",  "rock",        "gift",         "scooter",      "skateboard", "electronic_scale"}))
        return Mount::floor;
    const float wide = std::max(m.size_m.x, m.size_m.z);
    return wide < 0.52f && m.size_m.y < 0.6f ? Mount::surface : Mount::floor;
}

}  // namespace packs

std::optional<std::string> stand_in(const std::string& klass) {
    if (const auto* choice = packs::choice_of(klass); choice && !choice->stand_in.empty())
        return std::string(choice->stand_in);
    return {};
}

}  // namespace fastscene
