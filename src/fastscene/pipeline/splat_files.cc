#include "fastscene/pipeline/splat_files.h"

#include <cstdlib>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/base/program.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

bool is_sog(const fs::path& path) { return path.extension() == ".sog" || path.extension() == ".SOG"; }

// A program with the arguments that come before ours.
struct Command {
    fs::path program;
    std::vector<std::string> first;
};
Command splat_transform() {
    if (const auto found = find_program("splat-transform")) return {*found, {}};
    const fs::path checkout = fs::path(source_dir()) / "web/node_modules/@playcanvas/splat-transform/bin/cli.mjs";
    const auto node = find_program("node");
    if (node && fs::exists(checkout)) return {*node, {checkout.string()}};
    throw Error(
        "SOG is written and read by the program splat-transform, which is not here: `npm install -g @playcanvas/splat-transform` (Node 18 or later), "
        "or `npm ci --ignore-scripts` in {}/web; or use .spz, .glb or .compressed.ply",
        source_dir());
}

// A folder that goes with the object.
class ScratchFolder {
  public:
    ScratchFolder() : path_((fs::temp_directory_path() / "fastscene-XXXXXX").string()) {
        if (!::mkdtemp(path_.data())) throw Error("{}: cannot make a temporary folder", path_);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    fs::path path() const { return path_; }

  private:
    std::string path_;
};

// Without a graphics card: `-g cpu`.
void translate(const fs::path& from, const fs::path& to, const fs::path& named, const ScratchFolder& scratch, const Run& run) {
    const Command command = splat_transform();
    std::vector<std::string> arguments = command.first;
    for (const std::string& a : {std::string("-w"), std::string("-g"), std::string("cpu"), from.string(), to.string()}) arguments.push_back(a);
    const fs::path log = scratch.path() / "log";
    const int code = run_program(command.program, arguments, {log, {}, run.stop});
    if (code == 0 && fs::exists(to)) return;
    std::string said = fs::exists(log) ? read_file(log) : "";
    if (said.size() > 400) said = said.substr(said.size() - 400);
    throw Error("{}: splat-transform failed with exit code {}: {}", named.string(), code, said);
}

}  // namespace

bool is_splat_file_name(const fs::path& path) { return is_sog(path) || splat_format_of_name(path); }

Mat3d splat_file_from_world(const fs::path& path) {
    const auto format = splat_format_of_name(path);
    return format ? file_from_world(*format) : Mat3d{};
}

fs::path scene_file(const fs::path& place) {
    if (!fs::is_directory(place)) return place;
    for (const fs::path& file : {RunFolder{place}.scene_ply(), place / "scene.ply"})
        if (fs::exists(file)) return file;
    throw UsageError("{}: expected a finished run or a splat file, found no splat/scene.ply", place.string());
}

LoadedSplats load_scene(const fs::path& place, const Run& run) {
    const fs::path file = scene_file(place);
    LoadedSplats loaded;
    if (is_sog(file)) {
        if (!fs::exists(file)) throw Error("{}: cannot be read: No such file or directory", file.string());
        const ScratchFolder scratch;
        translate(fs::absolute(file), scratch.path() / "scene.ply", file, scratch, run);
        loaded = load_splats(scratch.path() / "scene.ply");
    } else {
        loaded = load_splats(file);
    }
    if (loaded.cleaned.dropped)
        run.warn(fmt::format("{}: {} splats cannot be drawn (NaN, infinite or far too large numbers) and are left out", file.string(),
                             loaded.cleaned.dropped));
    if (loaded.cleaned.repaired)
        run.note(
            fmt::format("{}: {} splats had an infinite opacity, no size or no rotation; they were repaired", file.string(), loaded.cleaned.repaired));
    return loaded;
}

void save_scene(const fs::path& path, const Splats& splats, const SplatWriting& writing, const Run& run) {
    if (!is_splat_file_name(path)) throw UsageError("{}: expected a name that ends in {}", path.string(), kSplatFileNames);
    if (!is_sog(path)) return save_splats(path, splats, *splat_format_of_name(path), writing);
    if (splats.antialias)
        run.warn(fmt::format("{}: splat-transform 2.7 forgets that these splats are antialiased: small ones will look too bright", path.string()));
    const ScratchFolder scratch;
    save_splat_ply(scratch.path() / "scene.ply", splats, PlyBands::present);
    translate(scratch.path() / "scene.ply", scratch.path() / "scene.sog", path, scratch, run);
    write_file(path, read_file(scratch.path() / "scene.sog"));
}

}  // namespace fastscene
