// assets list, verify, add: a folder of the user's own models, textures and skies.
#include <filesystem>

#include "fastscene/base/file.h"
#include "fastscene/cli/verb.h"
#include "fastscene/rooms/user_inventory.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

Verb add_list(CLI::App& assets) {
    auto folder = std::make_shared<std::string>();
    CLI::App* verb = assets.add_subcommand(
        "list", "Names the models, textures and skies of a folder, and the words by which prompts find them.");
    verb->add_option("folder", *folder, "The folder.")->type_name("DIR")->required();
    return {verb, [folder](const Session& session) {
                const Inventory inventory = take_inventory(*folder, session.run(0));
                session.print(text_of(inventory), json_of(inventory));
            }};
}

Verb add_verify_assets(CLI::App& assets) {
    auto folder = std::make_shared<std::string>();
    CLI::App* verb = assets.add_subcommand(
        "verify",
        "Opens everything in a folder and tells what cannot be used, and what was guessed. Fails if anything "
        "cannot be used.");
    verb->add_option("folder", *folder, "The folder.")->type_name("DIR")->required();
    return {verb, [folder](const Session& session) {
                const Inventory inventory = take_inventory(*folder, session.run(0));
                session.print(text_of(inventory, true), json_of(inventory));
                if (const std::size_t bad = inventory.refused(); bad > 0)
                    throw Error("{}: expected assets that can be used, found {} that cannot", *folder, bad);
            }};
}

Verb add_add(CLI::App& assets) {
    struct Flags {
        std::string folder, file;
        NewModel model;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = assets.add_subcommand(
        "add", "Copies a model into a folder and writes its row into assets.toml. It is opened first.");
    verb->add_option("folder", flags->folder, "The folder; made if it is not there.")->type_name("DIR")->required();
    verb->add_option("file", flags->file, "The model: .glb, .gltf or .obj.")->type_name("FILE")->required();
    NewModel& m = flags->model;
    verb->add_option("--class", m.kind, "What it is: \"armchair\"; default: from the file's name.")->type_name("CLASS");
    verb->add_option("--name", m.names, "What prompts call it; may be given several times.")->type_name("WORDS");
    verb->add_option("--width", m.size_m.x, "Metres; the other extents go along.")->type_name("M");
    verb->add_option("--height", m.size_m.y, "Metres.")->type_name("M");
    verb->add_option("--depth", m.size_m.z, "Metres.")->type_name("M");
    verb->add_option("--up", m.up, "Axis of the file that points up; default: y.")->type_name("AXIS");
    verb->add_option("--front", m.front, "Axis of the file that the front looks along; default: z.")->type_name("AXIS");
    verb->add_option("--author", m.attribution.author, "For credits.txt.")->type_name("NAME");
    verb->add_option("--licence", m.attribution.license, "For credits.txt.")->type_name("NAME");
    verb->add_option("--source", m.attribution.source, "For credits.txt: where it is from.")->type_name("URL");
    return {verb, [flags](const Session& session) {
                const Inventory added = add_model(flags->folder, flags->file, flags->model, session.run(0));
                session.print(text_of(added, true), json_of(added));
            }};
}

}  // namespace

Verb add_assets(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("assets", "Your own models, textures and skies: list, verify, add.");
    verb->require_subcommand(1);
    verb->footer(
        "Examples:\n  fastscene assets add mine chair.glb --class armchair --licence \"CC BY 4.0\" --author \"Jane "
        "Doe\"\n  fastscene assets verify mine\n  fastscene make \"a reading corner with an armchair\" --assets mine");
    const std::vector<Verb> parts{add_list(*verb), add_verify_assets(*verb), add_add(*verb)};
    for (const Verb& part : parts) part.app->fallthrough();  // common flags belong to `assets`
    return {verb, [parts](const Session& session) {
                for (const Verb& part : parts)
                    if (part.app->parsed()) part.act(session);
            }};
}

}  // namespace fastscene::cli
