// Quality of the walk's inpainting of surfaces hidden from panorama 0, against the traced room (its albedo: no light,
// no noise). One JSON line per room: PSNR of the walked panoramas in total and where panorama 0 saw nothing, error by
// object, and what the warp had there. Traced pictures are cached in --keep, so that another version can walk through
// the same room immediately.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>

#include "cpu_clock.h"
#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/walk/coarse_view.h"
#include "fastscene/walk/plane_picture.h"
#include "fastscene/walk/walk.h"

namespace fastscene {
namespace {

struct TrueView {
    ImageRgb8 color;
    ImageF range;
    Image<std::int32_t> object;  // index into the cached names, -1 = walls, floor, ceiling, -2 = outside
};
TrueView load_view(const std::filesystem::path& stem) {
    TrueView view{load_rgb8(stem.string() + ".png"), load_float(stem.string() + ".exr"), {}};
    const ImageF object = load_float(stem.string() + "-object.exr");
    view.object = Image<std::int32_t>(object.width, object.height);
    for (std::size_t i = 0; i < object.size(); ++i)
        view.object.pixels[i] = static_cast<std::int32_t>(std::lround(object.pixels[i]));
    return view;
}
void save_view(const std::filesystem::path& stem, const Shot& shot) {
    ImageF object(shot.range.width, shot.range.height);
    for (std::size_t i = 0; i < object.size(); ++i) object.pixels[i] = static_cast<float>(shot.object.pixels[i]);
    save_png(stem.string() + ".png", srgb8_from_linear(shot.albedo));
    save_exr(stem.string() + "-object.exr", object);
    save_exr(stem.string() + ".exr", shot.range);
}
Panorama panorama_of(const TrueView& view) { return {linear_from_srgb8(view.color), view.range, {}, {}}; }

struct Kept {
    TrueView first;
    std::vector<TrueView> views;  // at the viewpoints, in order
    std::vector<std::string> objects;
};
// Cached.
Kept true_views(const std::filesystem::path& folder, const std::string& text, const PanoramaParams& params,
                const WalkParams& walk, const Run& run) {
    const auto name = [&](std::size_t k) { return folder / fmt::format("{:03}", k); };
    if (!std::filesystem::exists(folder / "objects.json")) {
        make_directories(folder);
        PromptSpec prompt = read_prompt(text, params);
        const auto room = make_traced_room(prompt, params, run);
        const EquirectSize size{params.width, params.width / 2};
        const ShotParts parts{.color = false, .range = true, .albedo = true, .object = true, .pixel_samples = 4};
        save_view(name(0), room->panorama({}, size, parts, run));
        const std::vector<Vec3f> positions = choose_viewpoints(panorama_of(load_view(name(0))), walk);
        for (std::size_t k = 0; k < positions.size(); ++k)
            save_view(name(k + 1), room->panorama({{}, positions[k]}, size, parts, run));
        Json objects = Json::array();
        for (const RoomObject& o : room->room().objects) objects.push_back(o.name.empty() ? o.kind : o.name);
        write_json(folder / "objects.json", objects);
    }
    Kept kept{load_view(name(0)), {}, read_json(folder / "objects.json").get<std::vector<std::string>>()};
    for (std::size_t k = 1; std::filesystem::exists(name(k).string() + ".png"); ++k)
        kept.views.push_back(load_view(name(k)));
    return kept;
}

// Nonzero where the true surface is hidden from panorama 0.
ImageMask unseen_part(const ImageF& range, Vec3f position, const ImageF& first) {
    const EquirectSize size{range.width, range.height};
    ImageMask out(range.width, range.height);
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x) {
            if (!std::isfinite(range.at(x, y))) continue;
            const Vec3f p = position + direction_of_pixel(x, y, size) * range.at(x, y);
            const Vec2f at = pixel_of_direction(p, size);
            float farthest = 0;  // maximum over neighbouring pixels, so that silhouettes count as seen
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    farthest = std::max(farthest, first.at(wrap_column(static_cast<int>(at.x) + i, size.width),
                                                           std::clamp(static_cast<int>(at.y) + j, 0, size.height - 1)));
            out.at(x, y) = farthest < 0.98f * length(p) - 0.01f;
        }
    return out;
}

double square(Rgb8 a, Rgb8 b) {
    const auto one = [](int d) { return static_cast<double>(d * d) / (255.0 * 255.0); };
    return (one(a.r - b.r) + one(a.g - b.g) + one(a.b - b.b)) / 3;
}
struct Mean {
    double sum = 0, weight = 0;
    void add(double value, double by) { sum += value * by, weight += by; }
    double db() const { return -10 * std::log10(sum / weight + 1e-12); }
};

// Index of the plane that contains a point of the walk's frame, or -1.
int plane_at(Vec3f p, const std::vector<ScenePlane>& planes, Vec3f from) {
    int best = -1;
    float nearest = plane_tolerance(length(p));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const float off = std::fabs(dot(planes[i].normal, p) - planes[i].offset);
        if (off < nearest && dot(planes[i].normal, p - from) < 0) nearest = off, best = static_cast<int>(i);
    }
    return best;
}

