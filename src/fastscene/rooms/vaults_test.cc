// Octagonal and round rooms, apses, vaults: geometry that all who furnish, build and walk rely on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/validate.h"

namespace fastscene {
namespace {

Plan plan_with(Outline outline, float width, float depth, Vault vault = Vault::flat, float oculus = 0) {
    Plan plan;
    plan.width = width, plan.depth = depth, plan.height = 4, plan.measured = true;
    plan.style = style_named("classic");
    cut_corners(outline, plan);
    plan.vault = vault, plan.spring = vault == Vault::flat ? 0.f : 2.6f, plan.oculus = oculus;
    return plan;
}
const std::vector<Plan>& plans() {
    static const std::vector<Plan> all{plan_with(Outline::octagon, 5, 5),
                                       plan_with(Outline::octagon, 6, 4.4f, Vault::dome),
                                       plan_with(Outline::round, 5, 5, Vault::cone),
                                       plan_with(Outline::round, 7, 4.6f, Vault::dome, 0.5f),
                                       plan_with(Outline::apse, 8, 12, Vault::barrel),
                                       plan_with(Outline::box, 4, 6, Vault::dome),
                                       plan_with(Outline::box, 4, 6, Vault::barrel)};
    return all;
}

float turn(Vec2f u, Vec2f v) { return u.x * v.y - u.y * v.x; }
float to_segment(Vec2f a, Vec2f b, Vec2f p) {
    const float t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.f, 1.f);
    return length(p - (a + (b - a) * t));
}
bool is_within(const std::vector<Vec2f>& outline, Vec2f p) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2f a = outline[i], b = outline[(i + 1) % outline.size()];
        if (turn(b - a, p - a) > 1e-5f) return false;
    }
    return true;
}

TEST(Outlines, AreConvexInTheOrderOfTheWalls) {
    for (const Plan& plan : plans()) {
        const std::vector<Vec2f> outline = plan.outline();
        ASSERT_GE(outline.size(), 4u);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2f a = outline[i], b = outline[(i + 1) % outline.size()], c = outline[(i + 2) % outline.size()];
            EXPECT_LE(turn(b - a, c - b), 1e-5f);
            EXPECT_LE(std::abs(a.x), plan.width / 2 + 1e-5f);
            EXPECT_LE(std::abs(a.y), plan.depth / 2 + 1e-5f);
        }
    }
    const std::vector<Vec2f> octagon = plans()[0].outline();
    ASSERT_EQ(octagon.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(length(octagon[(i + 1) % 8] - octagon[i]), 5 * (std::sqrt(2.f) - 1), 1e-3f);
}

TEST(Outlines, LeaveAFlatPieceOfEachWallForADoor) {
    for (const Plan& plan : plans())
        for (int wall = 0; wall < 4; ++wall) {
            const auto [low, high] = plan.free_span(wall, 2);
            EXPECT_GE(high - low, 1.49f);
        }
}

TEST(Outlines, FacesLieOnThemAndChordsBefore) {
    for (const Plan& plan : plans()) {
        const std::vector<Vec2f> outline = plan.outline();
        float around = 0, on_faces = 0;
        for (std::size_t i = 0; i < outline.size(); ++i)
            around += length(outline[(i + 1) % outline.size()] - outline[i]);
        for (const WallFace& face : plan.faces()) {
            EXPECT_NEAR(length(face.along), 1, 1e-5f);
            EXPECT_NEAR(dot(face.along, face.inward), 0, 1e-5f);
            const Vec2f middle = flat(face.point(face.length / 2, 0));
            EXPECT_LT(dot(flat(face.inward), middle), 0.f) << "it looks into the room";
            for (const float u : {0.f, face.length}) EXPECT_TRUE(is_within(outline, flat(face.point(u, 0)) * 0.999f));
            if (face.behind > 0) continue;
            EXPECT_NEAR(plan.wall_distance(middle), 0, 1e-4f);
            on_faces += face.length;
        }
        EXPECT_NEAR(on_faces, around, 1e-3f);
    }
}

TEST(Outlines, WallDistanceIsThatToTheNearestWall) {
    Random rng(5, "points");
    for (const Plan& plan : plans()) {
        const std::vector<Vec2f> outline = plan.outline();
        for (int k = 0; k < 400; ++k) {
            const Vec2f p{plan.width * (rng.uniform() - 0.5f), plan.depth * (rng.uniform() - 0.5f)};
            if (!is_within(outline, p)) {
                EXPECT_LT(plan.wall_distance(p), 1e-3f);
                continue;
            }
            float near = 1e9f;
            for (std::size_t i = 0; i < outline.size(); ++i)
                near = std::min(near, to_segment(outline[i], outline[(i + 1) % outline.size()], p));
            EXPECT_NEAR(plan.wall_distance(p), near, 1e-4f);
        }
    }
}

