#include "fastscene/rooms/layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fastscene/rooms/lexicon.h"

namespace fastscene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Furnished {
    PromptSpec spec;
    Plan plan;
    std::vector<Placed> placed;
};

Furnished furnished(const std::string& text, std::uint64_t seed) {
    Furnished out{understand_prompt(text, false), {}, {}};
    Random dice(seed, "layout test");
    out.plan = make_plan(out.spec, dice);
    Layout layout(out.plan, out.spec, dice);
    furnish(layout);
    out.placed = layout.placed();
    return out;
}

TEST(Footprint, OverlapOfTurnedBoxes) {
    const Footprint a{{0, 0}, {1, 1}, 0, 0, 1};
    EXPECT_TRUE(overlap(a, {{1.5f, 0}, {1, 1}, 0, 0, 1}));
    EXPECT_FALSE(overlap(a, {{2.f, 0}, {1, 1}, 0, 0, 1})) << "touching is no overlap";
    EXPECT_FALSE(overlap(a, {{0, 0}, {1, 1}, 0, 1, 2})) << "one above the other";
    // A diamond reaches sqrt(2) along x, but its sides leave the square's corner free.
    EXPECT_TRUE(overlap(a, {{2.3f, 0}, {1, 1}, kPi / 4, 0, 1}));
    EXPECT_FALSE(overlap(a, {{2.45f, 0}, {1, 1}, kPi / 4, 0, 1}));
    EXPECT_FALSE(overlap(a, {{1.8f, 1.8f}, {1, 1}, kPi / 4, 0, 1}));
}

TEST(Footprint, DistanceToABox) {
    const Footprint box{{1, 2}, {2, 0.5f}, kPi / 2, 0, 1};  // turned: 0.5 along x, 2 along z
    EXPECT_NEAR(distance_to(box, {1, 2}), 0.f, 1e-6f);
    EXPECT_NEAR(distance_to(box, {3, 2}), 1.5f, 1e-5f);
    EXPECT_NEAR(distance_to(box, {1, 5}), 1.f, 1e-5f);
    EXPECT_NEAR(distance_to(box, {4.5f, 8}), 5.f, 1e-5f);
}

TEST(Layout, NothingIsWrongInAnyRoomOfAnyStyle) {
    for (const std::string& room : room_types())
        for (const std::string& style : styles())
            for (const std::uint64_t seed : {1u, 2u}) {
                const Furnished f = furnished("a " + style + " " + room_title(room), seed);
                const std::vector<std::string> faults = layout_faults(f.plan, f.placed);
                EXPECT_TRUE(faults.empty()) << style << " " << room << ", seed " << seed << ": " << faults.size() << ", first: " << faults.front();
            }
}

TEST(Layout, PiecesWithABackStandAtAWallAndLookIntoTheRoom) {
    for (const std::uint64_t seed : {1u, 2u, 3u})
        for (const char* text : {"a living room", "a bedroom", "a study", "a kitchen", "a bathroom"}) {
            const Furnished f = furnished(text, seed);
            for (const Placed& p : f.placed) {
                for (const char* klass : {"bed", "wardrobe", "bookshelf", "tv_stand", "fireplace", "fridge", "kitchen_counter", "washbasin", "picture", "mirror"}) {
                    if (p.piece.klass != klass || (p.piece.mount != Mount::wall && p.piece.mount != Mount::floor)) continue;
                    const Footprint box = footprint_of(p);
                    const Vec2f front{std::sin(p.yaw), std::cos(p.yaw)}, back = box.center - front * box.half.y;
                    // The back is at the wall behind it.
                    const float wall = std::abs(front.x) > 0.5f ? f.plan.width / 2 - std::abs(back.x) : f.plan.depth / 2 - std::abs(back.y);
                    EXPECT_LT(wall, 0.12f) << text << ": " << klass;
                    EXPECT_LT(dot(front, back), 0.f) << text << ": " << klass << " faces the wall";
                }
            }
        }
}

TEST(Layout, SmallThingsStandOnWhatCarriesThem) {
    for (const char* text : {"a cluttered living room", "a cozy bedroom", "a lamp on the desk in a study"})
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            const Furnished f = furnished(text, seed);
            int carried = 0;
            for (const Placed& p : f.placed) {
                if (p.piece.mount != Mount::surface && p.on < 0) continue;
                ASSERT_GE(p.on, 0) << p.piece.klass << " floats";
                const Placed& below = f.placed[static_cast<std::size_t>(p.on)];
                bool at_a_top = false;
                for (const Surface& s : below.piece.surfaces) at_a_top = at_a_top || std::abs(below.position.y + s.center.y - p.position.y) < 1e-3f;
                EXPECT_TRUE(at_a_top) << p.piece.klass << " on " << below.piece.klass;
                EXPECT_LT(distance_to(footprint_of(below), footprint_of(p).center), 1e-3f);
                ++carried;
            }
            EXPECT_GT(carried, 0) << text;
        }
}

