// The outside as seen through the windows: a small world of plants, houses and hills under the sky, traced once per
// room into a panorama, or a photographed one (Sky::picture). It is looked up by direction alone, as if it were far
// away.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fastscene/base/bytes.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/sky.h"

namespace fastscene {

class Outdoors {
  public:
    // `pixels_per_degree` at the horizon, in the directions that the room's windows show from anywhere within its
    // bounding box; 0: only the coarse table. Without windows nothing is built, and there is bare sky and ground.
    Outdoors(const Sky& sky, const std::vector<Portal>& portals, Vec3f room_low, Vec3f room_high,
             float pixels_per_degree);
    explicit Outdoors(const Room& room, float pixels_per_degree)
        : Outdoors(room.sky, room.portals, room.min_corner, room.max_corner, pixels_per_degree) {}

    // Radiance from a direction (world frame, unit, y down), as sharp as there is. Without the sun's disc.
    Vec3f seen(Vec3f direction) const;
    // The same at 0.7 degrees per pixel: for illumination, which needs no leaves and window panes. Its mean over any
    // larger solid angle is the same.
    Vec3f light(Vec3f direction) const;
    // Geometric mean of the luminance about the horizon, as the windows show it: what a photographer would expose for.
    float brightness() const;
    float pixels_per_degree() const { return pixels_per_degree_; }

    // For a file, as tracing it takes many seconds. What is read back is the same to the bit. `sky`: of the same room.
    std::string bytes() const;
    static Outdoors from_bytes(ByteReader& in, const Sky& sky);

    // Height is stretched so that pixels are densest at the horizon, where things are far and small.
    struct Band {
        int width = 0, height = 0;   // width: of the full circle
        float stretch = 0, top = 0;  // radians
        std::vector<int> column;     // of pixels, by azimuth; -1: no window shows it
        ImageColor pixels;
        Vec2f position(Vec3f direction) const;
        Vec3f direction(Vec2f position) const;
        bool covers(Vec2f position) const;
        Vec3f at(Vec2f position) const;  // bilinear
    };
    const Band& band() const { return band_; }
    const ImageColor& table() const { return table_; }  // 512 x 256; empty: bare sky and ground
    const SkyDome& dome() const { return dome_; }
    bool pictured() const { return pictured_; }

  private:
    explicit Outdoors(const Sky& sky) : dome_(sky), ground_(sky.ground), pictured_(sky.picture != nullptr) {}
    Vec3f bare(Vec3f direction) const;

    SkyDome dome_;
    Vec3f ground_;
    bool pictured_ = false;  // Sky::picture: the dome is not what is seen above
    float pixels_per_degree_ = 0;
    float scale_ = 0;  // pixels times this are half precision numbers; 0: not rounded yet
    Band band_;
    ImageColor table_;
};

// Azimuth (atan2(x, z)) that the largest window looks to; 0 without windows.
float main_outlook(const std::vector<Portal>& portals);

}  // namespace fastscene