TEST(Outlines, HoldWhatHasAllItsCornersInTheRoomBelowTheCeiling) {
    Random rng(6, "boxes");
    int held = 0, refused = 0;
    for (const Plan& plan : plans()) {
        const std::vector<Vec2f> outline = plan.outline();
        for (int k = 0; k < 2000; ++k) {
            const Footprint box{{plan.width * (rng.uniform() - 0.5f), plan.depth * (rng.uniform() - 0.5f)},
                                {0.05f + rng.uniform(), 0.05f + 0.5f * rng.uniform()},
                                2 * kPi * rng.uniform(),
                                0,
                                4.2f * rng.uniform()};
            bool within = true, inside = true;
            for (const Vec2f corner : corners_of(box)) {
                within = within && is_within(outline, corner * 1.01f) && box.y1 < plan.ceiling_at(corner) - 0.02f;
                inside = inside && is_within(outline, corner) && box.y1 < plan.ceiling_at(corner) + 0.02f;
            }
            EXPECT_TRUE(!within || plan.holds(box));
            EXPECT_TRUE(inside || !plan.holds(box));
            held += within, refused += !inside;
        }
    }
    EXPECT_GT(held, 500);
    EXPECT_GT(refused, 500);
}

TEST(Vaults, SpringFromTheWallsAndRiseToTheMiddle) {
    for (const Plan& plan : plans()) {
        if (plan.vault == Vault::flat) continue;
        EXPECT_NEAR(plan.ceiling_at({0, 0}), plan.height, 1e-3f);
        const std::vector<Vec2f> outline = plan.outline();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2f foot = (outline[i] + outline[(i + 1) % outline.size()]) * 0.5f;
            const bool gable = plan.vault == Vault::barrel && std::abs(std::abs(foot.y) - plan.depth / 2) < 1e-3f &&
                               foot.y < conch_from(plan) + 1e-3f;
            EXPECT_NEAR(gable ? plan.spring : plan.ceiling_at(foot), plan.spring, 0.02f);
            float before = 0;
            for (float t = 1; t >= 0; t -= 0.1f) {
                const float now = plan.ceiling_at(foot * t);
                EXPECT_GE(now, before - 1e-4f);
                before = now;
            }
        }
    }
}

// The meshes and ceiling_at are two ways to the same surface.
TEST(Vaults, AreBuiltWhereTheCeilingIsSaidToBe) {
    for (const Plan& plan : plans()) {
        if (plan.vault == Vault::flat) continue;
        Room room;
        build_shell(plan, room);
        int checked = 0;
        for (const Mesh& mesh : room.meshes) {
            constexpr int kCeiling = 4;  // after walls, accent, trim and floor
            if (mesh.material != kCeiling || mesh.object >= 0) continue;
            for (const Vec3f p : mesh.positions) {
                // It lies on the walls, and ends at them.
                if (p.y > plan.height - 1e-3f || p.y < plan.spring + 1e-3f) continue;
                const float z = std::clamp(p.z, -plan.depth / 2, plan.depth / 2);
                EXPECT_NEAR(p.y, plan.ceiling_at({p.x, z}), 0.02f) << p.x << " " << p.z;
                ++checked;
            }
        }
        EXPECT_GT(checked, 40);
    }
}

// Whether a ray meets one of the room's triangles.
bool meets(const Room& room, Vec3f from, Vec3f way) {
    for (const Mesh& mesh : room.meshes)
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const Vec3f a = mesh.positions[mesh.triangles[t]], u = mesh.positions[mesh.triangles[t + 1]] - a,
                        v = mesh.positions[mesh.triangles[t + 2]] - a, h = cross(way, v), s = from - a;
            const float det = dot(u, h);
            if (std::abs(det) < 1e-9f) continue;
            const float b = dot(s, h) / det, c = dot(way, cross(s, u)) / det;
            if (b > -1e-4f && c > -1e-4f && b + c < 1.0001f && dot(v, cross(s, u)) / det > 0) return true;
        }
    return false;
}

TEST(Vaults, LetNoLightInButThroughTheirOculus) {
    Random rng(7, "rays");
    for (const Plan& plan : plans()) {
        Room room;
        build_shell(plan, room);
        EXPECT_EQ(room.portals.size(), plan.oculus > 0 ? 1u : 0u);
        const Vec3f eye{0.1f, 1.5f, -0.2f};
        for (int k = 0; k < 300; ++k) {
            const float y = 2 * rng.uniform() - 1, a = 2 * kPi * rng.uniform(), r = std::sqrt(1 - y * y);
            const Vec3f way{r * std::cos(a), y, r * std::sin(a)};
            const Vec3f top = eye + way * ((plan.height + 0.2f - eye.y) / std::max(1e-3f, way.y));
            const bool open = way.y > 0 && std::hypot(top.x, top.z) < 1.5f * plan.oculus;
            EXPECT_TRUE(open || meets(room, eye, way));
        }
    }
}

