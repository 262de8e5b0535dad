#include "fastscene/base/file.h"
#include "fastscene/base/writable.h"
#include "fastscene/cli/request.h"
#include "fastscene/pipeline/hole_report.h"

namespace fastscene::cli {
namespace {

struct TableFlags {
    std::string scene, picture, range_map, out;
    bool truth = false;
};

// The table subcommand accepts the common flags of its command; settings of the walk would have no effect there.
void check_flags(const CLI::App& walk) {
    for (const CLI::Option* option : walk.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || name == "--threads" || name == "--json" || name == "--progress") continue;
        throw UsageError("{}: expected with the walk itself, found with walk table, which it does not change", name);
    }
}

void make_table(const TableFlags& flags, const Session& session) {
    const bool has_picture = !flags.picture.empty() || !flags.range_map.empty();
    if (has_picture == !flags.scene.empty() || flags.picture.empty() != flags.range_map.empty())
        throw UsageError("walk table: expected the folder of a run, or --panorama FILE and --range FILE");
    if (flags.truth && has_picture)
        throw UsageError(
            "--truth: expected the folder of a run from a prompt: behind a picture there is no room to compare with");
    if (!flags.out.empty()) {  // fail now instead of after the work
        make_directories(flags.out);
        for (const char* name : {"hole_table.txt", "hole_table.json", "hole_table.svg"})
            check_writable(std::filesystem::path(flags.out) / name);
    }
    const Run run = session.run(0);
    const std::vector<HoleRow> rows = has_picture ? hole_table_of_picture(flags.picture, flags.range_map, run)
                                                  : hole_table_of_run(flags.scene, flags.truth, run);
    std::string text = hole_table_text(rows);
    text.pop_back();
    session.print(text, hole_table_json(rows));  // printed first, so that a full disk does not lose it
    if (!flags.out.empty()) save_hole_table(flags.out, rows);
}

}  // namespace

Verb add_walk(CLI::App& app) {
    Verb walk = add_stage_verb(app, "walk",
                               "One panorama with range -> many, at exactly known positions, holes filled.");
    auto flags = std::make_shared<TableFlags>();
    CLI::App* table = walk.app->add_subcommand("table",
                                               "How much of the picture a step leaves open, by axis and distance (the "
                                               "paper's Table 1): as published, and ours.");
    table->add_option("scene", flags->scene, "Folder of a run that has got as far as its depth.")->type_name("DIR");
    table->add_option("--panorama", flags->picture, "Or a 2:1 picture …")->type_name("FILE");
    table
        ->add_option("--range", flags->range_map, "… and its range map (.exr, .pfm, .tif, 16-bit .png in millimetres).")
        ->type_name("FILE");
    table->add_flag("--truth", flags->truth, "Also compare our holes with those of the traced room behind the prompt.");
    table->add_option("-o,--out", flags->out, "Write hole_table.txt, .json and .svg into this folder.")
        ->type_name("DIR");
    walk.app->footer(
        "Example:\n  fastscene walk out/bedroom --walk-viewpoints 20\n  fastscene walk table out/bedroom -o out/holes");
    table->footer("Example:\n  fastscene walk table out/bedroom -o out/holes");
    table->fallthrough();  // --json, --threads and --progress belong to the command
    // A run folder is required for the walk only.
    CLI::Option* folder = walk.app->get_option("folder")->required(false);
    const auto act = walk.act;
    return {walk.app, [act, flags, table, folder, walk_app = walk.app](const Session& session) {
                if (table->parsed()) {
                    check_flags(*walk_app);
                    return make_table(*flags, session);
                }
                if (folder->count() == 0) throw UsageError("walk: expected the folder of a run");
                act(session);
            }};
}

}  // namespace fastscene::cli
