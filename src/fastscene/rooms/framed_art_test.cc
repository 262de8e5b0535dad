// What hangs in frames: photographs, prints, paintings.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "fastscene/image/color.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/furniture/wall/framed_art.h"
#include "fastscene/rooms/furniture/wall/panels.h"
#include "fastscene/rooms/style.h"

namespace fastscene {
namespace {

using furniture::framed_art;
using furniture::Genre;

TEST(FramedArt, EveryPictureOpensAndIsNoBrighterThanPaper) {
    std::set<std::string> names;
    for (const Genre genre : {Genre::photo, Genre::print, Genre::painting})
        for (std::uint32_t i = 0; i < 12; ++i) {
            const auto art = framed_art(genre, i);
            ASSERT_NE(art.image, nullptr);
            if (!names.insert(std::string(art.name)).second) continue;
            const ImageRgb8& image = art.image->levels[0];
            EXPECT_GE(image.width, 512) << art.name;
            float least = 1, most = 0;
            for (const Rgb8 c : image.pixels) {
                const float light = luminance(linear_from_srgb8(c));
                least = std::min(least, light), most = std::max(most, light);
            }
            EXPECT_LT(most, 0.86f) << art.name;
            EXPECT_GT(most - least, 0.3f) << art.name << " is nearly blank";
        }
    EXPECT_GE(names.size(), 14u);
}

// The canvas of a picture, where it shows one of them.
const Mesh* canvas_of(const Piece& piece) {
    for (const Mesh& m : piece.meshes)
        if (piece.materials[static_cast<std::size_t>(m.material)].pattern == Pattern::image) return &m;
    return nullptr;
}

struct Span {
    float low = 1e9f, high = -1e9f;
    void add(float v) { low = std::min(low, v), high = std::max(high, v); }
};

TEST(FramedArt, FillsItsFrameUprightAndUnstretched) {
    int framed = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
        for (const Vec3f size : {Vec3f{0.9f, 0.6f, 0}, {0.5f, 0.75f, 0}}) {
            const Piece piece = make_piece(
                {.kind = "picture", .style = &style_named("modern"), .seed = seed, .size_m = size});
            const Mesh* canvas = canvas_of(piece);
            if (!canvas) continue;
            ++framed;
            Span u, v, x, y;
            for (std::size_t i = 0; i < canvas->coords.size(); ++i) {
                u.add(canvas->coords[i].x), v.add(canvas->coords[i].y);
                x.add(canvas->positions[i].x), y.add(canvas->positions[i].y);
            }
            EXPECT_GE(u.low, -1e-4f);
            EXPECT_LE(u.high, 1 + 1e-4f);
            EXPECT_GE(v.low, -1e-4f);
            EXPECT_LE(v.high, 1 + 1e-4f);
            // v = 1 is the picture's top.
            const auto top = std::max_element(canvas->positions.begin(), canvas->positions.end(),
                                              [](Vec3f a, Vec3f b) { return a.y < b.y; });
            EXPECT_NEAR(canvas->coords[static_cast<std::size_t>(top - canvas->positions.begin())].y, v.high, 1e-3f);
            const auto& image = piece.materials[static_cast<std::size_t>(canvas->material)].image->levels[0];
            EXPECT_NEAR((u.high - u.low) * static_cast<float>(image.width) / (x.high - x.low),
                        (v.high - v.low) * static_cast<float>(image.height) / (y.high - y.low),
                        0.02f * static_cast<float>(image.height));
        }
    EXPECT_GT(framed, 20);
}

TEST(FramedArt, PanelsContinueEachOther) {
    int looked = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        float right = 0;
        for (int i = 0; i < 3; ++i) {
            PieceRequest r{.kind = "picture", .style = &style_named("modern"), .seed = seed, .size_m = {0.5f, 0.7f, 0}};
            r.pattern = furniture::pattern_of({i, 3});
            const Piece piece = make_piece(r);
            const Mesh* canvas = canvas_of(piece);
            if (!canvas) continue;
            Span u;
            for (const Vec3f c : canvas->coords) u.add(c.x);
            if (i > 0) {
                EXPECT_GT(u.low, right);
            }
            right = u.high;
            ++looked;
        }
        EXPECT_LE(right, 1 + 1e-4f);
    }
    EXPECT_GT(looked, 6);
}

TEST(FramedArt, AColorThatIsAskedForIsADesign) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        PieceRequest r{.kind = "picture", .style = &style_named("modern"), .seed = seed};
        r.color_name = "blue";
        EXPECT_EQ(canvas_of(make_piece(r)), nullptr);
    }
}

}  // namespace
}  // namespace fastscene
