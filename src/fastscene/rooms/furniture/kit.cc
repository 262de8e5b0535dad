#include "fastscene/rooms/furniture/kit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/builders.h"
#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/prints.h"

namespace fastscene::furniture {

Material plain(std::string name, Vec3f color, float roughness) {
    Material m;
    m.name = std::move(name);
    m.color_a = m.color_b = m.color_c = color;
    m.roughness = roughness;
    return m;
}
Material glow(std::string name, Vec3f radiance) {
    Material m = plain(std::move(name), {0.8f, 0.76f, 0.7f}, 0.7f);
    m.emission = radiance;
    return m;
}
Material lit(std::string name, Vec3f radiance) {
    Material m = glow(std::move(name), radiance);
    m.pattern = Pattern::screen;
    return m;
}
Material flame(std::string name, Vec3f radiance) {
    Material m = glow(std::move(name), radiance);
    m.color_a = m.color_b = m.color_c = {0.3f, 0.1f, 0.02f};
    m.burns = true;
    return m;
}
Material tinted(Material m, Vec3f color) {
    const float ratio = luminance(m.color_b) / std::max(luminance(m.color_a), 0.01f);
    m.color_a = color;
    m.color_b = color * std::clamp(ratio, 0.4f, 1.1f);
    if (m.pattern != Pattern::rug) m.color_c = color;
    return m;
}
Material glass() { return *material_named("glass"); }
bool is_upholstery(const std::string& material) {
    const auto m = material.empty() ? std::nullopt : material_named(material);
    return m && (m->pattern == Pattern::fabric || m->pattern == Pattern::leather || m->pattern == Pattern::knit);
}
Material porcelain() { return plain("porcelain", {0.8f, 0.8f, 0.78f}, 0.12f); }
Material steel() { return *material_named("steel"); }

int Kit::main(Material m, bool printed) {
    std::optional<Vec3f> color = request.color;
    if (!color && !request.color_name.empty()) color = color_named(request.color_name);
    if (!request.material.empty())
        if (const auto asked = material_named(request.material)) {
            const float scale = m.scale_m;
            const bool art = m.pattern == Pattern::rug || m.pattern == Pattern::art;
            if (!art) m = *asked;
            else m.scale_m = scale;
            if (request.material == "leather" && !color) m = style.leather;
        }
    // A weave is a material of one yarn; a print has colors of its own.
    static constexpr std::array<std::pair<std::string_view, Pattern>, 4> kWeaves{{{"knitted", Pattern::knit},
                                                                                  {"tiled", Pattern::tile},
                                                                                  {"marble", Pattern::marble},
                                                                                  {"wicker", Pattern::wicker}}};
    for (const auto& [name, pattern] : kWeaves)
        if (request.pattern == name) {
            m.pattern = pattern;
            m.scale_m = pattern == Pattern::knit ? 0.012f : 0.05f;
            m.color_b = pattern == Pattern::knit ? 0.75f * m.color_a : lerp(m.color_a, style.palette[0], 0.8f);
            m.color_c = style.palette[1];
        }
    if (color) {
        const Material old = m;
        m = tinted(m, *color);
        if (old.metal < 0.5f && luminance(m.color_b) < 0.01f) m.color_b = *color * 0.7f;
        m.name = (request.color_name.empty() ? "colored" : request.color_name) + " " + old.name;
    }
    if (printed) print(m, color);
    piece.main_material = material(std::move(m));
    return piece.main_material;
}

void Kit::print(Material& m, std::optional<Vec3f> said) const {
    if (!is_print(request.pattern)) return;
    // Coats of animals have their own colors; so do the squares of a quilt.
    if (!said && request.pattern == "leopard") m.color_a = {0.55f, 0.34f, 0.13f};
    if (!said && request.pattern == "zebra") m.color_a = {0.74f, 0.72f, 0.67f};
    if (!said && request.pattern == "camouflage") m.color_a = {0.2f, 0.19f, 0.09f};
    std::optional<Vec3f> second = color_named(request.color2_name);
    if (request.color2_name.empty()) second.reset();
    static constexpr Vec3f kInk{0.035f, 0.03f, 0.026f};
    if (!second && is_one_of(request.pattern, {"leopard", "zebra"})) second = kInk;
    if (!second && request.pattern == "camouflage" && !said) second = Vec3f{0.07f, 0.1f, 0.04f};
    // Of a color that was said the other is white, or a dark shade: the room's colors would take it over.
    if (!second && said)
        second = luminance(*said) < 0.45f ? lerp(*said, Vec3f{0.8f, 0.78f, 0.72f}, 0.8f) : *said * 0.4f;
    print_on(m, request.pattern,
             piece.kind == "rug"       ? PrintGround::rug
             : piece.kind == "curtain" ? PrintGround::curtain
                                       : PrintGround::cloth,
             second, style.palette);
    if (!said && request.pattern == "leopard") m.color_c = {0.33f, 0.17f, 0.055f};
    if (!said && request.pattern == "camouflage") m.color_c = {0.28f, 0.24f, 0.15f};
}

void Kit::merge(const Piece& other, Vec3f at, float turn_deg) {
    const int first = static_cast<int>(piece.materials.size());
    piece.materials.insert(piece.materials.end(), other.materials.begin(), other.materials.end());
    for (Mesh m : other.meshes) {
        if (turn_deg != 0.f) shapes::turn(m, {0, 1, 0}, turn_deg);
        m.material += first;
        shapes::move(m, at);
        piece.meshes.push_back(std::move(m));
    }
}
Piece Kit::small(std::string kind) {
    PieceRequest r;
    r.kind = std::move(kind);
    r.style = &style;
    r.seed = rng.next_u64();
    return make_piece(r);
}

Vec3f around(float a) { return {std::cos(a), 0, std::sin(a)}; }
// A flat bar from a to b in a plane of constant x: `wide` along x, `thick` across.
void strut(Kit& k, int material, Vec3f a, Vec3f b, float wide, float thick) {
    const Vec3f d = b - a;
    Mesh m = shapes::box({wide, length(d), thick}, 0.003f);
    shapes::turn(m, {1, 0, 0}, std::atan2(d.z, d.y) * 180.f / kPi);
    k.add(std::move(m), material, (a + b) * 0.5f);
}

void slat(Kit& k, int material, Vec3f a, Vec3f b, float wide, float thick) {
    const Vec3f d = b - a;
    Mesh m = shapes::box({wide, std::hypot(d.x, d.y), thick}, 0.003f);
    shapes::turn(m, {0, 0, 1}, std::atan2(-d.x, d.y) * 180.f / kPi);
    k.add(std::move(m), material, (a + b) * 0.5f);
}

// The outline of a star with five points, one of them up.
std::vector<Vec2f> star(float outer, float inner) {
    std::vector<Vec2f> outline;
    for (int i = 0; i < 10; ++i) {
        const float a = kTau * static_cast<float>(i) / 10.f, r = i % 2 == 0 ? outer : inner;
        outline.push_back({r * std::sin(a), -r * std::cos(a)});
    }
    return outline;
}

void legs(Kit& k, int mat, float hx, float hz, float y, float t) {
    const LegType type = k.style.legs;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            const Vec3f top{sx * hx, y, sz * hz}, foot{sx * hx, 0, sz * hz};
            switch (type) {
                case LegType::tapered: k.rod(mat, foot, top, 0.28f * t, 0.5f * t, 12); break;
                case LegType::splayed:
                    k.rod(mat, {sx * (hx + 0.1f * y), 0, sz * (hz + 0.06f * y)}, top, 0.26f * t, 0.48f * t, 12);
                    break;
                case LegType::hairpin: k.rod(mat, foot, top, 0.2f * t); break;
                case LegType::metal_frame: k.board(mat, foot, {0.7f * t, y, 0.7f * t}, 0.003f); break;
                case LegType::square: k.board(mat, foot, {t, y, t}, 0.005f); break;
                case LegType::turned: {
                    const float r = 0.5f * t;
                    const std::array<Vec2f, 10> p{Vec2f{0.45f * r, 0},    {0.75f * r, 0.03f * y},
                                                  {0.5f * r, 0.09f * y},  {0.55f * r, 0.2f * y},
                                                  {0.95f * r, 0.55f * y}, {0.7f * r, 0.68f * y},
                                                  {1.05f * r, 0.72f * y}, {0.7f * r, 0.76f * y},
                                                  {r, 0.8f * y},          {r, y}};
                    k.add(shapes::lathe(p, 16, true), mat, foot);
                    break;
                }
            }
        }
    if (type == LegType::metal_frame)
        for (const float sx : {-1.f, 1.f}) k.board(mat, {sx * hx, 0, 0}, {0.68f * t, 0.5f * t, 2 * hz}, 0.003f);
}

