#include "fastscene/base/file.h"
#include "fastscene/base/registry.h"
#include "fastscene/base/writable.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/labelled_scene.h"
#include "fastscene/cli/verb.h"
#include "fastscene/export/collision.h"
#include "fastscene/export/labelled_views.h"
#include "fastscene/export/labels.h"
#include "fastscene/export/meshopt.h"
#include "fastscene/export/range_mesh.h"
#include "fastscene/export/room_glb.h"
#include "fastscene/export/room_usda.h"
#include "fastscene/io/npy.h"
#include "fastscene/pipeline/room_of_run.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/splat_files.h"
#include "fastscene/trace/standable.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct ExportFlags {
    std::string scene, out, what;
    std::vector<std::string> maps{kViewMaps.begin(), kViewMaps.end()};
    bool baked_light = false, compress = false;
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

// What an export works on.
struct ExportJob {
    RunFolder folder;
    std::shared_ptr<const TracedRoom> known;  // null: a scene without a known room
    const ExportFlags& flags;
    BakeParams bake;
    const Run& run;
    fs::path out() const { return flags.out; }
    const TracedRoom& room() const { return *known; }
};

// What can be exported: its name for --what, and the ending of its files; without one it is a folder.
struct ExportKind {
    const char *name, *ending;
    enum Needs { room, ranges } needs;  // a known room; or panoramas with range, which every scene has
    void (*write)(const ExportJob&);
};

RoomModel model_of(const ExportJob& job) {
    return job.flags.baked_light ? lit_room_model(job.room(), job.bake, job.run)
                                 : room_model(job.room().room(), job.bake, job.run);
}

void write_glb(const ExportJob& job, const std::string& glb) {
    write_file(job.out(), job.flags.compress ? with_meshopt(glb) : glb);
}

void write_usda(const ExportJob& job) {
    const std::string folder = job.out().stem().string() + "_textures";
    const fs::path textures = job.out().parent_path() / folder;
    const UsdaRoom usda = room_usda(job.room().room(), model_of(job), folder);
    if (!usda.textures.empty()) make_directories(textures);
    for (const NamedBytes& texture : usda.textures) write_file(textures / texture.name, texture.bytes);
    write_file(job.out(), usda.text);
}

// The numbers, and what they mean beside them.
void write_npy(const ExportJob& job) {
    const LabelledScene scene = labelled_scene(job.folder.root, job.room(), job.run);
    write_json(instances_beside(job.out()), instances_json(scene.instances));
    write_file(job.out(), npy_bytes(scene.labels));
}

void write_views(const ExportJob& job) {
    const std::size_t count = write_labelled_views(job.folder.views(), job.out(), job.room(), job.flags.maps, job.run);
    job.run.note(fmt::format("{} views", count));
}

const std::vector<ExportKind>& export_kinds() {
    static const std::vector<ExportKind> all{
        {"room", ".glb", ExportKind::room,
         [](const ExportJob& job) { write_glb(job, room_glb_bytes(job.room().room(), model_of(job))); }},
        {"room", ".usda", ExportKind::room, write_usda},
        {"mesh", ".glb", ExportKind::ranges,
         [](const ExportJob& job) {
             write_glb(job, range_mesh_glb_bytes(load_walk(job.folder), job.bake.texture_size, job.run));
         }},
        {"collision", ".glb", ExportKind::ranges,
         [](const ExportJob& job) {
             if (!job.known) return write_file(job.out(), range_collision_glb_bytes(load_walk(job.folder), job.run));
             write_file(job.out(), collision_glb_bytes(job.room().room(), standable_floor(job.room()).floor_y));
         }},
        {"labels", ".json", ExportKind::room,
         [](const ExportJob& job) { write_file(job.out(), labels_json(job.room()).dump(2) + "\n"); }},
        {"walkable", ".json", ExportKind::room,
         [](const ExportJob& job) { write_file(job.out(), walkable_floor_json(job.room()).dump(2) + "\n"); }},
        {"plan", ".svg", ExportKind::room, [](const ExportJob& job) { write_file(job.out(), plan_svg(job.room())); }},
        {"splats", ".ply", ExportKind::room,
         [](const ExportJob& job) {
             save_labelled_ply(job.out(), labelled_scene(job.folder.root, job.room(), job.run));
         }},
        {"splats", ".npy", ExportKind::room, write_npy},
        {"views", "", ExportKind::room, write_views},
    };
    return all;
}

std::vector<std::string> export_names() {
    std::vector<std::string> out;
    for (const ExportKind& kind : export_kinds())
        if (std::find(out.begin(), out.end(), kind.name) == out.end()) out.emplace_back(kind.name);
    return out;
}

