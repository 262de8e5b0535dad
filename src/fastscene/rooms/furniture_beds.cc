// Beds that stand at the wall with their heads, day beds, cots.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_forms.h"

namespace fastscene::furniture {

// Cloth over a mattress: flat on top, hanging at the sides, with folds.
Mesh blanket(Vec3f mattress, float drop, float from_z, float to_z, float lift, float thick, std::uint32_t seed,
             float fold) {
    const float hx = 0.5f * mattress.x + 0.02f + lift;
    Mesh cloth = shapes::slab(44, 30, thick, [=](float u, float v) {
        const float arc = (u - 0.5f) * 2.f * (hx + drop), z = from_z + (to_z - from_z) * v;
        const float over = std::max(0.f, std::fabs(arc) - hx + 0.05f), sx = arc < 0 ? -1.f : 1.f;
        const float bend = std::min(over / 0.1f, 1.f), hang = std::max(0.f, over - 0.1f * 0.6f);
        const float ripple = shapes::wobble({arc * 3.f, 2.f, z * 3.1f}, seed) +
                             0.5f * shapes::wobble({arc * 7.f, 5.f, z * 7.5f}, seed + 1) +
                             0.22f * shapes::wobble({arc * 15.f, 8.f, z * 15.f}, seed + 2);
        const float wave = std::sin(z * 15.f + 2.f * shapes::wobble({z * 2.f, sx, 0}, seed + 3));
        float x = std::fabs(arc) < hx - 0.05f ? arc
                                              : sx * (hx - 0.05f + 0.05f * std::sin(1.5708f * bend) +
                                                      0.025f * hang / std::max(drop, 0.01f) * (1.f + wave));
        float y = mattress.y + lift + thick - 0.05f * (1.f - std::cos(1.5708f * bend)) - hang +
                  fold * (1.f + 0.6f * ripple) * (1.f - 0.7f * bend);
        // The foot end hangs too.
        const float past = z - 0.5f * mattress.z;
        if (past > 0.f) {
            y -= std::max(past - hang, 0.f);  // at the corner the longer of both falls
            return Vec3f{x, y, 0.5f * mattress.z + 0.03f + lift + 0.012f * (1.f + std::sin(arc * 14.f))};
        }
        return Vec3f{x, std::max(y, 0.06f), z};
    });
    // Stripes run from side to side, whatever the folds.
    for (std::size_t i = 0; i < cloth.positions.size(); ++i)
        cloth.coords[i] = {cloth.positions[i].z, cloth.positions[i].x, cloth.positions[i].y};
    return cloth;
}
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
    const LegType type = k.style.legs;
    if (type == LegType::metal_frame || k.style.name == "art deco")
        return k.board(mat, foot, {0.036f, top, 0.036f}, 0.004f);
    if (type != LegType::turned && type != LegType::square) return k.board(mat, foot, {0.055f, top, 0.055f}, 0.01f);
    k.board(mat, foot, {0.085f, 0.56f, 0.085f}, 0.01f);
    const float r = 0.036f;
    const std::array<Vec2f, 13> p{Vec2f{r, 0.56f},         {1.1f * r, 0.575f},     {0.7f * r, 0.6f},
                                  {1.15f * r, 0.66f},      {1.25f * r, 0.76f},     {0.8f * r, 0.92f},
                                  {0.62f * r, 0.95f},      {1.05f * r, 0.975f},    {0.85f * r, 1.02f},
                                  {0.72f * r, top - 0.1f}, {1.f * r, top - 0.07f}, {0.8f * r, top - 0.04f},
                                  {0.8f * r, top}};
    k.add(shapes::lathe(p, 14, true), mat, foot);
}

