#include "fastscene/panorama/dataset.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/image/encoded_maps.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/dataset_parts.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
using namespace dataset;

constexpr float kDegree = std::numbers::pi_v<float> / 180;

struct DatasetPlan {
    DatasetRequest request;
    fs::path folder;
    std::uint64_t seed;
    bool panorama;

    int rooms() const { return (request.count + request.params.views - 1) / request.params.views; }
    fs::path stem(int picture) const {
        return folder / fmt::format("shard-{:05}", picture / request.params.shard) / fmt::format("{:08}", picture);
    }
    fs::path file(int picture, std::string_view ending) const {
        return fs::path(stem(picture).string() + std::string(ending));
    }
    // The picture's JSON is written last: if it exists, so does everything else.
    bool there(int picture) const { return fs::exists(file(picture, ".json")); }
    std::vector<int> missing(int room) const {
        std::vector<int> out;
        for (int i = room * request.params.views; i < std::min(request.count, (room + 1) * request.params.views); ++i)
            if (!there(i)) out.push_back(i);
        return out;
    }
};

// Settings that two calls on the same folder must share. The number of pictures may grow.
Json description(const DatasetPlan& plan) {
    const DatasetParams& p = plan.request.params;
    return {{"format", "fastscene dataset 1"},
            {"seed", plan.seed},
            {"width", plan.request.width},
            {"height", plan.request.height},
            {"camera", plan.panorama ? "panorama" : "perspective"},
            {"film", p.film},
            {"views", p.views},
            {"over_things", p.over_things},
            {"shard", p.shard},
            {"cell_m", p.trace.cell_m},
            {"cell_samples", p.trace.cell_samples},
            {"pixel_samples", p.trace.pixel_samples},
            {"range_unit_m", 0.001},
            {"classes", nyu40_names()}};
}

void settle_description(const DatasetPlan& plan) {
    const fs::path path = plan.folder / "dataset.json";
    const Json wanted = description(plan);
    if (!fs::exists(path)) write_json(path, wanted);
    const Json found = read_json(path);
    for (const auto& [name, value] : wanted.items())
        if (!found.contains(name) || found[name] != value)
            throw UsageError(
                "{}: expected a dataset with {} = {}, found {}: use the same settings to resume, or another folder",
                path.string(), name, value.dump(), found.contains(name) ? found[name].dump() : "none");
}

// A free position in the room at the height of a person or a tripod, clear of furniture, with floor or (`over_things`)
// furniture below and ceiling above. If there is no such furniture, a position over the floor is used.
Vec3f random_place(const TracedRoom& room, bool over_things, Random& rng) {
    constexpr float kLowestThing = 0.25f;  // anything lower, such as a carpet, counts as floor
    const Vec3f low = room.room().min_corner, high = room.room().max_corner;
    for (int attempt = 0; attempt < 200; ++attempt) {
        const float floor = high.y;  // y is down
        const Vec3f p{rng.uniform(low.x, high.x), floor - rng.uniform(0.7f, std::min(2.f, high.y - low.y - 0.3f)),
                      rng.uniform(low.z, high.z)};
        const bool inside = room.distance(p, {0, 1, 0}) < 4.f && room.distance(p, {0, -1, 0}) < 6.f;
        const bool as_wished = !over_things || attempt >= 150 ||
                               room.distance(p, {0, 1, 0}) < floor - p.y - kLowestThing;
        if (inside && as_wished && room.clearance(p, 0.35f) >= 0.35f) return p;
    }
    return {};  // the room's own camera position is always free
}

struct Camera {
    Rigid world_from_camera;
    Pinhole pinhole;  // for perspective views
};

Camera random_camera(const DatasetPlan& plan, const TracedRoom& room, int view, Random& rng) {
    const bool over_things = rng.chance(static_cast<float>(plan.request.params.over_things));
    const Vec3f place = view == 0 ? Vec3f{} : random_place(room, over_things, rng);
    const float yaw = rng.uniform(0.f, 360.f) * kDegree, fov_deg = rng.uniform(50.f, 100.f);
    const float pitch = plan.panorama ? 0.f : 11.f * kDegree * rng.normal(),
                roll = plan.panorama ? 0.f : 2.f * kDegree * rng.normal();
    const Mat3f rotation = rotation_about(Vec3f{0, 1, 0}, yaw) *
                           rotation_about(Vec3f{1, 0, 0}, std::clamp(pitch, -0.7f, 0.7f)) *
                           rotation_about(Vec3f{0, 0, 1}, roll);
    return {{rotation, place}, Pinhole::with_fov(plan.request.width, plan.request.height, fov_deg)};
}

