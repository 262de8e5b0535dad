#include "fastscene/rooms/furniture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/rooms/furniture/lettering.h"
#include "fastscene/rooms/shapes.h"

namespace fastscene {
namespace {

Piece make(const std::string& kind, const std::string& style = "modern", std::uint64_t seed = 3) {
    PieceRequest r;
    r.kind = kind;
    r.style = &style_named(style);
    r.seed = seed;
    return make_piece(r);
}

// Everything a piece promises of its geometry; returns its triangles.
std::size_t check_piece(const Piece& p) {
    std::size_t count = 0, agreeing = 0;
    shapes::Box all;
    for (const Mesh& m : p.meshes) {
        EXPECT_LT(static_cast<std::size_t>(m.material), p.materials.size());
        EXPECT_EQ(m.positions.size(), m.normals.size());
        EXPECT_EQ(m.positions.size(), m.coords.size());
        bool sound = m.triangles.size() % 3 == 0;
        for (std::size_t i = 0; i < m.positions.size(); ++i)
            sound = sound && std::isfinite(dot(m.positions[i], m.positions[i])) &&
                    std::isfinite(dot(m.coords[i], m.coords[i])) && std::fabs(length(m.normals[i]) - 1.f) < 1e-3f;
        for (const std::uint32_t i : m.triangles) sound = sound && i < m.positions.size();
        EXPECT_TRUE(sound) << p.materials[static_cast<std::size_t>(m.material)].name;
        if (!sound) return 0;
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
            const std::uint32_t a = m.triangles[t], b = m.triangles[t + 1], c = m.triangles[t + 2];
            const Vec3f n = cross(m.positions[b] - m.positions[a], m.positions[c] - m.positions[a]);
            agreeing += dot(n, m.normals[a] + m.normals[b] + m.normals[c]) > 0.f;
            ++count;
        }
        const shapes::Box b = shapes::bounds(m);
        for (std::size_t k = 0; k < 3; ++k) {
            all.low[k] = std::min(all.low[k], b.low[k]);
            all.high[k] = std::max(all.high[k], b.high[k]);
        }
    }
    EXPECT_GT(static_cast<double>(agreeing), 0.98 * static_cast<double>(count))
        << "normals point away from their triangles";
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(all.high[k] - all.low[k], p.size_m[k], 0.01f);
    EXPECT_NEAR(all.low.x + all.high.x, 0.f, 0.01f);
    if (p.mount == Mount::ceiling) EXPECT_NEAR(all.high.y, 0.f, 1e-3f);
    else EXPECT_NEAR(all.low.y, 0.f, 1e-3f);
    EXPECT_NEAR(p.mount == Mount::wall ? all.low.z : all.low.z + all.high.z, 0.f, 0.01f);
    for (const Surface& s : p.surfaces) {
        EXPECT_LE(s.center.y, p.size_m.y + 0.01f);
        EXPECT_LE(std::fabs(s.center.x) + s.half.x, 0.5f * p.size_m.x + 0.01f);
    }
    return count;
}

// A dye takes from what comes through as it takes from what comes back.
TEST(Furniture, DarkCurtainsLetLessLightThrough) {
    for (const std::string name : {"modern", "classic", "boho", "rustic"}) {
        const auto through = [&](Vec3f color) {
            PieceRequest r;
            r.kind = "curtain", r.style = &style_named(name), r.color = color;
            const Piece p = make_piece(r);
            return p.materials[static_cast<std::size_t>(p.main_material)].transmission;
        };
        const float white = through({0.75f, 0.74f, 0.72f}), red = through({0.5f, 0.03f, 0.03f}),
                    navy = through({0.02f, 0.03f, 0.12f});
        EXPECT_GT(white, 0.f);
        EXPECT_LT(red, 0.5f * white) << name;
        EXPECT_LE(navy, red) << name;
    }
}

TEST(Furniture, EveryClassInEveryStyleIsSound) {
    EXPECT_GE(piece_classes().size(), 60u);
    for (const std::string& style : styles())
        for (const std::string& kind : piece_classes()) {
            SCOPED_TRACE(style + " " + kind);
            const std::size_t triangles = check_piece(make(kind, style, hash_name(style)));
            EXPECT_GT(triangles, 50u);
            EXPECT_LT(triangles, 27000u);
        }
}

TEST(Furniture, TheSameRequestMakesTheSamePiece) {
    for (const std::string kind : {"sofa", "bookshelf", "plant", "desk"}) {
        const Piece a = make(kind), b = make(kind), c = make(kind, "modern", 4);
        ASSERT_EQ(a.meshes.size(), b.meshes.size());
        for (std::size_t i = 0; i < a.meshes.size(); ++i) EXPECT_TRUE(a.meshes[i].positions == b.meshes[i].positions);
        bool same = a.meshes.size() == c.meshes.size();
        for (std::size_t i = 0; same && i < a.meshes.size(); ++i) same = a.meshes[i].positions == c.meshes[i].positions;
        EXPECT_FALSE(same) << kind << ": the seed changes nothing";
    }
}

TEST(Furniture, AWishedColorReachesTheMainSurface) {
    for (const std::string& kind : piece_classes()) {
        SCOPED_TRACE(kind);
        PieceRequest r;
        r.kind = kind;
        r.style = &style_named("scandinavian");
        r.color_name = "red";
        const Piece p = make_piece(r);
        const Material& m = p.materials[static_cast<std::size_t>(p.main_material)];
        EXPECT_GT(m.color_a.x, 3.f * m.color_a.y);
        const bool used = std::any_of(p.meshes.begin(), p.meshes.end(),
                                      [&](const Mesh& mesh) { return mesh.material == p.main_material; });
        EXPECT_TRUE(used);
    }
}

TEST(Furniture, ALeatherSofaIsLeatherAndBrown) {
    PieceRequest r;
    r.kind = "sofa";
    r.style = &style_named("modern");
    r.material = "leather";
    r.color_name = "brown";
    const Piece p = make_piece(r);
    const Material& m = p.materials[static_cast<std::size_t>(p.main_material)];
    EXPECT_EQ(m.pattern, Pattern::leather);
    EXPECT_GT(m.color_a.x, 1.5f * m.color_a.z);
}

// Between glass and ceiling a lamp throws no shadow: its plate ends within the glass, and from below it is not seen
// past it.
TEST(Furniture, ACeilingLampsPlateIsBehindItsGlass) {
    const Piece lamp = make("ceiling_lamp");
    float glass = 0, plate = 0;
    for (const Mesh& m : lamp.meshes) {
        const bool shines = luminance(lamp.materials[static_cast<std::size_t>(m.material)].emission) > 0;
        for (const Vec3f& p : m.positions)
            if (shines) glass = std::max(glass, std::hypot(p.x, p.z));
            else if (p.y > -0.02f) plate = std::max(plate, std::hypot(p.x, p.z));
    }
    EXPECT_LT(plate, 0.85f * glass);
}

// Brick is brown-red: with as much blue as green the light of a room makes it pink.
TEST(Style, BrickIsNotPink) {
    const Material brick = *material_named("brick");
    for (const Vec3f c : {brick.color_a, brick.color_c}) {
        EXPECT_GT(c.x, 1.7f * c.y);
        EXPECT_GT(c.y, 1.2f * c.z);
    }
}

// A corner sofa reaches out on one side, and is of one cloth with its seat.
TEST(Furniture, ACornerSofaHasItsLongSeat) {
    for (const std::string& style : styles()) {
        PieceRequest r;
        r.kind = "sofa", r.style = &style_named(style);
        const Piece straight = make_piece(r);
        r.pattern = "corner";
        r.color_name = "gray";
        const Piece corner = make_piece(r);
        EXPECT_GT(corner.size_m.z, straight.size_m.z + 0.5f) << style;
        check_piece(corner);
        const Material& m = corner.materials[static_cast<std::size_t>(corner.main_material)];
        EXPECT_GT(luminance(m.color_b), 0.4f * luminance(m.color_a)) << style;
        EXPECT_LT(luminance(m.color_b), 1.3f * luminance(m.color_a)) << style;
    }
}

// A rug that was asked for as round is, whatever room it is laid out for.
TEST(Furniture, ARoundRugIsRound) {
    for (const std::string& style : styles()) {
        PieceRequest r;
        r.kind = "rug", r.style = &style_named(style), r.pattern = "round", r.size_m = {2.6f, 0, 1.9f};
        const Piece p = make_piece(r);
        EXPECT_NEAR(p.size_m.x, p.size_m.z, 0.02f) << style;
        for (const Mesh& m : p.meshes)
            for (const Vec3f& v : m.positions) EXPECT_LT(std::hypot(v.x, v.z), 0.51f * p.size_m.x) << style;
    }
}

// Fluffy is one color of deep pile, not a woven pattern.
TEST(Furniture, AFluffyRugHasNoPattern) {
    for (const std::string& style : styles()) {
        PieceRequest r;
        r.kind = "rug", r.style = &style_named(style), r.material = "wool";
        const Piece p = make_piece(r);
        EXPECT_EQ(p.materials[static_cast<std::size_t>(p.main_material)].pattern, Pattern::carpet) << style;
        r.color_name = "lavender";
        const Piece tinted = make_piece(r);
        const Vec3f c = tinted.materials[static_cast<std::size_t>(tinted.main_material)].color_a;
        EXPECT_GT(c.z, c.y) << style;
    }
}

// Whatever the style: what is asked for in rattan is woven, coarse enough to be seen, and browner than paper.
TEST(Furniture, RattanIsSeenToBeWoven) {
    for (const std::string& style : styles())
        for (const std::string kind : {"chair", "armchair", "sofa", "loveseat"})
            for (const std::string material : {"rattan", "wicker"}) {
                PieceRequest r;
                r.kind = kind, r.style = &style_named(style), r.material = material;
                const Piece p = make_piece(r);
                SCOPED_TRACE(style + " " + kind);
                check_piece(p);
                const Material& m = p.materials[static_cast<std::size_t>(p.main_material)];
                EXPECT_EQ(m.pattern, Pattern::wicker);
                EXPECT_GE(m.scale_m, 0.03f);
                EXPECT_GT(m.color_a.x, 1.3f * m.color_a.z);
                EXPECT_TRUE(std::any_of(p.meshes.begin(), p.meshes.end(),
                                        [&](const Mesh& mesh) { return mesh.material == p.main_material; }));
            }
}

// A flame is yellow to orange wherever one looks, and orange at its point.
TEST(Furniture, FlamesAreWarmAndTurnToOrange) {
    for (const std::string kind : {"candle", "fireplace"}) {
        const Piece p = make(kind, "classic");
        int flames = 0;
        float reddest = 0, yellowest = 1e9f;
        for (const Material& m : p.materials) {
            if (!m.burns) continue;
            ++flames;
            EXPECT_GT(m.emission.x, 1.5f * m.emission.y) << m.name;
            EXPECT_GT(m.emission.y, 4.f * m.emission.z) << m.name;
            reddest = std::max(reddest, m.emission.x / m.emission.y);
            yellowest = std::min(yellowest, m.emission.x / m.emission.y);
        }
        EXPECT_GE(flames, 2) << kind;
        EXPECT_GT(reddest, 1.4f * yellowest) << kind;
    }
}

TEST(Furniture, APictureShowsTheMotifThatWasAskedFor) {
    for (const char* motif : {"skull", "ship", "map", "anchor", "rocket", "lion", "gamepad", "whale"}) {
        PieceRequest r;
        r.kind = "picture", r.style = &style_named("classic"), r.pattern = motif, r.seed = 3;
        const Piece shown = make_piece(r);
        r.pattern.clear();
        const Piece other = make_piece(r);
        SCOPED_TRACE(motif);
        check_piece(shown);
        EXPECT_GT(shown.meshes.size(), other.meshes.size());
        for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(shown.size_m[k], other.size_m[k], 1e-3f);
        EXPECT_LT(shown.size_m.z, 0.05f);
    }
}

// Of all triangles, those that look up and lie at about this height: their area, m2.
float area_at(const Piece& p, float low, float high) {
    float area = 0;
    for (const Mesh& m : p.meshes)
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
            const Vec3f a = m.positions[m.triangles[t]], b = m.positions[m.triangles[t + 1]],
                        c = m.positions[m.triangles[t + 2]], n = cross(b - a, c - a);
            if (n.y > 0.f && std::min({a.y, b.y, c.y}) > low && std::max({a.y, b.y, c.y}) < high) area += 0.5f * n.y;
        }
    return area;
}
// The mesh of the main material alone.
std::vector<Vec3f> main_points(const Piece& p) {
    std::vector<Vec3f> out;
    for (const Mesh& m : p.meshes)
        if (m.material == p.main_material) out.insert(out.end(), m.positions.begin(), m.positions.end());
    return out;
}

