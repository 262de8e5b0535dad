// The open arches of an arcade.
#include <array>

#include "fastscene/rooms/shapes.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

// Carved from the wall's stone, without its joints.
int carved_stone(Room& room, int wall) {
    Material stone = room.materials[static_cast<std::size_t>(wall)];
    stone.name = "carved stone", stone.pattern = Pattern::plaster, stone.scale_m = 0.5f, stone.bump_m = 0.0008f;
    stone.color_a = stone.color_a * 1.06f, stone.color_b = stone.color_b * 1.04f;
    return add_material(room, stone);
}

}  // namespace

void build_arcade_arch(const Opening& o, const WallFace& face, Room& room, int wall, int object) {
    constexpr float kColumn_m = 0.085f, kBase_m = 0.12f, kCapital_m = 0.17f, kSill_m = 0.09f, kReach_m = 0.05f,
                    kRoll_m = 0.07f;
    const int stone = carved_stone(room, wall);
    const WallBuilder build(face, room);
    const float spring = o.y1 - arch_rise(o), foot = o.y0, middle = -0.5f * kWallThickness;
    // The slab that they stand on.
    build.box(o.u0 - kReach_m, o.u1 + kReach_m, foot - kSill_m, foot + kHair_m, -kWallThickness - kReach_m, kReach_m,
              stone, object);
    const auto put = [&](Mesh mesh, float u) {
        shapes::move(mesh, face.point(u, 0) + face.inward * middle);
        mesh.material = stone, mesh.object = object;
        room.meshes.push_back(std::move(mesh));
    };
    for (const float u : {o.u0 + kColumn_m, o.u1 - kColumn_m}) {
        const std::array<Vec2f, 12> profile{Vec2f{1.5f * kColumn_m, foot},
                                            {1.5f * kColumn_m, foot + 0.3f * kBase_m},
                                            {1.42f * kColumn_m, foot + 0.4f * kBase_m},
                                            {1.15f * kColumn_m, foot + 0.6f * kBase_m},
                                            {1.25f * kColumn_m, foot + 0.8f * kBase_m},
                                            {kColumn_m, foot + kBase_m},
                                            {0.92f * kColumn_m, spring - kCapital_m},
                                            {1.1f * kColumn_m, spring - 0.95f * kCapital_m},
                                            {1.02f * kColumn_m, spring - 0.85f * kCapital_m},
                                            {1.2f * kColumn_m, spring - 0.55f * kCapital_m},
                                            {1.6f * kColumn_m, spring - 0.22f * kCapital_m},
                                            {1.6f * kColumn_m, spring - 0.2f * kCapital_m}};
        put(shapes::lathe(profile, 24), u);
        build.box(u - 1.75f * kColumn_m, u + 1.75f * kColumn_m, spring - 0.2f * kCapital_m, spring, middle - 0.14f,
                  middle + 0.14f, stone, object);
    }
    // Mouldings about the arch on both sides of the wall.
    if (o.shape != Opening::Shape::arched) return;
    for (const auto& [w0, w1] : {std::pair{0.f, 0.03f}, std::pair{-kWallThickness - 0.03f, -kWallThickness}})
        build.band(edge_of(o, 0), edge_of(o, kRoll_m), w0, w1, stone, object);
}

}  // namespace fastscene::shell