Random rng_of(const DatasetPlan& plan, int picture) {
    return {plan.seed, "dataset picture", static_cast<std::uint64_t>(picture)};
}

// Camera positions of all pictures of a room, including existing ones, so that the light does not depend on which are
// missing.
std::vector<Vec3f> eyes_in(const DatasetPlan& plan, const TracedRoom& room, int first, int count) {
    std::vector<Vec3f> viewpoints;
    for (int k = 0; k < count; ++k) {
        Random rng = rng_of(plan, first + k);
        viewpoints.push_back(random_camera(plan, room, k, rng).world_from_camera.translation);
    }
    return viewpoints;
}

ImageRgb8 encoded_normals(const ImageColor& normals, const Image<std::int32_t>& object,
                          const Mat3f& camera_from_world) {
    ImageRgb8 out(normals.width, normals.height, encoded_normal({}));
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (object.pixels[i] == -2) continue;
        out.pixels[i] = encoded_normal(camera_from_world * normals.pixels[i]);
    }
    return out;
}

// Walls, floor and ceiling are not objects: they are distinguished by their normals (y is down).
int class_of(const Room& room, std::int32_t object, Vec3f normal) {
    if (object == -2) return 0;
    if (object == -1) return normal.y < -0.7f ? 2 : normal.y > 0.7f ? 22 : 1;
    return nyu40_of(room.objects[static_cast<std::size_t>(object)].kind);
}

Json instances_json(const Room& room, const Image<std::int32_t>& object) {
    std::vector<int> pixels(room.objects.size(), 0);
    for (const std::int32_t i : object.pixels)
        if (i >= 0) ++pixels[static_cast<std::size_t>(i)];
    Json out = Json::array();
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (pixels[i] > 0)
            out.push_back({{"id", i + 1},
                           {"class", nyu40_of(room.objects[i].kind)},
                           {"name", room.objects[i].kind},
                           {"pixels", pixels[i]}});
    return out;
}

void make_picture(const DatasetPlan& plan, const TracedRoom& room, const std::string& prompt, int picture,
                  const Run& run) {
    const DatasetRequest& request = plan.request;
    Random rng = rng_of(plan, picture);
    const Camera camera = random_camera(plan, room, picture % request.params.views, rng);
    const Film film = random_film(rng, !plan.panorama);
    const Run quiet{rng.next_u64(), nullptr, run.stop};
    const ShotParts parts{.color = true, .range = true, .normal = true, .object = true};
    const Shot shot = plan.panorama
                          ? room.panorama(camera.world_from_camera, {request.width, request.height}, parts, quiet)
                          : room.perspective(camera.world_from_camera, camera.pinhole, parts, quiet);

    ImageMask classes(request.width, request.height);
    Image<std::uint16_t> instances(request.width, request.height);
    for (std::size_t i = 0; i < classes.size(); ++i) {
        classes.pixels[i] = static_cast<std::uint8_t>(
            class_of(room.room(), shot.object.pixels[i], shot.normal.pixels[i]));
        instances.pixels[i] = static_cast<std::uint16_t>(std::max(0, shot.object.pixels[i] + 1));
    }
    const bool clean = request.params.film == "clean";
    const std::string color_ending = clean ? ".color.png" : ".color.jpg";
    make_directories(plan.stem(picture).parent_path());
    if (clean) save_png(plan.file(picture, color_ending), srgb8_from_linear(shot.color));
    else save_jpeg(plan.file(picture, color_ending), expose(shot.color, film, plan.panorama, rng), film.jpeg_quality);
    save_png16(plan.file(picture, ".range.png"), millimetres(shot.range));
    save_png(plan.file(picture, ".normal.png"),
             encoded_normals(shot.normal, shot.object, transpose(camera.world_from_camera.rotation)));
    save_png(plan.file(picture, ".class.png"), classes);
    save_png16(plan.file(picture, ".instance.png"), instances);

    const auto name = [&](const std::string& ending) { return plan.file(picture, ending).filename().string(); };
    Json lens = plan.panorama ? Json{{"model", "EQUIRECTANGULAR"}}
                              : Json{{"model", "PINHOLE"},
                                     {"fx", camera.pinhole.fx},
                                     {"fy", camera.pinhole.fy},
                                     {"cx", camera.pinhole.cx},
                                     {"cy", camera.pinhole.cy}};
    const Look& look = room.room().look;
    write_json(plan.file(picture, ".json"),
               {{"picture", picture},
                {"room", picture / request.params.views},
                {"prompt", prompt},
                {"color", name(color_ending)},
                {"range", name(".range.png")},
                {"normal", name(".normal.png")},
                {"class", name(".class.png")},
                {"instance", name(".instance.png")},
                {"camera", lens},
                {"world_from_camera", json_from_pose(camera.world_from_camera, Decimals::exact)},
                {"look",
                 {{"exposure_ev", look.exposure_ev},
                  {"white", {look.white.x, look.white.y, look.white.z}},
                  {"contrast", look.contrast},
                  {"saturation", look.saturation}}},
                {"film", clean ? Json() : to_json(film)},
                {"instances", instances_json(room.room(), shot.object)}});
}

