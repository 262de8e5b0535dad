#include "fastscene/dataset/dataset.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/dataset/card.h"
#include "fastscene/dataset/checksum.h"
#include "fastscene/dataset/flow.h"
#include "fastscene/dataset/intrinsics.h"
#include "fastscene/dataset/parts.h"
#include "fastscene/dataset/set.h"
#include "fastscene/dataset/statistics.h"
#include "fastscene/export/identities.h"
#include "fastscene/image/color.h"
#include "fastscene/image/encoded_maps.h"
#include "fastscene/io/color_maps.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/scene/pose_json.h"
#include "fastscene/scene/raised_floor.h"

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
    std::vector<std::string> further;  // words of --channels

    int rooms() const { return (request.count + request.params.views - 1) / request.params.views; }
    int room_of(int picture) const { return picture / request.params.views; }
    int first_of(int room) const { return room * request.params.views; }
    int views_of(int room) const { return std::min(request.params.views, request.count - first_of(room)); }
    // The picture that flow leads to: the room's next one, from the last to the first. The same however many pictures
    // the set has by now.
    int next_of(int picture) const {
        const int first = first_of(room_of(picture));
        return first + (picture - first + 1) % request.params.views;
    }
    bool has(std::string_view word) const { return std::find(further.begin(), further.end(), word) != further.end(); }
    bool is_clean() const { return request.params.film == "clean"; }
    fs::path stem(int picture) const { return folder / picture_stem(picture, request.params.shard); }
    fs::path document(int room) const { return folder / room_document_name(room); }
    // The picture's JSON is written last: if it exists, so does everything else.
    bool there(int picture) const { return fs::exists(stem(picture).string() + ".json"); }
    std::vector<int> missing(int room) const {
        std::vector<int> out;
        for (int k = 0; k < views_of(room); ++k)
            if (!there(first_of(room) + k)) out.push_back(first_of(room) + k);
        return out;
    }
};

// Settings that two calls on the same folder must share. The number of pictures may grow.
Json description(const DatasetPlan& plan) {
    DatasetParams params = plan.request.params;
    params.channels = fmt::format("{}", fmt::join(plan.further, ","));
    Json settings = fields_json(params);
    // These change how the work is done, not the pictures.
    settings.erase("stale-minutes");
    settings.erase("trace-device");
    Json out{{"format", kSetFormat},
             {"program", program_version()},
             {"seed", plan.seed},
             {"count", plan.request.count},
             {"width", plan.request.width},
             {"height", plan.request.height},
             {"camera", plan.panorama ? "panorama" : "perspective"},
             {"range_unit_m", 0.001}};
    if (plan.has("flow")) out["flow_unit_px"] = flow_unit_px(plan.request.width, plan.request.height, plan.panorama);
    out["settings"] = settings;
    out["classes"] = nyu40_labels();
    return out;
}

void settle_description(const DatasetPlan& plan) {
    const fs::path path = plan.folder / "dataset.json";
    Json wanted = description(plan);
    if (!fs::exists(path)) write_json(path, wanted);
    const Json found = read_set_settings(plan.folder);
    const auto compare = [&](const std::string& name, const Json& value, const Json& other) {
        if (other != value)
            throw UsageError(
                "{}: expected a dataset with {} = {}, found {}: use the same settings to resume, or another folder",
                path.string(), name, value.dump(), other.is_null() ? "none" : other.dump());
    };
    for (const auto& [name, value] : wanted.items())
        if (name != "count" && name != "settings") compare(name, value, found.value(name, Json()));
    const Json settings = found.value("settings", Json::object());
    for (const auto& [name, value] : wanted["settings"].items()) compare(name, value, settings.value(name, Json()));
    if (found.value("count", 0) >= plan.request.count) return;
    if (found.contains("license")) wanted["license"] = found["license"];
    write_json(path, wanted);
}

