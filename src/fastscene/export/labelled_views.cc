#include "fastscene/export/labelled_views.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/export/view_maps.h"
#include "fastscene/image/encoded_maps.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/view_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

void copy_folder(const fs::path& from, const fs::path& to) {
    std::error_code failed;
    fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::overwrite_existing, failed);
    if (failed) throw Error("{}: cannot be written: {}", to.string(), failed.message());
}

void save_map(const std::string& map, const fs::path& file, const ViewMaps& maps,
              const std::vector<Instance>& instances) {
    if (map == "depth") return save_png16(file, millimetres(maps.depth_z));
    if (map == "instance") return save_png16(file, maps.instance);
    if (map == "class") return save_png(file, class_map(maps.instance, instances));
    ImageRgb8 normal(maps.normal.width, maps.normal.height);
    std::transform(maps.normal.pixels.begin(), maps.normal.pixels.end(), normal.pixels.begin(), encoded_normal);
    save_png(file, normal);
}

}  // namespace

std::size_t write_labelled_views(const fs::path& views, const fs::path& out, const TracedRoom& room,
                                 const std::vector<std::string>& wanted, const Run& run) {
    if (fs::exists(views / "known"))
        throw UsageError("{}: expected views with known cameras, found estimated ones (--sfm)", views.string());
    const ViewSet set = load_views(views);
    const std::vector<Instance> instances = instances_of(room.room());
    for (const std::string& map : wanted) make_directories(out / map);
    copy_folder(views / "images", out / "images");
    copy_folder(views / "sparse", out / "sparse");
    Json transforms = read_json(views / "transforms.json");
    const Run quiet{run.seed, nullptr, run.stop};
    Progress progress(run, "maps", static_cast<std::int64_t>(set.views.size()));
    for (const View& view : set.views) {
        run.check_stop();
        const ViewMaps maps = view_maps(room, view.camera, view.world_from_camera, quiet);
        for (const std::string& map : wanted) save_map(map, out / map / view.name, maps, instances);
        progress.advance();
    }
    for (Json& frame : transforms["frames"]) {
        const std::string name = fs::path(frame["file_path"].get<std::string>()).filename().string();
        for (const std::string& map : wanted) frame[map + "_file_path"] = map + "/" + name;
    }
    write_json(out / "instances.json", instances_json(instances));
    write_json(out / "transforms.json", transforms);
    return set.views.size();
}

}  // namespace fastscene