TEST(Layout, RelationsHold) {
    int under = 0, on = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Furnished f = furnished("a bedroom with a desk under the window and a lamp on the desk", seed);
        for (const Placed& p : f.placed) {
            if (p.piece.klass == "table_lamp" && !p.wish.klass.empty()) on += p.on >= 0 && f.placed[static_cast<std::size_t>(p.on)].piece.klass == "desk";
            if (p.piece.klass != "desk") continue;
            for (const Opening& o : f.plan.openings) {
                if (o.kind != Opening::Kind::window) continue;
                const WallFace face = f.plan.wall(o.wall);
                const float u = dot(p.position - face.origin, face.along), off = dot(p.position - face.origin, face.inward);
                if (off < 0.7f && u > o.u0 - 0.7f && u < o.u1 + 0.7f) {
                    ++under;
                    break;
                }
            }
        }
    }
    EXPECT_EQ(on, 6);
    EXPECT_GE(under, 5);
}

TEST(Layout, PicturesHangAtEyeHeight) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const Furnished f = furnished("a modern living room with three pictures", seed);
        int pictures = 0;
        for (const Placed& p : f.placed) {
            if (p.piece.klass != "picture" || p.on >= 0) continue;
            ++pictures;
            const float middle = p.position.y + p.piece.size_m.y / 2;
            EXPECT_GT(middle, 1.1f);
            EXPECT_LT(middle, 2.1f);
        }
        EXPECT_GE(pictures, 3);
    }
}

TEST(Layout, NothingHangsBeforeAWindow) {
    for (const std::string& room : room_types())
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            const Furnished f = furnished("a " + room_title(room) + " with a mirror and two pictures", seed);
            for (const Placed& p : f.placed) {
                if (p.piece.klass != "mirror" && p.piece.klass != "picture") continue;
                const Footprint box = footprint_of(p);
                for (const Opening& o : f.plan.openings) {
                    const WallFace face = f.plan.wall(o.wall);
                    const Vec3f at = p.position - face.origin;
                    const float u = dot(at, face.along);
                    if (std::abs(dot(at, face.inward)) > 0.1f || p.on >= 0) continue;
                    EXPECT_FALSE(u + box.half.x > o.u0 && u - box.half.x < o.u1 && box.y0 < o.y1 && box.y1 > o.y0) << room << ", seed " << seed << ": " << p.piece.klass;
                }
            }
        }
}

TEST(Layout, CurtainsHangBeforeTheirWindow) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const Furnished f = furnished("a bedroom with red curtains", seed);
        int curtains = 0;
        for (const Placed& p : f.placed) {
            if (p.piece.klass != "curtain") continue;
            ++curtains;
            bool before = false;
            for (const Opening& o : f.plan.openings) {
                if (o.kind != Opening::Kind::window) continue;
                const WallFace face = f.plan.wall(o.wall);
                const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0);
                before = before || (distance_to(footprint_of(p), {middle.x, middle.z}) < 0.15f && p.position.y + p.piece.size_m.y > o.y1);
            }
            EXPECT_TRUE(before);
        }
        EXPECT_GE(curtains, 1) << "seed " << seed;
    }
}

TEST(Layout, NothingIsPutOnSeats) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const Furnished f = furnished("a cluttered living room with an armchair and a sofa", seed);
        for (const Placed& p : f.placed) {
            if (p.on < 0 || p.piece.klass == "cushion" || p.piece.klass == "cat") continue;
            const std::string& below = f.placed[static_cast<std::size_t>(p.on)].piece.klass;
            EXPECT_TRUE(below != "armchair" && below != "sofa" && below != "chair") << p.piece.klass << " on " << below;
        }
    }
}

TEST(Layout, FaultsAreFound) {
    Furnished f = furnished("a living room with a sofa", 1);
    ASSERT_FALSE(f.placed.empty());
    f.placed.push_back(f.placed.front());
    EXPECT_FALSE(layout_faults(f.plan, f.placed).empty()) << "two pieces in one place";
    f.placed.pop_back();
    f.placed.front().position.x += 10.f;
    EXPECT_FALSE(layout_faults(f.plan, f.placed).empty()) << "outside";
}

}  // namespace
}  // namespace fastscene