void books(Kit& k, Vec3f at, float length, float max_height, float depth) {
    book_row(k, is_old_book(k.style, k.rng) ? Print::cloth_spines : Print::paper_spines, at + Vec3f{0, 0, depth},
             length, max_height, depth);
}

void fronts(Kit& k, int mat, int metal, float x0, float x1, float y0, float y1, float z, int columns, int rows) {
    const bool framed = k.style.mouldings != Mouldings::none, knobs = framed || k.style.legs == LegType::turned;
    const float w = (x1 - x0) / static_cast<float>(columns), h = (y1 - y0) / static_cast<float>(rows);
    const bool door = h > 0.4f && h > 0.8f * w;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const float cx = x0 + (static_cast<float>(i) + 0.5f) * w, cy = y0 + (static_cast<float>(j) + 0.5f) * h;
            const float fw = w - 0.005f, fh = h - 0.005f;
            k.board(mat, {cx, cy - 0.5f * fh, z + 0.009f}, {fw, fh, 0.018f}, 0.003f);
            if (framed) {  // a raised frame around the panel
                const float f = std::min(0.07f, 0.2f * std::min(fw, fh));
                for (const float s : {-1.f, 1.f}) {
                    k.board(mat, {cx + s * 0.5f * (fw - f), cy - 0.5f * fh, z + 0.022f}, {f, fh, 0.01f}, 0.003f);
                    k.board(mat, {cx, cy + s * 0.5f * (fh - f) - 0.5f * f, z + 0.022f}, {fw - 2 * f, f, 0.01f}, 0.003f);
                }
            }
            const float zh = z + (framed ? 0.027f : 0.018f);
            const float side = columns > 1 ? (i % 2 == 0 ? 1.f : -1.f) : 1.f;
            if (door) {
                const float hx = cx + side * (0.5f * fw - 0.035f);
                if (knobs) k.add(shapes::ball({hx, cy, zh + 0.016f}, {0.014f, 0.014f, 0.016f}, 10), metal);
                else {
                    const float l = std::min(0.3f, 0.3f * fh);
                    k.rod(metal, {hx, cy - 0.5f * l, zh + 0.02f}, {hx, cy + 0.5f * l, zh + 0.02f}, 0.005f, -1, 8);
                    for (const float s : {-0.4f, 0.4f})
                        k.rod(metal, {hx, cy + s * l, zh - 0.002f}, {hx, cy + s * l, zh + 0.02f}, 0.004f, -1, 8);
                }
            } else if (knobs) {
                for (const float s : {-0.25f, 0.25f})
                    k.add(
                        shapes::ball({cx + s * (fw > 0.5f ? fw : 0.f), cy, zh + 0.014f}, {0.013f, 0.013f, 0.014f}, 10),
                        metal);
            } else {
                const float l = std::min(0.22f, 0.4f * fw);
                k.rod(metal, {cx - 0.5f * l, cy, zh + 0.018f}, {cx + 0.5f * l, cy, zh + 0.018f}, 0.005f, -1, 8);
                for (const float s : {-0.4f, 0.4f})
                    k.rod(metal, {cx + s * l, cy, zh - 0.002f}, {cx + s * l, cy, zh + 0.018f}, 0.004f, -1, 8);
            }
        }
}

