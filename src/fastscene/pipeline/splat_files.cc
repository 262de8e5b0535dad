#include "fastscene/pipeline/splat_files.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "fastscene/base/data_files.h"
#include "fastscene/base/file.h"
#include "fastscene/base/program.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

bool is_sog(const fs::path& path) { return path.extension() == ".sog" || path.extension() == ".SOG"; }

// A program with its leading arguments.
struct Command {
    fs::path program;
    std::vector<std::string> first;
};
Command splat_transform() {
    if (const auto found = find_program("splat-transform")) return {*found, {}};
    const auto script = find_data("splat-transform/bin/cli.mjs");  // exists in a build tree, but not in an installation
    const auto node = find_program("node");
    if (node && script) return {*node, {script->string()}};
    throw Error(
        "SOG is written and read by the program splat-transform, which is not here: `npm install -g "
        "@playcanvas/splat-transform` (Node 18 or later), "
        "or `npm ci --ignore-scripts` in the folder web/ of the sources; or use .spz, .glb or .compressed.ply");
}

// A temporary folder, deleted with the object.
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

// The line with the reason, without positions in the other program's source.
std::string reason_in(const std::string& said) {
    std::string last;
    for (std::size_t at = 0; at < said.size();) {
        const std::size_t end = std::min(said.find('\n', at), said.size());
        const std::string line = said.substr(at, end - at);
        at = end + 1;
        if (const std::size_t error = line.find("Error: "); error != std::string::npos) return line.substr(error + 7);
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
    }
    return last;
}

// A bundle is a ZIP archive, which has its directory at the end.
void check_bundle(const fs::path& file) {
    const std::string bytes = read_file(file);
    if (!bytes.starts_with("PK\x03\x04"))
        throw Error("{}: expected a SOG bundle, which is a ZIP archive, found {}", file.string(),
                    bytes.empty() ? "an empty file" : "something else");
    constexpr std::size_t kLongestEnd = 22 + 65535;
    if (bytes.find("PK\x05\x06", bytes.size() - std::min(bytes.size(), kLongestEnd)) == std::string::npos)
        throw Error("{}: expected a whole SOG bundle, found: the file ends too early ({} bytes)", file.string(),
                    bytes.size());
}

// `-g cpu`: works without a GPU.
void translate(const fs::path& from, const fs::path& to, const fs::path& named, const ScratchFolder& scratch,
               const Run& run) {
    const Command command = splat_transform();
    std::vector<std::string> arguments = command.first;
    for (const std::string& a : {std::string("-w"), std::string("-g"), std::string("cpu"), from.string(), to.string()})
        arguments.push_back(a);
    const fs::path log = scratch.path() / "log";
    const int code = run_program(command.program, arguments, {log, {}, run.stop});
    if (code == 0 && fs::exists(to)) return;
    throw Error("{}: splat-transform failed with exit code {}: {}", named.string(), code,
                fs::exists(log) ? reason_in(read_file(log)) : "");
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
        check_bundle(file);
        const ScratchFolder scratch;
        translate(fs::absolute(file), scratch.path() / "scene.ply", file, scratch, run);
        loaded = load_splats(scratch.path() / "scene.ply");
    } else {
        loaded = load_splats(file);
    }
    if (loaded.cleaned.dropped)
        run.warn(fmt::format("{}: {} splats cannot be drawn (NaN, infinite or far too large numbers) and are left out",
                             file.string(), loaded.cleaned.dropped));
    if (loaded.cleaned.repaired)
        run.note(fmt::format("{}: {} splats had an infinite opacity, no size or no rotation; they were repaired",
                             file.string(), loaded.cleaned.repaired));
    return loaded;
}

void save_scene(const fs::path& path, const Splats& splats, const SplatWriting& writing, const Run& run) {
    if (!is_splat_file_name(path))
        throw UsageError("{}: expected a name that ends in {}", path.string(), kSplatFileNames);
    if (!is_sog(path)) return save_splats(path, splats, *splat_format_of_name(path), writing);
    if (splats.size() == 0)
        throw Error("{}: expected splats to write, found none: splat-transform makes no empty SOG", path.string());
    if (splats.antialias)
        run.warn(fmt::format(
            "{}: splat-transform 2.7 forgets that these splats are antialiased: small ones will look too bright",
            path.string()));
    const ScratchFolder scratch;
    save_splat_ply(scratch.path() / "scene.ply", splats, PlyBands::present);
    translate(scratch.path() / "scene.ply", scratch.path() / "scene.sog", path, scratch, run);
    write_file(path, read_file(scratch.path() / "scene.sog"));
}

}  // namespace fastscene