TEST(Vaults, AnyHomeMayBeRoundOrOctagonalOrDomed) {
    std::uint64_t count = 0;
    for (const char* room : {"bedroom", "living room", "kitchen", "study", "bathroom", "library", "dining room"})
        for (const char* shape :
             {"an octagonal ROOM", "a round ROOM", "a ROOM with a domed ceiling", "a small ROOM with a barrel vault"}) {
            std::string text = shape;
            text.replace(text.find("ROOM"), 4, room);
            SCOPED_TRACE(text);
            const std::uint64_t seed = 1 + (count + count / 4) % 2;  // both for each room and each of the four shapes
            ++count;
            PromptSpec spec = understand_prompt(text, true);
            const fastscene::Run run{seed, nullptr, {}};
            const FurnishedRoom furnished = furnish_room(spec, run);
            for (const Fault& fault : room_faults(furnished.plan, furnished.placed, furnished.camera))
                ADD_FAILURE() << fault.kind << ": " << fault.text;
            EXPECT_TRUE(spec.not_placed.empty()) << spec.not_placed.front();
            EXPECT_GE(furnished.placed.size(), 6u);
            const RoomDocument document = document_of(spec, furnished, seed);
            const std::string json = document_json(document).dump(2);
            EXPECT_EQ(document_json(read_document(json, "room.json")).dump(2), json);
        }
}

// Pews of two metres stand in narrow churches too, with narrower ways beside them.
TEST(Vaults, AChurchHasPewsOnBothSidesOfItsAisle) {
    for (const char* text : {"a church", "a small church"})
        for (std::uint64_t seed = 1; seed < 9; ++seed) {
            PromptSpec spec = understand_prompt(text, true);
            const FurnishedRoom furnished = furnish_room(spec, {seed, nullptr, {}});
            const auto pews = std::count_if(furnished.placed.begin(), furnished.placed.end(),
                                            [](const Placed& p) { return p.piece.kind == "pew"; });
            EXPECT_GE(pews, 8) << text << ", seed " << seed;
        }
}

TEST(Mezzanines, AreFurnishedAboveAndBelowAndReachedByStairs) {
    for (const char* text :
         {"a living room with a mezzanine", "a bedroom with a mezzanine", "a library with a mezzanine",
          "a bookstore with a mezzanine", "an industrial loft with a mezzanine"})
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            SCOPED_TRACE(std::string(text) + ", seed " + std::to_string(seed));
            PromptSpec spec = understand_prompt(text, true);
            const fastscene::Run run{seed, nullptr, {}};
            const FurnishedRoom furnished = furnish_room(spec, run);
            const Plan& plan = furnished.plan;
            ASSERT_GT(plan.mezzanine.depth, 2);
            EXPECT_GE(plan.mezzanine.floor - kMezzanineSlab, 2.3f) << "one walks below it";
            EXPECT_GE(plan.height - plan.mezzanine.floor, 2.1f) << "one stands on it";
            EXPECT_LT(furnished.camera.z, plan.mezzanine_edge());
            for (const Fault& fault : room_faults(plan, furnished.placed, furnished.camera))
                ADD_FAILURE() << fault.kind << ": " << fault.text;
            EXPECT_TRUE(spec.not_placed.empty()) << spec.not_placed.front();
            EXPECT_GE(furnished.placed_next.size(), 3u);
            for (const Placed& p : furnished.placed_next) {
                EXPECT_GE(p.position.y, plan.mezzanine.floor - 0.01f) << p.piece.kind;
                EXPECT_GT(p.position.z, plan.mezzanine_edge()) << p.piece.kind;
            }
            const auto stairs = std::find_if(plan.blocks.begin(), plan.blocks.end(),
                                             [](const Block& b) { return b.kind == Block::Kind::stairs; });
            ASSERT_NE(stairs, plan.blocks.end());
            for (const Placed& p : furnished.placed)
                EXPECT_FALSE(overlap(footprint_of(p, -0.01f), {(stairs->low + stairs->high) * 0.5f,
                                                               (stairs->high - stairs->low) * 0.5f, 0, 0, 2}))
                    << p.piece.kind;
            const std::string json = document_json(document_of(spec, furnished, seed)).dump(2);
            DocumentRoom again = furnish_document(read_document(json, "room.json"), "room.json", nullptr, run);
            EXPECT_EQ(document_json(document_of(again.spec, again.furnished, seed)).dump(2), json);
        }
}

TEST(Mezzanines, WhereThereIsNoRoomThatIsSaid) {
    for (const char* text : {"a bedroom with a mezzanine and a ceiling 2.6 m high", "an attic with a mezzanine",
                             "a living room 3 by 4 m with a mezzanine"}) {
        PromptSpec spec = understand_prompt(text, false);
        const FurnishedRoom furnished = furnish_room(spec, {3, nullptr, {}});
        EXPECT_EQ(furnished.plan.mezzanine.depth, 0) << text;
        EXPECT_FALSE(spec.not_placed.empty()) << text;
    }
}

TEST(Vaults, WhatCannotBeIsSaid) {
    for (const char* text : {"an attic with a domed ceiling", "a bedroom with a dome and a ceiling 2.3 m high"}) {
        PromptSpec spec = understand_prompt(text, false);
        const FurnishedRoom furnished = furnish_room(spec, {3, nullptr, {}});
        EXPECT_EQ(furnished.plan.vault, Vault::flat) << text;
        EXPECT_FALSE(spec.not_placed.empty()) << text;
    }
}

}  // namespace
}  // namespace fastscene
