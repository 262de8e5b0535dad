// Silhouettes of the main pieces: what distinguishes a sofa of one style from that of another.
#pragma once

#include <initializer_list>
#include <string_view>

#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {

void frame_sofa(Kit& k, float width, int seats);
void chesterfield(Kit& k, float width, int seats);
void channel_seat(Kit& k, float width, int channels);  // a sofa, or a tub chair when narrow

void wing_chair(Kit& k);
void sling_chair(Kit& k);
void rattan_chair(Kit& k);

enum class BedForm { panels, tufted, slats, board, low, iron, posts };
void headboard(Kit& k, BedForm form, float width, float length, int wood, int head);

// Cloth over a mattress: flat on top, hanging at the sides, with folds. `mattress`: its width, its top above the floor,
// its length.
Mesh blanket(Vec3f mattress, float drop, float from_z, float to_z, float lift, float thick, std::uint32_t seed,
             float fold);
// Cloth in one of the style's accents: plain, striped or knitted.
int accent_cloth(Kit& k);
// A cushion on its lower edge at `at`, leaning back, then turned.
void put_pillow(Kit& k, int material, Vec3f at, Vec3f size, float lean_deg, float yaw_deg = 0.f);

// The two forms that rooms of a style have of a piece: the first a little more often.
struct StyleForms {
    std::string_view style;
    int first, second;
};
int form_for(Kit& k, std::initializer_list<StyleForms> table, int usual);

// Asked for in rattan, cane or the like: what is woven of it looks so in every style.
bool is_woven(const Kit& k);
// Its weave, of strands as wide as a seat has them, in the color that was asked for.
int woven_main(Kit& k);

}  // namespace fastscene::furniture
