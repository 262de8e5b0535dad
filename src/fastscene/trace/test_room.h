// For tests: the corners of a small room and a matt material.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "fastscene/scene/box.h"
#include "fastscene/scene/raised_floor.h"
#include "fastscene/scene/room.h"

namespace fastscene {

inline constexpr Vec3f kLow{-2, -1.1f, -2.5f}, kHigh{2, 1.5f, 2.5f};

inline Material diffuse(Vec3f albedo, Vec3f emission = {}) {
    Material m;
    m.color_a = m.color_b = m.color_c = albedo;
    m.emission = emission;
    m.specular = 0;
    m.roughness = 1;
    return m;
}

// Raises a part of the floor of a room whose floor is at kHigh.y.
inline void raise_floor(Room& room, Vec2f low, Vec2f high, float height, const char* kind = kTier) {
    RoomObject object;
    object.kind = kind;
    object.size_m = {high.x - low.x, height, high.y - low.y};
    object.world_from_object = {rotation_about(Vec3f{1, 0, 0}, kPi),
                                {(low.x + high.x) / 2, kHigh.y, (low.y + high.y) / 2}};
    room.objects.push_back(object);
    room.meshes.push_back(box_mesh({low.x, kHigh.y - height, low.y}, {high.x, kHigh.y, high.y}, 0,
                                   static_cast<int>(room.objects.size()) - 1));
}

// A screen that shows a picture of which the left half is white, the right one black, over coordinates from 0 to 1.
inline Material half_lit_screen(Vec3f white) {
    Material m = diffuse({0, 0, 0}, white);
    m.pattern = Pattern::screen;
    auto picture = std::make_shared<TextureImage>();
    for (int side = 64; side > 0; side /= 2) {
        ImageRgb8 level(side, side, Rgb8{0, 0, 0});
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < std::max(1, side / 2); ++x) level.at(x, y) = {255, 255, 255};
        if (side == 1) level.at(0, 0) = {188, 188, 188};  // half of the light
        picture->levels.push_back(std::move(level));
    }
    m.image = std::move(picture);
    return m;
}
// Shares of the mesh's extent along x and y.
inline void spread_picture(Mesh& mesh) {
    Vec3f low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
    for (const Vec3f p : mesh.positions)
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3f p = mesh.positions[i];
        mesh.coords[i] = {(p.x - low.x) / (high.x - low.x), (p.y - low.y) / (high.y - low.y), 0};
    }
}

}  // namespace fastscene
