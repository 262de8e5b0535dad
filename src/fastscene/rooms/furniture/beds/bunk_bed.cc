// Beds one climbs into: bunk, loft and cabin beds.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"
#include "fastscene/rooms/prints.h"

namespace fastscene::furniture {
namespace {

constexpr float kBunkLong = 2.0f, kBunkWide = 0.94f;  // between the middles of the posts

constexpr float kMattress = 0.14f;  // thick

constexpr float kLadderWide = 0.42f;

// What is shared by the parts of one such bed.
struct Bunk {
    Kit& k;
    BunkForm form;
    int frame = 0, linen = 0;
    float hx = 0.5f * kBunkLong, hz = 0.5f * kBunkWide;

    explicit Bunk(Kit& kit);
    void beam(Vec3f a, Vec3f b, float high, float thick);
    void plank(Vec3f foot, Vec3f head, float wide, float thick);
    void posts(float top);
    void fence(Vec3f a, Vec3f b, float high);
    void deck(float base, bool slats);
    void made_bed(float base, int duvet);
    void ladder(float base, float lean);
    void guard(float base, bool gate_at_feet = false);
    void stairs(float base);
    int duvet(int nth);
};

bool is_metal(const std::string& material) {
    return material == "metal" || material == "iron" || material == "steel" || material == "brass" ||
           material == "wrought iron" || material == "chrome";
}

BunkForm bunk_form(Kit& k) {
    const BunkForm form = form_for(k, k.style.forms.bunk);
    if (is_metal(k.request.material)) return BunkForm::pipes;
    return form == BunkForm::pipes && !k.request.material.empty() ? BunkForm::boards : form;
}

Bunk::Bunk(Kit& kit) : k(kit), form(bunk_form(kit)) {
    Material wood = form == BunkForm::pipes ? k.style.metal : k.style.of(k.style.made_of.bunk);
    if (k.style.lacquered_play && form != BunkForm::pipes && k.rng.chance(0.45f)) wood = *material_named("lacquer");
    frame = k.main(std::move(wood), false);  // what was said to be striped is the bedding
    linen = k.material(tinted(k.style.fabric, {0.74f, 0.72f, 0.68f}));
}

// A level board from a to b, both at the middle of its lower edge.
void Bunk::beam(Vec3f a, Vec3f b, float high, float thick) {
    const Vec3f d = b - a, size = std::fabs(d.x) > std::fabs(d.z) ? Vec3f{std::fabs(d.x), high, thick}
                                                                  : Vec3f{thick, high, std::fabs(d.z)};
    k.board(frame, (a + b) * 0.5f, size, 0.006f);
}

// A board that leans in the plane of y and z.
void Bunk::plank(Vec3f foot, Vec3f head, float wide, float thick) {
    const Vec3f d = head - foot;
    Mesh m = shapes::box({wide, length(d), thick}, 0.005f);
    shapes::turn(m, {1, 0, 0}, std::atan2(d.z, d.y) * 180.f / kPi);
    k.add(std::move(m), frame, (foot + head) * 0.5f);
}

void Bunk::posts(float top) {
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            const Vec3f foot{sx * hx, 0, sz * hz}, head = foot + Vec3f{0, top, 0};
            if (form == BunkForm::boards) {
                k.board(frame, foot, {0.062f, top, 0.062f}, 0.008f);
            } else if (form == BunkForm::bars) {
                k.board(frame, foot, {0.075f, top - 0.04f, 0.075f}, 0.012f);
                k.add(shapes::ball(head - Vec3f{0, 0.012f, 0}, {0.042f, 0.042f, 0.042f}, 18), frame);
            } else {
                k.rod(frame, foot, head, 0.022f, -1, 14);
                k.add(shapes::ball(head, {0.025f, 0.018f, 0.025f}, 14), frame);
            }
        }
}

// What keeps a sleeper in, between two posts, from a.y on.
void Bunk::fence(Vec3f a, Vec3f b, float high) {
    const Vec3f d = b - a, up{0, 1, 0};
    const float far = length(d);
    if (form == BunkForm::boards) {
        const int boards = std::max(1, static_cast<int>(high / 0.13f));
        const float step = high / static_cast<float>(boards), wide = std::min(0.095f, step - 0.04f);
        for (int i = 0; i < boards; ++i)
            beam(a + up * (step * static_cast<float>(i + 1) - wide), b + up * (step * static_cast<float>(i + 1) - wide),
                 wide, 0.022f);
        return;
    }
    const int bars = std::max(2, static_cast<int>(far / (form == BunkForm::pipes ? 0.15f : 0.13f)));
    if (form == BunkForm::bars) {
        beam(a + up * (high - 0.06f), b + up * (high - 0.06f), 0.06f, 0.034f);
        beam(a, b, 0.035f, 0.028f);
    } else {
        k.rod(frame, a + up * (high - 0.014f), b + up * (high - 0.014f), 0.014f, -1, 12);
        k.rod(frame, a + up * 0.012f, b + up * 0.012f, 0.011f, -1, 10);
    }
    for (int i = 1; i < bars; ++i) {
        const Vec3f at = a + d * (static_cast<float>(i) / static_cast<float>(bars));
        if (form == BunkForm::bars)
            k.board(frame, at + up * 0.02f,
                    d.x * d.x > d.z * d.z ? Vec3f{0.05f, high - 0.06f, 0.018f} : Vec3f{0.018f, high - 0.06f, 0.05f},
                    0.004f);
        else k.rod(frame, at + up * 0.012f, at + up * (high - 0.014f), 0.008f, -1, 8);
    }
}

// The rails between the posts and what the mattress lies on; `base` is its upper side.
void Bunk::deck(float base, bool slats) {
    const float high = form == BunkForm::pipes ? 0.05f : 0.15f,
                low = base - (form == BunkForm::pipes ? 0.045f : 0.075f),
                thick = form == BunkForm::pipes ? 0.03f : 0.03f;
    for (const float s : {-1.f, 1.f}) {
        beam({-hx, low, s * hz}, {hx, low, s * hz}, high, thick);
        beam({s * hx, low, -hz}, {s * hx, low, hz}, high, thick);
    }
    const float inside = kBunkLong - 0.06f;
    constexpr int kSlats = 13;
    if (!slats) return k.board(frame, {0, base - 0.018f, 0}, {inside, 0.018f, kBunkWide - 0.02f}, 0.003f);
    for (int i = 0; i < kSlats; ++i)
        k.board(frame, {inside * ((static_cast<float>(i) + 0.5f) / kSlats - 0.5f), base - 0.018f, 0},
                {0.09f, 0.018f, kBunkWide - 0.02f}, 0.003f);
}

// Mattress, duvet with its edge turned back, pillow; all within the rails.
void Bunk::made_bed(float base, int duvet_cloth) {
    const float inside = kBunkLong - 0.08f, wide = kBunkWide - 0.07f, top = base + kMattress;
    k.soft(linen, {0, base, 0}, {inside, kMattress, wide}, {0.045f, 0.008f, 0.001f, 10});
    const std::uint32_t seed = k.seed();
    const float x0 = -0.16f * inside, x1 = 0.5f * inside + 0.004f, half = 0.5f * wide + 0.004f;
    constexpr float kTuck = 0.06f, kThick = 0.018f;
    const auto ease = [](float t) { return t <= 0 ? 0.f : t >= 1 ? 1.f : t * t * (3 - 2 * t); };
    Mesh cover = shapes::slab(34, 22, kThick, [=](float u, float v) {
        const float x = x0 + (x1 - x0) * u, arc = (0.5f - v) * 2.f * (half + kTuck), side = arc < 0 ? -1.f : 1.f;
        const float over = std::max(0.f, std::fabs(arc) - half + 0.035f), bend = std::min(over / 0.055f, 1.f),
                    down = std::max(0.f, over - 0.055f);
        const float ripple = shapes::wobble({x * 3.4f, 2, arc * 3.4f}, seed) +
                             0.5f * shapes::wobble({x * 8.f, 5, arc * 8.f}, seed + 1) +
                             0.25f * shapes::wobble({x * 17.f, 8, arc * 17.f}, seed + 2);
        const float full = ease((half - std::fabs(arc)) / 0.2f) * ease((x1 - x) / 0.16f) *
                           ease((x - x0 - 0.08f) / 0.16f);
        const float fall = 0.05f * (1.f - ease((x1 - x) / 0.06f));
        const float z = std::fabs(arc) < half - 0.035f ? arc
                                                       : side * (half - 0.035f + 0.035f * std::sin(0.5f * kPi * bend));
        return Vec3f{x,
                     top + kThick + 0.004f + full * (0.042f + 0.02f * ripple) + 0.005f * ripple * (1.f - bend) -
                         0.035f * (1.f - std::cos(0.5f * kPi * bend)) - down - fall,
                     z};
    });
    // Stripes run across.
    for (std::size_t i = 0; i < cover.positions.size(); ++i)
        cover.coords[i] = {cover.positions[i].x, cover.positions[i].z, cover.positions[i].y};
    k.add(std::move(cover), duvet_cloth);
    k.soft(linen, {x0 + 0.06f, top + 0.002f, 0}, {0.27f, 0.075f, wide + 0.012f}, {0.034f, 0.012f, 0.004f, 18});
    put_pillow(k, duvet_cloth, {-0.5f * inside + 0.4f, top + 0.02f, k.rng.uniform(-0.03f, 0.03f)},
               {0.62f, 0.42f, 0.16f}, 64.f, 90.f + k.rng.uniform(-6, 6));
    k.top(top + 0.07f, 0.28f, 0, 0.5f, 0.26f);
}

// From the floor to a hand above the upper mattress, hooked onto its rail.
void Bunk::ladder(float base, float lean) {
    const float right = hx - 0.05f, left = right - kLadderWide, high = base + kMattress + 0.26f, z = hz + 0.034f;
    const auto at = [&](float x, float y) { return Vec3f{x, y, z + lean * (1.f - y / high)}; };
    for (const float x : {left, right}) {
        if (form == BunkForm::pipes) k.rod(frame, at(x, 0.f), at(x, high), 0.016f, -1, 12);
        else plank(at(x, 0.003f), at(x, high), 0.03f, 0.055f);
    }
    const int rungs = std::max(2, static_cast<int>(std::lround(base / 0.24f)));
    for (int i = 1; i <= rungs; ++i) {
        const float y = (base - 0.03f) * static_cast<float>(i) / static_cast<float>(rungs);
        if (form == BunkForm::pipes) k.rod(frame, at(left, y), at(right, y), 0.013f, -1, 12);
        else k.board(frame, at(0.5f * (left + right), y - 0.012f), {kLadderWide, 0.024f, 0.065f}, 0.005f);
    }
}

// Fences around the upper bed: all the way, but for the ladder; or for where stairs arrive, at the back of its feet.
void Bunk::guard(float base, bool gate_at_feet) {
    const float from = base + 0.075f, high = 0.3f, gate = hx - 0.09f - kLadderWide, inset = 0.03f;
    if (gate_at_feet) {
        for (const float s : {-1.f, 1.f}) fence({-hx, from, s * hz}, {hx, from, s * hz}, high);
        fence({-hx, from, -hz + inset}, {-hx, from, hz - inset}, high);
        return fence({hx, from, 0.02f}, {hx, from, hz - inset}, high);
    }
    fence({-hx, from, hz}, {gate, from, hz}, high);
    fence({-hx, from, -hz}, {hx, from, -hz}, high);
    for (const float s : {-1.f, 1.f}) fence({s * hx, from, -hz + inset}, {s * hx, from, hz - inset}, high);
    if (form == BunkForm::pipes) k.rod(frame, {gate, base, hz}, {gate, from + high, hz}, 0.015f, -1, 12);
    else k.board(frame, {gate, base - 0.07f, hz}, {0.045f, high + 0.16f, 0.045f}, 0.006f);
}

// Steps at the feet, from the front to the back, with a drawer in each and a rail on the outside.
void Bunk::stairs(float base) {
    constexpr int kSteps = 4;
    constexpr float kStairWide = 0.44f;
    const float x0 = hx + 0.036f, x1 = x0 + kStairWide, run = kBunkWide / kSteps, rise = (base - 0.02f) / kSteps;
    const int box = form == BunkForm::pipes ? k.material(k.style.of(k.style.made_of.bunk_boxes)) : frame,
              knob = k.material(k.style.metal);
    for (int i = 0; i < kSteps; ++i) {
        const float front = hz - run * static_cast<float>(i), back = -hz, top = rise * static_cast<float>(i + 1),
                    low = rise * static_cast<float>(i);
        k.board(box, {0.5f * (x0 + x1), low, 0.5f * (front + back)},
                {kStairWide - 0.02f, rise - 0.022f, front - back - 0.02f}, 0.003f);
        k.board(box, {0.5f * (x0 + x1), top - 0.024f, 0.5f * (front + back)}, {kStairWide, 0.024f, front - back},
                0.004f);  // the tread
        fronts(k, box, knob, x0 + 0.012f, x1 - 0.012f, low + 0.008f, top - 0.028f, front - 0.012f, 1, 1);
    }
    const auto at = [&](float z) { return rise * ((hz - z) / run + 1.f) + 0.52f; };
    for (const float z : {hz - 0.03f, -hz + 0.03f}) {
        const float foot = z > 0 ? rise - 0.01f : base - 0.03f;
        if (form == BunkForm::pipes)
            k.rod(frame, {x1 - 0.02f, foot, z}, {x1 - 0.02f, std::min(at(z), base + 0.46f), z}, 0.016f, -1, 12);
        else k.board(frame, {x1 - 0.022f, foot, z}, {0.04f, std::min(at(z), base + 0.46f) - foot, 0.04f}, 0.006f);
    }
    const float end = std::min(at(-hz + 0.03f), base + 0.46f);
    if (form == BunkForm::pipes)
        k.rod(frame, {x1 - 0.02f, at(hz - 0.03f), hz - 0.03f}, {x1 - 0.02f, end, -hz + 0.03f}, 0.015f, -1, 12);
    else
        plank({x1 - 0.022f, at(hz - 0.03f) - 0.02f, hz - 0.03f}, {x1 - 0.022f, end - 0.02f, -hz + 0.03f}, 0.042f,
              0.05f);
}

// Cloth for the nth bed: no two alike.
int Bunk::duvet(int nth) {
    const std::size_t count = k.style.palette.size(),
                      first = static_cast<std::size_t>(k.rng.index(static_cast<int>(count)));
    const auto asked = color_named(k.request.holder_color);
    const Vec3f color = k.style.palette[(first + 2 * static_cast<std::size_t>(nth)) % count];
    Material m = tinted(k.style.fabric, asked ? *asked : lerp(color, {0.72f, 0.69f, 0.64f}, 0.3f));
    m.name = "duvet", m.pattern = Pattern::fabric;
    const bool striped = (nth + k.rng.index(2)) % 2 == 0;
    k.print(m, asked);
    if (striped && !asked && !is_print(k.request.pattern))
        m.pattern = Pattern::stripes, m.scale_m = 0.07f, m.color_b = {0.72f, 0.7f, 0.65f}, m.color_c = m.color_a;
    return k.material(m);
}

void settle_bunk(Kit& k) {
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

}  // namespace

void build_bunk_bed(Kit& k) {
    // Two beds, or three with less air between them; up a ladder or up stairs.
    const bool triple = k.request.pattern == "triple", stairs = k.request.pattern == "stairs";
    const std::vector<float> bases = triple ? std::vector<float>{0.16f, 0.94f, 1.72f}
                                            : std::vector<float>{0.26f, 1.16f};
    Bunk bunk(k);
    bunk.posts(bases.back() + (triple ? 0.42f : 0.46f));
    // Head and foot of the lowest bed.
    for (const float s : {-1.f, 1.f})
        bunk.fence({s * bunk.hx, bases[0] + 0.08f, -bunk.hz + 0.03f}, {s * bunk.hx, bases[0] + 0.08f, bunk.hz - 0.03f},
                   0.4f);
    for (std::size_t i = 0; i < bases.size(); ++i) {
        bunk.deck(bases[i], i > 0);
        if (i > 0) bunk.guard(bases[i], stairs);
        bunk.made_bed(bases[i], bunk.duvet(static_cast<int>(i)));
    }
    if (stairs) bunk.stairs(bases.back());
    else bunk.ladder(bases.back(), triple ? 0.16f : 0.13f);
    settle_bunk(k);
}

// High enough to sit below it.
void build_loft_bed(Kit& k) {
    constexpr float kBase = 1.46f;
    Bunk bunk(k);
    bunk.posts(kBase + 0.46f);
    bunk.deck(kBase, true);
    // What keeps the posts upright: boards at the back and the sides, out of a desk's way.
    bunk.beam({-bunk.hx, 0.3f, -bunk.hz}, {bunk.hx, 0.3f, -bunk.hz}, bunk.form == BunkForm::pipes ? 0.03f : 0.09f,
              0.024f);
    for (const float s : {-1.f, 1.f})
        bunk.beam({s * bunk.hx, 0.3f, -bunk.hz}, {s * bunk.hx, 0.3f, bunk.hz},
                  bunk.form == BunkForm::pipes ? 0.03f : 0.09f, 0.024f);
    bunk.guard(kBase);
    bunk.made_bed(kBase, bunk.duvet(0));
    bunk.ladder(kBase, 0.05f);  // steep: a chair stands before it
    settle_bunk(k);
}

// Above drawers, doors and shelves.
void build_cabin_bed(Kit& k) {
    constexpr float kBase = 0.84f;
    Bunk bunk(k);
    bunk.posts(kBase + 0.44f);
    bunk.deck(kBase, false);
    const int frame = bunk.form == BunkForm::pipes ? k.material(k.style.of(k.style.made_of.bunk_boxes)) : bunk.frame,
              metal = k.material(k.style.metal);
    const float low = 0.05f, high = kBase - 0.09f, x0 = -bunk.hx + 0.04f, x1 = bunk.hx - 0.04f, split = 0.42f,
                drawers = -0.28f, depth = kBunkWide - 0.1f, back = -0.5f * depth, face = 0.5f * depth;
    // The carcass: bottom, back, uprights; drawers, a pair of doors, open shelves behind the ladder.
    k.board(frame, {0.5f * (x0 + x1), 0, 0}, {x1 - x0, low, depth - 0.04f}, 0.004f);
    k.board(frame, {0.5f * (x0 + x1), low, back + 0.01f}, {x1 - x0, high - low, 0.018f}, 0.003f);
    for (const float x : {x0 + 0.01f, drawers, split, x1 - 0.01f})
        k.board(frame, {x, low, 0}, {0.02f, high - low, depth}, 0.003f);
    k.board(frame, {0.5f * (x0 + split), low, 0}, {split - x0 - 0.01f, high - low, depth - 0.05f}, 0.003f);
    fronts(k, frame, metal, x0 + 0.02f, drawers - 0.01f, low, high, face - 0.025f, 1, 3);
    fronts(k, frame, metal, drawers + 0.01f, split - 0.01f, low, high, face - 0.025f, 2, 1);
    const float middle = 0.5f * (low + high);
    k.board(frame, {0.5f * (split + x1), middle - 0.01f, 0}, {x1 - split - 0.02f, 0.02f, depth - 0.02f}, 0.003f);
    for (const float y : {low, middle + 0.01f}) books(k, {split + 0.03f, y, -0.05f}, 0.3f, 0.27f, 0.3f);
    bunk.guard(kBase);
    bunk.made_bed(kBase, bunk.duvet(0));
    bunk.ladder(kBase, 0.1f);
    settle_bunk(k);
}

}  // namespace fastscene::furniture
