#include "fastscene/walk/hole_dataset.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/walk/free_space.h"
#include "fastscene/walk/hole_table.h"
#include "fastscene/walk/published_inpaint.h"
#include "fastscene/walk/published_warp.h"
#include "fastscene/walk/ready.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

std::vector<double> numbers_in(const std::string& flag, const std::string& list) {
    std::vector<double> out;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string word = list.substr(begin, end - begin);
        std::string_view rest = word;
        const double value = leading_number(rest).value_or(0);
        if (!rest.empty() || !(value > 0 && value < 100))
            throw UsageError("{}: expected distances above 0 with commas between them, found \"{}\"", flag, list);
        out.push_back(value);
        begin = end + 1;
    }
    return out;
}

Vec3f in_float(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

ImageMask published_hole(const ImageRgb8& color, const ImageF& range, Vec3d direction, double share) {
    const Image<double> units = published_units(in_double(range));
    double most = 0;
    for (const float r : range.pixels)
        if (std::isfinite(r)) most = std::max(most, static_cast<double>(r));
    const double free = kMostOfTheWay * distance_ahead(range, normalize(in_float(world_from_published(direction)))) /
                        most / length(direction);
    const PublishedWarp warp = published_warp(color, units, direction * std::min(share, free));
    ImageMask hole(color.width, color.height);
    std::transform(warp.source.pixels.begin(), warp.source.pixels.end(), hole.pixels.begin(),
                   [](std::int32_t s) { return s == kNoSource ? std::uint8_t{255} : std::uint8_t{0}; });
    return hole;
}

struct Plan {
    const HoleDatasetParams& params;
    fs::path folder;
    std::uint64_t seed;

    fs::path done(std::int64_t i) const { return folder / "done" / fmt::format("{:08}.json", i); }
    bool held_out(const PanoramaFiles& files) const {
        return Random(seed, files.place).uniform() * 100.f < static_cast<float>(params.held_out);
    }
    fs::path part(const PanoramaFiles& files) const { return folder / (held_out(files) ? "held-out" : "train"); }
    fs::path file(const fs::path& part_folder, const char* kind, std::int64_t i, const std::string& rest) const {
        return part_folder / kind / fmt::format("shard-{:05}", i / params.shard) / fmt::format("{:08}-{}.png", i, rest);
    }
};

void settle_settings(const Plan& plan) {
    const fs::path path = plan.folder / "dataset.json";
    Json wanted{{"format", "fastscene holes 1"}, {"seed", plan.seed}};
    wanted.update(fields_json(plan.params));
    if (!fs::exists(path)) return write_json(path, wanted);
    const Json found = read_json(path);
    for (const auto& [name, value] : wanted.items())
        if (!found.contains(name) || found[name] != value)
            throw UsageError(
                "{}: expected a dataset with {} = {}, found {}: use the same settings to resume, or another folder",
                path.string(), name, value.dump(), found.contains(name) ? found[name].dump() : "none");
}

// Empty, with a warning, if the panorama cannot be read or has no room to walk in: such a file is skipped. (An
// unwritable disk is a hard error.)
std::optional<Panorama> readable(const PanoramaFiles& files, const Run& run) {
    try {
        return ready_to_walk(load_panorama(files), {run.seed, nullptr, run.stop});
    } catch (const Error& e) {
        const std::string why = e.what(), name = files.color.string();
        run.warn(fmt::format("skipped {}{}", why.find(name) == std::string::npos ? name + ": " : "", why));
        return {};
    }
}

void make_one(const Plan& plan, const PanoramaFiles& files, const Panorama& panorama, std::int64_t i, const Run& run) {
    const ImageRgb8 color = srgb8_from_linear(panorama.color);
    const fs::path part = plan.part(files);
    for (const char* kind : {"images", "masks"}) make_directories(plan.file(part, kind, i, "").parent_path());
    const auto whole = published_faces(color, ImageMask(color.width, color.height), plan.params.size);
    for (std::size_t f = 0; f < whole.size(); ++f)
        save_png(plan.file(part, "images", i, std::string(name_of(kPublishedFaces[f]))), whole[f].color);
    const std::vector<ImageMask> holes = walk_holes(panorama, plan.params);
    double open = 0;
    for (std::size_t k = 0; k < holes.size(); ++k) {
        run.check_stop();
        const auto torn = published_hole_faces(holes[k], plan.params.size);
        for (std::size_t f = 0; f < torn.size(); ++f) {
            save_png(plan.file(part, "masks", i, fmt::format("{}-{:02}", name_of(kPublishedFaces[f]), k)), torn[f]);
            open += static_cast<double>(std::count(torn[f].pixels.begin(), torn[f].pixels.end(), 255)) /
                    static_cast<double>(torn[f].size());
        }
    }
    write_json(plan.done(i), {{"color", files.name},
                              {"place", files.place},
                              {"part", part.filename().string()},
                              {"faces", whole.size()},
                              {"masks", holes.size() * whole.size()},
                              {"open", open / static_cast<double>(holes.size() * whole.size())}});
}

}  // namespace

