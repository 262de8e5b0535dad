#include "fastscene/depth/examples.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/json.h"
#include "fastscene/base/random.h"
#include "fastscene/depth/repaint.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

bool drawn_for_holding_out(const std::string& place) { return mix64(hash_name(place)) % 10 == 0; }

std::vector<fs::path> sorted_entries(const fs::path& folder) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(folder)) out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

// A picture's JSON is written last: without one it is unfinished.
void find_rooms(const fs::path& shard, std::vector<DepthFiles>& out) {
    for (const fs::path& path : sorted_entries(shard)) {
        if (path.extension() != ".json") continue;
        const Json json = read_json(path);
        try {
            if (json.at("camera").at("model") != "EQUIRECTANGULAR") continue;
            const int room = json.at("room").get<int>();
            DepthFiles files{shard / json.at("color").get<std::string>(),
                             shard / json.at("range").get<std::string>(),
                             {},
                             {},
                             fmt::format("room {}", room),
                             room % 10 == 9};
            if (json.contains("normal") && json.contains("instance")) {
                files.normals = shard / json.at("normal").get<std::string>();
                files.pieces = shard / json.at("instance").get<std::string>();
            }
            out.push_back(std::move(files));
        } catch (const Json::exception& e) {
            throw Error("{}: expected camera, room, color and range (docs/dataset.md): {}", path.string(), e.what());
        }
    }
}

void find_structured3d(const fs::path& scene, std::vector<DepthFiles>& out) {
    const std::string place = scene.filename().string();
    const bool held_out = std::atoi(place.substr(6).c_str()) >= 3000;
    for (const fs::path& room : sorted_entries(scene / "2D_rendering"))
        for (const char* furniture : {"full", "simple", "empty"})
            for (const char* light : {"rgb_rawlight.png", "rgb_warmlight.png", "rgb_coldlight.png"}) {
                const fs::path color = room / "panorama" / furniture / light,
                               range = room / "panorama" / furniture / "depth.png";
                if (fs::exists(color) && fs::exists(range)) out.push_back({color, range, {}, {}, place, held_out});
            }
}

// Names: SCENE_PLACE_color_POSITION.png; with "depth" in place of "color" it is the range.
void find_pano3d(const fs::path& color, std::vector<DepthFiles>& out) {
    std::string name = color.filename().string();
    const std::size_t at = name.find("_color_");
    if (at == std::string::npos || color.extension() != ".png") return;
    const std::string place = name.substr(0, at);
    name = name.substr(0, at) + "_depth_" + fs::path(name.substr(at + 7)).stem().string() + ".exr";
    if (fs::exists(color.parent_path() / name))
        out.push_back({color, color.parent_path() / name, {}, {}, place, drawn_for_holding_out(place)});
}

// Downloads have their own folders: Structured3D_panorama_00/Structured3D/scene_00000.
constexpr int kDeepest = 4;

void find_below(const fs::path& path, int deep, std::vector<DepthFiles>& out) {
    const std::string name = path.filename().string();
    if (!fs::is_directory(path)) return find_pano3d(path, out);
    if (name.starts_with("shard-")) return find_rooms(path, out);
    if (name.starts_with("scene_") && fs::is_directory(path / "2D_rendering")) return find_structured3d(path, out);
    if (deep == 0) return;
    for (const fs::path& inner : sorted_entries(path)) find_below(inner, deep - 1, out);
}

