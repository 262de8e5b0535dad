// Parts that several sites share. Private to trace/outdoors_site*.cc.
#pragma once

#include <vector>

#include "fastscene/base/random.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/noise.h"
#include "fastscene/trace/outdoors_plants.h"
#include "fastscene/trace/outdoors_world.h"

namespace fastscene::outdoors {

// Metres to the right and ahead of the main window; the viewer is `stands` metres ahead of their origin.
struct Layout {
    explicit Layout(float azimuth, float viewer_ahead = 0)
        : facing(azimuth), s(std::sin(azimuth)), c(std::cos(azimuth)), stands(viewer_ahead) {}
    Vec2f place(float right, float ahead) const {
        const float off = ahead - stands;
        return {right * c + off * s, off * c - right * s};
    }
    Vec2f laid_out(Vec2f p) const { return {p.x * c - p.y * s, p.x * s + p.y * c + stands}; }  // the inverse
    float facing, s, c, stands;
};

struct Site : Layout {
    Site(const Sky& from, const Layout& layout) : Layout(layout), sky(from), random(from.seed, "outdoors.site") {
        world.paints = standard_paints();
        const bool thick = sky.clouds > 0.9f;
        world.clear_m = sky.snow ? 420.f : thick ? 900.f : 2600.f;
    }
    Vec2f polar(float azimuth, float far) const { return {far * std::sin(azimuth), far * std::cos(azimuth)}; }
    float turn() { return random.uniform(0, 2 * kPi); }

    const Sky& sky;
    World world;
    Random random;
};

// Young trees for gardens and streets, tall ones for behind them. Without leaves in snow.
std::vector<std::uint32_t> small_trees(Site& site, int count);
std::vector<std::uint32_t> tall_trees(Site& site, int count);
std::vector<std::uint32_t> spruces(Site& site, int count, float height_m);

// Stands a tree of the list, turned and scaled at random, in a hue of its own.
void plant(Site& site, const std::vector<std::uint32_t>& kinds, Vec2f at, float scale = 1);

// Covers the neighbourhood of the viewer with blades of grass where `grows` allows.
void sow_grass(Site& site, float reach_m, float high_m, const std::function<bool(Vec2f)>& grows,
               Vec3f tint = {1, 1, 1});

// The ground as a mesh in rings around the viewer, finer nearby.
void spread_ground(Site& site, float reach_m, int rings, int around);

// Albedo of snow, lawn and woodland soil.
Vec3f lawn_albedo(Vec2f p, float footprint, std::uint32_t seed);
Vec3f snow_albedo(Vec2f p, float footprint, std::uint32_t seed);

void lay_out_garden(Site& site);
void lay_out_forest(Site& site);
void lay_out_city(Site& site);
// The same city, seen from its main street.
Layout street_layout(float azimuth);
void lay_out_street(Site& site);
void lay_out_mountains(Site& site);
void lay_out_sea(Site& site);
void lay_out_airfield(Site& site);
void lay_out_court(Site& site);

}  // namespace fastscene::outdoors
