// Writes a small colored room in every format that other programs read, and furnished rooms for engines:
// make_reader_samples DIR [VIEWER_DIR]. The colored room: red wall left (-x), green right (+x), blue ahead (+z), white
// ceiling (-y), brown floor (+y).
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>

#include <fmt/format.h>

#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/export/collision.h"
#include "fastscene/export/meshopt.h"
#include "fastscene/export/room_glb.h"
#include "fastscene/export/room_usda.h"
#include "fastscene/export/view_maps.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/view_io.h"
#include "fastscene/io/viewer.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/trace/surface.h"

using namespace fastscene;

namespace {

constexpr float kHalfWidth = 3, kHalfHeight = 1.4f, kHalfDepth = 4;

// One wall: center + s u + t v for s, t in [-1, 1], filled with flat splats (thin along `thin_axis`).
void add_wall(Splats& splats, std::vector<SurfacePoint>& points, Vec3f center, Vec3f u, Vec3f v, std::size_t thin_axis,
              Rgb8 color) {
    constexpr int kSide = 60;
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
            const float s = (static_cast<float>(i) + 0.5f) / kSide * 2 - 1,
                        t = (static_cast<float>(j) + 0.5f) / kSide * 2 - 1;
            const Vec3f p = center + u * s + v * t;
            Vec3f log_scale{-2.6f, -2.6f, -2.6f};  // 7 cm: covers the 13 cm between neighbours
            log_scale[thin_axis] = -5;
            splats.mean_m.push_back(p);
            splats.log_scale.push_back(log_scale);
            splats.rotation.push_back({1, 0, 0, 0});
            splats.opacity_logit.push_back(4);
            const Vec3f c{static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
            splats.sh0.push_back((c * (1 / 255.f) - Vec3f{0.5f, 0.5f, 0.5f}) * (1 / kSh0));
            points.push_back({p, {}, color, 0.07f});
        }
}

// Splats without any symmetry, with all SH degrees.
Splats odd_splats() {
    Random random(7, "odd");
    Splats s;
    s.sh_degree = 3;
    s.resize(300);
    for (std::size_t i = 0; i < s.size(); ++i) {
        s.mean_m[i] = {random.uniform(-1, 3), random.uniform(-2, 1), random.uniform(0, 5)};
        s.log_scale[i] = {random.uniform(-5, -4), random.uniform(-4, -3), random.uniform(-3, -2)};
        s.rotation[i] = {random.normal(), random.normal(), random.normal(), random.normal()};
        s.opacity_logit[i] = random.uniform(-3, 3);
        s.sh0[i] = {random.uniform(-1.5f, 1.5f), random.uniform(-1.5f, 1.5f), random.uniform(-1.5f, 1.5f)};
    }
    for (float& f : s.sh_rest) f = random.uniform(-0.5f, 0.5f);
    return s;
}

// A floor within the room: 4 x 5 m with an island of 2 x 1 m, a slanted wall stepped on a 0.1 m grid, and a doorway 0.3
// m wide to a second part. viewer_walk_check.mjs uses the same numbers.
WalkableArea two_rooms() {
    std::vector<Vec2f> outline{{-2, -3}, {2, -3}, {2, 2}, {1.8f, 2}, {1.8f, 2.2f}, {2, 2.2f}, {2, 3.5f}};
    for (const Vec2f p : {Vec2f{-2, 3.5f}, Vec2f{-2, 2.2f}, Vec2f{1.5f, 2.2f}, Vec2f{1.5f, 2}}) outline.push_back(p);
    // From (-1, 2) to (-2, 0), half as wide as it is long.
    for (int k = 0; k < 10; ++k) {
        outline.push_back({-1 - 0.1f * static_cast<float>(k), 2 - 0.2f * static_cast<float>(k)});
        outline.push_back({-1 - 0.1f * static_cast<float>(k), 1.8f - 0.2f * static_cast<float>(k)});
    }
    outline.push_back({-2, 0});
    return {{outline, {{-1, 0}, {1, 0}, {1, 1}, {-1, 1}}}, -0.4f, 0.6f, kHalfHeight};
}

constexpr BakeParams kSmall{.texels_per_metre = 32, .texture_size = 256};

// The color of what each pixel's center shows, without light; as wide as a texel, so that it is as blurred.
ImageRgb8 colors_of(const Room& room, const Pinhole& camera) {
    const SceneBvh bvh(room);
    const float texel_m = 1.f / static_cast<float>(kSmall.texels_per_metre);
    ImageColor color(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Vec2f center{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            const Vec3f ray = normalize(camera.direction_at(center));
            if (const RayHit hit = bvh.first_hit({}, ray))
                color.at(x, y) = surface_at(room, hit, {}, ray, texel_m, false).texture.albedo;
        }
    return srgb8_from_linear(color);
}

// What the camera of room.glb sees: the numbers of things, their ids beside, and the colors.
void write_views(const std::filesystem::path& stem, const Room& room) {
    const TracedRoom traced(room);
    constexpr int kWidth = 640, kHeight = 480;
    const float across_deg = 2 * std::atan(std::tan(kCameraFov_deg * kPi / 360) * kWidth / kHeight) * 180 / kPi;
    const Pinhole camera = Pinhole::with_fov(kWidth, kHeight, across_deg);
    const auto seen = view_maps(traced, camera, {}, {}).instance;
    ImageMask gray(kWidth, kHeight);
    std::copy(seen.pixels.begin(), seen.pixels.end(), gray.pixels.begin());
    save_png(stem.string() + ".instances.png", gray);
    write_json(stem.string() + ".instances.json", instances_json(instances_of(room)));
    save_png(stem.string() + ".colors.png", colors_of(room, camera));
}

// Furnished rooms for engines: day and night, glass, mirrors, screens, lamps.
void write_rooms(const std::filesystem::path& dir) {
    for (const auto& [name, prompt] :
         {std::pair{"bedroom", "a cozy bedroom with a red armchair and a large window"},
          std::pair{"bathroom", "a marble bathroom at night with a mirror, a shower and candles"},
          std::pair{"attic", "an attic study in the evening with a computer, a neon sign and fairy lights"}}) {
        const Run run{5, nullptr, {}};
        PromptSpec spec = understand_prompt(prompt, false);
        const Room room = make_room(spec, run);
        const std::string glb = room_glb_bytes(room, kSmall, run);
        write_file(dir / fmt::format("{}.room.glb", name), glb);
        write_file(dir / fmt::format("{}.meshopt.glb", name), with_meshopt(glb));
        write_file(dir / fmt::format("{}.collision.glb", name), collision_glb_bytes(room, room.max_corner.y));
        const std::string textures = fmt::format("{}_textures", name);
        const UsdaRoom usda = room_usda(room, textures, kSmall, run);
        make_directories(dir / textures);
        for (const NamedBytes& texture : usda.textures) write_file(dir / textures / texture.name, texture.bytes);
        write_file(dir / fmt::format("{}.room.usda", name), usda.text);
        write_views(dir / name, room);
    }
}

void write_samples(const std::filesystem::path& dir, const std::filesystem::path& viewer_dir) {
    Splats splats;
    ViewSet set;
    const Vec3f x{kHalfWidth, 0, 0}, y{0, kHalfHeight, 0}, z{0, 0, kHalfDepth};
    add_wall(splats, set.points, x * -1.f, y, z, 0, {200, 30, 30});
    add_wall(splats, set.points, x, y, z, 0, {30, 160, 40});
    add_wall(splats, set.points, z, x, y, 2, {40, 60, 210});
    add_wall(splats, set.points, y * -1.f, x, z, 1, {240, 240, 240});
    add_wall(splats, set.points, y, x, z, 1, {120, 75, 40});
    for (int k = 0; k < 3; ++k) {
        View view;
        view.name = fmt::format("{:04}.png", k);
        view.camera = Pinhole::with_fov(32, 24, k == 2 ? 60.f : 90.f);
        view.world_from_camera.translation = {0.1f * static_cast<float>(k), 0, 0.2f};
        view.color = ImageRgb8(32, 24, {static_cast<std::uint8_t>(40 * k), 90, 120});
        set.views.push_back(view);
    }
    make_directories(dir);
    save_splat_ply(dir / "room.ply", splats);
    save_compressed_ply(dir / "room.compressed.ply", splats);
    save_views(dir / "views", set);
    const Splats odd = odd_splats();
    save_splat_ply(dir / "odd.ply", odd);
    save_compressed_ply(dir / "odd.compressed.ply", odd);
    for (const int version : {2, 3, 4})
        save_splats(dir / fmt::format("odd{}.spz", version), odd, {PlyBands::all, version});
    save_splats(dir / "odd.glb", odd);
    save_splats(dir / "odd.usda", odd);
    write_rooms(dir);
    if (viewer_dir.empty()) return;
    ViewerScene scene{"Colored room", {0, 0, -1}, {0, 0, 4}, 75, {}};
    save_viewer_html(dir / "viewer.html", splats, scene, viewer_dir);
    scene.walkable = two_rooms();
    save_viewer_html(dir / "walk.html", splats, scene, viewer_dir);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fputs("usage: make_reader_samples DIR [VIEWER_DIR]\n", stderr), 2;
    try {
        write_samples(argv[1], argc > 2 ? argv[2] : "");
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}
