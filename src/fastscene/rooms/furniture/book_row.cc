// Rows of books on shelves.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/print_designs.h"

namespace fastscene::furniture {
namespace {

struct Book {
    Cell cell;
    Vec3f size;
};

// The block of pages, whose edges show above and at the front, lies in covers that reach over it; the spine is rounded.
// Its spine looks to +z; by the middle of its lower edge at the spine.
void add_book(Mesh& printed_parts, Mesh& pages, const Book& b, Vec3f at, float lean_deg, bool lying) {
    const float w = 0.5f * b.size.x, h = b.size.y, d = b.size.z, bulge = 0.16f * b.size.x, recess = 0.004f;
    const Cell& c = b.cell;
    Mesh m, leaf;
    // five columns of the spine
    constexpr int kColumns = 4;
    for (int i = 0; i <= kColumns; ++i) {
        const float t = 2.f * static_cast<float>(i) / kColumns - 1.f;
        for (const float v : {0.f, 1.f}) {
            m.positions.push_back({w * t, h * v, -bulge * t * t});
            m.normals.push_back(normalize(Vec3f{0.75f * t, 0, 1}));
            m.coords.push_back({mix(c.low.x, c.high.x, 0.5f + 0.5f * t), mix(c.low.y, c.high.y, v), 0});
        }
    }
    for (std::uint32_t i = 0; i < kColumns; ++i)
        m.triangles.insert(m.triangles.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1});
    const float u = mix(c.low.x, c.high.x, 0.06f), back = -d, front = -bulge;
    const std::array<Vec2f, 4> side{Vec2f{u, c.low.y}, {u, c.low.y}, {u, c.high.y}, {u, c.high.y}};
    add_quad(m, {Vec3f{w, 0, front}, {w, 0, back}, {w, h, back}, {w, h, front}}, {1, 0, 0}, side);
    add_quad(m, {Vec3f{-w, 0, back}, {-w, 0, front}, {-w, h, front}, {-w, h, back}}, {-1, 0, 0}, side);
    // the boards' edges above, and the pages between them
    const float board = std::min(0.0025f, 0.2f * b.size.x);
    const std::array<Vec2f, 4> edge{Vec2f{u, c.high.y}, {u, c.high.y}, {u, c.high.y}, {u, c.high.y}};
    for (const float s : {-1.f, 1.f}) {
        const float x0 = s < 0 ? -w : w - board, x1 = x0 + board;
        add_quad(m, {Vec3f{x0, h, front}, {x1, h, front}, {x1, h, back}, {x0, h, back}}, {0, 1, 0}, edge);
    }
    add_quad(m, {Vec3f{-w, h, 0}, {w, h, 0}, {w, h, front - 0.004f}, {-w, h, front - 0.004f}}, {0, 1, 0}, edge);
    add_quad(leaf,
             {Vec3f{-w, h - recess, front}, {w, h - recess, front}, {w, h - recess, back}, {-w, h - recess, back}},
             {0, 1, 0}, edge);
    add_quad(leaf, {Vec3f{w, 0, back}, {-w, 0, back}, {-w, h, back}, {w, h, back}}, {0, 0, -1}, edge);
    for (Mesh* part : {&m, &leaf}) {
        if (lying) {  // on its side, the title upright
            shapes::turn(*part, {0, 0, 1}, -90);
            shapes::move(*part, {-0.5f * h, w, 0});
        } else if (lean_deg != 0.f) {
            // about the lower corner towards which it leans
            const float x = lean_deg > 0 ? -w : w;
            shapes::move(*part, {-x, 0, 0});
            shapes::turn(*part, {0, 0, 1}, lean_deg);
            shapes::move(*part, {x, 0, 0});
        }
        shapes::move(*part, at);
    }
    shapes::append(printed_parts, m);
    shapes::append(pages, leaf);
}

}  // namespace

void book_row(Kit& k, Print spines, Vec3f at, float length, float max_height, float depth) {
    constexpr float kSet = 0.1f, kPile = 0.05f, kLean = 0.06f;  // how probable at each place
    const PrintSheet sheet = print_sheet(k, spines);
    const int paper = k.material(plain("paper", {0.6f, 0.53f, 0.4f}, 0.9f));
    const bool cloth = spines == Print::cloth_spines;
    const float least = cloth ? 0.016f : 0.011f, most = cloth ? 0.046f : 0.036f;
    Mesh covers, pages;
    float x = 0, usual = k.rng.uniform(0.19f, 0.26f);
    const auto any = [&] {
        usual = std::clamp(usual + k.rng.uniform(-0.025f, 0.025f), 0.175f, 0.275f);
        const float h = std::min(max_height, std::clamp(usual + k.rng.uniform(-0.03f, 0.03f), 0.16f, 0.3f));
        return Book{sheet[k.rng.index(sheet.cells)],
                    {k.rng.uniform(least, most), h, std::min(depth, h * k.rng.uniform(0.62f, 0.74f))}};
    };
    const auto stand = [&](const Book& b, float recess, float lean) {
        add_book(covers, pages, b, at + Vec3f{x + 0.5f * b.size.x, 0, -recess}, lean, false);
    };
    while (true) {
        Book b = any();
        if (x + b.size.x > length) break;
        if (k.rng.chance(kSet)) {  // the volumes of one work
            for (int volumes = 3 + k.rng.index(6); volumes > 0 && x + b.size.x <= length; --volumes) {
                stand(b, 0.008f, 0);
                x += b.size.x + 0.001f;
            }
            continue;
        }
        if (k.rng.chance(kPile) && x + b.size.y + 0.01f < length && max_height > 0.12f) {
            float y = 0, longest = 0;
            for (int i = 2 + k.rng.index(4); i > 0; --i) {
                Book lies = any();
                if (x + lies.size.y > length || y + lies.size.x > max_height - 0.02f) break;
                longest = std::max(longest, lies.size.y);
                add_book(covers, pages, lies, at + Vec3f{x + 0.5f * lies.size.y, y, -k.rng.uniform(0, 0.015f)}, 0,
                         true);
                y += lies.size.x;
            }
            x += longest + 0.012f;
            continue;
        }
        const float recess = k.rng.uniform(0.f, 0.018f);
        if (k.rng.chance(kLean) && x > 0.1f) {  // against its left neighbor
            const float degrees = k.rng.uniform(6.f, 13.f), sine = std::sin(degrees * kPi / 180.f);
            b.size.y = std::min(b.size.y, 0.2f);
            if (x + b.size.y * sine + b.size.x < length) {
                x += b.size.y * sine;
                stand(b, recess, degrees);
                x += b.size.x + 0.004f;
                if (k.rng.chance(0.4f)) x += k.rng.uniform(0.02f, 0.09f);
                continue;
            }
        }
        stand(b, recess, 0);
        x += b.size.x + 0.001f;
        if (k.rng.chance(0.02f)) x += k.rng.uniform(0.03f, 0.1f);
    }
    if (covers.triangles.empty()) return;
    k.add(std::move(covers), sheet.material);
    k.add(std::move(pages), paper);
}

}  // namespace fastscene::furniture
