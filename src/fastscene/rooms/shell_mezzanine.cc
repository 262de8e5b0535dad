// A mezzanine: slab, edge beam, railing, and stairs without risers.
#include <cmath>

#include "fastscene/rooms/shapes.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

constexpr float kRailing = 0.95f, kBalusters = 0.11f;  // height; from one to the next

class Builder {
  public:
    Builder(const Plan& plan, int floor, int wood, int metal, int object, Room& room)
        : plan_(plan), floor_(floor), wood_(wood), metal_(metal), object_(object), room_(room) {}

    void slab() {
        const float w = plan_.width / 2, edge = plan_.mezzanine_edge(), top = plan_.mezzanine.floor;
        box({-w, top - kMezzanineSlab, edge}, {w, top, plan_.depth / 2}, floor_);
        constexpr float kBeam = 0.07f, kBelow = 0.05f;  // thickness of the edge beam; how far it hangs below the slab
        box({-w, top - kMezzanineSlab - kBelow, edge - kBeam}, {w, top + 0.01f, edge}, metal_);
    }
    // Along the edge, but for where the stairs arrive.
    void railing() {
        const float w = plan_.width / 2, z = plan_.mezzanine_edge() - 0.035f, y = plan_.mezzanine.floor;
        const float low = plan_.mezzanine.stairs_wall == 3 ? kMezzanineStairs - w : -w,
                    high = plan_.mezzanine.stairs_wall == 1 ? w - kMezzanineStairs : w;
        bars({low + 0.03f, y, z}, {high - 0.03f, y, z});
    }
    void stairs() {
        const float side = plan_.mezzanine.stairs_wall == 1 ? 1.f : -1.f, edge = plan_.mezzanine_edge() - 0.07f,
                    rise = plan_.mezzanine.floor / kMezzanineSteps, wall = side * (plan_.width / 2 - 0.01f),
                    open = side * (plan_.width / 2 - kMezzanineStairs);
        constexpr float kTread = 0.035f, kNosing = 0.03f, kString = 0.045f;
        for (int i = 1; i < kMezzanineSteps; ++i) {
            const float y = rise * static_cast<float>(i),
                        z = edge - kMezzanineGoing * static_cast<float>(kMezzanineSteps - i);
            box({std::min(wall, open), y - kTread, z - kNosing}, {std::max(wall, open), y, z + kMezzanineGoing}, wood_);
        }
        // Strings below the treads' ends, a rail on the open side.
        const Vec3f foot{0, 0.02f, edge - kMezzanineGoing * kMezzanineSteps + 0.06f},
            top{0, plan_.mezzanine.floor - 0.1f, edge - 0.02f};
        for (const float x : {wall - side * kString, open + side * kString})
            string(foot + Vec3f{x, 0, 0}, top + Vec3f{x, 0, 0}, kString);
        const float x = open + side * 0.03f;
        bars({x, rise, edge - kMezzanineGoing * (kMezzanineSteps - 1) + 0.08f},
             {x, plan_.mezzanine.floor, edge - 0.03f});
    }

  private:
    void add(Mesh mesh, int material) {
        mesh.material = material, mesh.object = object_;
        room_.meshes.push_back(std::move(mesh));
    }
    void box(Vec3f low, Vec3f high, int material) { room_.meshes.push_back(box_mesh(low, high, material, object_)); }
    // Balusters from a to b, a rail on them.
    void bars(Vec3f a, Vec3f b) {
        const int count = std::max(2, static_cast<int>(std::lround(length(b - a) / kBalusters)));
        const Vec3f up{0, kRailing, 0};
        for (int i = 0; i <= count; ++i) {
            const Vec3f foot = lerp(a, b, static_cast<float>(i) / static_cast<float>(count));
            const bool post = i % 10 == 0 || i == count;
            add(shapes::rod(foot, foot + up, post ? 0.018f : 0.007f, post ? 0.018f : 0.007f, 8), metal_);
        }
        add(shapes::rod(a + up, b + up, 0.024f, 0.024f, 12), wood_);
    }
    // A board on edge from a to b.
    void string(Vec3f a, Vec3f b, float thick) {
        constexpr float kHigh = 0.2f;
        const Vec3f along = b - a, upright = normalize(cross(along, Vec3f{1, 0, 0}));
        Mesh board = box_mesh({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}, metal_, object_);
        const Vec3f across{thick, 0, 0}, middle = (a + b) * 0.5f, high = upright * kHigh, forward = normalize(along);
        for (Vec3f& p : board.positions) p = middle + across * p.x + high * p.y + along * p.z;
        for (Vec3f& n : board.normals) n = Vec3f{1, 0, 0} * n.x + upright * n.y + forward * n.z;
        board.coords = board.positions;
        if (dot(cross(across, high), along) < 0)
            for (std::size_t t = 0; t < board.triangles.size(); t += 3)
                std::swap(board.triangles[t + 1], board.triangles[t + 2]);
        room_.meshes.push_back(std::move(board));
    }

    const Plan& plan_;
    int floor_, wood_, metal_, object_;
    Room& room_;
};

}  // namespace

void build_mezzanine(const Plan& plan, const Materials& m, Room& room) {
    const Material& wood = plan.style.wood;
    const int boards = plan.style.floor.pattern == Pattern::carpet ? add_material(room, wood) : m.floor;
    const int object = part_object(plan, room, "mezzanine",
                                   {plan.width, kMezzanineSlab + kRailing, plan.mezzanine.depth});
    room.objects.back().world_from_object.translation = {0, plan.mezzanine.floor - kMezzanineSlab,
                                                         plan.depth / 2 - plan.mezzanine.depth / 2};
    Builder builder(plan, boards, add_material(room, as_asked(plan, "mezzanine", wood)),
                    add_material(room, *material_named("iron")), object, room);
    builder.slab();
    builder.railing();
    builder.stairs();
}

}  // namespace fastscene::shell
