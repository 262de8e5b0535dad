#include <algorithm>
#include <limits>

#include "fastscene/cli/flags.h"
#include "fastscene/cli/inpaint.h"
#include "fastscene/walk/hole_dataset.h"

namespace fastscene::cli {
namespace {

std::string summary(const std::string& folder, const HoleDatasetState& s) {
    std::string text = fmt::format("{}: {} of {} panoramas done, {} in this run: {} faces, {} masks", folder, s.there,
                                   s.panoramas, s.made, s.faces, s.masks);
    if (s.broken > 0) text += fmt::format("; {} could not be read and were skipped", s.broken);
    return text;
}

}  // namespace

Verb add_inpaint_dataset(CLI::App& inpaint) {
    struct Flags {
        std::string panoramas, out, seed = "0", count;
        std::shared_ptr<Given> given = std::make_shared<Given>();
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = inpaint.add_subcommand(
        "dataset",
        "Panoramas with range -> the disocclusion holes of a walk, on cube faces (the paper's training data).");
    verb->add_option("panoramas", flags->panoramas,
                     "Folder with panoramas: a dataset of `fastscene rooms dataset`, Structured3D as downloaded, or "
                     "NAME.png beside NAME.range.png.")
        ->type_name("DIR")
        ->required();
    verb->add_option("-o,--out", flags->out, "Folder of the dataset. Existing files are kept.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--count", flags->count, "Use only the first N panoramas.")->type_name("N");
    verb->add_option("--seed", flags->seed, "Seed that selects the held-out places.")
        ->type_name("N")
        ->capture_default_str();
    add_fields(*verb, "", HoleDatasetParams{}, flags->given, "Settings of the holes");
    verb->footer(
        "DIR/train and DIR/held-out hold images/ (faces) and masks/ (white = hole), as AOT-GAN's own loader reads them "
        "(docs/inpaint.md).");
    return {verb, [flags](const Session& session) {
                HoleDatasetParams params;
                apply_fields("", params, *flags->given);
                check_fields("", params);
                const std::size_t most = flags->count.empty() ? std::numeric_limits<std::size_t>::max()
                                                              : number_from<std::size_t>("--count", flags->count);
                if (most == 0) throw UsageError("--count: expected at least 1 panorama, found 0");
                std::vector<PanoramaFiles> panoramas = find_panoramas(flags->panoramas);
                panoramas.resize(std::min(panoramas.size(), most));
                const HoleDatasetState s = make_hole_dataset(
                    panoramas, params, flags->out, session.run(number_from<std::uint64_t>("--seed", flags->seed)));
                session.print(summary(flags->out, s), {{"folder", flags->out},
                                                       {"panoramas", s.panoramas},
                                                       {"there", s.there},
                                                       {"made", s.made},
                                                       {"broken", s.broken},
                                                       {"faces", s.faces},
                                                       {"masks", s.masks}});
            }};
}

}  // namespace fastscene::cli
