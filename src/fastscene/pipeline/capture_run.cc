#include "fastscene/pipeline/capture_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/memory.h"
#include "fastscene/base/parallel.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/fit_report.h"
#include "fastscene/pipeline/health.h"
#include "fastscene/pipeline/best_view.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/claim.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/pipeline/source_json.h"
#include "fastscene/pipeline/stage_cache.h"
#include "fastscene/pipeline/stage_splat.h"
#include "fastscene/pipeline/training_picture.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

Capture load_capture(const CaptureRequest& request) {
    const CaptureSource& source = request.source;
    return capture_kind(source.kind)
        .load(source.source, {source.images, source.masks, request.photos.downscale, source.points});
}

// Masks that match no picture are a mistake that would otherwise show only in the result.
void check_masks(const CaptureRequest& request, const Capture& capture, const Run& run) {
    const std::string folder = request.source.masks.string();
    if (folder.empty()) return;
    if (!fs::is_directory(folder)) throw Error("--masks {}: expected a folder, found none", folder);
    const auto without = std::count_if(capture.photos.begin(), capture.photos.end(),
                                       [](const Photo& p) { return p.mask.empty(); });
    if (without == 0) return;
    const std::string name = std::find_if(capture.photos.begin(), capture.photos.end(), [](const Photo& p) {
                                 return p.mask.empty();
                             })->name;
    if (static_cast<std::size_t>(without) == capture.photos.size())
        throw Error("--masks {}: expected masks named like the pictures, such as {}.png, found none", folder, name);
    run.warn(fmt::format("--masks {}: {} of {} pictures have no mask and count fully, {} first", folder, without,
                         capture.photos.size(), name));
}

// Hash of the model's numbers and of each picture's name, size and time, without reading the pictures.
std::string identity_of(const Capture& capture) {
    Hash hash;
    hash.add("capture");
    for (const Photo& p : capture.photos) {
        hash.add(p.name);
        for (const fs::path& file : {p.file, p.mask}) {
            std::error_code code;
            const auto size = fs::file_size(file, code);
            hash.add(code ? std::uint64_t{0} : static_cast<std::uint64_t>(size));
            const auto time = fs::last_write_time(file, code);
            hash.add(code ? std::int64_t{0} : static_cast<std::int64_t>(time.time_since_epoch().count()));
        }
        const Lens& l = p.lens;
        hash.add(static_cast<int>(l.kind));
        for (const double v : {double(l.width), double(l.height), l.fx, l.fy, l.cx, l.cy, l.p1, l.p2}) hash.add(v);
        for (const double v : l.k) hash.add(v);
        for (const double v : l.s) hash.add(v);
        const Mat3d& r = p.world_from_camera.rotation;
        for (const Vec3d& v : {r.row0, r.row1, r.row2, p.world_from_camera.translation})
            hash.add(v.x).add(v.y).add(v.z);
    }
    for (const CapturePoint& p : capture.points)
        hash.add(p.position.x).add(p.position.y).add(p.position.z).add(p.color.r).add(p.color.g).add(p.color.b);
    return hash.hex();
}

Json run_json_of(const CaptureRequest& request, const std::string& identity, std::uint64_t seed) {
    Json json = json_of_source(request.source);
    json["capture"]["photos"] = fields_json(request.photos);
    json["identity"] = identity;
    json["seed"] = seed;
    json["quality"] = request.quality;
    json["params"] = {{"splat", fields_json(request.splat)}};
    json["versions"] = build_json();
    return json;
}

void claim(const RunFolder& folder, const Json& wanted, bool start_over) {
    const auto called = [](const Json& run) {
        return run.contains("capture") ? run.at("capture").value("source", "") : "\"" + run.value("prompt", "") + "\"";
    };
    const auto clash = [&](const Json& recorded) {
        return called(recorded) == called(wanted) ? std::nullopt : std::optional(called(recorded));
    };
    claim_folder(folder, wanted, start_over, clash, called(wanted));
}