// A free position in the room at the height of a person or a tripod, clear of furniture, with floor or (`over_things`)
// furniture below and ceiling above. If there is no such furniture, a position over the floor is used.
Vec3f random_place(const TracedRoom& room, bool over_things, Random& rng) {
    constexpr float kLowestThing = 0.25f;  // anything lower, such as a carpet, counts as floor
    const Vec3f low = room.room().min_corner, high = room.room().max_corner;
    for (int attempt = 0; attempt < 200; ++attempt) {
        const float x = rng.uniform(low.x, high.x), above = rng.uniform(0.7f, std::min(2.f, high.y - low.y - 0.3f)),
                    z = rng.uniform(low.z, high.z), floor = floor_at(room.room(), {x, z});  // y is down
        const Vec3f p{x, floor - above, z};
        const bool inside = room.distance(p, {0, 1, 0}) < 4.f && room.distance(p, {0, -1, 0}) < 6.f;
        const bool as_wished = !over_things || attempt >= 150 ||
                               room.distance(p, {0, 1, 0}) < floor - p.y - kLowestThing;
        if (inside && as_wished && room.clearance(p, 0.35f) >= 0.35f) return p;
    }
    return {};  // the room's own camera position is always free
}

Camera random_camera(const DatasetPlan& plan, const TracedRoom& room, int view, Random& rng) {
    const bool over_things = rng.chance(static_cast<float>(plan.request.params.over_things));
    const Vec3f place = view == 0 ? Vec3f{} : random_place(room, over_things, rng);
    const float yaw = rng.uniform(0.f, 360.f) * kDegree, fov_deg = rng.uniform(50.f, 100.f);
    const float pitch = plan.panorama ? 0.f : 11.f * kDegree * rng.normal(),
                roll = plan.panorama ? 0.f : 2.f * kDegree * rng.normal();
    const Mat3f rotation = rotation_about(Vec3f{0, 1, 0}, yaw) *
                           rotation_about(Vec3f{1, 0, 0}, std::clamp(pitch, -0.7f, 0.7f)) *
                           rotation_about(Vec3f{0, 0, 1}, roll);
    return {{rotation, place}, Pinhole::with_fov(plan.request.width, plan.request.height, fov_deg), plan.panorama};
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
    return nyu40_label(room.objects[static_cast<std::size_t>(object)].kind);
}

Json visible_things_json(const Room& room, const Image<std::int32_t>& object) {
    std::vector<int> pixels(room.objects.size(), 0);
    for (const std::int32_t i : object.pixels)
        if (i >= 0) ++pixels[static_cast<std::size_t>(i)];
    const std::vector<std::string> ids = object_ids(room);
    Json out = Json::array();
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (pixels[i] > 0)
            out.push_back({{"id", i + 1},
                           {"class", nyu40_label(room.objects[i].kind)},
                           {"name", room.objects[i].kind},
                           {"thing", ids[i]},
                           {"pixels", pixels[i]}});
    return out;
}

// Writes the files of a picture, and keeps what verify compares them to.
class PictureFiles {
  public:
    PictureFiles(const DatasetPlan& plan, int picture) : plan_(plan), picture_(picture) {
        make_directories(plan.stem(picture).parent_path());
    }
    // write(path): writes the file of this channel.
    void add(std::string_view name, const std::function<void(const fs::path&)>& write) {
        const auto channel = std::find_if(kChannels.begin(), kChannels.end(),
                                          [&](const Channel& c) { return c.name == name; });
        FASTSCENE_CHECK(channel != kChannels.end());
        const fs::path path = plan_.stem(picture_).string() + ending_of(*channel, plan_.is_clean());
        write(path);
        keep(std::string(name), path);
    }
    void keep(const std::string& name, const fs::path& path) {
        names_[name] = path.lexically_relative(plan_.stem(picture_).parent_path()).string();
        sums_[name] = to_json(checksum_of(path));
    }
    const Json& names() const { return names_; }
    const Json& sums() const { return sums_; }

  private:
    const DatasetPlan& plan_;
    int picture_;
    Json names_ = Json::object(), sums_ = Json::object();
};

// What a camera sees, before it is written.
struct PictureMaps {
    Shot shot;
    ImageMask classes;
    Image<std::uint16_t> instances;
};

Shot take(const DatasetPlan& plan, const TracedRoom& room, const Camera& camera, const ShotParts& parts,
          const Run& run) {
    return plan.panorama ? room.panorama(camera.world_from_camera, camera.size(), parts, run)
                         : room.perspective(camera.world_from_camera, camera.pinhole, parts, run);
}