// Two beds one above the other with room to sit up between, a ladder from the floor to beyond the upper one, a rail
// around that.
TEST(Furniture, ABunkBedHasTwoBedsALadderAndARail) {
    for (const std::string& style : styles())
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            SCOPED_TRACE(style);
            const Piece p = make("bunk_bed", style, seed);
            check_piece(p);
            ASSERT_EQ(p.surfaces.size(), 2u);
            const float lower = std::min(p.surfaces[0].center.y, p.surfaces[1].center.y),
                        upper = std::max(p.surfaces[0].center.y, p.surfaces[1].center.y);
            EXPECT_GT(upper - lower, 0.85f);
            EXPECT_LT(lower, 0.55f);
            for (const float y : {lower, upper}) EXPECT_GT(area_at(p, y - 0.16f, y + 0.12f), 1.3f) << y;
            EXPECT_GT(p.size_m.x, 1.9f);
            EXPECT_LT(p.size_m.y, 1.75f) << "one must be able to sit on it below a ceiling of 2.5 m";
            EXPECT_TRUE(p.against_wall);
            // The ladder is what stands out in front: from the floor to above the upper mattress.
            float low = 1e9f, high = -1e9f, rail = -1e9f;
            for (const Vec3f& v : main_points(p)) {
                if (v.z > 0.5f * p.size_m.z - 0.05f) low = std::min(low, v.y);
                if (v.z > 0.5f * p.size_m.z - 0.2f && v.x > 0.f && v.x < 0.5f * p.size_m.x - 0.12f)
                    high = std::max(high, v.y);
                if (v.x < 0.2f) rail = std::max(rail, v.y);
            }
            EXPECT_LT(low, 0.02f);
            EXPECT_GT(high, upper + 0.1f);
            EXPECT_GT(rail, upper + 0.15f);
        }
}