void check_request(const DatasetRequest& request) {
    if (request.count < 1) throw UsageError("--count: expected at least 1 picture, found {}", request.count);
    if (request.width < 16 || request.height < 16 || request.width > 8192 || request.height > 8192)
        throw UsageError("--size: expected 16x16 to 8192x8192, found {}x{}", request.width, request.height);
    if (request.params.camera == "panorama" && request.width != 2 * request.height)
        throw UsageError("--size: expected a width of twice the height for panoramas, found {}x{}", request.width,
                         request.height);
}

// A list with one line per picture, for data loaders. Written by whichever process completes the set.
void write_index(const DatasetPlan& plan) {
    std::string lines;
    for (int i = 0; i < plan.request.count; ++i)
        lines += fs::relative(plan.file(i, ".json"), plan.folder).string() + "\n";
    write_file(plan.folder / "index.txt", lines);
}

}  // namespace

DatasetState make_dataset(const DatasetRequest& request, const fs::path& folder, const Run& run) {
    check_request(request);
    const DatasetPlan plan{request, folder, run.seed,
                           request.params.camera == "panorama" ||
                               (request.params.camera == "auto" && request.width == 2 * request.height)};
    make_directories(folder / "claims");
    settle_description(plan);

    DatasetState state{request.count, 0, 0};
    Progress progress(run, "pictures", request.count);
    for (int r = 0; r < plan.rooms(); ++r) {
        run.check_stop();
        const int all = std::min(request.params.views, request.count - r * request.params.views);
        std::vector<int> missing = plan.missing(r);
        progress.advance(all - static_cast<int>(missing.size()));
        if (missing.empty()) continue;
        const auto claim = Claim::take(folder / "claims", fmt::format("room-{:07}", r), request.params.stale_minutes);
        if (!claim) continue;
        const auto before = missing.size();
        missing = plan.missing(r);  // another process may have just finished it
        progress.advance(static_cast<int>(before - missing.size()));
        if (missing.empty()) continue;
        RandomRoom random = random_room(plan.seed, r);
        TracedRoom room(std::move(random.room));
        room.gather_light(request.params.trace, {plan.seed, nullptr, run.stop},
                          eyes_in(plan, room, r * request.params.views, all));
        for (const int picture : missing) {
            run.check_stop();
            claim->still_alive();
            make_picture(plan, room, random.prompt, picture, run);
            ++state.made;
            progress.advance();
        }
    }
    for (int i = 0; i < request.count; ++i) state.there += plan.there(i) ? 1 : 0;
    if (state.there == request.count) write_index(plan);
    return state;
}

}  // namespace fastscene
