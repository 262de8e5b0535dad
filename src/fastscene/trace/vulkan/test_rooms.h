// For tests: a small room with everything that paths meet.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/scene/box.h"
#include "fastscene/trace/test_room.h"

namespace fastscene::vulkan {

inline Mesh add_box(Vec3f low, Vec3f high, bool inward, int material) {
    return box_mesh(low, high, material, -1, inward);
}

// A heap of triangles in all sizes and ways, as a thing in a room.
inline Mesh heap_mesh(int count, int material, Vec3f middle, float size, std::uint64_t seed) {
    Mesh mesh;
    mesh.material = material;
    Random random(seed, "test.heap");
    for (int i = 0; i < count; ++i) {
        const auto around = [&](float reach) {
            return Vec3f{random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
        };
        const Vec3f at = middle + around(size);
        const float reach = 0.02f + size * 0.3f * random.uniform() * random.uniform();
        const Vec3f corners[3] = {at + around(reach), at + around(reach), at + around(reach)};
        const Vec3f normal = normalize(cross(corners[1] - corners[0], corners[2] - corners[0]));
        for (const Vec3f p : corners) {
            mesh.triangles.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(p), mesh.normals.push_back(normal), mesh.coords.push_back(p);
        }
    }
    return mesh;
}

// Lamps, a window with a pane and a curtain, sun, a mirror, lacquer, metal, velvet, a candle's flame, a glass in front
// of a box, a heap of scraps, a screen.
inline Room everything_room() {
    Room room;
    room.min_corner = kLow, room.max_corner = kHigh;
    enum { kWalls, kLamp, kRed, kMetal, kMirror, kGlass, kCurtain, kLacquer, kFlame, kVelvet, kScraps, kScreen };
    room.materials.assign(12, diffuse({0.7f, 0.65f, 0.6f}));
    room.materials[kLamp].emission = {9, 8, 7};
    room.materials[kRed] = diffuse({0.7f, 0.05f, 0.04f});
    Material& metal = room.materials[kMetal];
    metal.metal = 1, metal.roughness = 0.25f;
    room.materials[kMirror].mirror = 1;
    Material& glass = room.materials[kGlass];
    glass = diffuse({0.85f, 0.9f, 0.88f});
    glass.transmission = 0.9f, glass.roughness = 0.05f, glass.specular = 0.04f;
    room.materials[kCurtain].transmission = 0.4f;
    Material& lacquer = room.materials[kLacquer];
    lacquer = diffuse({0.1f, 0.15f, 0.4f});
    lacquer.roughness = 0.3f, lacquer.specular = 0.05f;
    Material& flame = room.materials[kFlame];
    flame.emission = {30, 18, 6}, flame.burns = true;
    room.materials[kVelvet].sheen = 0.8f;
    room.materials[kScraps] = diffuse({0.3f, 0.5f, 0.25f});
    room.materials[kScreen] = half_lit_screen({3, 2.5f, 2});

    // The wall at +x has a hole. Nothing stands on the floor: which of two faces at one place a ray meets is open.
    Mesh shell = add_box(kLow, kHigh, true, kWalls);
    std::vector<std::uint32_t> kept;
    for (std::size_t t = 0; t < shell.triangles.size(); t += 3)
        if (shell.normals[shell.triangles[t]].x > -0.5f)
            kept.insert(kept.end(), shell.triangles.begin() + static_cast<std::ptrdiff_t>(t),
                        shell.triangles.begin() + static_cast<std::ptrdiff_t>(t + 3));
    shell.triangles = kept;
    room.meshes.push_back(shell);
    const float w = 0.6f;
    room.meshes.push_back(add_box({2, kLow.y, kLow.z}, {2.1f, kHigh.y, -w}, false, kWalls));
    room.meshes.push_back(add_box({2, kLow.y, w}, {2.1f, kHigh.y, kHigh.z}, false, kWalls));
    room.meshes.push_back(add_box({2, kLow.y, -w}, {2.1f, -w, w}, false, kWalls));
    room.meshes.push_back(add_box({2, w, -w}, {2.1f, kHigh.y, w}, false, kWalls));
    room.portals.push_back({{2.1f, -w, -w}, {0, 2 * w, 0}, {0, 0, 2 * w}});
    const Vec3f into = cross(room.portals[0].edge_u, room.portals[0].edge_v);
    if (into.x > 0) std::swap(room.portals[0].edge_u, room.portals[0].edge_v);
    room.meshes.push_back(add_box({2.04f, 0.01f - w, 0.01f - w}, {2.05f, w - 0.01f, w - 0.01f}, false, kGlass));
    Mesh curtain;  // a sheet in front of half of the window
    curtain.positions = {{1.9f, -w, -w}, {1.9f, -w, 0}, {1.9f, w, 0}, {1.9f, w, -w}};
    curtain.normals.assign(4, {-1, 0, 0}), curtain.coords = curtain.positions;
    curtain.triangles = {0, 1, 2, 0, 2, 3}, curtain.material = kCurtain;
    room.meshes.push_back(curtain);

    room.meshes.push_back(add_box({-0.2f, -1.05f, 0.8f}, {0.2f, -1.f, 1.2f}, false, kLamp));
    room.meshes.push_back(add_box({-1.7f, -0.4f, -1.f}, {-1.6f, -0.2f, -0.9f}, false, kLamp));
    room.meshes.push_back(add_box({0.9f, 0.7f, 1.2f}, {1.5f, 1.45f, 1.8f}, false, kRed));
    room.meshes.push_back(add_box({-1.5f, 0.9f, 1.2f}, {-0.9f, 1.45f, 1.8f}, false, kMetal));
    room.meshes.push_back(add_box({-0.5f, -0.6f, 2.4f}, {0.5f, 0.5f, 2.42f}, false, kMirror));
    room.meshes.push_back(add_box({-0.6f, 0.9f, 0.9f}, {-0.2f, 1.45f, 1.3f}, false, kGlass));
    room.meshes.push_back(add_box({-1.4f, 1.2f, -0.5f}, {1.4f, 1.3f, 0.5f}, false, kLacquer));
    room.meshes.push_back(add_box({0.2f, 0.8f, 0.9f}, {0.25f, 0.95f, 0.95f}, false, kFlame));
    room.meshes.push_back(add_box({-1.9f, 0.8f, -0.6f}, {-1.5f, 1.45f, 0.6f}, false, kVelvet));
    Mesh screen = add_box({-1.5f, -0.7f, -2.3f}, {-0.9f, -0.3f, -2.28f}, false, kScreen);
    spread_picture(screen);
    room.meshes.push_back(screen);
    room.meshes.push_back(heap_mesh(1500, kScraps, {0.6f, 1.1f, -1.5f}, 0.4f, 3));
    room.sky.zenith = {0.4f, 0.6f, 1.f}, room.sky.horizon = {0.8f, 0.85f, 1.f}, room.sky.ground = {0.3f, 0.3f, 0.25f};
    room.sky.sun_dir = normalize(Vec3f{0.8f, -0.5f, 0.2f});
    room.sky.sun_irradiance = {12, 11, 9};
    room.sky.sun_limit = 2;
    return room;
}

}  // namespace fastscene::vulkan
