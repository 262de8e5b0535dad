// Plans and surfaces of documents: outlines become a box and its blocks, materials those of a style.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/rooms/document_fields.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/materials.h"

namespace fastscene {
namespace {

constexpr float kLevel = 1e-3f;  // metres

bool crosses(Vec2f a, Vec2f b, Vec2f c, Vec2f d) {
    return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <= std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
           std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <= std::min(std::max(a.y, b.y), std::max(c.y, d.y));
}

// Even-odd rule.
bool is_inside(const std::vector<Vec2f>& polygon, Vec2f p) {
    bool inside = false;
    for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
        const Vec2f a = polygon[i], b = polygon[k];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

std::vector<float> levels(const std::vector<Vec2f>& polygon, float Vec2f::*axis) {
    std::vector<float> out;
    for (const Vec2f& p : polygon) out.push_back(p.*axis);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end(), [](float a, float b) { return b - a < kLevel; }), out.end());
    return out;
}

// The corners of the box that slanted walls cut off it: such a wall goes from one side of the box to the next. In the
// polygon their place is taken by the corner of the box.
std::vector<Block> take_cut_corners(std::vector<Vec2f>& polygon) {
    std::vector<Block> out;
    const std::vector<float> xs = levels(polygon, &Vec2f::x), zs = levels(polygon, &Vec2f::y);
    const auto at_end = [](float v, const std::vector<float>& all) {
        return std::abs(v - all.front()) < kLevel || std::abs(v - all.back()) < kLevel;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2f a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if (std::abs(a.x - b.x) < kLevel || std::abs(a.y - b.y) < kLevel) continue;
        Vec2f corner;
        if (at_end(a.x, xs) && at_end(b.y, zs)) corner = {a.x, b.y};
        else if (at_end(b.x, xs) && at_end(a.y, zs)) corner = {b.x, a.y};
        else continue;
        // What takes a whole side away is no corner.
        if (std::abs(a.x - b.x) > xs.back() - xs.front() - kLevel ||
            std::abs(a.y - b.y) > zs.back() - zs.front() - kLevel)
            continue;
        out.push_back(
            {Block::Kind::cut, {std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}});
        polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1, corner);
        ++i;
    }
    // What lies on a wall between two others is no corner any more.
    for (std::size_t i = 0; i < polygon.size() && !out.empty();) {
        const std::size_t n = polygon.size();
        const Vec2f a = polygon[(i + n - 1) % n], b = polygon[i], c = polygon[(i + 1) % n];
        const bool straight = (std::abs(a.x - b.x) < kLevel && std::abs(b.x - c.x) < kLevel) ||
                              (std::abs(a.y - b.y) < kLevel && std::abs(b.y - c.y) < kLevel);
        if (straight) polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
        else ++i;
    }
    return out;
}

void check_polygon(const std::vector<Vec2f>& polygon, const std::string& place) {
    const std::size_t n = polygon.size();
    if (n < 4) throw Error("{}: expected at least four corners, found {}", place, n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2f a = polygon[i], b = polygon[(i + 1) % n];
        const bool along_x = std::abs(a.y - b.y) < kLevel, along_z = std::abs(a.x - b.x) < kLevel;
        if (along_x == along_z)
            throw Error(
                "{}: expected walls along x or z, or slanted ones that cut off a corner of the plan's box, found "
                "another one from corner {} to {}",
                place, i, (i + 1) % n);
        for (std::size_t k = i + 2; k < n; ++k)
            if ((k + 1) % n != i && crosses(a, b, polygon[k], polygon[(k + 1) % n]))
                throw Error("{}: the plan crosses itself: the wall from corner {} meets that from corner {}", place, i,
                            k);
    }
}

}  // namespace

void dress(const DocumentSurfaces& given, Style& style) {
    DocumentSurfaces surfaces = given;
    document_fields::visit_surfaces(
        surfaces, [&](std::string_view, std::optional<Material>& m, Material Style::*own, std::string_view) {
            if (m) style.*own = *m;
        });
    if (surfaces.palette) style.palette = *surfaces.palette;
    if (surfaces.shelves) style.shelves = *surfaces.shelves;
}

DocumentSurfaces surfaces_of(const Style& style, const Style& usual) {
    DocumentSurfaces out;
    document_fields::visit_surfaces(
        out, [&](std::string_view, std::optional<Material>& m, Material Style::*own, std::string_view) {
            if (document_fields::material_json(style.*own) != document_fields::material_json(usual.*own))
                m = style.*own;
        });
    if (style.palette != usual.palette) out.palette = style.palette;
    if (style.shelves != usual.shelves) out.shelves = style.shelves;
    return out;
}

std::optional<Material> document_fields::surface_named(const std::string& name) {
    if (const auto material = material_named(name)) return material;
    const auto color = color_said(name);
    if (!color) return {};
    return materials::make(name + " paint", Pattern::plaster, *color, *color, 0.1f, 0.75f, 0.0003f);
}

void apply_polygon(const std::vector<Vec2f>& given, const std::string& place, Plan& plan) {
    std::vector<Vec2f> polygon = given;
    std::vector<Block> cuts = take_cut_corners(polygon);
    check_polygon(polygon, place);
    const std::vector<float> xs = levels(polygon, &Vec2f::x), zs = levels(polygon, &Vec2f::y);
    constexpr float kOff = 0.01f;
    const Vec2f middle{(xs.front() + xs.back()) / 2, (zs.front() + zs.back()) / 2};
    if (std::abs(middle.x) > kOff || std::abs(middle.y) > kOff)
        throw Error("{}: expected the origin in the middle of the plan's box, found that at ({:.2f}, {:.2f})", place,
                    middle.x, middle.y);
    plan.width = xs.back() - xs.front();
    plan.depth = zs.back() - zs.front();
    plan.measured = true;
    plan.blocks = std::move(cuts);
    // What of the box is not room, row by row; equal rows become one block.
    for (std::size_t k = 0; k + 1 < zs.size(); ++k)
        for (std::size_t i = 0; i + 1 < xs.size();) {
            const auto is_room = [&](std::size_t column) {
                return is_inside(polygon, {(xs[column] + xs[column + 1]) / 2, (zs[k] + zs[k + 1]) / 2});
            };
            std::size_t end = i;
            while (end + 1 < xs.size() && !is_room(end)) ++end;
            if (end > i) {
                const Vec2f low{xs[i], zs[k]}, high{xs[end], zs[k + 1]};
                const auto below = std::find_if(plan.blocks.begin(), plan.blocks.end(), [&](const Block& b) {
                    return b.low.x == low.x && b.high.x == high.x && b.high.y == low.y;
                });
                if (below != plan.blocks.end()) below->high.y = high.y;
                else plan.blocks.push_back({Block::Kind::corner, low, high});
            }
            i = std::max(end, i + 1);
        }
}

}  // namespace fastscene