PictureMaps maps_of(const DatasetPlan& plan, const TracedRoom& room, const Camera& camera, const Run& run) {
    PictureMaps maps{take(plan, room, camera, {.color = true, .range = true, .normal = true, .object = true}, run),
                     ImageMask(plan.request.width, plan.request.height),
                     Image<std::uint16_t>(plan.request.width, plan.request.height)};
    for (std::size_t i = 0; i < maps.classes.size(); ++i) {
        const std::int32_t object = maps.shot.object.pixels[i];
        maps.classes.pixels[i] = static_cast<std::uint8_t>(class_of(room.room(), object, maps.shot.normal.pixels[i]));
        maps.instances.pixels[i] = static_cast<std::uint16_t>(std::max(0, object + 1));
    }
    return maps;
}

// With the picture's own rays, so that both have the same noise.
Intrinsics intrinsics_seen(const DatasetPlan& plan, const TracedRoom& traced, const Camera& camera, const Run& run) {
    const Shot light = take(plan, traced, camera,
                            {.color = true, .range = false, .albedo = true, .mesh = true, .radiance = true}, run);
    const Room& room = traced.room();
    ImageMask has_albedo(light.mesh.width, light.mesh.height);
    for (std::size_t i = 0; i < has_albedo.size(); ++i) {
        const std::int32_t mesh = light.mesh.pixels[i];
        if (mesh < 0) continue;
        const Material& m =
            room.materials[static_cast<std::size_t>(room.meshes[static_cast<std::size_t>(mesh)].material)];
        has_albedo.pixels[i] = m.mirror > 0.5f || luminance(m.emission) > 0 ? 0 : 1;
    }
    return intrinsics_of(light.color, light.albedo, has_albedo, room.look);
}

// Whether a range map taken at `eye` shows the point: glass hides what is behind it, as in range maps.
bool is_first_surface(const TracedRoom& room, Vec3f eye, Vec3f point) {
    constexpr float kSurface_m = 4e-3f;  // tolerance for rounding
    const Vec3f way = point - eye;
    const float far = length(way);
    return far <= kSurface_m || room.distance(eye, way / far) > far - kSurface_m;
}

void make_picture(const DatasetPlan& plan, const TracedRoom& room, const RandomRoom& random, int picture,
                  const Run& run) {
    const DatasetRequest& request = plan.request;
    Random rng = rng_of(plan, picture);
    const Camera camera = random_camera(plan, room, picture % request.params.views, rng);
    const Film film = random_film(rng, !plan.panorama);
    const Run quiet{rng.next_u64(), nullptr, run.stop};
    const PictureMaps maps = maps_of(plan, room, camera, quiet);
    const Shot& shot = maps.shot;

    PictureFiles files(plan, picture);
    files.add("color", [&](const fs::path& path) {
        if (plan.is_clean()) save_png(path, srgb8_from_linear(shot.color));
        else save_jpeg(path, expose(shot.color, film, plan.panorama, rng), film.jpeg_quality);
    });
    files.add("range", [&](const fs::path& path) { save_png16(path, millimetres(shot.range)); });
    files.add("normal", [&](const fs::path& path) {
        save_png(path, encoded_normals(shot.normal, shot.object, transpose(camera.world_from_camera.rotation)));
    });
    files.add("class", [&](const fs::path& path) { save_png(path, maps.classes); });
    files.add("instance", [&](const fs::path& path) { save_png16(path, maps.instances); });
    if (plan.has("intrinsics")) {
        const Intrinsics parts = intrinsics_seen(plan, room, camera, quiet);
        files.add("albedo", [&](const fs::path& path) { save_png(path, parts.albedo); });
        files.add("shading", [&](const fs::path& path) { save_exr_light(path, parts.shading); });
    }
    if (plan.has("flow")) {
        const int next = plan.next_of(picture);
        Random other = rng_of(plan, next);
        const Camera to = random_camera(plan, room, next % request.params.views, other);
        const FlowMap flow = flow_between(camera, to, shot.range, [&](Vec3f point) {
            return is_first_surface(room, to.world_from_camera.translation, point);
        });
        files.add("flow", [&](const fs::path& path) {
            save_png16(path, encoded_flow(flow, flow_unit_px(request.width, request.height, plan.panorama)));
        });
    }
    files.keep("room_document", plan.document(plan.room_of(picture)));

    const Look& look = room.room().look;
    Json about{{"picture", picture},
               {"room", plan.room_of(picture)},
               {"room_type", room.room().type},
               {"style", room.room().style},
               {"prompt", random.prompt}};
    about.update(files.names());
    if (plan.has("flow")) about["flow_to"] = plan.next_of(picture);
    about.update(Json{{"camera", lens_json(camera)},
                      {"world_from_camera", json_from_pose(camera.world_from_camera, Decimals::exact)},
                      {"look",
                       {{"exposure_ev", look.exposure_ev},
                        {"white", {look.white.x, look.white.y, look.white.z}},
                        {"contrast", look.contrast},
                        {"saturation", look.saturation}}},
                      {"film", plan.is_clean() ? Json() : to_json(film)},
                      {"instances", visible_things_json(room.room(), shot.object)},
                      {"class_pixels", class_pixels_json(maps.classes)},
                      {"range_pixels", range_pixels_json(shot.range)},
                      {"files", files.sums()}});
    seal(about);
    write_json(plan.stem(picture).string() + ".json", about);
}