// Posts with rails between their heads, a headboard and a low foot; `draped`: a roof of cloth, and cloth tied to the
// posts.
void four_posts(Kit& k, Posts over, float width, float length, int duvet) {
    const bool metal = k.style.legs == LegType::metal_frame || k.style.name == "art deco",
               turned = !metal && (k.style.legs == LegType::turned || k.style.legs == LegType::square),
               rich = k.style.mouldings == Mouldings::rich;
    const int frame = k.material(metal ? k.style.metal : k.style.wood);
    // Outside of what hangs from the mattress.
    const float top = turned && over == bare_posts ? 2.02f : 2.1f, px = 0.5f * width + 0.1f,
                hz = -0.5f * length - 0.06f, fz = 0.5f * length + 0.13f, mid = 0.5f * (hz + fz),
                t = metal ? 0.034f : 0.05f;
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
    enum { panels, tufted, slats, board, low, iron, posts };
    const auto form = static_cast<BedForm>(form_for(k,
                                                    {{"modern", panels, low},
                                                     {"scandinavian", board, slats},
                                                     {"japandi", low, board},
                                                     {"industrial", iron, panels},
                                                     {"classic", tufted, posts},
                                                     {"boho", posts, board},
                                                     {"rustic", slats, iron},
                                                     {"mid-century", board, low},
                                                     {"mediterranean", iron, posts},
                                                     {"art deco", panels, tufted}},
                                                    board));
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
    k.add(blanket(mattress, 0.26f, -0.42f, 0.5f * length + 0.24f, 0.006f, 0.03f, k.seed(), 0.012f), duvet);
    // The folded edge of the duvet, then a throw across the foot.
    k.soft(linen, {0, 0.545f, -0.36f}, {width + 0.06f, 0.05f, 0.3f}, {0.02f, 0.01f, 0.004f, 18});
    k.add(blanket(mattress, 0.3f, 0.38f, 0.38f + k.dice.uniform(0.35f, 0.48f), 0.06f, 0.016f, k.seed(), 0.012f),
          throw_cloth);
    if (over == no_posts) headboard(k, form, width, length, wood, head);
    else four_posts(k, over, width, length, duvet);
    // Pillows: a row that leans, a row before it, cushions.
    const int row = width > 1.2f ? 2 : 1;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < row; ++i) {
            const float x = row == 1 ? 0.f : (static_cast<float>(i) - 0.5f) * 0.5f * width;
            put_pillow(
                k, j == 0 ? linen : duvet,
                {x + k.dice.uniform(-0.02f, 0.02f), 0.54f, -0.5f * length + 0.26f + 0.16f * static_cast<float>(j)},
                {0.68f - 0.06f * static_cast<float>(j), 0.46f, 0.2f}, 32.f + 8.f * static_cast<float>(j),
                k.dice.uniform(-4, 4));
        }
    put_pillow(k, throw_cloth, {k.dice.uniform(-0.1f, 0.1f), 0.55f, -0.5f * length + 0.56f}, {0.45f, 0.38f, 0.15f},
               38.f, k.dice.uniform(-10, 10));
    // Between the pillows and the throw.
    k.top(0.58f, 0, 0.06f, 0.4f * width, 0.3f);
    k.piece.clearance_front_m = 0.5f;
    k.piece.clearance_side_m = 0.5f;
    k.piece.against_wall = true;
}
void bed(Kit& k) { bed_of(k, 1.6f, no_posts); }
void bed_single(Kit& k) { bed_of(k, 0.95f, no_posts); }
void four_poster_bed(Kit& k) { bed_of(k, 1.6f, bare_posts); }
void canopy_bed(Kit& k) { bed_of(k, 1.6f, draped_posts); }
void crib(Kit& k) {
    const int wood = k.main(k.style.wood), linen = k.material(tinted(k.style.fabric, {0.72f, 0.7f, 0.65f})),
              cloth = accent_cloth(k);
    const float hx = 0.65f, hz = 0.35f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) k.board(wood, {sx * hx, 0, sz * hz}, {0.045f, 0.92f, 0.045f}, 0.008f);
    for (const float s : {-1.f, 1.f})
        for (const float y : {0.25f, 0.86f}) {
            k.board(wood, {0, y, s * hz}, {2 * hx, 0.04f, 0.03f}, 0.006f);
            k.board(wood, {s * hx, y, 0}, {0.03f, 0.04f, 2 * hz}, 0.006f);
        }
    for (const float s : {-1.f, 1.f}) {
        for (int i = -6; i <= 6; ++i)
            k.rod(wood, {0.092f * static_cast<float>(i), 0.28f, s * hz},
                  {0.092f * static_cast<float>(i), 0.87f, s * hz}, 0.009f, -1, 8);
        for (int i = -3; i <= 3; ++i)
            k.rod(wood, {s * hx, 0.28f, 0.092f * static_cast<float>(i)},
                  {s * hx, 0.87f, 0.092f * static_cast<float>(i)}, 0.009f, -1, 8);
    }
    k.soft(linen, {0, 0.3f, 0}, {1.24f, 0.12f, 0.64f}, {0.03f, 0.01f, 0.001f, 8});
    k.soft(cloth, {0.2f, 0.4f, 0}, {0.7f, 0.05f, 0.6f}, {0.02f, 0.015f, 0.006f, 14});
    k.top(0.45f, 0.2f, 0, 0.3f, 0.24f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

// A sofa to sleep on: its long side at the wall, a back and two ends of one height.
void daybed(Kit& k) {
    enum { boards, iron, padded };
    int form = form_for(k,
                        {{"modern", padded, boards},
                         {"scandinavian", boards, iron},
                         {"japandi", boards, boards},
                         {"industrial", iron, boards},
                         {"classic", padded, iron},
                         {"boho", boards, iron},
                         {"rustic", boards, iron},
                         {"mid-century", boards, padded},
                         {"mediterranean", iron, boards},
                         {"art deco", padded, padded}},
                        boards);
    if (k.request.material == "iron" || k.request.material == "metal" || k.request.material == "wrought iron")
        form = iron;
    const float long_side = 2.04f, deep = 0.98f, hx = 0.5f * long_side, hz = 0.5f * deep,
                base = form == padded ? 0.3f : 0.28f, top = base + 0.17f, high = form == iron ? 0.92f : 0.8f;
    Material sheet = tinted(k.style.fabric, lerp(k.style.fabric.color_a, {0.74f, 0.71f, 0.66f}, 0.45f));
    const int cloth = k.main(sheet), frame = k.material(form == iron ? k.style.metal : k.style.wood);
    const bool colored = k.request.color || !k.request.color_name.empty();
    const auto ends = [&](auto&& each) {
        for (const float s : {-1.f, 1.f}) each(Vec3f{s * hx, 0, -hz}, Vec3f{s * hx, 0, hz});
        each(Vec3f{-hx, 0, -hz}, Vec3f{hx, 0, -hz});
    };
    if (form == boards) {
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {-1.f, 1.f}) k.board(frame, {sx * hx, 0, sz * hz}, {0.055f, high, 0.055f}, 0.012f);
        const bool bars = k.style.legs == LegType::turned || k.style.legs == LegType::splayed ||
                          k.style.legs == LegType::tapered;
        ends([&](Vec3f a, Vec3f b) {
            const bool along_x = a.z == b.z;
            const float far = along_x ? b.x - a.x : b.z - a.z;
            const auto bar = [&](float y, float tall, float thick) {
                k.board(frame, (a + b) * 0.5f + Vec3f{0, y, 0},
                        along_x ? Vec3f{far, tall, thick} : Vec3f{thick, tall, far}, 0.007f);
            };
            bar(high - 0.075f, 0.06f, 0.034f);
            if (!bars) return bar(top - 0.06f, high - top - 0.04f, 0.022f);
            const int count = static_cast<int>(far / 0.12f);
            for (int i = 1; i < count; ++i)
                k.rod(frame, lerp(a, b, static_cast<float>(i) / static_cast<float>(count)) + Vec3f{0, base - 0.06f, 0},
                      lerp(a, b, static_cast<float>(i) / static_cast<float>(count)) + Vec3f{0, high - 0.06f, 0}, 0.01f,
                      -1, 8);
        });
    } else if (form == iron) {
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {-1.f, 1.f}) {
                k.rod(frame, {sx * hx, 0, sz * hz}, {sx * hx, high - (sz > 0 ? 0.1f : 0.f), sz * hz}, 0.017f, -1, 12);
                k.add(shapes::ball({sx * hx, high + 0.02f - (sz > 0 ? 0.1f : 0.f), sz * hz}, {0.028f, 0.028f, 0.028f},
                                   12),
                      frame);
            }
        ends([&](Vec3f a, Vec3f b) {
            // The upper bar swings up in the middle of the back, and falls to the front at the ends.
            const bool back = a.z == b.z;
            const auto crest = [=](float u) {
                return back ? high - 0.05f + 0.1f * std::sin(kPi * u) * std::sin(kPi * u) : high - 0.05f - 0.1f * u * u;
            };
            std::vector<Vec3f> path;
            for (int i = 0; i <= 20; ++i)
                path.push_back(lerp(a, b, static_cast<float>(i) / 20.f) +
                               Vec3f{0, crest(static_cast<float>(i) / 20.f), 0});
            k.add(shapes::tube(path, 0.012f, 8), frame);
            k.rod(frame, a + Vec3f{0, top, 0}, b + Vec3f{0, top, 0}, 0.01f, -1, 8);
            const int count = back ? 15 : 7;
            for (int i = 1; i < count; ++i) {
                const float u = static_cast<float>(i) / static_cast<float>(count);
                k.rod(frame, lerp(a, b, u) + Vec3f{0, top, 0}, lerp(a, b, u) + Vec3f{0, crest(u), 0}, 0.007f, -1, 8);
            }
        });
    } else {
        const int cover = colored
                              ? k.material(tinted(k.style.fabric2,
                                                  k.piece.materials[static_cast<std::size_t>(cloth)].color_a * 0.85f))
                              : k.material(k.style.fabric2);
        for (const float s : {-1.f, 1.f})
            k.soft(cover, {s * (hx - 0.01f), 0.1f, 0}, {0.12f, high - 0.2f, deep}, {0.045f, 0.016f, 0.001f, 10});
        k.soft(cover, {0, 0.1f, -hz + 0.05f}, {long_side - 0.1f, high - 0.1f, 0.12f}, {0.045f, 0.016f, 0.001f, 14});
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {-1.f, 1.f})
                k.rod(frame, {sx * (hx - 0.05f), 0, sz * (hz - 0.08f)}, {sx * (hx - 0.05f), 0.13f, sz * (hz - 0.08f)},
                      0.018f, 0.026f, 12);
    }
    const float low = form == padded ? 0.13f : base - 0.1f;
    k.board(frame, {0, low, 0.01f}, {long_side - 0.08f, base - low, deep - 0.05f}, 0.008f);
    const float inside = long_side - (form == padded ? 0.16f : 0.08f), z0 = form == padded ? 0.055f : 0.01f,
                wide = deep - (form == padded ? 0.13f : 0.06f);
    k.soft(cloth, {0, base - 0.005f, z0}, {inside, top - base + 0.02f, wide}, {0.05f, 0.018f, 0.003f, 18});
    // Cushions along the back, a bolster at each end, a throw over the front.
    const int second = accent_cloth(k), third = accent_cloth(k),
              light = k.material(tinted(k.style.fabric, {0.72f, 0.7f, 0.65f}));
    const std::array<int, 4> cushions{light, second, cloth, third};
    const float back = z0 - 0.5f * wide;
    for (int i = 0; i < 4; ++i) {
        const float s = i % 3 == 0 ? 0.52f : 0.46f;
        put_pillow(
            k, cushions[static_cast<std::size_t>(i)],
            {inside * (0.2f * static_cast<float>(i) - 0.3f) + k.dice.uniform(-0.02f, 0.02f), top + 0.005f, back + 0.2f},
            {s, s, 0.17f}, 19.f, k.dice.uniform(-7, 7));
    }
    for (const float s : {-1.f, 1.f}) {
        const std::array<Vec2f, 8> p{Vec2f{0.02f, 0}, {0.07f, 0.006f},  {0.092f, 0.035f}, {0.097f, 0.1f},
                                     {0.097f, 0.44f}, {0.092f, 0.505f}, {0.07f, 0.534f},  {0.02f, 0.54f}};
        Mesh roll = shapes::lathe(p, 22, true);
        shapes::turn(roll, {1, 0, 0}, 90);
        k.add(std::move(roll), cloth, {s * (0.5f * inside - 0.105f), top + 0.1f, back + 0.32f});
    }
    k.top(top + 0.015f, 0, 0.2f, 0.34f * inside, 0.2f);
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
}

