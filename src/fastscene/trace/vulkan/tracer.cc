#include "fastscene/trace/vulkan/tracer.h"

#include <bit>
#include <cstring>

#include "fastscene/base/random.h"

namespace fastscene::vulkan {
namespace {

constexpr int kPathsASubmission = 4;            // of a pixel
constexpr std::int64_t kPixelsABand = 1 << 22;  // of a picture, whose sums the card holds at once

// Rows of a picture that are worked on at once.
int rows_of_band(int width) { return static_cast<int>(std::max<std::int64_t>(1, kPixelsABand / std::max(1, width))); }

}  // namespace

Camera camera_data(const RayCamera& camera, std::uint64_t seed) {
    const Mat3f& r = camera.world_from_camera.rotation;
    const Vec3f t = camera.world_from_camera.translation;
    Camera out;
    out.row_x = vec4(r.row0, t.x), out.row_y = vec4(r.row1, t.y), out.row_z = vec4(r.row2, t.z);
    out.panorama = camera.panorama ? 1 : 0, out.seed = seed;
    const Pinhole& p = camera.pinhole;
    out.lens = camera.panorama
                   ? Vec4{static_cast<float>(camera.width), static_cast<float>(camera.height), camera.eye_m, 0}
                   : Vec4{p.fx, p.fy, p.cx, p.cy};
    return out;
}

Tracer::Tracer(const std::string& device, const std::string& flag, const Room& room, const Lights& lights)
    : room_(room), device_(gpu::choose_device(device, flag)), commands_(device_), scene_(device_, room, lights) {
    for (const Material& m : room.materials) {
        const auto pattern = static_cast<std::uint32_t>(m.pattern);
        patterns_[pattern / 32] |= 1u << pattern % 32;
    }
    kernels_.shade.prepare(device_, patterns_);  // done while the light is gathered
}

void Tracer::set_look(const Look& look, const Sky& sky) {
    scene_.set_look(look, sky);
    scene_.write();
}

void Tracer::clear(const gpu::Buffer& buffer) {
    commands_.begin();
    commands_.fill(buffer, 0);
    commands_.submit();
    commands_.wait();
}

ImageColor Tracer::path_sums(const RayCamera& camera, const ShotParts& parts, int samples, const Run& run) {
    struct Push {
        std::uint64_t world, camera, pixels, sums;
        std::uint32_t count, first, samples;
        float pixel_angle;
    };
    ImageColor out(camera.width, camera.height);
    const Camera data = camera_data(camera, path_picture_key(run.seed));
    gpu::Buffer lens(device_, sizeof data, gpu::Memory::device, "a camera");
    gpu::upload(device_, lens, 0, &data, sizeof data);
    Progress progress(run, "paths", camera.height);
    const int rows = rows_of_band(camera.width);
    for (int top = 0; top < camera.height; top += rows) {
        const int bottom = std::min(camera.height, top + rows);
        std::vector<std::uint32_t> pixels;
        for (int y = top; y < bottom; ++y)
            for (int x = 0; x < camera.width; ++x)
                if (is_asked_for(parts, x, y))
                    pixels.push_back(static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16);
        const auto count = static_cast<std::int64_t>(pixels.size());
        gpu::Buffer list(device_, count * 4, gpu::Memory::device, "a picture"),
            sums(device_, count * static_cast<std::int64_t>(sizeof(Vec4)), gpu::Memory::device, "a picture");
        gpu::upload(device_, list, 0, pixels.data(), count * 4);
        clear(sums);
        for (int first = 0; first < samples; first += kPathsASubmission) {
            const auto now = static_cast<std::uint32_t>(std::min(kPathsASubmission, samples - first));
            run_in_pieces(kernels_.paths, count, run, [&](std::int64_t at, std::uint32_t items) {
                return Push{scene_.world(),
                            lens.address(),
                            list.address() + static_cast<std::uint64_t>(at) * 4,
                            sums.address() + static_cast<std::uint64_t>(at) * sizeof(Vec4),
                            items,
                            static_cast<std::uint32_t>(first),
                            now,
                            camera.pixel_angle};
            });
        }
        std::vector<Vec4> found(pixels.size());
        gpu::download(device_, sums, 0, found.data(), count * static_cast<std::int64_t>(sizeof(Vec4)));
        for (std::size_t i = 0; i < pixels.size(); ++i)
            out.at(static_cast<int>(pixels[i] & 0xffff), static_cast<int>(pixels[i] >> 16)) = {found[i].x, found[i].y,
                                                                                               found[i].z};
        progress.advance(bottom - top);
    }
    return out;
}

std::vector<RayHit> Tracer::hits(const std::vector<Query>& rays) {
    struct Push {
        std::uint64_t world, rays, hits;
        std::uint32_t count, unused;
    };
    std::vector<Vec4> given;
    for (const Query& q : rays) {
        given.push_back(vec4(q.origin, std::min(q.far_m, 1e30f)));
        given.push_back(vec4(q.direction, std::bit_cast<float>(q.lit ? std::uint32_t{kLit} : 0u)));
    }
    const auto bytes = static_cast<std::int64_t>(given.size() * sizeof(Vec4));
    gpu::Buffer from(device_, bytes, gpu::Memory::device, "rays"), to(device_, bytes, gpu::Memory::device, "hits");
    gpu::upload(device_, from, 0, given.data(), bytes);
    run_in_pieces(kernels_.hits, static_cast<std::int64_t>(rays.size()), {},
                  [&](std::int64_t first, std::uint32_t items) {
                      const std::uint64_t at = 2 * sizeof(Vec4) * static_cast<std::uint64_t>(first);
                      return Push{scene_.world(), from.address() + at, to.address() + at, items, 0};
                  });
    gpu::download(device_, to, 0, given.data(), bytes);
    std::vector<RayHit> out;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec4 a = given[2 * i], b = given[2 * i + 1];
        RayHit hit;
        hit.mesh = std::bit_cast<std::int32_t>(b.y);
        if (hit.mesh >= 0) {
            hit.distance = a.x, hit.u = a.y, hit.v = a.z, hit.back = b.z != 0;
            hit.triangle = std::bit_cast<std::int32_t>(b.x);  // among all of the room
        }
        out.push_back(hit);
    }
    return out;
}

}  // namespace fastscene::vulkan
