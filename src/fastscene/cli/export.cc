#include "fastscene/base/file.h"
#include "fastscene/base/registry.h"
#include "fastscene/base/writable.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/verb.h"
#include "fastscene/export/collision.h"
#include "fastscene/export/labels.h"
#include "fastscene/export/room_glb.h"
#include "fastscene/pipeline/room_of_run.h"
#include "fastscene/trace/standable.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct ExportFlags {
    std::string scene, out, what;
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

// What can be exported: its name for --what, and the ending of its files.
struct ExportKind {
    const char *name, *ending;
    std::function<std::string(const TracedRoom&, const BakeParams&, const Run&)> bytes;
};
const std::vector<ExportKind>& export_kinds() {
    static const std::vector<ExportKind> all{
        {"room", ".glb",
         [](const TracedRoom& room, const BakeParams& params, const Run& run) {
             return room_glb_bytes(room.room(), params, run);
         }},
        {"collision", ".glb",
         [](const TracedRoom& room, const BakeParams&, const Run&) {
             return collision_glb_bytes(room.room(), standable_floor(room).floor_y);
         }},
        {"labels", ".json",
         [](const TracedRoom& room, const BakeParams&, const Run&) { return labels_json(room).dump(2) + "\n"; }},
        {"walkable", ".json",
         [](const TracedRoom& room, const BakeParams&, const Run&) {
             return walkable_floor_json(room).dump(2) + "\n";
         }},
        {"plan", ".svg", [](const TracedRoom& room, const BakeParams&, const Run&) { return plan_svg(room); }},
    };
    return all;
}

std::vector<std::string> export_names() {
    std::vector<std::string> out;
    for (const ExportKind& kind : export_kinds()) out.emplace_back(kind.name);
    return out;
}

// By --what; without it the first whose files end so.
const ExportKind& export_kind_of(const ExportFlags& flags) {
    const std::string ending = fs::path(flags.out).extension().string();
    std::vector<std::string> endings;
    for (const ExportKind& kind : export_kinds()) {
        if (flags.what.empty() ? ending == kind.ending : flags.what == kind.name) {
            if (ending == kind.ending) return kind;
            throw UsageError("{}: expected a name that ends in {} for --what {}", flags.out, kind.ending, kind.name);
        }
        if (std::find(endings.begin(), endings.end(), kind.ending) == endings.end()) endings.emplace_back(kind.ending);
    }
    throw UsageError("{}: expected a name that ends in {}", flags.out, any_of(endings));
}

}  // namespace

Verb add_export(CLI::App& app) {
    auto flags = std::make_shared<ExportFlags>();
    CLI::App* verb = app.add_subcommand("export", "Writes the room of a scene from a prompt for engines and tools.");
    verb->add_option("scene", flags->scene, "Folder of a run from a prompt.")->type_name("DIR")->required();
    verb->add_option("file", flags->out, "The file to write: .glb, .json or .svg.")->type_name("FILE")->required();
    verb->add_option(
            "--what", flags->what,
            "What to write; without it, the first of these with the file's ending: the room, labels or the plan.")
        ->type_name(fmt::format("{}", fmt::join(export_names(), "|")))
        ->check(one_of(export_names()));
    add_fields(*verb, "", BakeParams{}, flags->given, "Textures");
    verb->footer(
        "Example:\n  fastscene export out/bedroom bedroom.glb\n  fastscene export out/bedroom collision.glb --what "
        "collision");
    return {verb, [flags](const Session& session) {
                const ExportKind& kind = export_kind_of(*flags);
                BakeParams params;
                apply_fields("", params, *flags->given);
                check_fields("", params);
                check_writable(flags->out);
                const Run run = session.run(0);
                const RunFolder folder{flags->scene};
                const std::string bytes = kind.bytes(*unlit_room_of_run(folder, recorded_run(folder), run), params,
                                                     run);
                write_file(flags->out, bytes);
                session.print(flags->out, {{"file", flags->out}, {"what", kind.name}, {"bytes", bytes.size()}});
            }};
}

}  // namespace fastscene::cli