namespace {

// Puts the piece where its mount promises and gives it the wished size.
void settle(Kit& k) {
    Piece& p = k.piece;
    shapes::Box b;
    const auto grow = [&] {
        b = {};
        for (const Mesh& m : p.meshes) {
            const shapes::Box c = shapes::bounds(m);
            for (std::size_t a = 0; a < 3; ++a) {
                b.low[a] = std::min(b.low[a], c.low[a]);
                b.high[a] = std::max(b.high[a], c.high[a]);
            }
        }
    };
    grow();
    Vec3f scale{1, 1, 1};
    if (!k.sized)
        for (std::size_t a = 0; a < 3; ++a)
            scale[a] = k.request.size_m[a] > 0.f ? k.request.size_m[a] / (b.high[a] - b.low[a]) : k.request.size_factor;
    Vec3f origin = (b.low + b.high) * 0.5f;
    origin.y = p.mount == Mount::ceiling ? b.high.y : b.low.y;
    if (p.mount == Mount::wall) origin.z = b.low.z;
    for (Mesh& m : p.meshes) {
        for (Vec3f& v : m.positions) v = (v - origin) * scale;
        for (Vec3f& n : m.normals) n = normalize(Vec3f{n.x / scale.x, n.y / scale.y, n.z / scale.z});
    }
    for (Surface& s : p.surfaces) s = {(s.center - origin) * scale, {s.half.x * scale.x, s.half.y * scale.z}};
    std::stable_sort(p.surfaces.begin(), p.surfaces.end(),
                     [](const Surface& a, const Surface& c) { return a.half.x * a.half.y > c.half.x * c.half.y; });
    p.size_m = (b.high - b.low) * scale;
}

// Meshes of one material become one: fewer, larger meshes trace and store better.
void merge_by_material(Piece& p) {
    std::vector<Mesh> merged(p.materials.size());
    for (Mesh& m : p.meshes) shapes::append(merged[static_cast<std::size_t>(m.material)], m);
    p.meshes.clear();
    for (std::size_t i = 0; i < merged.size(); ++i) {
        if (merged[i].triangles.empty()) continue;
        merged[i].material = static_cast<int>(i);
        p.meshes.push_back(std::move(merged[i]));
    }
}

}  // namespace
}  // namespace fastscene::furniture