// By --what and the extension; without --what the first with this extension that the scene has.
const ExportKind& export_kind_of(const ExportFlags& flags, bool has_known) {
    const std::string ending = fs::path(flags.out).extension().string();
    std::vector<std::string> endings;
    bool folder = false;
    for (const ExportKind& kind : export_kinds()) {
        if (!flags.what.empty() && flags.what != kind.name) continue;
        const bool fits = has_known || kind.needs == ExportKind::ranges || ending != ".glb";
        if (ending == kind.ending && (!flags.what.empty() || (!ending.empty() && fits))) return kind;
        folder = folder || !*kind.ending;
        if (*kind.ending && std::find(endings.begin(), endings.end(), kind.ending) == endings.end())
            endings.emplace_back(kind.ending);
    }
    if (flags.what.empty()) throw UsageError("{}: expected a name that ends in {}", flags.out, any_of(endings));
    if (folder) throw UsageError("{}: expected the name of a folder for --what {}", flags.out, flags.what);
    throw UsageError("{}: expected a name that ends in {} for --what {}", flags.out, any_of(endings), flags.what);
}

// Before the work; a folder may be there already.
void check_place(const ExportKind& kind, const fs::path& out) {
    if (*kind.ending) return check_writable(out);
    make_directories(out);
    check_writable(out / "transforms.json");
}

}  // namespace

Verb add_export(CLI::App& app) {
    auto flags = std::make_shared<ExportFlags>();
    CLI::App* verb = app.add_subcommand(
        "export",
        "Exports a scene for engines and tools: its room, if made from a prompt, or a mesh of its panoramas.");
    verb->add_option("scene", flags->scene, "Folder of a run.")->type_name("DIR")->required();
    verb->add_option("file", flags->out,
                     "The file to write: .glb, .usda, .json, .svg, .ply or .npy; a folder for --what views.")
        ->type_name("FILE")
        ->required();
    verb->add_option(
            "--what", flags->what,
            "What to write; default: the first that fits the file's extension: the room (a mesh, if there is no known "
            "room), labels, the plan or labelled splats.")
        ->type_name(fmt::format("{}", fmt::join(export_names(), "|")))
        ->check(one_of(export_names()));
    const std::vector<std::string> maps{kViewMaps.begin(), kViewMaps.end()};
    verb->add_option("--maps", flags->maps, "With --what views: the maps to write, separated by commas.")
        ->type_name(fmt::format("{}", fmt::join(maps, ",")))
        ->delimiter(',')
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(one_of(maps))
        ->default_str("all");
    verb->add_flag("--baked-light", flags->baked_light,
                   "With the room: bake the light into the textures, for viewers without lighting.")
        ->group("Textures");
    verb->add_flag("--compress", flags->compress,
                   "With .glb files of the room or mesh: compress meshes by EXT_meshopt_compression, for readers that "
                   "know it.");
    add_fields(*verb, "", BakeParams{}, flags->given, "Textures");
    verb->footer(
        "Example:\n  fastscene export out/bedroom bedroom.glb\n  fastscene export out/bedroom collision.glb --what "
        "collision\n  fastscene export out/bedroom labelled --what views --maps depth,instance");
    return {verb, [flags](const Session& session) {
                BakeParams params;
                apply_fields("", params, *flags->given);
                check_fields("", params);
                const Run run = session.run(0);
                const RunFolder folder{flags->scene};
                const RecordedRun recorded = recorded_run(folder);
                const bool has_known = has_room(recorded.request.source);
                const ExportKind& kind = export_kind_of(*flags, has_known);
                if (flags->baked_light && std::string(kind.name) != "room")
                    throw UsageError("--baked-light: expected with the room, found with --what {}", kind.name);
                const std::string name = kind.name, ending = kind.ending;
                if (flags->compress && (ending != ".glb" || name == "collision"))
                    throw UsageError("--compress: expected with the room or a mesh as .glb, found with {}", flags->out);
                if (kind.needs == ExportKind::ranges && !has_known && !fs::exists(folder.walk() / "poses.json"))
                    throw Error("{}: its panoramas are not made yet: run `fastscene walk {}` first", flags->scene,
                                flags->scene);
                check_place(kind, flags->out);
                ExportJob job{folder, nullptr, *flags, params, run};
                if (has_known || kind.needs == ExportKind::room)
                    job.known = flags->baked_light ? room_of_run(folder, recorded, run)
                                                   : unlit_room_of_run(folder, recorded, run);
                kind.write(job);
                Json report{{"file", flags->out}, {"what", kind.name}};
                if (*kind.ending) report["bytes"] = fs::file_size(flags->out);
                session.print(flags->out, report);
            }};
}

}  // namespace fastscene::cli
