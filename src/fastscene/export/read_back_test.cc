// Our own rooms, read as people's models are.
#include <gtest/gtest.h>

#include "fastscene/export/meshopt.h"
#include "fastscene/export/room_glb.h"
#include "fastscene/export/test_rooms.h"
#include "fastscene/io/gltf_model.h"

namespace fastscene {
namespace {

TEST(RoomGlb, IsReadBackAsAModel) {
    const Room room = room_from("a bathroom with a stool");
    const BakeParams params{.texels_per_metre = 16};
    const RoomModel model = room_model(room, params, {});
    std::size_t triangles = 0;
    for (const ModelNode& node : model.nodes)
        if (node.mesh >= 0)
            for (const ModelPart& part : model.meshes[static_cast<std::size_t>(node.mesh)].parts)
                for (std::size_t t = 0; t < part.triangles.size(); t += 3) {
                    const auto p = [&](std::size_t i) { return part.positions[part.triangles[t + i]]; };
                    triangles += length(cross(p(1) - p(0), p(2) - p(0))) > 0;
                }
    const std::string glb = room_glb_bytes(room, model);
    const auto none = [](const std::string&) -> std::optional<std::string> { return {}; };
    const GltfModel plain = read_gltf_bytes(glb, "room.glb", none),
                    packed = read_gltf_bytes(with_meshopt(glb), "packed.glb", none);
    // A node's turn may flatten the thinnest slivers, rounding of the compression others.
    EXPECT_NEAR(static_cast<double>(plain.triangle_count), static_cast<double>(triangles), 1e-3 * triangles);
    EXPECT_NEAR(static_cast<double>(packed.triangle_count), static_cast<double>(triangles), 0.01 * triangles);
    EXPECT_EQ(plain.materials.size(), packed.materials.size());
    EXPECT_EQ(plain.images.size(), model.textures.size());
    EXPECT_EQ(packed.images.size(), model.textures.size());
    ASSERT_EQ(plain.groups.size(), packed.groups.size());
    for (std::size_t g = 0; g < plain.groups.size(); ++g) {
        Vec3f low{1e9f, 1e9f, 1e9f}, high = -low;
        for (const Vec3f p : plain.groups[g].positions)
            for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
        for (const Vec3f p : packed.groups[g].positions)
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_GT(p[k], low[k] - 1e-3f);
                EXPECT_LT(p[k], high[k] + 1e-3f);
            }
    }
}

}  // namespace
}  // namespace fastscene
