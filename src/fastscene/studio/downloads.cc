#include "fastscene/studio/downloads.h"

#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/base/program.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/studio/refusal.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

enum class Needs : std::uint8_t { nothing, splats, room };

struct Download {
    std::string id, group, file, about;
    std::string stands;                  // file below the scene's folder; empty: made on demand
    std::vector<std::string> arguments;  // of the command that makes it, with SCENE and FILE as placeholders
    Needs needs = Needs::nothing;
};

std::vector<Download> all_downloads() {
    std::vector<Download> all{
        {"viewer", "share", "viewer.html", "web page to walk through the scene, opens from disk", "viewer.html", {}},
        {"panorama", "share", "panorama.png", "360° picture, equirectangular", "panorama/color.png", {}},
        {"preview", "share", "preview.jpg", "picture", "preview.jpg", {}},
        {"ply", "splats", "scene.ply", "3D Gaussians, as most programs read them", "splat/scene.ply", {}},
        {"compressed-ply",
         "splats",
         "scene.compressed.ply",
         "SuperSplat, PlayCanvas",
         "splat/scene.compressed.ply",
         {}},
    };
    for (const SplatFormat& format : registered<SplatFormat>()) {
        if (format.ending.ends_with(".ply")) continue;  // there already
        all.push_back({"splats" + format.ending,
                       "splats",
                       "scene" + format.ending,
                       format.readers,
                       "",
                       {"convert", "SCENE/splat/scene.ply", "FILE"},
                       Needs::splats});
    }
    const std::vector<Download> room{
        {"room",
         "room",
         "room.glb",
         "textured room: Blender, Unity, Unreal, Godot",
         "",
         {"export", "SCENE", "FILE", "--what", "room"},
         Needs::room},
        {"collision",
         "room",
         "collision.glb",
         "simple shapes for physics",
         "",
         {"export", "SCENE", "FILE", "--what", "collision"},
         Needs::room},
        {"labels",
         "room",
         "labels.json",
         "all objects with their classes and bounding boxes",
         "",
         {"export", "SCENE", "FILE", "--what", "labels"},
         Needs::room},
        {"walkable",
         "room",
         "walkable.json",
         "walkable area",
         "",
         {"export", "SCENE", "FILE", "--what", "walkable"},
         Needs::room},
        {"plan",
         "room",
         "plan.svg",
         "floor plan with dimensions",
         "",
         {"export", "SCENE", "FILE", "--what", "plan"},
         Needs::room},
        {"document", "room", "room.json", "the room as a document, to edit and build again", "panorama/room.json", {}},
        {"range", "data", "range.exr", "range map of the panorama, metres", "depth/range.exr", {}},
        {"report", "data", "report.json", "what the run cost", "report.json", {}},
        {"credits", "data", "credits.txt", "attributions that a published scene must name", "credits.txt", {}},
    };
    all.insert(all.end(), room.begin(), room.end());
    return all;
}

std::vector<std::string> filled(std::vector<std::string> arguments, const std::string& scene, const std::string& file) {
    for (std::string& argument : arguments) {
        if (argument.starts_with("SCENE")) argument = scene + argument.substr(5);
        if (argument == "FILE") argument = file;
    }
    return arguments;
}

std::string last_words(const fs::path& log) {
    const std::string text = fs::exists(log) ? read_file(log) : "";
    const std::size_t at = text.rfind("fastscene: ");
    if (at == std::string::npos) return "the program printed no message";
    return text.substr(at + 11, text.find('\n', at) - at - 11);
}

}  // namespace

fs::path Downloads::made_file(const std::string& scene, const std::string& file) const {
    return library_.root() / ".studio" / "downloads" / scene / file;
}

bool Downloads::is_current(const std::string& scene, const fs::path& made) const {
    const fs::path report = library_.folder(scene).report_json();
    return fs::exists(made) && fs::exists(report) && fs::last_write_time(made) >= fs::last_write_time(report);
}

Json Downloads::list(const std::string& scene) const {
    const RunFolder folder = library_.folder(scene);
    const bool splats = fs::exists(folder.scene_ply()), room = fs::exists(folder.room_json());
    Json out = Json::array();
    for (const Download& d : all_downloads()) {
        if ((d.needs == Needs::splats && !splats) || (d.needs == Needs::room && !room)) continue;
        const fs::path file = d.stands.empty() ? made_file(scene, d.file) : folder.root / d.stands;
        const bool there = d.stands.empty() ? is_current(scene, file) : fs::exists(file);
        if (!there && !d.stands.empty()) continue;
        Json one{{"id", d.id}, {"group", d.group}, {"file", d.file}, {"about", d.about}};
        one["bytes"] = there ? Json(fs::file_size(file)) : Json(nullptr);
        one["arguments"] = filled(d.arguments, folder.root.string(), d.file);
        out.push_back(std::move(one));
    }
    return out;
}

fs::path Downloads::make(const std::string& scene, const std::string& id) {
    const RunFolder folder = library_.folder(scene);
    for (const Download& d : all_downloads()) {
        if (d.id != id) continue;
        if (!d.stands.empty()) {
            if (const auto file = library_.file(scene, d.stands)) return *file;
            break;
        }
        const std::lock_guard lock(mutex_);
        const fs::path made = made_file(scene, d.file);
        if (is_current(scene, made)) return made;
        make_directories(made.parent_path());
        const fs::path log = made.parent_path() / "log";
        std::error_code none;
        fs::remove(log, none);
        std::vector<std::string> arguments = filled(d.arguments, folder.root.string(), made.string());
        arguments.insert(arguments.end(), {"--progress", "none"});
        if (run_program(program_, arguments, {log, {}, {}, {}}) != 0) throw Error("{}: {}", d.file, last_words(log));
        return made;
    }
    throw Refusal(404, "{} has no file \"{}\"", scene, id);
}

}  // namespace fastscene::studio