// Nearest neighbour: an interpolated range lies on neither surface.
template <class T>
Image<T> picked(const Image<T>& map, EquirectSize size) {
    Image<T> out(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            out.at(x, y) = map.at((2 * x + 1) * map.width / (2 * size.width),
                                  (2 * y + 1) * map.height / (2 * size.height));
    return out;
}

ImageF picked_range(const ImageF& range, EquirectSize size) {
    ImageF out = picked(range, size);
    for (float& r : out.pixels)
        if (!(r > 0.f && std::isfinite(r))) r = 0.f;
    return out;
}

// The dominant axis of an encoded normal, (n + 1) / 2.
int axis_of_normal(Rgb8 c) {
    const int x = std::abs(2 * c.r - 255), y = std::abs(2 * c.g - 255), z = std::abs(2 * c.b - 255);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

SurfaceMap load_surfaces(const DepthFiles& files, EquirectSize size) {
    const ImageRgb8 normals = picked(load_rgb8(files.normals), size);
    const ImageF pieces = picked(load_float(files.pieces, 1.f), size);
    SurfaceMap out(size.width, size.height);
    for (std::size_t i = 0; i < out.size(); ++i)
        out.pixels[i] = surface_id(static_cast<int>(pieces.pixels[i]), axis_of_normal(normals.pixels[i]));
    return out;
}

}  // namespace

std::vector<DepthFiles> find_depth_files(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw Error("{}: expected a folder of pictures with range, found none", folder.string());
    std::vector<DepthFiles> out;
    find_below(folder, kDeepest, out);
    if (out.empty())
        throw Error(
            "{}: expected panoramas with range (shard-00000/*.json of `fastscene rooms dataset`, "
            "scene_00000/2D_rendering of Structured3D, or "
            "*_color_*.png with "
            "*_depth_*.exr of Pano3D), found none",
            folder.string());
    return out;
}

DepthExample load_example(const DepthFiles& files, EquirectSize size, bool with_surfaces) {
    const ImageRgb8 color = load_rgb8(files.color);
    if (color.width != 2 * color.height)
        throw Error("{}: expected a panorama twice as wide as high, found {} x {}", files.color.string(), color.width,
                    color.height);
    const ImageF range = load_float(files.range);
    if (range.width != 2 * range.height)
        throw Error("{}: expected a map twice as wide as high, found {} x {}", files.range.string(), range.width,
                    range.height);
    DepthExample out{srgb8_from_linear(equirect_from_equirect(linear_from_srgb8(color), size)),
                     picked_range(range, size)};
    if (with_surfaces && !files.pieces.empty()) out.surfaces = load_surfaces(files, size);
    if (std::none_of(out.range.pixels.begin(), out.range.pixels.end(),
                     [](float r) { return r > 0.f && r < kFarthestTaught_m; }))
        throw Error("{}: expected ranges in metres, above 0 and below {}, found none: are they in another unit?",
                    files.range.string(), kFarthestTaught_m);
    return out;
}

std::vector<DepthExample> load_examples(const std::vector<DepthFiles>& files, bool held_out, EquirectSize size,
                                        const Run& run) {
    std::vector<DepthExample> out;
    if (files.empty()) return out;
    Progress progress(run, "pictures", static_cast<std::int64_t>(files.size()));
    for (const DepthFiles& one : files) {
        run.check_stop();
        progress.advance();
        if (one.held_out != held_out) continue;
        try {
            out.push_back(load_example(one, size, !held_out));
        } catch (const Error& e) {
            run.warn(fmt::format("left out: {}", e.what()));
        }
    }
    return out;
}

std::vector<float> mean_range_by_latitude(const std::vector<DepthExample>& examples) {
    if (examples.empty()) return {};
    const auto height = static_cast<std::size_t>(examples.front().range.height);
    std::vector<double> sum(height), count(height);
    for (const DepthExample& e : examples)
        for (std::size_t i = 0; i < e.range.size(); ++i)
            if (const float r = e.range.pixels[i]; r > 0)
                sum[i / static_cast<std::size_t>(e.range.width)] += r,
                    count[i / static_cast<std::size_t>(e.range.width)] += 1;
    std::vector<float> mean(height, 0.f);
    float last = 0;
    for (std::size_t y = 0; y < height; ++y)
        mean[y] = last = count[y] > 0 ? static_cast<float>(sum[y] / count[y]) : last;
    for (std::size_t y = height; y-- > 0;) mean[y] = last = mean[y] > 0 ? mean[y] : last;
    return mean;
}

}  // namespace fastscene