void check_request(const DatasetRequest& request) {
    if (request.count < 1) throw UsageError("--count: expected at least 1 picture, found {}", request.count);
    if (request.width < 16 || request.height < 16 || request.width > 8192 || request.height > 8192)
        throw UsageError("--size: expected 16x16 to 8192x8192, found {}x{}", request.width, request.height);
    if (request.params.camera == "panorama" && request.width != 2 * request.height)
        throw UsageError("--size: expected a width of twice the height for panoramas, found {}x{}", request.width,
                         request.height);
}

// The set is complete: a list with one line per picture, for data loaders, and the card. Both were perhaps written for
// fewer pictures, or by another process.
void complete(const DatasetPlan& plan, bool has_changed) {
    const fs::path index = plan.folder / "index.txt", card = plan.folder / "README.md";
    const std::string lines = index_text(plan.request.count, plan.request.params.shard);
    if (!has_changed && fs::exists(card) && fs::exists(index) && read_file(index) == lines) return;
    write_card(plan.folder);
    write_file(index, lines);
}

// The room's light does not depend on which of its pictures are missing.
TracedRoom lit_room(const DatasetPlan& plan, Room room, int number, const Run& run) {
    TracedRoom traced(std::move(room));
    traced.gather_light(plan.request.params.trace, {plan.seed, nullptr, run.stop},
                        eyes_in(plan, traced, plan.first_of(number), plan.request.params.views));
    return traced;
}

}  // namespace

DatasetState make_dataset(const DatasetRequest& request, const fs::path& folder, const Run& run) {
    check_request(request);
    const DatasetPlan plan{
        request, folder, run.seed,
        request.params.camera == "panorama" || (request.params.camera == "auto" && request.width == 2 * request.height),
        asked_channels(request.params.channels)};
    make_directories(folder / "claims");
    settle_description(plan);

    DatasetState state{request.count, 0, 0};
    Progress progress(run, "pictures", request.count);
    for (int r = 0; r < plan.rooms(); ++r) {
        run.check_stop();
        std::vector<int> missing = plan.missing(r);
        progress.advance(plan.views_of(r) - static_cast<int>(missing.size()));
        if (missing.empty() && fs::exists(plan.document(r))) continue;
        const auto claim = Claim::take(folder / "claims", fmt::format("room-{:07}", r), request.params.stale_minutes);
        if (!claim) continue;
        const auto before = missing.size();
        missing = plan.missing(r);  // another process may have just finished it
        progress.advance(static_cast<int>(before - missing.size()));
        if (missing.empty() && fs::exists(plan.document(r))) continue;
        RandomRoom random = random_room(plan.seed, r);
        make_directories(plan.document(r).parent_path());
        write_json(plan.document(r), random.document);
        if (missing.empty()) continue;
        const TracedRoom room = lit_room(plan, std::move(random.room), r, run);
        for (const int picture : missing) {
            run.check_stop();
            claim->still_alive();
            make_picture(plan, room, random, picture, run);
            ++state.made;
            progress.advance();
        }
    }
    for (int i = 0; i < request.count; ++i) state.there += plan.there(i) ? 1 : 0;
    if (state.there == request.count) complete(plan, state.made > 0);
    return state;
}

}  // namespace fastscene