// The rectified plane pictures in which the walk looks up hidden surfaces.
void save_plane_pictures(const std::filesystem::path& folder, const Panorama& first,
                         const std::vector<ScenePlane>& planes, const WalkParams& walk, const Run& run) {
    const Image<std::int16_t> label = label_planes(first.range, planes);
    const WarpSource source = make_warp_source(first.color, first.range, label, {}, {});
    const auto inpainter = make_inpainter(walk.inpainter, walk.inpaint_weights, walk.device);
    const std::vector<PlanePicture> pictures = paint_planes(source.color, first.range, label, source.cuts, planes,
                                                            *inpainter, run);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        if (!pictures[i].empty())
            save_png(folder / fmt::format("plane-{:02}.png", i), srgb8_from_linear(pictures[i].color));
}

// What the warp of panorama 0 has at a pixel, before completion.
const char* name_of(Cover cover) {
    switch (cover) {
        case Cover::hole: return "hole";
        case Cover::front: return "front";
        case Cover::back: return "back";
        case Cover::bridge: return "bridge";
        case Cover::guess: return "guess";
    }
    return "";
}
Json sorted_shares(const std::map<std::string, double>& errors, double all) {
    std::vector<std::pair<double, std::string>> most;
    for (const auto& [what, error] : errors) most.push_back({error / all, what});
    std::sort(most.rbegin(), most.rend());
    Json shares = Json::array();
    for (std::size_t i = 0; i < std::min<std::size_t>(8, most.size()); ++i)
        shares.push_back({most[i].second, std::round(most[i].first * 1000) / 1000});
    return shares;
}