// The smallest rotation from `up` to the world's up (-y).
Mat3d upright_from(Vec3f up) {
    const Vec3d from{up.x, up.y, up.z}, to{0, -1, 0};
    const Vec3d axis = cross(from, to);
    const double s = length(axis), c = dot(from, to);
    if (s < 1e-6) return c > 0 ? Mat3d{} : Mat3d{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    return rotation_about(axis * (1 / s), std::atan2(s, c));
}

Json json_of(const Rigid& pose) {
    const Vec3f forward = pose.rotation.column(2), p = pose.translation;
    return {{"position_m", {p.x, p.y, p.z}}, {"forward", {forward.x, forward.y, forward.z}}};
}

// What the first view shows, for pictures during training.
PictureCamera first_camera(const View& first) {
    if (first.model == CameraModel::equirectangular)
        return {Pinhole::with_fov(kTrainingWidth, kTrainingHeight, kPreviewFovDeg), first.world_from_camera};
    Pinhole camera = first.camera;
    const float scale = kTrainingWidth / static_cast<float>(std::max(camera.width, kTrainingWidth));
    camera.width = static_cast<int>(scale * static_cast<float>(camera.width));
    camera.height = std::max(1, static_cast<int>(scale * static_cast<float>(camera.height)));
    camera.fx *= scale, camera.fy *= scale, camera.cx *= scale, camera.cy *= scale;
    return {camera, first.world_from_camera};
}

// Checks memory from the pictures' sizes and the number of Gaussians, before hours of loading and training.
void check_memory(const CaptureRequest& request, const Capture& capture) {
    const std::int64_t have = available_memory();
    if (have <= 0) return;
    const std::size_t points = capture.points.empty() ? static_cast<std::size_t>(request.photos.random_points)
                                                      : capture.points.size();
    const std::int64_t splats = splat_memory(request.splat, points);
    const auto wanted = [&](const PhotosMemory& photos) {
        return photos.views + std::max(photos.reading, splats + (request.splat.coarse > 0 ? photos.views / 4 : 0));
    };
    if (wanted(memory_of_photos(capture, request.photos, false)) <= have) return;
    const PhotosMemory photos = memory_of_photos(capture, request.photos, true);
    if (wanted(photos) <= have) return;
    constexpr double kGiB = 1 << 30;
    throw Error(
        "{}: its pictures take {:.1f} GiB, plus {:.1f} GiB while loading, and {} Gaussians {:.1f} GiB during training; "
        "found {:.1f} GiB free: use smaller pictures (--max-size, --downscale) or fewer Gaussians (--splat-count)",
        capture.source, static_cast<double>(photos.views) / kGiB, static_cast<double>(photos.reading) / kGiB,
        request.splat.count, static_cast<double>(splats) / kGiB, static_cast<double>(have) / kGiB);
}

// Writes all files of the stage. viewer.json: the visitor's initial pose, in the frame of viewer.compressed.ply.
void make_capture_splat(const CaptureRequest& request, const Capture& capture, const RunFolder& folder,
                        const fs::path& out, const Run& run) {
    check_memory(request, capture);
    const PhotoViews photos = views_of_capture(capture, request.photos, run);
    run.note(fmt::format("{} views of {} photographs, {} initial points", photos.set.views.size(),
                         capture.photos.size(), photos.set.points.size()));
    FittedSplats fitted = fit_and_keep_place(photos.set, request.splat, folder, run,
                                             pictures_of_training(folder, first_camera(photos.set.views.front()), run));
    Splats own = fitted.splats;
    transform(own, inverse(photos.world_from_capture));
    std::swap(own, fitted.splats);
    save_fit(fitted, out, capture.offset);
    save_cameras_json(out / "cameras.json", capture.photos);

    const Mat3d upright = upright_from(photos.up);
    transform(own, {upright, 1, {}});
    save_compressed_ply(out / "viewer.compressed.ply", own);
    const View& first = photos.set.views.front();
    const Mat3f turn{{float(upright.row0.x), float(upright.row0.y), float(upright.row0.z)},
                     {float(upright.row1.x), float(upright.row1.y), float(upright.row1.z)},
                     {float(upright.row2.x), float(upright.row2.y), float(upright.row2.z)}};
    Json viewer = json_of({turn * first.world_from_camera.rotation, turn * first.world_from_camera.translation});
    const bool sphere = first.model == CameraModel::equirectangular;
    viewer["fov_deg"] = sphere
                            ? 75.f
                            : std::clamp(2 * std::atan(static_cast<float>(first.camera.width) / (2 * first.camera.fx)) *
                                             57.29578f,
                                         50.f, 90.f);
    write_json(out / "viewer.json", viewer);
    forget_place(folder);
}

std::string name_of(const fs::path& source) {
    return (source.filename().empty() ? source.parent_path() : source).filename().string();
}

}  // namespace

Json train_capture(const CaptureRequest& request, const RunFolder& folder, const Run& run) {
    check_splat_params(request.splat);
    check_fields("", request.photos);
    const Capture capture = load_capture(request);
    check_masks(request, capture, run);
    const std::string identity = identity_of(capture);
    make_directories(folder.root);
    const FolderLock lock(folder.root);
    claim(folder, run_json_of(request, identity, run.seed), request.start_over);

    const Json params{{"splat", fields_json(request.splat)}, {"photos", fields_json(request.photos)}};
    const StageRecord record = run_stage(
        folder.root, "splat", stage_key("capture", params, {identity}, run.seed), run,
        [&](const fs::path& out) { make_capture_splat(request, capture, folder, out, run); });
    if (record.skipped) run.note("splat: already made");
    run.check_stop();
    share_capture(folder, name_of(request.source.source), run);
    Json report{{"capture", fs::absolute(request.source.source).lexically_normal().string()},
                {"photographs", capture.photos.size()},
                {"points", capture.points.size()},
                {"seed", run.seed},
                {"quality", request.quality},
                {"versions", build_json()},
                {"threads", thread_count()},
                {"seconds", record.cost.seconds},
                {"cpu_seconds", record.cost.cpu_seconds},
                {"peak_memory_bytes", record.cost.peak_memory_bytes}};
    report["stages"]["splat"] = {{"seconds", record.cost.seconds},
                                 {"cpu_seconds", record.cost.cpu_seconds},
                                 {"peak_memory_bytes", record.cost.peak_memory_bytes},
                                 {"hash", record.result}};
    report["stages"]["splat"]["device"] = device_of_fit(folder.stage("splat"));
    Json made = Json::array();
    for (const std::string& name : RunFolder::owned())
        if (name == "report.json" || fs::exists(folder.root / name)) made.push_back(name);
    report["made"] = made;
    report["health"] = check_health(folder, run);
    write_json(folder.report_json(), report);
    return report;
}

std::optional<RecordedCapture> recorded_capture(const RunFolder& folder) {
    if (!fs::exists(folder.run_json())) return {};
    const Json json = read_json(folder.run_json());
    if (!json.contains("capture")) return {};
    try {
        RecordedCapture out;
        const Json& capture = json.at("capture");
        out.request.source = std::get<CaptureSource>(source_from_json(json));
        out.request.quality = json.at("quality");
        out.seed = json.at("seed");
        fields_from_json(capture.at("photos"), out.request.photos);
        fields_from_json(json.at("params").at("splat"), out.request.splat);
        return out;
    } catch (const Json::exception& e) {
        throw Error("{}: expected capture, quality, params and seed: {}", folder.run_json().string(), e.what());
    }
}

}  // namespace fastscene