TEST(Furniture, BelowALoftBedIsRoomForADesk) {
    for (const std::string& style : styles()) {
        const Piece p = make("loft_bed", style, 2), desk = make("desk", style, 2);
        SCOPED_TRACE(style);
        EXPECT_LT(p.size_m.y, 2.f);
        // Nothing in the way from the knee to above a seated head, but at the posts, the back and the ladder.
        for (const Mesh& m : p.meshes)
            for (const Vec3f& v : m.positions)
                if (v.y > 0.1f && v.y < 1.32f) {
                    EXPECT_TRUE(std::fabs(v.x) > 0.5f || v.z < -0.4f) << v.x << ' ' << v.y << ' ' << v.z;
                }
        EXPECT_LT(desk.size_m.x, p.size_m.x - 0.2f);
        EXPECT_GT(area_at(p, p.surfaces[0].center.y - 0.16f, p.surfaces[0].center.y + 0.12f), 1.3f);
    }
}

// Four posts that reach to above a man's head; with a canopy cloth lies over them.
TEST(Furniture, FourPostersHavePostsAndCanopiesARoof) {
    for (const std::string& style : styles())
        for (const std::string kind : {"four_poster_bed", "canopy_bed"}) {
            SCOPED_TRACE(style + " " + kind);
            const Piece p = make(kind, style);
            EXPECT_GT(p.size_m.y, 1.95f);
            EXPECT_LT(p.size_m.y, 2.2f);
            for (const float sx : {-1.f, 1.f})
                for (const float sz : {-1.f, 1.f}) {
                    float low = 1e9f, high = 0;
                    for (const Mesh& m : p.meshes)
                        for (const Vec3f& v : m.positions)
                            if (sx * v.x > 0.5f * p.size_m.x - 0.12f && sz * v.z > 0.5f * p.size_m.z - 0.14f)
                                low = std::min(low, v.y), high = std::max(high, v.y);
                    EXPECT_LT(low, 0.01f);
                    EXPECT_GT(high, 1.95f);
                }
            const float roof = area_at(p, 1.9f, 2.2f);
            if (kind == "canopy_bed") EXPECT_GT(roof, 2.5f);
            else EXPECT_LT(roof, 1.f);
        }
}

