// metrics images, metrics niqe-fit: measures pictures without a scene.
#include <fmt/ranges.h>

#include "fastscene/base/writable.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/metrics.h"
#include "fastscene/metrics/images.h"
#include "fastscene/metrics/niqe.h"

namespace fastscene::cli {
namespace {

std::string niqe_fit_text() {
    return fmt::format(
        "Of each picture those blocks of {0} x {0} pixels count that are sharper than 3/4 of its sharpest. Less than "
        "{1} are refused, {2} are good.\n"
        "40 photographs of 1024 x 512 gave 155, so {1} take about 26 of that size and {2} about 260; NIQE's authors "
        "took 125 photographs.\n"
        "Scores by another model than the authors' cannot be compared with published ones.\n",
        kNiqeBlock, kLeastNiqeBlocks, kGoodNiqeBlocks);
}

}  // namespace

Verb add_metrics_images(CLI::App& metrics) {
    auto inputs = std::make_shared<ImageMeasures>();
    CLI::App* verb = metrics.add_subcommand("images",
                                            "Measures pictures: NIQE and BRISQUE of each, PSNR, SSIM and LPIPS against "
                                            "--reference, CLIP score against --prompt.");
    verb->add_option("pictures", inputs->pictures, "A picture, or a folder of .png, .jpg, .webp or .tif.")
        ->type_name("DIR|FILE")
        ->required();
    verb->add_option("--reference", inputs->reference,
                     "What they should be: a picture, or a folder with the same names.")
        ->type_name("DIR|FILE");
    verb->add_option("--prompt", inputs->prompt, "What they should show.")->type_name("TEXT");
    verb->add_option("--measure", inputs->wanted, fmt::format("Only these: {}.", fmt::join(image_measure_names(), " ")))
        ->type_name("NAME")
        ->check(one_of(image_measure_names()));
    verb->add_option("--weights", inputs->weights,
                     "Folder of parameters and networks; default: $FASTSCENE_WEIGHTS, else fastscene/metrics in the "
                     "user's cache.")
        ->type_name("DIR");
    verb->footer(metrics_weights_text());
    return {verb, [inputs](const Session& session) {
                ImageMeasures all = *inputs;
                all.weights = metrics_weights(all.weights);
                const Json report = measure_images(all, session.run(0));
                session.print(image_table(report), report);
                if (const auto without = not_measured(report, all.wanted); !without.empty())
                    throw Error("--measure: expected a value of {} for at least one picture, found none",
                                fmt::join(without, ", "));
            }};
}

Verb add_niqe_fit(CLI::App& metrics) {
    struct Flags {
        std::string folder, out;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = metrics.add_subcommand("niqe-fit",
                                            "Fits NIQE's model of undistorted pictures to one's own: `metrics images` "
                                            "measures niqe_own by it, without a download.");
    verb->add_option("pictures", flags->folder, "A folder of good photographs or renders.")
        ->type_name("DIR")
        ->required();
    verb->add_option("-o,--out", flags->out,
                     "Where the model goes; niqe.json in the --weights of `metrics images` is found there.")
        ->type_name("FILE")
        ->required();
    verb->footer(niqe_fit_text());
    return {verb, [flags](const Session& session) {
                check_writable(flags->out);
                const NiqeModel model = fit_niqe(pictures_in(flags->folder, "niqe-fit"), session.run(0));
                save_niqe_model(flags->out, model);
                session.print(
                    fmt::format("{}: {} sharp blocks of {} pictures", flags->out, model.blocks, model.pictures),
                    {{"model", flags->out}, {"blocks", model.blocks}, {"pictures", model.pictures}});
            }};
}

}  // namespace fastscene::cli
