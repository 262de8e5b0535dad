// The finished cache as bytes: what pictures and later gatherings read, in half precision.
#include <algorithm>
#include <cmath>

#include "fastscene/base/bytes.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/light_bytes.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/texture.h"

namespace fastscene {

using namespace irradiance;

namespace {

// Fractions of one, such as the coordinates of unit vectors: 2^-15 apart.
constexpr float kSteps = 32767.f;

void append_steps(std::string& out, float fraction) {
    append(out, static_cast<std::int16_t>(std::lround(std::clamp(fraction, -1.f, 1.f) * kSteps)));
}
float steps_from(ByteReader& in) { return static_cast<float>(in.get<std::int16_t>()) / kSteps; }

void append_unit(std::string& out, Vec3f v) {
    for (std::size_t a = 0; a < 3; ++a) append_steps(out, v[a]);
}
Vec3f unit_from(ByteReader& in) {
    const float x = steps_from(in), y = steps_from(in), z = steps_from(in);
    return {x, y, z};  // normalized again it would not be rounded again to the same
}
void append_point(std::string& out, Vec3f p) {
    for (std::size_t a = 0; a < 3; ++a) append(out, p[a]);
}
Vec3f point_from(ByteReader& in) {
    const float x = in.get<float>(), y = in.get<float>(), z = in.get<float>();
    return {x, y, z};
}

constexpr std::size_t kCellBytes = 66, kPatchBytes = 42, kPlaceBytes = 20;

}  // namespace

void IrradianceCache::know_surfaces(const Room& room) {
    for (const Material& m : room.materials) {
        const Vec3f albedo = mean_albedo(m);
        const float metal = mean_metal(m);
        reflectances_.push_back(is_clear(m) ? Vec3f{} : mean_reflectance(m, albedo, metal));
        coats_.push_back(is_clear(m) || m.mirror > 0.5f ? Coat{} : coat_of(m, albedo, m.roughness, metal));
    }
    for (const Mesh& mesh : room.meshes) closed_.push_back(is_closed(mesh));
}

std::string IrradianceCache::bytes() const {
    float brightest = 0;
    for (const Cell& cell : cells_)
        for (const Vec3f light : {cell.direct, cell.indirect, cell.sun})
            brightest = std::max({brightest, light.x, light.y, light.z});
    const float scale = scale_ > 0 ? scale_ : scale_for_halves(brightest);  // kept: rounding twice is rounding once
    std::string out;
    out.reserve(cells_.size() * kCellBytes + sun_patches_.size() * kPatchBytes + sun_places_.size() * kPlaceBytes + 64);
    append(out, cell_m_);
    append_point(out, origin_);
    append(out, scale);
    append(out, static_cast<std::uint64_t>(cells_.size()));
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const Cell& cell = cells_[c];
        append(out, keys_[c]);
        for (const Vec3f light : {cell.direct, cell.indirect, cell.sun}) append_halves(out, light, scale);
        append_halves(out, cell.directed.gradient(), 1);
        append_halves(out, cell.albedo, 1);
        append_unit(out, cell.normal);
        append_point(out, cell.center);
        append(out, cell.area);
        append_steps(out, cell.transmission);
        append_steps(out, cell.trust);
        append(out, static_cast<std::uint16_t>(cell.seen));
    }
    append(out, static_cast<std::uint64_t>(sun_patches_.size()));
    for (const SunPatch& patch : sun_patches_) {
        append(out, patch.first), append(out, patch.count);
        append_point(out, patch.sun), append_point(out, patch.leaving);
        append(out, patch.area), append(out, patch.useful);
        append(out, static_cast<std::uint16_t>(patch.behind));
    }
    append(out, static_cast<std::uint64_t>(sun_places_.size()));
    for (const SunPlace& place : sun_places_) {
        append_point(out, place.at.position);
        append_unit(out, place.at.normal);
        append(out, static_cast<std::uint16_t>(place.material));
    }
    return out;
}

IrradianceCache IrradianceCache::from_bytes(ByteReader& in, const Room& room) {
    IrradianceCache cache;
    cache.know_surfaces(room);
    cache.cell_m_ = in.get<float>();
    cache.origin_ = point_from(in);
    const auto scale = cache.scale_ = in.get<float>();
    if (!(cache.cell_m_ > 0) || !(scale > 0)) in.refuse("expected the light of a room, found something else");
    const std::size_t cells = in.count(kCellBytes);
    cache.cells_.reserve(cells), cache.keys_.reserve(cells);
    for (std::size_t c = 0; c < cells; ++c) {
        const auto key = in.get<std::uint64_t>();
        Cell cell;
        for (Vec3f* light : {&cell.direct, &cell.indirect, &cell.sun}) *light = halves_from(in, scale);
        cell.directed = {halves_from(in, 1), 1};
        cell.albedo = halves_from(in, 1);
        cell.normal = unit_from(in);
        cell.center = point_from(in);
        cell.area = in.get<float>();
        cell.transmission = steps_from(in);
        cell.trust = steps_from(in);
        cell.seen = in.get<std::uint16_t>() != 0;
        cache.cells_.push_back(cell), cache.keys_.push_back(key);
    }
    const std::size_t patches = in.count(kPatchBytes);
    for (std::size_t i = 0; i < patches; ++i) {
        SunPatch patch{};
        patch.first = in.get<std::uint32_t>(), patch.count = in.get<std::uint32_t>();
        patch.sun = point_from(in), patch.leaving = point_from(in);
        patch.area = in.get<float>(), patch.useful = in.get<float>();
        patch.behind = in.get<std::uint16_t>() != 0;
        cache.sun_patches_.push_back(patch);
    }
    const std::size_t places = in.count(kPlaceBytes);
    for (std::size_t i = 0; i < places; ++i) {
        const Vec3f position = point_from(in), normal = unit_from(in);
        const std::size_t material = in.get<std::uint16_t>();
        if (material >= room.materials.size()) in.refuse("expected the light of this room, found that of another");
        cache.sun_places_.push_back({{position, normal}, material});
    }
    for (const SunPatch& patch : cache.sun_patches_)
        if (patch.count == 0 || patch.first + std::uint64_t{patch.count} > places)
            in.refuse("expected the light of a room, found something else");
    cache.add_sun_powers();
    cache.index();
    return cache;
}

IrradianceCache IrradianceCache::rounded(const Room& room) const {
    const std::string exact = bytes();
    ByteReader in("light", exact);
    return from_bytes(in, room);
}

}  // namespace fastscene
