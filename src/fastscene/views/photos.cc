#include "fastscene/views/photos.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/io/image_io.h"
#include "fastscene/views/photo_picture.h"
#include "fastscene/views/spacing.h"
#include "fastscene/views/sweep.h"

namespace fastscene {
namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Vec3d median_place(const std::vector<Photo>& photos) {
    Vec3d out;
    for (std::size_t a = 0; a < 3; ++a) {
        std::vector<double> values;
        for (const Photo& p : photos) values.push_back(p.world_from_camera.translation[a]);
        out[a] = median(std::move(values));
    }
    return out;
}

// Scene radius: the median distance of the visible points from the center of the cameras, robust against outliers.
// Without points, the spread of the cameras.
double radius_of(const Capture& capture, Vec3d middle) {
    std::vector<double> distances;
    for (const CapturePoint& p : capture.points)
        if (const double d = length(p.position - middle); std::isfinite(d)) distances.push_back(d);
    if (!distances.empty()) return median(std::move(distances));
    for (const Photo& p : capture.photos) distances.push_back(length(p.world_from_camera.translation - middle));
    return 1.5 * median(std::move(distances));
}

// The trainer's initial steps and its grid are tuned for rooms in metres.
constexpr double kRoom_m = 3, kSmallest_m = 0.8, kLargest_m = 12, kFarOff_m = 100;

Similarity world_from_capture(const Capture& capture) {
    const Vec3d middle = median_place(capture.photos);
    const double radius = radius_of(capture, middle);
    const bool is_room = radius >= kSmallest_m && radius <= kLargest_m && length(middle) < kFarOff_m;
    if (is_room) return {};
    const double scale = radius > 1e-9 ? kRoom_m / radius : 1;
    return {{}, scale, middle * -scale};
}

Vec3f to_float(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
Vec3d place_of(const Similarity& s, Vec3d p) { return (s.new_from_old * p) * s.scale + s.translation; }
Rigid pose_of(const Similarity& s, const Rigidd& world_from_camera) {
    const Mat3d r = s.new_from_old * world_from_camera.rotation;
    return {{to_float(r.row0), to_float(r.row1), to_float(r.row2)},
            to_float(place_of(s, world_from_camera.translation))};
}

std::vector<const Photo*> present_photos(const Capture& capture, const Run& run) {
    std::vector<const Photo*> present;
    std::string first_missing;
    for (const Photo& photo : capture.photos)
        if (std::filesystem::is_regular_file(photo.file)) present.push_back(&photo);
        else if (first_missing.empty()) first_missing = photo.file.string();
    if (capture.photos.empty()) throw Error("{}: expected photographs with cameras, found none", capture.source);
    if (present.empty())
        throw Error("{}: expected the pictures of {} cameras, found none; {} is missing", capture.source,
                    capture.photos.size(), first_missing);
    if (present.size() < capture.photos.size())
        run.warn(fmt::format("{}: {} of {} pictures are missing and left out, {} first", capture.source,
                             capture.photos.size() - present.size(), capture.photos.size(), first_missing));
    return present;
}

// Points farther than this many scene radii are not used.
constexpr float kFarthest = 300 * static_cast<float>(kRoom_m);

std::vector<SurfacePoint> sized_points(const Capture& capture, const Similarity& world, const Run& run) {
    std::vector<SurfacePoint> out;
    std::vector<Vec3f> places;
    for (const CapturePoint& p : capture.points) {
        const Vec3f place = to_float(place_of(world, p.position));
        if (!(length(place) < kFarthest)) continue;
        places.push_back(place);
        out.push_back({place, {}, p.color, 0});
    }
    if (const std::size_t dropped = capture.points.size() - out.size())
        run.note(fmt::format("{} points are too far away to be used", dropped));
    const std::vector<float> sizes = spacings(places);
    // An isolated distant point must not become a fog over everything.
    const float typical = sizes.empty() ? 0 : static_cast<float>(median({sizes.begin(), sizes.end()}));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].radius_m = std::clamp(sizes[i], std::max(0.05f * typical, 1e-4f), std::max(20 * typical, 1e-3f));
    return out;
}

// Random points in front of random cameras, log-uniform in distance, with the color seen there.
std::vector<SurfacePoint> made_up_points(const ViewSet& set, int count, double distance_m, const Run& run) {
    std::vector<SurfacePoint> out;
    Random random(run.seed, "views/random-points");
    for (int i = 0; i < count; ++i) {
        const View& view = set.views[static_cast<std::size_t>(random.index(static_cast<int>(set.views.size())))];
        const int x = random.index(view.camera.width), y = random.index(view.camera.height);
        const float distance = static_cast<float>(distance_m) * std::exp(random.uniform(-1.6f, 1.6f));
        const Vec3f ray = view.model == CameraModel::equirectangular
                              ? direction_of_pixel(x, y, {view.camera.width, view.camera.height})
                              : normalize(view.camera.direction_at(
                                    {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
        out.push_back({view.world_from_camera * (ray * distance), {}, view.color.at(x, y), 0});
    }
    std::vector<Vec3f> places;
    for (const SurfacePoint& p : out) places.push_back(p.position_m);
    const std::vector<float> sizes = spacings(places);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].radius_m = std::max(sizes[i], 1e-4f);
    return out;
}

// For captures without points: from plane sweeping, or else random.
void make_up_points(const Capture& capture, const PhotosParams& params, PhotoViews& views, const Run& run) {
    const std::string why = capture.missing_points.empty()
                                ? "has no points to start from"
                                : capture.missing_points.string() + ", its points, is missing";
    const double spread = radius_of({capture.source, capture.photos, {}, {}, {}, {}}, median_place(capture.photos)) *
                          views.world_from_capture.scale;
    if (const auto reach = static_cast<float>(spread); reach > 0) {
        // Cameras that look inward surround their subject; cameras in a room are a step apart.
        views.set.points = swept_points(views.set, params.random_points, 0.3f * reach, 60 * reach, run);
    }
    if (views.set.points.empty()) {
        views.set.points = made_up_points(views.set, params.random_points, spread > 0.1 ? spread : kRoom_m, run);
        return run.warn(fmt::format("{}: {}; {} random ones are used, which needs more steps for lower quality",
                                    capture.source, why, views.set.points.size()));
    }
    run.warn(fmt::format("{}: {}; {} from plane sweeping are used", capture.source, why, views.set.points.size()));
    // The size of the scene is known only now.
    std::vector<double> distances;
    for (const SurfacePoint& p : views.set.points) distances.push_back(static_cast<double>(length(p.position_m)));
    const double radius = median(std::move(distances));
    if (radius >= kSmallest_m && radius <= kLargest_m) return;
    const double factor = kRoom_m / radius;
    views.world_from_capture.scale *= factor;
    views.world_from_capture.translation = views.world_from_capture.translation * factor;
    for (View& view : views.set.views)
        view.world_from_camera.translation = view.world_from_camera.translation * static_cast<float>(factor);
    for (SurfacePoint& p : views.set.points)
        p.position_m = p.position_m * static_cast<float>(factor), p.radius_m *= static_cast<float>(factor);
}

// `why`: what is wrong with each view's picture, or empty. A few damaged pictures are dropped; if most are damaged, it
// is an error, as the result would hide the mistake.
void leave_out_unusable(const Capture& capture, const std::vector<std::string>& why, std::vector<View>& views,
                        const Run& run) {
    constexpr std::size_t kNamed = 10;
    std::vector<std::string> named;
    std::vector<View> usable;
    std::size_t unusable = 0;
    for (std::size_t i = 0; i < why.size(); ++i) {
        if (why[i].empty()) usable.push_back(std::move(views[i]));
        else if (++unusable <= kNamed) named.push_back(why[i]);
    }
    views = std::move(usable);
    if (unusable == 0) return;
    if (unusable > kNamed) named.push_back(fmt::format("and {} more", unusable - kNamed));
    if (2 * unusable > why.size())
        throw Error("{}: expected pictures that fit their cameras, found {} of {} that cannot be used: {}",
                    capture.source, unusable, why.size(), fmt::join(named, "; "));
    run.warn(fmt::format("{}: {} of {} pictures cannot be used and are left out: {}", capture.source, unusable,
                         why.size(), fmt::join(named, "; ")));
}

void check_something_counts(const Capture& capture, const PhotosParams& params, const std::vector<View>& views) {
    for (const View& view : views)
        if (view.weight.empty() ||
            std::any_of(view.weight.pixels.begin(), view.weight.pixels.end(), [](std::uint8_t w) { return w > 0; }))
            return;
    const bool masked = params.alpha == "mask" || std::any_of(capture.photos.begin(), capture.photos.end(),
                                                              [](const Photo& p) { return !p.mask.empty(); });
    throw Error(
        "{}: expected a pixel that counts, found none in {} pictures: {}", capture.source, views.size(),
        masked ? "masks are black (and pictures transparent) where pixels are ignored; --invert-masks inverts masks"
               : "no pixel of the undistorted pictures is inside the lens' view; are its distortion and principal "
                 "point right?");
}

}  // namespace

PhotosMemory memory_of_photos(const Capture& capture, const PhotosParams& params, bool from_headers) {
    // bytes per pixel; a decoder needs additional rows besides the picture
    constexpr std::int64_t kColor = 3, kReading = 8;
    PhotosMemory out;
    std::int64_t largest = 0, count = 0;
    for (const Photo& photo : capture.photos) {
        if (!std::filesystem::is_regular_file(photo.file)) continue;
        PictureSize stored{photo.lens.width, photo.lens.height};
        if (from_headers) {
            try {
                const PictureInfo info = picture_info(photo.file);
                stored = {info.width, info.height};
            } catch (const Error&) {
                continue;  // dropped
            }
        }
        const auto [width, height] = size_of_view(photo, stored, params);
        const bool weights = !photo.mask.empty() || params.alpha == "mask" || !photo.lens.is_pinhole();
        out.views += std::int64_t{width} * height * (kColor + weights);
        largest = std::max(largest, std::int64_t{stored.width} * stored.height * kReading);
        ++count;
    }
    out.reading = largest * std::min<std::int64_t>(count, thread_count());
    return out;
}

PhotoViews views_of_capture(const Capture& capture, const PhotosParams& params, const Run& run) {
    check_fields("", params);
    for (const std::string& text : capture.warnings) run.warn(text);
    const std::vector<const Photo*> photos = present_photos(capture, run);
    PhotoViews out;
    out.world_from_capture = world_from_capture(capture);
    out.set.views.resize(photos.size());
    std::vector<std::string> unusable(photos.size());
    const auto is_bare = [](const Photo* photo) { return photo->mask.empty(); };
    const auto bare = static_cast<std::size_t>(std::count_if(photos.begin(), photos.end(), is_bare));
    if (bare > 0 && bare < photos.size())
        run.warn(fmt::format("{}: {} of {} pictures have no mask and count whole, {} first", capture.source, bare,
                             photos.size(), (*std::find_if(photos.begin(), photos.end(), is_bare))->name));
    Progress progress(run, "pictures", static_cast<std::int64_t>(photos.size()));
    parallel_for(static_cast<std::int64_t>(photos.size()), 1, [&](std::int64_t begin, std::int64_t) {
        run.check_stop();
        const auto i = static_cast<std::size_t>(begin);
        try {
            out.set.views[i] = view_of_photo(*photos[i], pose_of(out.world_from_capture, photos[i]->world_from_camera),
                                             params);
        } catch (const Error& e) {
            unusable[i] = e.what();
        }
        progress.advance();
    });
    leave_out_unusable(capture, unusable, out.set.views, run);
    Vec3f up;
    for (const View& view : out.set.views) up -= view.world_from_camera.rotation.column(1);
    check_something_counts(capture, params, out.set.views);
    out.up = length(up) > 0.1f * static_cast<float>(out.set.views.size()) ? normalize(up) : Vec3f{0, -1, 0};
    out.set.points = sized_points(capture, out.world_from_capture, run);
    if (out.set.points.empty()) make_up_points(capture, params, out, run);
    return out;
}

}  // namespace fastscene