// Bedding on the floor: a futon on mats of straw, a mattress on pallets, or on nothing.
void floor_bed(Kit& k) {
    enum { bare, mats, pallets };
    const int form = form_for(k,
                              {{"modern", bare, pallets},
                               {"scandinavian", bare, pallets},
                               {"japandi", mats, mats},
                               {"industrial", pallets, pallets},
                               {"classic", bare, bare},
                               {"boho", pallets, bare},
                               {"rustic", pallets, pallets},
                               {"mid-century", mats, bare},
                               {"mediterranean", bare, pallets},
                               {"art deco", bare, mats}},
                              bare);
    const float width = 1.42f, length = 1.98f,
                base = form == mats      ? 0.035f
                       : form == pallets ? 0.13f
                                         : 0.f,
                thick = form == mats ? 0.13f : 0.2f, top = base + thick;
    Material quilt = tinted(k.style.fabric, lerp(k.style.fabric.color_a, {0.75f, 0.72f, 0.66f}, 0.5f));
    quilt.name = "duvet", quilt.pattern = Pattern::fabric;
    const int duvet = k.main(quilt), linen = k.material(tinted(k.style.fabric, {0.74f, 0.72f, 0.68f})),
              second = accent_cloth(k);
    if (form == mats) {
        Material straw = *material_named("wicker");
        straw.name = "tatami", straw.color_a = {0.52f, 0.47f, 0.28f}, straw.color_b = {0.42f, 0.37f, 0.2f},
        straw.scale_m = 0.014f, straw.bump_m = 0.001f;
        const int tatami = k.material(straw),
                  edge = k.material(plain("tatami border", k.style.fabric2.color_a * 0.6f, 0.85f));
        for (const float s : {-1.f, 1.f}) {
            k.board(tatami, {s * 0.5f * (width + 0.34f) * 0.5f, 0, 0},
                    {0.5f * (width + 0.34f) - 0.004f, base, length + 0.3f}, 0.004f);
            for (const float e : {-1.f, 1.f})
                k.board(edge, {s * 0.25f * (width + 0.34f) + e * (0.25f * (width + 0.34f) - 0.018f), 0.001f, 0},
                        {0.03f, base + 0.001f, length + 0.301f}, 0.002f);
        }
    }
    if (form == pallets) {
        const int wood = k.material(k.style.wood2);
        constexpr int kBoards = 12;
        for (int i = 0; i < kBoards; ++i)
            k.board(wood, {0, base - 0.022f, (length + 0.26f) * ((static_cast<float>(i) + 0.5f) / kBoards - 0.5f)},
                    {width + 0.3f, 0.022f, 0.14f}, 0.004f);
        for (const float x : {-1.f, 0.f, 1.f}) {
            k.board(wood, {x * 0.5f * (width + 0.18f), 0, 0}, {0.1f, 0.02f, length + 0.26f}, 0.004f);
            for (const float z : {-1.f, 0.f, 1.f})
                k.board(wood, {x * 0.5f * (width + 0.18f), 0.018f, z * 0.5f * (length + 0.1f)},
                        {0.1f, base - 0.04f, 0.14f}, 0.006f);
        }
    }
    k.soft(linen, {0, base, 0}, {width, thick, length}, {0.06f, 0.014f, 0.003f, 12});
    k.add(blanket({width, top, length}, thick - 0.03f, -0.36f, 0.5f * length + 0.1f, 0.006f, 0.03f, k.seed(), 0.016f),
          duvet);
    k.soft(linen, {0, top + 0.034f, -0.31f}, {width + 0.06f, 0.065f, 0.32f}, {0.028f, 0.012f, 0.004f, 18});
    for (const float s : {-1.f, 1.f}) {
        put_pillow(k, linen, {s * 0.34f, top + 0.01f, -0.5f * length + 0.32f}, {0.66f, 0.44f, 0.18f}, 66.f,
                   k.dice.uniform(-6, 6));
        put_pillow(k, s < 0 ? duvet : second,
                   {s * 0.33f + k.dice.uniform(-0.04f, 0.04f), top + 0.07f, -0.5f * length + 0.42f},
                   {0.58f, 0.4f, 0.15f}, 60.f, k.dice.uniform(-9, 9));
    }
    k.add(blanket({width, top, length}, thick - 0.04f, 0.4f, 0.78f, 0.075f, 0.014f, k.seed(), 0.008f), second);
    k.top(top + 0.06f, 0, 0.1f, 0.36f * width, 0.22f);
    k.piece.clearance_front_m = 0.5f;
    k.piece.clearance_side_m = 0.4f;
    k.piece.against_wall = true;
}

constexpr Entry kBeds[] = {{"bed", bed},
                           {"bed_single", bed_single},
                           {"four_poster_bed", four_poster_bed},
                           {"canopy_bed", canopy_bed},
                           {"daybed", daybed},
                           {"floor_bed", floor_bed},
                           {"crib", crib}};

}  // namespace

std::span<const Entry> beds() { return kBeds; }

}  // namespace fastscene::furniture
