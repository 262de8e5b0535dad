// Irradiance cache: the room's diffuse light, computed once and shared by all pictures of the room (a voxelized
// relative of Ward's irradiance cache, 1988).
//
// Space is divided into cells of `cell_m`; every cell that contains surface has one entry for each of the six axis
// directions that the surface may face. An entry holds the irradiance (W/m2 up to the room's scale): direct light from
// lamps and windows, and indirect light gathered over repeated passes. Direct sun is stored separately because its
// shadows are sharp: pictures trace it themselves, and the cached value serves for bounced light only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Where the irradiance of a surface comes from, to first order: its relative gradient by the normal. Lets relief be
// shaded by the light that falls on it (directional light maps, in world space).
struct LightDirection {
    Vec3f sum{};       // of luminance * direction / cosine
    float weight = 0;  // of luminance

    void add(Vec3f irradiance, Vec3f direction, Vec3f normal);
    void add(const LightDirection& other, float share) { sum += other.sum * share, weight += other.weight * share; }
    // The gradient: E(n') / E(n) = 1 + dot(n' - n, gradient).
    Vec3f gradient() const { return weight > 0 ? sum / weight : Vec3f{}; }
};
// The irradiance of a slope of the relief, relative to that of the even surface.
float relief_light(Vec3f gradient, Vec3f normal, Vec3f bumped);

class ByteReader;
class Gatherer;     // gatherer.h
struct RoomChange;  // room_change.h

class IrradianceCache {
  public:
    // Places entries on all surfaces and gathers their light. Deterministic in run.seed. `viewpoints`: where cameras
    // will be. Entries that cannot be seen from around them get fewer paths, since they matter only through what they
    // light. `gatherer`: traces the rays; null: Embree does. The result is rounded as bytes() rounds it.
    static IrradianceCache gather(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                  const TraceParams& params, const Run& run,
                                  const std::vector<Vec3f>& viewpoints = {Vec3f{}}, Gatherer* gatherer = nullptr);

    // The light of a room before a change, gathered with the same settings.
    struct Earlier {
        const IrradianceCache& light;
        const RoomChange& change;
    };
    // gather() for a changed room: entries whose light the change hardly alters keep it. With Embree.
    static IrradianceCache gather_again(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                        const TraceParams& params, const Run& run, const std::vector<Vec3f>& viewpoints,
                                        const Earlier& earlier);
    // Share of the entries that kept their light, in [0, 1].
    double kept_share() const { return kept_share_; }

    // All that pictures need, with light in half precision: 66 bytes an entry, and the sun patches.
    std::string bytes() const;
    // Throws Error for bytes that are not light, or of another room.
    static IrradianceCache from_bytes(ByteReader& in, const Room& room);

    // Irradiance without direct sun at a surface point, interpolated between the entries around it. `normal`: unit
    // length.
    Vec3f at(Vec3f position, Vec3f normal) const { return read(position, normal).irradiance; }
    // The same, with a confidence: 1 on even surfaces in the open, 0 near other objects or on uneven surfaces, where
    // light varies within a cell.
    struct Reading {
        Vec3f irradiance;
        Vec3f sun;        // irradiance of direct sun, blurred to the cell size
        Vec3f direction;  // where `irradiance` comes from (LightDirection)
        float trust = 0;
    };
    Reading read(Vec3f position, Vec3f normal) const;
    // From the nearest entry only, for secondary bounces, where speed matters more than smoothness.
    struct Near {
        Vec3f light, sun;  // irradiance without and from direct sun
    };
    Near near(Vec3f position, Vec3f normal) const;
    std::size_t size() const { return cells_.size(); }

    // A bit of surface.
    struct Place {
        Vec3f position, normal;
    };
    // A one-sample estimate of a point's irradiance, in two parts whose sum has the entry's value as its mean. First
    // next-event estimation: lamps, windows and the first bounce of the sun. `which`, `uv`: uniform in [0, 1),
    // preferably stratified.
    struct Direct {
        DirectedLight lights, sunlit;
        Vec3f irradiance() const { return lights.irradiance + sunlit.irradiance; }
    };
    Direct direct(const Room& room, const SceneBvh& bvh, const Lights& lights, const Place& at, float which,
                  Vec2f uv) const;
    // Then one cosine-weighted ray, which returns the cached light where it hits.
    struct Bounce {
        Vec3f irradiance, direction;
        float distance = kFar;
        bool buried = false;  // hit a back face: the point lies inside a solid
    };
    Bounce bounced(const Room& room, const SceneBvh& bvh, const Lights& lights, const Place& at, Vec2f uv) const;

