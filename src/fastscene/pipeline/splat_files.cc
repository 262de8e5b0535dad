#include "fastscene/pipeline/splat_files.h"

#include "fastscene/pipeline/run_folder.h"

namespace fastscene {
namespace fs = std::filesystem;

fs::path scene_file(const fs::path& place) {
    if (!fs::is_directory(place)) return place;
    for (const fs::path& file : {RunFolder{place}.scene_ply(), place / "scene.ply"})
        if (fs::exists(file)) return file;
    throw UsageError("{}: expected a finished run or a splat file, found no splat/scene.ply", place.string());
}

LoadedSplats load_scene(const fs::path& place, const Run& run) {
    const fs::path file = scene_file(place);
    LoadedSplats loaded = load_splats(file);
    if (loaded.cleaned.dropped)
        run.warn(fmt::format("{}: {} splats cannot be drawn (NaN, infinite or far too large numbers) and were dropped",
                             file.string(), loaded.cleaned.dropped));
    if (loaded.cleaned.repaired)
        run.note(fmt::format("{}: {} splats had an infinite opacity, no size or no rotation; they were repaired",
                             file.string(), loaded.cleaned.repaired));
    for (const std::string& text : loaded.warnings) run.warn(fmt::format("{}: {}", file.string(), text));
    if (const Vec3d at = loaded.offset_m; at != Vec3d{})
        run.note(fmt::format("{}: its positions lie around ({:.0f}, {:.0f}, {:.0f}) and are taken relative to that",
                             file.string(), at.x, at.y, at.z));
    return loaded;
}

}  // namespace fastscene
