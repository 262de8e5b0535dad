#include "fastscene/rooms/furniture/print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

#include "fastscene/image/color.h"
#include "fastscene/rooms/furniture/lettering.h"
#include "fastscene/rooms/furniture/print_designs.h"
#include "fastscene/rooms/texture_image.h"

namespace fastscene::furniture {
namespace {

constexpr auto kPrints = static_cast<std::size_t>(Print::count);

std::shared_ptr<const TextureImage> drawn(Print print) {
    static std::array<std::once_flag, kPrints> once;
    static std::array<std::shared_ptr<const TextureImage>, kPrints> images;
    const auto i = static_cast<std::size_t>(print);
    std::call_once(once[i], [&] {
        const PrintStyle& s = style_of(static_cast<Print>(i));
        ImageColor image(s.columns * s.width, s.rows * s.height);
        Random rng(1, s.name);
        for (int row = 0; row < s.rows; ++row)
            for (int column = 0; column < s.columns; ++column) {
                Patch patch(image, column * s.width, row * s.height, s.width, s.height);
                s.draw(patch, rng, s);
            }
        for (Vec3f& c : image.pixels)
            for (std::size_t a = 0; a < 3; ++a) c[a] = std::clamp(c[a], 0.012f, 0.8f);
        images[i] = texture_image(srgb8_from_linear(image));
    });
    return images[i];
}

Cell cell_of(Print print, int index) {
    const PrintStyle& s = style_of(print);
    const float w = 1.f / static_cast<float>(s.columns), h = 1.f / static_cast<float>(s.rows),
                // not quite to the edge, where the neighbor shines through
        inset_u = 0.8f * w / static_cast<float>(s.width), inset_v = 0.8f * h / static_cast<float>(s.height);
    const float u = w * static_cast<float>(index % s.columns), v = 1.f - h * static_cast<float>(index / s.columns + 1);
    return {{u + inset_u, v + inset_v}, {u + w - inset_u, v + h - inset_v}};
}

Material printed(const char* name, std::shared_ptr<const TextureImage> image, float width_m, float roughness) {
    Material m = plain(name, {1, 1, 1}, roughness);
    m.pattern = Pattern::image;
    m.image = std::move(image);
    m.scale_m = width_m;
    return m;
}

}  // namespace

void add_quad(Mesh& m, const std::array<Vec3f, 4>& corners, Vec3f normal, const std::array<Vec2f, 4>& coords) {
    const auto base = static_cast<std::uint32_t>(m.positions.size());
    for (std::size_t i = 0; i < 4; ++i) {
        m.positions.push_back(corners[i]);
        m.normals.push_back(normal);
        m.coords.push_back({coords[i].x, coords[i].y, 0});
    }
    m.triangles.insert(m.triangles.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
}

Cell PrintSheet::operator[](int i) const { return cell_of(print, i); }

const PrintStyle& style_of(Print print) {
    const auto i = static_cast<std::size_t>(print);
    const std::span<const PrintStyle> goods = goods_styles();
    return i < goods.size() ? goods[i] : poster_styles()[i - goods.size()];
}

PrintSheet print_sheet(Kit& k, Print print) {
    const PrintStyle& s = style_of(print);
    const auto image = drawn(print);
    const auto& all = k.piece.materials;
    const auto same = std::find_if(all.begin(), all.end(), [&](const Material& m) { return m.image == image; });
    const int material = same != all.end()
                             ? static_cast<int>(same - all.begin())
                             : k.material(
                                   printed(s.name, image, s.cell_m.x * static_cast<float>(s.columns), s.roughness));
    return {material, s.columns * s.rows, print};
}

Mesh printed_box(const Cell& c, Vec3f s) {
    Mesh m;
    const float x = 0.5f * s.x, z = 0.5f * s.z, y = s.y;
    // Faces that are not printed show the ground: the left edge of the cell, and its upper one.
    const float u = mix(c.low.x, c.high.x, 0.03f), v = mix(c.low.y, c.high.y, 0.97f);
    const std::array<Vec2f, 4> front{c.low, {c.high.x, c.low.y}, c.high, {c.low.x, c.high.y}},
        side{Vec2f{u, c.low.y}, {u, c.low.y}, {u, c.high.y}, {u, c.high.y}},
        top{Vec2f{c.low.x, v}, {c.high.x, v}, {c.high.x, v}, {c.low.x, v}};
    add_quad(m, {Vec3f{-x, 0, z}, {x, 0, z}, {x, y, z}, {-x, y, z}}, {0, 0, 1}, front);
    add_quad(m, {Vec3f{x, 0, -z}, {-x, 0, -z}, {-x, y, -z}, {x, y, -z}}, {0, 0, -1}, side);
    add_quad(m, {Vec3f{x, 0, z}, {x, 0, -z}, {x, y, -z}, {x, y, z}}, {1, 0, 0}, side);
    add_quad(m, {Vec3f{-x, 0, -z}, {-x, 0, z}, {-x, y, z}, {-x, y, -z}}, {-1, 0, 0}, side);
    add_quad(m, {Vec3f{-x, y, z}, {x, y, z}, {x, y, -z}, {-x, y, -z}}, {0, 1, 0}, top);
    add_quad(m, {Vec3f{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}}, {0, -1, 0}, top);
    return m;
}

Mesh printed_can(const Cell& c, float r, float y0, float y1, int sides) {
    Mesh m;
    const int steps = sides / 2;
    for (const float half : {1.f, -1.f}) {
        const auto base = static_cast<std::uint32_t>(m.positions.size());
        for (int i = 0; i <= steps; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(steps), a = kPi * t;
            const Vec3f out{-half * std::cos(a), 0, half * std::sin(a)};
            for (const float y : {y0, y1}) {
                m.positions.push_back(r * out + Vec3f{0, y, 0});
                m.normals.push_back(out);
                m.coords.push_back({mix(c.low.x, c.high.x, t), y == y0 ? c.low.y : c.high.y, 0});
            }
        }
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(steps); ++i) {
            const std::uint32_t v = base + 2 * i;
            m.triangles.insert(m.triangles.end(), {v, v + 2, v + 3, v, v + 3, v + 1});
        }
    }
    return m;
}

Mesh printed_face(const Cell& c, Vec2f s) {
    Mesh m;
    add_quad(m, {Vec3f{0, 0, 0}, {s.x, 0, 0}, {s.x, s.y, 0}, {0, s.y, 0}}, {0, 0, 1},
             {c.low, {c.high.x, c.low.y}, c.high, {c.low.x, c.high.y}});
    return m;
}

Material picture_material(const char* name, const ImageColor& image, float width_m, float roughness) {
    return printed(name, texture_image(srgb8_from_linear(image)), width_m, roughness);
}

void sign(Kit& k, std::string_view words, Vec3f ground, Vec3f ink, Vec3f at, Vec2f size) {
    constexpr float kPixelsPerM = 260.f, kMost = 640.f;
    const float scale = std::min(kPixelsPerM, kMost / std::max(size.x, size.y));
    ImageColor image(std::max(8, static_cast<int>(size.x * scale)), std::max(8, static_cast<int>(size.y * scale)),
                     ground);
    Patch p(image, 0, 0, image.width, image.height);
    const float high = 0.46f * p.h, fits = std::min(high, 0.86f * p.w * high / letters_width(words, high));
    p.title(words, 0.5f * p.w, 0.5f * (p.h - fits), 0.86f * p.w, high, ink);
    const int material = k.material(picture_material("sign", image, size.x, 0.5f));
    const float u = 0.5f / p.w, v = 0.5f / p.h;
    k.add(printed_face({{u, v}, {1 - u, 1 - v}}, size), material, at);
}

}  // namespace fastscene::furniture
