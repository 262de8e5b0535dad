#include "fastscene/trace/vulkan/scene.h"

#include <bit>
#include <cmath>

#include "fastscene/trace/film.h"
#include "fastscene/trace/kernel/material_data.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/vulkan/bvh.h"

namespace fastscene::vulkan {
namespace {

float bits(std::uint32_t word) { return std::bit_cast<float>(word); }
float bits(std::int32_t word) { return std::bit_cast<float>(word); }

std::vector<Vec4> padded(const std::vector<Vec3f>& from) {
    std::vector<Vec4> out;
    out.reserve(from.size());
    for (const Vec3f v : from) out.push_back(vec4(v));
    return out;
}

}  // namespace

CardScene::CardScene(gpu::Device& device, const Room& room, const Lights& lights) : device_(device) {
    add_geometry(room, lights);
    add_lights(room, lights);
    add_outside(room, lights.outdoors());
    set_look(room.look, room.sky);
    world_buffer_ = gpu::Buffer(device_, sizeof(World), gpu::Memory::device, "a room's tables");
    write();
}

std::uint64_t CardScene::keep(const void* from, std::int64_t bytes, const char* purpose) {
    buffers_.emplace_back(device_, bytes, gpu::Memory::device, purpose);
    gpu::upload(device_, buffers_.back(), 0, from, bytes);
    return buffers_.back().address();
}

void CardScene::write() { gpu::upload(device_, world_buffer_, 0, &world_, sizeof world_); }

void CardScene::set_cache(CacheTable which, const void* from, std::int64_t bytes) {
    gpu::Buffer& buffer = cache_[which];
    if (buffer.bytes() < bytes || !buffer) {
        buffer = {};
        buffer = gpu::Buffer(device_, bytes, gpu::Memory::device, "the light of a room");
    }
    gpu::upload(device_, buffer, 0, from, bytes);
    const std::array<std::uint64_t*, kCacheTables> addresses{
        &world_.cells, &world_.slots, &world_.coats, &world_.sun_patches, &world_.sun_places, &world_.sun_powers};
    *addresses[which] = buffer.address();
    write();
}

void CardScene::set_look(const Look& look, const Sky& sky) {
    world_.sun = vec4(sky.sun_dir, look.sun_seen);
    world_.sun_light = vec4(sky.sun_irradiance, sky.clouds);
    world_.zenith = vec4(sky.zenith, sky.seen * look.outside_seen);
    world_.horizon = vec4(sky.horizon, sky.time == Sky::Time::night ? 1.f : 0.f);
    world_.ground = vec4(sky.ground, look.exposure_ev);
    world_.look = vec4(look.white, look.saturation);
    world_.curve = {film_slope(look), 0, 0, 0};
    world_.sky_seed = sky.seed;
}

void CardScene::add_geometry(const Room& room, const Lights& lights) {
    {
        const Bvh bvh = build_bvh(room);
        world_.nodes = keep(bvh.nodes, "a room's tree");
        world_.triangles = keep(bvh.triangles, "a room's triangles");
    }
    std::vector<Uvec4> corners, meshes;
    std::vector<Vec4> vertices;
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const Mesh& mesh = room.meshes[m];
        const auto first_triangle = static_cast<std::uint32_t>(corners.size()),
                   first_vertex = static_cast<std::uint32_t>(vertices.size() / 3);
        meshes.push_back(
            {static_cast<std::uint32_t>(mesh.material),
             (lights.is_watertight(m) ? kClosed : 0u) | (lights.is_large(static_cast<int>(m)) ? kLarge : 0u),
             static_cast<std::uint32_t>(lights.first_of_mesh(m)), first_triangle});
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3)
            corners.push_back({first_vertex + mesh.triangles[t], first_vertex + mesh.triangles[t + 1],
                               first_vertex + mesh.triangles[t + 2], static_cast<std::uint32_t>(m)});
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            for (const Vec3f row : {mesh.positions[v], mesh.normals[v], mesh.coords[v]}) vertices.push_back(vec4(row));
    }
    world_.corners = keep(corners, "a room's triangles"), world_.meshes = keep(meshes, "a room's meshes");
    world_.vertices = keep(vertices, "a room's vertices");
    const kernel::TextureWords pictures = kernel::texture_words(room.materials);
    const std::uint64_t address = keep(pictures.words, "a room's pictures");
    std::vector<kernel::MaterialData> materials;
    for (const Material& m : room.materials) materials.push_back(kernel::material_data(m, pictures, address));
    world_.materials = keep(materials, "a room's materials");
}

