#include "fastscene/trace/texture.h"

#include "fastscene/trace/patterns.h"

namespace fastscene {
namespace {

TextureValue raw_texture(const Material& m, const TexturePoint& p) {
    switch (m.pattern) {
        case Pattern::plain: return {m.color_a, m.roughness, 0.5f};
        case Pattern::plaster: return patterns::plaster(m, p);
        case Pattern::wood: return patterns::wood(m, p);
        case Pattern::planks: return patterns::planks(m, p);
        case Pattern::herringbone: return patterns::herringbone(m, p);
        case Pattern::parquet: return patterns::parquet(m, p);
        case Pattern::tile: return patterns::tile(m, p);
        case Pattern::checker: return patterns::checker(m, p);
        case Pattern::subway: return patterns::subway(m, p);
        case Pattern::brick: return patterns::brick(m, p);
        case Pattern::concrete: return patterns::concrete(m, p);
        case Pattern::marble: return patterns::marble(m, p);
        case Pattern::terrazzo: return patterns::terrazzo(m, p);
        case Pattern::fabric: return patterns::fabric(m, p);
        case Pattern::knit: return patterns::knit(m, p);
        case Pattern::carpet: return patterns::carpet(m, p);
        case Pattern::leather: return patterns::leather(m, p);
        case Pattern::rug: return patterns::rug(m, p);
        case Pattern::stripes: return patterns::stripes(m, p);
        case Pattern::damask: return patterns::damask(m, p);
        case Pattern::floral: return patterns::floral(m, p);
        case Pattern::wicker: return patterns::wicker(m, p);
        case Pattern::metal: return patterns::metal(m, p);
        case Pattern::art: return patterns::art(m, p);
        case Pattern::book: return patterns::book(m, p);
        case Pattern::leaf: return patterns::leaf(m, p);
        case Pattern::grass: return patterns::grass(m, p);
        case Pattern::bark: return patterns::bark(m, p);
        case Pattern::screen: return patterns::screen(m, p);
        case Pattern::dots: return patterns::dots(m, p);
        case Pattern::zigzag: return patterns::zigzag(m, p);
        case Pattern::twill: return patterns::twill(m, p);
        case Pattern::geometric: return patterns::geometric(m, p);
        case Pattern::diamonds: return patterns::diamonds(m, p);
        case Pattern::lattice: return patterns::lattice(m, p);
        case Pattern::stars: return patterns::stars(m, p);
        case Pattern::gingham: return patterns::gingham(m, p);
        case Pattern::plaid: return patterns::plaid(m, p);
        case Pattern::houndstooth: return patterns::houndstooth(m, p);
        case Pattern::patchwork: return patterns::patchwork(m, p);
        case Pattern::leopard: return patterns::leopard(m, p);
        case Pattern::zebra: return patterns::zebra(m, p);
        case Pattern::camouflage: return patterns::camouflage(m, p);
        case Pattern::paisley: return patterns::paisley(m, p);
        case Pattern::encaustic: return patterns::encaustic(m, p);
        case Pattern::laid_tiles: return patterns::laid_tiles(m, p);
        case Pattern::peeling: return patterns::peeling(m, p);
        case Pattern::image: return patterns::image(m, p);
    }
    return {m.color_a, m.roughness, 0.5f};
}

// A footprint larger than anything in a room.
constexpr float kFarAway = 1e6f;

// Height of the surface in metres: the pattern's relief and the creases of soft things.
float relief_m(const Material& m, const TexturePoint& p) {
    float height = 0;
    if (m.bump_m > 0) height += m.bump_m * raw_texture(m, p).height;
    if (m.crease_m > 0) height += m.crease_m * patterns::crease(p.coords, p.footprint_m, m.seed);
    return height;
}

}  // namespace

int dominant_axis(Vec3f n) {
    const float x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
    return z >= x && z >= y ? 2 : y >= x ? 1 : 0;
}

Vec2f flat_coords(Vec3f c, int axis) {
    return axis == 2 ? Vec2f{c.x, c.y} : axis == 1 ? Vec2f{c.x, c.z} : Vec2f{c.z, c.y};
}

TextureValue sample_texture(const Material& material, const TexturePoint& point) {
    TextureValue v = raw_texture(material, point);
    v.albedo = {unit_clamp(v.albedo.x), unit_clamp(v.albedo.y), unit_clamp(v.albedo.z)};
    v.roughness = std::clamp(v.roughness, 0.02f, 1.f);
    return v;
}

Vec2f texture_slope(const Material& material, const TexturePoint& point, int axis) {
    if (!(material.bump_m > 0.f || material.crease_m > 0.f)) return {};
    const float h = std::max(0.5f * point.footprint_m, 0.0004f);
    const auto height = [&](float du, float dv) {
        TexturePoint q = point;
        q.flat = q.flat + Vec2f{du, dv};
        q.coords += axis == 2 ? Vec3f{du, dv, 0} : axis == 1 ? Vec3f{du, 0, dv} : Vec3f{0, dv, du};
        return relief_m(material, q);
    };
    const float here = height(0, 0);
    const Vec2f slope{(height(h, 0) - here) / h, (height(0, h) - here) / h};
    // Limited, since steep flanks of joints would turn the normal below the horizon.
    const float l = length(slope);
    return l > 0.7f ? slope * (0.7f / l) : slope;
}

Vec3f mean_albedo(const Material& material) {
    if (material.pattern == Pattern::image)
        return sample_texture(material, {{}, {}, kFarAway}).albedo;  // the coarsest mip level
    // A footprint of 1 cm already averages fine grain; points spread over four units, incommensurate with any joints,
    // cover the rest.
    Vec3f sum{};
    constexpr int kPlaces = 1024;
    const float span = 4.f * std::max(material.scale_m, 0.15f);  // leather is worn in patches of 20 cm
    // patterns that do not repeat
    const bool whole = material.pattern == Pattern::art || material.pattern == Pattern::book;
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
        const float u = static_cast<float>((i * 3242174889u) >> 8) * 0x1p-24f,
                    v = static_cast<float>((i * 2447445414u) >> 8) * 0x1p-24f;  // Roberts' R2
        TexturePoint p;
        p.flat = whole ? Vec2f{u * material.scale_m, v * material.scale_m}
                 : material.pattern == Pattern::rug
                     ? Vec2f{(2 * u - 1) * material.scale_m, (2 * v - 1) * material.scale_m}
                     : Vec2f{(u - 0.5f) * span, (v - 0.5f) * span};
        p.coords = {p.flat.x, p.flat.y, 0.3f * (u + v) * span};
        if (material.pattern == Pattern::rug)
            p.coords = {p.flat.x, material.scale_m, p.flat.y};  // coords.y is half the depth
        p.footprint_m = 0.01f;
        sum += sample_texture(material, p).albedo;
    }
    return sum / static_cast<float>(kPlaces);
}

}  // namespace fastscene