// A bean bag is a sack: it lies flat on the floor, its seat is a hollow before a higher back.
TEST(Furniture, ABeanBagSags) {
    for (const std::uint64_t seed : {1u, 5u, 9u}) {
        const Piece p = make("bean_bag", "modern", seed);
        float seat = 0, back = 0, front = 0, floor = 0;
        for (const Vec3f& v : main_points(p)) {
            if (std::fabs(v.x) > 0.1f) continue;
            if (v.z > 0.02f && v.z < 0.16f && v.y > 0.1f) seat = std::max(seat, v.y);
            if (v.z < -0.15f) back = std::max(back, v.y);
            if (v.z > 0.2f) front = std::max(front, v.y);
            if (v.y < 0.03f) floor = std::max(floor, std::fabs(v.z));
        }
        EXPECT_GT(back, seat + 0.2f);
        EXPECT_GT(floor, 0.15f) << "it stands on a point";
        EXPECT_LT(seat, 0.5f);
        EXPECT_GT(front, 0.2f);
    }
}

// The basket hangs clear of the floor and in reach of who sits down; all of it hangs on what stands.
TEST(Furniture, AHangingChairHangs) {
    for (const std::string& style : styles()) {
        const Piece p = make("hanging_chair", style);
        float lowest = 1e9f;
        for (const Vec3f& v : main_points(p)) lowest = std::min(lowest, v.y);
        EXPECT_GT(lowest, 0.3f) << style;
        EXPECT_LT(lowest, 0.5f) << style;
        EXPECT_LT(p.size_m.y, 2.15f) << style;
    }
}