void CardScene::add_lights(const Room& room, const Lights& lights) {
    std::vector<Vec4> emitters, nodes;
    for (const Lights::Emitter& e : lights.emitters()) {
        if (e.portal >= 0) {
            const Portal& p = room.portals[static_cast<std::size_t>(e.portal)];
            emitters.push_back(vec4(p.corner, bits(0u))),
                emitters.push_back(vec4(p.edge_u, bits(std::uint32_t{kWindow})));
            emitters.push_back(vec4(p.edge_v, length(cross(p.edge_u, p.edge_v))));
            ++world_.windows;
            continue;
        }
        const Mesh& mesh = room.meshes[static_cast<std::size_t>(e.mesh)];
        const auto corner = [&](std::size_t k) {
            return mesh.positions[mesh.triangles[3 * static_cast<std::size_t>(e.triangle) + k]];
        };
        const std::uint32_t flags = (lights.is_watertight(static_cast<std::size_t>(e.mesh)) ? kSolid : 0u) |
                                    (is_flame(room.materials[static_cast<std::size_t>(mesh.material)]) ? kFlame : 0u);
        emitters.push_back(vec4(corner(0), bits(mesh.material))), emitters.push_back(vec4(corner(1), bits(flags)));
        emitters.push_back(vec4(corner(2), 0.5f * length(cross(corner(1) - corner(0), corner(2) - corner(0)))));
    }
    world_.emitter_count = static_cast<std::uint32_t>(lights.emitters().size());
    for (const LightTree::Node& n : lights.tree().nodes()) {
        nodes.push_back(vec4(n.center, n.radius)), nodes.push_back(vec4(n.half, n.power));
        nodes.push_back(vec4(n.axis, n.cosine));
        nodes.push_back({n.sine, bits(n.two_sided ? 1u : 0u), bits(n.emitter), bits(n.second)});
    }
    std::vector<Uvec4> places;
    for (const LightTree::Place& p : lights.tree().places())
        places.push_back({static_cast<std::uint32_t>(p.head), static_cast<std::uint32_t>(p.depth),
                          static_cast<std::uint32_t>(p.path), static_cast<std::uint32_t>(p.path >> 32)});
    world_.heads = static_cast<std::uint32_t>(lights.tree().heads().size());
    world_.emitters = keep(emitters, "a room's lamps"), world_.light_nodes = keep(nodes, "a room's lamps");
    world_.light_heads = keep(lights.tree().heads(), "a room's lamps");
    world_.light_places = keep(places, "a room's lamps");
}

void CardScene::add_outside(const Room& room, const Outdoors& outdoors) {
    const Outdoors::Band& band = outdoors.band();
    world_.has_table = outdoors.table().pixels.empty() ? 0 : outdoors.pictured() ? kPictured : 1;
    world_.outside_table = keep(padded(outdoors.table().pixels), "the view through the windows");
    world_.band = {static_cast<float>(band.width), static_cast<float>(band.height), band.stretch, band.top};
    world_.band_pitch = static_cast<std::uint32_t>(band.pixels.width);
    world_.band_pixels = keep(padded(band.pixels.pixels), "the view through the windows");
    world_.band_columns = keep(band.column, "the view through the windows");
    std::vector<Vec4> dome;
    for (const auto& row : outdoors.dome().course())
        for (const Vec3f c : row) dome.push_back(vec4(c));
    world_.dome = keep(dome, "the sky");
    world_.sunward = vec4(outdoors.dome().sunward());
    static_cast<void>(room);
}

}  // namespace fastscene::vulkan