namespace fastscene {
namespace {

// The room's own style ends with the room; one of styles() is named by its address.
std::shared_ptr<const PieceRequest> kept(PieceRequest request) {
    const auto& all = all_styles();
    if (std::none_of(all.begin(), all.end(), [&](const Style& s) { return &s == request.style; }))
        request.style = nullptr;
    return std::make_shared<const PieceRequest>(std::move(request));
}

Piece built(const PieceRequest& request) {
    if (request.style == nullptr) throw Error("piece '{}': expected a style, found none", request.kind);
    if (!(request.size_factor >= 0.25f && request.size_factor <= 4.f))
        throw Error("piece '{}': expected a size factor in [0.25, 4], found {}", request.kind, request.size_factor);
    if (request.pack && request.model) return request.pack->piece(*request.model, request);
    const furniture::Builder build = furniture::builder_of(request.kind);
    if (build == nullptr) throw Error("piece: expected a known class of furniture, found '{}'", request.kind);
    furniture::Kit kit{request, *request.style, Random(request.seed, "piece", hash_name(request.kind)), {}, false};
    kit.piece.kind = request.kind;
    build(kit);
    furniture::settle(kit);
    furniture::merge_by_material(kit.piece);
    return std::move(kit.piece);
}

}  // namespace

Piece make_piece(const PieceRequest& request) {
    Piece piece = built(request);
    piece.made_from = kept(request);
    piece.made_mount = piece.mount;
    return piece;
}

const std::vector<std::string>& piece_classes() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const furniture::BuilderEntry& e : furniture::builders()) out.emplace_back(e.kind);
        return out;
    }();
    return names;
}

}  // namespace fastscene