// Long enough to lie on, higher at the head than at the feet.
TEST(Furniture, AChaiseLongueIsLongAndRisesToItsHead) {
    for (const std::string& style : styles()) {
        const Piece p = make("chaise_longue", style);
        float head = 0, feet = 0;
        for (const Vec3f& v : main_points(p))
            (v.x < 0 ? head : feet) = std::max(v.x < 0 ? head : feet, std::fabs(v.x) > 0.4f ? v.y : 0.f);
        EXPECT_GT(p.size_m.x, 1.5f) << style;
        EXPECT_LT(p.size_m.z, 0.85f) << style;
        EXPECT_GT(head, feet + 0.3f) << style;
    }
}

TEST(Furniture, WishedSizesAreKept) {
    for (const std::string kind : {"rug", "dining_table", "wardrobe", "kitchen_counter", "cat"}) {
        PieceRequest r;
        r.kind = kind;
        r.style = &style_named("modern");
        r.size_m = {1.5f, 0, 0};
        EXPECT_NEAR(make_piece(r).size_m.x, 1.5f, 0.1f) << kind;
    }
}

TEST(Furniture, LampsShineAndUnknownClassesThrow) {
    for (const std::string& style : styles())
        for (const std::string kind : {"floor_lamp", "table_lamp", "pendant_lamp", "ceiling_lamp", "chandelier"}) {
            const Piece p = make(kind, style);
            float most = 0.f;
            for (const Mesh& m : p.meshes)
                most = std::max(most, max_component(p.materials[static_cast<std::size_t>(m.material)].emission));
            EXPECT_GT(most, 4.f) << style << ' ' << kind;
        }
    EXPECT_THROW((void)make("spaceship"), Error);
    EXPECT_THROW((void)style_named("spaceship"), Error);
}

