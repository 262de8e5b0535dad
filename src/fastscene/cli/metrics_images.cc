// metrics images, metrics niqe-fit: pictures measured without a scene.
#include <fmt/ranges.h>

#include "fastscene/cli/metrics.h"
#include "fastscene/metrics/images.h"
#include "fastscene/metrics/niqe.h"

namespace fastscene::cli {

Verb add_metrics_images(CLI::App& metrics) {
    auto inputs = std::make_shared<ImageMeasures>();
    CLI::App* verb = metrics.add_subcommand("images", "Measures pictures: NIQE and BRISQUE of each, PSNR, SSIM and LPIPS against --reference, CLIP score against --prompt.");
    verb->add_option("pictures", inputs->pictures, "A picture, or a folder of .png and .jpg.")->type_name("DIR|FILE")->required();
    verb->add_option("--reference", inputs->reference, "What they should be: a picture, or a folder with the same names.")->type_name("DIR|FILE");
    verb->add_option("--prompt", inputs->prompt, "What they should show.")->type_name("TEXT");
    verb->add_option("--measure", inputs->wanted, fmt::format("Only these: {}.", fmt::join(image_measure_names(), " ")))
        ->type_name("NAME")
        ->check(CLI::IsMember(image_measure_names()).description(""));
    verb->add_option("--weights", inputs->weights, "Folder of parameters and networks; default: $FASTSCENE_WEIGHTS, else fastscene/metrics in the user's cache.")->type_name("DIR");
    verb->footer("Files of --weights:\n" + metrics_weights_text());
    return {verb, [inputs](const Session& session) {
                ImageMeasures all = *inputs;
                if (all.weights.empty()) all.weights = default_metrics_weights();
                const Json report = measure_images(all, session.run(0));
                session.print(image_table(report), report);
            }};
}

Verb add_niqe_fit(CLI::App& metrics) {
    struct Flags {
        std::string folder, out;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = metrics.add_subcommand("niqe-fit", "Fits NIQE's model of undistorted pictures to one's own, so that NIQE works without a download.");
    verb->add_option("pictures", flags->folder, "A folder of good photographs or renders.")->type_name("DIR")->required();
    verb->add_option("-o,--out", flags->out, "Where the model goes; niqe.json in the --weights of `metrics images` is found there.")->type_name("FILE")->required();
    return {verb, [flags](const Session& session) {
                save_niqe_model(flags->out, fit_niqe(pictures_in(flags->folder, "niqe-fit"), session.run(0)));
                session.print(flags->out, {{"model", flags->out}});
            }};
}

}  // namespace fastscene::cli