std::vector<ImageMask> walk_holes(const Panorama& panorama, const HoleDatasetParams& params) {
    std::vector<ImageMask> out;
    if (params.warp != "ours") {
        const ImageRgb8 color = srgb8_from_linear(panorama.color);
        for (const double share : numbers_in("--shares", params.shares))
            for (const PublishedDirection& direction : kPublishedDirections)
                out.push_back(published_hole(color, panorama.range, direction.move, share));
    }
    if (params.warp != "paper") {
        const WarpSource source = make_warp_source(panorama.color, panorama.range, {}, {}, {});
        for (const double metres : numbers_in("--metres", params.metres))
            for (const PublishedDirection& direction : kPublishedDirections) {
                const Vec3f towards = normalize(in_float(world_from_published(direction.move)));
                out.push_back(our_holes(source, panorama.size(),
                                        towards * std::min(static_cast<float>(metres),
                                                           kMostOfTheWay * distance_ahead(panorama.range, towards))));
            }
    }
    return out;
}

HoleDatasetState make_hole_dataset(const std::vector<PanoramaFiles>& panoramas, const HoleDatasetParams& params,
                                   const fs::path& folder, const Run& run) {
    numbers_in("--shares", params.shares);
    numbers_in("--metres", params.metres);
    const Plan plan{params, folder, run.seed};
    make_directories(folder / "done");
    settle_settings(plan);
    HoleDatasetState state;
    state.panoramas = static_cast<std::int64_t>(panoramas.size());
    std::int64_t held_out = 0;
    Progress progress(run, "panoramas", state.panoramas);
    for (std::int64_t i = 0; i < state.panoramas; ++i) {
        run.check_stop();
        const PanoramaFiles& files = panoramas[static_cast<std::size_t>(i)];
        if (!fs::exists(plan.done(i))) {
            const std::optional<Panorama> panorama = readable(files, run);
            if (!panorama) {
                ++state.broken;
                progress.advance();
                continue;
            }
            make_one(plan, files, *panorama, i, run);
            ++state.made;
        }
        const Json about = read_json(plan.done(i));
        // Older records contain the absolute path.
        if (const std::string made = about.value("color", ""); made != files.name && made != files.color.string())
            throw UsageError(
                "{}: expected panorama {} of the same list, {}, found {}: the input has changed; give another folder",
                folder.string(), i, made, files.name);
        ++state.there;
        held_out += plan.held_out(files);
        state.faces += about.value("faces", std::int64_t{0});
        state.masks += about.value("masks", std::int64_t{0});
        progress.advance();
    }
    if (state.panoramas > 0 && state.there == 0)
        throw Error("{}: expected a panorama with range that can be read, found none among {}", folder.string(),
                    state.panoramas);
    if (held_out == state.there)
        run.warn(
            fmt::format("{}: all {} panoramas are of places that are held out, none is left to train on: give more "
                        "places, or another folder with less --held-out",
                        folder.string(), held_out));
    return state;
}

}  // namespace fastscene