    struct Cell {
        Vec3f direct, indirect, sun, normal, center;
        Vec3f albedo;  // mean over the cell
        LightDirection directed;
        float area = 0;  // of the surface in the cell
        float transmission = 0;
        float trust = 0;
        bool seen = true;  // visible from around a viewpoint
    };
    // A sunlit cell as a light source for the rest of the room (a virtual area light). It emits from the sample points
    // that the sun actually reaches: the cell's center may be in shade or behind an edge.
    struct SunPatch {
        std::uint32_t first, count;  // range of sun_places_
        Vec3f sun;                   // irradiance
        Vec3f leaving;               // radiant exitance
        float area;
        float useful;  // the share of the room that sees it
        bool behind;   // the far side of a thin sheet
    };
    struct SunPlace {
        Place at;
        std::size_t material;
    };
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t cell = 0;  // + 1; 0: free
    };
    // All of it, for graphics cards.
    struct Tables {
        float cell_m;
        Vec3f origin;
        const std::vector<Vec3f>& reflectances;  // by material: diffuse albedo for secondary bounces
        const std::vector<Coat>& coats;          // by material: specular coat, for its reflection of the sun
        const std::vector<Cell>& cells;
        const std::vector<std::uint64_t>& keys;          // of cells, ascending
        const std::vector<std::uint32_t>& first_sample;  // offsets into samples, one more than cells; empty when done
        const std::vector<Place>& samples;
        const std::vector<Slot>& slots;  // open-addressing hash table over keys
        const std::vector<SunPatch>& sun_patches;
        const std::vector<SunPlace>& sun_places;
        const std::vector<float>& sun_powers;  // cumulative, by patch
    };
    Tables tables() const {
        return {cell_m_,       origin_,  reflectances_, coats_,       cells_,      keys_,
                first_sample_, samples_, slots_,        sun_patches_, sun_places_, sun_powers_};
    }

  private:
    int find(std::int32_t x, std::int32_t y, std::int32_t z, int facing) const;
    int nearest(Vec3f position, Vec3f normal) const;
    int near_plane(Vec3f point, int facing) const;
    const Place& place(std::size_t cell, int i) const;
    std::uint64_t random_key(std::size_t cell, std::uint64_t pass, std::uint64_t seed) const;
    void know_surfaces(const Room& room);
    void add_sun_powers();
    IrradianceCache rounded(const Room& room) const;
    void build(const Room& room);
    std::vector<std::uint8_t> visibility(const SceneBvh& bvh) const;
    void drop_hidden(const std::vector<std::uint8_t>& sight);
    void find_seen(const SceneBvh& bvh, const std::vector<Vec3f>& viewpoints, Gatherer* gatherer, const Run& run);
    void index();
    void despeckle(bool indirect, float tolerated);
    std::vector<float> pooled(const std::vector<float>& error) const;
    void smooth(bool indirect, int step, std::vector<float>& error);
    void smooth_directions();
    void distrust_edges();

    // Of a changed room: whether the entry keeps its light.
    bool is_kept(std::size_t cell) const { return !kept_.empty() && kept_[cell] != 0; }
    void keep_light(const Room& room, const Lights& lights, const Earlier& earlier, const Run& run);
    std::vector<float> share_of_change(const Room& room, const Lights& lights, const RoomChange& change,
                                       std::uint64_t seed) const;

    // By which factor the cells of a large room are larger than asked for.
    static float coarseness(const Room& room);
    // The steps of gathering, in order.
    void place_cells(const Room& room, const SceneBvh& bvh, const TraceParams& params,
                     const std::vector<Vec3f>& viewpoints, Gatherer* gatherer, const Run& run);
    void gather_sun(const Room& room, const SceneBvh& bvh, const Lights& lights, Gatherer* gatherer, const Run& run);
    void gather_rest(const Room& room, const SceneBvh& bvh, const Lights& lights, const TraceParams& params,
                     Gatherer* gatherer, const Run& run);
    std::vector<std::uint16_t> light_by_sun(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                            Gatherer* gatherer, const Run& run);
    void find_sun_patches(const Room& room, const SceneBvh& bvh, const std::vector<std::uint16_t>& sunny,
                          std::uint64_t seed);
    void gather_direct(const Room& room, const SceneBvh& bvh, const Lights& lights, int samples, Gatherer* gatherer,
                       const Run& run, Progress& progress);
    struct Pass;
    void gather_pass(const Room& room, const SceneBvh& bvh, const Lights& lights, Gatherer* gatherer, const Run& run,
                     Progress& progress, Pass& pass);
    void gather_indirect(const Room& room, const SceneBvh& bvh, const Lights& lights, int samples, Gatherer* gatherer,
                         const Run& run, Progress& progress);
    Vec3f reflected(const Room& room, std::size_t material, Vec3f normal, Vec3f direction, bool behind) const;
    DirectedLight sunlit(const Room& room, const SceneBvh& bvh, const Place& at, float which) const;

    float cell_m_ = 0.03f;
    Vec3f origin_;
    std::vector<Vec3f> reflectances_;  // these as in Tables
    std::vector<Coat> coats_;
    std::vector<bool> closed_;  // by mesh: watertight
    std::vector<Cell> cells_;
    std::vector<std::uint64_t> keys_;
    std::vector<std::uint32_t> first_sample_;
    std::vector<Place> samples_;
    std::vector<Slot> slots_;
    std::uint32_t mask_ = 0;
    std::vector<SunPatch> sun_patches_;
    std::vector<SunPlace> sun_places_;
    std::vector<float> sun_powers_;
    float scale_ = 0;                 // of bytes(), once rounded
    std::vector<std::uint8_t> kept_;  // by cell; empty: none. Only while gathering
    double kept_share_ = 0;
};

// The direction among +-x, +-y, +-z that a normal is nearest to: 0..5.
int facing_of(Vec3f normal);

}  // namespace fastscene
