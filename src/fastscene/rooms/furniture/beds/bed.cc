// Beds with their head at the wall, with or without posts.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/beds/bedding.h"
#include "fastscene/rooms/furniture/beds/headboard.h"
#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {
namespace {

enum Posts { no_posts, bare_posts, draped_posts };  // at the four corners, to above a man's height

// Cloth gathered on a rail at `at` + y1, that runs from a post along it, and tied back to the post at the height `tie`.
Mesh tied_back(Vec3f at, Vec3f along, Vec3f across, float wide, float y0, float y1, float tie, std::uint32_t seed) {
    return shapes::sheet(30, 10, [=](float u, float v) {
        const float y = y0 + (y1 - y0) * v, off = y > tie ? (y - tie) / (y1 - tie) : (tie - y) / (tie - y0),
                    gather = y > tie ? 0.2f + 0.8f * std::pow(off, 1.4f) : 0.2f + 0.34f * std::sqrt(off);
        const float fold = (0.012f + 0.016f * gather) *
                           std::sin(kTau * 5.f * u + 0.8f * shapes::wobble({u * 4.f, y * 1.3f, 1.f}, seed));
        // Between rail and tie the free edge hangs in a bow.
        return at + along * (wide * gather * u) + across * fold +
               Vec3f{0, y - (y > tie ? 0.05f * u * (1.f - off) * off : 0.f), 0};
    });
}

// A post: of metal, turned, or square.
void bed_post(Kit& k, int mat, Vec3f foot, float top) {
    const PostForm form = k.style.bed_posts;
    if (form == PostForm::metal) return k.board(mat, foot, {0.036f, top, 0.036f}, 0.004f);
    if (form == PostForm::square) return k.board(mat, foot, {0.055f, top, 0.055f}, 0.01f);
    k.board(mat, foot, {0.085f, 0.56f, 0.085f}, 0.01f);
    const float r = 0.036f;
    const std::array<Vec2f, 13> p{Vec2f{r, 0.56f},         {1.1f * r, 0.575f},     {0.7f * r, 0.6f},
                                  {1.15f * r, 0.66f},      {1.25f * r, 0.76f},     {0.8f * r, 0.92f},
                                  {0.62f * r, 0.95f},      {1.05f * r, 0.975f},    {0.85f * r, 1.02f},
                                  {0.72f * r, top - 0.1f}, {1.f * r, top - 0.07f}, {0.8f * r, top - 0.04f},
                                  {0.8f * r, top}};
    k.add(shapes::lathe(p, 14, true), mat, foot);
}

// Where a four-poster has its posts and its low rails: x of both, z of the head and of the foot.
struct PostPlaces {
    float x, head, foot;
};
PostPlaces post_places(float width, float length) {
    return {0.5f * width + 0.1f, -0.5f * length - 0.06f, 0.5f * length + 0.13f};
}

// What keeps the bedding of a four-poster from hanging out between its posts.
std::vector<DrapeSolid> around_posts(float width, float length) {
    const PostPlaces at = post_places(width, length);
    constexpr float kPost = 0.045f, kRail = 0.02f, kRailTop = 0.3f, kHigh = 1.f;
    std::vector<DrapeSolid> out;
    for (const float sx : {-1.f, 1.f}) {
        out.push_back({{sx * at.x, 0.5f * kHigh, at.foot}, {kPost, 0.5f * kHigh, kPost}, 0.01f});
        out.push_back({{sx * at.x, 0.5f * kRailTop, 0.5f * (at.head + at.foot)},
                       {kRail, 0.5f * kRailTop, 0.5f * (at.foot - at.head)},
                       0.01f});
    }
    return out;
}

// Posts with rails between their heads, a headboard and a low foot; `draped`: a roof of cloth, and cloth tied to the
// posts.
void four_posts(Kit& k, Posts over, float width, float length, int duvet) {
    const bool metal = k.style.bed_posts == PostForm::metal, turned = k.style.bed_posts == PostForm::turned,
               rich = k.style.mouldings == Mouldings::rich;
    const int frame = k.material(metal ? k.style.metal : k.style.wood);
    // Outside of what hangs from the mattress.
    const auto [px, hz, fz] = post_places(width, length);
    const float top = turned && over == bare_posts ? 2.02f : 2.1f, mid = 0.5f * (hz + fz), t = metal ? 0.034f : 0.05f;
    for (const float sx : {-1.f, 1.f})
        for (const float z : {hz, fz}) {
            bed_post(k, frame, {sx * px, 0, z}, top);
            if (turned && over == bare_posts)
                k.add(shapes::ball({sx * px, top + 0.05f, z}, {0.04f, 0.055f, 0.04f}, 16), frame);
        }
    const float rail = top - t;
    for (const float sx : {-1.f, 1.f}) k.board(frame, {sx * px, rail, mid}, {t, t, fz - hz}, 0.005f);
    for (const float z : {hz, fz}) k.board(frame, {0, rail, z}, {2 * px, t, t}, 0.005f);
    for (const float sx : {-1.f, 1.f}) k.board(frame, {sx * px, 0.16f, mid}, {0.7f * t, 0.14f, fz - hz}, 0.005f);
    k.board(frame, {0, 0.16f, fz}, {2 * px, 0.14f, 0.7f * t}, 0.005f);
    // The head: padded where the posts are of metal, a framed panel else.
    if (metal) {
        k.soft(k.material(k.style.fabric2), {0, 0.22f, hz}, {2 * px - 0.06f, 0.86f, 0.09f},
               {0.035f, 0.018f, 0.001f, 12});
    } else {
        const float high = rich ? 1.28f : 1.1f;
        k.board(frame, {0, 0.2f, hz}, {2 * px, high - 0.26f, 0.025f}, 0.006f);
        k.board(frame, {0, high - 0.09f, hz}, {2 * px, 0.09f, 0.05f}, 0.014f);
        k.board(frame, {0, 0.54f, hz + 0.012f}, {2 * px, 0.07f, 0.03f}, 0.008f);
        const int panels = 3;
        for (int i = 0; i < panels; ++i)
            k.board(frame, {2 * px * ((static_cast<float>(i) + 0.5f) / panels - 0.5f), 0.66f, hz + 0.014f},
                    {2 * px / panels - 0.12f, high - 0.82f, 0.026f}, 0.012f);
    }
    if (over != draped_posts) return;
    Material cloth = k.style.curtain;
    if (k.request.color || !k.request.color_name.empty())
        cloth = tinted(cloth, k.piece.materials[static_cast<std::size_t>(duvet)].color_a);
    cloth.transmission = std::min(cloth.transmission, 0.35f);
    const int veil = k.material(cloth);
    const float head = turned ? 1.f : 1.12f;
    for (const float sx : {-1.f, 1.f})
        for (const float end : {-1.f, 1.f}) {
            const float z = end < 0 ? hz : fz;
            k.add(tied_back({sx * px, 0, z - end * 0.035f}, {0, 0, -end}, {1, 0, 0}, end < 0 ? 0.62f : 0.5f, 0.03f,
                            rail - 0.002f, head, k.seed()),
                  veil);
            k.add(shapes::ball({sx * px, head, z - end * 0.08f}, {0.036f, 0.034f, 0.075f}, 12), veil);
        }
    // The roof sags between three laths.
    constexpr int kFields = 3;
    for (int i = 1; i < kFields; ++i)
        k.board(frame, {0, rail + 0.004f, hz + (fz - hz) * static_cast<float>(i) / kFields}, {2 * px, 0.018f, 0.022f},
                0.004f);
    k.add(
        shapes::slab(
            8, 24, 0.004f,
            [=](float u, float v) {
                const float f = kFields * v - std::min(std::floor(kFields * v), kFields - 1.f), x = (1.f - 2.f * u);
                return Vec3f{px * -x, top + 0.006f - 0.16f * f * (1.f - f) * (1.f - 0.3f * x * x), fz + (hz - fz) * v};
            }),
        veil);
    if (!turned && !rich) return;
    // A valance all around, but at the wall.
    const auto valance = [&](Vec3f a, Vec3f b, Vec3f out) {
        const float far = std::sqrt(dot(b - a, b - a)), folds = std::round(far / 0.09f);
        k.add(shapes::sheet(static_cast<int>(4 * folds), 2,
                            [=](float u, float v) {
                                return lerp(a, b, u) +
                                       out * (0.012f + 0.011f * (1.f - 0.6f * v) * std::sin(kTau * folds * u)) -
                                       Vec3f{0, (0.15f + 0.02f * std::cos(kTau * folds * u / 4.f)) * (1.f - v), 0};
                            }),
              veil);
    };
    const float o = px + 0.5f * t;
    valance({-o, top, hz}, {-o, top, fz + 0.5f * t}, {-1, 0, 0});
    valance({-o, top, fz + 0.5f * t}, {o, top, fz + 0.5f * t}, {0, 0, 1});
    valance({o, top, fz + 0.5f * t}, {o, top, hz}, {1, 0, 0});
}

void bed_of(Kit& k, float width, Posts over) {
    const float length = 2.0f, base_y = 0.3f;
    const BedForm form = form_for(k, k.style.forms.bed);
    const bool cloth_head = form == BedForm::panels || form == BedForm::tufted;
    Material quilt = tinted(k.style.fabric, lerp(k.style.fabric.color_a, {0.75f, 0.72f, 0.66f}, 0.55f));
    quilt.name = "duvet";
    quilt.pattern = Pattern::fabric;
    const bool colored = k.request.color ||
                         !k.request.color_name.empty();  // an upholstered head is of the color that was asked for, too
    const int duvet = k.main(quilt);
    const int linen = k.material(tinted(k.style.fabric, {0.74f, 0.72f, 0.68f})), wood = k.material(k.style.wood),
              head = cloth_head
                         ? k.material(colored
                                          ? tinted(k.style.fabric2,
                                                   k.piece.materials[static_cast<std::size_t>(duvet)].color_a * 0.85f)
                                          : k.style.fabric2)
                         : wood,
              throw_cloth = accent_cloth(k);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(wood, {sx * (0.5f * width - 0.07f), 0, sz * (0.5f * length - 0.09f)},
                  {sx * (0.5f * width - 0.08f), 0.17f, sz * (0.5f * length - 0.1f)}, 0.02f, 0.03f, 12);
    k.board(wood, {0, 0.15f, 0}, {width + 0.06f, base_y - 0.13f, length + 0.04f}, 0.012f);
    const Vec3f mattress{width, 0.52f, length};
    k.soft(linen, {0, base_y - 0.03f, 0}, {width, 0.26f, length}, {0.06f, 0.015f, 0.001f, 8});
    Bedding bedding{mattress};
    if (over != no_posts) bedding.more = around_posts(width, length);
    const DrapedCloth cover = over_mattress(bedding, -0.42f, 0.5f * length + 0.26f, {.drop_m = 0.26f}, k.seed());
    k.add_soft(cloth_mesh(cover, 0.03f), duvet, kDrapedCrease);
    // The folded edge of the duvet, then a throw across the foot.
    k.soft(linen, {0, 0.545f, -0.36f}, {width + 0.06f, 0.05f, 0.3f}, {0.02f, 0.01f, 0.004f, 18});
    const float throw_z = 0.38f, throw_end = throw_z + k.rng.uniform(0.35f, 0.48f);
    Covers across{.drop_m = 0.3f, .thick_m = 0.016f, .slack = 0.015f};
    lay_over(bedding, cover, throw_z, throw_end, across);
    k.add_soft(cloth_mesh(over_mattress(bedding, throw_z, throw_end, across, k.seed()), 0.016f), throw_cloth,
               kDrapedCrease);
    if (over == no_posts) headboard(k, form, width, length, wood, head);
    else four_posts(k, over, width, length, duvet);
    // Pillows: a row that leans, a row before it, cushions.
    const int row = width > 1.2f ? 2 : 1;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < row; ++i) {
            const float x = row == 1 ? 0.f : (static_cast<float>(i) - 0.5f) * 0.5f * width;
            put_pillow(
                k, j == 0 ? linen : duvet,
                {x + k.rng.uniform(-0.02f, 0.02f), 0.54f, -0.5f * length + 0.26f + 0.16f * static_cast<float>(j)},
                {0.68f - 0.06f * static_cast<float>(j), 0.46f, 0.2f}, 32.f + 8.f * static_cast<float>(j),
                k.rng.uniform(-4, 4));
        }
    put_pillow(k, throw_cloth, {k.rng.uniform(-0.1f, 0.1f), 0.55f, -0.5f * length + 0.56f}, {0.45f, 0.38f, 0.15f}, 38.f,
               k.rng.uniform(-10, 10));
    // Between the pillows and the throw.
    k.top(0.58f, 0, 0.06f, 0.4f * width, 0.3f);
    k.piece.clearance_front_m = 0.5f;
    k.piece.clearance_side_m = 0.5f;
    k.piece.against_wall = true;
}

}  // namespace

void build_bed(Kit& k) { bed_of(k, 1.6f, no_posts); }

void build_bed_single(Kit& k) { bed_of(k, 0.95f, no_posts); }

void build_four_poster_bed(Kit& k) { bed_of(k, 1.6f, bare_posts); }

void build_canopy_bed(Kit& k) { bed_of(k, 1.6f, draped_posts); }

}  // namespace fastscene::furniture
