// Subjects of `render`: splats, and traced rooms.
#include <cmath>
#include <filesystem>

#include "fastscene/base/check.h"
#include "fastscene/cli/render.h"
#include "fastscene/image/color.h"
#include "fastscene/pipeline/room_of_run.h"

namespace fastscene::cli {

RenderSubject subject_of_splats(Splats given, const SplatBackend& backend, Vec3f background) {
    const auto splats = std::make_shared<const Splats>(std::move(given));
    const auto renderer = std::make_shared<const SplatRenderer>(*splats, backend);
    const auto sphere = [=](int width, const Rigid& pose) {
        return (void)splats, sphere_of(*renderer, width, pose, background);
    };
    return {[=](const Pinhole& camera, const Rigid& pose) {
                return (void)splats, still_of(*renderer, camera, pose, background);
            },
            sphere,
            [=](int width, const Rigid& pose, float eye_m) {
                return (void)splats, eye_sphere_of(*renderer, width, pose, eye_m, background);
            },
            [=](int width, const Rigid& pose) { return front_half(sphere(width, pose).color); }};
}

RenderSubject subject_of_room(const std::string& folder, int samples, const Session& session) {
    const Run run = session.run(0);
    if (!std::filesystem::is_directory(folder))
        throw UsageError("--of room: expected the folder of a run from a prompt, found the file {}", folder);
    const RunFolder run_folder{folder};
    const RecordedRun recorded = recorded_run(run_folder);
    unlit_room_of_run(run_folder, recorded, run);  // another version's room is refused before its light is gathered
    const std::shared_ptr<const TracedRoom> room = room_of_run(run_folder, recorded, run);
    const ShotParts parts = final_parts(samples);
    const Run quiet{recorded.seed, nullptr, run.stop};
    const auto still = [](Shot shot, auto&& of_range) {
        Still out{srgb8_from_linear(shot.color), ImageMask(shot.color.width, shot.color.height, 255),
                  std::move(shot.range)};
        for (int y = 0; y < out.distance.height; ++y)
            for (int x = 0; x < out.distance.width; ++x) {
                float& d = out.distance.at(x, y);
                d = std::isfinite(d) ? d * of_range(x, y) : 0.f;  // nothing is hit outside
            }
        return out;
    };
    return {
        [=](const Pinhole& camera, const Rigid& pose) {
            return still(room->perspective(pose, camera, parts, quiet), [&](int x, int y) {
                return normalize(camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f})).z;
            });
        },
        [=](int width, const Rigid& pose) {
            return still(room->panorama(pose, {width, width / 2}, parts, quiet), [](int, int) { return 1.f; });
        },
        [=](int width, const Rigid& pose, float eye_m) {
            return srgb8_from_linear(room->eye_panorama(pose, {width, width / 2}, eye_m, parts, quiet).color);
        },
        [=](int width, const Rigid& pose) {
            ImageMask front(width, width / 2, 0);
            for (int y = 0; y < front.height; ++y)
                for (int x = width / 4; x < width * 3 / 4; ++x) front.at(x, y) = 255;
            ShotParts half = parts;
            half.only = &front;
            return front_half(srgb8_from_linear(room->panorama(pose, {width, width / 2}, half, quiet).color));
        }};
}

FilmStereo stereo_of(const RenderFlags& flags) {
    for (std::size_t i = 0; i < std::size(kFilmStereos); ++i)
        if (flags.stereo == kFilmStereos[i]) return static_cast<FilmStereo>(i);
    FASTSCENE_CHECK(!"--stereo was checked");
    return FilmStereo::mono;
}

ImageRgb8 sphere_picture(const RenderSubject& subject, int width, const Rigid& pose, FilmStereo stereo) {
    constexpr float kEye_m = kPupils_m / 2;
    switch (stereo) {
        case FilmStereo::mono: break;
        case FilmStereo::top_bottom:
            return stacked(subject.eye(width, pose, -kEye_m), subject.eye(width, pose, kEye_m));
        case FilmStereo::vr180:
            return beside(subject.half(width, displaced_eye(pose, -kEye_m)),
                          subject.half(width, displaced_eye(pose, kEye_m)));
    }
    return subject.sphere(width, pose).color;
}

}  // namespace fastscene::cli
