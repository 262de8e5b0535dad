#include "fastscene/cli/splat_select.h"

#include <algorithm>

#include "fastscene/base/writable.h"
#include "fastscene/cli/labelled_scene.h"
#include "fastscene/io/splat_io.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct SelectFlags {
    std::string from, to;
    std::vector<std::string> ids, classes;
    bool invert = false;
};

bool is_plain_ply(const fs::path& file) {
    const SplatFormat* format = splat_format_of_name(file);
    return format && format->name == "ply";
}

void select(const SelectFlags& flags, const Session& session) {
    if (flags.ids.empty() && flags.classes.empty())
        throw UsageError("splat select: expected --class or --id, found neither");
    if (!splat_format_of_name(flags.to))
        throw UsageError("{}: expected a name that ends in {}", flags.to, splat_endings());
    check_writable(flags.to);
    const LabelledScene scene = load_labelled(flags.from, session.run(0));
    const std::vector<std::uint16_t> wanted = numbers_of(scene.instances, flags.ids, flags.classes);
    LabelledScene out{{}, {}, scene.instances};
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < scene.labels.size(); ++i)
        if ((std::find(wanted.begin(), wanted.end(), scene.labels[i]) != wanted.end()) != flags.invert) {
            kept.push_back(static_cast<std::uint32_t>(i));
            out.labels.push_back(scene.labels[i]);
        }
    if (kept.empty())
        throw Error("{}: none of {} splats belong to it; nothing was written", flags.from, scene.labels.size());
    out.splats = chosen(scene.splats, kept);
    if (is_plain_ply(flags.to)) save_labelled_ply(flags.to, out);  // so that more can be cut out of it
    else save_splats(flags.to, out.splats);
    Json ids = Json::array();
    for (const std::uint16_t number : wanted) ids.push_back(scene.instances[number].id);
    session.print(flags.to,
                  {{"file", flags.to}, {"splats", kept.size()}, {"splats_read", scene.labels.size()}, {"ids", ids}});
}

}  // namespace

Verb add_splat_select(CLI::App& splat) {
    auto flags = std::make_shared<SelectFlags>();
    CLI::App* verb = splat.add_subcommand("select", "Cuts things out of the splats of a scene from a prompt.");
    verb->add_option("-i,--input", flags->from,
                     "Folder of a run, a .ply of `fastscene export`, or splats with NAME.labels.npy beside them.")
        ->type_name("FILE|DIR")
        ->required();
    verb->add_option("-o,--out", flags->to, "File to write; its extension selects the format.")
        ->type_name("FILE")
        ->required();
    const auto add = [&](const char* name, std::vector<std::string>& words, const char* sentence) {
        verb->add_option(name, words, sentence)
            ->type_name("NAME")
            ->delimiter(',')
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    add("--class", flags->classes, "Things of this class or NYU40 label: sofa, chair, floor; may be repeated.");
    add("--id", flags->ids, "The thing with this id, as labels.json has it: sofa-1; may be repeated.");
    verb->add_flag("--invert", flags->invert, "Everything else instead.");
    verb->footer("Example:\n  fastscene splat select -i out/bedroom --class armchair -o armchair.ply");
    return {verb, [flags](const Session& session) { select(*flags, session); }};
}

}  // namespace fastscene::cli