int run(int argc, char** argv) {
    CLI::App app("Hidden surfaces as the walk paints them against the traced room.");
    std::string text, keep, pictures;
    std::uint64_t seed = 0;
    int threads = 0;
    bool show_planes = false;
    PanoramaParams panorama;
    panorama.width = 1024;
    panorama.trace = {
        .cell_m = 0.5f, .cell_samples = 1, .pixel_samples = 1};  // required, though no picture here is lit
    WalkParams walk;
    walk.viewpoints = 8;
    app.add_option("prompt", text, "The room.")->required();
    app.add_option("--keep", keep, "Folder of the traced pictures.")->required();
    app.add_option("--pictures", pictures,
                   "Folder for the walked panoramas, where and how far they are wrong, and the planes' pictures.");
    app.add_option("--seed", seed, "")->capture_default_str();
    app.add_option("--viewpoints", walk.viewpoints, "")->capture_default_str();
    app.add_option("--inpainter", walk.inpainter, "")->capture_default_str();
    app.add_flag("--planes", show_planes, "Say which plane is painted where another truly is.");
    app.add_option("--threads", threads, "")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    set_threads(threads);
    const Run how{seed, nullptr, {}};
    const Kept kept = true_views(keep, text, panorama, walk, how);
    const std::vector<ScenePlane> planes = find_planes(kept.first.range, seed);
    if (!pictures.empty()) {
        make_directories(pictures);
        save_plane_pictures(pictures, panorama_of(kept.first), planes, walk, how);
    }
    const double before = cpu_seconds();
    const std::vector<Panorama> walked = walked_through(panorama_of(kept.first), walk, how).panoramas;
    const double seconds = cpu_seconds() - before;
    if (walked.size() != kept.views.size() + 1)
        throw Error("{}: expected {} views, found {}", keep, walked.size() - 1, kept.views.size());
    Mean all, unseen;
    std::map<std::string, double> errors, covers, pairs;
    const std::vector<WarpSource> first{make_warp_source(linear_from_srgb8(kept.first.color), kept.first.range,
                                                         label_planes(kept.first.range, planes), {}, {})};
    for (std::size_t k = 1; k < walked.size(); ++k) {
        const TrueView& truth = kept.views[k - 1];
        const ImageRgb8 ours = srgb8_from_linear(walked[k].color);
        const EquirectSize size{ours.width, ours.height};
        const ImageMask hidden = unseen_part(truth.range, walked[k].world_from_pano.translation, kept.first.range);
        const Image<Cover> cover = coarse_view(first, size, walked[k].world_from_pano.translation).cover;
        ImageRgb8 wrong(ours.width, ours.height);
        for (int y = 0; y < ours.height; ++y)
            for (int x = 0; x < ours.width; ++x) {
                const double angle = pixel_solid_angle(y, size), error = square(ours.at(x, y), truth.color.at(x, y));
                all.add(error, angle);
                const int shown = std::min(255, static_cast<int>(std::sqrt(error) * 510));
                const auto level = static_cast<std::uint8_t>(shown);
                wrong.at(x, y) = hidden.at(x, y) ? Rgb8{level, std::uint8_t(60), std::uint8_t(60)}
                                                 : Rgb8{level, level, level};
                if (!hidden.at(x, y)) continue;
                unseen.add(error, angle);
                covers[name_of(cover.at(x, y))] += error * angle;
                const int object = truth.object.at(x, y);
                errors[object >= 0    ? kept.objects[static_cast<std::size_t>(object)]
                       : object == -1 ? "shell"
                                      : "outside"] += error * angle;
            }
        if (show_planes)
            for (int y = 0; y < ours.height; ++y)
                for (int x = 0; x < ours.width; ++x) {
                    if (!hidden.at(x, y)) continue;
                    const Vec3f d = direction_of_pixel(x, y, size), from = walked[k].world_from_pano.translation;
                    const float r = walked[k].range.at(x, y), t = truth.range.at(x, y);
                    const char* how_far = std::fabs(r - t) < 0.02f + 0.03f * t ? "there" : r < t ? "near" : "far";
                    const int object = truth.object.at(x, y);
                    const std::string on = object >= 0    ? kept.objects[static_cast<std::size_t>(object)]
                                           : object == -1 ? "shell"
                                                          : "outside";
                    pairs[fmt::format("{:2} for {:2} ({:5}) {} {}", plane_at(from + d * r, planes, from),
                                      plane_at(from + d * t, planes, from), how_far,
                                      walked[k].known.at(x, y) == Known::original ? "seen" : "made", on)] +=
                        square(ours.at(x, y), truth.color.at(x, y)) * pixel_solid_angle(y, size);
                }
        if (pictures.empty()) continue;
        const auto name = [&](const char* what) {
            return std::filesystem::path(pictures) / fmt::format("{:03}-{}.png", k, what);
        };
        save_png(name("walked"), ours);
        save_png(name("wrong"), wrong);
    }
    if (show_planes) {
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const ScenePlane& p = planes[i];
            std::cerr << fmt::format(
                "{:2} {:5} n {:6.3f} {:6.3f} {:6.3f} offset {:.3f} low {:.2f} {:.2f} high {:.2f} {:.2f}\n", i,
                p.hull ? "hull" : "", p.normal.x, p.normal.y, p.normal.z, p.offset, p.low.x, p.low.y, p.high.x,
                p.high.y);
        }
        std::vector<std::pair<double, std::string>> all_pairs;
        for (const auto& [what, error] : pairs) all_pairs.push_back({error / unseen.sum, what});
        std::sort(all_pairs.rbegin(), all_pairs.rend());
        for (std::size_t i = 0; i < std::min<std::size_t>(30, all_pairs.size()); ++i)
            std::cerr << fmt::format("{:6.1f} % {}\n", 100 * all_pairs[i].first, all_pairs[i].second);
    }
    std::cout << Json{{"prompt", text},
                      {"seed", seed},
                      {"walk_cpu_s", seconds},
                      {"all_db", all.db()},
                      {"unseen_db", unseen.db()},
                      {"unseen_share", unseen.weight / all.weight},
                      {"unseen_error_share", unseen.sum / all.sum},
                      {"on", sorted_shares(errors, unseen.sum)},
                      {"warped_as", sorted_shares(covers, unseen.sum)}}
                     .dump()
              << std::endl;
    return 0;
}

}  // namespace
}  // namespace fastscene

int main(int argc, char** argv) { return fastscene::run(argc, argv); }
