// What hangs on walls, in windows and from ceilings because somebody asked for it: where it belongs, within it, lit
// when it should be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/test_prompts.h"
#include "fastscene/rooms/validate.h"

namespace fastscene {
namespace {

struct Hung {
    PromptSpec spec;
    FurnishedRoom room;
    std::vector<const Placed*> all(const std::string& kind) const {
        std::vector<const Placed*> out;
        for (const Placed& p : room.placed)
            if (p.piece.kind == kind) out.push_back(&p);
        return out;
    }
};
Hung hung_room(const std::string& text, std::uint64_t seed = 1) {
    Hung h;
    h.spec = read(text);
    h.room = furnish_room(h.spec, {seed, nullptr, {}});
    return h;
}
float brightest(const Room& room, const std::string& kind) {
    float most = 0;
    for (const Mesh& m : room.meshes)
        if (m.object >= 0 && room.objects[static_cast<std::size_t>(m.object)].kind == kind)
            most = std::max(most, luminance(room.materials[static_cast<std::size_t>(m.material)].emission));
    return most;
}
Room built(Hung h) { return room_of(h.spec, h.room, {1, nullptr, {}}); }
Room lit_room(const std::string& text) {
    PromptSpec spec = read(text);
    return make_room(spec, {1, nullptr, {}});
}

TEST(WallThings, WhatIsAskedForIsUnderstoodAndHangsWhereItBelongs) {
    for (const auto& [text, kind, mount] : {std::tuple{"a bedroom with a wall sconce", "wall_lamp", Mount::wall},
                                            {"a living room with a blue neon sign", "neon_sign", Mount::wall},
                                            {"a study with a whiteboard", "whiteboard", Mount::wall},
                                            {"a kitchen with a blackboard", "chalkboard", Mount::wall},
                                            {"a study with a cork board", "pin_board", Mount::wall},
                                            {"a boho bedroom with a tapestry", "tapestry", Mount::wall},
                                            {"a boho bedroom with a macrame wall hanging", "macrame", Mount::wall},
                                            {"a cabin living room with antlers", "antlers", Mount::wall},
                                            {"a rustic dining room with a deer head", "deer_head", Mount::wall},
                                            {"a kids room with a world map", "world_map", Mount::wall},
                                            {"a loft with a dartboard", "dartboard", Mount::wall},
                                            {"a dining room with a red flag", "flag", Mount::wall},
                                            {"a living room with a ceiling fan", "ceiling_fan", Mount::ceiling},
                                            {"a loft with a disco ball", "disco_ball", Mount::ceiling},
                                            {"a kitchen with track lighting", "track_light", Mount::ceiling},
                                            {"a dining room with edison bulbs", "bulb_pendant", Mount::ceiling},
                                            {"a bedroom with a paper lantern", "paper_lantern", Mount::ceiling},
                                            {"a sunroom with hanging plants", "hanging_plant", Mount::ceiling},
                                            {"a hallway with a grandfather clock", "grandfather_clock", Mount::floor},
                                            {"a kids room with a teepee", "play_tent", Mount::floor},
                                            {"a living room with a bar cart", "bar_cart", Mount::floor},
                                            {"a study with a cactus", "cactus", Mount::surface},
                                            {"a living room with a large cactus", "cactus", Mount::floor},
                                            {"a study with a fish bowl", "fish_bowl", Mount::surface},
                                            {"a living room with a lantern", "lantern", Mount::surface}}) {
        const Hung h = hung_room(text);
        SCOPED_TRACE(text);
        const PromptObject* wish = object_of(h.spec, kind);
        ASSERT_TRUE(wish);
        const auto there = h.all(kind);
        ASSERT_GE(static_cast<int>(there.size()), wish->count);
        EXPECT_EQ(there.front()->piece.mount, mount);
        EXPECT_EQ(h.room.hidden_wishes, 0);
        for (const Fault& f : room_faults(h.room.plan, h.room.placed, h.room.camera)) ADD_FAILURE() << f.text;
    }
}

// In every window, within its reveal; what is drawn up hangs from its head.
TEST(WallThings, BlindsHangWithinTheirWindows) {
    for (const auto& [words, kind] : {std::pair{"venetian blinds", "venetian_blind"},
                                      {"roller shades", "roller_blind"},
                                      {"roman blinds", "roman_blind"},
                                      {"shutters", "shutters"},
                                      {"shoji screens", "shoji"}})
        for (const std::string room : {"modern living room", "rustic kitchen", "japandi bedroom", "classic study"})
            for (const std::uint64_t seed : {1u, 2u}) {
                const Hung h = hung_room("a " + room + " with " + words, seed);
                SCOPED_TRACE(room + " with " + words);
                const auto windows = std::count_if(h.room.plan.openings.begin(), h.room.plan.openings.end(),
                                                   [](const Opening& o) { return o.kind == Opening::Kind::window; });
                const auto there = h.all(kind);
                EXPECT_EQ(static_cast<long>(there.size()), windows);
                for (const Placed* p : there) {
                    EXPECT_TRUE(hangs_in_window(h.room.plan, *p));
                    const Opening& o = h.room.plan.openings[static_cast<std::size_t>(p->sill)];
                    EXPECT_NEAR(p->position.y + p->piece.size_m.y, o.y1, 0.002f);
                    EXPECT_GT(p->piece.size_m.x, 0.95f * (o.u1 - o.u0));
                }
                EXPECT_TRUE(h.all("curtain").empty()) << "who asks for blinds has no curtains by himself";
                for (const Fault& f : room_faults(h.room.plan, h.room.placed, h.room.camera)) ADD_FAILURE() << f.text;
            }
    const Hung both = hung_room("a living room with roman blinds and red curtains");
    EXPECT_FALSE(both.all("roman_blind").empty());
    EXPECT_FALSE(both.all("curtain").empty());
}

// A pair of sconces hangs to either side of the bed, level, at a height where one reads by it.
TEST(WallThings, SconcesHangBesideTheBed) {
    for (const std::string style : {"modern", "classic", "rustic"}) {
        const Hung h = hung_room("a " + style + " bedroom with a bed and two wall sconces on both sides of the bed");
        const auto lamps = h.all("wall_lamp");
        const auto beds = h.all("bed");
        ASSERT_EQ(lamps.size(), 2u) << style;
        ASSERT_FALSE(beds.empty());
        const Vec3f right = right_of(beds.front()->yaw);
        float sides = 1;
        for (const Placed* lamp : lamps) {
            sides *= dot(lamp->position - beds.front()->position, right);
            EXPECT_GT(lamp->position.y, 1.f);
            EXPECT_LT(lamp->position.y, 1.8f);
        }
        EXPECT_LT(sides, 0.f) << style << ": both on one side";
        EXPECT_NEAR(lamps[0]->position.y, lamps[1]->position.y, 0.01f);
    }
}

TEST(WallThings, LampsShineAtNightAndSignsAlways) {
    for (const auto& [words, kind] : {std::pair{"wall sconces", "wall_lamp"},
                                      {"a ceiling fan", "ceiling_fan"},
                                      {"track lighting", "track_light"},
                                      {"edison bulbs", "bulb_pendant"},
                                      {"a paper lantern", "paper_lantern"}}) {
        const std::string text = std::string("a living room with ") + words;
        EXPECT_GT(brightest(lit_room(text + " at night"), kind), 1.f) << words;
        EXPECT_EQ(brightest(lit_room(text + " at noon"), kind), 0.f) << words;
    }
    for (const std::string time : {"at night", "at noon"}) {
        const Room room = lit_room("a living room with a pink neon sign " + time);
        // By night the picture is exposed for lamps: as bright as by day it would burn out its wall.
        EXPECT_GT(brightest(room, "neon_sign"), time == "at noon" ? 0.5f : 0.1f) << time;
        if (time == "at night") {
            EXPECT_LT(brightest(room, "neon_sign"), 0.4f);
        }
        for (const Material& m : room.materials)
            if (m.name == "pink neon") {
                EXPECT_GT(m.emission.x, 1.5f * m.emission.y);
                EXPECT_GT(m.emission.z, m.emission.y);
            }
    }
}

// Under a ceiling of beams a rail of spots hangs from a beam, not in it; a hanging plant hides nothing on the walls and
// hangs in no doorway.
TEST(WallThings, WhatHangsIsSeen) {
    int railed = 0;
    for (const std::string style : {"rustic", "mediterranean", "industrial"}) {
        const Hung h = hung_room("a " + style + " kitchen with track lighting");
        for (const Placed* p : h.all("track_light")) {
            if (!h.room.plan.beams) continue;
            ++railed;
            EXPECT_NEAR(p->position.y, h.room.plan.height - kBeamDepth, 1e-3f) << style;
        }
    }
    EXPECT_GT(railed, 0);
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const Hung h = hung_room("a boho living room with three hanging plants", seed);
        EXPECT_EQ(h.all("hanging_plant").size(), 3u);
        for (const Placed* plant : h.all("hanging_plant"))
            for (const Placed& other : h.room.placed) EXPECT_FALSE(hides(*plant, other)) << other.piece.kind;
    }
}

// What hangs from a ceiling of beams hangs from one of them or between two, in none.
TEST(WallThings, LampsStandInNoBeam) {
    int below = 0, between = 0;
    for (const std::string style : {"rustic", "mediterranean", "industrial"})
        for (const std::string lamp : {"a ceiling lamp", "a pendant lamp", "a chandelier"})
            for (const std::uint64_t seed : {1u, 2u, 3u}) {
                const Hung h = hung_room("a " + style + " bedroom with " + lamp, seed);
                const Plan& plan = h.room.plan;
                if (!plan.beams || plan.knee > 0) continue;
                for (const Placed& p : h.room.placed) {
                    if (!furnishing::lights_from_above(p.piece.kind)) continue;
                    const bool hangs_from_beam = p.position.y < plan.height - kBeamDepth + 1e-3f;
                    const float half = p.piece.kind == "ceiling_lamp" ? p.piece.size_m.z / 2 : 0.05f;
                    for (int i = 0; i < beam_count(plan) && !hangs_from_beam; ++i)
                        EXPECT_GT(std::abs(p.position.z - beam_z(plan, i)), kBeamWidth / 2 + half)
                            << h.room.plan.style.name << " " << lamp;
                    bool under = false;
                    for (int i = 0; i < beam_count(plan); ++i)
                        under = under || std::abs(p.position.z - beam_z(plan, i)) < 1e-3f;
                    EXPECT_TRUE(!hangs_from_beam || under) << lamp << " beside the beam that it hangs from";
                    ++(hangs_from_beam ? below : between);
                }
            }
    EXPECT_GT(below, 0);
    EXPECT_GT(between, 0);
}

// Lights sunk into the ceiling, wherever it has room for them: between beams, in coffers, between slopes; no plate of a
// lamp beside them.
TEST(WallThings, RecessedLightsAreInTheCeiling) {
    int coffers = 0, beams = 0;
    for (const std::string room : {"a modern kitchen", "a rustic living room", "a classic dining room",
                                   "a classic study", "an attic bedroom", "a bathroom"})
        for (const std::uint64_t seed : {1u, 2u}) {
            const Hung h = hung_room(room + " with recessed lighting at night", seed);
            const Plan& plan = h.room.plan;
            coffers += plan.coffers, beams += plan.beams && !(plan.knee > 0);
            EXPECT_TRUE(h.all("ceiling_lamp").empty()) << room;
            const Room shown = built(h);
            const auto object = std::find_if(shown.objects.begin(), shown.objects.end(),
                                             [](const RoomObject& o) { return o.kind == "recessed_lights"; });
            ASSERT_NE(object, shown.objects.end()) << room;
            EXPECT_TRUE(object->requested);
            EXPECT_GT(brightest(shown, "recessed_lights"), 0.f) << room;
        }
    EXPECT_GT(coffers, 0);
    EXPECT_GT(beams, 0);
    for (const RoomObject& o : built(hung_room("a modern living room without recessed lights")).objects)
        EXPECT_NE(o.kind, "recessed_lights");
}

// Parts of the shell come in the color and material they are asked for in.
TEST(WallThings, PartsOfTheShellAreAsAsked) {
    const auto mean_albedo = [](const Room& room, const std::string& kind) {
        Vec3f sum{};
        float count = 0;
        for (const Mesh& m : room.meshes)
            if (m.object >= 0 && room.objects[static_cast<std::size_t>(m.object)].kind == kind)
                sum += room.materials[static_cast<std::size_t>(m.material)].color_a, ++count;
        return count > 0 ? sum / count : Vec3f{-1, -1, -1};
    };
    for (const std::string room : {"a rustic living room", "an industrial bedroom"}) {
        const float white = luminance(mean_albedo(lit_room(room + " with white beams"), "beams")),
                    black = luminance(mean_albedo(lit_room(room + " with black steel beams"), "beams"));
        EXPECT_GT(white, 0.5f) << room;
        EXPECT_TRUE(black >= 0 && black < 0.05f) << room << " " << black;
    }
    // Of a column base and capital stay as the trim, of a window the glass.
    for (const auto& [text, kind] : {std::pair{"a classic dining room with black columns", "column"},
                                     {"a rustic kitchen with black windows", "window"}}) {
        const Room room = lit_room(text);
        EXPECT_TRUE(std::any_of(room.meshes.begin(), room.meshes.end(), [&](const Mesh& m) {
            return m.object >= 0 && room.objects[static_cast<std::size_t>(m.object)].kind == kind &&
                   luminance(room.materials[static_cast<std::size_t>(m.material)].color_a) < 0.05f;
        })) << text;
    }
    const Vec3f panels = mean_albedo(lit_room("a classic study with dark green wainscoting"), "wainscoting");
    EXPECT_TRUE(panels.y > panels.x && panels.y > panels.z && panels.y < 0.3f)
        << panels.x << " " << panels.y << " " << panels.z;
    for (const std::string style : {"modern", "classic", "scandinavian"})
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            const Room room = built(hung_room("a " + style + " hallway with a wooden door", seed));
            EXPECT_TRUE(std::any_of(room.meshes.begin(), room.meshes.end(), [&](const Mesh& m) {
                return m.object >= 0 && room.objects[static_cast<std::size_t>(m.object)].kind == "door" &&
                       room.materials[static_cast<std::size_t>(m.material)].pattern == Pattern::wood;
            })) << style;
        }
}

// No cloth hangs before what hangs on the wall.
TEST(WallThings, CurtainsHangBesideSigns) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        const Hung h = hung_room("a classic bedroom with a neon sign and two tapestries", seed);
        for (const Placed& p : h.room.placed) {
            if (p.piece.mount != Mount::wall || p.piece.kind == "curtain") continue;
            Footprint before = footprint_of(p);
            before.half.y += 0.1f;
            for (const Placed* curtain : h.all("curtain"))
                EXPECT_FALSE(overlap(before, footprint_of(*curtain))) << p.piece.kind << " seed " << seed;
        }
    }
}

// A fan, a track or bulbs light the room: no other lamp hangs in their way.
TEST(WallThings, WhoAsksForALightAboveGetsNoOther) {
    for (const std::string words : {"a ceiling fan", "track lighting", "edison bulbs", "a paper lantern"}) {
        const Hung h = hung_room("a living room with " + words);
        int above = 0;
        for (const Placed& p : h.room.placed)
            above += furnishing::lights_from_above(p.piece.kind) && p.wish.kind.empty();
        EXPECT_EQ(above, 0) << words;
    }
}

}  // namespace
}  // namespace fastscene
