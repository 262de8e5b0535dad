#include <algorithm>
#include <limits>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/image/ssim.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/metrics.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

Json json_of(const Rigid& pose) {
    Json rows = Json::array();
    const Mat3f& m = pose.rotation;
    for (const Vec3f v : {m.row0, m.row1, m.row2, pose.translation}) rows.push_back({v.x, v.y, v.z});
    return rows;
}

Rigid rigid_from(const Json& rows) {
    const auto number = [&](std::size_t i, std::size_t j) { return rows.at(i).at(j).get<float>(); };
    const auto row = [&](std::size_t i) { return Vec3f{number(i, 0), number(i, 1), number(i, 2)}; };
    return {{row(0), row(1), row(2)}, row(3)};
}

fs::path color_file(const fs::path& dir, std::size_t i) { return dir / fmt::format("{:02}.png", i); }
fs::path again_file(const fs::path& dir, std::size_t i) { return dir / fmt::format("{:02}-again.png", i); }
fs::path unseen_file(const fs::path& dir, std::size_t i) { return dir / fmt::format("{:02}-unseen.png", i); }

}  // namespace

TruthSet make_truth_set(const TracedRoom& room, const TruthParams& params, const Run& run) {
    TruthSet set{truth_poses(room, params, run.seed), {}, 0};
    Progress progress(run, "truth", static_cast<std::int64_t>(set.poses.size()));
    for (std::size_t i = 0; i < set.poses.size(); ++i) {
        run.check_stop();
        set.pictures.push_back(truth_picture(room, set.poses[i], params.size_px, Run{run.seed, nullptr, run.stop}));
        set.floor_db += psnr(set.pictures[i].color, set.pictures[i].again) / static_cast<double>(set.poses.size());
        progress.advance();
    }
    return set;
}

void save_truth_set(const fs::path& dir, const TruthSet& set) {
    make_directories(dir);
    Json poses = Json::array();
    for (std::size_t i = 0; i < set.poses.size(); ++i) {
        poses.push_back(json_of(set.poses[i].world_from_camera));
        save_png(color_file(dir, i), set.pictures[i].color);
        save_png(again_file(dir, i), set.pictures[i].again);
        save_png(unseen_file(dir, i), set.pictures[i].unseen);
    }
    write_json(dir / "poses.json", {{"rotation_rows_and_position", poses}, {"floor_db", set.floor_db}});
}

TruthSet load_truth_set(const fs::path& dir) {
    const Json about = read_json(dir / "poses.json");
    TruthSet set;
    try {
        for (const Json& rows : about.at("rotation_rows_and_position")) set.poses.push_back({rigid_from(rows)});
        set.floor_db = about.at("floor_db").is_number() ? about.at("floor_db").get<double>()
                                                        : std::numeric_limits<double>::infinity();
    } catch (const Json::exception& e) {
        throw Error("{}: expected poses and a floor: {}", (dir / "poses.json").string(), e.what());
    }
    for (std::size_t i = 0; i < set.poses.size(); ++i)
        set.pictures.push_back(
            {load_rgb8(color_file(dir, i)), load_rgb8(again_file(dir, i)), load_mask_png(unseen_file(dir, i))});
    return set;
}

}  // namespace fastscene
