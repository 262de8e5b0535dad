#include "fastscene/trace/room_change.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <span>

#include "fastscene/base/hash.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

template <class T>
void add_all(Hash& hash, const std::vector<T>& values) {
    hash.add(std::span<const T>(values));
}

void add_material(Hash& hash, const Material& m) {
    hash.add(static_cast<int>(m.pattern)).add(m.seed).add(static_cast<int>(m.variant)).add(m.burns);
    for (const Vec3f color : {m.color_a, m.color_b, m.color_c, m.emission}) hash.add(color.x).add(color.y).add(color.z);
    for (const float value :
         {m.scale_m, m.bump_m, m.crease_m, m.sheen, m.roughness, m.specular, m.metal, m.transmission, m.mirror})
        hash.add(value);
    for (const auto& picture : {m.image, m.normals, m.metallic_roughness})
        if (picture && !picture->levels.empty())
            hash.add_bytes(picture->levels[0].pixels.data(), picture->levels[0].pixels.size() * sizeof(Rgb8));
}

std::string content_of(const Room& room, const Mesh& mesh) {
    Hash hash;
    add_all(hash, mesh.positions);
    add_all(hash, mesh.normals);
    add_all(hash, mesh.coords);
    add_all(hash, mesh.triangles);
    add_material(hash, room.materials[static_cast<std::size_t>(mesh.material)]);
    return hash.hex();
}

void add_mesh(Room& to, const Room& from, const Mesh& mesh) {
    Mesh copy = mesh;
    copy.material = static_cast<int>(to.materials.size());
    copy.object = -1;
    to.materials.push_back(from.materials[static_cast<std::size_t>(mesh.material)]);
    to.meshes.push_back(std::move(copy));
}

bool is_lamp(const Room& room, const Mesh& mesh) {
    return luminance(room.materials[static_cast<std::size_t>(mesh.material)].emission) > 0;
}

std::string outside_of(const Room& room) {
    const Sky& s = room.sky;
    Hash hash;
    hash.add(static_cast<int>(s.time)).add(static_cast<int>(s.view)).add(s.snow).add(s.seed);
    for (const float value : {s.clouds, s.seen, s.sun_limit, s.ground_least}) hash.add(value);
    for (const Vec3f v : {s.sun_dir, s.sun_irradiance, s.zenith, s.horizon, s.ground, room.min_corner, room.max_corner})
        hash.add(v.x).add(v.y).add(v.z);
    if (s.picture) hash.add_bytes(s.picture->pixels.data(), s.picture->pixels.size() * sizeof(Vec3f));
    for (const Portal& portal : room.portals)
        for (const Vec3f v : {portal.corner, portal.edge_u, portal.edge_v}) hash.add(v.x).add(v.y).add(v.z);
    return hash.hex();
}

}  // namespace

std::string content_of(const Room& room) {
    Hash hash;
    for (const Mesh& mesh : room.meshes) hash.add(content_of(room, mesh)).add(mesh.material);
    return hash.add(outside_of(room)).hex();
}

RoomChange change_between(const Room& before, const Room& now) {
    RoomChange out;
    out.lights = outside_of(before) != outside_of(now);
    std::map<std::string, std::vector<const Mesh*>> only_before;
    for (const Mesh& mesh : before.meshes) only_before[content_of(before, mesh)].push_back(&mesh);
    const auto add = [&](const Room& room, const Mesh& mesh) {
        out.lights |= is_lamp(room, mesh);
        add_mesh(out.surfaces, room, mesh);
    };
    for (const Mesh& mesh : now.meshes) {
        const auto found = only_before.find(content_of(now, mesh));
        if (found == only_before.end() || found->second.empty()) add(now, mesh);
        else found->second.pop_back();
    }
    for (const auto& [content, meshes] : only_before)
        for (const Mesh* mesh : meshes) add(before, *mesh);
    return out;
}

}  // namespace fastscene
