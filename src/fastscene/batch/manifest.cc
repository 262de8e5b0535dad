#include "fastscene/batch/manifest.h"

#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/batch/task_cost.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/stage_code.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr int kMostChunks = 1000000;  // journals in one folder

std::string line_of(const BatchScene& scene) {
    Json json{{"name", scene.name}, {"prompt", scene.prompt}, {"seed", scene.seed}};
    if (!scene.quality.empty()) json["quality"] = scene.quality;
    if (!scene.flags.empty()) json["flags"] = scene.flags;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_scenes(const fs::path& file, const std::vector<const BatchScene*>& scenes) {
    write_pieces(file, [&](const auto& put) {
        for (const BatchScene* scene : scenes) put(line_of(*scene));
    });
}

}  // namespace

std::string batch_version() {
    Hash code;
    for (const std::string_view stage : kStages) code.add(code_version(stage));
    return fmt::format("{} ({})", program_version(), code.hex().substr(0, 12));
}

Json batch_settings(int total, const BatchParams& params) {
    return {{"scenes", total},       {"quality", params.quality}, {"command", params.stage},
            {"flags", params.flags}, {"tries", params.tries},     {"version", batch_version()}};
}

ChunkPlan write_manifest(const std::vector<BatchScene>& scenes, const fs::path& folder, const BatchParams& params,
                         int of_chunk, int most_chunks) {
    collect_journals(folder);
    const BatchJournal journal(folder);
    std::vector<const BatchScene*> left;
    for (const BatchScene& scene : scenes)
        if (!is_done(scene, params, journal)) left.push_back(&scene);
    ChunkPlan plan{static_cast<int>(left.size()), of_chunk};
    if (of_chunk == 0) plan.of_chunk = std::max(1, (plan.scenes + most_chunks - 1) / most_chunks);
    if (plan.chunks() > most_chunks)
        throw UsageError("--chunk-scenes: expected at least {}, found {}: {} scenes, and an array of at most {} tasks",
                         (plan.scenes + most_chunks - 1) / most_chunks, of_chunk, plan.scenes, most_chunks);
    write_scenes(folder / "scenes.jsonl", left);
    Json settings = batch_settings(static_cast<int>(scenes.size()), params);
    settings["scenes_of_chunk"] = plan.of_chunk;
    settings["chunks"] = plan.chunks();
    const TaskCost cost = task_cost(scenes, params.quality, plan.of_chunk);
    settings["of_chunk"] = {{"memory_mib", cost.memory_mib}, {"core_seconds", cost.core_seconds}};
    write_json(folder / "batch.json", settings);
    return plan;
}

ChunkPlan prepare_chunks(const std::vector<BatchScene>& scenes, const fs::path& folder, const BatchParams& params,
                         int of_chunk) {
    make_directories(folder);
    const FolderLock lock(folder);
    return write_manifest(scenes, folder, params, std::max(1, of_chunk), kMostChunks);
}

Chunk read_chunk(const fs::path& folder, int number) {
    const fs::path file = folder / "batch.json";
    const Json settings = fs::exists(file) ? read_json(file) : Json::object();
    if (!settings.contains("chunks"))
        throw UsageError("{}: expected a batch with chunks (--engine slurm or manual), found none", folder.string());
    if (settings.at("version") != batch_version())
        throw Error("{}: expected version {} of fastscene, which wrote it, found {}", file.string(),
                    settings.at("version").get<std::string>(), batch_version());
    const int chunks = settings.at("chunks").get<int>(), size = settings.at("scenes_of_chunk").get<int>();
    if (number >= chunks)
        throw UsageError("--chunk: expected a number below {}, the chunks of {}, found {}", chunks, folder.string(),
                         number);
    std::vector<BatchScene> scenes = read_scene_list(folder / "scenes.jsonl", 0).scenes;
    const auto at = [&](int chunk) {
        return scenes.begin() + std::min<std::ptrdiff_t>(std::ptrdiff_t{chunk} * size, std::ssize(scenes));
    };
    Chunk out{{at(number), at(number + 1)}, {}};
    out.params.quality = settings.at("quality"), out.params.stage = settings.at("command");
    out.params.flags = settings.at("flags"), out.params.tries = settings.at("tries");
    return out;
}

}  // namespace fastscene