// A car is smooth, and light enough for a garage of them.
TEST(Piece, ACarIsOfModestSize) {
    const Piece car = make("car", "modern", 2);
    std::size_t triangles = 0;
    for (const Mesh& m : car.meshes) triangles += m.triangles.size() / 3;
    EXPECT_GT(triangles, 8'000u);
    EXPECT_LT(triangles, 27'000u);
    EXPECT_NEAR(car.size_m.z, 4.3f, 0.2f);
    EXPECT_NEAR(car.size_m.y, 1.46f, 0.05f);
    EXPECT_LT(car.size_m.x, 2.2f);
}

// A lit screen shows a picture, in light and dark.
TEST(Piece, LitScreensShowPictures) {
    for (const std::string kind : {"projector_screen", "monitor", "laptop", "tv", "arcade_machine", "slot_machine",
                                   "departure_board", "check_in_desk", "ticket_machine", "video_wall", "treadmill"}) {
        int pictures = 0;
        for (std::uint64_t seed = 1; seed < 9; ++seed) {
            const Piece p = make(kind, "modern", seed);
            for (const Mesh& mesh : p.meshes) {
                const Material& m = p.materials[static_cast<std::size_t>(mesh.material)];
                if (m.pattern != Pattern::screen || !m.image) continue;
                ++pictures;
                ASSERT_EQ(m.image->levels.back().size(), 1u) << kind;
                double sum = 0, squares = 0;
                for (const Rgb8 c : m.image->levels[0].pixels) {
                    const double bright = luminance(linear_from_srgb8(c));
                    sum += bright, squares += bright * bright;
                }
                const double count = static_cast<double>(m.image->levels[0].size()), mean = sum / count;
                EXPECT_GT(std::sqrt(squares / count - mean * mean), 0.3 * mean) << kind << " " << m.name;
                EXPECT_GT(mean, 0.004) << kind << " " << m.name;
                // The whole picture, or a part of it.
                for (const Vec3f c : mesh.coords) EXPECT_TRUE(c.x > 0 && c.x < 1 && c.y > 0 && c.y < 1) << kind;
            }
        }
        EXPECT_GT(pictures, 0) << kind;
    }
}

// What is printed and bound has the dull colors of ink and cloth, many of them, and real albedos.
TEST(Piece, BooksAndGoodsAreDull) {
    for (const std::string kind : {"bookshelf", "library_shelf", "book_island", "grocery_shelf", "grocery_island",
                                   "video_shelf", "record_wall", "medicine_shelf", "toy_shelf", "coffee_shelf"}) {
        const Piece p = make(kind, "modern", 5);
        std::size_t pictures = 0;
        for (const Material& m : p.materials) {
            if (m.pattern != Pattern::image) continue;
            ++pictures;
            ASSERT_NE(m.image, nullptr) << kind;
            const ImageRgb8& image = m.image->levels[0];
            ASSERT_EQ(m.image->levels.back().size(), 1u);
            double gaudy = 0;
            float brightest = 0;
            for (const Rgb8 pixel : image.pixels) {
                const Vec3f c = linear_from_srgb8(pixel);
                brightest = std::max(brightest, max_component(c));
                gaudy += max_component(c) - std::min({c.x, c.y, c.z}) > 0.6f;
            }
            EXPECT_LE(brightest, 0.85f) << kind << ": " << m.name << " is brighter than paper";
            EXPECT_LT(gaudy, 0.01 * static_cast<double>(image.size())) << kind << ": " << m.name << " is neon";
        }
        EXPECT_GT(pictures, 0u) << kind << " shows nothing printed";
    }
}

// One sheet of a trade serves all pieces: a hall of shelves keeps one picture.
TEST(Piece, ShelvesOfATradeShareTheirPicture) {
    const auto picture = [](const Piece& p) {
        for (const Material& m : p.materials)
            if (m.image) return m.image.get();
        return static_cast<const TextureImage*>(nullptr);
    };
    const Piece first = make("library_shelf", "classic", 1), second = make("library_shelf", "gothic", 2);
    ASSERT_NE(picture(first), nullptr);
    EXPECT_EQ(picture(first), picture(second));
}

TEST(Lettering, EverySignIsDrawn) {
    for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-+/'")) {
        const auto strokes = furniture::letter_strokes(std::string(1, c), 0.6f);
        ASSERT_FALSE(strokes.empty()) << c;
        for (const auto& stroke : strokes) {
            EXPECT_GE(stroke.size(), 2u) << c;
            for (const Vec2f p : stroke) {
                EXPECT_GE(p.y, 0.f) << c;
                EXPECT_LE(p.y, 0.601f) << c;
                EXPECT_LE(p.x, 0.401f) << c;
            }
        }
    }
    EXPECT_EQ(furniture::letter_strokes("a", 1.f).size(), furniture::letter_strokes("A", 1.f).size());
    EXPECT_TRUE(furniture::letter_strokes(" ", 1.f).empty());
    EXPECT_NEAR(furniture::letters_width("OO", 0.6f), 0.96f, 1e-4f);
}

TEST(Style, ColorsAreRealAlbedos) {
    for (const std::string name : {"red", "sage", "sage green", "terracotta", "dark blue", "light gray", "navy-blue",
                                   "Walnut", "olive green", "white", "black"}) {
        const auto c = color_named(name);
        ASSERT_TRUE(c.has_value()) << name;
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_GE((*c)[k], 0.0119f) << name;
            EXPECT_LE((*c)[k], 0.8501f) << name;
        }
        EXPECT_GE(luminance(*c), 0.0299f) << name << " is darker than soot";
    }
    EXPECT_LT(luminance(*color_named("dark blue")), luminance(*color_named("blue")));
    EXPECT_GT(luminance(*color_named("light blue")), luminance(*color_named("blue")));
    EXPECT_FALSE(color_named("spaceship").has_value());
    // Mahogany is brown: what is raised to soot's brightness keeps its hue.
    const Vec3f mahogany = *color_named("mahogany");
    EXPECT_GT(mahogany.x, 4 * mahogany.z);
    EXPECT_GE(styles().size(), 10u);
    for (const std::string& s : styles()) EXPECT_EQ(style_named(s).palette.size(), 6u);
}

}  // namespace
}  // namespace fastscene
