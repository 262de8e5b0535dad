#include "fastscene/cli/labelled_scene.h"

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/export/splat_labels.h"
#include "fastscene/io/npy.h"
#include "fastscene/pipeline/room_of_run.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/splat_files.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

// Comments of a labelled PLY: an instance each.
constexpr std::string_view kInstanceComment = "fastscene instance ";

void check_labels(const fs::path& file, const LabelledScene& scene) {
    if (scene.labels.size() != scene.splats.size())
        throw Error("{}: expected a label for each of {} splats, found {}", file.string(), scene.splats.size(),
                    scene.labels.size());
    for (const std::uint16_t label : scene.labels)
        if (label >= scene.instances.size())
            throw Error("{}: expected labels below {}, found {}", file.string(), scene.instances.size(), label);
}

// The panoramas that the splats were trained on.
std::vector<Vec3f> viewpoints_of(const fs::path& run_folder) {
    std::vector<Vec3f> out;
    for (const Rigid& pose : load_walk_poses(RunFolder{run_folder})) out.push_back(pose.translation);
    return out;
}

}  // namespace

fs::path instances_beside(const fs::path& npy) { return fs::path(npy).replace_extension(".json"); }

LabelledScene labelled_scene(const fs::path& run_folder, const TracedRoom& room, const Run& run) {
    LabelledScene scene{load_scene(run_folder, run).splats, {}, instances_of(room.room())};
    scene.labels = splat_labels(scene.splats, room, viewpoints_of(run_folder), run);
    return scene;
}

LabelledScene load_labelled(const fs::path& place, const Run& run) {
    if (fs::is_directory(place)) {
        const RunFolder folder{place};
        return labelled_scene(place, *unlit_room_of_run(folder, recorded_run(folder), run), run);
    }
    LabelledScene scene;
    if (place.extension() == ".ply") {
        LabelledSplats found = load_labelled_ply(place);
        if (!found.labels.values.empty()) {
            Json instances = Json::array();
            for (const std::string& comment : found.labels.comments)
                if (comment.starts_with(kInstanceComment))
                    instances.push_back(Json::parse(comment.substr(kInstanceComment.size()), nullptr, false));
            scene = {std::move(found.splats), std::move(found.labels.values),
                     instances_from_json(instances, place.string() + ": comments")};
            check_labels(place, scene);
            return scene;
        }
    }
    const fs::path labels = fs::path(place).replace_extension(".labels.npy");
    if (!fs::exists(labels))
        throw UsageError(
            "{}: expected labelled splats: the folder of a run from a prompt, a .ply of `fastscene export`, or {} "
            "beside it; found none",
            place.string(), labels.filename().string());
    scene = {load_splats(place).splats, load_npy(labels),
             instances_from_json(read_json(instances_beside(labels)), instances_beside(labels).string())};
    check_labels(labels, scene);
    return scene;
}

void save_labelled_ply(const fs::path& file, const LabelledScene& scene) {
    SplatLabels labels{scene.labels, {}};
    for (const Json& instance : instances_json(scene.instances))
        labels.comments.push_back(std::string(kInstanceComment) + instance.dump());
    write_file(file, splat_ply_bytes(scene.splats, PlyBands::all, {}, labels));
}

}  // namespace fastscene::cli
